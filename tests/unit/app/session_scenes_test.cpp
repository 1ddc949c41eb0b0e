// The window's list of scenes: the built-in ones below headings, their small pictures, and the user's last files.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "../in_chinese.h"
#include "../run_program.h"
#include "app/session/recorded_program.h"
#include "app/session/scenes.h"
#include "base/image/file.h"
#include "scene/command/text.h"
#include "scene/scenes/caption.h"
#include "scene/scenes/load.h"
#include "scene/scenes/scene_groups.h"

namespace twinlight::session::session_scenes_test {
namespace {

using Strings = std::vector<std::string>;

TEST(SceneGroups, HaveEachBuiltInSceneBelowOneHeading) {
    std::multiset<std::string> listed, known;
    for (const SceneGroup& group : scene_groups()) {
        EXPECT_FALSE(group.heading.empty());
        for (const std::string_view name : group.scenes) listed.emplace(name);
    }
    for (const EmbeddedFile& file : kSceneFiles) known.insert(built_in_name(file));
    EXPECT_EQ(listed, known);
}

TEST(SessionScenes, SmallPicturesShowTheWholeScene) {
    for (const std::string name : {"lab", "monitor"}) {
        const auto small = small_scene(name, {320, 240});
        EXPECT_EQ(small->frame.width, 320) << name;
        EXPECT_EQ(small->frame.height, 240) << name;
        const auto whole = make_scene(load_commands(name), {});
        EXPECT_EQ(small->frame.draws().size(), whole.frame.draws().size()) << name;
        const Rectangle &viewport = small->frame.draws().back()->raster.viewport,
                        &of_whole = whole.frame.draws().back()->raster.viewport;
        EXPECT_EQ(2 * viewport.width, of_whole.width) << name;
    }
}

// As a scene without a file: saving asks for a name.
TEST(SessionScenes, OfARecordingAreOneOfItsFrames) {
    const TemporaryFolder folder;
    write_file_atomically(folder / "lamp.txt",
                          "1 glViewport(x = 0, y = 0, width = 30, height = 20)\n"
                          "2 glXSwapBuffers(dpy = 0x1, drawable = 1)\n"
                          "3 glColor3f(red = 1, green = 0.5, blue = 0)\n"
                          "4 glRectf(x1 = 0, y1 = 0, x2 = 1, y2 = 1)\n"
                          "5 glXSwapBuffers(dpy = 0x1, drawable = 1)\n");
    Session session(load_commands("terms"));
    show_scene(session, folder / "lamp.txt");
    EXPECT_EQ(key_of(session), "lamp.txt, frame 1");
    EXPECT_EQ(session.file, std::nullopt);
    EXPECT_EQ(session.opened->window, (WindowSize{30, 20}));
    EXPECT_NE(session.opened->text->find("glColor3f(1, 0.5, 0);\nglRectf(0, 0, 1, 1);\n"), std::string::npos)
        << *session.opened->text;
    EXPECT_EQ(caption_of(*session.opened).title, "lamp.txt, frame 1.");
    const InChinese chinese;
    show_scene(session, "terms");
    show_scene(session, folder / "lamp.txt");
    EXPECT_EQ(caption_of(*session.opened).title, "lamp.txt，第 1 帧。");
}

TEST(SessionScenes, OfProgramsThatCanBeRecorded) {
    const TemporaryFolder folder;
    for (const char* name : {"lamp.cpp", "lamp.py", "lamp.gl", "lamp"}) write_file_atomically(folder / name, "");
    std::filesystem::permissions(folder / "lamp", std::filesystem::perms::owner_all);
    EXPECT_TRUE(can_be_recorded(folder / "lamp.cpp"));
    EXPECT_TRUE(can_be_recorded(folder / "lamp.py"));
    EXPECT_TRUE(can_be_recorded(folder / "lamp"));
    EXPECT_FALSE(can_be_recorded(folder / "lamp.gl"));
    EXPECT_FALSE(can_be_recorded(folder / "none.cpp"));
    EXPECT_FALSE(can_be_recorded(folder.str()));
}

// With the compiler's first error: the window shows no other of its messages.
TEST(SessionScenes, OfAProgramThatCannotBeCompiledSayWhyInTheWindowsLanguage) {
    if (run_shell("", "command -v c++").status != 0) GTEST_SKIP() << "c++ is not installed";
    const TemporaryFolder folder;
    const std::string program = folder / "lamp.cpp";
    write_file_atomically(program, "int main() { return lamp; }\n");
    const auto error = [&] {
        try {
            ProgramRecording(program).scene();
        } catch (const SceneError& refusal) {
            return std::string(refusal.what());
        }
        return std::string();
    };
    const std::string place = program + ":1:21: error: ", english = error();
    EXPECT_TRUE(english.starts_with(place)) << english;
    EXPECT_TRUE(english.ends_with("\n" + program + ": it cannot be compiled, see above")) << english;
    const InChinese chinese;
    const std::string translated = error();
    EXPECT_TRUE(translated.starts_with(place)) << translated;
    EXPECT_TRUE(translated.ends_with("\n" + program + "：无法编译，见上面")) << translated;
}

TEST(SessionScenes, RecentFilesAreTheLastOnesThatExist) {
    const TemporaryFolder folder;
    const auto file = [&](int i) { return folder / (std::to_string(i) + ".gl"); };
    Session session(load_commands("terms"));
    note_recent_file(session);
    EXPECT_EQ(recent_files(session), Strings{});  // a built-in scene is no file
    for (int i = 0; i < 12; ++i) {
        write_file_atomically(file(i), "glRectf(0, 0, 1, 1);");
        session.file = file(i);
        note_recent_file(session);
    }
    session.file = file(5);
    note_recent_file(session);
    note_recent_file(session);
    EXPECT_EQ(recent_files(session),
              (Strings{file(5), file(11), file(10), file(9), file(8), file(7), file(6), file(4), file(3), file(2)}));
    std::filesystem::remove(file(10));
    EXPECT_EQ(recent_files(session)[2], file(9));
}

// So a file that was opened by its name is not opened a second time by its whole path.
TEST(SessionScenes, RecentFilesBelowThisFolderAreNamedFromHere) {
    Session session(load_commands("terms"));
    session.file = "src/scene/scenes/lab.gl";
    note_recent_file(session);
    EXPECT_TRUE(std::filesystem::path(session.recent_files.front()).is_absolute());
    EXPECT_EQ(recent_files(session), Strings{"src/scene/scenes/lab.gl"});
}

}  // namespace
}  // namespace twinlight::session::session_scenes_test
