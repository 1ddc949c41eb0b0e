#include "app/cli/explain_pixel.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "app/cli/command_line.h"
#include "app/cli/derivation_light.h"
#include "app/cli/renderers.h"
#include "render/context/context.h"
#include "render/fixed/replay.h"
#include "render/reference/pixel_history.h"
#include "render/reference/reference.h"
#include "scene/command/text.h"
#include "scene/state/lecture_variants.h"

namespace twinlight::cli {

namespace {

using reference::Face;
using reference::LitPoint;
using reference::PixelFragment;
using reference::Vec;

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

// A picture of one pixel that shows the vertex as a point: the projection moves it to the middle, and only lighting is
// left of the state. Points show the front, so the back face becomes the front.
Frame picture_of(const Draw& draw, std::uint32_t vertex, Face face) {
    Draw point;
    point.mode = kGL_POINTS;
    point.vertices = {draw.vertices[vertex]};
    point.lighting = draw.lighting;
    point.lighting.shade_model = kGL_SMOOTH;
    point.lighting.light_model.two_side = false;
    const Materials materials = draw.materials.empty() ? Materials{draw.lighting.front, draw.lighting.back}
                                                       : draw.materials[point.vertices[0].material];
    point.vertices[0].material = 0;
    point.lighting.front = face == Face::kFront ? materials.front : materials.back;
    if (face == Face::kBack) {
        ColorMaterial& tracking = point.lighting.color_material;
        tracking.enabled = tracking.enabled && tracking.face != kGL_FRONT;
        tracking.face = kGL_FRONT_AND_BACK;
        point.vertices[0].normal_object = -point.vertices[0].normal_object;
    }
    point.raster.viewport = {0, 0, 1, 1};
    point.eye_from_object = draw.eye_from_object;
    const double w_eye = (draw.eye_from_object * point.vertices[0].position_object).w;
    point.clip_from_eye = glm::dmat4(0);
    point.clip_from_eye[3][3] = w_eye < 0 ? -1 : 1;
    point.place = draw.place;
    Frame frame{.width = 1, .height = 1};
    frame.items.emplace_back(std::move(point));
    return frame;
}

std::vector<Rendered> rendered(const Frame& picture, const PlanOptions& options) {
    const RendererSet set(picture.width, picture.height);
    std::vector<Rendered> result;
    fixed::Replay(picture, {.budget = options.budget, .patches = false}).draw();
    result.push_back({"fixed", read_pixels(picture.width, picture.height).at(0, 0)});
    result.push_back({"programmable", set.functions().programmable(picture, {options}).image.at(0, 0)});
    result.push_back({"reference", reference::render(picture, reference::Options{options}).at(0, 0)});
    return result;
}

// ---- As text ----

std::string face_words(Face face) { return face == Face::kFront ? "front face" : "back face"; }

std::string legend() {
    return "All lines follow OpenGL 2.1, section 2.14.1, in eye coordinates. VP: the direction to the light (L); VP_e: "
           "to the\n"
           "viewer (V); h: half-way between them (H); n: the normal. docs/lighting.md lists all symbols.\n";
}

// Where the fragment's colour comes from: its corners and their shares.
std::string corners_text(const PixelFragment& fragment, const Draw& draw) {
    std::string text;
    switch (fragment.shading) {
        case Shading::kFlat:
            return fmt::format(
                "  flat: the whole primitive has the colour of its provoking vertex, number {} (2.14.7)\n",
                *fragment.points.front().vertex + 1);
        case Shading::kPhong:
            text = "  phong: this pixel is lit with what lies between these vertices:";
            for (const PixelFragment::Corner& corner : fragment.corners)
                text += fmt::format("{} {:.5f} of number {}", &corner == fragment.corners.data() ? "" : ",",
                                    corner.weight, corner.vertex + 1);
            return text + "\n";
        case Shading::kExact: return "  exact: this point of the curved surface is lit; a mesh is lit at this pixel\n";
        case Shading::kGouraud: break;
    }
    const bool separate = draw.lighting.light_model.color_control == kGL_SEPARATE_SPECULAR_COLOR;
    text = "  gouraud: the mean of the vertices' clamped colours, weighted by their distances to the pixel (3.5.1)\n";
    const auto add = [&](const char* name, Vec LitPoint::*color) {
        text += color_head(fmt::format("  {}", name));
        Vec sum{};
        for (const LitPoint& point : fragment.points) {
            const Vec of_vertex = clamped_color(point.*color);
            text += color_row(fmt::format("number {}", *point.vertex + 1), fmt::format("weight {:.5f}", point.weight),
                              of_vertex);
            sum += point.weight * of_vertex;
        }
        text += color_row("mean", "the sum of weight times colour", sum);
    };
    add(separate ? "primary colour" : "colour", &LitPoint::primary);
    if (separate) add("secondary colour", &LitPoint::secondary);
    return text;
}

std::string point_head(const LitPoint& point, std::size_t draw, bool two_side) {
    const std::string where =
        point.vertex ? fmt::format("vertex {} of draw {}", *point.vertex + 1, draw) : "this pixel";
    return "\n  " + bold(where) + (two_side ? ", " + face_words(point.face) : "") + "\n";
}

std::string fragment_head(const PixelFragment& fragment, const Draw& draw) {
    return bold(fmt::format("draw {}, {}", fragment.draw + 1, draw.place.str())) +
           fmt::format(": {}, depth {:.6f}", face_words(fragment.face), fragment.depth);
}

// What happens to the lit colour before blending: "after clamping, texture and fog".
std::string steps_after_lighting(const PixelFragment& fragment, const Draw& draw) {
    std::vector<std::string> steps = {"clamping"};
    if (draw.texture.texture) steps.emplace_back("texture (3.8)");
    if (fragment.is_lit && draw.lighting.light_model.color_control == kGL_SEPARATE_SPECULAR_COLOR)
        steps.emplace_back("colour sum (3.9)");
    if (draw.fog.enabled) steps.emplace_back("fog (3.10)");
    if (draw.fragment.srgb_coded) steps.emplace_back("sRGB");
    return fmt::format("after {}", fmt::join(steps, ", "));
}

std::string fragment_text(const PixelFragment& fragment, const Scene& scene, const Draw& draw, bool all) {
    std::string text = fragment_head(fragment, draw) + (fragment.passes ? "\n" : "; discarded by a test\n");
    if (fragment.is_lit) {
        text += corners_text(fragment, draw);
        const auto heaviest = std::ranges::max_element(fragment.points, {}, &LitPoint::weight);
        for (const LitPoint& point : fragment.points) {
            if (!all && &point != &*heaviest) continue;
            text += point_head(point, fragment.draw + 1, draw.lighting.light_model.two_side);
            text += derivation_text({scene.frame, draw, fragment.draw + 1, fragment.lights, point}, all);
        }
        if (!all && fragment.points.size() > 1) {
            text += "\n  For the other vertices:";
            for (const LitPoint& point : fragment.points)
                if (&point != &*heaviest) text += fmt::format(" --vertex {},{}", fragment.draw + 1, *point.vertex + 1);
            text += " (or --all)\n";
        }
    } else {
        text += "  GL_LIGHTING is disabled: the colour is glColor's, and no light matters\n";
    }
    text += "\n" + color_row("fragment", steps_after_lighting(fragment, draw), vec3_cast<Vec>(fragment.color));
    return text + rulings_text(fragment.rulings);
}

// The last fragment that hides all earlier ones; 0 if there is none.
std::size_t first_seen_of(const std::vector<PixelFragment>& fragments, const std::vector<const Draw*>& draws) {
    for (std::size_t i = fragments.size(); i > 0; --i) {
        const FragmentState& state = draws[fragments[i - 1].draw]->fragment;
        if (fragments[i - 1].passes && !state.blend && state.color_mask == std::array{true, true, true, true})
            return i - 1;
    }
    return 0;
}

std::string pictures_text(const std::vector<Rendered>& pictures, bool variants) {
    std::string text = "\n" + color_head("The same by each renderer");
    for (const Rendered& picture : pictures)
        text += color_row(picture.renderer,
                          fmt::format("8-bit values {} {} {}", channel_code(picture.color[0]),
                                      channel_code(picture.color[1]), channel_code(picture.color[2])),
                          {picture.color[0], picture.color[1], picture.color[2]});
    if (variants && pictures.front().renderer == std::string_view("fixed"))
        text += "  (programmable and reference follow the scene's pragmas; GL's fixed function cannot)\n";
    return text;
}

// ---- As JSON ----

// Means over the fragment's points; "points" has each.
Json mean_json(const LitPoint& mean, const std::vector<int>& lights) {
    Json json = {{"emission", color_json(mean.material.emission)}, {"scene_ambient", color_json(mean.scene_ambient)}};
    json["lights"] = Json::array();
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const lighting::LightTerms<double>& terms = mean.terms[i];
        json["lights"].push_back({{"name", light_name(lights[i])},
                                  {"attenuation", terms.attenuation},
                                  {"spot", terms.spot},
                                  {"n_dot_vp", terms.n_dot_vp},
                                  {"highlight", terms.highlight},
                                  {"ambient", color_json(terms.ambient)},
                                  {"diffuse", color_json(terms.diffuse)},
                                  {"specular", color_json(terms.specular)},
                                  {"formulas",
                                   {{"ambient", mean.formulas.ambient},
                                    {"diffuse", mean.formulas.diffuse},
                                    {"specular", mean.formulas.specular}}}});
    }
    json["primary_unclamped"] = color_json(mean.primary);
    json["secondary_unclamped"] = color_json(mean.secondary);
    return json;
}

Json fragment_json(const PixelFragment& fragment, const Scene& scene, const Draw& draw) {
    Json json = {{"draw", fragment.draw + 1},
                 {"place", draw.place.str()},
                 {"face", fragment.face == Face::kFront ? "front" : "back"},
                 {"depth", fragment.depth},
                 {"passes", fragment.passes},
                 {"lit", fragment.is_lit},
                 {"shading", name_of(fragment.shading)}};
    json["corners"] = Json::array();
    for (const PixelFragment::Corner& corner : fragment.corners)
        json["corners"].push_back({{"vertex", corner.vertex + 1}, {"weight", corner.weight}});
    if (fragment.is_lit) {
        json.update(mean_json(mean_of(fragment), fragment.lights));
        json["points"] = Json::array();
        for (const LitPoint& point : fragment.points)
            json["points"].push_back(derivation_json({scene.frame, draw, fragment.draw + 1, fragment.lights, point}));
    }
    json["color"] = color_json(vec3_cast<Vec>(fragment.color));
    json["rulings"] = rulings_json(fragment.rulings);
    return json;
}

void add_pictures(const std::vector<Rendered>& pictures, Json& json) {
    for (const Rendered& picture : pictures)
        json["pictures"][picture.renderer] = {picture.color[0], picture.color[1], picture.color[2]};
}

// Two whole numbers with a comma between them.
template <class Number>
std::optional<std::pair<Number, Number>> two_numbers(const std::string& text) {
    std::pair<Number, Number> numbers;
    const char* end = text.data() + text.size();
    const auto first = std::from_chars(text.data(), end, numbers.first);
    if (first.ec != std::errc() || first.ptr == end || *first.ptr != ',') return std::nullopt;
    const auto second = std::from_chars(first.ptr + 1, end, numbers.second);
    if (second.ec != std::errc() || second.ptr != end) return std::nullopt;
    return numbers;
}

}  // namespace

