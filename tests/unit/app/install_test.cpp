// make install and make uninstall; the manual pages and the completion name every option that --help lists.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "../run_program.h"
#include "app/version.h"
#include "base/image/file.h"

namespace twinlight::install_test {
namespace {

namespace fs = std::filesystem;

// Runs make on the programs that the tests run on, without building them again.
ProgramResult run_make(const std::string& goal, const std::string& variables) {
    const std::string build = build_folder();
    return run_shell(
        "", fmt::format("env -u MAKEFLAGS -u MAKELEVEL make --no-print-directory {0} BUILD={1} PROGRAMS={1} {2} "
                        "-o programs -o {1}/twinlight -o {1}/twinlight-demo",
                        goal, quoted(build), variables));
}

bool is_installed(const std::string& program) { return run_shell("", "command -v " + program).status == 0; }

std::vector<std::string> words_of(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> words;
    for (std::string word; in >> word;) words.push_back(word);
    return words;
}

// "render", "compare" and so on, as --help lists them.
std::vector<std::string> commands() {
    const std::string help = run_program("twinlight", {"--help"}).out;
    std::vector<std::string> names;
    const std::regex row("\n  ([a-z]+) +[A-Z]");
    const std::string list = help.substr(help.find("ubcommands:"));
    for (std::sregex_iterator match(list.begin(), list.end(), row), end; match != end; ++match)
        names.push_back(match->str(1));
    return names;
}

std::string help_of(const std::string& program, const std::string& command) {
    std::vector<std::string> arguments{command, "--help"};
    if (command.empty()) arguments.erase(arguments.begin());
    const ProgramResult result = run_program(program, arguments);
    EXPECT_EQ(result.status, 0) << program << " " << command;
    return result.out;
}

// "--with", "-o": the names at the start of the lines of --help.
std::set<std::string> options_of(const std::string& help) {
    std::set<std::string> options;
    const std::regex row("\n  (-[a-zA-Z]|--[a-z-]+)(, *(--[a-z-]+))?");
    for (std::sregex_iterator match(help.begin(), help.end(), row), end; match != end; ++match)
        for (const int group : {1, 3})
            if ((*match)[group].matched) options.insert(match->str(group));
    return options;
}

// The choices of the options that have some: "--as" with "c", "glsl".
struct Choices {
    std::string option;
    std::vector<std::string> words;
    bool or_file;  // "osmesa|egl|FILE": shells offer files, too
};
std::vector<Choices> choices_of(const std::string& help) {
    std::vector<Choices> options;
    const std::regex row("\n  (--[a-z-]+) ([a-z0-9]+([|][a-z0-9]+)+)([|]FILE)?");
    for (std::sregex_iterator match(help.begin(), help.end(), row), end; match != end; ++match) {
        std::string words = match->str(2);
        std::ranges::replace(words, '|', ' ');
        options.push_back({match->str(1), words_of(words), (*match)[4].matched});
    }
    return options;
}

class Install : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        folder_ = std::make_unique<TemporaryFolder>();
        const ProgramResult result = run_make("install-files", where("root"));
        ASSERT_EQ(result.status, 0) << result.out << result.err;
    }
    static void TearDownTestSuite() { folder_.reset(); }

    static std::string in_folder(const std::string& name) { return *folder_ / name; }
    static std::string where(const std::string& root) {
        return "MADE=" + quoted(in_folder("made")) + " DESTDIR=" + quoted(in_folder(root));
    }
    static std::string share(const std::string& path) { return in_folder("root/usr/local/share/" + path); }

    static inline std::unique_ptr<TemporaryFolder> folder_;
};

