// Saving: the files that the window writes. It replaces no file: a number is added to a name that exists.
#pragma once

#include <cstdint>
#include <string>

#include "app/session/session.h"

namespace twinlight::session {

// kScene: the commands as a scene file. kC: a freeglut program. kGlsl: a folder with shaders to keep and a program that loads
// them. kHtml: a page that draws the scene with WebGL 2.
enum class Form : std::uint8_t { kScene, kC, kGlsl, kHtml };
struct FormName {
    Form value;
    const char* words;
    const char* what;
    const char* ending;
};
inline constexpr FormName kForms[] = {
    {Form::kScene, "Scene", "its commands, to open again: NAME.gl", ".gl"},
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
