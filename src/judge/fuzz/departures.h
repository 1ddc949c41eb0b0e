// Where a driver is known to leave the specification's text (golden/known_differences), and where the text leaves the answer
// to rounding. The fuzzer leaves such cases out by name, and counts them.
#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "scene/command/command.h"
#include "scene/state/scene.h"

namespace twinlight::fuzz {

enum class Leaves : std::uint8_t {
    kFixedFunction,  // the driver's fixed function leaves the text; its shaders do not
    kDriver,         // both do: it stands behind the shaders
    kOpen,           // nobody does: the equation jumps there, and rounding decides
};

// Is handed the commands of a scene, one after the other, and says each time whether the departure shows in those so far.
using CommandRule = std::function<bool(const Command&)>;

// The first that is there says where it applies: anywhere in a scene, to a Draw, or to a vertex.
struct Departure {
    std::string_view name;
    std::string_view section;
    Leaves leaves = Leaves::kFixedFunction;
    CommandRule (*of_commands)() = nullptr;
    bool (*of_draw)(const Draw& draw) = nullptr;
    bool (*of_vertex)(const Draw& draw, const Vertex& vertex) = nullptr;
    std::string_view only_on{};  // a driver that is not the listed one's: golden/known_differences does not have it
};
const std::vector<Departure>& departures();

// What applies to a scene; asked vertex by vertex. `lifted`: names that are not left out.
class LeftOut {
  public:
    LeftOut(const CommandList& scene, const std::vector<std::string_view>& lifted);

    // Null where nothing applies. Those that are of shaders, too, come first.
    const Departure* at(const Draw& draw, const Vertex& vertex) const;
    const Departure* in(const Frame& frame) const;

  private:
    const Departure* find(const std::function<bool(const Departure&)>& applies) const;

    std::vector<const Departure*> asked_;  // of which a Draw or a vertex must be asked
    const Departure* of_all_ = nullptr;
};

// All that apply somewhere in a scene, but for those that rounding decides. Goes through its commands once.
std::vector<const Departure*> departures_in(const Scene& scene);

}  // namespace twinlight::fuzz