TEST_F(Install, PutsProgramsWhereTheyRunAndUninstallTakesAllAway) {
    const std::string bin = in_folder("root/usr/local/bin");
    const ProgramResult ran =
        run_shell("", fmt::format("mkdir {0} && cd {0} && env -i PATH={1}:/usr/bin:/bin HOME={0} sh -c "
                                  "'twinlight scenes && twinlight render report --with reference --size 40x30 && "
                                  "twinlight check light-none && twinlight export lab --as html -o lab.html && "
                                  "twinlight compare lab --size 40x30 -o lab && twinlight-demo --version'",
                                  quoted(in_folder("elsewhere")), quoted(bin)));
    EXPECT_EQ(ran.status, 0) << ran.out << ran.err;
    for (const char* file : {"report.png", "lab.html", "lab/index.html"})
        EXPECT_TRUE(fs::exists(in_folder(std::string("elsewhere/") + file))) << file;

    int scenes = 0, cases = 0;
    for (const auto& entry : fs::directory_iterator("src/scene/scenes")) {
        if (entry.path().extension() != ".gl") continue;
        EXPECT_EQ(read_file(share("twinlight/scenes/" + entry.path().filename().string())), read_file(entry.path()));
        ++scenes;
    }
    for (const auto& entry : fs::directory_iterator("golden/hard"))
        cases += fs::exists(share("twinlight/cases/" + entry.path().filename().string())) ? 1 : 0;
    EXPECT_GE(scenes, 5);
    EXPECT_GE(cases, 200);
    EXPECT_EQ(cases, std::distance(fs::directory_iterator("golden/hard"), {}));
    EXPECT_NE(read_file(share("applications/twinlight.desktop")).find("\nIcon=twinlight\n"), std::string::npos);
    EXPECT_TRUE(fs::exists(share("icons/hicolor/scalable/apps/twinlight.svg")));

    fs::copy(in_folder("root"), in_folder("copy"), fs::copy_options::recursive);
    const ProgramResult removed = run_make("uninstall", where("copy"));
    EXPECT_EQ(removed.status, 0) << removed.err;
    for (const auto& entry : fs::recursive_directory_iterator(in_folder("copy")))
        EXPECT_TRUE(entry.is_directory()) << entry.path() << " is left";
}

TEST_F(Install, ManualPagesNameEveryOption) {
    const auto plain = [](std::string page) {
        for (const std::string mark : {"\\fB", "\\fI", "\\fR", "\\&", "\\:"})
            for (std::size_t at = 0; (at = page.find(mark, at)) != std::string::npos;) page.erase(at, mark.size());
        for (std::size_t at = 0; (at = page.find("\\-", at)) != std::string::npos; ++at) page.erase(at, 1);
        return page;
    };
    const auto names = [](const std::string& part, const std::string& option) {
        return std::regex_search(part, std::regex("\n\\.TP\n([^\n]*, )?" + option + "(?![a-z-])"));
    };
    const std::string page = plain(read_file(share("man/man1/twinlight.1")));
    const std::vector<std::string> all = commands();
    ASSERT_GE(all.size(), 10U);
    int named = 0;
    for (const std::string& command : all) {
        const std::size_t begin = page.find("\n.SS twinlight " + command + "\n");
        ASSERT_NE(begin, std::string::npos) << command;
        const std::size_t end = std::min(page.find("\n.S", begin + 1), page.size());
        const std::string part = page.substr(begin, end - begin), help = help_of("twinlight", command);
        for (const std::string& option : options_of(help)) {
            if (option == "-h" || option == "--help" || option == "--version") continue;  // at the top of the page
            EXPECT_TRUE(names(part, option)) << command << " " << option;
            ++named;
        }
        for (const auto& [option, choices, or_file] : choices_of(help))
            for (const std::string& choice : choices)
                EXPECT_TRUE(std::regex_search(part, std::regex(option + "[^\n]*[ |]" + choice + "\\b")))
                    << command << " " << option << " " << choice;
    }
    EXPECT_GT(named, 50);
    EXPECT_FALSE(names(page, "--no-such-option"));
    const std::string demo = plain(read_file(share("man/man1/twinlight-demo.1")));
    for (const std::string& option : options_of(help_of("twinlight-demo", "")))
        EXPECT_TRUE(names(demo, option)) << "twinlight-demo " << option;
    EXPECT_NE(demo.find("\nf               GL_FLAT or GL_SMOOTH\n"), std::string::npos);
    if (!is_installed("groff")) return;
    for (const char* name : {"twinlight", "twinlight-demo"}) {
        const ProgramResult checked =
            run_shell("", "groff -man -Tutf8 -ww -z " + quoted(share(fmt::format("man/man1/{}.1", name))));
        EXPECT_EQ(checked.status, 0);
        EXPECT_EQ(checked.err, "") << name;
    }
}

