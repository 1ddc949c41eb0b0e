// Whole programs, read without a compiler: the commands that we read are those that the compiled program calls.
//
// Each program of tests/homework is compiled and recorded by apitrace up to the end of its first picture. Three things are
// normalised, by a header that the compiler puts in front of the program:
// - The functions of GLU and the shapes of GLUT call GL themselves, as freeglut_shapes_test.cpp and glu_quadrics_test.cpp
//   check. Here each leaves its name and its arguments in the recording instead: glPassThrough has the number of its row
//   in commands.def, and a glMapGrid1d follows for each argument.
// - The program ends after its first picture: glutSwapBuffers ends it, and in a window with one buffer glFlush.
// - The calls of GLUT itself are left out: the window's first glViewport and glScissor, and its choice of the buffer to
//   draw to in a window with one buffer.
// And apitrace prints floats with 7 digits, doubles with 16, so ours are rounded to as many.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "../unit/compare_three_ways.h"
#include "../unit/run_program.h"
#include "base/image/file.h"
#include "judge/compare/comparison.h"
#include "judge/report/words.h"
#include "scene/command/memory.h"
#include "scene/command/text.h"
#include "scene/scenes/load.h"
#include "scene/state/state.h"
#include "xvfb.h"

namespace twinlight::homework_test {
namespace {

constexpr const char* kFolder = "tests/homework";

std::vector<std::string> programs() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(kFolder))
        if (entry.path().extension() == ".c") names.push_back(entry.path().stem());
    std::sort(names.begin(), names.end());
    return names;
}

std::string path_of(const std::string& program) { return fmt::format("{}/{}.c", kFolder, program); }

// Whether a library above GL carries the command out.
bool is_of_a_library(const Signature& sig) {
    return sig.family == Family::kShape || sig.family == Family::kQuadric || sig.name.starts_with("glu");
}

// A function of GLU or GLUT whose parameters are all numbers or quadrics.
bool can_be_marked(const Signature& sig) {
    return is_of_a_library(sig) && std::all_of(sig.parameters.begin(), sig.parameters.end(), [](const Parameter& p) {
               return p.extent == Extent::kValue || p.extent == Extent::kResult;
           });
}

// The header that the compiler puts in front of a program.
std::string header() {
    std::string text =
        "#include <GL/freeglut.h>\n"
        "#include <stdlib.h>\n"
        "static size_t quadrics;\n"
        "static void mark(int row, int count, const double* values) {\n"
        "    int i;\n"
        "    glPassThrough(row);\n"
        "    for (i = 0; i < count; ++i) glMapGrid1d(1, values[i], 0);\n"
        "}\n"
        "static void end_picture(void) { glFinish(); exit(0); }\n"
        "#define glutSwapBuffers() end_picture()\n"
        "#define glFlush() (glFlush(), end_picture())\n";
    for (std::size_t row = 0; row < signatures().size(); ++row) {
        const Signature& sig = signatures()[row];
        if (!can_be_marked(sig)) continue;
        std::string parameters, values;
        const bool has_result = sig.c_arguments() < sig.parameters.size();
        for (std::size_t i = 0; i < sig.c_arguments(); ++i) {
            const bool is_quadric = sig.parameters[i].kind == Kind::kQuadric;
            parameters += fmt::format("{}a{}", i == 0 ? "" : ", ", i);
            values +=
                fmt::format("(double)({})(a{}), ", is_quadric ? "size_t" : c_type_name(sig.parameters[i].kind), i);
        }
        const std::string call =
            has_result ? fmt::format("(mark({}, 1, (double[]){{(double)++quadrics}}), (GLUquadric*)quadrics)", row)
                       : fmt::format("mark({}, {}, (double[]){{{}0}})", row, sig.c_arguments(), values);
        text += fmt::format("#undef {0}\n#define {0}({1}) {2}\n", sig.name, parameters, call);
    }
    return text;
}

// Our commands with marks for those of GLU and GLUT, as the header leaves them.
std::vector<Command> with_marks(const std::vector<Command>& commands) {
    std::vector<Command> marked;
    for (const Command& command : commands) {
        if (!is_of_a_library(command.sig())) {
            marked.push_back(command);
            continue;
        }
        const auto row = static_cast<double>(&command.sig() - signatures().data());
        marked.push_back({CommandId::glPassThrough, {row}, command.place});
        for (const double value : command.arguments)
            marked.push_back({CommandId::glMapGrid1d, {1, value, 0}, command.place});
    }
    return marked;
}

// The command with its numbers as apitrace prints them.
Command as_printed(Command command) {
    for (std::size_t p = 0; p < command.sig().parameters.size(); ++p) {
        const std::size_t first = command.first(p), count = command.count(p);
        for (std::size_t i = first; i < first + count; ++i) {
            double& value = command.arguments[i];
            if (command.sig().parameters[p].kind == Kind::kFloat)
                value = static_cast<double>(std::strtof(fmt::format("{:.7g}", value).c_str(), nullptr));
            else if (command.sig().parameters[p].kind == Kind::kDouble)
                value = std::strtod(fmt::format("{:.16g}", value).c_str(), nullptr);
        }
    }
    return command;
}

