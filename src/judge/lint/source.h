// The text of a scene: comments that silence rules, and statements.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

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

}  // namespace twinlight::lint
