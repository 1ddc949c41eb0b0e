// The choices that a study holds against each other: how a scene is drawn, in its finest detail or with less.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "state/frame.h"

namespace twinlight::study {

// What of the lighting is done more simply than the scene says (2.14.1's factors, one by one).
enum class Without : std::uint8_t {
    kNothing,
    kSpecular,     // no highlights
    kLocalViewer,  // the viewer at infinity
    kPlaces,       // lights directional: in the direction in which the middle of the shape sees them
    kAttenuation,  // att_i = 1
    kSpots,        // spot_i = 1
    kNormalize,    // normals as they come, without GL_NORMALIZE and GL_RESCALE_NORMAL
};

struct Choice {
    std::string renderer;  // "fixed", "programmable" or "reference"
    Shading shading = Shading::kGouraud;
    Tier tier = Tier::kUniform;
    int slices = 0;  // 0: as the scene has them, or none at all (exact surfaces)
    Without without = Without::kNothing;
    double budget = RenderOptions{}.budget;

    // "gouraud, 32 slices, shaders with uniforms"
    std::string words() const;
    // The same for files and keys: "programmable-gouraud-32"
    std::string key() const;
    RenderOptions options() const;

    friend bool operator==(const Choice&, const Choice&) = default;
};

const char* name_of(Shading shading);

// All that are worth a look for this scene; `has_slices`: whether its meshes can be made finer or coarser.
enum class Extent : std::uint8_t { kQuick, kFull };
std::vector<Choice> choices(const Frame& frame, bool has_slices, Extent extent);

// The frame with less.
Frame simplified(const Frame& frame, Without without);

}  // namespace twinlight::study
