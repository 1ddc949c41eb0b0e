// The tutors' scenes and their six calls.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "app/session/arguments.h"
#include "app/session/edits.h"
#include "app/session/keys.h"
#include "app/session/layout.h"
#include "app/session/tutor.h"
#include "judge/lint/lint.h"
#include "render/reference/reference.h"
#include "scene/state/state.h"

namespace twinlight::session::session_tutor_test {
namespace {

constexpr WindowSize kSmall{80, 60};

Image picture_of(const CommandList& commands) {
    StateOptions options;
    options.width = kSmall.width;
    options.height = kSmall.height;
    return reference::render(make_frame(scaled(commands, natural_size(commands), kSmall), options), {});
}

// Whether another value of one of the call's numbers, or the other of a flag's, changes a pixel.
bool changes_the_picture(const CommandList& commands, std::size_t call) {
    const Image before = picture_of(commands);
    const Command& command = commands.commands[call];
    for (std::size_t argument = 0; argument < command.arguments.size(); ++argument) {
        const ArgumentInfo info = argument_info(command, argument);
        if (info.editing != Editing::kNumber && info.editing != Editing::kFlag) continue;
        const double value = info.editing == Editing::kFlag
                                 ? 1 - command.number(argument)
                                 : nearest_legal(command, argument, command.number(argument) + 1);
        if (picture_of(with_argument(commands, call, argument, value)).pixels != before.pixels) return true;
    }
    return false;
}

TEST(SessionTutor, EachHasSixCallsThatChangeThePicture) {
    for (const TutorName& tutor : kTutors) {
        SCOPED_TRACE(tutor.key);
        const auto scene = tutor_scene(tutor.key);
        const auto calls = tutor_calls(*scene);
        EXPECT_EQ(calls.size(), kTutorCalls);
        for (const std::size_t call : calls) EXPECT_TRUE(changes_the_picture(*scene, call)) << call;
    }
}

TEST(SessionTutor, TheLinterFindsNoMistakeInTheirScenes) {
    for (const TutorName& tutor : kTutors)
        EXPECT_TRUE(lint::lint(make_scene(tutor_scene(tutor.key), {})).empty()) << tutor.key;
}

TEST(SessionTutor, TheKeyGoesThroughAllAndKeepsTheirChanges) {
    Session session(tutor_scene("material"));
    press(session, 'u');
    EXPECT_TRUE(session.tutor_requested);
    for (const TutorName& tutor : kTutors) {
        next_tutor(session);
        EXPECT_EQ(session.view, View::kTutor);
        EXPECT_EQ(key_of(session), "tutor-" + std::string(tutor.key));
    }
    press(session, 'f');
    for (std::size_t i = 0; i < std::size(kTutors); ++i) next_tutor(session);
    EXPECT_EQ(key_of(session), "tutor-attenuation");
    EXPECT_TRUE(session.history.can_undo());
}

TEST(SessionTutor, ShowsTheWorldAtTheLeftAndTheActivePictureAtTheRight) {
    Session session(tutor_scene("light"));
    open_tutor(session, "light");
    const Layout places = layout(session, 1280, 800, 1);
    ASSERT_EQ(places.cells.size(), 2u);
    EXPECT_EQ(places.cells[0].pane, kWorldPane);
    EXPECT_EQ(places.cells[1].pane, 0u);
    EXPECT_LT(places.cells[0].picture.x, places.cells[1].picture.x);
    EXPECT_EQ(places.panel.width, 0);
    EXPECT_GT(places.code.height, 0);
    EXPECT_LE(places.cells[0].footer.y + places.cells[0].footer.height, places.code.y);
}

}  // namespace
}  // namespace twinlight::session::session_tutor_test
