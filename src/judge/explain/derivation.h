// The lighting equation at one point with its numbers: as text that can be followed with a pocket calculator, and as
// JSON.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "judge/explain/explain.h"
#include "render/reference/pixel_history.h"
#include "scene/frame/frame.h"

namespace twinlight::explain {

// A lit point and where it comes from.
struct Derivation {
    const Frame& frame;
    const Draw& draw;
    std::size_t draw_number;         // counts from 1
    const std::vector<int>& lights;  // as in LitPoint::terms
    const reference::LitPoint& point;
    bool lecture_variants = true;  // as in Look: whether the scene's variants of the equation count

    bool has_reflection() const { return lecture_variants && model().specular == Word::reflection; }
    bool has_unattenuated_ambient() const { return lecture_variants && model().light_ambient == Word::unattenuated; }
    bool is_spectral() const { return lecture_variants && model().spectrum; }
    const LightModel& model() const { return draw.lighting.light_model; }
};

// A line of a derivation.
struct Line {
    enum class Kind : std::uint8_t {
        kHeading,          // "total"
        kHeadingOfColors,  // "scene": colours follow
        kLight,            // "GL_LIGHT0", "positional, a spot"
        kEquation,
        kValue,  // "n.VP", "0.86603", "30.00 degrees between n and VP"
        kColor,  // a colour and how it is computed
        kNote,   // may have several lines
    };
    Kind kind = Kind::kValue;
    std::string what{};  // the symbol; empty: that of the line above
    std::string value{};
    std::string how{};
    reference::Vec color{};
    std::optional<int> light{};  // the number of the light that the line belongs to
    bool is_result = false;      // calculated from the lines above it and the scene's numbers
};
// Lines can be added up.
using Lines = std::vector<Line>;
inline Lines operator+(Lines a, const Lines& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}
inline Lines& operator+=(Lines& a, const Lines& b) { return a = std::move(a) + b; }

// A name, its value, and how it is computed.
Lines line(std::string what, std::string value, std::string how = "");
Lines result_line(std::string what, std::string value, std::string how = "");
Lines color_line(std::string what, std::string how, const reference::Vec& color);

// `whole`: also the factors that are 1 because the scene does not use them.
Lines derivation_lines(const Derivation& at, bool whole);
std::string text_of(const Line& line, bool in_color);

// With TextOptions::all also the factors that are 1 because the scene does not use them.
std::string derivation_text(const Derivation& at, const TextOptions& options);
Json derivation_json(const Derivation& at);

// Texture, colour sum and fog of a fragment, if they are used. `is_exact`: a point of a curved surface.
Lines after_lighting_lines(const reference::ColorSteps& steps, const Draw& draw, bool is_exact);
// Adds "texture" and "fog", if they are used.
void add_after_lighting(const reference::ColorSteps& steps, const Draw& draw, Json& json);

// "for GL_LIGHT0 the specification is silent (a zero normal); our choice: ambient and emission only"
std::string rulings_text(const std::vector<reference::PixelFragment::Decided>& rulings);
Json rulings_json(const std::vector<reference::PixelFragment::Decided>& rulings);

// "att spot n.VP d_cm d_cli"
std::string formula_text(const lighting::Formula& formula);
// "GL_LIGHT0", "GL_LIGHT3"
std::vector<std::string> names_of(const std::vector<int>& lights);
Json color_json(const reference::Vec& c);
// "(0.5, 1, 0, 1)"
std::string quadruple(const glm::dvec4& v);
// "   0.80000   0.50000   0.31000"
std::string columns(const reference::Vec& c);
// A line of the tables: a name, how it is computed, and its red, green and blue.
std::string color_row(const std::string& what, const std::string& how, const reference::Vec& c);
// The heading of the colour columns.
std::string color_head(const std::string& what);
// With a terminal's codes, or as it is.
std::string bold(const std::string& text, bool in_color);

}  // namespace twinlight::explain
