// Runs the command lines of README and of every page in docs/, as a reader would: each page in a folder of its own, from top to bottom.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "../unit/effort.h"
#include "../unit/run_program.h"
#include "../window/xvfb.h"
#include "base/image/file.h"
#include "documents.h"

namespace twinlight::commands_test {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> split(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> words;
    for (std::string word; in >> word;) words.push_back(word);
    return words;
}

bool has(const std::string& text, const char* pattern) { return std::regex_search(text, std::regex(pattern)); }

// Words for which a reader writes his own.
std::string with_examples(std::string line) {
    line = std::regex_replace(line, std::regex(R"(\[[^\]]*\])"), "");  // what may be left out
    line = std::regex_replace(line, std::regex(R"(\bSCENE\b)"), "report");
    line = std::regex_replace(line, std::regex(R"(\bDIR\b)"), "folder");
    // The explanation after a usage line: two blanks, and then words.
    return std::regex_replace(line, std::regex(R"(   +.*)"), "");
}

// make is not run from here, since it builds and runs these tests. Its goals and variables must exist.
std::string complaint_of_make(const std::string& line) {
    static const std::string makefile =
        read_file("Makefile") + read_file("tools/install/install.mk") + read_file("src/app/web/web.mk");
    static const std::set<std::string> kUsual = {"CXX", "CXXFLAGS", "LDFLAGS", "DESTDIR"};
    bool after_make = false;
    for (const std::string& word : split(line)) {
        const std::size_t equals = word.find('=');
        if (word == "make" || word == "sudo" || word.starts_with('-')) {
            after_make = after_make || word == "make";
        } else if (word == "&&") {
            after_make = false;
        } else if (equals != std::string::npos) {
            const std::string name = word.substr(0, equals);
            const bool is_known = kUsual.contains(name) || makefile.find("$(" + name + ")") != std::string::npos ||
                                  makefile.find("," + name + ")") != std::string::npos;
            if (after_make && !is_known) return "the Makefile has no variable " + name;
        } else if (after_make && makefile.find("\n" + word + ":") == std::string::npos) {
            return "the Makefile has no goal " + word;
        }
        if (word.find('\'') != std::string::npos) return "";  // a value with blanks: TEST='...'
    }
    return "";
}

// Lines that a test cannot run. Each is tried elsewhere.
std::optional<std::string> complaint_of_others(const std::string& line) {
    if (has(line, R"(^(sudo )?([A-Z_]+=\S* )*make\b)"))
        return complaint_of_make(std::regex_replace(line, std::regex("^sudo "), ""));
    if (has(line, "^(sudo )?apt-get |^git clone|^man ")) return "";
    if (line.starts_with("tools/in-clean-root.sh")) {  // CI runs it; here its options must exist
        const std::string help = run_shell("", "tools/in-clean-root.sh --help").out;
        for (const std::string& word : split(line.substr(0, line.find('\''))))
            if (word.starts_with("--") && help.find("\n" + word + " ") == std::string::npos) return "no option " + word;
        return "";
    }
    std::smatch fuzzer;
    if (std::regex_match(line, fuzzer,
                         std::regex(R"(build/fuzz/([a-z]+)-fuzzer .*)")))  // make fuzz builds it, with clang
        return fs::exists("tests/fuzz/" + fuzzer.str(1) + "_fuzzer.cpp") ? "" : "there is no such fuzzer";
    if (has(line, R"(\blamp\.c\b)")) return "";  // ExportedGlsl.PortsTheProgramOfTheDocs runs these in order
    if (line.find("valgrind ") != std::string::npos) return "";  // takes minutes; HardCasesOfTheReference runs valgrind
    return std::nullopt;
}

// Takes long, and is not shorter with smaller numbers.
bool is_long(const std::string& line) {
    return has(line, R"(twinlight check( --json| --html .*| --write-(cases|reports) .*)?$|twinlight lint --rules)") ||
           (has(line, R"(twinlight study )") && !has(line, "--quick|--merge"));
}

// The same with less work.
std::string shortened(std::string line, int study_s = tries_all() ? 2 : 1) {
    const int scenes = tries_all() ? 200 : 50;
    line = std::regex_replace(line, std::regex("--count \\d{3,}"), fmt::format("--count {}", scenes));
    // Ctrl-C ends a study, which keeps what it measured.
    if (has(line, "twinlight study ") && !has(line, "--merge"))
        line = fmt::format("timeout --preserve-status -s INT {} ", study_s) + line;
    // A window stays open until somebody closes it.
    if (has(line, R"(^(\S+/)?twinlight-demo\b)") && !has(line, "--quit-after"))
        line = "timeout 60 " + line + " --quit-after 2 --screenshot window.png";
    // So does a reader's own program.
    static const std::regex program(R"((^|&& )(\./))");
    if (std::regex_search(line, program))
        line = std::regex_replace(line, program, "$1timeout 3 $2") + "; status=$?; [ $status = 124 ] || exit $status";
    if (has(line, "twinlight record ") && !has(line, "--seconds"))
        line = std::regex_replace(line, std::regex("twinlight record"), "twinlight record --seconds 1 --frames 32");
    return line;
}

// For a line about a scene file whose text the page does not show.
constexpr const char* kScene = R"(
glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
glMatrixMode(GL_PROJECTION); gluPerspective(45, 4.0 / 3.0, 1, 10);
glMatrixMode(GL_MODELVIEW); gluLookAt(0, 0, 5,  0, 0, 0,  0, 1, 0);
glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){2, 3, 4, 1});
glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glEnable(GL_DEPTH_TEST);
glutSolidSphere(1, 32, 16);
)";

