// Compares the program of `make GL=egl` with the OSMesa program: the same pictures on the same driver.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "../run_program.h"
#include "base/image/file.h"
#include "base/text/json.h"
#include "render/context/context.h"

namespace twinlight::egl_test {
namespace {

class Egl : public testing::Test {
  protected:
    void SetUp() override {
        program_ = context_provider() == "EGL" ? "twinlight" : "egl/twinlight";
        if (!std::filesystem::exists(build_folder() + "/" + program_))
            GTEST_SKIP() << "make GL=egl builds it, where Debian's package libegl-dev is installed";
    }

    std::string program_;
    const TemporaryFolder folder_;
};

TEST_F(Egl, DrawsThePicturesOfOsmesa) {
    if (context_provider() == "EGL") GTEST_SKIP() << "this is EGL's program: the other's test compares them";
    const auto run = [](const std::string& program, const std::string& arguments) {
        return run_shell(program, "LIBGL_ALWAYS_SOFTWARE=true \"$PROGRAM\" " + arguments);  // even if there is a GPU
    };
    const auto driver = [&](const std::string& program) {
        const ProgramResult result =
            run(program, "compare report --size 16x16 --json -o " + quoted(folder_ / "report"));
        EXPECT_EQ(result.err, "");
        const std::string text = nlohmann::json::parse(result.out).at("driver");
        return std::pair(text.substr(0, text.rfind(", ")), text.substr(text.rfind(", ") + 2));
    };
    const auto [driver_of_osmesa, osmesa] = driver("twinlight");
    const auto [driver_of_egl, egl] = driver(program_);
    EXPECT_EQ(osmesa, "OSMesa");
    EXPECT_EQ(egl, "EGL");
    if (driver_of_egl != driver_of_osmesa) GTEST_SKIP() << "EGL's driver is another: " << driver_of_egl;
    // EGL's buffers accumulate in Twinlight's own code, whatever textures are enabled in whichever unit.
    const std::string accumulates = folder_ / "accumulates.gl";
    write_file_atomically(
        accumulates,
        "GLubyte texel[] = {99, 150, 201, 255}; glClearColor(0.75, 0.5, 0.25, 1); glClear(GL_COLOR_BUFFER_BIT);\n"
        "glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);\n"
        "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST); glEnable(GL_TEXTURE_2D);\n"
        "glActiveTexture(GL_TEXTURE1); glAccum(GL_LOAD, 1); glRectf(0, 0, 1, 1); glAccum(GL_ACCUM, -0.3);\n"
        "glAccum(GL_RETURN, 1);\n");
    // The built-in scene has points, lines, textures and text, whose borders would show rows that are upside down.
    for (const std::string& scene : {std::string("legacy"), accumulates}) {
        for (const char* renderer : {"fixed", "shaders"}) {
            const auto picture = [&](const std::string& program, const std::string& name) {
                EXPECT_EQ(
                    run(program, "render " + quoted(scene) + " --with " + renderer + " -o " + quoted(folder_ / name))
                        .status,
                    0);
                return read_file(folder_ / name);
            };
            EXPECT_TRUE(picture("twinlight", "osmesa.png") == picture(program_, "egl.png"))
                << scene << " with " << renderer;
        }
    }
}

TEST_F(Egl, TellsInOneLineThatNoDriverIsThere) {
    for (const auto& [variables, advice] :
         {std::pair("", "install the GPU's driver or Mesa's"),
          {"LIBGL_DRIVERS_PATH=/nowhere", "LIBGL_DRIVERS_PATH is '/nowhere'; unset it"}}) {
        const ProgramResult result = run_shell(
            program_, std::string("unset LIBGL_DRIVERS_PATH; __EGL_VENDOR_LIBRARY_FILENAMES=/nowhere ") + variables +
                          " \"$PROGRAM\" render report --with fixed -o " + quoted(folder_ / "picture.png"));
        EXPECT_EQ(result.status, 2);
        EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
        EXPECT_NE(result.err.find(advice), std::string::npos) << result.err;
        EXPECT_TRUE(folder_.names().empty());
    }
}

// The message has the reason of each display, and nothing of Mesa's own messages.
TEST_F(Egl, TellsInOneLineWhatDoesNotStart) {
    const ProgramResult result =
        run_shell(program_, "LIBGL_DRIVERS_PATH=/nowhere \"$PROGRAM\" render report --with fixed -o " +
                                quoted(folder_ / "picture.png"));
    if (result.status == 0) GTEST_SKIP() << "EGL's driver is not one of Mesa's";
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
    EXPECT_NE(result.err.find("it does not start"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace twinlight::egl_test
