// What the window saves, and what survives it: the text around the edits, the changes of two programs, the changes after a crash.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>

#include "../run_program.h"
#include "app/session/edits.h"
#include "app/session/keys.h"
#include "app/session/merge.h"
#include "app/session/recovery.h"
#include "app/session/saving.h"
#include "app/session/scenes.h"
#include "app/session/typed_calls.h"
#include "base/image/file.h"
#include "base/image/png.h"
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

// A scene in a file, as the window opens it.
Session session_of_file(const std::string& file, const std::string& text) {
    write_file_atomically(file, text);
    Session session(load_commands(file), file);
    refresh(session, 64, 48);
    return session;
}

const std::string kText = R"(// A lamp and a ball.
gluPerspective(45, 4.0 / 3.0, 0.1, 100);  // as in the lecture
glEnable(GL_LIGHT0);
GLfloat lamp[] = {2, 3, 4, 1};
glLightfv(GL_LIGHT0, GL_POSITION, lamp);
glMaterialf(GL_FRONT, GL_SHININESS, 32);  // glossy
glutSolidCube(1);
)";

std::string replaced(std::string text, const std::string& before, const std::string& after) {
    return text.replace(text.find(before), before.size(), after);
}

std::size_t index_of(const Session& session, CommandId id) {
    const auto& list = commands(session).commands;
    return static_cast<std::size_t>(std::ranges::find(list, id, &Command::id) - list.begin());
}

void set(Session& session, CommandId id, std::size_t argument, double value) {
    edit(session, with_argument(commands(session), index_of(session, id), argument, value), "set");
}

TEST(SessionSaving, ChangesOnlyTheArgumentsThatWereChanged) {
    const TemporaryFolder folder;
    const std::string file = folder / "scene.gl";
    Session session = session_of_file(file, kText);
    EXPECT_FALSE(is_edited(session));
    set(session, CommandId::gluPerspective, 0, 60);
    EXPECT_TRUE(is_edited(session));
    save(session);
    EXPECT_FALSE(is_edited(session));
    EXPECT_EQ(read_file(file), replaced(kText, "45,", "60,"));
    EXPECT_EQ(load_commands(file)->commands, commands(session).commands);
    // Undo brings the first text back, comments and all.
    press(session, 'z');
    save(session);
    EXPECT_EQ(read_file(file), kText);
}

TEST(SessionSaving, KeepsTheTextAroundCallsThatAreInsertedDeletedAndMoved) {
    const TemporaryFolder folder;
    const std::string file = folder / "scene.gl";
    Session session = session_of_file(file, kText);
    session.selected_command = index_of(session, CommandId::glLightfv);
    insert_calls(session, "glEnable(GL_FOG);");
    const std::string inserted = replaced(kText, "glMaterialf", "glEnable(GL_FOG);\nglMaterialf");
    EXPECT_EQ(text_now(session), inserted);
    edit(session, without_command(commands(session), index_of(session, CommandId::glLightfv)), "delete");
    const std::string deleted = replaced(inserted, "glLightfv(GL_LIGHT0, GL_POSITION, lamp);\n", "");
    EXPECT_EQ(text_now(session), deleted);
    // The comment stays where it was.
    edit(session, with_moved(commands(session), index_of(session, CommandId::glutSolidCube), 0), "move");
    EXPECT_EQ(text_now(session),
              replaced(replaced(deleted, "glutSolidCube(1);\n", ""), "gluPersp", "glutSolidCube(1);\ngluPersp"));
}

TEST(SessionSaving, DoesNotWriteAChangeThatItsTextCannotHave) {
    const TemporaryFolder folder;
    const std::string file = folder / "loop.c";
    const std::string program = R"(
#include <GL/glut.h>
void display(void) {
    for (int i = 0; i < 2; ++i) glEnable(GL_LIGHT0 + i);
    glutSolidCube(1);
    glutSwapBuffers();
}
int main(int argc, char** argv) {
    glutInit(&argc, argv);
    glutCreateWindow("loop");
    glutDisplayFunc(display);
    glutMainLoop();
}
)";
    Session session = session_of_file(file, program);
    edit(session, toggle_light(commands(session), 1), "light 1");  // one repetition of the loop
    EXPECT_THROW(save(session), std::runtime_error);
    EXPECT_EQ(read_file(file), program);
    EXPECT_EQ(save_all(session, ""), "saved " + (folder / "loop.gl"));
    EXPECT_EQ(load_commands(folder / "loop.gl")->commands, commands(session).commands);
}

