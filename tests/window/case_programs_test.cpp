// twinlight check --write-cases, to its end: the programs are compiled and run on the system's GL, and agree with what the suite lists for it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "../unit/run_program.h"
#include "base/image/file.h"
#include "judge/check/case.h"
#include "judge/compare/departures.h"
#include "render/context/context.h"
#include "render/context/driver_name.h"
#include "xvfb.h"

namespace twinlight::case_programs_test {
namespace {

// The lines that programs print: the name of GL, and "NAME: VERDICT ...".
struct Lines {
    std::string gl;
    std::map<std::string, std::string> of_cases;

    explicit Lines(const std::string& out) {
        std::istringstream stream(out);
        for (std::string line; std::getline(stream, line);) {
            const std::size_t at = line.find(": ");
            if (at == std::string::npos) continue;
            if (line.starts_with("GL: "))
                gl = line.substr(4);
            else
                of_cases[line.substr(0, at)] = line.substr(at + 2);
        }
    }
    std::string verdict(const std::string& name) const {
        const auto found = of_cases.find(name);
        if (found == of_cases.end()) return "";
        return found->second.substr(0, std::min(found->second.find(" ("), found->second.find(':')));
    }
    // As driver_name() writes it.
    std::string driver() const {
        const std::size_t renderer = gl.find("; "), version = gl.find("; ", renderer + 2);
        return fmt::format("{}, {}, GLX", gl.substr(renderer + 2, version - renderer - 2), gl.substr(version + 2));
    }
};

// The four numbers of "0.5, nan, 0, 1)"; none where there are fewer.
std::vector<double> values_at(const char* text) {
    std::vector<double> values;
    for (int i = 0; i < 4; ++i) {
        char* end = nullptr;
        values.push_back(std::strtod(text, &end));
        if (end == text) return {};
        text = end + 1;
    }
    return values;
}

class CasePrograms : public testing::Test {
  protected:
    void SetUp() override {
        if (run_shell("", "command -v " + compiler_).status != 0) GTEST_SKIP() << "there is no C compiler";
        if (!server_.running()) GTEST_SKIP() << server_.reason();
    }
    ProgramResult written(std::vector<std::string> cases) const {
        cases.insert(cases.begin(), {"check", "--write-cases", folder_.str()});
        return run_program("twinlight", cases);
    }
    ProgramResult in_folder(const std::string& command) const {
        return run_shell("", "cd " + quoted(folder_.str()) +
                                 " && export LIBGL_ALWAYS_SOFTWARE=1 DISPLAY=" + server_.display() + " && " + command);
    }
    ProgramResult made(const std::string& goals) const {
        return in_folder("make CC=" + compiler_ + " CFLAGS='-Wall -Wextra -Wpedantic -Werror' " + goals);
    }
    std::string own_case(const char* expectation) const {
        const std::string path = folder_ / "small.gl";
        write_file_atomically(path,
                              std::string("// what: w\n// why: w\n// text: 2.14.1\n// status: defined\n// derived: d\n"
                                          "// expect: ") +
                                  expectation +
                                  "\nglTranslatef(-0.75, -0.75, 0);\nglEnable(GL_LIGHTING);\n"
                                  "glMaterialfv(GL_FRONT, GL_EMISSION, (GLfloat[]){0.5, 2, -1, 1});\n"
                                  "glLightModelfv(GL_LIGHT_MODEL_AMBIENT, (GLfloat[]){0, 0, 0, 1});\n"
                                  "glBegin(GL_POINTS); glVertex3f(0, 0, 0); glEnd();\n");
        return path;
    }