// What a shell offers for the last of the words.
std::vector<std::string> offered_by_bash(const std::string& script, const std::string& line) {
    return words_of(run_shell("",
                              "bash -c '. \"$1\"; name=$2; shift; COMP_WORDS=(\"$@\"); COMP_CWORD=$(($# - 1)); "
                              "\"_${name//-/_}\"; printf \"%s\\n\" \"${COMPREPLY[@]}\"' - " +
                                  quoted(script) + " " + line)
                        .out);
}

TEST_F(Install, BashCompletesEveryCommandOptionAndChoice) {
    const auto sorted = [](std::vector<std::string> words) {
        std::ranges::sort(words);
        return words;
    };
    const std::string script = share("bash-completion/completions/twinlight"), demo = script + "-demo";
    std::vector<std::string> all = commands();
    EXPECT_EQ(sorted(offered_by_bash(script, "twinlight ''")), sorted(all));
    EXPECT_EQ(offered_by_bash(script, "twinlight exp"), sorted({"explain", "export"}));
    const auto expect_options = [&](const std::string& file, const std::string& line, const std::string& help) {
        std::vector<std::string> offered = offered_by_bash(file, line + " -");
        const std::set<std::string> options = options_of(help);
        EXPECT_EQ(std::set<std::string>(offered.begin(), offered.end()), options) << line;
        for (const auto& [option, choices, or_file] : choices_of(help)) {
            for (const char* value : {" ''", " = ''"}) {
                std::vector<std::string> words = offered_by_bash(file, line + " " + option + value);
                EXPECT_EQ(words.size() > choices.size(), or_file) << line;
                if (or_file) words.resize(choices.size());
                EXPECT_EQ(words, choices) << line;
            }
        }
    };
    for (const std::string& command : all)
        expect_options(script, "twinlight " + command, help_of("twinlight", command));
    expect_options(demo, "twinlight-demo", help_of("twinlight-demo", ""));
    EXPECT_GE(choices_of(help_of("twinlight-demo", "")).size(), 2U);
    EXPECT_EQ(offered_by_bash(script, "twinlight compare repor"), std::vector<std::string>{"report"});
    EXPECT_EQ(offered_by_bash(script, "twinlight check light-non"), std::vector<std::string>{"light-none"});
    EXPECT_EQ(offered_by_bash(script, "twinlight lint README.m"), std::vector<std::string>{"README.md"});
}

TEST_F(Install, FishCompletesEveryOption) {
    if (!is_installed("fish")) GTEST_SKIP() << "fish is not installed";
    const auto offered = [&](const std::string& program, const std::string& line) {
        const std::string file = share("fish/vendor_completions.d/" + program + ".fish");
        std::set<std::string> words;
        std::istringstream lines(run_shell("", fmt::format("HOME={} fish -N -c {}", quoted(folder_->str()),
                                                           quoted("source " + file + "; complete -C '" + line + "'")))
                                     .out);
        for (std::string text; std::getline(lines, text);) words.insert(text.substr(0, text.find('\t')));
        return words;
    };
    const auto expect_options = [&](const std::string& program, const std::string& command) {
        const std::string line = program + (command.empty() ? "" : " " + command), help = help_of(program, command);
        const std::set<std::string> found = offered(program, line + " --");
        for (const std::string& option : options_of(help))
            EXPECT_TRUE(!option.starts_with("--") || found.contains(option)) << line << " " << option;
        EXPECT_FALSE(found.contains("--no-such-option"));
        for (const auto& [option, choices, or_file] : choices_of(help)) {
            const std::set<std::string> words = offered(program, line + " " + option + " ");
            EXPECT_EQ(words.size() > choices.size(), or_file) << line;
            for (const std::string& choice : choices) EXPECT_TRUE(words.contains(choice)) << line << " " << choice;
        }
    };
    for (const std::string& command : commands()) expect_options("twinlight", command);
    expect_options("twinlight-demo", "");
    EXPECT_TRUE(offered("twinlight", "twinlight che").contains("check"));
    EXPECT_TRUE(offered("twinlight", "twinlight compare repo").contains("report"));
}