TEST(SessionSaving, SavesABuiltInSceneToAFile) {
    const TemporaryFolder folder;
    Session session = session_of("report");
    press(session, '4');
    save_as(session, folder / "mine.gl");
    EXPECT_EQ(session.file, folder / "mine.gl");
    EXPECT_EQ(title_of(session), "mine.gl");
    EXPECT_FALSE(is_edited(session));
    EXPECT_EQ(load_commands(folder / "mine.gl")->commands, commands(session).commands);
    EXPECT_NE(read_file(folder / "mine.gl").find("//"), std::string::npos) << "the comments are lost";
    press(session, 'z');
    EXPECT_TRUE(is_edited(session));
}

// ---- The file changes while the window has changes, too ----

TEST(SessionSaving, MergesTheFilesChangeWithMine) {
    const TemporaryFolder folder;
    const std::string file = folder / "scene.gl";
    Session session = session_of_file(file, kText);
    set(session, CommandId::gluPerspective, 0, 60);
    const std::string theirs = replaced(kText, "32", "64");
    take_file_text(session, theirs);
    EXPECT_EQ(session.dialog, Dialog::kNone);
    EXPECT_EQ(text_now(session), replaced(theirs, "45,", "60,"));
    EXPECT_TRUE(is_edited(session));
    press(session, 'z');  // the file's version alone
    EXPECT_EQ(text_now(session), theirs);
    EXPECT_FALSE(is_edited(session));
}

TEST(SessionSaving, AsksWhereBothChangedTheSameLine) {
    const TemporaryFolder folder;
    const std::string file = folder / "scene.gl";
    Session session = session_of_file(file, kText);
    set(session, CommandId::glMaterialf, 2, 5);
    const std::string theirs = replaced(kText, "32", "64");
    take_file_text(session, theirs);
    EXPECT_EQ(session.dialog, Dialog::kFileChanged);
    EXPECT_EQ(text_now(session), replaced(kText, "32", "5"));
    press(session, 'z');
    EXPECT_EQ(text_now(session), theirs);
}

TEST(SessionSaving, TakesTheFilesChangeWhenNothingWasChangedHere) {
    const TemporaryFolder folder;
    Session session = session_of_file(folder / "scene.gl", kText);
    const std::string theirs = replaced(kText, "32", "64");
    take_file_text(session, theirs);
    EXPECT_EQ(text_now(session), theirs);
    EXPECT_FALSE(is_edited(session));
    EXPECT_THROW(take_file_text(session, "glEnabel(GL_FOG);"), SceneError);
    EXPECT_EQ(text_now(session), theirs);
}

TEST(SessionMerge, TakesBothChangesOfALine) {
    EXPECT_EQ(merged("a\nb\nc\n", "A\nb\nc\n", "a\nb\nc\nd\n"), "A\nb\nc\nd\n");
    EXPECT_EQ(merged("a\nb\n", "A\nb\n", "a\nB\n"), "A\nB\n");  // side by side
    EXPECT_EQ(merged("a\nb\n", "b\n", "a\nb\nc"), "b\nc");
    EXPECT_EQ(merged("a\n", "b\n", "b\n"), "b\n");
    EXPECT_EQ(merged("", "a\n", ""), "a\n");
    EXPECT_EQ(merged("a\n", "b\n", "c\n"), std::nullopt);
    EXPECT_EQ(merged("a\nb\n", "b\n", "A\nb\n"), std::nullopt);  // deleted here, changed there
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
    EXPECT_THROW(save(session, Form::kC, {}, folder / "missing"), FileError);
    EXPECT_TRUE(std::filesystem::is_empty(folder / ""));  // nothing is left behind
}

// A scene names its pictures relative to its folder, so it can be saved only where they are.
TEST(SessionSaving, ASceneWithPicturesStaysBesideThem) {
    const TemporaryFolder folder;
    write_png(folder / "wall.png", Image(1, 1));
    const std::string text = "#pragma twinlight texture(\"wall.png\")\n";
    Session session = session_of_file(folder / "room.gl", text);
    make_folder(folder / "elsewhere");
    EXPECT_THROW(save_as(session, folder / "elsewhere/room.gl"), std::exception);
    EXPECT_EQ(read_file(folder / "room.gl"), text);
    save(session, Form::kC, {}, folder / "elsewhere");  // has the pixels in it
    EXPECT_TRUE(std::filesystem::exists(folder / "elsewhere/room.c"));
}

