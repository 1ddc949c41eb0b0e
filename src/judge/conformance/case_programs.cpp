#include "judge/conformance/case_programs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <glm/common.hpp>
#include <optional>

#include "base/image/embedded.h"
#include "judge/compare/vertex_colors.h"
#include "judge/conformance/c_scene.h"
#include "render/reference/reference.h"
#include "scene/command/text.h"
#include "scene/frame/lecture_variants.h"
#include "scene/state/state.h"

namespace twinlight {

// The files of suite/, by name.
extern const std::vector<EmbeddedFile> kConformanceFiles;

}  // namespace twinlight

namespace twinlight::conformance {

namespace {

using check::Case, check::Expectation, check::Spot;

constexpr double kPixelDifference =
    1e-3;  // of the reference's pixel from the vertex's colour, if the pixel shows it; far below 1/255

// A comment in C that nothing in the text can end.
std::string c_comment(std::string text) {
    for (std::size_t at = 0; (at = text.find("*/", at)) != std::string::npos;) text.replace(at, 2, "* /");
    return "/* " + text + " */\n";
}

// "vertex_w_2": a name in C, which may not begin with a digit.
std::string identifier(const std::string& name) {
    std::string made = "case_";
    for (const char c : name) made += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
    return made;
}

std::string c_number(double value) {
    if (std::isnan(value)) return "NAN";
    if (std::isinf(value)) return value > 0 ? "INFINITY" : "-INFINITY";
    return fmt::format("{:.9g}", value);
}

std::string c_array(const glm::dvec4& c) {
    return fmt::format("{{{}, {}, {}, {}}}", c_number(c.r), c_number(c.g), c_number(c.b), c_number(c.a));
}

// What the fixed function can show: no Phong or exact shading, and an error by itself.
std::vector<Expectation> colors_of(const Case& of) {
    std::vector<Expectation> colors;
    for (const Expectation& expected : of.expectations)
        if (!expected.spot.shading && expected.spot.kind != Spot::Kind::kError) colors.push_back(expected);
    return colors;
}

struct Places {
    std::vector<glm::dvec2>
        places;  // of a vertex in a window of 1 x 1, of a pixel in one of kSide; from the lower left corner
    bool is_of_polygons = false;
    std::string no_pixel;  // why a pixel cannot show the vertices
};

bool is_in_unit_range(const glm::dvec4& color) {
    return glm::all(glm::greaterThanEqual(color, glm::dvec4(0))) && glm::all(glm::lessThanEqual(color, glm::dvec4(1)));
}

// Whether the pixels at the vertices, drawn as points, have their colours in the reference.
bool is_shown_by_pixels(const Case& of, const std::vector<Expectation>& colors, const Places& places) {
    auto points = std::make_shared<CommandList>(*of.scene);
    if (places.is_of_polygons)
        points->commands.insert(points->commands.begin(),
                                {CommandId::glPolygonMode, {kGL_FRONT_AND_BACK, kGL_POINT}, {}});
    Case drawn = of;
    drawn.scene = points;
    const Image picture = reference::render(drawn.carried_out(check::kVertexSide).scene.frame, {});
    for (std::size_t i = 0; i < colors.size(); ++i) {
        const glm::ivec2 at(places.places[i] * static_cast<double>(check::kVertexSide));
        const Rgba& pixel = picture.at(at.x, check::kVertexSide - 1 - at.y);
        const glm::dvec4 secondary(colors[i].secondary, 0);
        const glm::dvec4 right = compare::color_sum(std::get<glm::dvec4>(colors[i].value), secondary),
                         other = compare::color_sum(std::get<glm::dvec4>(colors[i].other), secondary);
        for (int channel = 0; channel < 4; ++channel) {
            const double shown = pixel[static_cast<std::size_t>(channel)];
            if (!(std::abs(shown - right[channel]) < kPixelDifference) &&
                !(std::abs(shown - other[channel]) < kPixelDifference))
                return false;
        }
    }
    return true;
}

Places places_of(const Case& of, const std::vector<Expectation>& colors) {
    Places found;
    if (!of.is_of_vertices()) {
        for (const Expectation& expected : colors)
            found.places.emplace_back(expected.spot.x, check::kSide - 1 - expected.spot.y);
        return found;
    }
    std::string error;
    const std::optional<compare::VertexScene> scene =
        compare::make_vertex_scene(of.carried_out(compare::kVertexWindow).scene, error);
    if (!scene) throw SceneError(of.name + ": " + error);
    found.is_of_polygons = draws_polygons(scene->draw().mode);
    for (const Expectation& expected : colors) {
        if (static_cast<std::size_t>(expected.spot.vertex) >= scene->lit.size())
            throw SceneError(of.name + ": the last primitive has no " + expected.spot.str());
        found.places.push_back(scene->place(static_cast<std::size_t>(expected.spot.vertex)));
        for (const check::Seen& color : {expected.value, expected.other})
            if (!is_in_unit_range(std::get<glm::dvec4>(color)))
                found.no_pixel = "8 bits cannot show a colour outside [0, 1]";
    }
    if (found.no_pixel.empty() && !is_shown_by_pixels(of, colors, found))
        found.no_pixel = "other state than lighting changes the colour of its pixel";
    return found;
}

std::string expected_in_c(const Case& of, const Expectation& expected, const glm::dvec2& place) {
    const glm::dvec4 &value = std::get<glm::dvec4>(expected.value), &other = std::get<glm::dvec4>(expected.other);
    const glm::dvec4 secondary(expected.secondary, 0);
    const bool is_vertex = of.is_of_vertices();
    return fmt::format("    {{{}, {}, {}, {}, {}, {}, {}}},\n", c_literal(expected.spot.str()), c_number(place.x),
                       c_number(place.y), c_array(value), c_array(other),
                       c_array(is_vertex ? compare::color_sum(value, secondary) : value),
                       c_array(is_vertex ? compare::color_sum(other, secondary) : other));
}

std::string program(const Case& of, const std::vector<Expectation>& colors) {
    const std::string id = identifier(of.name);
    const CommandList scene = c_scene(*of.scene);
    const Places places = places_of(of, colors);
    std::string text = c_comment(of.what) + c_comment(of.why) + c_comment("OpenGL 2.1, section " + of.text) +
                       c_comment((of.is_ruling ? "OpenGL leaves this open; our choice: " : "") + of.derived);
    text += "#include \"hard_case.h\"\n\n";
    if (needs_glu(scene)) text += "#include <GL/glu.h>\n\n";
    text += print_c_function(scene, "draw_" + id) + "\n";
    if (!colors.empty()) {
        text += "static const struct expected expected_" + id + "[] = {\n";
        for (std::size_t i = 0; i < colors.size(); ++i) text += expected_in_c(of, colors[i], places.places[i]);
        text += "};\n\n";
    }
    std::string error = "GL_NO_ERROR";
    for (const Expectation& expected : of.expectations)
        if (expected.spot.kind == Spot::Kind::kError) error = check::text_of(expected.value);
    const std::string causes =
        of.tolerance ? of.tolerance_causes : "for float arithmetic; relative to the larger of 1 and the value";
    text += fmt::format(
        "HARD_CASE({}) = {{\n    {},\n    {},\n    {},\n    draw_{},\n    {},\n    {}, /* the last primitive is a "
        "polygon */\n"
        "    {}, /* OpenGL leaves it open */\n    {:g}, /* {} */\n    {},\n    {},\n    {},\n    {},\n}};\n",
        id, c_literal(of.name), c_literal(of.what), c_literal("OpenGL 2.1, section " + of.text), id,
        of.is_of_vertices() ? "OF_VERTICES" : "OF_PIXELS", places.is_of_polygons ? 1 : 0, of.is_ruling ? 1 : 0,
        of.tolerance.value_or(check::kTolerance), causes, error, colors.size(), colors.empty() ? "0" : "expected_" + id,
        places.no_pixel.empty() ? "0" : c_literal(places.no_pixel));
    return text;
}

// A case without colours must expect an error.
bool is_of_fixed_function(const Case& of, const std::vector<Expectation>& colors) {
    return (!colors.empty() || of.expects_error()) && !has_variants(of.carried_out(check::kSide).scene.frame);
}

}  // namespace

CasePrograms case_programs(std::span<const Case> cases) {
    CasePrograms made;
    std::string all = "/* All cases in one program. */\n#define ALL_CASES\n", table, known;
    for (const Case& of : cases) {
        const std::vector<Expectation> colors = colors_of(of);
        if (!is_of_fixed_function(of, colors)) {
            made.left_out.push_back(of.name);
            continue;
        }
        made.written.push_back(of.name);
        made.files.push_back({"cases/" + of.name + ".c", program(of, colors)});
        all += "#include \"cases/" + of.name + ".c\"\n";
        table += "    &" + identifier(of.name) + ",\n";
        known +=
            fmt::format("{}\t{}\t{}\t{}\t{}\n", of.name, of.text, of.is_ruling ? "open" : "defined", of.what, of.why);
    }
    made.files.push_back(
        {"all.c", all + "\nconst struct hard_case* const hard_cases[] = {\n" + table + "    0,\n};\n"});
    made.files.push_back({"cases.txt", known});
    for (const EmbeddedFile& file : kConformanceFiles)
        made.files.push_back({std::string(file.name), std::string(file.text)});
    return made;
}

}  // namespace twinlight::conformance
