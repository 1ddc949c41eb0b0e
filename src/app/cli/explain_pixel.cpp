#include "app/cli/explain_pixel.h"

#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <utility>
#include <vector>

#include "app/cli/command_line.h"
#include "app/cli/exercise.h"
#include "app/cli/renderers.h"
#include "judge/explain/explain.h"
#include "render/context/context.h"
#include "render/fixed/replay.h"
#include "render/reference/reference.h"
#include "render/reference/undefined_colors.h"
#include "scene/command/text.h"

namespace twinlight::cli {

namespace {

using explain::Pixel;
using explain::Rendered;
using explain::VertexOfDraw;

// The fixed function only lights vertices.
std::vector<Rendered> rendered(const Scene& scene, const PlanOptions& options, const Pixel& pixel,
                               const Rgba& reference) {
    const Frame& frame = scene.frame;
    name_gl();
    const RendererSet set(frame.width, frame.height);
    const compare::Renderers& functions = set.functions();
    std::vector<Rendered> result;
    if (!lights_every_pixel(options.shading))
        result.push_back({Path::kFixed, functions.fixed(scene, {options.shading}).at(pixel.x, pixel.y)});
    result.push_back({Path::kProgrammable, functions.programmable(frame, {options}).at(pixel.x, pixel.y)});
    result.push_back({Path::kReference, reference});
    return result;
}

std::vector<Rendered> rendered(const Frame& picture, const PlanOptions& options) {
    name_gl();
    const RendererSet set(picture.width, picture.height);
    std::vector<Rendered> result;
    fixed::Replay(picture, {.budget = options.budget, .patches = false}).draw();
    result.push_back({Path::kFixed, read_pixels(picture.width, picture.height).at(0, 0)});
    result.push_back({Path::kProgrammable, set.functions().programmable(picture, {options}).at(0, 0)});
    result.push_back({Path::kReference, reference::render(picture, reference::Options{options}).at(0, 0)});
    return result;
}

explain::AllowedPixel allowed_at(const Frame& frame, const Look& look, const Pixel& pixel) {
    const AllowedDifference allowed = reference::allowed_difference(frame, reference::Options{look});
    const std::size_t at = allowed.index(pixel.x, pixel.y);
    explain::AllowedPixel result{.edge = allowed.edge[at], .channels = allowed.channels(at)};
    for (int bit = 0; bit < kWhys; ++bit) {
        const auto why = static_cast<Why>(bit);
        if ((allowed.open[at] & bit_of(why)) != 0 || allowed.allows(why, at)) result.why.push_back(why);
    }
    if (allowed.is_undefined(at))
        if (const auto undefined = reference::first_undefined_color(frame))
            result.undefined = reference::words_of(*undefined);
    if (result.edge && allowed.is_judged(at)) result.ranges = allowed.ranges.at(at);
    return result;
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

// Throws UsageError unless `text` is "X,Y" and inside the frame.
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

// Throws UsageError unless `text` is "DRAW,N", both counted from 1, and the frame has that vertex and lights it.
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
    if (!draws[draw - 1]->lighting.enabled)
        throw UsageError(
            fmt::format("--vertex {},{}: draw {} is not lit; GL_LIGHTING is disabled, so its vertices keep "
                        "glColor's colours",
                        draw, vertex, draw));
    return {draw - 1, vertex - 1};
}

template <class Explanation>
std::string printed(const Scene& scene, const ExplainOptions& options, const Explanation& explanation) {
    if (!options.as_json)
        return text_of(scene, explanation, {.all = options.all, .in_color = result_in_color(), .calls = options.calls});
    auto json = json_of(scene, explanation);
    json["driver"] = name_gl();
    json["library"] = gl_library();
    return dumped_lines(json);
}

}  // namespace

std::string explain_pixel(const Scene& scene, const ExplainOptions& options, const std::string& pixel) {
    explain::PixelExplanation explanation =
        explain::explain_pixel(scene.frame, options.plan, parse_pixel(pixel, scene.frame));
    explanation.rendered = rendered(scene, options.plan, explanation.pixel, explanation.history.color);
    explanation.allowed = allowed_at(scene.frame, options.plan, explanation.pixel);
    return printed(scene, options, explanation);
}

std::string exercise_of_pixel(const Scene& scene, const Look& look, const std::string& pixel) {
    return exercise_page(scene, explain::explain_pixel(scene.frame, look, parse_pixel(pixel, scene.frame)));
}

std::string explain_vertex(const Scene& scene, const ExplainOptions& options, const std::string& vertex) {
    explain::VertexExplanation explanation =
        explain::explain_vertex(scene.frame, options.plan, parse_vertex(vertex, scene.frame));
    const auto [draw, number] = explanation.vertex;
    for (explain::FaceExplanation& face : explanation.faces) {
        const Frame picture = explain::picture_of(*scene.frame.draws()[draw], static_cast<std::uint32_t>(number),
                                                  face.history.point.face);
        face.rendered = rendered(picture, options.plan);
    }
    return printed(scene, options, explanation);
}

}  // namespace twinlight::cli