// Our commands with the driver's names of display lists: glGenLists may return any unused names (5.4; Mesa 22.3 starts at 1,
// Mesa 25.0 elsewhere).
std::vector<Command> with_names_of(const std::vector<Command>& theirs, std::vector<Command> ours) {
    std::map<double, double> names;
    for (std::size_t i = 0; i < std::min(ours.size(), theirs.size()); ++i) {
        Command& command = ours[i];
        if (command.id == CommandId::glGenLists && theirs[i].id == command.id) {
            for (double k = 0; k < command.number(0); ++k) names[command.number(1) + k] = theirs[i].number(1) + k;
            command.arguments[1] = theirs[i].number(1);
        } else if (command.id == CommandId::glNewList || command.id == CommandId::glCallList ||
                   command.id == CommandId::glDeleteLists) {
            const auto name = names.find(command.number(0));
            if (name != names.end()) command.arguments[0] = name->second;
        }
    }
    return ours;
}

// The program's own commands in a recording.
std::vector<Command> commands_of(const Recording& recording) {
    std::vector<Command> commands;
    recording.for_each([&](const Step& step) {
        if (step.kind == Step::Kind::kCommand) commands.push_back(step.command);
        return true;
    });
    // What GLUT calls when the window opens.
    std::size_t first = 0;
    while (first < commands.size() &&
           (commands[first].id == CommandId::glViewport || commands[first].id == CommandId::glScissor ||
            commands[first].id == CommandId::glDrawBuffer || commands[first].id == CommandId::glReadBuffer))
        ++first;
    commands.erase(commands.begin(), commands.begin() + static_cast<std::ptrdiff_t>(first));
    if (!commands.empty() && commands.back().id == CommandId::glFinish) commands.pop_back();  // by end_picture
    return commands;
}

class Homework : public testing::TestWithParam<std::string> {};

TEST_P(Homework, ReadsAsTheCommandsThatTheCompiledProgramCalls) {
    const std::string compiler = "${CC:-gcc}";
    if (run_shell("", "command -v " + compiler).status != 0) GTEST_SKIP() << "there is no C compiler";
    if (run_shell("", "command -v apitrace").status != 0) GTEST_SKIP() << "apitrace is not installed";
    const Xvfb server("1024x768x24");
    if (!server.running()) GTEST_SKIP() << server.reason();

    const TemporaryFolder folder;
    write_file_atomically(folder / "marks.h", header());
    const ProgramResult compiled = run_shell(
        "", fmt::format("{} -std=gnu99 -O0 -ffp-contract=off -include {} {} -o {} -lglut -lGLU -lGL -lm", compiler,
                        quoted(folder / "marks.h"), path_of(GetParam()), quoted(folder / "program")));
    ASSERT_EQ(compiled.status, 0) << compiled.err;
    const ProgramResult recorded = run_shell(
        "", fmt::format("DISPLAY={} LIBGL_ALWAYS_SOFTWARE=1 timeout 60 apitrace trace --api=gl --output={} {}",
                        server.display(), quoted(folder / "program.trace"), quoted(folder / "program")));
    ASSERT_EQ(recorded.status, 0) << recorded.err;

    const std::vector<Command> theirs = commands_of(*load_recording(folder / "program.trace"));
    const std::vector<Command> ours = with_names_of(theirs, with_marks(load_commands(path_of(GetParam()))->commands));
    ASSERT_GT(ours.size(), 10U);
    for (std::size_t i = 0; i < std::min(ours.size(), theirs.size()); ++i) {
        const Command printed = as_printed(ours[i]);
        ASSERT_EQ(print_command(printed), print_command(theirs[i]))
            << "command " << i << ", ours from " << ours[i].place.str();
        ASSERT_EQ(printed, theirs[i]) << print_command(printed);
    }
    EXPECT_EQ(ours.size(), theirs.size());
}

TEST_P(Homework, LooksAlikeThreeWays) {
    auto commands = load_commands(path_of(GetParam()));
    ASSERT_TRUE(commands->window);
    Frame frame = make_frame(*commands, {.width = commands->window->width, .height = commands->window->height});
    const Scene scene{commands, std::move(frame)};
    const compare::Comparison comparison = compare_three_ways(scene);
    EXPECT_EQ(comparison.verdict(), compare::Verdict::kWithin);
    for (const compare::Pair& pair : comparison.pairs)
        EXPECT_NE(pair.verdict, compare::Verdict::kBeyond) << report::name_of(comparison, pair);
    for (const compare::Render& render : comparison.renders) {
        const Rgba corner = render.image.pixels.front();
        const auto drawn = std::count_if(render.image.pixels.begin(), render.image.pixels.end(),
                                         [&](const Rgba& pixel) { return pixel != corner; });
        EXPECT_GT(drawn, static_cast<std::ptrdiff_t>(render.image.pixels.size() / 50)) << render.name;
    }
}

INSTANTIATE_TEST_SUITE_P(Programs, Homework, testing::ValuesIn(programs()),
                         [](const testing::TestParamInfo<std::string>& program) { return program.param; });

TEST(HomeworkFolder, HasFifteenProgramsOfAtMost300Lines) {
    EXPECT_EQ(programs().size(), 15U);
    for (const std::string& program : programs()) {
        const std::string text = read_file(path_of(program));
        EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 300) << program;
    }
}

}  // namespace
}  // namespace twinlight::homework_test
