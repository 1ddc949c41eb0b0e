// The planner: which effects a Draw needs, why the others are left out, and how large the error of a colour is at most.
//
// Nearly everything that is left out adds exactly nothing. Faint lights are left out too, as long as their sum stays
// within PlanOptions::budget (render/effect/bounds.h computes the bounds; docs/effects.md).
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "base/text/translation.h"
#include "render/effect/effect_set.h"
#include "render/effect/vertex_facts.h"
#include "render/look.h"

namespace twinlight {

struct LeftOut {
    std::string what;     // "GL_LIGHT0's attenuation", "two-sided lighting"
    std::string why;      // "its constant, linear and quadratic factors are 1, 0, 0"
    bool is_off = false;  // the scene does not turn it on
};

struct PlannedLight {
    int number = 0;  // of GL_LIGHTi
    // The part of att_i spot_i that is the same at every vertex: a constant attenuation, a directional light's spot.
    double constant_reach = 1;
};

// Why a light is kept or left out.
enum class LightFate : std::uint8_t {
    kIn,
    kDisabled,
    kBlack,        // its colours times the material's are 0
    kReplaced,     // the texture replaces the colours it would add
    kAmbientOnly,  // it has only a constant ambient term, which is part of Plan::constant_ambient
    kOutsideCone,  // directional, and its direction is outside its cone
    kNoReach,      // attenuation factors of 0, 0, 0
    kConeMisses,   // by LightBound::deg
    kBehind,       // every normal faces away from it, by LightBound::deg
    kFaint,        // its bound fits into the budget
};

struct LightBound {
    int number = 0;  // for light_name()
    LightFate fate = LightFate::kDisabled;
    double deg = 0;
    // The most that its terms add to a channel of the primary and secondary colour together, before the clamp, anywhere
    // on the Draw. Infinite if there is no bound. Without an ambient term that is part of Plan::constant_ambient.
    glm::dvec3 bound{0};

    bool in() const { return fate == LightFate::kIn; }
    double largest() const { return std::max({bound.r, bound.g, bound.b}); }
};

// A sentence with its number: "its cone misses the draw's bounding sphere by 12.3 degrees".
std::string reason(const LightBound& light);

struct Plan {
    EffectSet effects;
    VertexFacts vertices;  // of the Draw that it was made for
    std::vector<LeftOut>
        left_out;  // except whole lights, which are in light_bounds; empty without PlanOptions::reasons
    bool has_reasons = true;
    bool for_any_pose = false;  // PlanOptions::for_any_pose

    std::vector<PlannedLight> lights;  // one for each of effects.lights
    // The ambient light that is the same at every vertex: a_cs, and a_cli of the lights whose ambient term nothing
    // weakens. It includes these terms, so EffectSet::lights has none of them.
    glm::dvec3 constant_ambient{0};
    // The effective state: the Draw's, without the lecture's variants if the options turn them off, and with a colour
    // that all vertices share put into the material that it sets.
    LightingState lighting;

    // One for each light of the state, enabled or not, in the state's order; empty for an unlit Draw.
    std::vector<LightBound> light_bounds;
    // The largest error of a channel of a lit colour, before the clamp and rounding, from faint things that are left
    // out.
    double error_bound = 0;
    // The limit for error_bound: the options' budget, or 0 where blending may add errors up.
    double budget = 0;

    void leave_out(std::string_view what, std::string_view why, bool is_off = false) {
        if (has_reasons) left_out.push_back({tr(what), tr(why), is_off});
    }
};

struct PlanOptions : Look {
    // The largest allowed error of a colour's channel, before rounding to 8 bits, from leaving out faint things. 0
    // leaves out only what adds exactly nothing. The default is half of what rounding to 8 bits hides.
    double budget = 0.5 / 255;
    // For scenes with spectra. False lights every vertex or fragment in all samples, as if materials varied from point
    // to point; the picture is the same. Used to measure the cost of samples (judge/study/spectral.h).
    bool fold_spectra = true;
    // Decides by state, not by where things are, so that the effects stay right when objects, lights and the camera
    // move (programmable/export/): no light is left out as faint, behind or outside its cone; a light that is on keeps
    // its own ambient term; colours are always clamped; GL_NORMALIZE normalizes. The budget is then 0.
    bool for_any_pose = false;
    // False leaves Plan::left_out empty. Writing the reasons takes longer than the rest of a plan.
    bool reasons = true;
};

Plan plan_effects(const Draw& draw, const PlanOptions& options);
// The same with known vertex facts: then the cost does not grow with the number of vertices.
Plan plan_effects(const Draw& draw, const PlanOptions& options, const VertexFacts& vertices);

// The lights that are left out, in the form of Plan::left_out.
std::vector<LeftOut> lights_left_out(const Plan& plan);

}  // namespace twinlight