    const std::string compiler_ = "${CC:-gcc}";
    const Xvfb server_;
    const TemporaryFolder folder_;
};

// Where clip coordinates are near the largest float, llvmpipe draws no point; feedback has its colour.
bool is_lost_by_the_rasteriser(const std::string& name) { return name == "clip-w-1e37"; }

TEST_F(CasePrograms, FindTheListedBugsAndNoOthers) {
    ASSERT_EQ(written({}).status, 0);
    const ProgramResult built = made("build/all");
    ASSERT_EQ(built.status, 0) << built.err;
    const Lines by_feedback(in_folder("build/all").out), by_pixels(in_folder("build/all --pixel").out);
    if (!compare::is_measured(parse_driver_name(by_feedback.driver())))
        GTEST_SKIP() << "nobody has looked at the departures of " << by_feedback.gl;
    int wrong = 0, pixels = 0;
    for (const check::Case& of : check::load_cases()) {
        if (!by_feedback.of_cases.contains(of.name)) continue;  // the fixed function lacks what it needs
        const std::string feedback = by_feedback.verdict(of.name), pixel = by_pixels.verdict(of.name);
        if (of.is_ruling) {
            EXPECT_TRUE(feedback == "right" || feedback == "open") << of.name << ": " << feedback;
            EXPECT_TRUE(pixel == "right" || pixel == "open" || pixel == "not run") << of.name << ": " << pixel;
            continue;
        }
        const bool departs = std::ranges::any_of(
            of.differs, [&](const check::Differs& differs) { return differs.is_of(by_feedback.driver()); });
        const std::string expected = departs ? "wrong" : "right";
        EXPECT_EQ(feedback, expected) << of.name << ": " << by_feedback.of_cases.at(of.name);
        if (pixel != "not run" && !is_lost_by_the_rasteriser(of.name)) {
            EXPECT_EQ(pixel, expected) << of.name << ": " << by_pixels.of_cases.at(of.name);
            ++pixels;
        }
        wrong += departs;
        // The wrong values are the listed ones, too: nothing but the bug is seen.
        for (const check::Differs& differs : of.differs) {
            if (!differs.is_of(by_feedback.driver()) || differs.spot.kind == check::Spot::Kind::kError) continue;
            const std::string& line = by_feedback.of_cases.at(of.name);
            const std::size_t place = line.find(differs.spot.str() + ": "), gives = line.find("this GL gives ", place);
            ASSERT_NE(gives, std::string::npos) << line;
            const std::vector<double> values = values_at(line.c_str() + gives + 15);
            ASSERT_EQ(values.size(), 4u) << line;
            const glm::dvec4& listed = std::get<glm::dvec4>(differs.value);
            const double tolerance = of.tolerance.value_or(check::kTolerance) + (of.is_of_vertices() ? 0 : 0.5 / 255);
            for (int i = 0; i < 4; ++i) {
                const double value = values[static_cast<std::size_t>(i)];
                if (value == listed[i] || (std::isnan(value) && std::isnan(listed[i]))) continue;
                EXPECT_NEAR(value, listed[i], tolerance * std::max(1.0, std::abs(listed[i]))) << line;
            }
        }
    }
    EXPECT_GE(wrong, 60);
    EXPECT_GE(pixels, 230);
}

// A case that expects something else than the text says, and the same corrected.
TEST_F(CasePrograms, SayWhatIsWrong) {
    for (const auto& [wrong, right, finding] :
         {std::tuple("vertex 0: 0.75 2 -1 1", "vertex 0: 0.5 2 -1 1",
                     "wrong (feedback): vertex 0: expected (0.75, 2, -1, 1), this GL gives (0.5, 2, -1, 1)"),
          std::tuple("pixel 8,55: 0.75 1 0 1", "pixel 8,55: 0.5 1 0 1",
                     "wrong (pixel): pixel 8,55: expected (0.75, 1, 0, 1), this GL gives (0.5019608, 1, 0, 1)")}) {
        ASSERT_EQ(written({own_case(wrong)}).status, 0);
        ASSERT_EQ(made("build/small").status, 0);
        const ProgramResult found = in_folder("build/small");
        EXPECT_EQ(found.status, 1) << found.err;
        EXPECT_NE(found.out.find("small: " + std::string(finding) + "; OpenGL 2.1, section 2.14.1\n"),
                  std::string::npos)
            << found.out;
        ASSERT_EQ(written({own_case(right)}).status, 0);
        ASSERT_EQ(made("build/small").status, 0);
        const ProgramResult corrected = in_folder("build/small");
        EXPECT_EQ(corrected.status, 0) << corrected.out;
        EXPECT_NE(corrected.out.find("small: right"), std::string::npos) << corrected.out;
    }
}

TEST_F(CasePrograms, EndWith77WhereTheyCannotRun) {
    ASSERT_EQ(written({"color-hdr", "pixels-copied-mask", "texture-3d-level", "vertex-w-2"}).status, 0);
    ASSERT_EQ(made("all").status, 0);
    const auto expect_77 = [&](const std::string& command, const std::string& reason) {
        const ProgramResult result = in_folder(command);
        EXPECT_EQ(result.status, 77) << command << result.err;
        EXPECT_NE(result.out.find(": not run: " + reason), std::string::npos) << command << ": " << result.out;
    };
    // freeglut ends the program with status 1.
    expect_77("DISPLAY= build/vertex-w-2", "a library ended the program");
    expect_77("DISPLAY= build/all", "a library ended the program");
    expect_77("build/color-hdr --pixel", "8 bits cannot show a colour outside [0, 1]");
    expect_77("MESA_GL_VERSION_OVERRIDE=1.3 build/pixels-copied-mask", "this GL has no glWindowPos2i (OpenGL 1.4)");
    // All cases go on after one that cannot run.
    const Lines old(in_folder("MESA_GL_VERSION_OVERRIDE=1.1 build/all").out);
    EXPECT_EQ(old.verdict("pixels-copied-mask"), "not run");
    EXPECT_EQ(old.verdict("texture-3d-level"), "not run");
    EXPECT_NE(old.verdict("vertex-w-2"), "not run");
    // Without unclamped colours the clamped ones are compared.
    const ProgramResult clamped = in_folder("MESA_EXTENSION_OVERRIDE=-GL_ARB_color_buffer_float build/color-hdr");
    EXPECT_EQ(clamped.status, 0) << clamped.out;
}

TEST_F(CasePrograms, AreSummedUp) {
    ASSERT_EQ(written({"light-behind", "vertex-w-2", "color-hdr"}).status, 0);
    for (const char* goal : {"report", "report-at-once"}) {
        const ProgramResult result = made(std::string(goal) + " ARGUMENTS=--pixel");
        ASSERT_EQ(result.status, 0) << result.err;
        EXPECT_NE(result.out.find("3 cases: 1 right, 1 wrong, 0 open, 1 not run, 0 crashed\n"), std::string::npos)
            << result.out;
        const auto json = nlohmann::json::parse(read_file(folder_ / "report.json"));
        EXPECT_EQ(json.at("wrong"), 1);
        EXPECT_EQ(json.at("cases").size(), 3u);
        EXPECT_EQ(json.at("cases").at(1).at("name"), "vertex-w-2");
        EXPECT_EQ(json.at("cases").at(1).at("result"), "wrong");
        EXPECT_EQ(json.at("cases").at(1).at("read_by"), "pixel");
        const std::string page = read_file(folder_ / "report.html");
        EXPECT_LT(page.find("<tr id=\"vertex-w-2\">"),
                  page.find("<tr id=\"light-behind\">"));  // what is wrong comes first
    }
}

// The values of "NAME: (0.5, nan, 0, 1)" at the start of a line; none where the name is not there.
std::vector<double> values_after(const std::string& out, const std::string& name) {
    const std::size_t at = ("\n" + out).find("\n" + name + ": (");
    return at == std::string::npos ? std::vector<double>() : values_at(out.c_str() + at + name.size() + 3);
}

// The C program of a bug report.
std::string program_in(const std::string& report) {
    const std::size_t begin = report.find("```c\n"), end = report.rfind("```");
    EXPECT_LT(begin, end);
    return begin < end ? report.substr(begin + 5, end - begin - 5) : "";
}

// Bug reports: the driver of `check` and that of the program must be of one release.
TEST_F(CasePrograms, ReportsHaveAProgramThatShowsTheBug) {
    const auto context = make_offscreen_context(8, 8);
    if (!compare::is_measured(current_driver())) GTEST_SKIP() << "nobody has looked at this driver's departures";
    const std::vector<std::string> names = {
        "vertex-w-2", "vertex-w-0-directional-range", "light-directional-beside-infinity",
        "label-fog",  "error-single-value-light",     "light-behind"};
    std::vector<std::string> arguments = {"check", "--write-reports", folder_.str()};
    arguments.insert(arguments.end(), names.begin(), names.end());
    ASSERT_EQ(run_program("twinlight", arguments).status, 0);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "light-behind.md"));  // the driver is right
    int compared = 0;
    for (const check::Case& of : check::load_cases({names.begin(), names.end() - 1})) {
        SCOPED_TRACE(of.name);
        const std::string report = read_file(folder_ / (of.name + ".md"));
        EXPECT_NE(report.find("Specification: OpenGL 2.1, section " + of.text), std::string::npos) << report;
        write_file_atomically(folder_ / (of.name + ".c"), program_in(report));
        const ProgramResult shown = in_folder(fmt::format(
            "{0} -std=c99 -Wall -Wextra -Wpedantic -Werror {1}.c -o {1} -lglut -lGL -lm && ./{1}", compiler_, of.name));
        ASSERT_EQ(shown.status, 0) << shown.err;
        const std::string gl = shown.out.substr(0, shown.out.find('\n')) + ", GLX";
        if (parse_driver_name(gl).version != current_driver().version) continue;
        for (const check::Differs& differs : of.differs) {
            if (!differs.is_of(gl)) continue;
            ++compared;
            if (const Enum* error = std::get_if<Enum>(&differs.value)) {
                EXPECT_NE(shown.out.find(fmt::format("glGetError: 0x{:04X}\n", *error)), std::string::npos)
                    << shown.out;
                continue;
            }
            const std::vector<double> values = values_after(shown.out, differs.spot.str());
            ASSERT_EQ(values.size(), 4u) << differs.spot.str() << ": " << shown.out;
            const glm::dvec4& listed = std::get<glm::dvec4>(differs.value);
            const double tolerance = of.tolerance.value_or(check::kTolerance) + (of.is_of_vertices() ? 0 : 0.5 / 255);
            for (int i = 0; i < 3; ++i)
                EXPECT_NEAR(values[static_cast<std::size_t>(i)], listed[i], tolerance) << shown.out;
        }
    }
    if (compared == 0) GTEST_SKIP() << "the window's GL is of another release than " << driver_name();
    EXPECT_GE(compared, 5);
}

