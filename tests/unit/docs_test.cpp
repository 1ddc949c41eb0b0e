// docs/scene-language.md names every command of the table, and no other; docs/lighting.md names only symbols that exist; README names
// the systems that docs/testing.md lists.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "app/session/keys.h"
#include "base/image/file.h"
#include "render/programmable/export/shader_text.h"
#include "scene/command/command.h"
#include "scene/command/text.h"
#include "scene/scenes/load.h"
#include "scene/state/state.h"

namespace twinlight::docs_test {
namespace {

// "glFog{f,i}[v]" as glFogf, glFogfv, glFogi, glFogiv.
std::vector<std::string> expanded(const std::string& pattern) {
    const std::size_t open = pattern.find_first_of("{[");
    if (open == std::string::npos) return {pattern};
    const char closing = pattern[open] == '{' ? '}' : ']';
    const std::size_t close = pattern.find(closing, open);
    std::vector<std::string> choices{closing == ']' ? "" : std::string()};
    if (closing == ']') choices.emplace_back();
    for (const char c : pattern.substr(open + 1, close - open - 1)) {
        if (c == ',') {
            choices.emplace_back();
        } else {
            choices.back() += c;
        }
    }
    std::vector<std::string> names;
    for (const std::string& choice : choices) {
        for (const std::string& name : expanded(pattern.substr(0, open) + choice + pattern.substr(close + 1))) {
            names.push_back(name);
        }
    }
    return names;
}

TEST(Docs, NameEveryCommandOfAScene) {
    const std::string page = read_file("docs/scene-language.md");
    const std::size_t start = page.find("\n## Commands\n"), end = page.find("\n## ", start + 1);
    ASSERT_NE(start, std::string::npos);
    std::set<std::string> named;
    std::istringstream lines(page.substr(start, end - start));
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("| `")) continue;
        const std::string commands = line.substr(0, line.find(" | "));
        std::istringstream parts(commands);  // every second one stands in backquotes
        for (std::string part; std::getline(parts, part, '`');) {
            if (!part.starts_with("gl")) continue;
            for (const std::string& name : expanded(part)) {
                EXPECT_TRUE(named.insert(name).second) << name << " stands there twice";
                EXPECT_TRUE(find_command(name)) << name << " is no command";
            }
        }
    }
    for (const Signature& sig : signatures()) {
        if (sig.family == Family::kPragma) continue;
        EXPECT_TRUE(named.contains(std::string(sig.name))) << sig.name << " is missing";
    }
}

// ---- docs/lighting.md ----

// The GLSL that C++ writes: of a scene that calls for all sorts of lights, as it is exported.
std::string written_shaders() {
    const auto file = std::ranges::find(kSceneFiles, "commands.gl", &EmbeddedFile::name);
    programmable::Options options;
    options.shading = Shading::kPhong;
    return programmable::shader_source(make_frame(read_scene(file->text, "commands.gl", "commands"), {}), options);
}

// All C++ and GLSL below src, and the GLSL that C++ writes, without comments.
std::vector<std::string> code() {
    std::vector<std::string> files;
    const auto add = [&](const std::string& text) {
        std::istringstream lines(text);
        std::string& file = files.emplace_back();
        for (std::string line; std::getline(lines, line);) file += line.substr(0, line.find("//")) + "\n";
    };
    for (const auto& entry : std::filesystem::recursive_directory_iterator("src")) {
        const std::string extension = entry.path().extension();
        if (extension == ".h" || extension == ".cpp" || extension == ".glsl") add(read_file(entry.path()));
    }
    add(written_shaders());
    return files;
}

bool is_word_letter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// Whether the text has the word, or, where it ends in "...", one that starts so; with "(" after it for a function.
bool has_word(const std::string& text, std::string word) {
    const bool is_start = word.ends_with("...");
    if (is_start) word.resize(word.size() - 3);
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        const bool starts = at == 0 || !is_word_letter(text[at - 1]);
        if (starts && (is_start || word.ends_with('(') || end == text.size() || !is_word_letter(text[end])))
            return true;
    }
    return false;
}

