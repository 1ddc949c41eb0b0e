#include "app/cli/explain_pixel.h"

#include <fmt/format.h>

#include <charconv>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "app/cli/command_line.h"
#include "app/cli/renderers.h"
#include "render/reference/pixel_history.h"
#include "scene/state/lecture_variants.h"

namespace twinlight::cli {

namespace {

using reference::LitPoint;
using reference::PixelFragment;
using reference::Vec;

const char* words_of(Shading shading) {
    switch (shading) {
        case Shading::kFlat: return "flat: terms of the provoking vertex";
        case Shading::kGouraud: return "gouraud: terms interpolated between the vertices; factors are averages";
        case Shading::kPhong: return "phong: terms computed at this pixel";
        case Shading::kExact:
            return "exact: terms computed on the exact surface; for meshes without one, at this pixel";
    }
    return "";
}

struct Rendered {
    const char* renderer;
    Rgba color;
};

// The fixed function only lights vertices.
std::vector<Rendered> rendered(const Scene& scene, const PlanOptions& options, const Pixel& pixel,
                               const Rgba& reference) {
    const Frame& frame = scene.frame;
    const RendererSet set(frame.width, frame.height);
    const compare::Renderers& functions = set.functions();
    std::vector<Rendered> result;
    const bool by_pixel = options.shading == Shading::kPhong || options.shading == Shading::kExact;
    if (!by_pixel) result.push_back({"fixed", functions.fixed(scene, {options.shading}).at(pixel.x, pixel.y)});
    result.push_back({"programmable", functions.programmable(frame, {options}).image.at(pixel.x, pixel.y)});
    result.push_back({"reference", reference});
    return result;
}

// ---- As text ----

std::string color(const Vec& c) { return fmt::format("{:>9.5f} {:>9.5f} {:>9.5f}", c.x, c.y, c.z); }

std::string row(const std::string& what, const std::string& factors, const Vec& c) {
    return fmt::format("  {:<24} {:<44} {}\n", what, factors, color(c));
}

std::string bold(const std::string& text) { return result_in_color() ? "\x1b[1m" + text + "\x1b[0m" : text; }

std::vector<std::string> names_of(const std::vector<int>& lights) {
    std::vector<std::string> names;
    for (const int light : lights) names.push_back(light_name(light));
    return names;
}

// Turns "att spot n.VP d_cm d_cli" into "att 0.50000  spot 1.00000  n.VP 0.80000"; unchanged if it has only colours.
std::string factors_of(const char* formula, const lighting::LightTerms<double>& terms) {
    std::string text;
    std::istringstream words(formula);
    for (std::string word; words >> word;) {
        if (word.find("_c") != word.npos) continue;
        const double factor = word == "att"    ? terms.attenuation
                              : word == "spot" ? terms.spot
                              : word == "n.VP" ? terms.n_dot_vp
                                               : terms.highlight;
        text += fmt::format("{}{} {:.5f}", text.empty() ? "" : "  ", word, factor);
    }
    return text.empty() ? formula : text;
}

// "for GL_LIGHT0 the specification is silent (a zero normal); our choice: ambient and emission only"
std::string ruling_text(const PixelFragment::Decided& decided) {
    const lighting::RulingText& text = lighting::text_of(decided.ruling);
    const std::vector<std::string> lights = names_of(decided.lights);
    return fmt::format("  {}{}{}the specification is silent ({}); our choice: {}\n", lights.empty() ? "" : "for ",
                       fmt::join(lights, ", "), lights.empty() ? "" : " ", text.state, text.answer);
}

std::string fragment_text(const PixelFragment& fragment, const Draw& draw) {
    std::string text =
        bold(fmt::format("draw {}, {}", fragment.draw + 1, draw.place.str())) +
        fmt::format(": {} face, depth {:.6f}{}\n", fragment.face == reference::Face::kFront ? "front" : "back",
                    fragment.depth, fragment.passes ? "" : ", discarded by a test");
    if (fragment.is_lit) {
        const LitPoint mean = mean_of(fragment);
        text += fmt::format("  {}\n  {:<24} {:<44} {:>9} {:>9} {:>9}\n", words_of(fragment.shading), "", "", "red",
                            "green", "blue");
        text += row("emission", "e_cm", mean.material.emission);
        text += row("scene ambient", "a_cm a_cs", mean.scene_ambient);
        for (std::size_t i = 0; i < fragment.lights.size(); ++i) {
            const lighting::LightTerms<double>& terms = mean.terms[i];
            const std::string name = light_name(fragment.lights[i]);
            text += row(name + " ambient", factors_of(mean.formulas.ambient, terms), terms.ambient);
            text += row(name + " diffuse", factors_of(mean.formulas.diffuse, terms), terms.diffuse);
            text += row(name + " specular", factors_of(mean.formulas.specular, terms), terms.specular);
        }
        text += row("primary colour", "before clamping", mean.primary);
        if (draw.lighting.light_model.color_control == kGL_SEPARATE_SPECULAR_COLOR)
            text += row("secondary colour", "before clamping", mean.secondary);
    } else {
        text += "  GL_LIGHTING is disabled\n";
    }
    text += row("fragment",
                draw.fragment.srgb_coded ? "after clamping, texture, sum, fog and sRGB"
                                         : "after clamping, texture, colour sum and fog",
                vec3_cast<Vec>(fragment.color));
    for (const PixelFragment::Decided& decided : fragment.rulings) text += ruling_text(decided);
    return text;
}

// ---- As JSON ----

using Json = nlohmann::ordered_json;

Json json_of(const Vec& c) { return {c.x, c.y, c.z}; }

Json json_of(const PixelFragment& fragment, const Draw& draw) {
    Json json = {{"draw", fragment.draw + 1},
                 {"place", draw.place.str()},
                 {"face", fragment.face == reference::Face::kFront ? "front" : "back"},
                 {"depth", fragment.depth},
                 {"passes", fragment.passes},
                 {"lit", fragment.is_lit}};
    if (fragment.is_lit) {
        const LitPoint mean = mean_of(fragment);
        json["emission"] = json_of(mean.material.emission);
        json["scene_ambient"] = json_of(mean.scene_ambient);
        json["lights"] = Json::array();
        for (std::size_t i = 0; i < fragment.lights.size(); ++i) {
            const lighting::LightTerms<double>& terms = mean.terms[i];
            json["lights"].push_back({{"name", light_name(fragment.lights[i])},
                                      {"attenuation", terms.attenuation},
                                      {"spot", terms.spot},
                                      {"n_dot_vp", terms.n_dot_vp},
                                      {"highlight", terms.highlight},
                                      {"ambient", json_of(terms.ambient)},
                                      {"diffuse", json_of(terms.diffuse)},
                                      {"specular", json_of(terms.specular)},
                                      {"formulas",
                                       {{"ambient", mean.formulas.ambient},
                                        {"diffuse", mean.formulas.diffuse},
                                        {"specular", mean.formulas.specular}}}});
        }
        json["primary_unclamped"] = json_of(mean.primary);
        json["secondary_unclamped"] = json_of(mean.secondary);
    }
    json["color"] = json_of(vec3_cast<Vec>(fragment.color));
    json["rulings"] = Json::array();
    for (const PixelFragment::Decided& decided : fragment.rulings) {
        const lighting::RulingText& text = lighting::text_of(decided.ruling);
        json["rulings"].push_back(
            {{"state", text.state}, {"answer", text.answer}, {"lights", names_of(decided.lights)}});
    }
    return json;
}

}  // namespace

Pixel parse_pixel(const std::string& text, const Frame& frame) {
    Pixel pixel;
    const char* end = text.data() + text.size();
    const auto x = std::from_chars(text.data(), end, pixel.x);
    bool good = x.ec == std::errc() && x.ptr != end && *x.ptr == ',';
    if (good) {
        const auto y = std::from_chars(x.ptr + 1, end, pixel.y);
        good = y.ec == std::errc() && y.ptr == end;
    }
    if (!good) throw UsageError(fmt::format("--pixel is '{}'; it must be X,Y, such as 320,240", one_line(text)));
    if (pixel.x < 0 || pixel.y < 0 || pixel.x >= frame.width || pixel.y >= frame.height) {
        throw UsageError(fmt::format("--pixel {} is outside the picture; the last pixel is {},{}", text,
                                     frame.width - 1, frame.height - 1));
    }
    return pixel;
}

std::string explain_pixel(const Scene& scene, const PlanOptions& options, const Pixel& pixel, bool as_json) {
    const Frame& frame = scene.frame;
    const reference::PixelHistory history =
        reference::pixel_history(frame, reference::Options{options}, pixel.x, frame.height - 1 - pixel.y);
    const std::vector<PixelFragment>& fragments = history.fragments;
    const std::vector<Rendered> pictures = rendered(scene, options, pixel, history.color);
    const std::vector<const Draw*> draws = frame.draws();
    if (as_json) {
        Json json = {{"scene", scene.name()}, {"pixel", {pixel.x, pixel.y}}, {"fragments", Json::array()}};
        for (const PixelFragment& fragment : fragments)
            json["fragments"].push_back(json_of(fragment, *draws[fragment.draw]));
        for (const Rendered& picture : pictures)
            json["pictures"][picture.renderer] = {picture.color[0], picture.color[1], picture.color[2]};
        return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
    }
    std::string text = fmt::format(
        "{}, pixel {},{} of {} x {}: {}\n", scene.name(), pixel.x, pixel.y, frame.width, frame.height,
        fragments.empty() ? "no draw covers it"
                          : fmt::format("{} fragment{}, in order", fragments.size(), fragments.size() == 1 ? "" : "s"));
    if (std::ranges::any_of(fragments, &PixelFragment::is_lit))
        text += "The symbols are those of OpenGL 2.1, section 2.14.1; docs/lighting.md explains them.\n";
    bool variants = false;
    for (const PixelFragment& fragment : fragments) {
        text += "\n" + fragment_text(fragment, *draws[fragment.draw]);
        variants = variants || has_variants(*draws[fragment.draw]);
    }
    text += "\n";
    for (const Rendered& picture : pictures) {
        const Vec c{picture.color[0], picture.color[1], picture.color[2]};
        text += row(picture.renderer,
                    fmt::format("8-bit values {} {} {}", channel_code(picture.color[0]), channel_code(picture.color[1]),
                                channel_code(picture.color[2])),
                    c);
    }
    if (variants && pictures.front().renderer == std::string_view("fixed"))
        text += "  (programmable and reference follow the scene's pragmas; GL's fixed function cannot)\n";
    return text;
}

}  // namespace twinlight::cli