// The reports by hand say what their programs print, on all measured releases.
TEST_F(CasePrograms, ReportsOfQueriesHaveAProgramThatShowsTheBug) {
    int run = 0;
    for (const auto& entry : std::filesystem::directory_iterator("docs/upstream")) {
        const std::string name = entry.path().stem();
        if (!name.starts_with("query-")) continue;
        SCOPED_TRACE(name);
        const std::string report = read_file(entry.path());
        write_file_atomically(folder_ / (name + ".c"), program_in(report));
        const ProgramResult shown = in_folder(fmt::format(
            "{0} -std=c99 -Wall -Wextra -Wpedantic -Werror {1}.c -o {1} -lglut -lGL && ./{1}", compiler_, name));
        ASSERT_EQ(shown.status, 0) << shown.err;
        if (shown.out.find("Mesa") == std::string::npos) GTEST_SKIP() << "not Mesa: " << shown.out;
        std::smatch row;
        ASSERT_TRUE(std::regex_search(report, row, std::regex("\n\\| (gl[^|]*) \\| ([^ ]+) \\| ([^ ]+) \\|\n")));
        EXPECT_NE(row[2], row[3]);
        EXPECT_NE(shown.out.find(fmt::format("\n{}: {}\n", row.str(1), row.str(2))), std::string::npos) << shown.out;
        ++run;
    }
    EXPECT_GT(run, 0);
}

