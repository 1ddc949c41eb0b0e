// EffectSet: the facts that change the code which lights a Draw, and nothing else.
//
// Two Draws whose sets are equal are lit by the same code with other numbers. The facts are canonical
// (plan_effects sees to it): one that cannot matter has its default value, so the set may be the key of a
// program cache as it is.
//
//   a fact may be set only if ...
//   everything but shading, clamp            lighting
//   shading kFlat                            the primitive has more than one vertex
//   two_side, back                           a back face can show
//   local_viewer                             a light's highlight depends on the viewer
//   vertex_w                                 a light is positional, or local_viewer
//   normalize                                a light is diffuse or specular
//   separate_specular, specular_model        a light is specular
//   shininess                                a light is specular
//   tracks_*                                 that colour of the material is called for
//   lights[i].attenuated, .spot              the light is positional
//
// NOLINT below: clang-tidy takes a defaulted <=> for a null pointer.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <string>

#include "state/frame.h"

namespace twinlight {

// x^n as code: 1 for n = 0, repeated squaring for a whole n, pow for the rest.
enum class Power : std::uint8_t { kOne, kWhole, kReal };

// GL's (n.h)^s and the lecture's (r.v)^s.
enum class Highlight : std::uint8_t { kHalfVector, kReflection };

struct LightEffects {
    bool directional = false;  // w of the position is 0
    bool attenuated = false;   // by a linear or quadratic factor; a constant one is folded into the products
    bool spot = false;         // cutoff other than 180 degrees
    Power spot_exponent = Power::kOne;
    bool smooth_cone = false;  // the lecture's cone in the place of the spot's
    bool ambient = false;      // an ambient term that is not the same at every vertex
    bool diffuse = false;
    bool specular = false;

    friend auto operator<=>(const LightEffects&, const LightEffects&) = default;  // NOLINT
};

// Which colours of a face's material the vertex's colour replaces (2.14.3).
struct FaceEffects {
    bool tracks_emission = false;
    bool tracks_ambient = false;
    bool tracks_diffuse = false;
    bool tracks_specular = false;

    friend auto operator<=>(const FaceEffects&, const FaceEffects&) = default;  // NOLINT
};

struct EffectSet {
    bool lighting = false;
    Shading shading = Shading::kGouraud;
    bool clamp = false;  // a colour may leave [0,1] (2.14.6)
    bool two_side = false;
    bool local_viewer = false;
    bool vertex_w = false;  // w in eye coordinates may be other than 1
    bool normalize = false;
    bool separate_specular = false;
    Highlight highlight = Highlight::kHalfVector;
    Power shininess = Power::kOne;
    FaceEffects front, back;
    int light_count = 0;
    std::array<LightEffects, kMaxLights> lights;  // the first light_count, in GL's order

    friend auto operator<=>(const EffectSet&, const EffectSet&) = default;  // NOLINT

    // Whether any light is: needs_position(), say, for "a position in eye coordinates is called for".
    bool any_light(bool LightEffects::*fact) const {
        for (int i = 0; i < light_count; ++i)
            if (lights[static_cast<std::size_t>(i)].*fact) return true;
        return false;
    }
    bool needs_position_eye() const {
        bool positional = false;
        for (int i = 0; i < light_count; ++i) positional |= !lights[static_cast<std::size_t>(i)].directional;
        return positional || local_viewer;
    }
    bool needs_normal() const { return any_light(&LightEffects::diffuse) || any_light(&LightEffects::specular); }
    bool needs_color() const { return !lighting || front != FaceEffects{} || back != FaceEffects{}; }
};

// One fact a line: "lighting", "light 0: positional, attenuated, diffuse".
std::string describe(const EffectSet& effects);

}  // namespace twinlight