TEST_F(Install, ZshReadsTheCompletionThatNamesEveryOption) {
    const auto expect_options = [&](const std::string& part, const std::string& help) {
        for (const std::string& option : options_of(help))
            EXPECT_TRUE(std::regex_search(part, std::regex("\\)" + option + "=?\\["))) << option << " in\n" << part;
        for (const auto& [option, choices, or_file] : choices_of(help))
            EXPECT_NE(part.find(fmt::format("({})", fmt::join(choices, " "))), std::string::npos) << option;
    };
    const std::string file = share("zsh/site-functions/_twinlight"), text = read_file(file);
    for (const std::string& command : commands()) {
        const std::size_t begin = text.find("\n    " + command + ")\n");
        ASSERT_NE(begin, std::string::npos) << command;
        expect_options(text.substr(begin, text.find(";;", begin) - begin), help_of("twinlight", command));
    }
    expect_options(read_file(file + "-demo"), help_of("twinlight-demo", ""));
    if (!is_installed("zsh")) GTEST_SKIP() << "zsh is not installed; the text names every option";
    for (const std::string& name : {file, file + "-demo"}) {
        const ProgramResult read = run_shell("", "zsh -f -n " + quoted(name));
        EXPECT_EQ(read.status, 0) << read.err;
    }
}

TEST(Dist, HoldsEveryFileOfTheCommitAndBuilds) {
    if (run_shell("", "git rev-parse --verify HEAD").status != 0) GTEST_SKIP() << "this is not a git repository";
    const TemporaryFolder folder;
    const ProgramResult packed = run_make("dist", "DIST=" + quoted(folder.str()));
    ASSERT_EQ(packed.status, 0) << packed.err;
    const ProgramResult unpacked =
        run_shell("", fmt::format("cd {} && tar xzf twinlight-*.tar.gz && cd twinlight-*/ && "
                                  "find . -type f | sed 's,^\\./,,' | LC_ALL=C sort",
                                  quoted(folder.str())));
    const ProgramResult tracked =
        run_shell("", "git -c core.quotePath=false ls-tree -r --name-only HEAD | LC_ALL=C sort");
    EXPECT_EQ(unpacked.out, tracked.out) << unpacked.err;
    EXPECT_GT(words_of(tracked.out).size(), 1000U);
    // The archive knows its commit, although it has no repository.
    const ProgramResult commit = run_shell("", fmt::format("{}/twinlight-*/tools/commit.sh", quoted(folder.str())));
    EXPECT_EQ(commit.out, run_shell("", "git rev-parse HEAD").out.substr(0, 8) + "\n") << commit.err;
    const ProgramResult planned =
        run_shell("", fmt::format("cd {}/twinlight-*/ && env -u MAKEFLAGS make -n programs", quoted(folder.str())));
    EXPECT_EQ(planned.status, 0) << planned.err;
    EXPECT_NE(planned.out.find("link build/twinlight-demo"), std::string::npos);
}

// `make nightly PART=release` makes and tries a whole release.
TEST(Release, HasNotesForEveryReaderOfThisVersion) {
    const std::string notes = run_shell("", std::string("tools/release.sh --notes ") + kVersion).out;
    for (const char* reader : {"Students", "Teachers", "Porters", "Driver writers"})
        EXPECT_TRUE(std::regex_search(notes, std::regex(fmt::format("\n### {}\n\n- [A-Z`1]", reader)))) << reader;
    EXPECT_EQ(notes.find("\n## "), std::string::npos);
    EXPECT_EQ(run_shell("", "tools/release.sh --notes 99").out, "");
    EXPECT_NE(read_file("CITATION.cff").find(fmt::format("version: \"{}\"", kVersion)), std::string::npos);
}

TEST(Release, HasManualPagesAsHtml) {
    if (!is_installed("mandoc")) GTEST_SKIP() << "mandoc is not installed";
    const TemporaryFolder folder;
    const ProgramResult made = run_make("manuals-html", "MADE=" + quoted(folder.str()));
    ASSERT_EQ(made.status, 0) << made.err;
    const std::string page = read_file(folder / "twinlight.1.html");
    for (const std::string& command : commands())
        EXPECT_NE(page.find("<h2 class=\"Ss\" id=\"twinlight_" + command + "\">"), std::string::npos) << command;
    EXPECT_NE(read_file(folder / "twinlight-demo.1.html").find("--screenshot"), std::string::npos);
}

}  // namespace
}  // namespace twinlight::install_test
