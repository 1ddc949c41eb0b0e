// The planner: which effects a Draw calls for, why the others are left out, and how far a colour may be off by that.
//
// Nearly all that is left out is exactly nothing. Lights that are faint are left out too, as long as all of them together
// stay within PlanOptions::budget (render/effect/bounds.h says how they are bounded; docs/effects.md).
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "render/effect/effect_set.h"
#include "render/effect/vertex_facts.h"
#include "render/look.h"

namespace twinlight {

struct LeftOut {
    std::string what;  // "GL_LIGHT0's attenuation", "two-sided lighting"
    std::string why;   // "its constant, linear and quadratic factors are 1, 0, 0"
};

struct PlannedLight {
    int number = 0;  // of GL_LIGHTi
    // The part of att_i spot_i that is the same at every vertex: a constant attenuation, a directional light's spot.
    double constant_reach = 1;
};

// Why a light is in or out.
enum class LightFate : std::uint8_t {
    kIn,
    kDisabled,
    kBlack,         // the products of its colours and the material's are 0
    kReplaced,      // the texture takes the place of its colours
    kAmbientAlone,  // what it has is the same at every vertex, and in Plan::constant_ambient
    kOutsideCone,   // directional, and its direction is outside its cone
    kNoReach,       // attenuation factors of 0, 0, 0
    kConeMisses,    // by LightBound::deg
    kBehind,        // every normal faces away from it, by LightBound::deg
    kFaint,         // within the budget
};

struct LightBound {
    int number = 0;  // of light_name()
    LightFate fate = LightFate::kDisabled;
    double deg = 0;
    // What its terms add at most to a channel of the primary and the secondary colour together, before the clamp, wherever the
    // Draw is lit. Infinite where nothing bounds it. Without an ambient term that is in Plan::constant_ambient.
    glm::dvec3 bound{0};

    bool in() const { return fate == LightFate::kIn; }
    double largest() const { return std::max({bound.r, bound.g, bound.b}); }
};

// A sentence with its number: "its cone misses the sphere around the Draw by 12.3 degrees".
std::string reason(const LightBound& light);

struct Plan {
    EffectSet effects;
    VertexFacts vertices;           // of the Draw that it was made for
    std::vector<LeftOut> left_out;  // but for whole lights: those are in light_bounds

    std::vector<PlannedLight> lights;  // one for each of effects.lights
    // The ambient light that is the same at every vertex: a_cs and, of the lights whose ambient term nothing
    // weakens on its way, a_cli. Their ambient terms are called for nowhere else.
    glm::dvec3 constant_ambient{0};
    // The state in force: the Draw's, with the lecture's variants off if the options say so, and with a
    // colour that all vertices share put into the material which tracks it.
    LightingState lighting;

    // One for each light of the state, enabled or not, in their order; empty where nothing is lit.
    std::vector<LightBound> light_bounds;
    // How far a channel of a lit colour may be off, before the clamp and rounding, by what is left out though it is not nothing.
    double error_bound = 0;
    // What error_bound had to stay within: the options', or 0 where blending may add errors up.
    double budget = 0;
};

struct PlanOptions : Look {
    // How far a colour's channel may be off, before rounding to codes, by what is left out because it is small;
    // 0: only what is exactly nothing. The default is half of what rounding to 8 bits hides.
    double budget = 0.5 / 255;
    // Where a scene has spectra: false lights every vertex or fragment in all samples, as if materials varied from point to
    // point. The picture is the same: for who asks what samples cost (judge/study/spectral.h).
    bool fold_spectra = true;
};

Plan plan_effects(const Draw& draw, const PlanOptions& options);
// The same for who keeps the facts of vertices that stay as they are: then the cost does not grow with their number.
Plan plan_effects(const Draw& draw, const PlanOptions& options, const VertexFacts& vertices);

// The lights that are out, as Plan::left_out has the rest.
std::vector<LeftOut> lights_left_out(const Plan& plan);

}  // namespace twinlight
