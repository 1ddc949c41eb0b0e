// What the window saves: no file is replaced, and the scene that is read again is the one on show.
#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>

#include "../run_program.h"
#include "app/session/edits.h"
#include "app/session/saving.h"
#include "base/image/file.h"
#include "scene/command/text.h"
#include "scene/scenes/load.h"

namespace twinlight::session::session_saving_test {
namespace {

Session session_of(const std::string& name) {
    Session session(load_commands(name));
    refresh(session, 64, 48);
    return session;
}

TEST(SessionSaving, NamesFilesAfterTheScene) {
    EXPECT_EQ(stem_of("report"), "report");
    EXPECT_EQ(stem_of("/home/me/work.v2/ball.gl"), "ball");
    EXPECT_EQ(stem_of("-"), "stdin");
    EXPECT_EQ(stem_of(""), "scene");
}

TEST(SessionSaving, AddsANumberToANameThatExists) {
    const TemporaryFolder folder;
    const std::string in = folder / "";
    EXPECT_EQ(free_path(in, "ball", ".gl"), folder / "ball.gl");
    write_file_atomically(folder / "ball.gl", "1");
    EXPECT_EQ(free_path(in, "ball", ".gl"), folder / "ball-2.gl");
    write_file_atomically(folder / "ball-2.gl", "2");
    EXPECT_EQ(free_path(in, "ball", ".gl"), folder / "ball-3.gl");
    EXPECT_EQ(free_path(in, "ball", ".c"), folder / "ball.c");
    // A link whose target is missing is a name that exists.
    std::filesystem::create_symlink("nowhere", folder / "ball-3.gl");
    EXPECT_EQ(free_path(in, "ball", ".gl"), folder / "ball-4.gl");
    EXPECT_EQ(free_path("", "no such ball", ".gl"), "no such ball.gl");
}

TEST(SessionSaving, TheSavedSceneIsTheOneOnShow) {
    const TemporaryFolder folder;
    Session session = session_of("report");
    edit(session, toggle_light(commands(session), 3), "light 3");
    refresh(session, 64, 48);
    const std::string said = save(session, Form::kScene, {}, folder / "");
    EXPECT_NE(said.find(folder / "report.gl"), std::string::npos) << said;
    EXPECT_EQ(load_commands(folder / "report.gl")->commands, commands(session).commands);
    save(session, Form::kScene, {}, folder / "");
    EXPECT_TRUE(std::filesystem::exists(folder / "report-2.gl"));
}

TEST(SessionSaving, WritesEveryForm) {
    const TemporaryFolder folder;
    const Session session = session_of("report");
    for (const FormName& form : kForms) EXPECT_NE(save(session, form.value, {}, folder / ""), "") << form.words;
    EXPECT_NE(read_file(folder / "report.c").find("glutMainLoop();"), std::string::npos);
    EXPECT_NE(read_file(folder / "report.html").find("webgl2"), std::string::npos);
    EXPECT_TRUE(std::filesystem::exists(folder / "report-shaders/README.md"));
    EXPECT_TRUE(std::filesystem::exists(folder / "report-shaders/kind1.frag"));
}

TEST(SessionSaving, SaysWhatCannotBeSaved) {
    const TemporaryFolder folder;
    const Session session = session_of("report");
    EXPECT_THROW(save(session, Form::kHtml, {Shading::kExact}, folder / ""), std::runtime_error);
    EXPECT_THROW(save(session, Form::kScene, {}, folder / "missing"), FileError);
    EXPECT_TRUE(std::filesystem::is_empty(folder / ""));  // nothing is left behind
}

// A scene with pictures stays beside them.
TEST(SessionSaving, ASceneWithPicturesStaysInItsFolder) {
    const TemporaryFolder folder;
    const auto one_pixel = [](const std::string&) { return ImageFile{1, 1, std::vector<std::byte>(4)}; };
    Session session(std::make_shared<CommandList>(
        read_scene("#pragma twinlight texture(\"wall.png\")\n", "room.gl", "room.gl", one_pixel)));
    session.file = folder / "room.gl";
    refresh(session, 64, 48);
    make_folder(folder / "elsewhere");
    save(session, Form::kScene, {}, folder / "elsewhere");
    EXPECT_EQ(read_file(folder / "room.gl"), "#pragma twinlight texture(\"wall.png\")\n");
    save(session, Form::kC, {}, folder / "elsewhere");  // has the pixels in it
    EXPECT_TRUE(std::filesystem::exists(folder / "elsewhere/room.c"));
}

}  // namespace
}  // namespace twinlight::session::session_saving_test
