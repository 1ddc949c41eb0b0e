// Tries to break the planner's bounds: in random Draws, the lights and effects that a Plan skips must not change a lit
// colour by more than its error_bound, at any vertex, and with phong shading at any point of a triangle.
//
// TWINLIGHT_PLAN_SCENES=1000000 tries that many. All in double precision: the reference draws the whole Draw, and the
// Draw without what the Plan skips.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <glm/gtc/matrix_transform.hpp>

#include "judge/fuzz/random.h"
#include "random_spectra.h"
#include "render/effect/plan.h"
#include "render/reference/vertices/draw_lighting.h"

namespace twinlight::plan_bounds_test {
namespace {

// The rounding error of the two sums, relative to the magnitudes of their terms: about a hundred double operations, a
// few of them (powers) with an error of up to 128 ulp.
constexpr double kSumRounding = 1e-12;

class RandomScene {
  public:
    explicit RandomScene(std::uint64_t seed) : random_(seed) {}

    Draw draw() {
        Draw draw;
        LightingState& lighting = draw.lighting;
        lighting.enabled = true;
        lighting.normalize = chance(0.5);
        lighting.rescale_normal = chance(0.3);
        LightModel& model = lighting.light_model;
        model.ambient = color(0.3);
        model.local_viewer = chance(0.5);
        model.two_side = chance(0.4);
        model.color_control = chance(0.3) ? kGL_SEPARATE_SPECULAR_COLOR : kGL_SINGLE_COLOR;
        model.specular = chance(0.2) ? Word::reflection : Word::half_vector;
        model.light_ambient = chance(0.2) ? Word::unattenuated : Word::attenuated;
        lighting.front = material();
        lighting.back = material();
        if (chance(0.2)) draw.materials = {{lighting.front, lighting.back}, {material(), material()}};
        constexpr Enum kModes[] = {kGL_AMBIENT, kGL_DIFFUSE, kGL_SPECULAR, kGL_EMISSION, kGL_AMBIENT_AND_DIFFUSE};
        constexpr Enum kFaces[] = {kGL_FRONT, kGL_BACK, kGL_FRONT_AND_BACK};
        lighting.color_material = {
            .enabled = chance(0.3), .face = kFaces[random_.below(3)], .mode = kModes[random_.below(5)]};
        place(draw);
        const int lights = 1 + random_.below(chance(0.1) ? 40 : 8);
        lighting.lights.resize(static_cast<std::size_t>(std::max(lights, kMaxLights)));
        for (int i = 0; i < lights; ++i) lighting.lights[static_cast<std::size_t>(i)] = light(draw);
        randomise_spectra(random_, lighting, draw.materials.empty());
        return draw;
    }

    double budget() {
        constexpr double kBudgets[] = {0, 0.5 / 255, 0.01, 0.2};
        return kBudgets[random_.below(4)];
    }
    Shading shading() { return static_cast<Shading>(random_.below(3)); }
    glm::dvec3 weights() {
        const double a = random_.uniform(0, 1), b = random_.uniform(0, 1 - a);
        return {a, b, 1 - a - b};
    }

  private:
    bool chance(double probability) { return random_.chance(probability); }
    double magnitude(double low, double high) { return std::pow(10, random_.uniform(low, high)); }
    glm::dvec3 vector(double size) {
        return {random_.uniform(-size, size), random_.uniform(-size, size), random_.uniform(-size, size)};
    }
    glm::dvec4 color(double size) {
        if (chance(0.2)) return {0, 0, 0, 1};
        const double low = chance(0.1) ? -size : 0;
        return {random_.uniform(low, size), random_.uniform(low, size), random_.uniform(low, size),
                random_.uniform(0, 1)};
    }
    double exponent() {
        if (chance(0.2)) return 0;
        const double e = random_.uniform(0, 128);
        return chance(0.5) ? std::ceil(e) : e;
    }
    Material material() {
        return {.ambient = color(1),
                .diffuse = color(1),
                .specular = color(1),
                .emission = color(0.1),
                .shininess = exponent()};
    }

