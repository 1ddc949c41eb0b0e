// The plans of a frame, for people to read: Draws with equal plans are one.
#pragma once

#include <string>
#include <vector>

#include "render/effect/plan.h"

namespace twinlight {

// The plan of a Draw, or of an exact surface: in the order in which they are drawn.
struct PlannedDraw {
    int number = 0;  // of the Draw, from 1 up
    Place place;
    bool begins_shape = false;  // the Draw is the first part of its shape
    Plan plan;
};

struct ExplainedDraw {
    std::vector<int> numbers;  // of the Draws, from 1 up
    Place place;               // of the first
    // Of the first. The parts of a shape whose plans have the same facts are one: with the largest of their bounds, and of the
    // angles by which a light misses them the smallest.
    Plan plan;
};

std::vector<ExplainedDraw> explain(std::vector<PlannedDraw> plans);
// Plans it first.
std::vector<ExplainedDraw> explain(const Frame& frame, const PlanOptions& options);

// How far a channel may be off in the whole picture: Draws that blend do not add their errors up (Plan::budget).
double error_bound(const std::vector<ExplainedDraw>& draws);

// "GL_LIGHT0", "GL_LIGHT1 to GL_LIGHT7": neighbours that are out for the same reason are one.
struct ExplainedLights {
    std::string names;
    bool in = false;
    std::string why;
    double largest = 0;  // LightBound::largest()
};
std::vector<ExplainedLights> explain_lights(const Plan& plan);

// "draw 1, scene.gl:3:1", "4 draws, the first draw 2, scene.gl:7:1"
std::string name_of(const ExplainedDraw& draw);

// "0.0204 of 255 codes", "nothing"
std::string in_codes(double error);

}  // namespace twinlight
