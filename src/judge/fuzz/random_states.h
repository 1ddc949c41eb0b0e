// Random scenes, made with all kinds of commands.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "judge/compare/departure_rules.h"
#include "judge/fuzz/random.h"
#include "scene/command/command.h"

namespace twinlight::fuzz {

// The seed of one random scene. Scenes with the same structure need the same program of the driver (same lights, of the
// same type, ...) and differ only in values, because a driver takes a tenth of a second to make a program.
struct Seed {
    std::uint64_t structure = 0;
    std::uint64_t values = 0;
    // A known bug of compare::departures() that the scene is likely to show. Empty: one in ten structures shows any of
    // them.
    std::string_view departure{};
};

// The known bug that a scene is meant to show, or none.
class ShownBug {
  public:
    explicit ShownBug(const compare::Departure* departure = nullptr) : departure_(departure) {}

    bool is_none() const { return !departure_; }
    // Whether it is that of this rule (departure_rules.h): each bug has a rule of its own.
    bool is(compare::MakeCommandRule* rule) const { return departure_ && departure_->command_rule == rule; }
    bool is(compare::DrawRule* rule) const { return departure_ && departure_->draw_rule == rule; }
    bool is(compare::VertexRule* rule) const { return departure_ && departure_->vertex_rule == rule; }
    template <class... Rules>
    bool is_any(Rules*... rules) const {
        return (is(rules) || ...);
    }

  private:
    const compare::Departure* departure_;
};
ShownBug departure_of(const Seed& seed, Random& structure);

// A scene that varies everything in the equation of 2.14.1: random lights, materials, light model, colour material,
// matrices, normals and colours. One primitive with three vertices in different corners of the view. Values are of
// moderate size and no coordinate is 0, unless the scene is meant to show a known bug.
CommandList lighting_state(const Seed& seed);

// A scene at the limits of the equation: one point, whose numbers have all magnitudes, with one to eight lights. For the oracle.
CommandList extreme_state(const Seed& seed);

// A scene that varies everything between vertices and pixels: a few batches in a perspective view, with random
// primitives, textures, environments, fog, blending, tests, masks, clip planes, offsets, widths. All numbers are of
// moderate size.
CommandList fragment_state(const Seed& seed);

// The text of bitmaps or a pixel rectangle, and their state, at the end of a scene. is_of_labels(): whether they are likely to
// show this known bug.
std::string label(Random& random, const ShownBug& departure);
bool is_of_labels(const ShownBug& departure);

// The same for glCopyPixels.
std::string pixel_copy(Random& random, const ShownBug& departure);
bool is_of_pixel_copies(const ShownBug& departure);
// The same for stencil values of glDrawPixels and glCopyPixels.
std::string stencil_pixels(Random& random, const ShownBug& departure);
bool is_of_stencil_pixels(const ShownBug& departure);

// The same scene, rewritten with display lists, vertex arrays, attribute stacks and matrix stacks. The picture must not
// change.
CommandList disguised(const CommandList& scene, Random& random);

}  // namespace twinlight::fuzz
