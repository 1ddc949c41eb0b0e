// The choices that a study holds against each other: how a scene is drawn, in its finest detail or with less. What they may
// differ in are the axes; a choice is a value of each.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "judge/study/lighting_change.h"
#include "render/fixed/replay.h"
#include "render/programmable/shader_options.h"
#include "render/reference/reference_options.h"
#include "scene/state/frame.h"

namespace twinlight::study {

// Who draws; of the shaders, with which programs (programmable::Options).
enum class Method : std::uint8_t { kFixed, kUniforms, kConstants, kPrecise, kReference };

// What the driver draws into.
enum class Target : std::uint8_t { kCodes, kFloats };

struct Choice {
    Method method = Method::kUniforms;
    Shading shading = Shading::kGouraud;
    int slices = 0;  // 0: as the scene has them, or none at all (exact surfaces)
    LightingChange lighting_change = LightingChange::kWhole;
    fixed::Sending sending = fixed::Sending::kBuffers;
    Target target = Target::kCodes;
    int samples = 1;                  // the side of a pixel's square of samples
    Number number = Number::kDouble;  // of the reference, as the next
    Powers powers = Powers::kPow;
    double budget = PlanOptions{}.budget;

    // "shaders with uniforms, gouraud, 32 slices": what is as usual is not told.
    std::string words() const;
    // The same for files and keys: "programmable-gouraud-32"
    std::string key() const;
    programmable::Options shader_options() const;
    reference::Options reference_options() const;
    fixed::ReplayOptions fixed_options() const;

    friend bool operator==(const Choice&, const Choice&) = default;
};

// What of a choice an axis tells.
struct Value {
    std::string key,
        words;  // "no-specular", "no highlights"; of numbers the key is the number, and empty where there is none
    bool is_told = true;  // in the choice's own words and key
};

struct Axis {
    const char* name;   // "model"; a column of study.csv
    const char* words;  // "what is lit more simply"
    bool is_number;
    const char* prefix;  // of its part of a choice's key
    Value (*value)(const Choice& choice);
    // False where the axis has no such value.
    bool (*set)(Choice& choice, std::string_view key);
    // The keys that there are, for people; empty of numbers.
    std::string (*keys)();
};
const std::vector<Axis>& axes();

// All that are worth a look for this scene (selection.cpp); `has_slices`: whether its meshes can be made finer or coarser; `coverage`: the
// samples along a pixel's side that truth has.
enum class Extent : std::uint8_t { kQuick, kFull };
inline const char* name_of(Extent extent) { return extent == Extent::kQuick ? "quick" : "full"; }
inline constexpr int kMostCoverage = 16;
std::vector<Choice> select_choices(const Frame& frame, bool has_slices, Extent extent, int coverage = 1);

}  // namespace twinlight::study
