// Which GL draws: --gl, TWINLIGHT_GL, the system's path for libraries.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>

#include "../../window/xvfb.h"
#include "../run_program.h"
#include "base/image/file.h"
#include "base/image/png.h"
#include "base/text/json.h"

namespace twinlight::gl_choice_test {
namespace {

namespace fs = std::filesystem;

// Names of GLs for --gl that need no X server.
constexpr std::array kWithoutWindow = {"osmesa", "egl"};

// Shapes of GLU and of GLUT, text, textures, lines and points, whose borders would show rows that are upside down.
constexpr const char* kScene = "legacy";

int center_red(const std::string& png) {
    const PngPixels pixels = decode_png_pixels(png, 1000);
    return pixels.rgba[4 * static_cast<std::size_t>(pixels.height / 2 * pixels.width + pixels.width / 2)];
}

class GlChoice : public testing::Test {
  protected:
    // Mesa's software driver even if there is a GPU. `before`: variables, and perhaps xvfb-run.
    static ProgramResult run(const std::string& arguments, const std::string& before = "") {
        return run_shell("twinlight", "LIBGL_ALWAYS_SOFTWARE=true " + before + " \"$PROGRAM\" " + arguments);
    }
    // The driver, without the provider's name, and the provider; nullopt if there is no such GL here.
    struct Gl {
        std::string driver, provider, library;
    };
    std::optional<Gl> gl(const std::string& arguments, const std::string& before = "") {
        const ProgramResult result =
            run("compare report --size 16x16 --json -o " + quoted(folder_ / "report") + " " + arguments, before);
        if (result.status == 2) return std::nullopt;
        EXPECT_EQ(result.err, "");
        const auto json = nlohmann::json::parse(result.out);
        const std::string driver = json.at("driver"), library = json.at("library");
        EXPECT_EQ(result.gl, "twinlight: OpenGL is " + driver + " (" + library + ")\n");
        return Gl{driver.substr(0, driver.rfind(", ")), driver.substr(driver.rfind(", ") + 2), library};
    }
    std::string picture(const std::string& arguments, const std::string& before = "") {
        const ProgramResult result = run("render " + arguments + " -o " + quoted(folder_ / "picture.png"), before);
        EXPECT_EQ(result.status, 0) << result.err;
        return result.status == 0 ? read_file(folder_ / "picture.png") : "";
    }
    // The library that is loaded for a name.
    std::string library(const std::string& name) {
        const std::optional<Gl> found = gl("--gl " + name);
        return found ? found->library : "";
    }

