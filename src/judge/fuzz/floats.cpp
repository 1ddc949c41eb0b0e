#include "judge/fuzz/floats.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "judge/fuzz/vertex_colors.h"

namespace twinlight::fuzz {

namespace {

static_assert(kMostVertexScenes == Floats::kMostScenes);

// What a channel may be off by, relative to the sum of the magnitudes of a colour's terms, in units of a float's last place.
// 2.1.1 allows each operation 1e-5; what drivers and shaders really lose is less.
constexpr double kUlp = 0x1p-23;
constexpr double kArithmeticUlps = 40;  // as many operations deep
// Of n.h, which its power multiplies by the exponent: a unit normal, and one that is the product of an inverse matrix that
// the driver has in floats.
constexpr double kUnitCosineUlps = 1, kCosineUlps = 3;
// Of the logarithm that a power is made of: it is multiplied by the exponent, and matters where n.h is greater than 1, for
// then the power is the greatest term by far.
constexpr double kLogarithmUlps = 5;
// Of each of the two unit vectors whose sum is made unit to h_i: where they nearly cancel, the sum is as far off, but short.
constexpr double kHalfVectorUlps = 1;

// The shortest sum of the directions to a light and to the viewer: 2 at most.
double shortest_half_vector(const Draw& draw, const Vertex& vertex) {
    const glm::dvec4 at = draw.eye_from_object * vertex.position_object;
    const glm::dvec3 position_eye = glm::dvec3(at) / at.w;
    const glm::dvec3 to_viewer =
        draw.lighting.light_model.local_viewer ? glm::normalize(-position_eye) : glm::dvec3(0, 0, 1);
    double shortest = 2;
    for (const LightSource& light : draw.lighting.lights) {
        if (!light.enabled) continue;
        const glm::dvec3 direction(light.position_eye);
        const double w = light.position_eye.w;
        const glm::dvec3 to_light = glm::normalize(w == 0 ? direction : direction / w - position_eye);
        shortest = std::min(shortest, glm::length(to_light + to_viewer));
    }
    return shortest;
}

double bar(const Draw& draw, const Vertex& vertex) {
    const LightingState& lighting = draw.lighting;
    const Materials materials =
        draw.materials.empty() ? Materials{lighting.front, lighting.back} : draw.materials[vertex.material];
    const double exponent = std::max(materials.front.shininess, materials.back.shininess);
    const double of_half_vector = 2 * kHalfVectorUlps / shortest_half_vector(draw, vertex);
    if (lighting.normalize) return kUlp * (kArithmeticUlps + (kUnitCosineUlps + of_half_vector) * exponent);
    const glm::dvec3 normal_eye = glm::transpose(glm::inverse(glm::dmat3(draw.eye_from_object))) * vertex.normal_object;
    const double length = lighting.rescale_normal ? 1 : std::max(1.0, glm::length(normal_eye));
    return kUlp * (kArithmeticUlps + (kCosineUlps + of_half_vector + kLogarithmUlps * std::log(length)) * exponent);
}

// ---- The comparison ----

glm::dvec4 clamped(const glm::dvec4& color) { return glm::clamp(color, 0.0, 1.0); }

// The largest difference of a channel, relative to the magnitude.
void compare(PairFound& found, double bar, const Color& a, const Color& b, const glm::dvec4& magnitude,
             const std::string& where) {
    ++found.compared;
    if (!a || !b) {
        found.fails = found.misses = true;
        found.worst = 1;
        found.what = where + ": only one of the two shows this vertex";
        return;
    }
    for (int channel = 0; channel < 4; ++channel) {
        const double relative = std::abs((*a)[channel] - (*b)[channel]) / magnitude[channel];
        if (relative <= found.worst) continue;
        found.worst = std::isnan(relative) ? HUGE_VAL : relative;
        if (relative <= bar) continue;
        found.fails = true;
        found.what = fmt::format("{}, {}: {:.9g} and {:.9g}, {:.1e} of the terms' magnitude {:.3g}", where,
                                 std::array{"red", "green", "blue", "alpha"}.at(static_cast<std::size_t>(channel)),
                                 (*a)[channel], (*b)[channel], relative, magnitude[channel]);
    }
}

Found judge(const CommandList& commands, const VertexScene& scene, const std::vector<Color>& fixed_colors,
            const std::vector<Color>& shader_colors, const std::vector<std::string_view>& lifted) {
    Found found;
    const LeftOut left_out(commands, lifted);
    const bool back = scene.shows_back();
    const bool has_shaders =
        !scene.draw().lighting.light_model.two_side || !draws_polygons(scene.draw().mode) || knows_faces_of_corners();
    const bool is_sum = scene.draw().lighting.light_model.color_control != kGL_SINGLE_COLOR;
    for (std::size_t i = 0; i < scene.lit.size(); ++i) {
        const reference::LitVertex& lit = scene.lit[i];
        const glm::dvec4 primary = back ? lit.back_primary : lit.front_primary;
        const glm::dvec4 secondary = back ? lit.back_secondary : lit.front_secondary;
        const glm::dvec4 magnitude = glm::max(back ? lit.back_magnitude : lit.front_magnitude, glm::dvec4(1e-30));
        const glm::dvec4 at_least_1 = glm::max(magnitude, glm::dvec4(1));
        const glm::dvec4 sum = color_sum(primary, secondary);
        const std::string where = fmt::format("vertex {}, {} face", i, back ? "back" : "front");

        std::array<PairFound, kPairs> here;
        const auto of = [&](Pair pair) -> PairFound& { return here[static_cast<std::size_t>(pair)]; };
        const double bar_here = bar(scene.draw(), scene.draw().vertices[i]);
        compare(of(Pair::kFixedReference), bar_here, fixed_colors[i], primary, magnitude, where);
        compare(of(Pair::kProgrammableReference), bar_here, shader_colors[i], sum, at_least_1, where);
        if (!is_sum) {  // feedback returns the primary colour alone
            const Color fixed = fixed_colors[i] ? Color(clamped(*fixed_colors[i])) : Color();
            compare(of(Pair::kFixedProgrammable), 2 * bar_here, fixed, shader_colors[i], at_least_1, where);
        }

        const Departure* departure = left_out.at(scene.draw(), scene.draw().vertices[i]);
        if (departure) {
            LeftOutCount& count = found.left_out[departure];
            ++count.cases;
            count.differing += of(Pair::kFixedReference).fails;
        }
        for (std::size_t pair = 0; pair < kPairs; ++pair) {
            if (!has_shaders && pair != static_cast<std::size_t>(Pair::kFixedReference)) continue;
            if (departure && (has_fixed(pair) || departure->leaves != Leaves::kFixedFunction)) continue;
            PairFound& all = found.pairs[pair];
            all.compared += here[pair].compared;
            if (here[pair].fails && !all.fails) all.what = here[pair].what;
            all.misses = all.misses || here[pair].misses;
            all.fails = all.fails || here[pair].fails;
            all.worst = std::max(all.worst, here[pair].worst);
        }
    }
    return found;
}

}  // namespace

Floats::Floats(std::vector<std::string_view> lifted)
    : lifted_(std::move(lifted)),
      context_(make_offscreen_context(kShaderPicture, kShaderPicture, ColorBuffer::kFloat)) {
    renderer_.emplace();
}

Floats::~Floats() {
    context_->make_current();
    renderer_.reset();
}

std::vector<Found> Floats::compare(std::span<const std::shared_ptr<const CommandList>> commands) {
    context_->make_current();
    std::vector<Found> found(commands.size());
    std::vector<std::optional<VertexScene>> scenes;
    std::vector<std::vector<Color>> fixed(commands.size());
    for (std::size_t i = 0; i < commands.size(); ++i) {
        scenes.push_back(make_vertex_scene(commands[i], found[i].error));
        if (scenes.back()) fixed[i] = fixed_colors(*scenes.back());
    }
    const std::vector<std::vector<Color>> shaders = shader_colors(scenes, *renderer_, {{kGlsOwnModel, 0}});
    for (std::size_t i = 0; i < commands.size(); ++i) {
        if (scenes[i]) found[i] = judge(*commands[i], *scenes[i], fixed[i], shaders[i], lifted_);
    }
    return found;
}

}  // namespace twinlight::fuzz
