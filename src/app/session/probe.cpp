#include "app/session/probe.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <span>
#include <string_view>

#include "base/text/translation.h"
#include "judge/explain/derivation_light.h"
#include "scene/command/names.h"

namespace twinlight::session {
namespace {

using explain::Derivation;
using explain::Line;
using reference::Face;
using reference::LitPoint;
using reference::PixelFragment;
using reference::Vec;

const char* words_of(Face face) { return tr(face == Face::kFront ? "front face" : "back face"); }

std::string trouble_of(const Frame& frame, const Probe& probe) {
    if (!probe.is_vertex) {
        if (probe.x < 0 || probe.y < 0 || probe.x >= frame.width || probe.y >= frame.height)
            return tr("Pixel {}, {} is outside the picture of {} x {} pixels.", probe.x, probe.y, frame.width,
                      frame.height);
        return "";
    }
    const std::vector<const Draw*> draws = frame.draws();
    if (draws.empty()) return tr("The scene draws nothing.");
    if (probe.draw < 1 || probe.draw > draws.size())
        return tr("There is no draw {}; the scene has draws 1 to {}.", probe.draw, draws.size());
    const Draw& draw = *draws[probe.draw - 1];
    if (draw.vertices.empty()) return tr("Draw {} has no vertices.", probe.draw);
    if (probe.vertex < 1 || probe.vertex > draw.vertices.size())
        return tr("Draw {} has no vertex {}; it has vertices 1 to {}.", probe.draw, probe.vertex, draw.vertices.size());
    if (!draw.lighting.enabled)
        return tr("Draw {} is not lit: GL_LIGHTING is disabled, so its vertices keep glColor's colours.", probe.draw);
    return "";
}

struct SymbolRow {
    std::string_view specification, lecture;
};

// Products in the lecture's order of factors.
constexpr SymbolRow kProducts[] = {{"n.VP d_cm d_cli", "k_d I_di (n·l)"},
                                   {"f(n.h)^s s_cm s_cli", "k_s I_si (n·h)^n"},
                                   {"(r.v)^s s_cm s_cli", "k_s I_si (r·v)^n"},
                                   {"c =", "I ="}};
// A symbol comes after those that contain it.
constexpr SymbolRow kSymbols[] = {{"f is 1 because n.VP > 0", "counted because n·l > 0"},
                                  {"f is 0 because n.VP is 0", "0 because n·l is 0"},
                                  {"s is GL_SHININESS", "the exponent is GL_SHININESS"},
                                  {"f(n.h)^s", "(n·h)^n"},
                                  {"(r.v)^s", "(r·v)^n"},
                                  {"n.VP", "n·l"},
                                  {"n.h", "n·h"},
                                  {"r.v", "r·v"},
                                  {"VP_e", "v"},
                                  {"VP", "l"},
                                  {"e_cm", "e"},
                                  {"a_cm", "k_a"},
                                  {"d_cm", "k_d"},
                                  {"s_cm", "k_s"},
                                  {"a_cs", "I_a"},
                                  {"a_cli", "I_ai"},
                                  {"d_cli", "I_di"},
                                  {"s_cli", "I_si"},
                                  {"c_pri", "I"},
                                  {"c_sec", "I_s"}};

// Replaces words by the lecture's symbols; only whole words count.
std::string in_lecture_symbols(std::string_view text, std::span<const SymbolRow> rows) {
    const auto is_in_word = [&](std::size_t at) {
        return at < text.size() && (std::isalnum(static_cast<unsigned char>(text[at])) != 0 || text[at] == '_');
    };
    std::string result;
    for (std::size_t at = 0; at < text.size();) {
        const auto row = std::ranges::find_if(rows, [&](const SymbolRow& one) {
            return text.substr(at).starts_with(one.specification) && !is_in_word(at + one.specification.size()) &&
                   (at == 0 || !is_in_word(at - 1));
        });
        if (row == rows.end()) {
            result += text[at++];
        } else {
            result += row->lecture;
            at += row->specification.size();
        }
    }
    return result;
}

void use(Symbols symbols, std::string& text) {
    if (symbols == Symbols::kLecture) text = in_lecture_symbols(text, kSymbols);
}
void use_in_formula(Symbols symbols, std::string& text) {
    if (symbols == Symbols::kLecture) text = in_lecture_symbols(in_lecture_symbols(text, kProducts), kSymbols);
}

void add_total(std::vector<SumRow>& rows, const char* name, const Vec& color) {
    rows.push_back({"=", name, tr("before the clamp"), color, true});
    const Vec clamped = explain::clamped_color(color);
    rows.push_back(
        {"", tr("clamped"), clamped == color ? tr("to [0, 1]") : tr("to [0, 1]: this changes it"), clamped, true});
}

}  // namespace

ProbeAnswer answer_probe(const Scene& scene, const Look& look, const Probe& probe) {
    ProbeAnswer answer;
    answer.probe = probe;
    answer.trouble = trouble_of(scene.frame, probe);
    if (!answer.trouble.empty()) return answer;
    if (probe.is_vertex)
        answer.vertex = explain::explain_vertex(scene.frame, look, {probe.draw - 1, probe.vertex - 1});
    else
        answer.pixel = explain::explain_pixel(scene.frame, look, {probe.x, probe.y});
    return answer;
}

std::vector<ProbeFragment> fragments_of(const Scene& scene, const ProbeAnswer& answer) {
    std::vector<ProbeFragment> rows;
    if (!answer.trouble.empty()) return rows;
    const std::vector<const Draw*> draws = scene.frame.draws();
    const auto name = [&](std::size_t draw, Face face) {
        return tr("draw {}, {}, {}", draw + 1, draws[draw]->place.str(), words_of(face));
    };
    if (answer.probe.is_vertex) {
        for (const explain::FaceExplanation& face : answer.vertex.faces)
            rows.push_back({name(answer.vertex.vertex.draw, face.history.point.face), tr("lit as GL lights vertices")});
        return rows;
    }
    const std::vector<PixelFragment>& fragments = answer.pixel.history.fragments;
    const std::size_t first_seen = explain::first_seen(scene.frame, fragments);
    for (std::size_t i = 0; i < fragments.size(); ++i) {
        const PixelFragment& fragment = fragments[i];
        const bool is_seen = fragment.passes && i >= first_seen;
        rows.push_back({name(fragment.draw, fragment.face),
                        tr(is_seen           ? "seen"
                           : fragment.passes ? "a later draw covers it"
                                             : "discarded by a test"),
                        fragment.is_lit, is_seen});
    }
    return rows;
}

std::size_t main_fragment(const std::vector<ProbeFragment>& fragments) {
    for (std::size_t i = fragments.size(); i > 0; --i)
        if (fragments[i - 1].is_seen) return i - 1;
    return 0;
}

std::vector<ProbePoint> points_of(const Scene& scene, const ProbeAnswer& answer, std::size_t fragment) {
    std::vector<ProbePoint> points;
    const std::vector<const Draw*> draws = scene.frame.draws();
    const bool lecture_variants = (answer.probe.is_vertex ? answer.vertex.look : answer.pixel.look).lecture_variants;
    const auto add = [&](std::size_t draw, const std::vector<int>& lights, const LitPoint& point) {
        points.push_back({point.vertex ? tr("vertex {}", *point.vertex + 1) : tr("this pixel"),
                          point.weight,
                          explain::clamped_color(point.primary),
                          {scene.frame, *draws[draw], draw + 1, lights, point, lecture_variants}});
    };
    if (answer.probe.is_vertex) {
        if (fragment >= answer.vertex.faces.size()) return points;
        const reference::VertexHistory& history = answer.vertex.faces[fragment].history;
        add(answer.vertex.vertex.draw, history.lights, history.point);
        return points;
    }
    if (fragment >= answer.pixel.history.fragments.size()) return points;
    const PixelFragment& at = answer.pixel.history.fragments[fragment];
    for (const LitPoint& point : at.points) add(at.draw, at.lights, point);
    return points;
}

namespace {

std::vector<SumRow> rows_of_sum(const Derivation& at, std::optional<int> light) {
    const LitPoint& point = at.point;
    const bool separate = at.draw.lighting.light_model.color_control == kGL_SEPARATE_SPECULAR_COLOR;
    std::vector<SumRow> rows;
    if (light) {
        const auto found = std::ranges::find(at.lights, *light);
        if (found == at.lights.end()) return rows;
        const lighting::LightTerms<double>& terms = point.terms[static_cast<std::size_t>(found - at.lights.begin())];
        rows.push_back({"", tr("ambient"), explain::formula_text(point.formulas.ambient), terms.ambient});
        rows.push_back({"+", tr("diffuse"), explain::formula_text(point.formulas.diffuse), terms.diffuse});
        rows.push_back({"+", tr("specular"), explain::formula_text(point.formulas.specular), terms.specular});
        rows.push_back(
            {"=", light_name(*light), tr("its share"), terms.ambient + terms.diffuse + terms.specular, true});
        return rows;
    }
    rows.push_back({"", tr("emission"), "e_cm", point.material.emission});
    rows.push_back({"+", tr("ambient"), "a_cm a_cs", point.scene_ambient});
    for (std::size_t i = 0; i < at.lights.size(); ++i) {
        const lighting::LightTerms<double>& terms = point.terms[i];
        Vec sum = terms.ambient + terms.diffuse;
        if (!separate) sum += terms.specular;
        rows.push_back({"+", light_name(at.lights[i]), "", sum});
    }
    add_total(rows, "c_pri", point.primary);
    if (!separate) return rows;
    for (std::size_t i = 0; i < at.lights.size(); ++i)
        rows.push_back({i == 0 ? "" : "+", light_name(at.lights[i]), tr("specular"), point.terms[i].specular});
    add_total(rows, "c_sec", point.secondary);
    return rows;
}

}  // namespace

std::vector<SumRow> sum_rows(const Derivation& at, std::optional<int> light, Symbols symbols) {
    std::vector<SumRow> rows = rows_of_sum(at, light);
    for (SumRow& row : rows) {
        use(symbols, row.what);
        use_in_formula(symbols, row.how);
    }
    return rows;
}

std::vector<SumRow> mean_rows(const std::vector<ProbePoint>& points) {
    std::vector<SumRow> rows;
    if (points.size() < 2) return rows;
    Vec sum{};
    for (const ProbePoint& point : points) {
        rows.push_back({rows.empty() ? "" : "+", point.name, fmt::format("{:.4f} x", point.weight), point.color});
        sum += point.weight * point.color;
    }
    rows.push_back({"=", tr("mean"), tr("of the vertices"), sum, true});
    return rows;
}

std::vector<SumRow> fragment_rows(const Scene& scene, const ProbeAnswer& answer, std::size_t fragment) {
    if (answer.probe.is_vertex || fragment >= answer.pixel.history.fragments.size()) return {};
    const PixelFragment& at = answer.pixel.history.fragments[fragment];
    return {{"", tr("fragment"),
             explain::steps_after_lighting(at, *scene.frame.draws()[at.draw], answer.pixel.look.lecture_variants),
             vec3_cast<Vec>(at.color), true},
            {"", tr("picture"), tr("after it"), vec3_cast<Vec>(at.after), true}};
}

std::vector<Line> after_lighting(const Scene& scene, const ProbeAnswer& answer, std::size_t fragment) {
    if (answer.probe.is_vertex || fragment >= answer.pixel.history.fragments.size()) return {};
    const PixelFragment& at = answer.pixel.history.fragments[fragment];
    return explain::after_lighting_lines(at.steps, *scene.frame.draws()[at.draw], at.corners.empty());
}

std::string rulings_of(const ProbeAnswer& answer, std::size_t fragment) {
    if (answer.probe.is_vertex)
        return fragment < answer.vertex.faces.size()
                   ? explain::rulings_text(answer.vertex.faces[fragment].history.rulings)
                   : "";
    const std::vector<PixelFragment>& fragments = answer.pixel.history.fragments;
    return fragment < fragments.size() ? explain::rulings_text(fragments[fragment].rulings) : "";
}

std::string equation_of(const Derivation& at, Symbols symbols) {
    std::string equation;
    for (const Line& line : explain::derivation_lines(at, false))
        if (line.kind == Line::Kind::kEquation) equation = line.value;
    use_in_formula(symbols, equation);
    return equation;
}

std::vector<Line> lines_of(const Derivation& at, std::optional<int> light, Symbols symbols) {
    std::vector<Line> lines = explain::derivation_lines(at, false);
    for (Line& line : lines)
        for (std::string* text : {&line.what, &line.value, &line.how}) use(symbols, *text);
    if (light) {
        std::erase_if(lines, [&](const Line& line) { return line.light != light || line.kind == Line::Kind::kLight; });
        return lines;
    }
    // Up to the equation; the sum shows the rest.
    lines.erase(std::ranges::find(lines, Line::Kind::kEquation, &Line::kind), lines.end());
    return lines;
}

std::string probe_text(const Scene& scene, ProbeAnswer answer, const std::vector<explain::Rendered>& rendered) {
    if (!answer.trouble.empty()) return answer.trouble + "\n";
    if (answer.probe.is_vertex) return explain::text_of(scene, answer.vertex, {.all = true});
    answer.pixel.rendered = rendered;
    return explain::text_of(scene, answer.pixel, {.all = true});
}

}  // namespace twinlight::session
