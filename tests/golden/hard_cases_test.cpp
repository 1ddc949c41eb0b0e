// The hard cases of golden/hard: every renderer runs each of them, and the fixed function shows exactly the listed
// bugs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>

#include "../unit/run_program.h"
#include "../unit/sanitized.h"
#include "judge/check/suite.h"
#include "judge/compare/departures.h"
#include "judge/compare/vertex_colors.h"
#include "render/context/driver_name.h"
#include "render/reference/reference.h"
#include "render/reference/vertices/lit_vertices.h"
#include "scene/command/text.h"
#include "scene/state/state.h"

namespace twinlight::check::hard_cases_test {

namespace {

std::string words_of(const std::vector<Finding>& findings) {
    std::string text;
    for (const Finding& finding : findings)
        text += std::string(kPathNames.at(static_cast<std::size_t>(finding.path))) + " " + finding.variant + ", " +
                finding.spot.str() + ": " + text_of(finding.value) + ", expected " + text_of(finding.expected) + " (" +
                std::string(word_of(finding.outcome)) + ")\n";
    return text;
}

TEST(HardCases, AreAnsweredAsExpectedAndDepartedFromAsListed) {
    const std::vector<Case> cases = load_cases();
    EXPECT_GE(cases.size(), 240u);  // all files are embedded
    Suite suite;
    const bool is_measured = compare::is_measured(current_driver());
    const std::vector<Result> results = suite.run(cases);
    for (std::size_t i = 0; i < cases.size(); ++i) {
        SCOPED_TRACE(cases[i].name + "\n" + words_of(results[i].findings));
        EXPECT_EQ(results[i].error, "");
        EXPECT_EQ(results[i].non_finite, 0);
        EXPECT_LE(results[i].from_long_double, 3e-5);  // also where the case has a larger tolerance
        // Shaders show the bugs of the rasteriser, too.
        const Outcome of_shaders = results[i].outcomes[static_cast<std::size_t>(Path::kProgrammable)];
        EXPECT_TRUE(of_shaders == Outcome::kPass ||
                    (of_shaders == Outcome::kKnownBug && results[i].outcomes[0] == Outcome::kKnownBug));
        EXPECT_EQ(results[i].outcomes[static_cast<std::size_t>(Path::kReference)], Outcome::kPass);
        // The bugs of other drivers are not listed, and other releases may have fixed some.
        EXPECT_TRUE(!is_measured || !is_failure(results[i].outcomes[0]));
    }
}

// Every case in every number type, without a driver.
TEST(HardCasesOfTheReference, AreFinite) {
    for (const Case& of : load_cases()) {
        SCOPED_TRACE(of.name);
        const Frame frame = of.carried_out(kSide).scene.frame;
        for (const Number number : {Number::kFloat, Number::kDouble, Number::kLongDouble}) {
            reference::Options options{compare::kGlsOwnModel};
            options.arithmetic.number = number;
            for (const auto& item : frame.items) {
                const Draw* draw = std::get_if<Draw>(&item);
                if (!draw) continue;
                for (const reference::LitVertex& v : reference::light_vertices(*draw, options, false))
                    for (const glm::dvec4& color :
                         {v.front_primary, v.front_secondary, v.back_primary, v.back_secondary})
                        for (int i = 0; i < 4; ++i) EXPECT_TRUE(std::isfinite(color[i]));
            }
            const Image image = reference::render(frame, options);
            EXPECT_TRUE(std::ranges::all_of(image.pixels, [](const Rgba& pixel) {
                return std::ranges::all_of(pixel, [](auto channel) { return std::isfinite(channel); });
            }));
        }
    }
}

TEST(HardCasesOfTheReference, AreCleanUnderValgrind) {
    if (kSanitized) GTEST_SKIP() << "valgrind and the address sanitizer do not go together";
    if (run_shell("", "command -v valgrind").status != 0) GTEST_SKIP() << "valgrind is not installed";
    const ProgramResult result = run_shell("twinlight-tests",
                                           "valgrind --quiet --suppressions=tests/valgrind.supp --error-exitcode=9 "
                                           "--leak-check=full --errors-for-leak-kinds=definite \"$PROGRAM\" "
                                           "--gtest_filter=HardCasesOfTheReference.AreFinite");
    EXPECT_EQ(result.status, 0) << result.out << result.err;
    EXPECT_NE(result.out.find("[  PASSED  ] 1 test"), std::string::npos) << result.out;
}

// A new process, because a process chooses its driver with its first context.
TEST(HardCases, HoldOnSoftpipe) {
    ASSERT_EQ(::setenv("GALLIUM_DRIVER", "softpipe", 1), 0);
    const ProgramResult result = run_program("twinlight", {"check"});
    ::unsetenv("GALLIUM_DRIVER");
    ASSERT_LE(result.status, 1) << result.err;
    if (!compare::is_measured(parse_driver_name(result.out.substr(0, result.out.find('\n')))))
        GTEST_SKIP() << "this release was not measured";
    EXPECT_EQ(result.status, 0) << result.out;
}

TEST(HardCases, NameDeparturesOfTheList) {
    std::set<std::string> listed;
    std::ifstream file("golden/known_differences");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with('[')) listed.insert(line.substr(1, line.size() - 2));
    for (const Case& of : load_cases())
        for (const Differs& differs : of.differs)
            EXPECT_TRUE(listed.contains(differs.name)) << of.name << ": " << differs.name;
}

// ---- What the suite reports ----

// A case of a point that emits 0.5; `expectation` follows the first five lines of its head.
std::string small_case(const std::string& expectation) {
    return "// what: w\n// why: w\n// text: 2.14.1\n// status: defined\n// derived: d\n" + expectation +
           "glMatrixMode(GL_PROJECTION); glTranslatef(-0.75, -0.75, 0); glMatrixMode(GL_MODELVIEW);\n"
           "GLfloat ambient[] = {0, 0, 0, 1}, emission[] = {0.5, 0.5, 0.5, 1};\n"
           "glLightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient); glMaterialfv(GL_FRONT, GL_EMISSION, emission);\n"
           "glEnable(GL_LIGHTING); glBegin(GL_POINTS); glVertex3f(0, 0, 0); glEnd();\n";
}

Result result_of(const std::string& expectation) {
    const std::vector<Case> cases = {read_case(small_case(expectation), "small.gl", "small")};
    return Suite().run(cases).front();
}

TEST(HardCases, FailWhereAnyRendererGivesSomethingElse) {
    EXPECT_FALSE(result_of("// expect: vertex 0: 0.5 0.5 0.5 1\n").fails());
    const Result wrong = result_of("// expect: vertex 0: 0.5 0.50004 0.5 1\n");
    for (const Outcome outcome : wrong.outcomes) EXPECT_EQ(outcome, Outcome::kNewBug);
}

TEST(HardCases, FailWhereAListedDepartureIsGone) {
    const Result gone = result_of("// expect: vertex 0: 0.5 0.5 0.5 1\n// differs: *: vertex 0: 0 0 0 1; some name\n");
    EXPECT_EQ(gone.outcomes[0], Outcome::kFixedBug);
    EXPECT_TRUE(gone.fails());
    const Result elsewhere =
        result_of("// expect: vertex 0: 0.5 0.5 0.5 1\n// differs: another driver: vertex 0: 0 0 0 1; some name\n");
    EXPECT_EQ(elsewhere.outcomes[0], Outcome::kPass);
}

TEST(HardCases, ListADepartureThatShowsAtTimes) {
    const Differs differs{
        .driver = "llvmpipe*Mesa|softpipe*Mesa before 25.0 at times", .spot = {}, .value = {}, .name = ""};
    EXPECT_TRUE(differs.is_of("softpipe, 3.3 Mesa 22.3.6, EGL"));
    EXPECT_TRUE(differs.is_at_times("softpipe, 3.3 Mesa 22.3.6, EGL"));
    EXPECT_FALSE(differs.is_at_times("softpipe, 3.3 Mesa 26.1.6, EGL"));
    EXPECT_FALSE(differs.is_at_times("llvmpipe, 4.5 Mesa 22.3.6, EGL"));
    const char* const right =
        "// expect: vertex 0: 0.5 0.5 0.5 1\n// differs: * at times: vertex 0: 0 0 0 1; some name\n";
    EXPECT_EQ(result_of(right).outcomes[0], Outcome::kPass);
    const char* const wrong = "// expect: vertex 0: 1 1 1 1\n// differs: * at times: vertex 0: 0 0 0 1; some name\n";
    EXPECT_EQ(result_of(wrong).outcomes[0], Outcome::kNewBug);
    const char* const known =
        "// expect: vertex 0: 1 1 1 1\n// differs: * at times: vertex 0: 0.5 0.5 0.5 1; some name\n";
    EXPECT_EQ(result_of(known).outcomes[0], Outcome::kKnownBug);
}

TEST(HardCases, ListADepartureForSeveralDrivers) {
    const Differs differs{.driver = "llvmpipe*Mesa 22.3|Mesa 25.0", .spot = {}, .value = {}, .name = "some name"};
    for (const char* driver : {"llvmpipe (LLVM 15.0.6), 4.5 Mesa 22.3.6, OSMesa", "softpipe, 3.3 Mesa 25.0.7, OSMesa"})
        EXPECT_TRUE(differs.is_of(driver)) << driver;
    for (const char* driver : {"softpipe, 3.3 Mesa 22.3.6, OSMesa", "llvmpipe, 4.5 Mesa 24.0.5, OSMesa"})
        EXPECT_FALSE(differs.is_of(driver)) << driver;
}

TEST(HardCases, ListADepartureForARangeOfReleases) {
    const auto is_of = [](const char* drivers, const std::string& version) {
        return Differs{.driver = drivers, .spot = {}, .value = {}, .name = {}}.is_of("llvmpipe, 4.5 " + version +
                                                                                     ", EGL");
    };
    for (const char* version : {"Mesa 22.3.6", "Mesa 25.0.7", "Mesa 27.0.0"})
        EXPECT_TRUE(is_of("llvmpipe*Mesa", version));
    struct Row {
        const char* drivers;
        std::vector<const char*> in, out;
    };
    for (const Row& row : {
             Row{"Mesa before 25.0", {"Mesa 22.3.6", "Mesa 24.3.4"}, {"Mesa 25.0.0", "Mesa 26.1.6", "NVIDIA 20.1"}},
             Row{"Mesa from 25.0",
                 {"Mesa 25.0.0-devel", "Mesa 26.1.6", "Mesa 100.0.0"},
                 {"Mesa 24.3.4", "NVIDIA 580.1"}},
             Row{"llvmpipe*Mesa from 25.0 before 25.0.7", {"Mesa 25.0.6"}, {"Mesa 24.3.4", "Mesa 25.0.7"}},
             Row{"softpipe|Mesa before 24|NVIDIA", {"Mesa 22.3.6", "NVIDIA 580.159.04"}, {"Mesa 24.0.0", "AMD 20.1"}},
             Row{"softpipe", {}, {"Mesa 25.0.7"}},
         }) {
        for (const char* version : row.in) EXPECT_TRUE(is_of(row.drivers, version)) << row.drivers << ": " << version;
        for (const char* version : row.out) EXPECT_FALSE(is_of(row.drivers, version)) << row.drivers << ": " << version;
    }
}

// Only what is listed for a range was measured on another release.
TEST(HardCases, SayWhichReleaseWasMeasured) {
    const auto note = [](const char* drivers, const char* driver) {
        return Differs{.driver = drivers, .spot = {}, .value = {}, .name = {}}.note(driver);
    };
    const char* const newer = "llvmpipe, 4.5 Mesa 99.1.0, EGL";
    const std::string expected =
        fmt::format("measured on {}; this is 99.1.0", compare::counts_as(parse_driver_name(newer)));
    for (const char* drivers : {"Mesa", "llvmpipe*Mesa from 22.3", "Mesa 22.3|Mesa from 25.0"})
        EXPECT_EQ(note(drivers, newer), expected) << drivers;
    for (const char* drivers : {"*", "Mesa 99.1", "softpipe"}) EXPECT_EQ(note(drivers, newer), "") << drivers;
    EXPECT_EQ(note("Mesa", "llvmpipe, 4.5 Mesa 22.3.6, OSMesa"), "");
    EXPECT_EQ(note("a driver", "a driver, 4.6, EGL"), "");
}

TEST(HardCases, AreWordedForAReleaseThatWasNotMeasured) {
    const std::vector<Case> cases = {
        read_case(small_case("// expect: vertex 0: 0.5 0.5 0.5 1\n"), "small.gl", "small")};
    Finding finding{.path = Path::kFixed,
                    .variant = "",
                    .outcome = Outcome::kKnownBug,
                    .spot = {},
                    .value = Seen(glm::dvec4(0)),
                    .expected = glm::dvec4(1),
                    .name = "some name",
                    .note = "measured on Mesa 26.1; this is 26.2.0"};
    EXPECT_EQ(
        finding_text(cases[0], finding),
        "fixed, vertex 0: (0, 0, 0, 0), expected (1, 1, 1, 1) (known bug (measured on Mesa 26.1; this is 26.2.0): "
        "some name)");
    finding.outcome = Outcome::kFixedBug;
    EXPECT_EQ(
        finding_text(cases[0], finding),
        "fixed, vertex 0: (0, 0, 0, 0), as expected; the known bug (measured on Mesa 26.1; this is 26.2.0) is gone: "
        "some name");
    finding.note.clear();
    EXPECT_EQ(finding_text(cases[0], finding),
              "fixed, vertex 0: (0, 0, 0, 0), as expected; the known bug is gone: some name");
}

TEST(HardCases, FailWhereADepartureIsAnotherThanListedOrInNoList) {
    for (const char* differs : {"", "// differs: *: vertex 0: 0.25 0.5 0.5 1; some name\n"}) {
        const Result result = result_of(std::string("// expect: vertex 0: 0 0.5 0.5 1\n") + differs);
        EXPECT_EQ(result.outcomes[0], Outcome::kNewBug) << differs;
        EXPECT_TRUE(result.fails());
    }
    const Result listed =
        result_of("// expect: vertex 0: 0 0.5 0.5 1\n// differs: *: vertex 0: 0.5 0.5 0.5 1; some name\n");
    EXPECT_EQ(listed.outcomes[0], Outcome::kKnownBug);
}

TEST(HardCases, FailFarFromLongDouble) {
    Result result;
    result.from_long_double = 2.9e-5;
    EXPECT_FALSE(result.fails());
    result.from_long_double = 3.1e-5;
    EXPECT_TRUE(result.fails());
}

// A command with an error changes nothing (2.5). The driver and Twinlight must both raise the expected error.
TEST(HardCases, ExpectErrors) {
    const auto with = [](const std::string& error) {
        const std::vector<Case> cases = {read_case(small_case("// expect: vertex 0: 0.5 0.5 0.5 1\n// expect: error: " +
                                                              error + "\nglShadeModel(GL_LINES);\n"),
                                                   "small.gl", "small")};
        return Suite().run(cases).front();
    };
    EXPECT_FALSE(with("GL_INVALID_ENUM").fails());
    const Result wrong = with("GL_INVALID_VALUE");
    EXPECT_EQ(wrong.outcomes, (std::array{Outcome::kNewBug, Outcome::kPass, Outcome::kNewBug}));
    for (const Finding& finding : wrong.findings) EXPECT_EQ(text_of(finding.value), "GL_INVALID_ENUM");
}

// In a display list only the command that raises the error is ignored.
TEST(HardCases, CarryOutAListButForItsErrors) {
    const std::string list =
        "glNewList(1, GL_COMPILE); glShadeModel(GL_LINES);\n"
        "glMaterialfv(GL_FRONT, GL_EMISSION, (GLfloat[]){0.25, 0.5, 0.75, 1}); glEndList();\n";
    std::string text = small_case("// expect: vertex 0: 0.25 0.5 0.75 1\n// expect: error: GL_INVALID_ENUM\n" + list);
    text.insert(text.find("glEnable(GL_LIGHTING)"), "glCallList(1); ");
    EXPECT_EQ(words_of(Suite().run(std::vector{read_case(text, "small.gl", "small")}).front().findings), "");
}

// A driver that lacks a feature of the scene raises an error. It fails the case, also where the specification is
// silent.
TEST(HardCases, FailWhereADriverRaisesAnErrorUnasked) {
    const TemporaryFolder folder;
    std::string text = small_case("// expect: vertex 0: 0.5 0.5 0.5 1\n");
    text.insert(text.find("glEnable(GL_LIGHTING)"),
                "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);\n");
    write_file_atomically(folder / "defined.gl", text);
    text.replace(text.find("defined"), 7, "ruling");
    write_file_atomically(folder / "ruling.gl", text);
    for (const char* name : {"defined.gl", "ruling.gl"}) {
        const std::string check = "\"$PROGRAM\" check " + quoted(folder / name);
        EXPECT_EQ(run_shell("twinlight", check).status, 0);
        const ProgramResult lacking =
            run_shell("twinlight", "MESA_EXTENSION_OVERRIDE=-GL_ARB_texture_border_clamp " + check);
        EXPECT_EQ(lacking.status, 1) << lacking.out << lacking.err;
        EXPECT_NE(lacking.out.find("fixed, error: GL_INVALID_ENUM, expected GL_NO_ERROR"), std::string::npos)
            << lacking.out;
    }
}

// The suite itself calls glClampColor to read colours beyond [0, 1]; a driver may lack it.
TEST(HardCases, ChargeTheSceneAlone) {
    const ProgramResult lacking =
        run_shell("twinlight",
                  "MESA_EXTENSION_OVERRIDE=-GL_ARB_color_buffer_float MESA_GL_VERSION_OVERRIDE=2.1 "
                  "\"$PROGRAM\" check error-cutoff-91");
    EXPECT_EQ(lacking.status, 0) << lacking.out << lacking.err;
}

TEST(HardCases, HoldAListedDepartureToItsCasesTolerance) {
    const Result listed = result_of(
        "// tolerance: 1e-3, for a test\n// expect: vertex 0: 0 0.5 0.5 1\n"
        "// differs: *: vertex 0: 0.5005 0.5 0.5 1; some name\n");
    EXPECT_EQ(listed.outcomes[0], Outcome::kKnownBug);
}

TEST(HardCases, HoldLongDoubleToTheFirstOfTwoAnswers) {
    EXPECT_FALSE(result_of("// expect: vertex 0: 0.5|0 0.5 0.5 1\n").fails());
    const Result second = result_of("// expect: vertex 0: 0|0.5 0.5 0.5 1\n");
    EXPECT_EQ(second.outcomes, (std::array{Outcome::kPass, Outcome::kPass, Outcome::kNewBug}));
    ASSERT_EQ(second.findings.size(), 2u);
    EXPECT_EQ(second.findings[0].variant, "long double");
    EXPECT_EQ(second.findings[1].variant, "60 digits");  // the oracle's
}

TEST(HardCases, DoNotAskTheFixedFunctionOfVariants) {
    const std::vector<Case> cases = {
        read_case(small_case("// expect: vertex 0: 0.5 0.5 0.5 1\n#pragma twinlight specular(reflection)\n"),
                  "small.gl", "small")};
    const Result result = Suite().run(cases).front();
    EXPECT_EQ(result.outcomes, (std::array{Outcome::kNotTested, Outcome::kPass, Outcome::kPass}));
    EXPECT_FALSE(result.fails());
}

TEST(HardCases, AreRefusedWithTheLineWhereTheHeadIsWrong) {
    const auto refusal = [](const std::string& lines) -> std::string {
        try {
            read_case(small_case(lines), "small.gl", "small");
        } catch (const SceneError& refused) {
            return refused.what();
        }
        return "";
    };
    const std::string expectation = "// expect: vertex 0: 0 0 0 1\n";
    EXPECT_EQ(refusal(expectation), "");
    EXPECT_NO_THROW(read_case("\xEF\xBB\xBF" + small_case(expectation), "", ""));
    EXPECT_NE(refusal("").find("lacks 'expect'"), std::string::npos);
    const std::pair<const char*, const char*> wrong[] = {
        {"// expects: vertex 0: 0 0 0 1\n", "no key 'expects'"},
        {"// expect: vertex 7: 0 0 0 1\n", "is not a place"},
        {"// expect: pixel 64,0: 0 0 0 1\n", "from 0 to 63"},
        {"// expect: pixel 99999999999,0: 0 0 0 1\n", "from 0 to 63"},
        {"// expect: pixel -1,0: 0 0 0 1\n", "from 0 to 63"},
        {"// expect: pixel 1,1 flat: 0 0 0 1\n", "from 0 to 63"},
        {"// expect: pixel 1,1 phong exact: 0 0 0 1\n", "from 0 to 63"},
        {"// expect: vertex 0: 0|1|2 0 0 1\n", "not a list of numbers"},
        {"// expect: vertex 0: nan 0 0 1\n", "is not finite"},
        {"// expect: vertex 0: 0 0 1e999 1\n", "is not finite"},
        {"// expect:\n", "is empty"},
        {"// tolerance: -1, none\n", "at least 0"},
        {"// tolerance: inf, all\n", "is not finite"},
        {"// expect: error: GL_INVALID_VALUE\n", "must expect a colour"},
        {"// status: ruling\n", "is given twice"},
        {"// expect: vertex 0: 0 0 1\n", "must be 4 numbers"},
        {"// expect: vertex 0: 0 0 0 one\n", "not a list of numbers"},
        {"// tolerance: 1e-3\n", "lacks a ','"},
        {"// differs: Mesa: vertex 0: 0 0 0 1\n", "lacks a ';'"},
        {"// differs: Mesa before soon: vertex 0: 0 0 0 1; name\n", "such as 25.0, after 'before'"},
        {"// differs: NVIDIA|Mesa from v25: vertex 0: 0 0 0 1; name\n", "such as 25.0, after 'from'"},
        {"// expect: error: GL_INVALID\n", "not the name of an OpenGL error"},
        {"// expect: error: GL_NO_ERROR|GL_INVALID_ENUM\n", "names two errors"},
        {"// what: again\n", "is given twice"},
        {"//what\n", "a line of the head must be"},
        {"// tolerance: 1, \x1b[2J\n", "control character"},
    };
    for (const auto& [line, why] : wrong) {
        const std::string told = refusal(line);
        EXPECT_TRUE(told.starts_with("small.gl:6:") && told.find(why) != std::string::npos) << line << told;
    }
    const std::pair<const char*, const char*> wrong_beside[] = {
        {"// expect: pixel 1,1: 0 0 0 1\n", "not of both"},
        {"// expect: vertex 0: 1 0 0 1\n", "expected twice"},
        {"// differs: Mesa: vertex 1: 0 0 0 1; name\n", "but no 'expect' does"},
    };
    for (const auto& [line, why] : wrong_beside) {
        const std::string told = refusal(expectation + line);
        EXPECT_TRUE(told.starts_with("small.gl:7:") && told.find(why) != std::string::npos) << line << told;
    }
}

// A regular expression of the standard library took a megabyte of stack for each of these.
TEST(HardCases, AreReadWhateverTheLengthOfALine) {
    const std::string long_word(500'000, '1');
    const Case of = read_case(
        small_case("// expect: vertex 0: 0.5|0." + long_word + " 0.5 0.5 1\n// tolerance: 1, " + long_word + "\n"), "",
        "");
    EXPECT_EQ(of.tolerance_causes, long_word);
}

}  // namespace

}  // namespace twinlight::check::hard_cases_test