Pixel parse_pixel(const std::string& text, const Frame& frame) {
    const auto numbers = two_numbers<int>(text);
    if (!numbers) throw UsageError(fmt::format("--pixel is '{}'; it must be X,Y, such as 320,240", one_line(text)));
    const Pixel pixel{numbers->first, numbers->second};
    if (pixel.x < 0 || pixel.y < 0 || pixel.x >= frame.width || pixel.y >= frame.height) {
        throw UsageError(fmt::format("--pixel {} is outside the picture; the last pixel is {},{}", text,
                                     frame.width - 1, frame.height - 1));
    }
    return pixel;
}

VertexOfDraw parse_vertex(const std::string& text, const Frame& frame) {
    const auto numbers = two_numbers<std::size_t>(text);
    if (!numbers)
        throw UsageError(
            fmt::format("--vertex is '{}'; it must be DRAW,N, such as 1,1 for the first vertex of the "
                        "first draw",
                        one_line(text)));
    const std::vector<const Draw*> draws = frame.draws();
    const auto [draw, vertex] = *numbers;
    if (draw < 1 || draw > draws.size())
        throw UsageError(
            fmt::format("--vertex {}: there is no draw {}; the scene has draws 1 to {}", text, draw, draws.size()));
    const std::size_t count = draws[draw - 1]->vertices.size();
    if (vertex < 1 || vertex > count)
        throw UsageError(
            fmt::format("--vertex {}: draw {} has no vertex {}; it has vertices 1 to {}", text, draw, vertex, count));
    return {draw - 1, vertex - 1};
}

