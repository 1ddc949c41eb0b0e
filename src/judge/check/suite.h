// Holds cases against what the driver's fixed function, the shaders and the reference give.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "judge/check/case.h"
#include "judge/compare/shader_context.h"
#include "render/path.h"

namespace twinlight::check {

enum class Outcome : std::uint8_t {
    kNotAsked,  // the fixed function, where all is about what GL does not have
    kPass,
    kRuling,  // the specification leaves the answer open: programmable and reference give what Twinlight rules, fixed something
    kDeparts,   // as the case lists for this driver
    kNew,       // a departure that no list knows
    kVanished,  // one that the list has and the driver no longer shows
};
inline constexpr std::size_t kOutcomes = 6;
std::string_view word_of(Outcome outcome);  // "not asked", "pass", "ruling", "departs", "NEW", "VANISHED"
inline bool is_failure(Outcome outcome) { return outcome == Outcome::kNew || outcome == Outcome::kVanished; }

// What is not as expected, or a departure that is gone.
struct Finding {
    Path path{};
    std::string variant;  // "baked", "float"; empty for fixed
    Outcome outcome{};
    Spot spot;
    std::optional<Seen> value;  // nothing where it is not shown
    Seen expected;
    std::string name;  // of a known departure
};

// What a reader should see of a finding: which value, which is right, and why.
std::string finding_text(const Case& of, const Finding& finding);

struct Result {
    std::array<Outcome, kPaths> outcomes{};
    std::vector<Finding> findings;
    long non_finite = 0;  // of programmable and reference
    // How far the shaders are from the reference in long double, at the places that the case names.
    double from_long_double = 0;
    std::string error;  // of a scene that GL or a renderer refuses
    std::vector<std::pair<std::string, Image>>
        pictures{};  // by who drew them; of a case about vertices see draw_vertices()

    bool fails() const;
};

class Suite {
  public:
    // Throws std::runtime_error that says what the driver refused.
    Suite();

    const std::string& driver() const { return driver_; }
    // In the order of the cases.
    std::vector<Result> run(std::span<const Case> cases);
    // Pictures of a case about vertices: fixed, programmable and reference, of so few pixels that a point can be seen.
    void draw_vertices(const Case& of, Result& result);

  private:
    void run_vertices(std::span<const Case> cases, std::vector<Result>& results);
    void run_pictures(std::span<const Case> cases, std::vector<Result>& results);

    compare::ShaderContext context_;
    std::string driver_;
};

}  // namespace twinlight::check