    const TemporaryFolder folder_;
};

// GLU's calls reach the library that was loaded, so its shapes are in each picture.
TEST_F(GlChoice, DrawsTheSamePictureByEachGlOfOneDriver) {
    const Xvfb server;
    // EGL's buffers accumulate in Twinlight's own code, whatever textures are enabled in whichever unit.
    const std::string accumulates = folder_ / "accumulates.gl", sphere = folder_ / "sphere.gl";
    write_file_atomically(
        accumulates,
        "GLubyte texel[] = {99, 150, 201, 255}; glClearColor(0.75, 0.5, 0.25, 1); glClear(GL_COLOR_BUFFER_BIT);\n"
        "glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);\n"
        "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST); glEnable(GL_TEXTURE_2D);\n"
        "glActiveTexture(GL_TEXTURE1); glAccum(GL_LOAD, 1); glRectf(0, 0, 1, 1); glAccum(GL_ACCUM, -0.3);\n"
        "glAccum(GL_RETURN, 1);\n");
    write_file_atomically(
        sphere,
        "glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT); glEnable(GL_DEPTH_TEST); glEnable(GL_LIGHTING);\n"
        "glEnable(GL_LIGHT0); glMatrixMode(GL_PROJECTION); glOrtho(-1, 1, -1, 1, -1, 1);\n"
        "GLUquadric* q = gluNewQuadric(); gluSphere(q, 0.8, 24, 12);\n");
    struct Named {
        std::string option, before;
        Gl gl;
    };
    std::vector<Named> there;
    for (const auto& [name, before] : {std::pair(std::string("--gl osmesa"), std::string()),
                                       {"--gl egl", ""},
                                       {"--gl libGL.so.1", "DISPLAY=" + server.display()}}) {
        if (!before.empty() && !server.running()) continue;
        if (const auto found = gl(name, before)) there.push_back({name, before, *found});
    }
    if (there.size() < 2) GTEST_SKIP() << "there is one GL only";
    for (const std::string& scene : {std::string(kScene), accumulates, sphere}) {
        for (const char* renderer : {"fixed", "shaders"}) {
            std::string first;
            for (const Named& each : there) {
                if (each.gl.driver != there[0].gl.driver) continue;  // another release of Mesa
                const std::string bytes =
                    picture(quoted(scene) + " --with " + renderer + " " + each.option, each.before);
                if (first.empty()) first = bytes;
                EXPECT_TRUE(bytes == first) << scene << " with " << renderer << ", " << each.option;
                if (scene != sphere || bytes.empty()) continue;
                EXPECT_GT(center_red(bytes), 128) << each.option;
            }
        }
    }
}

TEST_F(GlChoice, TakesTheOptionThenTheVariableThenOsmesaOrEgl) {
    const std::optional<Gl> osmesa = gl("--gl osmesa"), egl = gl("--gl egl"), chosen = gl("");
    ASSERT_TRUE(chosen);
    EXPECT_EQ(chosen->provider, osmesa ? "OSMesa" : "EGL");
    if (!egl) GTEST_SKIP() << "there is no EGL";
    EXPECT_EQ(egl->provider, "EGL");
    const std::optional<Gl> by_variable = gl("", "TWINLIGHT_GL=egl");
    ASSERT_TRUE(by_variable);
    EXPECT_EQ(by_variable->provider, "EGL");
    if (!osmesa) GTEST_SKIP() << "there is no OSMesa";
    const std::optional<Gl> by_option = gl("--gl osmesa", "TWINLIGHT_GL=egl");
    ASSERT_TRUE(by_option);
    EXPECT_EQ(by_option->provider, "OSMesa");
}

// A driver that someone has built: by its file, or by LD_LIBRARY_PATH.
TEST_F(GlChoice, LoadsALibraryFromAnyFolder) {
    for (const std::string name : kWithoutWindow) {
        const std::string system = library(name);
        if (system.empty()) continue;
        const fs::path own = folder_ / name;
        fs::create_directory(own);
        const fs::path copy = own / fs::path(system).filename();
        fs::copy_file(system, copy);
        const std::optional<Gl> by_file = gl("--gl " + quoted(copy));
        const std::optional<Gl> by_path = gl("--gl " + name, "LD_LIBRARY_PATH=" + quoted(own));
        ASSERT_TRUE(by_file && by_path) << name;
        EXPECT_EQ(by_file->library, copy);
        EXPECT_EQ(by_path->library, copy);
        EXPECT_NE(system, copy);
    }
}

TEST_F(GlChoice, IsNamedFirstByEachCommandThatDraws) {
    for (const std::string command :
         {"render report --size 8x8 -o p.png", "compare report --size 8x8 -o r",
          "explain report --size 8x8 --pixel 4,4", "study report --size 8x8 --quick --seconds 0 -o s",
          "fuzz --count 1 -o f", "fuzz --count 1 --against oracle -o f", "check horizon-exact",
          "explain materials --size 8x8 --vertex 1,1"}) {
        const ProgramResult result =
            run_shell("twinlight", "P=$(realpath \"$PROGRAM\"); cd " + quoted(folder_.str()) + " && \"$P\" " + command);
        EXPECT_NE(result.status, 2) << command << ": " << result.err;
        EXPECT_TRUE(result.gl.starts_with("twinlight: OpenGL is ") && result.gl.ends_with(")\n")) << command;
        EXPECT_EQ(result.err.find("OpenGL is"), std::string::npos) << command;
    }
    for (const char* command : {"scenes", "lint report", "export report --as c", "--help"})
        EXPECT_EQ(run_shell("twinlight", std::string("\"$PROGRAM\" ") + command).gl, "") << command;
}

TEST_F(GlChoice, SaysInOneLineWhatIsWrong) {
    const auto refused = [&](const std::string& name, const std::string& expected) {
        const ProgramResult result = run_shell(
            "twinlight", "P=$(realpath \"$PROGRAM\"); cd " + quoted(folder_.str()) +
                             " && touch here.so && env -u DISPLAY \"$P\" render report -o p.png --gl " + name);
        EXPECT_EQ(result.status, 2);
        EXPECT_EQ(result.out + result.gl, "");
        EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
        EXPECT_NE(result.err.find(expected), std::string::npos) << result.err;
    };
    refused("nowhere.so", "nowhere.so: cannot open shared object file");
    refused("nowhere.so", "give osmesa, egl, or the file of a libOSMesa, libEGL or libGL");
    refused("here.so", "did you mean ./here.so?");
    refused("./here.so", "./here.so: file too short");
    refused("libm.so.6", "libm.so.6 has no functions that make a context");
    refused("''", "--gl");
    if (run_shell("", "/sbin/ldconfig -p | grep -q 'libGL.so.1 '").status == 0)
        refused("libGL.so.1", "cannot connect to an X server");
}

TEST_F(GlChoice, NamesAFunctionThatTheLibraryLacks) {
    if (run_shell("", "command -v cc").status != 0) GTEST_SKIP() << "there is no C compiler";
    write_file_atomically(folder_ / "empty.c",
                          "void* OSMesaCreateContextAttribs(const int* a, void* b) { static int c; return &c; }\n"
                          "void OSMesaDestroyContext(void* a) {}\n"
                          "int OSMesaMakeCurrent(void* a, void* b, unsigned c, int d, int e) { return 1; }\n"
                          "void* OSMesaGetProcAddress(const char* a) { return 0; }\n");
    const ProgramResult result =
        run_shell("twinlight", "P=$(realpath \"$PROGRAM\"); cd " + quoted(folder_.str()) +
                                   " && cc -w -shared -fPIC empty.c -o libempty.so && \"$P\" check horizon-exact --gl "
                                   "./libempty.so");
    EXPECT_EQ(result.status, 2);
    EXPECT_TRUE(result.err.starts_with("twinlight: ./libempty.so has no function gl")) << result.err;
    EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
}

TEST_F(GlChoice, TellsInOneLineThatEglHasNoDriver) {
    if (library("egl").empty()) GTEST_SKIP() << "there is no EGL";
    for (const auto& [variables, advice] :
         {std::pair("__EGL_VENDOR_LIBRARY_FILENAMES=/nowhere", "install the GPU's driver or Mesa's"),
          {"__EGL_VENDOR_LIBRARY_FILENAMES=/nowhere LIBGL_DRIVERS_PATH=/nowhere",
           "LIBGL_DRIVERS_PATH is '/nowhere'; unset it"}}) {
        const ProgramResult result = run_shell(
            "twinlight", std::string("unset LIBGL_DRIVERS_PATH; ") + variables +
                             " \"$PROGRAM\" render report --gl egl --with fixed -o " + quoted(folder_ / "picture.png"));
        EXPECT_EQ(result.status, 2);
        EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
        EXPECT_NE(result.err.find(advice), std::string::npos) << result.err;
        EXPECT_FALSE(fs::exists(folder_ / "picture.png"));
    }
}

// The message has the reason of each display, and nothing of Mesa's own messages.
TEST_F(GlChoice, TellsInOneLineWhatOfEglDoesNotStart) {
    if (library("egl").empty()) GTEST_SKIP() << "there is no EGL";
    const ProgramResult result =
        run_shell("twinlight", "LIBGL_DRIVERS_PATH=/nowhere \"$PROGRAM\" render report --gl egl --with fixed -o " +
                                   quoted(folder_ / "picture.png"));
    if (result.status == 0) GTEST_SKIP() << "EGL's driver is not one of Mesa's";
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
    EXPECT_NE(result.err.find("it does not start"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace twinlight::gl_choice_test