    // Three to twelve vertices in a ball of any size, anywhere around the eye, with normals near an axis or random.
    void place(Draw& draw) {
        draw.eye_from_object = glm::translate(glm::dmat4(1), vector(5));
        draw.eye_from_object = glm::rotate(draw.eye_from_object, random_.uniform(0, 6), glm::normalize(vector(1)));
        if (chance(0.3)) draw.eye_from_object = glm::scale(draw.eye_from_object, glm::dvec3(magnitude(-1, 1)));
        if (chance(0.2)) {
            draw.eye_from_object =
                glm::scale(draw.eye_from_object, glm::dvec3(1, magnitude(-0.5, 0.5), magnitude(-2, 1)));
            draw.eye_from_object = glm::rotate(draw.eye_from_object, random_.uniform(0, 6), glm::normalize(vector(1)));
        }
        const double size = magnitude(-2, 1), spread = chance(0.3) ? 5 : magnitude(-3, 0.5);
        const glm::dvec3 middle = vector(2), axis = glm::normalize(vector(1));
        const bool unit = chance(0.6), same_color = chance(0.5), has_w = chance(0.1);
        const int count = 3 * (1 + random_.below(4));
        for (int i = 0; i < count; ++i) {
            Vertex v;
            v.position_object = glm::dvec4(middle + vector(size), 1);
            if (has_w) v.position_object *= random_.uniform(0.2, 3);
            v.normal_object = axis + vector(spread);
            if (unit) v.normal_object = glm::normalize(v.normal_object);
            if (chance(0.02)) v.normal_object = glm::dvec3(0);
            if (i == 0 || !same_color)
                v.color = color(1);
            else
                v.color = draw.vertices.front().color;
            v.material = draw.materials.empty() ? 0 : static_cast<std::uint32_t>(random_.below(2));
            draw.vertices.edit().push_back(v);
        }
    }

    // Often near the vertices; bright or faint.
    LightSource light(const Draw& draw) {
        LightSource light;
        light.enabled = chance(0.95);
        const double size = magnitude(-4, 0.5);
        light.ambient = color(0.1 * size);
        light.diffuse = color(size);
        light.specular = color(size);
        const Vertex& any =
            draw.vertices[static_cast<std::size_t>(random_.below(static_cast<int>(draw.vertices.size())))];
        const glm::dvec4 at = draw.eye_from_object * any.position_object;
        const glm::dvec3 position =
            chance(0.05) ? glm::dvec3(at) / at.w : glm::dvec3(at) / at.w + vector(magnitude(-1, 2));
        light.position_eye = glm::dvec4(position, 1);
        if (chance(0.2)) light.position_eye *= random_.uniform(-2, 2);
        if (chance(0.3)) light.position_eye = glm::dvec4(vector(3), 0);
        light.spot_direction_eye =
            chance(0.5) ? vector(1) : glm::dvec3(at) / at.w - position + vector(magnitude(-1, 1));
        if (chance(0.02)) light.spot_direction_eye = glm::dvec3(0);
        if (chance(0.5)) {
            light.spot_cutoff_deg = chance(0.1) ? 90.0 * random_.below(2) : random_.uniform(0, 90);
            light.spot_exponent = exponent();
        }
        if (chance(0.15)) light.smooth_cone = LightSource::SmoothCone{random_.uniform(0, 60), random_.uniform(20, 90)};
        const double low = chance(0.03) ? -1 : 0;  // GL refuses negative factors
        light.constant_attenuation = chance(0.1) ? 0 : random_.uniform(low, 2);
        if (chance(0.6)) light.linear_attenuation = random_.uniform(low, 2);
        if (chance(0.6)) light.quadratic_attenuation = random_.uniform(low, 2);
        return light;
    }

    fuzz::Random random_;
};

// The Draw without what the Plan skips.
Draw planned(const Draw& draw, const Plan& plan) {
    Draw rest = draw;
    LightingState& lighting = rest.lighting;
    lighting.light_model.ambient = glm::dvec4(plan.constant_ambient, 1);
    lighting.normalize = plan.lighting.normalize;
    lighting.rescale_normal = plan.lighting.rescale_normal;
    for (LightSource& light : lighting.lights) light.enabled = false;
    for (std::size_t i = 0; i < plan.lights.size(); ++i) {
        LightSource& light = lighting.lights[static_cast<std::size_t>(plan.lights[i].number)];
        const LightEffects& effects = plan.effects.lights[i];
        light.enabled = true;
        if (!effects.ambient) light.ambient = glm::dvec4(0);
        if (!effects.diffuse) light.diffuse = glm::dvec4(0), light.diffuse_illuminant = {};
        if (!effects.specular) light.specular = glm::dvec4(0), light.specular_illuminant = {};
        if (!effects.directional && effects.cone != SpotCone::kGl) light.spot_cutoff_deg = 180;
    }
    return rest;
}

using reference::StageVertex;

// A random point of the triangle of three vertices from `first` on, as phong shading lights it.
reference::Colors between(const reference::DrawLighting& lighting, const std::vector<StageVertex>& vertices,
                          std::size_t first, const glm::dvec3& weights, reference::Face face) {
    StageVertex pixel;
    std::array<reference::LitMaterial, 3> materials;
    for (int i = 0; i < 3; ++i) {
        const StageVertex& v = vertices[first + static_cast<std::size_t>(i)];
        pixel.position_eye += weights[i] * v.position_eye;
        pixel.normal_eye += weights[i] * v.normal_eye;
        pixel.color += weights[i] * v.color;
        materials[static_cast<std::size_t>(i)] = lighting.material(v, face);
    }
    const auto normal_dir = lighting::unit(vec3_cast<Vec3<double>>(pixel.normal_eye));
    return lighting.lit(pixel.position_eye, vec3_cast<glm::dvec3>(normal_dir), reference::mixed(weights, materials),
                        face);
}

struct Tally {
    int scenes = 0, colors = 0, lights = 0, by_fate[10] = {};
    double tightest = 0;  // the largest ratio of error to bound
};

class Check {
  public:
    Check(std::uint64_t seed, Tally& tally) : seed_(seed), tally_(tally) {}

