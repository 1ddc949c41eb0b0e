// Where a driver is known to leave the specification's text (golden/known_differences), and where the text leaves the answer
// to rounding. `compare` names the first on the drivers where they were seen; the fuzzer leaves both out by name, and counts them.
#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "render/context/driver_name.h"
#include "scene/command/command.h"
#include "scene/state/scene.h"

namespace twinlight::compare {

enum class Leaves : std::uint8_t {
    kFixedFunction,  // the driver's fixed function leaves the text; its shaders do not
    kDriver,         // both do: it stands behind the shaders
    kOpen,           // nobody does: the equation jumps there, and rounding decides
};

// Is handed the commands of a scene, one after the other, and says each time whether the departure shows in those so far.
using CommandRule = std::function<bool(const Command&)>;

// A driver on which a departure was seen, and the release of Mesa: "Mesa 22.3" stands for all its patches.
struct SeenOn {
    std::string_view driver, version;
};

struct Departure {
    std::string_view name;
    std::string_view section;
    Leaves leaves = Leaves::kFixedFunction;
    std::span<const SeenOn> seen_on{};  // empty: of no driver in particular
    // The first that is there says where it applies: anywhere in a scene, to a Draw, or to a vertex.
    CommandRule (*of_commands)() = nullptr;
    bool (*of_draw)(const Draw& draw) = nullptr;
    bool (*of_vertex)(const Draw& draw, const Vertex& vertex) = nullptr;

    bool is_known_on(const Driver& driver) const;
    // Whether a driver that was not measured, or in another version, may show it as well.
    bool may_show_on(const Driver& driver) const;
};
const std::vector<Departure>& departures();

// Whether departures of this driver in this version are listed at all.
bool is_listed(const Driver& driver);

// All that this driver is known to show somewhere in a scene. Goes through its commands once.
std::vector<const Departure*> known_departures_in(const Scene& scene, const Driver& driver);

// What the fuzzer leaves out of a scene; asked vertex by vertex. `lifted`: names that are not left out.
class DeparturesOfScene {
  public:
    DeparturesOfScene(const CommandList& scene, const Driver& driver, const std::vector<std::string_view>& lifted);

    // Null where nothing applies. Those that are of shaders, too, come first.
    const Departure* at(const Draw& draw, const Vertex& vertex) const;
    const Departure* in(const Frame& frame) const;

  private:
    const Departure* find(const std::function<bool(const Departure&)>& applies) const;

    std::vector<const Departure*> asked_;  // of which a Draw or a vertex must be asked
    const Departure* of_all_ = nullptr;
};

}  // namespace twinlight::compare
