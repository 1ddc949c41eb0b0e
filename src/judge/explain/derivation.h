// The lighting equation at one point with its numbers: as text that can be followed with a pocket calculator, and as
// JSON.
#pragma once

#include <string>
#include <vector>

#include "judge/explain/explain.h"
#include "render/reference/pixel_history.h"
#include "scene/state/frame.h"

namespace twinlight::explain {

// A lit point and where it comes from.
struct Derivation {
    const Frame& frame;
    const Draw& draw;
    std::size_t draw_number;         // counts from 1
    const std::vector<int>& lights;  // as in LitPoint::terms
    const reference::LitPoint& point;
};

// With TextOptions::all also the factors that are 1 because the scene does not use them.
std::string derivation_text(const Derivation& at, const TextOptions& options);
Json derivation_json(const Derivation& at);

// "for GL_LIGHT0 the specification is silent (a zero normal); our choice: ambient and emission only"
std::string rulings_text(const std::vector<reference::PixelFragment::Decided>& rulings);
Json rulings_json(const std::vector<reference::PixelFragment::Decided>& rulings);

// "GL_LIGHT0", "GL_LIGHT3"
std::vector<std::string> names_of(const std::vector<int>& lights);
Json color_json(const reference::Vec& c);
// "   0.80000   0.50000   0.31000"
std::string columns(const reference::Vec& c);
// A line of the tables: a name, how it is computed, and its red, green and blue.
std::string color_row(const std::string& what, const std::string& how, const reference::Vec& c);
// The heading of the colour columns.
std::string color_head(const std::string& what);
// With a terminal's codes, or as it is.
std::string bold(const std::string& text, bool in_color);

}  // namespace twinlight::explain
