// docs/scene-language.md names every command of the table, and none that is not there.
#include <gtest/gtest.h>

#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "base/image/file.h"
#include "scene/command/command.h"

namespace twinlight {
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

}  // namespace
}  // namespace twinlight
