#include "judge/fuzz/floats.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "judge/compare/vertex_colors.h"
#include "render/context/driver_name.h"

namespace twinlight::fuzz {

namespace {

using compare::Cause;
using compare::Color;
using compare::Departure;
using compare::FaceColors;
using compare::VertexScene;

static_assert(compare::kMostVertexScenes == Floats::kMostScenes);

// ---- The comparison ----

glm::dvec4 clamped(const glm::dvec4& color) { return glm::clamp(color, 0.0, 1.0); }

// Adds the largest difference of a channel, relative to the magnitude.
void compare(PairDifferences& found, double tolerance, const Color& a, const Color& b, const glm::dvec4& magnitude,
             const std::string& where) {
    ++found.compared;
    if (!a || !b) {
        found.fails = found.only_one_draws = true;
        found.worst = 1;
        found.what = where + ": only one of the two draws this vertex";
        return;
    }
    for (int channel = 0; channel < 4; ++channel) {
        const double relative = std::abs((*a)[channel] - (*b)[channel]) / magnitude[channel];
        if (relative <= found.worst) continue;
        found.worst = std::isnan(relative) ? HUGE_VAL : relative;
        if (relative <= tolerance) continue;
        found.fails = true;
        found.what =
            fmt::format("{}, {}: {:.9g} and {:.9g} differ by {:.1e} of the sum of the terms' magnitudes, {:.3g}", where,
                        std::array{"red", "green", "blue", "alpha"}.at(static_cast<std::size_t>(channel)),
                        (*a)[channel], (*b)[channel], relative, magnitude[channel]);
    }
}

StateDifferences judge(const VertexScene& scene, const std::vector<Color>& fixed_colors,
                       const std::vector<Color>& shader_colors, const compare::DeparturesOfScene& departures) {
    StateDifferences found;
    const bool back = scene.shows_back();
    const bool has_shaders = !scene.draw().lighting.light_model.two_side || !draws_polygons(scene.draw().mode) ||
                             compare::knows_faces_of_corners();
    const bool is_sum = scene.draw().lighting.light_model.color_control != kGL_SINGLE_COLOR;
    for (std::size_t i = 0; i < scene.lit.size(); ++i) {
        const FaceColors face = compare::face_colors(scene.lit[i], back);
        const glm::dvec4 magnitude = glm::max(face.magnitude, glm::dvec4(1e-30));
        const glm::dvec4 at_least_1 = glm::max(magnitude, glm::dvec4(1));
        const std::string where = fmt::format("vertex {}, {} face", i, back ? "back" : "front");

        std::array<PairDifferences, kPairs> here;
        const auto of = [&](RendererPair pair) -> PairDifferences& { return here[static_cast<std::size_t>(pair)]; };
        const double tolerance = compare::vertex_tolerance(scene.draw(), scene.draw().vertices[i]);
        compare(of(RendererPair::kFixedReference), tolerance, fixed_colors[i], face.primary, magnitude, where);
        compare(of(RendererPair::kProgrammableReference), tolerance, shader_colors[i], face.sum(), at_least_1, where);
        if (!is_sum) {  // feedback returns only the primary colour
            const Color fixed = fixed_colors[i] ? Color(clamped(*fixed_colors[i])) : Color();
            compare(of(RendererPair::kFixedProgrammable), 2 * tolerance, fixed, shader_colors[i], at_least_1, where);
        }

        const Departure* departure = departures.at(scene.draw(), scene.draw().vertices[i]);
        if (departure) {
            LeftOutCount& count = found.left_out[departure];
            ++count.cases;
            count.differing += of(RendererPair::kFixedReference).fails;
        }
        for (std::size_t pair = 0; pair < kPairs; ++pair) {
            if (!has_shaders && pair != static_cast<std::size_t>(RendererPair::kFixedReference)) continue;
            if (departure && (has_fixed(pair) || departure->cause != Cause::kFixedFunction)) continue;
            PairDifferences& all = found.pairs[pair];
            all.compared += here[pair].compared;
            if (here[pair].fails && !all.fails) all.what = here[pair].what;
            all.only_one_draws = all.only_one_draws || here[pair].only_one_draws;
            all.fails = all.fails || here[pair].fails;
            all.worst = std::max(all.worst, here[pair].worst);
        }
    }
    return found;
}

}  // namespace

Floats::Floats(std::vector<std::string_view> lifted)
    : lifted_(std::move(lifted)), context_(compare::kShaderPicture, compare::kShaderPicture, ColorBuffer::kFloat) {}

std::vector<StateDifferences> Floats::compare(std::span<const std::shared_ptr<const CommandList>> commands) {
    context_.make_current();
    const Driver driver = current_driver();
    std::vector<StateDifferences> found(commands.size());
    std::vector<std::optional<VertexScene>> scenes;
    std::vector<std::vector<Color>> fixed(commands.size());
    for (std::size_t i = 0; i < commands.size(); ++i) {
        scenes.push_back(compare::make_vertex_scene(commands[i], found[i].error));
        if (scenes.back()) fixed[i] = compare::fixed_colors(*scenes.back());
    }
    const std::vector<std::vector<Color>> shaders =
        compare::shader_colors(scenes, context_.shaders(), {{compare::kGlsOwnModel, 0}});
    for (std::size_t i = 0; i < commands.size(); ++i) {
        if (scenes[i]) found[i] = judge(*scenes[i], fixed[i], shaders[i], {*commands[i], driver, lifted_});
    }
    return found;
}

}  // namespace twinlight::fuzz
