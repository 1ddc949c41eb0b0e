// The choices that a study compares: ways to draw a scene. Each axis (renderer, shading, slices, ...) is one thing in
// which they may differ; a choice has a value on each axis.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "judge/study/lighting_change.h"
#include "render/fixed/replay.h"
#include "render/programmable/numbers/shader_options.h"
#include "render/reference/vertices/reference_options.h"
#include "scene/frame/frame.h"

namespace twinlight::study {

// The renderer; for shaders also the kind of program (programmable::Options).
enum class Method : std::uint8_t { kFixed, kUniforms, kConstants, kPrecise, kReference };

// The colour buffer that the driver draws into.
enum class Target : std::uint8_t { kCodes, kFloats };

struct Choice {
    Method method = Method::kUniforms;
    Shading shading = Shading::kGouraud;
    int slices = 0;  // 0: as in the scene; exact surfaces have none
    LightingChange lighting_change = LightingChange::kWhole;
    fixed::Sending sending = fixed::Sending::kBuffers;
    Target target = Target::kCodes;
    int samples = 1;                  // a pixel has samples x samples of them
    Number number = Number::kDouble;  // only for the reference, like `powers`
    Powers powers = Powers::kPow;
    double budget = PlanOptions{}.budget;

    // "shaders with uniforms, gouraud, 32 slices"; usual values are not mentioned.
    std::string words() const;
    // The same for files and keys: "shaders-gouraud-32"
    std::string key() const;
    programmable::Options shader_options() const;
    reference::Options reference_options() const;
    fixed::ReplayOptions fixed_options() const;

    friend bool operator==(const Choice&, const Choice&) = default;
};

// The value of a choice on an axis.
struct Value {
    std::string key, words;    // "no-specular", "no highlights"; the key of a number is the number, or empty
    bool is_mentioned = true;  // in Choice::words() and key()
};

struct Axis {
    const char* name;   // "model"; a column of study.csv
    const char* words;  // "lighting model"
    bool is_number;
    const char* prefix;  // in front of its part of Choice::key()
    Value (*value)(const Choice& choice);
    // Returns false if the axis has no such value.
    bool (*set)(Choice& choice, std::string_view key);
    // All keys, for error messages; empty for numbers.
    std::string (*keys)();
};
const std::vector<Axis>& axes();

// The choices of a study of this scene (selection.cpp). `has_slices`: its meshes can be made finer or coarser.
// `coverage`: the exact picture has coverage x coverage samples per pixel.
enum class Extent : std::uint8_t { kQuick, kFull };
inline const char* name_of(Extent extent) { return extent == Extent::kQuick ? "quick" : "full"; }
inline constexpr int kMostCoverage = 16;
std::vector<Choice> select_choices(const Frame& frame, bool has_slices, Extent extent, int coverage = 1);

}  // namespace twinlight::study
