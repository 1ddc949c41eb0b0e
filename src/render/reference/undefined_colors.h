// The vertices whose colour the specification leaves undefined. The reference draws them by RULINGs; other renderers may have any
// colour there.
#pragma once

#include <optional>
#include <string_view>

#include "render/reference/staged_frame.h"

namespace twinlight::reference {

// Why a lit vertex has no colour: what is divided by 0.
enum class Undefined {
    kNormalMatrix,    // the modelview matrix has no inverse (2.11.3)
    kNormal,          // GL_NORMALIZE of (0, 0, 0) (2.11.3)
    kAttenuation,     // k_0 + k_1 d + k_2 d^2 is 0 (2.14.1)
    kLightDirection,  // the light is at the vertex, or its direction is (0, 0, 0) (2.14.1)
    kSpotDirection,   // GL_SPOT_DIRECTION is (0, 0, 0) (2.14.1)
};
std::string_view words_of(Undefined undefined);

// nullopt: the vertex has a colour.
std::optional<Undefined> undefined_color(const Draw& draw, const Vertex& vertex);
// The first in the frame; nullopt if all vertices have colours.
std::optional<Undefined> first_undefined_color(const Frame& frame);

// Fills StagedFrame::undefined.
void mark_undefined_colors(StagedFrame& stages);

}  // namespace twinlight::reference
