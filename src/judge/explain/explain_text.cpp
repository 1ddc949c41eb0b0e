// An explanation as text.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "base/text/translation.h"
#include "judge/explain/derivation_light.h"
#include "judge/explain/explain.h"
#include "scene/command/text.h"
#include "scene/frame/lecture_variants.h"

namespace twinlight::explain {

namespace {

using reference::Face;
using reference::LitPoint;
using reference::PixelFragment;
using reference::Vec;

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

std::string point_head(const LitPoint& point, std::size_t draw, bool two_side, bool in_color) {
    const std::string where =
        point.vertex ? fmt::format("vertex {} of draw {}", *point.vertex + 1, draw) : "this pixel";
    return "\n  " + bold(where, in_color) + (two_side ? ", " + face_words(point.face) : "") + "\n";
}

std::string calls_of(const Place& place, const TextOptions& options) {
    return options.calls && place.calls ? fmt::format(" ({})", one_line(*place.calls)) : "";
}

std::string fragment_head(const PixelFragment& fragment, const Draw& draw, const TextOptions& options) {
    return bold(fmt::format("draw {}, {}", fragment.draw + 1, draw.place.str()), options.in_color) +
           calls_of(draw.place, options) + fmt::format(": {}, depth {:.6f}", face_words(fragment.face), fragment.depth);
}

// Where a Draw without lighting has its colour from.
std::string unlit_text(const Scene& scene, const Draw& draw) {
    constexpr const char* kRasterPosition =
        "  GL_LIGHTING is disabled: the colour is the raster position's, glColor's at that time (2.13)\n";
    if (!draw.pixels) return "  GL_LIGHTING is disabled: the colour is glColor's, and no light matters\n";
    if (draw.pixels->has_stencils) return "  a stencil value is written, and no colour (4.3.1)\n";
    if (draw.pixels->copied)
        return draw.pixels->copied->source.pixels->buffer == CopiedBuffer::kColors
                   ? "  glCopyPixels: the colour is that of a pixel of the picture before it (4.3.3)\n"
                   : kRasterPosition;
    bool has_own_colors = false;
    scene.recording->for_each([&](const Step& step) {
        const bool draws = step.kind == Step::Kind::kCommand && step.command.id == CommandId::glDrawPixels;
        has_own_colors = has_own_colors || (draws && step.command.place == draw.place &&
                                            step.command.enumerant(2) != kGL_DEPTH_COMPONENT);
        return !has_own_colors;
    });
    return has_own_colors ? "  glDrawPixels: the colour is the pixel's own (3.6.4)\n" : kRasterPosition;
}

std::string fragment_text(const PixelFragment& fragment, const Scene& scene, const Draw& draw, bool lecture_variants,
                          const TextOptions& options) {
    std::string text = fragment_head(fragment, draw, options) + (fragment.passes ? "\n" : "; discarded by a test\n");
    if (fragment.is_lit) {
        text += corners_text(fragment, draw);
        const auto heaviest = std::ranges::max_element(fragment.points, {}, &LitPoint::weight);
        for (const LitPoint& point : fragment.points) {
            if (!options.all && &point != &*heaviest) continue;
            text += point_head(point, fragment.draw + 1, draw.lighting.light_model.two_side, options.in_color);
            text += derivation_text({scene.frame, draw, fragment.draw + 1, fragment.lights, point, lecture_variants},
                                    options);
        }
        if (!options.all && fragment.points.size() > 1) {
            text += "\n  For the other vertices:";
            for (const LitPoint& point : fragment.points)
                if (&point != &*heaviest) text += fmt::format(" --vertex {},{}", fragment.draw + 1, *point.vertex + 1);
            text += " (or --all)\n";
        }
    } else {
        text += unlit_text(scene, draw);
    }
    for (const Line& line : after_lighting_lines(fragment.steps, draw, fragment.corners.empty()))
        text += (line.kind == Line::Kind::kHeadingOfColors ? "\n" : "") + text_of(line, options.in_color);
    text += "\n" + color_row("fragment", steps_after_lighting(fragment, draw, lecture_variants),
                             vec3_cast<Vec>(fragment.color));
    return text + rulings_text(fragment.rulings);
}

std::string pictures_text(const std::vector<Rendered>& pictures, bool variants) {
    if (pictures.empty()) return "";
    std::string text = "\n" + color_head("What each renderer gives");
    for (const Rendered& picture : pictures)
        text += color_row(std::string(name_of(picture.renderer)),
                          fmt::format("8-bit values {} {} {}", channel_code(picture.color[0]),
                                      channel_code(picture.color[1]), channel_code(picture.color[2])),
                          {picture.color[0], picture.color[1], picture.color[2]});
    if (variants && pictures.front().renderer == Path::kFixed)
        text += "  (shaders and reference are with the scene's variants, which the fixed function lacks)\n";
    return text;
}

// "12 to 14", in 8-bit values.
std::string codes_text(float low, float high) {
    const int from = channel_code(low), to = channel_code(high);
    return from == to ? fmt::format("{}", from) : fmt::format("{} to {}", from, to);
}

std::string joined(const std::vector<Why>& whys, std::string_view between) {
    std::string text;
    for (const Why why : whys) text += fmt::format("{}{}", text.empty() ? "" : between, words_of(why));
    return text;
}

std::string allowed_text(const AllowedPixel& allowed) {
    std::string text = "\nWhat OpenGL leaves open here (docs/edges.md)\n";
    if (!allowed.undefined.empty()) text += fmt::format("  the colour, because {}\n", allowed.undefined);
    if (!allowed.edge) {
        const float most = std::max({allowed.channels[0], allowed.channels[1], allowed.channels[2]});
        if (most == 0)
            return allowed.undefined.empty() ? text + "  nothing but rounding: the pixel is away from edges\n" : text;
        return text + fmt::format("  away from edges, a channel may be off by {:.1f}/255: {}\n", 255 * most,
                                  joined(allowed.why, ", "));
    }
    text += "  the pixel is at an edge";
    if (!allowed.why.empty()) text += ": " + joined(allowed.why, "; ");
    if (allowed.ranges.empty()) return text + ". It may have any colour\n";
    text += allowed.ranges.size() == 1 ? ". It has a colour in this range, in 8-bit values:\n"
                                       : ". It has one of these colours, in 8-bit values:\n";
    for (const AllowedRange& range : allowed.ranges)
        text += fmt::format("    red {}, green {}, blue {}\n", codes_text(range.low[0], range.high[0]),
                            codes_text(range.low[1], range.high[1]), codes_text(range.low[2], range.high[2]));
    return text;
}

}  // namespace

std::string steps_after_lighting(const PixelFragment& fragment, const Draw& draw, bool lecture_variants) {
    std::string steps = tr("after clamping");
    if (draw.combines_textures())
        steps += tr(", textures (3.8)");
    else if (draw.texture.texture)
        steps += tr(", texture (3.8)");
    const bool separates = fragment.is_lit && draw.lighting.light_model.color_control == kGL_SEPARATE_SPECULAR_COLOR;
    if (separates || draw.column(VertexAttribute::kSecondaryColor)) steps += tr(", colour sum (3.9)");
    if (draw.fog.enabled) steps += tr(", fog (3.10)");
    if (lecture_variants && draw.fragment.srgb_coded) steps += tr(", sRGB");
    return steps;
}

std::size_t first_seen(const Frame& frame, const std::vector<PixelFragment>& fragments) {
    if (accumulates(frame)) return 0;
    const std::vector<const Draw*> draws = frame.draws();
    for (std::size_t i = fragments.size(); i > 0; --i) {
        const FragmentState& state = draws[fragments[i - 1].draw]->fragment;
        if (fragments[i - 1].passes && !state.blend && state.color_mask == std::array{true, true, true, true})
            return i - 1;
    }
    return 0;
}

std::string almost_one_depth(const Frame& frame, const std::vector<PixelFragment>& fragments) {
    // Drivers compute depths in floats and store them in 24 bits. What is drawn twice has exactly one depth (appendix A).
    constexpr double kRounding = 16.0 / (1 << 24);
    const std::vector<const Draw*> draws = frame.draws();
    const auto shown = std::find_if(fragments.rbegin(), fragments.rend(), std::mem_fn(&PixelFragment::passes));
    if (shown == fragments.rend() || !draws[shown->draw]->raster.depth_test) return "";
    std::set<std::size_t> numbers;
    for (const PixelFragment& fragment : fragments) {
        const double difference = std::abs(fragment.depth - shown->depth);
        if (difference > 0 && difference < kRounding && draws[fragment.draw]->raster.depth_test)
            numbers.insert(fragment.draw + 1);
    }
    if (numbers.empty()) return "";
    numbers.insert(shown->draw + 1);
    return fmt::format(
        "Surfaces of {} {} have almost the same depth here, so rounding decides which one shows. "
        "glPolygonOffset keeps them apart (3.5.5).",
        numbers.size() == 1 ? "draw" : "draws", fmt::join(numbers, ", "));
}

std::string text_of(const Scene& scene, const PixelExplanation& explanation, const TextOptions& options) {
    const Frame& frame = scene.frame;
    const Pixel& pixel = explanation.pixel;
    const std::vector<PixelFragment>& fragments = explanation.history.fragments;
    const std::vector<const Draw*> draws = frame.draws();
    std::string text = fmt::format(
        "{}, pixel {},{} of {} x {}: {}\n", scene.title(), pixel.x, pixel.y, frame.width, frame.height,
        fragments.empty() ? "by the reference, no draw covers it, so it shows what glClear left"
                          : fmt::format("{} fragment{}, in order", fragments.size(), fragments.size() == 1 ? "" : "s"));
    if (accumulates(frame)) text += "glAccum combines pictures here, so earlier fragments may show too (4.2.4).\n";
    if (std::ranges::any_of(fragments, &PixelFragment::is_lit)) text += legend();
    const std::size_t first_seen = explain::first_seen(frame, fragments);
    bool variants = false;
    for (std::size_t i = 0; i < fragments.size(); ++i) {
        const PixelFragment& fragment = fragments[i];
        const Draw& draw = *draws[fragment.draw];
        variants = variants || (explanation.look.lecture_variants && has_variants(draw));
        text += "\n";
        if (!options.all && !fragment.passes)
            text += fragment_head(fragment, draw, options) + "; discarded by a test, so it does not show\n";
        else if (!options.all && i < first_seen)
            text += fragment_head(fragment, draw, options) + "; a later draw covers it\n";
        else
            text += fragment_text(fragment, scene, draw, explanation.look.lecture_variants, options);
    }
    if (const std::string note = almost_one_depth(frame, fragments); !note.empty()) text += "\n" + note + "\n";
    text += pictures_text(explanation.rendered, variants);
    return explanation.allowed ? text + allowed_text(*explanation.allowed) : text;
}

std::string text_of(const Scene& scene, const VertexExplanation& explanation, const TextOptions& options) {
    const auto [number, vertex] = explanation.vertex;
    const Draw& draw = *scene.frame.draws()[number];
    std::string text = fmt::format("{}, vertex {} of the {} of draw {}, {}\n", scene.title(), vertex + 1,
                                   draw.vertices.size(), number + 1, draw.place.str() + calls_of(draw.place, options)) +
                       legend();
    for (const FaceExplanation& face : explanation.faces) {
        const reference::VertexHistory& history = face.history;
        text += point_head(history.point, number + 1, explanation.faces.size() > 1, options.in_color) +
                derivation_text(
                    {scene.frame, draw, number + 1, history.lights, history.point, explanation.look.lecture_variants},
                    options) +
                rulings_text(history.rulings) +
                pictures_text(face.rendered, explanation.look.lecture_variants && has_variants(draw));
    }
    return text;
}

}  // namespace twinlight::explain