    void run() {
        RandomScene scene(seed_);
        Draw draw = scene.draw();
        const PlanOptions options{{.shading = scene.shading()}, scene.budget()};
        plan_ = plan_effects(draw, options);
        ASSERT_LE(plan_.error_bound, options.budget) << "seed " << seed_;
        ++tally_.scenes;
        for (const LightBound& light : plan_.light_bounds) ++tally_.by_fate[static_cast<int>(light.fate)];
        const Draw rest = planned(draw, plan_);
        const reference::DrawLighting all(draw, true), left(rest, true);
        const std::vector<StageVertex> vertices = reference::vertex_stage(draw),
                                       of_rest = reference::vertex_stage(rest);
        for (const reference::Face face : {reference::Face::kFront, reference::Face::kBack}) {
            if (face == reference::Face::kBack && !plan_.effects.two_side) continue;
            if (*options.shading != Shading::kPhong) {
                for (std::size_t i = 0; i < vertices.size(); ++i)
                    compare(all.colors(vertices[i], face), left.colors(of_rest[i], face));
            } else {
                for (std::size_t i = 0; i < vertices.size(); ++i) {
                    const glm::dvec3 weights = scene.weights();
                    const std::size_t first = i - i % 3;
                    compare(between(all, vertices, first, weights, face), between(left, of_rest, first, weights, face));
                }
            }
        }
    }

  private:
    void compare(const reference::Colors& whole, const reference::Colors& left) {
        ++tally_.colors;
        for (int c = 0; c < 3; ++c) {
            // Both may be infinite, by the power of a long normal.
            const auto off = [](double x, double y) { return x == y ? 0 : std::abs(x - y); };
            const double difference =
                off(whole.primary[c], left.primary[c]) + off(whole.secondary[c], left.secondary[c]);
            const double rounding = kSumRounding * (1 + whole.magnitude[c] + std::abs(whole.secondary[c]));
            ASSERT_LE(difference, plan_.error_bound + rounding)
                << fmt::format("seed {} channel {}: {} is not {}\n{}", seed_, c, left.primary[c], whole.primary[c],
                               describe(plan_.effects));
            if (rounding < 1e-3 * plan_.error_bound)
                tally_.tightest = std::max(tally_.tightest, difference / plan_.error_bound);
            if (plan_.effects.clamp) continue;
            for (const double channel : {left.primary[c], left.secondary[c]}) {
                ASSERT_LE(channel, 1 + rounding) << "seed " << seed_ << " has no clamp";
                ASSERT_GE(channel, -rounding) << "seed " << seed_ << " has no clamp";
            }
        }
    }

    std::uint64_t seed_;
    Tally& tally_;
    Plan plan_;
};

TEST(PlanBounds, HoldOverRandomScenes) {
    const char* asked = std::getenv("TWINLIGHT_PLAN_SCENES");
    const std::uint64_t count = asked ? std::strtoull(asked, nullptr, 10) : 5000;
    Tally tally;
    for (std::uint64_t seed = 0; seed < count && !HasFatalFailure(); ++seed) Check(seed, tally).run();
    fmt::print(
        "{} scenes, {} colours; lights in {}, off {}, cone misses {}, behind {}, faint {}; up to {:.3f} of a bound "
        "used\n",
        tally.scenes, tally.colors, tally.by_fate[static_cast<int>(LightFate::kIn)],
        tally.by_fate[static_cast<int>(LightFate::kDisabled)], tally.by_fate[static_cast<int>(LightFate::kConeMisses)],
        tally.by_fate[static_cast<int>(LightFate::kBehind)], tally.by_fate[static_cast<int>(LightFate::kFaint)],
        tally.tightest);
    // If no error comes near its bound, the bounds are too loose or the scenes too simple.
    EXPECT_GT(tally.tightest, 0.9);
    for (const LightFate fate : {LightFate::kConeMisses, LightFate::kBehind, LightFate::kFaint})
        EXPECT_GT(tally.by_fate[static_cast<int>(fate)], static_cast<int>(count) / 100);
}

}  // namespace
}  // namespace twinlight::plan_bounds_test
