// Holds cases against what the driver's fixed function, the shaders and the reference give.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "check/case.h"
#include "context/context.h"
#include "programmable/programmable.h"

namespace twinlight::check {

enum class Path : std::uint8_t { kFixed, kProgrammable, kReference };
inline constexpr std::size_t kPaths = 3;
inline constexpr std::array<std::string_view, kPaths> kPathNames = {"fixed", "programmable", "reference"};

enum class Verdict : std::uint8_t {
    kPass,
    kRuling,  // the specification leaves the answer open: programmable and reference give what Twinlight rules, fixed something
    kDeparts,   // as the case lists for this driver
    kNew,       // a departure that no list knows
    kVanished,  // one that the list has and the driver no longer shows
};
std::string_view word_of(Verdict verdict);  // "pass", "ruling", "departs", "NEW", "VANISHED"
inline bool is_failure(Verdict verdict) { return verdict == Verdict::kNew || verdict == Verdict::kVanished; }

// A colour that is not the expected one, or a departure that is gone.
struct Finding {
    Path path{};
    std::string variant;  // "baked", "float"; empty for fixed
    Verdict verdict{};
    Spot spot;
    std::optional<glm::dvec4> value;  // nothing where it is not shown
    glm::dvec4 expected{0};
    std::string name;  // of a known departure
};

struct Result {
    std::array<Verdict, kPaths> verdicts{};
    std::vector<Finding> findings;
    long non_finite = 0;                                    // of programmable and reference
    std::string error;                                      // of a scene that GL or a renderer refuses
    std::vector<std::pair<std::string, Image>> pictures{};  // of a case about pixels, by who drew them

    bool fails() const;
};

// "(0.25, 0, 0, 1)", "nothing"
std::string color_text(const std::optional<glm::dvec4>& color);

class Suite {
  public:
    // Throws std::runtime_error that says what the driver refused.
    Suite();
    ~Suite();
    Suite(const Suite&) = delete;
    Suite& operator=(const Suite&) = delete;

    const std::string& driver() const { return driver_; }
    // In the order of the cases.
    std::vector<Result> run(std::span<const Case> cases);

  private:
    void run_vertices(std::span<const Case> cases, std::vector<Result>& results);
    void run_pictures(std::span<const Case> cases, std::vector<Result>& results);

    std::unique_ptr<OffscreenContext> context_;
    std::optional<programmable::Renderer> renderer_;  // dies before the context
    std::string driver_;
};

}  // namespace twinlight::check
