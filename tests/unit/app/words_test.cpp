// Keeps worn phrases out of everything that the programs print: every --help, the string literals of src/, the pages' text, the
// Makefile's help lines and messages.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "../run_program.h"
#include "base/image/file.h"

namespace twinlight::words_test {
namespace {

struct Phrase {
    std::string_view worn;  // in lower case; matched as whole words, in any case
    std::string_view write;
};

constexpr Phrase kPhrases[] = {
    {"tells", "shows, is"},
    {"told", "shown, reported"},
    {"stands", "is"},
    {"anew", "again"},
    {"alone", "only"},
    {"judged", "compared; decides the verdict"},
    {"departs", "violates the specification; has a bug"},
    {"depart", "violate the specification; have a bug"},
    {"vanished", "fixed bug"},
    {"not asked", "not tested"},
    {"slack", "allowed difference"},
    {"freedom", "allowed difference"},
    {"the truth", "the exact picture, the reference"},
    {"255 codes", "/255"},
    {"by one code", "by 1/255"},
    {"one code off", "off by 1/255"},
    {"is simulated", "is used"},
    {"not the rest", "the others are skipped"},
    {"ways against each other", "across the three renderers"},
    {"against each other", "with each other"},
    {"held against", "compared with"},
    {"hold against", "compare with"},
    {"is of the shaders", "applies only to shaders"},
    {"are of the shaders", "apply only to shaders"},
    {"unless given", "(default: ...)"},
    {"left altogether", "skipped in total"},
    {"one of both", "one of the two"},
    {"goes the difference", "brighter means a larger difference"},
    {"goes the absolute difference", "brighter means a larger difference"},
    {"beaten by no other", "nothing is both faster and more accurate"},
    {"of that form", "such files: case files"},
    {"of one's own", "your own"},
    {"off by nothing", "changes no pixel"},
    {"what is nothing", "what changes no pixel"},
    {"leaves the text", "violates the specification"},
    {"the text says", "section ... requires"},
    {"keeps to the text", "follows the specification"},
    {"which gl has not", "that GL lacks"},
    {"has no list", "is not listed"},
    {"is in no list", "is not listed"},
    {"are in no list", "are not listed"},
    {"with its place", "with file, line and column"},
    {"without a place", "w is 0"},
    {"not at hand", "missing"},
    {"is not done by", "is not drawn by"},
    {"in the place of", "instead of"},
    {"ahead of", "before"},
    {"broken off", "stopped early"},
    {"go on with", "continue"},
    {"goes on with", "continues"},
    {"comes of", "results from"},
    {"asked of", "required of"},
    {"said otherwise", "written differently"},
    {"otherwise than", "differently from"},
    {"that is none", "that is not one"},
    {"that are none", "that are not"},
    {"is no json", "is not JSON"},
    {"and none is given", "(default: ...)"},
    {"where none is given", "(default: ...)"},
    {"0 fine", "0 success"},
    {"bad input or use", "bad input or usage"},
    {"made if it is not there", "created if it does not exist"},
    {"does not suffice", "is not enough"},
    {"do not suffice", "are not enough"},
    {"one argument too many", "unexpected argument"},
    {"lacks its value", "needs a value"},
    {"calls for", "needs"},
    {"called for", "needed"},
    {"is off by at most", "differs by at most"},
    {"made unit", "normalised"},
    {"by nothing", "by zero"},
    {"lies in each other", "coincides"},
    {"lie in each other", "coincide"},
    {"map of depths", "shadow map"},
    {"maps of depths", "shadow maps"},
    {"texture of depths", "depth texture"},
    {"textures of depths", "depth textures"},
    {"of the time of", "at the time of"},
    {"in another way", "differently"},
    {"each have another", "each have a different"},
    {"the scene to start from", "the starting scene"},
    {"compares so", "compares this way"},
    {"is no struct", "is not a struct"},
    {"mend it", "fix it"},
};

// What a reader sees of a file: its string literals or its text, with the line that each character is on.
struct Text {
    std::string text;
    std::vector<int> lines;

