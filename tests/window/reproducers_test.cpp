// twinlight check --write-reproducers, to its end: the programs are compiled, run with the real freeglut under Xvfb, and show what
// the suite found.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "../unit/effort.h"
#include "../unit/run_program.h"
#include "judge/check/suite.h"
#include "judge/compare/departures.h"
#include "render/context/context.h"
#include "render/context/driver_name.h"
#include "xvfb.h"

namespace twinlight::reproducers_test {
namespace {

constexpr double kHalfCode = 0.5 / 255;  // of the window

// "0x0502 ..." or "(0.5, nan, 0, 1) ...", as the programs print it.
void expect_seen(const std::string& text, const check::Seen& expected, double tolerance) {
    if (const Enum* error = std::get_if<Enum>(&expected)) {
        EXPECT_EQ(std::strtoul(text.c_str(), nullptr, 16), *error) << text;
        return;
    }
    const auto& color = std::get<glm::dvec4>(expected);
    const char* at = text.c_str();
    for (int i = 0; i < 4; ++i) {
        char* end = nullptr;
        const double value = std::strtod(at + 1, &end);  // behind "(" or ","
        ASSERT_NE(end, at + 1) << text;
        at = end;
        if (value == color[i] || (std::isnan(value) && std::isnan(color[i]))) continue;  // infinite ones too
        EXPECT_NEAR(value, color[i], tolerance * std::max(1.0, std::abs(color[i]))) << text;
    }
}

class Reproducers : public testing::Test {
  protected:
    void SetUp() override {
        if (run_shell("", "command -v " + compiler_).status != 0) GTEST_SKIP() << "there is no C compiler";
        if (!server_.running()) GTEST_SKIP() << server_.reason();
    }
    ProgramResult written(const std::vector<std::string>& cases) const {
        std::vector<std::string> arguments = {"check", "--write-reproducers", folder_.str()};
        arguments.insert(arguments.end(), cases.begin(), cases.end());
        return run_program("twinlight", arguments);
    }
    // What the program prints; in one line of the shell, so that a program that is not there fails as well.
    ProgramResult compiled_and_run(const std::string& name, const std::string& environment = "") const {
        return run_shell(
            "", fmt::format("cd {} && {} -std=c99 -Wall -Werror {}.c -o {} -lglut -lGLU -lGL -lm && "
                            "{} DISPLAY={} LIBGL_ALWAYS_SOFTWARE=1 ./{}",
                            quoted(folder_.str()), compiler_, name, name, environment, server_.display(), name));
    }