std::string explain_pixel(const Scene& scene, const ExplainOptions& options, const Pixel& pixel) {
    const Frame& frame = scene.frame;
    const reference::PixelHistory history =
        reference::pixel_history(frame, reference::Options{options.plan}, pixel.x, frame.height - 1 - pixel.y);
    const std::vector<PixelFragment>& fragments = history.fragments;
    const std::vector<Rendered> pictures = rendered(scene, options.plan, pixel, history.color);
    const std::vector<const Draw*> draws = frame.draws();
    if (options.as_json) {
        Json json = {{"scene", scene.name()}, {"pixel", {pixel.x, pixel.y}}, {"fragments", Json::array()}};
        for (const PixelFragment& fragment : fragments)
            json["fragments"].push_back(fragment_json(fragment, scene, *draws[fragment.draw]));
        add_pictures(pictures, json);
        return dumped(json);
    }
    std::string text = fmt::format(
        "{}, pixel {},{} of {} x {}: {}\n", scene.name(), pixel.x, pixel.y, frame.width, frame.height,
        fragments.empty() ? "no draw covers it, so it shows what glClear left"
                          : fmt::format("{} fragment{}, in order", fragments.size(), fragments.size() == 1 ? "" : "s"));
    if (std::ranges::any_of(fragments, &PixelFragment::is_lit)) text += legend();
    const std::size_t first_seen = first_seen_of(fragments, draws);
    bool variants = false;
    for (std::size_t i = 0; i < fragments.size(); ++i) {
        const PixelFragment& fragment = fragments[i];
        const Draw& draw = *draws[fragment.draw];
        variants = variants || has_variants(draw);
        text += "\n";
        if (!options.all && !fragment.passes)
            text += fragment_head(fragment, draw) + "; discarded by a test, so it does not show\n";
        else if (!options.all && i < first_seen)
            text += fragment_head(fragment, draw) + "; a later draw covers it\n";
        else
            text += fragment_text(fragment, scene, draw, options.all);
    }
    return text + pictures_text(pictures, variants);
}