    void add(char c, int line) {
        text += std::isspace(static_cast<unsigned char>(c)) != 0 ? ' ' : c;
        lines.push_back(line);
    }
};

bool is_word_letter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// Reads C++ or JavaScript. Literals with nothing but blanks and comments between them are one text.
class Literals {
  public:
    explicit Literals(std::string_view source) : source_(source) {
        while (at_ < source_.size()) read_token();
    }
    const std::vector<Text>& texts() const { return texts_; }

  private:
    bool starts(std::string_view word) const { return source_.substr(at_).starts_with(word); }
    char take() {
        const char c = source_[at_++];
        if (c == '\n') ++line_;
        return c;
    }
    void skip_past(std::string_view end) {
        while (at_ < source_.size() && !starts(end)) take();
        for (std::size_t i = 0; i < end.size() && at_ < source_.size(); ++i) take();
    }

    void read_token() {
        const char c = source_[at_];
        const bool begins_word = at_ == 0 || !is_word_letter(source_[at_ - 1]);
        if (starts("//") || starts("#include")) return skip_past("\n");
        if (starts("/*")) return skip_past("*/");
        if (begins_word && starts("R\"")) return read_raw();
        if (c == '"' || c == '`') return read_literal(c);
        if (c == '\'' && begins_word) return skip_character();  // not the ' of 1'000
        if (std::isspace(static_cast<unsigned char>(c)) == 0) joins_ = false;
        take();
    }
    Text& text() {
        if (!joins_) texts_.emplace_back();
        joins_ = true;
        return texts_.back();
    }
    void read_literal(char quote) {
        Text& text = this->text();
        for (take(); at_ < source_.size() && source_[at_] != quote;) {
            char c = take();
            if (c == '\\' && at_ < source_.size()) {
                c = take();
                if (c == 'n' || c == 't' || c == 'r') c = ' ';
            }
            text.add(c, line_);
        }
        if (at_ < source_.size()) take();
    }
    void read_raw() {
        const std::size_t open = source_.find('(', at_);
        const std::string end = ")" + std::string(source_.substr(at_ + 2, open - at_ - 2)) + "\"";
        Text& text = this->text();
        while (at_ <= open) take();
        while (at_ < source_.size() && !starts(end)) {
            const int line = line_;
            text.add(take(), line);
        }
        skip_past(end);
    }
    void skip_character() {
        for (take(); at_ < source_.size() && source_[at_] != '\'';)
            if (take() == '\\') take();
        if (at_ < source_.size()) take();
        joins_ = false;
    }