    const std::string compiler_ = "${CC:-gcc}";
    const Xvfb server_;
    const TemporaryFolder folder_;
};

TEST_F(Reproducers, ShowTheDeparturesOfTheListedDriver) {
    const auto context = make_offscreen_context(8, 8);
    if (!compare::is_measured(current_driver())) GTEST_SKIP() << "nobody has looked at this driver's departures";
    const std::vector<check::Case> cases = check::load_cases();
    ASSERT_EQ(written({}).status, 0);
    int departing = 0;
    for (const check::Case& of : cases) {
        // Bugs that this release has corrected have no program.
        const bool departs = std::ranges::any_of(
            of.differs, [&](const check::Differs& differs) { return differs.is_of(driver_name()); });
        EXPECT_EQ(std::filesystem::exists(folder_ / (of.name + ".c")), departs) << of.name;
        // To link and run all takes a quarter of a minute: a third of them in CI.
        if (!departs || departing++ % 3 != 0 || !is_tried(departing / 3)) continue;
        SCOPED_TRACE(of.name);
        const ProgramResult shown = compiled_and_run(of.name);
        EXPECT_EQ(shown.status, 1) << shown.out << shown.err;
        EXPECT_NE(shown.out.find("OpenGL 2.1, section " + of.text), std::string::npos) << shown.out;
        EXPECT_NE(shown.out.find("The driver violates the specification."), std::string::npos) << shown.out;
        for (const check::Differs& differs : of.differs) {
            if (!differs.is_of(driver_name())) continue;
            const auto expected = std::ranges::find(of.expectations, differs.spot, &check::Expectation::spot);
            ASSERT_NE(expected, of.expectations.end());
            const bool is_error = differs.spot.kind == check::Spot::Kind::kError;
            const std::string right = check::text_of(expected->value);
            const std::string line =
                (is_error ? "(" + right + ")" : differs.spot.str() + ": expected " + right) + ", the driver gives ";
            ASSERT_NE(shown.out.find(line), std::string::npos) << shown.out;
            const double tolerance = of.tolerance.value_or(check::kTolerance) + (of.is_of_vertices() ? 0 : kHalfCode);
            expect_seen(shown.out.substr(shown.out.find(line) + line.size()), differs.value, tolerance);
        }
    }
    const ProgramResult all = run_shell(
        "", fmt::format("cd {} && {} -std=c99 -Wall -Werror -fsyntax-only *.c", quoted(folder_.str()), compiler_));
    EXPECT_EQ(all.status, 0) << all.err;
    EXPECT_GE(departing, 20);
}

// A case that expects something else than the text says; the program then says so, and says that all is well once it is corrected.
TEST_F(Reproducers, SayWhereNothingDeparts) {
    const auto text = [](const char* expectation) {
        return std::string("// what: w\n// why: w\n// text: 2.14.1\n// status: defined\n// derived: d\n// expect: ") +
               expectation +
               "\nglTranslatef(-0.75, -0.75, 0);\nglEnable(GL_LIGHTING);\n"
               "glMaterialfv(GL_FRONT, GL_EMISSION, (GLfloat[]){0.5, 2, -1, 1});\n"
               "glLightModelfv(GL_LIGHT_MODEL_AMBIENT, (GLfloat[]){0, 0, 0, 1});\n"
               "glBegin(GL_POINTS); glVertex3f(0, 0, 0); glEnd();\n";
    };
    for (const auto& [wrong, in_c, right] :
         {std::tuple("vertex 0: 0.75 2 -1 1", "{0.75, 2, -1, 1}", "{0.5, 2, -1, 1}"),
          std::tuple("pixel 8,55: 0.75 1 0 1", "{0.75, 1, 0, 1}", "{0.5, 1, 0, 1}")}) {
        write_file_atomically(folder_ / "small.gl", text(wrong));
        ASSERT_EQ(written({folder_ / "small.gl"}).status, 1);
        const ProgramResult departing = compiled_and_run("small");
        EXPECT_EQ(departing.status, 1) << departing.err;
        EXPECT_NE(departing.out.find("WRONG"), std::string::npos) << departing.out;
        std::string program = read_file(folder_ / "small.c");
        const std::size_t at = program.find(in_c);
        ASSERT_NE(at, std::string::npos) << program;
        program.replace(at, std::string(in_c).size(), right);
        write_file_atomically(folder_ / "small.c", program);
        const ProgramResult corrected = compiled_and_run("small");
        EXPECT_EQ(corrected.status, 0) << corrected.out << corrected.err;
        EXPECT_NE(corrected.out.find("The driver follows the specification."), std::string::npos) << corrected.out;
    }
}

// The driver's window refuses glClampColor: its error is not the scene's.
TEST_F(Reproducers, ChargeTheSceneAlone) {
    const auto context = make_offscreen_context(8, 8);
    if (!compare::is_measured(current_driver())) GTEST_SKIP() << "nobody has looked at this driver's departures";
    ASSERT_EQ(written({"error-single-value-light"}).status, 0);
    const ProgramResult shown = compiled_and_run(
        "error-single-value-light", "MESA_EXTENSION_OVERRIDE=-GL_ARB_color_buffer_float MESA_GL_VERSION_OVERRIDE=2.1");
    EXPECT_NE(shown.out.find("the driver clamps the colours of vertices"), std::string::npos) << shown.out << shown.err;
    EXPECT_NE(shown.out.find("(GL_INVALID_ENUM), the driver gives 0x0000"), std::string::npos) << shown.out;
}

// Feedback has the vertices of all Draws; those of the last are the case's.
TEST_F(Reproducers, ShowTheLastVertexOfAPlace) {
    std::string text =
        "// what: w\n// why: w\n// text: 2.14.1\n// status: defined\n// derived: d\n"
        "// expect: vertex 0: 0.75 0.5 0.5 1\n"
        "glTranslatef(-0.75, -0.75, 0);\nglEnable(GL_LIGHTING);\n"
        "glLightModelfv(GL_LIGHT_MODEL_AMBIENT, (GLfloat[]){0, 0, 0, 1});\n";
    for (const char* emission : {"0.75, 0.5, 0.5", "0.25, 0.5, 0.5"})
        text += fmt::format(
            "glMaterialfv(GL_FRONT, GL_EMISSION, (GLfloat[]){{{}, 1}});\n"
            "glBegin(GL_POINTS); glVertex3f(0, 0, 0); glEnd();\n",
            emission);
    write_file_atomically(folder_ / "two.gl", text);
    ASSERT_EQ(written({folder_ / "two.gl"}).status, 1);
    const ProgramResult shown = compiled_and_run("two");
    EXPECT_NE(shown.out.find("the driver gives (0.25, 0.5, 0.5, 1)"), std::string::npos) << shown.out << shown.err;
}

}  // namespace
}  // namespace twinlight::reproducers_test
