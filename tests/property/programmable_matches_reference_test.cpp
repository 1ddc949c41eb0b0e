// Compares the shaders' colours with the reference, vertex by vertex in floats, over random states with fixed seeds,
// including the lecture's variants.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <stdexcept>

#include "judge/fuzz/random.h"
#include "random_spectra.h"
#include "render/context/context.h"
#include "render/effect/plan.h"
#include "render/programmable/programmable.h"
#include "render/reference/reference.h"
#include "render/reference/vertices/lit_vertices.h"

namespace twinlight::programmable_matches_reference_test {
namespace {

constexpr int kStates = 60;
constexpr int kVertices = 32;  // per state; each is one pixel
// Relative to the sum of the magnitudes of a colour's terms, or to 1 where that is less: some forty float operations,
// and a relative error of an ulp or two in n.h, 128 times as large in its 128th power.
constexpr double kUlp = 0x1p-23;
constexpr double kBar = 40 * kUlp + 2 * 128 * kUlp;

class RandomDraw {
  public:
    explicit RandomDraw(std::uint64_t seed) : random_(seed) {}

    Draw draw() {
        Draw draw;
        draw.mode = kGL_POINTS;
        LightingState& lighting = draw.lighting;
        lighting.enabled = true;
        LightModel& model = lighting.light_model;
        model.ambient = color();
        model.local_viewer = chance(0.5);
        model.color_control = chance(0.3) ? kGL_SEPARATE_SPECULAR_COLOR : kGL_SINGLE_COLOR;
        model.specular = chance(0.3) ? Word::reflection : Word::half_vector;
        model.light_ambient = chance(0.3) ? Word::unattenuated : Word::attenuated;
        Material& material = lighting.front;
        material = {
            .ambient = color(), .diffuse = color(), .specular = color(), .emission = color(), .shininess = exponent()};
        constexpr Enum kModes[] = {kGL_AMBIENT, kGL_DIFFUSE, kGL_SPECULAR, kGL_EMISSION, kGL_AMBIENT_AND_DIFFUSE};
        lighting.color_material = {
            .enabled = chance(0.4), .face = kGL_FRONT_AND_BACK, .mode = kModes[random_.below(5)]};
        lighting.normalize = chance(0.5);
        lighting.rescale_normal = chance(0.3);
        for (LightSource& light : lighting.lights)
            if (chance(0.3)) light = random_light();
        draw.eye_from_object = glm::translate(glm::dmat4(1), vector(2) - glm::dvec3(0, 0, 3));
        draw.eye_from_object = glm::rotate(draw.eye_from_object, random_.uniform(0, 6), glm::normalize(vector(1)));
        if (chance(0.5)) draw.eye_from_object = glm::scale(draw.eye_from_object, glm::dvec3(random_.uniform(0.3, 3)));
        draw.clip_from_eye = glm::dmat4(0);  // the middle of the viewport, whatever the position
        draw.clip_from_eye[3][3] = 1;
        for (int i = 0; i < kVertices; ++i)
            draw.vertices.edit().push_back({.position_object = glm::dvec4(vector(1), 1),
                                            .normal_object = glm::normalize(vector(1)),
                                            .color = color()});
        randomise_spectra(random_, lighting, true);
        return draw;
    }

  private:
    bool chance(double probability) { return random_.chance(probability); }
    glm::dvec3 vector(double size) {
        return {random_.uniform(-size, size), random_.uniform(-size, size), random_.uniform(-size, size)};
    }
    glm::dvec4 color() {
        if (chance(0.2)) return {0, 0, 0, 1};
        return {random_.uniform(-0.2, 0.5), random_.uniform(0, 0.5), random_.uniform(0, 0.5), random_.uniform(0, 1)};
    }
    double exponent() {
        if (chance(0.2)) return 0;
        const double e = random_.uniform(0, 128);
        return chance(0.5) ? std::ceil(e) : e;
    }
    LightSource random_light() {
        LightSource light;
        light.enabled = true;
        light.ambient = color();
        light.diffuse = color();
        light.specular = color();
        light.position_eye = glm::dvec4(vector(3), chance(0.5) ? 0 : random_.uniform(0.5, 2));
        light.spot_direction_eye = chance(0.7) ? -glm::dvec3(light.position_eye) : vector(1);
        if (chance(0.4)) {
            light.spot_cutoff_deg = random_.uniform(10, 90);
            light.spot_exponent = exponent();
        } else if (chance(0.2)) {
            light.smooth_cone = LightSource::SmoothCone{random_.uniform(0, 40), random_.uniform(45, 90)};
        }
        light.constant_attenuation = random_.uniform(0.5, 2);
        if (chance(0.5)) light.linear_attenuation = random_.uniform(0, 1);
        if (chance(0.5)) light.quadratic_attenuation = random_.uniform(0, 1);
        return light;
    }

