// What README, CONTRIBUTING and the pages of docs/ name in code font exists: files, options, goals of make, tests, GL's names, symbols of
// the sources; and each link leads somewhere.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "../unit/run_program.h"
#include "base/image/file.h"
#include "documents.h"

namespace twinlight::names_test {
namespace {

namespace fs = std::filesystem;

bool is_word_letter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// All words of a text, with their names' letters, digits and underscores.
void add_words(const std::string& text, std::set<std::string, std::less<>>& words) {
    for (std::size_t at = 0; at < text.size();) {
        std::size_t end = at;
        while (end < text.size() && is_word_letter(text[end])) ++end;
        if (end > at) words.insert(text.substr(at, end - at));
        at = end + 1;
    }
}

// What the repository and GL's headers hold.
class Known {
  public:
    Known() {
        for (const char* folder : {"src", "tests", "tools", "golden", "docs", ".ci"})
            for (const auto& entry : fs::recursive_directory_iterator(folder)) add_file(entry.path());
        for (const auto& entry : fs::directory_iterator("."))
            if (entry.is_regular_file()) add_file(entry.path().lexically_normal());
        for (const char* header :
             {"GL/gl.h", "GL/glext.h", "GL/glu.h", "GL/glx.h", "GL/freeglut_std.h", "GL/freeglut_ext.h"})
            if (const fs::path path = fs::path("/usr/include") / header; fs::exists(path))
                add_words(read_file(path), gl_);
        const std::regex test(R"(TEST(_F|_P)?\((\w+), (\w+)\))");
        for (const auto& entry : fs::recursive_directory_iterator("tests")) {
            if (entry.path().extension() != ".cpp" || entry.path().filename() == "names_test.cpp") continue;
            const std::string text = read_file(entry.path());
            for (std::sregex_iterator match(text.begin(), text.end(), test), end; match != end; ++match)
                tests_.push_back(match->str(2) + "." + match->str(3));
            static const std::regex instantiated(R"(INSTANTIATE_TEST_SUITE_P\((\w+), (\w+))");
            for (std::sregex_iterator match(text.begin(), text.end(), instantiated), end; match != end; ++match)
                tests_.push_back(match->str(1) + "/" + match->str(2) + ".");
        }
        makefile_ = "\n" + read_file("Makefile") + read_file("tools/install/install.mk") +
                    read_file("src/app/web/web.mk") +
                    read_file("src/judge/conformance/suite/Makefile");  // in a folder of `check --write-cases`
        const std::string help = help_of("twinlight", "");
        const std::regex command("\n  ([a-z]+) +[A-Z]");
        const std::string list = help.substr(help.find("ubcommands:"));
        for (std::sregex_iterator match(list.begin(), list.end(), command), end; match != end; ++match)
            helps_[match->str(1)] = help_of("twinlight", match->str(1));
        helps_[""] = help;
        helps_["twinlight-demo"] = help_of("twinlight-demo", "");
    }

    bool has_word(const std::string& word) const { return words_.contains(word); }
    // A word that starts or ends so.
    bool has_part(const std::string& part) const {
        return std::ranges::any_of(
            words_, [&](const std::string& word) { return word.starts_with(part) || word.ends_with(part); });
    }
    bool has_gl_name(const std::string& name) const { return gl_.contains(name); }
    bool has_gl_start(const std::string& start) const {
        const auto at = gl_.lower_bound(start);
        return at != gl_.end() && at->starts_with(start);
    }
    bool is_command(const std::string& name) const { return !name.empty() && helps_.contains(name); }
    bool has_option(const std::string& command, const std::string& option) const {
        const std::string& help = helps_.at(command);
        return std::regex_search(help, std::regex("\n  (-[a-z], *)?" + option + "(?![a-z-])"));
    }
    bool any_has_option(const std::string& option) const {
        return std::ranges::any_of(helps_, [&](const auto& help) { return has_option(help.first, option); });
    }
    bool has_goal(const std::string& goal) const { return makefile_.find("\n" + goal + ":") != std::string::npos; }
    // "docs/lint.md", "lint.md", "src/app/demo/", "golden/hard/NAME.gl", "tests/unit/app/session_*_test.cpp"
    bool has_file(std::string path) const {
        if (path.ends_with('/')) path.pop_back();
        std::string pattern;  // words in capitals and * are any text
        static const std::regex placeholder(R"(NAME|SCENE|CASE|TARGET|\*)");
        pattern = std::regex_replace(path, placeholder, "\x01");
        std::string escaped;
        for (const char c : pattern)
            escaped += c == '\x01' ? std::string("[^/]*") : std::string(is_word_letter(c) || c == '/' ? "" : "\\") + c;
        const std::regex whole("(.*/)?" + escaped);
        return fs::exists(path) ||
               std::ranges::any_of(files_, [&](const std::string& file) { return std::regex_match(file, whole); });
    }
    // A file that the programs write: the sources have its name, or the end of it where it begins with a number.
    bool is_written(const std::string& path) const {
        const std::string name = path.substr(path.rfind('/') + 1);
        return sources_.find(name.substr(std::min(name.find_first_not_of("-0123456789"), name.size() - 1))) !=
               std::string::npos;
    }
    bool has_test(const std::string& filter) const {
        return std::ranges::any_of(tests_, [&](const std::string& test) { return matches(filter, test); });
    }

