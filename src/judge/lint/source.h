// The text of a scene: comments that silence rules, and statements.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "judge/lint/lint.h"

namespace twinlight::lint {

// The comments `// twinlight: allow(name, name)` of a text.
class Allowed {
  public:
    explicit Allowed(std::string_view source);
    bool has(std::string_view rule, int line) const;

  private:
    std::set<std::string, std::less<>> everywhere_;
    std::map<int, std::set<std::string, std::less<>>> on_line_;
};

// ---- Calls of a whole program that its first picture does not reach: in functions for keys, in branches not taken ----

// A call that sets a state: glLightfv(GL_LIGHT1, GL_DIFFUSE, ...) has the function glLight and these two names.
struct Setting {
    std::string function;
    std::vector<std::string> names;  // an argument that is no GL name, such as a variable, is empty: it may be any name
};

class CallsNotRun {
  public:
    explicit CallsNotRun(const CommandList& list);
    // Whether one of the calls fixes this warning. Then a key can fix it, and the program shows both on purpose.
    bool fix(const Warning& warning) const;

  private:
    std::vector<Setting> settings_;
};

// ---- Statements ----

// Without its blanks and comments, and with the places that it spans.
struct Statement {
    std::string text;
    Place first{}, last{};

    bool holds(const Place& place) const;
};

// The statements of a text that pass a test.
std::vector<Statement> statements_with(std::string_view source, bool (*test)(const std::string& statement));

}  // namespace twinlight::lint