// A folder with what a reader has after git clone and make.
class ReadersFolder {
  public:
    ReadersFolder() {
        for (const std::string& name : kCloned) fs::copy(name, folder_ / name, fs::copy_options::recursive);
        fs::create_directory_symlink(fs::absolute(build_folder()), folder_ / "build");
    }
    std::string operator/(const std::string& name) const { return folder_ / name; }

    // Removes what a page's lines wrote, so that each page begins with the same folder.
    void clean() {
        for (const std::string& name : folder_.names())
            if (std::ranges::find(kCloned, name) == kCloned.end() && name != "build" && folder_ / name != program_ &&
                folder_ / name != trace_)
                fs::remove_all(folder_ / name);
    }

    // Makes the files that the line reads and that no line before it wrote. `scene` is the text of a scene that the page has shown.
    void provide(const std::string& line, const std::string& scene, const std::string& folder) {
        const std::vector<std::string> words = split(line);
        for (std::size_t i = 1; i < words.size(); ++i) {
            const std::string& word = words[i];
            const std::string path = (fs::path(folder) / word).lexically_normal();
            if (words[i - 1] == "-o" || word.find_first_of("'\"$*") != std::string::npos || fs::exists(folder_ / path))
                continue;
            if (!fs::exists(fs::path(folder_ / path).parent_path()) && !word.ends_with("/study.json")) continue;
            const std::string extension = fs::path(word).extension();
            if (word.starts_with("./")) {
                provide_program();
                fs::copy(program_, folder_ / path);
            } else if (extension == ".gl") {
                write_file_atomically(folder_ / path, scene.empty() ? kScene : scene);
            } else if (extension == ".c" && word.find('/') == std::string::npos) {
                fs::copy("tests/homework/lit_sphere.c", folder_ / path);
            } else if (extension == ".trace") {
                if (trace_.empty()) {
                    provide_program();
                    trace_ = folder_ / "recorded.trace";
                    const ProgramResult recorded = run_program(
                        "twinlight", {"record", "--seconds", "2", "--frames", "32", "-o", trace_, program_});
                    EXPECT_EQ(recorded.status, 0) << recorded.err;
                }
                fs::copy(trace_, folder_ / path);
            } else if (word == "answers") {  // of a class of one
                fs::create_directories(folder_ / "answers/ann");
                fs::copy("tests/lessons/shininess/right-1.gl", folder_ / "answers/ann/shininess.gl");
            } else if (word.ends_with("/study.json")) {
                const std::string study = fs::path(folder_ / path).parent_path();
                const ProgramResult measured = run_program(
                    "twinlight", {"study", "report", "--quick", "--seconds", "0", "--size", "40x30", "-o", study});
                EXPECT_EQ(measured.status, 0) << measured.err;
            }
        }
    }