// ---- After a crash ----

TEST(SessionRecovery, BringsBackWhatWasNotSaved) {
    const TemporaryFolder folder;
    const std::string file = folder / "scene.gl", state = folder / "state";
    {
        Session session = session_of_file(file, kText);
        RecoveryFile recovery(state);
        recovery.keep(session);
        EXPECT_FALSE(find_lost_scenes(state)) << "nothing was changed";
        set(session, CommandId::gluPerspective, 0, 60);
        show_scene(session, "report");
        press(session, '4');
        recovery.keep(session);
    }
    const auto lost = find_lost_scenes(state);
    ASSERT_TRUE(lost);
    EXPECT_TRUE(lost->summary.starts_with("report, scene.gl, on ")) << lost->summary;
    Session session(load_commands(file), file);
    restore(session, *lost);
    EXPECT_EQ(edited_scenes(session).size(), 2u);
    EXPECT_FALSE(find_lost_scenes(state));
    show_scene(session, file);
    EXPECT_EQ(text_now(session), replaced(kText, "45,", "60,"));
    press(session, 'z');
    EXPECT_EQ(text_now(session), kText);
}

TEST(SessionRecovery, RemovesItsFileWhenAllIsSaved) {
    const TemporaryFolder folder;
    Session session = session_of_file(folder / "scene.gl", kText);
    RecoveryFile recovery(folder / "state");
    set(session, CommandId::gluPerspective, 0, 60);
    recovery.keep(session);
    EXPECT_TRUE(find_lost_scenes(folder / "state"));
    save(session);
    recovery.keep(session);
    EXPECT_FALSE(find_lost_scenes(folder / "state"));
}

TEST(SessionRecovery, DoesWithoutAFolderThatItCanWrite) {
    const TemporaryFolder folder;
    write_file_atomically(folder / "file", "");
    Session session = session_of("report");
    press(session, '4');
    RecoveryFile(folder / "file/state").keep(session);
    RecoveryFile("").keep(session);
    EXPECT_FALSE(find_lost_scenes(folder / "none"));
}

// ---- One scene after the other ----

TEST(SessionScenes, EachKeepsItsHistory) {
    const TemporaryFolder folder;
    const std::string file = folder / "scene.gl";
    Session session = session_of_file(file, kText);
    set(session, CommandId::gluPerspective, 0, 60);
    const CommandList edited = commands(session);
    const int revision = session.history.revision();
    show_scene(session, neighbour_scene(session, 1));
    EXPECT_NE(title_of(session), "scene.gl");
    EXPECT_GT(session.history.revision(), revision);
    show_scene(session, neighbour_scene(session, -1));
    EXPECT_EQ(title_of(session), "scene.gl");
    EXPECT_EQ(commands(session).commands, edited.commands);
    press(session, 'z');
    EXPECT_EQ(text_now(session), kText);
    // Ending asks for all of them.
    press(session, 'y');
    show_scene(session, "report");
    press(session, kEscape);
    EXPECT_EQ(session.dialog, Dialog::kEnd);
    EXPECT_FALSE(session.quit_requested);
}

TEST(SessionScenes, EscClosesWhatIsOnTopFirst) {
    Session session = session_of("report");
    press(session, '?');
    press(session, kCtrl + 'o');
    press(session, kEscape);
    EXPECT_EQ(session.dialog, Dialog::kNone);
    EXPECT_TRUE(session.keys_shown);
    press(session, kEscape);
    EXPECT_FALSE(session.keys_shown);
    EXPECT_FALSE(session.quit_requested);
    press(session, kEscape);
    EXPECT_TRUE(session.quit_requested);
}

TEST(SessionCalls, AreCopiedPastedAndFound) {
    Session session = session_of("report");
    EXPECT_EQ(selected_calls(session), "");
    session.selected_command = find_call(session, "gl_light1", 0);
    ASSERT_TRUE(session.selected_command);
    const std::string call = selected_calls(session);
    EXPECT_NE(call.find("GL_LIGHT1"), std::string::npos);
    const std::size_t before = commands(session).commands.size();
    insert_calls(session, call + "glFlush();");
    EXPECT_EQ(commands(session).commands.size(), before + 2);
    EXPECT_EQ(selected_calls(session), call);
    EXPECT_FALSE(find_call(session, "no such call", 0));
    EXPECT_THROW(insert_calls(session, "hello"), SceneError);
}

}  // namespace
}  // namespace twinlight::session::session_saving_test
