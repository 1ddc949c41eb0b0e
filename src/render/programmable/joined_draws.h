// Joined Draws: neighbours in a frame that have the same state, so that they are planned, uploaded and drawn as one.
//
// A sphere is a Draw for each of its strips, and many programs call glBegin for each polygon. Whatever is drawn by itself
// needs a plan, uniforms and the driver's check of its state, which take longer than a few vertices.
#pragma once

#include <cstddef>
#include <span>
#include <unordered_set>
#include <vector>

#include "render/stages/elements.h"
#include "scene/frame/frame.h"

namespace twinlight::programmable {

// Draws that follow each other in a frame.
using DrawRun = std::span<const Draw* const>;
std::size_t count_vertices(DrawRun draws);

// Whether both Draws may be drawn by one program with the same numbers, one after the other. They may differ in their
// vertices, in what is replaced by the vertices' colours (2.14.3), and in whether they draw triangles or other polygons.
bool have_one_state(const Draw& a, const Draw& b);
// The same for Draws that are placed (below): they may also differ in their modelview matrices and materials.
bool have_one_state_when_placed(const Draw& a, const Draw& b);

// The same for Draws at any place that have the same materials.
bool have_one_state_anywhere(const Draw& a, const Draw& b);

// Longer runs are cut, because all vertices of a run are uploaded again if one of them has changed.
inline constexpr std::size_t kMostJoinedVertices = 4096;

struct JoinedDraws {
    Draw draw;  // the first Draw's state, and the vertices and indices of all
    std::vector<ElementsPart> parts;
};
JoinedDraws joined(DrawRun run);

// Placed Draws: small ones, each at its own place or of its own material, such as the leaves of a tree. Their vertices are
// brought to eye coordinates and bring their materials, which takes less time than a further Draw. All small Draws of a
// frame are placed, with neighbours or without, so that the same vertices always get the same floats.
inline constexpr std::size_t kMostPlacedVertices = 16;
bool may_be_placed(DrawRun run);  // of Draws with one state

// The Draws of a frame that are drawn more than once at the same place, where depths are tested for being equal: a second pass, such
// as one that adds light. Each pass may be placed or not, and then the depths would not be equal. So none of them is placed.
class DepthRepeats {
  public:
    explicit DepthRepeats(const Frame& frame);
    bool contains_any_of(DrawRun run) const;

  private:
    std::unordered_set<std::size_t> repeated_;  // keys of Draws
};

JoinedDraws placed_together(DrawRun draws);

inline ElementsPart part_of(const Draw& draw) {
    return {draw.mode, draw.vertices.size(), draw.indices.size(), cuts_quadrilaterals(draw)};
}

}  // namespace twinlight::programmable
