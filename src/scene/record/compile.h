// Compiles programs that use GL.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace twinlight::trace {

// Whether this is a file of C or C++ source, or of Python, by its extension in any case.
bool is_source(const std::string& file);
bool is_python(const std::string& file);
// Whether a source of C or C++ has a function main().
bool has_main(std::string_view source);

struct Build {
    std::vector<std::string> sources;
    std::vector<std::string> options{};  // -IDIR, -DNAME, -LDIR, -lNAME
};

// Compiles the sources with debug information into the program `program`, with freeglut and GLU. Headers of other systems
// (windows.h, GLUT/glut.h, OpenGL/gl.h, in any case) are replaced. If functions are missing that other sources of the folder may
// define, compiles those, too, and returns their names. Throws SceneError with the reason; the compiler's messages go to
// `messages`.
struct Compiled {
    std::vector<std::string> others{};  // sources that were added
    std::string messages{};
    std::string failure{};  // "" if the program was made
};
Compiled compile(const Build& build, const std::string& program);

// The line with the first error in a compiler's messages. Empty if nothing failed, or only the linker.
std::string first_error(const std::string& messages);

}  // namespace twinlight::trace
