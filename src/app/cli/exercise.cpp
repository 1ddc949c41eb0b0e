#include "app/cli/exercise.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "app/program.h"
#include "base/image/png.h"
#include "judge/explain/derivation_light.h"
#include "judge/report/html.h"
#include "render/reference/reference.h"

namespace twinlight::cli {

namespace {

using explain::Line;
using reference::LitPoint;
using reference::PixelFragment;
using report::escaped;

enum class Sheet : std::uint8_t { kQuestion, kSolution };

constexpr const char* kTableStart =
    "<table class=\"sheet\"><thead><tr><th></th><th></th><th>red</th><th>green</th><th>blue</th></tr></thead>\n";

// A fixed number of digits would hide that 0.8 was typed.
std::string color_cells(const glm::dvec4& color) {
    return fmt::format("<td>{:.5g}</td><td>{:.5g}</td><td>{:.5g}</td>", color.r, color.g, color.b);
}
std::string color_cells(const reference::Vec& color) { return color_cells({color.x, color.y, color.z, 1}); }

std::string color_table_row(std::string_view symbol, std::string_view what, const std::string& cells) {
    return fmt::format("<tr><th scope=\"row\">{}</th><td class=\"how\">{}</td>{}</tr>\n", escaped(symbol),
                       escaped(what), cells);
}

// The numbers that the scene gives and that no line of the derivation names by itself.
std::string given_table(const Draw& draw, const LitPoint& point, const std::vector<int>& lights) {
    const lighting::Material<double>& material = point.material;
    std::string html = kTableStart;
    html += color_table_row("a_cm", "material: ambient", color_cells(material.ambient));
    html += color_table_row("d_cm", "material: diffuse", color_cells(material.diffuse));
    html += color_table_row("s_cm", "material: specular", color_cells(material.specular));
    html += color_table_row("e_cm", "material: emission", color_cells(material.emission));
    html += color_table_row("a_cs", "ambient light of the scene", color_cells(draw.lighting.light_model.ambient));
    for (const int number : lights) {
        const LightSource& light = draw.lighting.lights[static_cast<std::size_t>(number)];
        const std::string name = light_name(number);
        html += color_table_row("a_cl", name + ": ambient", color_cells(light.ambient));
        html += color_table_row("d_cl", name + ": diffuse", color_cells(light.diffuse));
        html += color_table_row("s_cl", name + ": specular", color_cells(light.specular));
    }
    html += "</table>\n<ul>\n";
    html += fmt::format("<li>GL_SHININESS: s = {:.5g}</li>\n", material.shininess);
    for (const int number : lights) {
        const LightSource& light = draw.lighting.lights[static_cast<std::size_t>(number)];
        const std::string name = light_name(number);
        if (!light.is_directional() && !light.has_initial_attenuation())
            html += fmt::format("<li>{}: k0 = {:.5g}, k1 = {:.5g}, k2 = {:.5g}</li>\n", name,
                                light.constant_attenuation, light.linear_attenuation, light.quadratic_attenuation);
        if (light.has_cutoff())
            html += fmt::format("<li>{}: GL_SPOT_CUTOFF {:.5g} degrees, GL_SPOT_EXPONENT {:.5g}</li>\n", name,
                                light.spot_cutoff_deg, light.spot_exponent);
    }
    return html + "</ul>\n";
}

// A line as a row of the table; a result's numbers are blank in the question. `formula`: of a result, from the line before it.
std::string row_of(const Line& line, const std::string& formula, Sheet sheet) {
    const bool is_blank = line.is_result && sheet == Sheet::kQuestion;
    const auto row = [&](const std::string& cells) {
        std::string how = escaped(formula);
        if (!is_blank || line.what == "sum")
            how += (how.empty() || line.how.empty() ? "" : "<br>= ") + escaped(line.how);
        return fmt::format("<tr><th scope=\"row\">{}</th><td class=\"how\">{}</td>{}</tr>\n", escaped(line.what), how,
                           cells);
    };
    switch (line.kind) {
        case Line::Kind::kHeading:
        case Line::Kind::kHeadingOfColors:
            return fmt::format("<tr><th scope=\"rowgroup\" colspan=\"5\">{}</th></tr>\n", escaped(line.what));
        case Line::Kind::kLight:
            return fmt::format("<tr><th scope=\"rowgroup\" colspan=\"5\">{}: {}</th></tr>\n", escaped(line.what),
                               escaped(line.how));
        case Line::Kind::kEquation: return "";  // it stands above the table
        case Line::Kind::kValue:
            return row(is_blank ? "<td colspan=\"3\" class=\"blank\"></td>"
                                : fmt::format("<td colspan=\"3\">{}</td>", escaped(line.value)));
        case Line::Kind::kColor: {
            constexpr const char* kBlank = "<td class=\"blank\"></td>";
            return row(is_blank ? fmt::format("{0}{0}{0}", kBlank) : color_cells(line.color));
        }
        case Line::Kind::kNote:
            return is_blank ? ""
                            : fmt::format("<tr><td></td><td class=\"how\" colspan=\"4\">{}</td></tr>\n",
                                          escaped(line.value));
    }
    return "";
}

std::string calculation(const explain::Lines& lines, Sheet sheet) {
    std::string html = kTableStart;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        // A formula and, without a symbol of its own, its result.
        const bool has_result = lines[i].kind == Line::Kind::kValue && !lines[i].is_result && i + 1 < lines.size() &&
                                lines[i + 1].is_result && lines[i + 1].what.empty() &&
                                lines[i + 1].kind != Line::Kind::kNote;
        if (!has_result) {
            html += row_of(lines[i], "", sheet);
            continue;
        }
        Line result = lines[i + 1];
        result.what = lines[i].what;
        html += row_of(result, lines[i].value, sheet);
        ++i;
    }
    return html + "</table>\n";
}

// The fragment that shows, and its point with the largest share.
const PixelFragment& lit_fragment(const Scene& scene, const explain::PixelExplanation& explanation) {
    const std::vector<PixelFragment>& fragments = explanation.history.fragments;
    for (std::size_t i = explain::first_seen(scene.frame, fragments); i < fragments.size(); ++i)
        if (fragments[i].passes && fragments[i].is_lit) return fragments[i];
    throw UsageError(
        fmt::format("--as exercise: no lit surface shows at pixel {},{}", explanation.pixel.x, explanation.pixel.y));
}

}  // namespace