std::string explain_vertex(const Scene& scene, const ExplainOptions& options, const VertexOfDraw& at) {
    const Draw& draw = *scene.frame.draws()[at.draw];
    const auto vertex = static_cast<std::uint32_t>(at.vertex);
    if (!draw.lighting.enabled)
        throw UsageError(
            fmt::format("--vertex {},{}: draw {} is not lit; GL_LIGHTING is disabled, so its vertices keep "
                        "glColor's colours",
                        at.draw + 1, at.vertex + 1, at.draw + 1));
    std::vector<Face> faces = {Face::kFront};
    if (draw.lighting.light_model.two_side && draws_polygons(draw.mode)) faces.push_back(Face::kBack);
    Json json = {
        {"scene", scene.name()}, {"draw", at.draw + 1}, {"vertex", at.vertex + 1}, {"place", draw.place.str()}};
    std::string text = fmt::format("{}, vertex {} of the {} of draw {}, {}\n", scene.name(), at.vertex + 1,
                                   draw.vertices.size(), at.draw + 1, draw.place.str()) +
                       legend();
    for (const Face face : faces) {
        const reference::VertexHistory history =
            reference::vertex_history(draw, reference::Options{options.plan}, vertex, face);
        const std::vector<Rendered> pictures = rendered(picture_of(draw, vertex, face), options.plan);
        const Derivation derivation{scene.frame, draw, at.draw + 1, history.lights, history.point};
        if (options.as_json) {
            Json one = derivation_json(derivation);
            one["rulings"] = rulings_json(history.rulings);
            add_pictures(pictures, one);
            json["faces"].push_back(std::move(one));
            continue;
        }
        text += point_head(history.point, at.draw + 1, faces.size() > 1) + derivation_text(derivation, options.all) +
                rulings_text(history.rulings) + pictures_text(pictures, has_variants(draw));
    }
    return options.as_json ? dumped(json) : text;
}

}  // namespace twinlight::cli