  private:
    static std::string help_of(const std::string& program, const std::string& command) {
        return run_shell(program, "\"$PROGRAM\" " + command + " --help").out;
    }
    void add_file(const fs::path& path) {
        files_.push_back(path.generic_string());
        if (!fs::is_regular_file(path)) return;
        const std::string kind = path.extension();
        const bool is_this_test = path.filename() == "names_test.cpp";  // which has names that do not exist
        if (kind == ".png" || kind == ".md" || path.generic_string().starts_with("docs/") || is_this_test) return;
        const std::string text = read_file(path);
        add_words(text, words_);
        if (path.generic_string().starts_with("src/scene/command/")) add_words(text, gl_);
        if (path.generic_string().starts_with("src/")) sources_ += text;
    }
    // GoogleTest's patterns: * is any text, also in the middle.
    static bool matches(const std::string& filter, const std::string& test) {
        std::string pattern;
        for (const char c : filter)
            pattern += c == '*'            ? ".*"
                       : c == '?'          ? "."
                       : is_word_letter(c) ? std::string(1, c)
                                           : "\\" + std::string(1, c);
        return std::regex_match(test, std::regex(pattern));
    }

    std::vector<std::string> files_, tests_;
    std::set<std::string, std::less<>> words_, gl_;
    std::map<std::string, std::string> helps_;
    std::string makefile_, sources_;
};

const Known& known() {
    static const Known all;
    return all;
}

std::vector<std::string> split(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> words;
    for (std::string word; in >> word;) words.push_back(word);
    return words;
}

// The spans between backquotes of the page's text, with their lines.
std::vector<std::pair<std::size_t, std::string>> code_spans(const Document& page) {
    std::set<std::size_t> in_blocks;
    for (const CodeBlock& block : code_blocks(page))
        for (std::size_t i = 0; i < block.lines.size(); ++i) in_blocks.insert(block.first_line + i);
    std::vector<std::pair<std::size_t, std::string>> spans;
    for (std::size_t i = 0; i < page.lines.size(); ++i) {
        if (in_blocks.contains(i + 1)) continue;
        std::istringstream parts(page.lines[i]);
        std::string part;
        for (bool is_code = false; std::getline(parts, part, '`'); is_code = !is_code)
            if (is_code && !part.empty()) spans.emplace_back(i + 1, part);
    }
    return spans;
}

// Files of the reader, as the pages call them.
bool is_example(const std::string& word) {
    static const std::set<std::string> kExamples = {"homework.c", "jitter.h", "ball.gl", "mine.gl"};
    return kExamples.contains(word);
}

bool is_of_c(const std::string& word) { return word == "main()" || word == "display()" || word == "pow()"; }

// "" or what is wrong with a command line or with a name.
std::string complaint(const std::string& code) {
    std::vector<std::string> words = split(code);
    static const std::set<std::string> kOthers = {"cc", "c++", "g++", "cd", "git", "apt-get", "sudo"};
    if (kOthers.contains(words[0])) return "";
    // A command of ours: its options are its own.
    std::string command;
    bool ours = false;
    std::size_t program = 0;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i] == "twinlight" || words[i] == "build/twinlight") {
            ours = true;
            program = i;
            if (i + 1 < words.size() && std::regex_match(words[i + 1], std::regex("[a-z]+"))) {
                command = words[i + 1];
                if (!known().is_command(command)) return "twinlight has no command " + command;
            }
        } else if (words[i] == "twinlight-demo" || words[i] == "build/twinlight-demo") {
            ours = true;
            command = "twinlight-demo";
        } else if (i == 0 && known().is_command(words[i]) && words.size() > 1 && words[1].starts_with("--")) {
            ours = true;  // "export --as html"
            command = words[i];
        }
    }
    words.erase(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(program));
    if (words[0] == "make") {
        for (std::size_t i = 1; i < words.size() && words[i].find('\'') == std::string::npos; ++i)
            if (std::regex_match(words[i], std::regex("[a-z-]+")) && !words[i].starts_with('-') && words[i] != "make" &&
                !known().has_goal(words[i]))
                return "the Makefile has no goal " + words[i];
    }
    static const std::regex filter(R"(TEST='([^']*)')");
    std::string filters;
    if (std::smatch found; std::regex_search(code, found, filter))
        filters = found.str(1);
    else if (std::regex_match(code, std::regex(R"([A-Z]\w+(/\w+)?\.[A-Z*][\w*]*\.{0,3})")) && !known().has_file(code))
        filters = code;
    if (filters.ends_with("...")) filters = filters.substr(0, filters.size() - 3) + "*";
    std::istringstream list(filters);
    for (std::string one; std::getline(list, one, ':');)
        if (!known().has_test(one)) return "there is no test " + one;
    if (!filters.empty()) return "";

    static const std::regex option(R"((--[a-z][a-z-]+)(=.*)?)");
    static const std::regex path(
        R"((\.?[A-Za-z_*][\w.*-]*/)*[\w*-]+\.(cpp|h|gl|def|md|sh|glsl|png|svg|mk|awk|supp|c|js|html|json|txt)|(src|docs|tests|tools|golden)/[\w./*-]*)");
    static const std::regex gl_name(R"(GLU?T?_[A-Z0-9_]+)"), gl_function(R"((glu?t?|glX)[A-Z]\w+(\(.*)?)");
    static const std::regex symbol(R"(((\w+)::)?([A-Za-z_]\w+)(\(\)?)?)");
    for (std::string word : words) {
        while (!word.empty() && std::string(",;:").find(word.back()) != std::string::npos) word.pop_back();
        std::smatch parts;
        if (std::regex_match(word, parts, option)) {
            const bool external = !ours && words.size() > 1;  // another program's line
            if (ours ? !known().has_option(command, parts.str(1)) : !external && !known().any_has_option(parts.str(1)))
                return fmt::format("no option {}{}{}", parts.str(1), command.empty() ? "" : " of ", command);
        } else if (std::regex_match(word, path)) {
            if (word.starts_with("build/") || ours) continue;  // what a line reads and writes is tried by running it
            if (!known().has_file(word) && !known().is_written(word) && !is_example(word))
                return "there is no file " + word;
        } else if (std::regex_match(word, gl_name)) {
            if (!known().has_gl_name(word) && !(word.ends_with('_') && known().has_gl_start(word)))
                return "GL has no name " + word;
        } else if (words.size() == 1 && std::regex_match(word, gl_function)) {
            const std::string name = word.substr(0, word.find_first_of("({["));
            if (!known().has_gl_name(name) && !known().has_gl_start(name)) return "GL has no function " + name;
        } else if (words.size() == 1 && !is_of_c(word) && std::regex_match(word, parts, symbol)) {
            const std::string name = parts.str(3);
            const bool looks_ours = parts[1].matched || parts[4].matched || name.find('_') != std::string::npos ||
                                    std::regex_match(name, std::regex("k?([A-Z][a-z]+){2,}"));
            if (looks_ours && !known().has_word(name) &&
                !((name.ends_with('_') || name.starts_with('_')) && known().has_part(name)))
                return "the sources do not name " + name;
            if (parts[1].matched && !known().has_word(parts.str(2))) return "the sources do not name " + parts.str(2);
        }
    }
    return "";
}