  private:
    static inline const std::vector<std::string> kCloned = {"docs",  "golden",   "src",      "tests",
                                                            "tools", "Makefile", "README.md"};

    void provide_program() {
        if (!program_.empty()) return;
        program_ = folder_ / "animated-program";
        const ProgramResult compiled = run_shell(
            "",
            fmt::format("cc -o {} tests/homework/solar_system.c -lglut -lGLU -lGL -lm", twinlight::quoted(program_)));
        EXPECT_EQ(compiled.status, 0) << compiled.err;
    }

    TemporaryFolder folder_;
    std::string program_, trace_;
};

// The lines of a scene: a block that begins with GL's calls, comments or pragmas.
std::string scene_text(const CodeBlock& block) {
    std::string text;
    bool has_call = false;
    for (const std::string& line : block.lines) {
        if (text.empty() && !has(line, R"(^(gl[A-Z]|glu[A-Z]|glut[A-Z]|//|#pragma))")) return "";
        has_call = has_call || has(line, R"(^ *glu?t?[A-Z]\w+\()");
        text += line + "\n";
    }
    return has_call ? text : "";
}

class CommandsOfDocs : public testing::Test {
  protected:
    void run_page(const Document& page) {
        folder_.clean();
        const std::vector<CodeBlock> blocks = code_blocks(page);
        const std::regex name(R"(// (\w+\.gl)\b.*)");
        std::smatch named;
        for (const CodeBlock& block : blocks)
            if (std::regex_match(block.lines.front(), named, name))
                write_file_atomically(folder_ / named.str(1), scene_text(block));
        std::string scene;
        for (const CodeBlock& block : blocks) {
            if (const std::string text = scene_text(block); !text.empty()) scene = text;
            std::string inside;  // where cd went
            for (const CommandLine& command : command_lines(block)) run_line(page, command, scene, inside);
        }
    }

    void run_line(const Document& page, const CommandLine& command, const std::string& scene, std::string& inside) {
        SCOPED_TRACE(fmt::format("{}:{}: {}", page.path, command.line, command.text));
        ++lines_;
        if (const std::optional<std::string> complaint = complaint_of_others(command.text)) {
            EXPECT_EQ(*complaint, "");
            return;
        }
        const std::string line = with_examples(command.text);
        EXPECT_FALSE(has(line, R"(\s(FILE|NAME|FOLDER|PATH|N|X,Y|STEP)\b)"))
            << "write a line that can be run, or add an example for the word to this test";
        if (line.starts_with("cd ")) inside = line.substr(3, line.find(' ', 3) - 3);
        if (line.starts_with("cd ") && line.find("&&") == std::string::npos) {
            EXPECT_TRUE(fs::is_directory(folder_ / inside));
            return;
        }
        const bool is_known = !ran_.insert(line).second;
        if (is_long(line) && !tries_all()) return;
        if (is_known && line.find(" -o ") == std::string::npos && line.find(".gl") == std::string::npos) return;
        folder_.provide(line, scene, inside);
        // On a busy machine the study that this line resumes may have been cut before it measured anything.
        if (const std::size_t resume = line.find(" --resume");
            resume != line.npos && !fs::exists(folder_ / "study/study.json"))
            run_in(inside, shortened(line.substr(0, resume), 60));
        const ProgramResult result = run_in(line.starts_with("cd ") ? "" : inside, shortened(line), display(line));
        // A difference or a warning is an answer, too.
        const bool may_differ = has(line, R"(twinlight (compare|check|lint|fuzz|lesson)\b)");
        // Interrupted before anything was measured.
        constexpr int kInterrupted = 130;
        const bool is_cut = has(line, "twinlight study ") && result.status == kInterrupted;
        EXPECT_TRUE(result.status == 0 || is_cut || (may_differ && result.status == 1))
            << "exit status " << result.status << "\n"
            << result.err << result.out.substr(0, 2000);
    }

