// Departures: known bugs of drivers (golden/known_differences), and cases where the specification leaves the result to rounding.
// `compare` names the bugs of the driver in use; the fuzzer skips both kinds by name, and counts them.
#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "judge/compare/releases.h"
#include "judge/compare/rewrites.h"
#include "render/context/driver_name.h"
#include "scene/command/command.h"
#include "scene/frame/scene.h"

namespace twinlight::compare {

enum class Cause : std::uint8_t {
    kFixedFunction,  // a bug of the driver's fixed function only; shaders are right
    kDriver,         // a bug of the driver behind the vertex stage, so that shaders show it too
    kUnspecified,    // no bug: the formula jumps and rounding decides, or the specification gives no result
};

// Called with each command of a scene in order; returns whether the departure may show in the commands so far.
using CommandRule = std::function<bool(const Command&)>;
// The functions of departure_rules.h.
using MakeCommandRule = CommandRule();
using DrawRule = bool(const Draw& draw);
using VertexRule = bool(const Draw& draw, const Vertex& vertex);

// A driver on which a departure was seen, and its releases that have it: without limits, all.
struct SeenOn {
    std::string_view driver;
    Releases releases{};
};

struct Departure {
    std::string_view name;
    std::string_view section;
    Cause cause = Cause::kFixedFunction;
    std::span<const SeenOn> seen_on{};  // empty: not a bug of any driver
    // One of these is set: a rule for the whole scene, for a Draw, or for a vertex.
    MakeCommandRule* command_rule = nullptr;
    DrawRule* draw_rule = nullptr;
    VertexRule* vertex_rule = nullptr;
    std::span<const SeenOn> crashes_on{};  // drivers that may crash there
    const Rewrite* rewrite = nullptr;      // takes the bug out of a scene; null if no rewrite is known
    std::string_view where{};              // the cause in Mesa's source, as read in 2026; empty if nobody has looked

    // A release that was not measured counts as one that was (releases.h).
    bool is_known_on(const Driver& driver) const;
    // Whether a driver that was not measured may show it as well.
    bool may_show_on(const Driver& driver) const;
    bool may_crash_on(const Driver& driver) const;
};
const std::vector<Departure>& departures();
const Departure* find_departure(std::string_view name);  // null if there is none
// Whether it may show in the Draw. One with a rule for the whole scene may in any.
bool may_show_in(const Departure& departure, const Draw& draw);

// Whether any departures are listed for this driver.
bool is_listed(const Driver& driver);
// Whether they were measured on this very release, so that each of them must show.
bool is_measured(const Driver& driver);

// The known bugs of this driver that may show in the scene. Reads the scene's commands once.
std::vector<const Departure*> known_departures_in(const Scene& scene, const Driver& driver);

// The departures that the fuzzer skips in a scene. `lifted`: names of departures that are not skipped.
class DeparturesOfScene {
  public:
    DeparturesOfScene(const CommandList& scene, const Driver& driver, const std::vector<std::string_view>& lifted);

    // The departure that applies, or null. Those that affect shaders too come first.
    const Departure* at(const Draw& draw, const Vertex& vertex) const;
    const Departure* in(const Frame& frame) const;
    // A departure that may crash the driver, so that it should not draw the frame; null if no known one may.
    const Departure* crash_in(const Frame& frame) const;

  private:
    const Departure* find(const std::function<bool(const Departure&)>& applies) const;

    std::vector<const Departure*> local_;  // those with a rule for a Draw or a vertex
    const Departure* in_commands_ = nullptr;
    const Departure* crash_in_commands_ = nullptr;
    Driver driver_;
};

}  // namespace twinlight::compare