    fuzz::Random random_;
};

// One pixel for each vertex, from left to right.
Frame one_pixel_a_vertex(const Draw& draw) {
    Frame frame;
    frame.width = kVertices;
    frame.height = 1;
    for (int i = 0; i < kVertices; ++i) {
        Draw one = draw;
        one.indices.edit().assign(1, static_cast<std::uint32_t>(i));
        one.raster.viewport = {i, 0, 1, 1};
        frame.items.emplace_back(std::move(one));
    }
    return frame;
}

void compare_states(const programmable::Options& options) {
    const auto context = make_offscreen_context(kVertices, 1, ColorBuffer::kFloat);
    double worst = 0;
    for (std::uint64_t seed = 0; seed < kStates; ++seed) {
        Draw draw = RandomDraw(seed).draw();
        // Phong shading always normalises the normal.
        if (options.shading == Shading::kPhong) draw.lighting.normalize = true;
        programmable::Renderer renderer;
        const Image image = renderer.render(one_pixel_a_vertex(draw), options);
        const auto lit = reference::light_vertices(draw, reference::Options{options}, true);
        for (int i = 0; i < kVertices; ++i) {
            const reference::LitVertex& v = lit[static_cast<std::size_t>(i)];
            const glm::dvec4 sum = v.front_primary + glm::dvec4(glm::dvec3(v.front_secondary), 0);
            for (int c = 0; c < 4; ++c) {
                const double actual = image.at(i, 0)[static_cast<std::size_t>(c)];
                const double expected = std::clamp(sum[c], 0.0, 1.0);
                const double relative = std::abs(actual - expected) / std::max(1.0, v.front_magnitude[c]);
                worst = std::max(worst, relative);
                ASSERT_LE(relative, kBar)
                    << fmt::format("seed {} vertex {} channel {}: {} is not {}\n{}", seed, i, c, actual, expected,
                                   describe(plan_effects(draw, options).effects));
            }
        }
    }
    fmt::print("{} vertices compared, the worst {:.2e} off\n", kStates * kVertices, worst);
}

TEST(ProgrammableMatchesReference, InFloatsAtTheVerticesOverRandomStates) { compare_states({{{}, 0}}); }
TEST(ProgrammableMatchesReference, InFloatsInPhongShadingOverRandomStates) {
    compare_states({{{.shading = Shading::kPhong}, 0}});
}
TEST(ProgrammableMatchesReference, WithNumbersAsConstants) {
    programmable::Options options;
    options.tier = programmable::Tier::kBaked;
    options.budget = 0;
    compare_states(options);
    options.shading = Shading::kPhong;
    compare_states(options);
}
TEST(ProgrammableMatchesReference, WithoutTheLecturesVariants) {
    compare_states({{{.shading = {}, .lecture_variants = false}, 0}});
}
// --precise does not copy the known bugs of Mesa's fixed function.
TEST(ProgrammableMatchesReference, InTheFixedFunctionsOrderOfOperations) {
    programmable::Options options;
    options.lecture_variants = false;
    options.precise = true;
    try {
        compare_states(options);
    } catch (const std::runtime_error& refused) {
        GTEST_SKIP() << refused.what();
    }
}

}  // namespace
}  // namespace twinlight::programmable_matches_reference_test