std::string exercise_page(const Scene& scene, const explain::PixelExplanation& explanation) {
    const PixelFragment& fragment = lit_fragment(scene, explanation);
    const LitPoint& point = *std::ranges::max_element(fragment.points, {}, &LitPoint::weight);
    const Draw& draw = *scene.frame.draws()[fragment.draw];
    const explain::Derivation at{scene.frame,     draw,  fragment.draw + 1,
                                 fragment.lights, point, explanation.look.lecture_variants};
    const explain::Lines lines = explain::derivation_lines(at, false);
    const auto equation = std::ranges::find(lines, Line::Kind::kEquation, &Line::kind);
    const auto [x, y] = explanation.pixel;
    const Frame& frame = scene.frame;
    const std::string png = encode_png(reference::render(frame, reference::Options{explanation.look}));
    const std::string where = point.vertex ? fmt::format("vertex {} of draw {}, which counts most at pixel {}, {}",
                                                         *point.vertex + 1, fragment.draw + 1, x, y)
                                           : fmt::format("pixel {}, {}", x, y);

    std::string html = report::page_head(
        scene.title(), std::string(report::page_file("page.css")) + std::string(report::page_file("exercise.css")));
    html += fmt::format("<body>\n<h1>{}</h1>\n", escaped(scene.title()));
    html += fmt::format(
        "<figure class=\"marked\"><img src=\"{}\" alt=\"the scene, with a mark at pixel {}, {}\">"
        "<span class=\"mark\" style=\"left:{:.3f}%;top:{:.3f}%\"></span></figure>\n",
        report::data_uri(png), x, y, 100 * (x + 0.5) / frame.width, 100 * (y + 0.5) / frame.height);
    html += fmt::format(
        "<p>Calculate the colour at {} by OpenGL's lighting equation (2.14.1), in eye coordinates. "
        "All vectors of the equation have length 1. Below 0 counts as 0.</p>\n",
        where);
    html += fmt::format("<p class=\"equation\">{}</p>\n", escaped(equation->value));
    html += fmt::format(
        "<p>n: the normal. VP: the direction to the light. VP_e: to the viewer. {} d: the distance to the light.</p>\n",
        at.has_reflection() ? "r: VP reflected about n."
                            : "h: half-way between VP and VP_e. f: 1 where n.VP is above 0, and else 0.");
    html += "<h2>Given</h2>\n" + given_table(draw, point, fragment.lights);
    html += "<h2>Calculate</h2>\n" + calculation(lines, Sheet::kQuestion);
    html += "<section class=\"solution\">\n<h1>Solution</h1>\n";
    html += fmt::format("<p class=\"equation\">{}</p>\n", escaped(equation->value));
    html += calculation(lines, Sheet::kSolution);
    return html + "</section>\n</body>\n</html>\n";
}

}  // namespace twinlight::cli
