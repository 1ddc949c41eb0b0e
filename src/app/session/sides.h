// Sides: what differs between the two sides of the slider, and the switches for it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/session/session.h"

namespace twinlight::session {

// A row below the slider: one thing that can differ.
struct SideRow {
    enum class Kind : std::uint8_t { kShading, kVariants };
    Kind kind = Kind::kShading;
    bool differs = false;
    std::string text{}, short_text{};  // the second where the first is too long
};
// How many rows there are, without their words: the layout asks in each frame.
std::size_t side_row_count(const Session& session);
// Empty if both sides are the fixed function's, which has no choice. The variants have a row only if the scene uses some.
std::vector<SideRow> side_rows(const Session& session);
// Makes the sides differ in this, or no longer. The shaders' or the reference's side changes; of two, the right one.
void switch_side(Session& session, const SideRow& row);

}  // namespace twinlight::session