// What the rows of tables have in backquotes: `f()`, `Class::member`, `u_FACE_...`.
std::set<std::string> symbols_of_tables(const std::string& page) {
    std::set<std::string> symbols;
    std::istringstream lines(page);
    const std::regex symbol("[A-Za-z_][A-Za-z0-9_]*(::[A-Za-z_][A-Za-z0-9_]*)?(\\(|\\.\\.\\.)?");
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("| ")) continue;
        std::istringstream parts(line);  // every second one stands in backquotes
        std::string part;
        for (bool is_quoted = false; std::getline(parts, part, '`'); is_quoted = !is_quoted) {
            if (!is_quoted) continue;
            for (std::sregex_iterator match(part.begin(), part.end(), symbol), end; match != end; ++match)
                symbols.insert(match->str());
        }
    }
    return symbols;
}

TEST(Docs, NameOnlySymbolsOfTheLightingThatExist) {
    const std::string text = read_file("docs/lighting.md");
    const std::size_t start = text.find("\n## Every symbol in the code\n");
    ASSERT_NE(start, std::string::npos);
    const std::string page = text.substr(start);  // the tables of the equation, and of what comes before and after it
    const std::set<std::string> symbols = symbols_of_tables(page);
    EXPECT_GT(symbols.size(), 40U);
    const std::vector<std::string> files = code();
    for (const std::string& symbol : symbols) {
        const std::size_t colons = symbol.find("::");
        const std::string member = colons == symbol.npos ? symbol : symbol.substr(colons + 2);
        const auto has_symbol = [&](const std::string& file) {
            const std::string type = symbol.substr(0, colons);
            return has_word(file, member) &&
                   (colons == symbol.npos || has_word(file, "struct " + type) || has_word(file, "class " + type));
        };
        EXPECT_TRUE(std::ranges::any_of(files, has_symbol))
            << "docs/lighting.md names " << symbol << ", which is not in src";
    }
}

// ---- The systems that were tried ----

// Those of the rows "| Debian 13 | trixie | g++ 14.2.0 | 25.0.7 | 2026-11-22 | ... | succeeded |". tools/in-clean-root.sh knows the releases.
std::set<std::string> tried_systems() {
    const std::string script = read_file("tools/in-clean-root.sh");
    std::set<std::string> systems;
    std::istringstream lines(read_file("docs/testing.md"));
    const std::regex row(
        R"(\| ((?:Debian|Ubuntu) (?:[0-9.]+|testing)) \| ([a-z]+) \| g\+\+ [0-9.]+ \| [^|]+ \| \d{4}-\d\d-\d\d \| .* succeeded[^|]*\|)");
    std::smatch cells;
    for (std::string line; std::getline(lines, line);) {
        if (!std::regex_match(line, cells, row)) continue;
        systems.insert(cells.str(1));
        EXPECT_NE(script.find("    " + cells.str(2) + ") name=\"" + cells.str(1) + "\""), std::string::npos) << line;
    }
    return systems;
}

TEST(Docs, ListTheKeysOfTheWindow) {
    std::string rows = "| key | what it does |\n|---|---|\n";
    for (const session::Key& key : session::keys())
        if (!key.label.empty()) rows += fmt::format("| {} | {} |\n", key.label, key.what);
    EXPECT_NE(read_file("docs/demo.md").find("\n\n" + rows + "\n"), std::string::npos) << rows;
}

TEST(Docs, NameTheSystemsThatWereTried) {
    for (const char* file : {"README.md", "README.zh-CN.md"}) {
        const std::string readme = read_file(file);
        const std::regex system("(Debian|Ubuntu) ([0-9]+([.][0-9]+)?|testing)");
        std::set<std::string> named;
        for (std::sregex_iterator match(readme.begin(), readme.end(), system), end; match != end; ++match)
            named.insert(match->str());
        EXPECT_GE(named.size(), 1U);
        EXPECT_EQ(named, tried_systems()) << file;
    }
}

}  // namespace
}  // namespace twinlight::docs_test
