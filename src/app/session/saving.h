// Saving: the scene into its own file, and what is made of it into new ones.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "app/session/session.h"

namespace twinlight::session {

// ---- The scene ----

// The text that the scene was read from, changed only where the scene was: comments and expressions stay. Empty if the changes do not fit
// into it, for example because a command in a loop differs from one repetition to the next.
std::optional<std::string> text_now(const OpenScene& scene);
// The same, or the commands one by one if that is empty.
std::string text_to_save(const OpenScene& scene);
// All of these throw std::runtime_error with a sentence, and FileError.
void save(OpenScene& scene);                              // into its file, which it must have
void save_as(Session& session, const std::string& path);  // replaces the file; the scene has this file from now on
// All edited scenes; those without a file into new ones in this folder. Returns what to say.
std::string save_all(Session& session, const std::string& folder);

// The scene's file has this text now. Merges it with the edits, line by line. Where both changed the same line, the scene stays as it is and
// Dialog::kFileChanged asks. Undo gives the file's version alone. Throws SceneError.
void take_file_text(Session& session, const std::string& theirs);

// ---- What is made of it. No file is replaced: a number is added to a name that exists. ----

// kC: a freeglut program. kGlsl: a folder with shaders to keep and a program that loads them. kHtml: a page that draws the scene with
// WebGL 2.
enum class Form : std::uint8_t { kC, kGlsl, kHtml };
struct FormName {
    Form value;
    const char* words;
    const char* what;
    const char* ending;
};
inline constexpr FormName kForms[] = {
    {Form::kC, "C program", "a freeglut program that draws it: NAME.c", ".c"},
    {Form::kGlsl, "Shaders", "GLSL to keep, with a program that loads them: NAME-shaders/", "-shaders"},
    {Form::kHtml, "Web page", "one page that draws it with WebGL 2: NAME.html", ".html"},
};

// "report" for the scene report, "ball" for dir/ball.gl.
std::string stem_of(const std::string& scene);
// "FOLDER/STEM-2.gl" where "STEM.gl" exists, and so on.
std::string free_path(const std::string& folder, const std::string& stem, const std::string& ending);

// Writes the scene as it is now into this folder and returns what to say: "wrote ball-2.gl, 31 commands". The shaders light as
// `look` says. Throws std::runtime_error with a sentence where the scene cannot have this form, and FileError.
std::string save(const Session& session, Form form, const Look& look, const std::string& folder);

}  // namespace twinlight::session