    // `inside`: a folder of the reader's folder.
    ProgramResult run_in(const std::string& inside, const std::string& line, const std::string& display = "") const {
        return run_shell(
            "", fmt::format("cd {} && export PATH=\"$PWD/build:$PATH\" DISPLAY={} && cd ./{} && timeout 300 sh -c {}",
                            twinlight::quoted(folder_ / ""), display, inside.empty() ? "" : twinlight::quoted(inside),
                            twinlight::quoted(line)));
    }

    // A window needs a display; the other programs must not.
    std::string display(const std::string& line) {
        if (!has(line, R"(twinlight-demo|\./)") || has(line, "twinlight record")) return "";
        if (!server_) server_.emplace();
        EXPECT_TRUE(server_->running()) << server_->reason();
        return server_->display();
    }

    ReadersFolder folder_;
    int lines_ = 0;
    std::set<std::string> ran_;
    std::optional<Xvfb> server_;
};

TEST_F(CommandsOfDocs, RunAsTheyAreWritten) {
    for (const Document& page : documents()) run_page(page);
    EXPECT_GT(lines_, 60) << "the test does find the lines";
}

TEST_F(CommandsOfDocs, ThatAreWrongAreFound) {
    const auto complaint = [](const std::string& line) { return complaint_of_others(line).value_or("none"); };
    EXPECT_EQ(complaint("make tests"), "the Makefile has no goal tests");
    EXPECT_EQ(complaint("sudo make instal PREFIX=/usr"), "the Makefile has no goal instal");
    EXPECT_EQ(complaint("make test TESTS='Spot*'"), "the Makefile has no variable TESTS");
    EXPECT_EQ(complaint("make test TEST='Spot* Light*'"), "");
    EXPECT_EQ(complaint("GALLIUM_DRIVER=softpipe TWINLIGHT_GL=egl make test"), "");
    EXPECT_EQ(complaint("tools/in-clean-root.sh --bare trixie 'make'"), "no option --bare");
    EXPECT_EQ(complaint("build/fuzz/gif-fuzzer a"), "there is no such fuzzer");
    EXPECT_EQ(complaint("build/twinlight scenes"), "none");
    const Document page{"page.md",
                        {"Text:", "", "    $ build/twinlight scenes   # all", "    not a command", "", "```",
                         "CC=gcc make \\", "  test", "```"}};
    const std::vector<CodeBlock> blocks = code_blocks(page);
    ASSERT_EQ(blocks.size(), 2U);
    ASSERT_EQ(command_lines(blocks[0]).size(), 1U);
    EXPECT_EQ(command_lines(blocks[0])[0].text, "build/twinlight scenes");
    EXPECT_EQ(command_lines(blocks[0])[0].line, 3U);
    EXPECT_EQ(command_lines(blocks[1])[0].text, "CC=gcc make   test");
    EXPECT_EQ(shortened("build/twinlight-demo lab"),
              "timeout 60 build/twinlight-demo lab --quit-after 2 --screenshot window.png");
    EXPECT_EQ(with_examples("build/twinlight-demo [SCENE]        SCENE: a name"), "build/twinlight-demo");
}

}  // namespace
}  // namespace twinlight::commands_test