TEST(NamesOfDocs, Exist) {
    std::size_t count = 0;
    for (const Document& page : documents()) {
        for (const auto& [line, code] : code_spans(page)) {
            if (split(code).empty()) continue;
            EXPECT_EQ(complaint(code), "") << page.path << ":" << line << ": `" << code << "`";
            ++count;
        }
        for (const CodeBlock& block : code_blocks(page))
            for (const CommandLine& command : command_lines(block))
                EXPECT_EQ(complaint(command.text), "") << page.path << ":" << command.line << ": " << command.text;
    }
    EXPECT_GT(count, 1000U) << "the test does find the names";
}

TEST(NamesOfDocs, ThatDoNotExistAreFound) {
    for (const char* wrong :
         {"src/lighting/equations.h", "no_such_file.cpp", "golden/hard/NAME.glx.gl", "twinlight drawn report",
          "twinlight render --wiht fixed", "export --as-html", "--no-such-option", "make tset",
          "make test TEST='NoSuchSuite*'", "NoSuchSuite.HasATest", "GL_NO_SUCH_NAME", "glLihgtfv", "no_such_function()",
          "NoSuchClass::member", "NoSuchClass", "kNoSuchConstant"})
        EXPECT_NE(complaint(wrong), "") << wrong;
    for (const char* right :
         {"src/lighting/equation.h", "equation.h", "golden/hard/NAME.gl", "twinlight render --with fixed",
          "export --as html", "--shading", "make test", "make test TEST='HardCases*:Png*'", "GL_LIGHT0", "glLightfv",
          "glLight{fi}[v]", "attenuation()", "1 + 2", "(GLfloat[]){1, 1, 1, 1}"})
        EXPECT_EQ(complaint(right), "") << right;
}