// A crash is no wrong answer, and the cases after it still run.
TEST_F(CasePrograms, GoOnAfterACrash) {
    ASSERT_EQ(written({"light-behind", "vertex-w-2", "color-hdr"}).status, 0);
    std::filesystem::create_directory(folder_ / "build");
    write_file_atomically(
        folder_ / "build/all",
        "#!/bin/sh\n"
        "echo 'GL: a; b; c'\n"
        "case $* in\n"
        "*light-behind) echo 'vertex-w-2: wrong (pixel): \"<&\\'; echo 'color-hdr: crashed: signal 6' ;;\n"
        "*color-hdr) ;;\n"
        "*) echo 'light-behind: crashed: signal 11' ;;\n"
        "esac\n");
    const ProgramResult result =
        in_folder("chmod +x build/all && sh run.sh '' '' build/all > results.txt && sh report.sh results.txt");
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.out.find("3 cases: 0 right, 1 wrong, 0 open, 0 not run, 2 crashed\n"), std::string::npos)
        << result.out;
    const auto json = nlohmann::json::parse(read_file(folder_ / "report.json"));
    EXPECT_EQ(json.at("gl"), "a; b; c");
    EXPECT_EQ(json.at("cases").at(1).at("finding"), "\"<&\\");
    EXPECT_NE(read_file(folder_ / "report.html").find("\"&lt;&amp;\\"), std::string::npos);
}

}  // namespace
}  // namespace twinlight::case_programs_test
