// The plans of a frame, as text. Draws with equal plans are merged.
#pragma once

#include <string>
#include <vector>

#include "render/effect/plan.h"

namespace twinlight {

struct ExplainedDraw {
    std::vector<int> numbers;  // of the Draws, counted from 1
    Place place;               // of the first
    // Of the first Draw. Parts of a shape whose plans have the same facts are merged: the plan then has the largest of
    // their bounds, and the smallest of the angles by which a light misses them.
    Plan plan;
};

// Plans each Draw by itself; with exact shading, each surface, in drawing order.
std::vector<ExplainedDraw> explain_draws(const Frame& frame, const PlanOptions& options);

// The largest error of a channel in the whole picture. Errors of blended Draws do not add up (Plan::budget).
double error_bound(const std::vector<ExplainedDraw>& draws);

// Lights next to each other that are left out for the same reason are merged: "GL_LIGHT1 to GL_LIGHT7".
struct ExplainedLights {
    std::string names;
    bool in = false;
    bool is_off = false;  // not enabled
    std::string why;
    double largest = 0;  // LightBound::largest()
};
std::vector<ExplainedLights> explain_lights(const Plan& plan);

// The lines of describe(): those about the draw, and those about its lights that are in ("directional, diffuse").
struct EffectWords {
    std::vector<std::string> of_draw, of_lights;
};
EffectWords effect_words(const Plan& plan);

// A light or effect, whether the shaders have it, and why.
struct ExplainedEffect {
    std::string what, why;
    bool in = false;
    bool is_off = false;  // the scene does not turn it on
};
std::vector<ExplainedEffect> explain_effects(const Plan& plan);

// "draw 1, scene.gl:3:1", "4 draws, the first draw 2, scene.gl:7:1"
std::string name_of(const ExplainedDraw& draw);

// An error as a fraction of 255: "0.0204/255", "0".
std::string in_codes(double error);

}  // namespace twinlight
