// twinlight check --write-reproducers, to its end: the programs are compiled, run with the real freeglut under Xvfb, and show what
// the suite found.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "../golden/listed_driver.h"
#include "../unit/run_program.h"
#include "check/check.h"
#include "context/context.h"
#include "xvfb.h"

namespace twinlight {
namespace {

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
    ProgramResult compiled_and_run(const std::string& name) const {
        return run_shell("", fmt::format("cd {} && {} -std=c99 -Wall -Werror {}.c -o {} -lglut -lGLU -lGL -lm && "
                                         "DISPLAY={} LIBGL_ALWAYS_SOFTWARE=1 ./{}",
                                         quoted(folder_.str()), compiler_, name, name, server_.display(), name));
    }

    const std::string compiler_ = "${CC:-gcc}";
    const Xvfb server_;
    const TemporaryFolder folder_;
};

TEST_F(Reproducers, ShowTheDeparturesOfTheListedDriver) {
    const auto context = make_offscreen_context(8, 8);
    if (!is_listed_driver()) GTEST_SKIP() << "nobody has looked at this driver's departures";
    const std::vector<check::Case> cases = check::load_cases();
    ASSERT_EQ(written({}).status, 0);
    int departing = 0;
    for (const check::Case& of : cases) {
        EXPECT_EQ(std::filesystem::exists(folder_ / (of.name + ".c")), !of.differs.empty()) << of.name;
        if (of.differs.empty() || departing++ % 3 != 0) continue;  // to compile all takes a quarter of a minute
        SCOPED_TRACE(of.name);
        const ProgramResult shown = compiled_and_run(of.name);
        EXPECT_EQ(shown.status, 1) << shown.out << shown.err;
        EXPECT_NE(shown.out.find("OpenGL 2.1, section " + of.text), std::string::npos) << shown.out;
        EXPECT_NE(shown.out.find("The driver departs from the specification."), std::string::npos) << shown.out;
        for (const check::Differs& differs : of.differs) {
            const auto expected = std::ranges::find(of.expectations, differs.spot, &check::Expectation::spot);
            ASSERT_NE(expected, of.expectations.end());
            const bool is_error = differs.spot.kind == check::Spot::Kind::kError;
            const std::string right = check::text_of(expected->value);
            EXPECT_NE(shown.out.find(is_error ? "(" + right + "), the driver gives"
                                              : differs.spot.str() + ": expected " + right + ", the driver gives"),
                      std::string::npos)
                << shown.out;
        }
    }
    EXPECT_GE(departing, 20);
}

// A case that expects something else than the text says; the program then says so, and says that all is well once it is mended.
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
        EXPECT_NE(departing.out.find("DIFFERS"), std::string::npos) << departing.out;
        std::string program = read_file(folder_ / "small.c");
        const std::size_t at = program.find(in_c);
        ASSERT_NE(at, std::string::npos) << program;
        program.replace(at, std::string(in_c).size(), right);
        // Of pixels half a code is rounding's.
        const std::string strict = "kTolerance = 3e-05";
        ASSERT_NE(program.find(strict), std::string::npos);
        if (std::string_view(wrong).starts_with("pixel"))
            program.replace(program.find(strict), strict.size(), "kTolerance = 0.5 / 255 + 3e-05");
        write_file_atomically(folder_ / "small.c", program);
        const ProgramResult mended = compiled_and_run("small");
        EXPECT_EQ(mended.status, 0) << mended.out << mended.err;
        EXPECT_NE(mended.out.find("As the specification says."), std::string::npos) << mended.out;
    }
}

}  // namespace
}  // namespace twinlight