    std::string_view source_;
    std::size_t at_ = 0;
    int line_ = 1;
    bool joins_ = false;  // whether a literal here continues the last one
    std::vector<Text> texts_;
};

std::vector<Text> whole(std::string_view source) {
    Text text;
    int line = 1;
    for (const char c : source) {
        text.add(c, line);
        if (c == '\n') ++line;
    }
    return {text};
}

// The help lines, and what recipes and $(error ...) print.
std::vector<Text> of_makefile(std::string_view source) {
    std::vector<Text> texts;
    int number = 1;
    for (std::size_t at = 0; at < source.size(); ++number) {
        const std::size_t end = std::min(source.find('\n', at), source.size());
        const std::string_view line = source.substr(at, end - at);
        const std::size_t begin = std::min({line.find("## "), line.find("echo "), line.find("$(error ")});
        if (begin != line.npos) {
            Text& text = texts.emplace_back();
            for (const char c : line.substr(begin)) text.add(c, number);
        }
        at = end + 1;
    }
    return texts;
}

// "FILE:3: 'told'; write: shown, reported": a line for each phrase found.
std::string worn_phrases(const std::string& file, const std::vector<Text>& texts) {
    std::string found;
    for (const Text& text : texts) {
        std::string lower;  // blanks between words are one
        std::vector<int> lines;
        for (std::size_t i = 0; i < text.text.size(); ++i) {
            if (text.text[i] == ' ' && lower.ends_with(' ')) continue;
            lower += static_cast<char>(std::tolower(static_cast<unsigned char>(text.text[i])));
            lines.push_back(text.lines[i]);
        }
        for (const auto& [worn, write] : kPhrases) {
            for (std::size_t at = lower.find(worn); at != lower.npos; at = lower.find(worn, at + 1)) {
                const std::size_t end = at + worn.size();
                if ((at > 0 && is_word_letter(lower[at - 1])) || (end < lower.size() && is_word_letter(lower[end])))
                    continue;
                found += file + ":" + std::to_string(lines[at]) + ": '" + std::string(worn) +
                         "'; write: " + std::string(write) + "\n";
            }
        }
    }
    return found;
}

TEST(Words, AreFoundInLiteralsOnly) {
    const auto found = [](std::string_view source) { return worn_phrases("a.cpp", Literals(source).texts()); };
    const std::string told = "a.cpp:2: 'told'; write: shown, reported\n";
    EXPECT_EQ(found("int a;\nf(\"as it was told\");"), told);
    EXPECT_EQ(found("\nf(\"Told: 1\");"), told) << "in any case";
    EXPECT_EQ(found("\nf(R\"x(it \"is\" told)x\");"), told);
    EXPECT_EQ(found("\nf(`it is told`);"), told);
    EXPECT_EQ(found("x = 1'000;\nf(\"told\");"), told) << "after a digit separator";
    EXPECT_EQ(found("c = '\"';\nf(\"told\");"), told) << "after a quote as a character";
    EXPECT_EQ(found("f(\"\\\"\");\nf(\"told\");"), told) << "after an escaped quote";
    EXPECT_EQ(found("f(\"held\"\n  // a comment\n  \" against it\");"),
              "a.cpp:1: 'held against'; write: compared with\n")
        << "across lines";
    EXPECT_EQ(found("// it is told\n/* \"told\" */ #include \"told.h\"\nint told;"), "");
    EXPECT_EQ(found("f(\"toldness, untold, told_by\"); f(\"held\", \" against\");"), "");
}

TEST(Words, AreFoundInPagesAndTheMakefile) {
    EXPECT_EQ(worn_phrases("a.html", whole("<p>\nThe driver\ndeparts</p>")),
              "a.html:3: 'departs'; write: violates the specification; has a bug\n");
    const std::string makefile = "# draws it anew\nall: ## draw it anew\n\t@draw anew; echo \"drawn anew\"\n";
    EXPECT_EQ(worn_phrases("Makefile", of_makefile(makefile)),
              "Makefile:2: 'anew'; write: again\nMakefile:3: 'anew'; write: again\n");
}

TEST(Words, OfTheSourcesAreNotWorn) {
    int files = 0;
    std::string found;
    for (const char* file : {"Makefile", "tools/deps.sh", ".ci/run"})
        found += worn_phrases(file, of_makefile(read_file(file)));
    for (const auto& entry : std::filesystem::recursive_directory_iterator("src")) {
        const std::string path = entry.path().generic_string(), kind = entry.path().extension();
        if (path.ends_with("chinese.def")) continue;  // its English texts are those of other files
        std::vector<Text> texts;
        if (kind == ".cpp" || kind == ".h" || kind == ".def" || kind == ".js")
            texts = Literals(read_file(path)).texts();
        else if (kind == ".html")
            texts = whole(read_file(path));
        else
            continue;
        found += worn_phrases(path, texts);
        ++files;
    }
    EXPECT_GT(files, 100);  // the test does read files
    EXPECT_TRUE(found.empty()) << found;
}

TEST(Words, OfEveryHelpAreNotWorn) {
    std::string found;
    for (const char* command : {"", "render", "compare", "explain", "export", "scenes", "study", "fuzz", "check"}) {
        std::vector<std::string> arguments = {command, "--help"};
        if (arguments[0].empty()) arguments.erase(arguments.begin());
        const ProgramResult result = run_program("twinlight", arguments);
        ASSERT_EQ(result.status, 0);
        found += worn_phrases(std::string("twinlight ") + command + " --help", whole(result.out));
    }
    const ProgramResult demo = run_program("twinlight-demo", {"--help"});
    ASSERT_EQ(demo.status, 0);
    found += worn_phrases("twinlight-demo --help", whole(demo.out));
    EXPECT_TRUE(found.empty()) << found;
}

}  // namespace
}  // namespace twinlight::words_test
