// Which release of Mesa draws in windows. It need not be OSMesa's: Ubuntu 26.04 has 26.0 there and OSMesa 25.1.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "../unit/run_program.h"
#include "base/image/file.h"
#include "render/context/context.h"
#include "render/context/driver_name.h"

namespace twinlight {

// "26.0.8"; empty if there is no C compiler.
inline std::string release_of_windows(const std::string& display) {
    const TemporaryFolder folder;
    write_file_atomically(folder / "release.c", R"(
        #include <GL/glut.h>
        #include <stdio.h>
        int main(int count, char** words) {
            glutInit(&count, words);
            glutCreateWindow("release");
            return puts((const char*)glGetString(GL_VERSION)) < 0;
        }
    )");
    const ProgramResult ran = run_shell(
        "", "cd " + quoted(folder.str()) + " && ${CC:-gcc} release.c -o release -lglut -lGL && DISPLAY=" + display +
                " LIBGL_ALWAYS_SOFTWARE=1 ./release");
    return std::string(parse_driver_name("a window, " + ran.out.substr(0, ran.out.find('\n')) + ", GLX").number());
}

// Whether windows have another release than OSMesa. Then the pictures are not equal bit for bit: releases add products in another
// order, which moves borders and rounds to another of the 255 steps (by up to two, where shaders of textures do so as well).
inline bool has_another_release(const std::string& display) {
    const auto context = make_offscreen_context(1, 1);
    const std::string release = release_of_windows(display);
    return !release.empty() && release != current_driver().number();
}
inline constexpr double kOfAnotherRelease = 2 / 255.0;
inline constexpr double kBorderlineOfAnotherRelease =
    0.1;  // share of pixels, measured on Ubuntu 26.04: 6 % of those at edges

}  // namespace twinlight
