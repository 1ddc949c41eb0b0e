// Runs the hard cases on the driver's fixed function, the shaders and the reference, and compares the results with what
// is expected.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "judge/check/case.h"
#include "judge/check/variants.h"
#include "judge/compare/shader_context.h"
#include "judge/compare/vertex_colors.h"
#include "render/path.h"

namespace twinlight::check {

enum class Outcome : std::uint8_t {
    kNotTested,  // "not tested": the case needs a feature that GL's fixed function lacks, or the driver may crash
    kPass,
    kOurChoice,  // "our choice": the fixed function gives another answer where the specification is silent
    kKnownBug,   // "known bug": a wrong answer that the case lists for this driver
    kNewBug,     // "new bug": a wrong answer that is not listed
    kFixedBug,   // "fixed bug": the right answer where a wrong one is listed
};
inline constexpr std::size_t kOutcomes = 6;
std::string_view word_of(Outcome outcome);  // the words above; "pass"
inline bool is_failure(Outcome outcome) { return outcome == Outcome::kNewBug || outcome == Outcome::kFixedBug; }

// One place where a result is not as expected, or where a known bug is fixed.
struct Finding {
    Path path{};
    std::string variant;  // "baked", "float"; empty for fixed
    Outcome outcome{};
    Spot spot;
    std::optional<Seen> value;  // none where the renderer shows nothing
    Seen expected;
    std::string name{};  // of the listed bug; empty where none is listed
    std::string note{};  // where it is listed for another release: "measured on Mesa 26.1; this is 26.2.0"
};

// One line for a reader: the value, the expected value, and why.
std::string finding_text(const Case& hard_case, const Finding& finding);

struct Result {
    std::array<Outcome, kPaths> outcomes{};
    std::vector<Finding> findings;
    long non_finite = 0;  // NaN or infinite results of the shaders and the reference
    // The largest difference between the shaders and the reference in long double, at the places that the case names.
    double from_long_double = 0;
    std::string error;  // why GL, a renderer or the driver rejects the scene; empty: none does
    std::vector<std::pair<std::string, Image>>
        pictures{};  // with the renderer's name; for a case that tests vertices see draw_vertices()

    bool fails() const;
};

class Suite {
  public:
    // Throws std::runtime_error where the driver refuses a context.
    Suite();

    const std::string& driver() const { return driver_; }
    // One result for each case, in the same order.
    std::vector<Result> run(std::span<const Case> cases);
    // Adds the pictures of a case that tests vertices: kVertexSide pixels wide and high, so that a point can be seen.
    void draw_vertices(const Case& hard_case, Result& result);

  private:
    void run_vertices(std::span<const Case> cases, std::vector<Result>& results);
    std::vector<std::vector<compare::Color>> shader_colors(std::vector<std::optional<compare::VertexScene>>& scenes,
                                                           const ShaderVariant& variant, std::vector<Result>& results);
    void run_pictures(std::span<const Case> cases, std::vector<Result>& results);

    compare::ShaderContext context_;
    std::string driver_;
};

}  // namespace twinlight::check