// ---- Links ----

// The name that GitHub gives a heading's place: letters of any language, digits, - and _ stay; a space becomes -.
std::string anchor_of(const std::string& heading) {
    std::string anchor;
    for (std::size_t at = 0; at < heading.size();) {
        const auto first = static_cast<unsigned char>(heading[at]);
        const std::size_t length = first < 0x80 ? 1 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
        const std::string letter = heading.substr(at, length);
        at += length;
        if (letter == " ") anchor += '-';
        // Beyond ASCII: no signs of Latin-1, no general punctuation, no Chinese punctuation (U+2000, U+3000, U+FF00).
        const bool is_sign = letter.starts_with("\xc2") || letter == "\u00d7" || letter.starts_with("\xe2") ||
                             letter.starts_with("\xe3\x80") || letter.starts_with("\xef\xbc") ||
                             letter.starts_with("\xef\xbd");
        if (length > 1 && !is_sign) anchor += letter;
        if (length == 1 && (is_word_letter(letter[0]) || letter == "-"))
            anchor += static_cast<char>(std::tolower(first));
    }
    return anchor;
}

std::set<std::string> anchors_of(const std::string& path) {
    std::set<std::string> anchors;
    std::istringstream lines(read_file(path));
    for (std::string line; std::getline(lines, line);)
        if (const std::size_t text = line.find_first_not_of('#'); text != line.npos && text > 0 && line[text] == ' ')
            anchors.insert(anchor_of(line.substr(text + 1)));
    return anchors;
}

TEST(LinksOfDocs, LeadSomewhere) {
    const std::regex link(R"(\]\(([^)#\s]*)(#([^)\s]*))?\))");
    int count = 0;
    for (const Document& page : documents()) {
        std::set<std::size_t> in_blocks;
        for (const CodeBlock& block : code_blocks(page))
            for (std::size_t i = 0; i < block.lines.size(); ++i) in_blocks.insert(block.first_line + i);
        for (std::size_t i = 0; i < page.lines.size(); ++i) {
            if (in_blocks.contains(i + 1)) continue;
            const std::string& line = page.lines[i];
            for (std::sregex_iterator match(line.begin(), line.end(), link), end; match != end; ++match) {
                const std::string target = match->str(1), anchor = match->str(3);
                if (target.starts_with("http") || target.starts_with("mailto:")) continue;
                ++count;
                const fs::path path = target.empty() ? fs::path(page.path) : fs::path(page.path).parent_path() / target;
                EXPECT_TRUE(fs::exists(path)) << page.path << ":" << i + 1 << ": there is no " << path;
                if (anchor.empty() || path.extension() != ".md" || !fs::exists(path)) continue;
                EXPECT_TRUE(anchors_of(path).contains(anchor))
                    << page.path << ":" << i + 1 << ": " << path << " has no heading " << anchor;
            }
        }
    }
    EXPECT_GT(count, 100);
    EXPECT_EQ(anchor_of("What `check` does, and why-not"), "what-check-does-and-why-not");
    EXPECT_EQ(anchor_of("\u7b2c\u4e09\u8bb2\uff1a\u5149 (GL_LIGHT0)"), "\u7b2c\u4e09\u8bb2\u5149-gl_light0");
}

// `make nightly PART=recipes` builds and tests what they make; here one notices that a change has made them old.
TEST(RecipesOfDocs, HavePatchesThatApply) {
    if (run_shell("", "git --version").status != 0) GTEST_SKIP() << "git is not installed";
    int count = 0;
    for (const auto& entry : fs::directory_iterator("tests/recipes")) {
        const ProgramResult run = run_shell("", "git apply --check " + quoted(entry.path().string()));
        EXPECT_EQ(run.status, 0) << "Make this change again by the recipe that the patch names: " << run.err;
        ++count;
    }
    EXPECT_GE(count, 2);
}

}  // namespace
}  // namespace twinlight::names_test
