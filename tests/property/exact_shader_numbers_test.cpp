// Exact surfaces drawn by shaders: the bounds that the planner uses, their depths, and their errors in floats.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstring>
#include <glm/gtc/matrix_inverse.hpp>

#include "exact_shader_cases.h"
#include "render/context/context.h"
#include "render/context/gl.h"
#include "render/effect/explanation.h"
#include "render/effect/surface_draw.h"
#include "render/programmable/programmable.h"
#include "render/reference/pixel_history.h"

namespace twinlight::exact_shader_numbers_test {
namespace {

// ---- The planner's bounds of a surface ----

// The vertices of a fine mesh lie on the surface, so a bound for the whole surface must hold for them.
TEST(SurfaceFacts, HoldForTheVerticesOfTheMesh) {
    int vertices = 0;
    for (const std::string& shape : shapes()) {
        SCOPED_TRACE(shape);
        const Frame frame = frame_of(kCamera + shape);
        const Draw& first = std::get<Draw>(frame.items.front());
        const std::vector<SurfaceDraw> surfaces = surface_draws(first);
        ASSERT_EQ(surfaces.size(), first.surfaces->size());
        for (const auto& item : frame.items)
            for (const Vertex& vertex : std::get<Draw>(item).vertices) {
                const glm::dvec4 position_eye = first.eye_from_object * vertex.position_object;
                const glm::dvec3 normal_eye =
                    glm::inverseTranspose(glm::dmat3(first.eye_from_object)) * vertex.normal_object;
                const auto holds = [&](const SurfaceDraw& surface) {
                    constexpr double kRounding = 1e-9;
                    const glm::dmat4& m = surface.draw.eye_from_object;
                    const VertexFacts& facts = surface.facts;
                    const glm::dvec3 p(glm::inverse(m) * position_eye);
                    const glm::dvec3 n = glm::normalize(glm::transpose(glm::dmat3(m)) * normal_eye);
                    const glm::dvec3 beyond = glm::abs(p) - glm::dvec3(facts.position_reach);
                    const double angle = std::acos(std::min(glm::dot(n, facts.normal_axis_dir_object), 1.0));
                    return glm::length(p - facts.center_object) <= facts.radius_object * (1 + kRounding) &&
                           std::max({beyond.x, beyond.y, beyond.z}) <= kRounding &&
                           angle <= facts.normal_half_angle + 1e-6 && vertex.color == facts.color_low &&
                           facts.radius_object > 0.4 && facts.radius_object < 2;
                };
                EXPECT_TRUE(std::ranges::any_of(surfaces, holds));
                ++vertices;
            }
    }
    EXPECT_GT(vertices, 500);
}

// The plan skips a faint light: the picture changes by no more than the plan's error bound.
TEST(SurfaceFacts, LeaveNoPictureOffByMoreThanThePlansBound) {
    const auto context = make_offscreen_context(kExactSide, kExactSide);
    programmable::Renderer renderer;
    const std::string faint =
        "glLightf(GL_LIGHT1, GL_QUADRATIC_ATTENUATION, 1); glLightfv(GL_LIGHT1, GL_POSITION, (float[]){3, 5, 4, 1}); "
        "glLightfv(GL_LIGHT1, GL_DIFFUSE, (float[]){1, 1, 1, 1}); glEnable(GL_LIGHT1); ";
    int left_out = 0;
    for (const std::string& shape : shapes()) {
        const Frame frame = frame_of(kCamera + kLit + faint + shape);
        programmable::Options options = exact(programmable::Tier::kUniform);
        const Image whole = renderer.render(frame, options);
        options.budget = 16 * kCode;
        const double bound = error_bound(explain_draws(frame, options));
        left_out += bound > 0;
        const Image image = renderer.render(frame, options);
        for (std::size_t i = 0; i < image.pixels.size(); ++i)
            EXPECT_LE(apart(image.pixels[i], whole.pixels[i]), bound + 1.01 * kCode) << shape;
    }
    EXPECT_GT(left_out, 5);
}

// Depths in the depth buffer, at some pixels of every shape.
TEST(ExactShaderDepths, AreTheReferences) {
    const auto context = make_offscreen_context(kExactSide, kExactSide);
    programmable::Renderer renderer;
    constexpr double kStep = 1.0 / (1 << 24);
    // Half a step of rounding, and a few float errors of a sum that can be 1 where depths are small.
    constexpr double kDepth = 6 * kStep;
    // Three times the slope, which grows without bound towards a silhouette; the error grows with its square.
    constexpr double kOffsetDepth = 40 * kStep;
    double worst = 0;
    int compared = 0;
    for (const StateCase& state : kStates)
        for (const char* name :
             {"lit", "far plane", "parallel", "depth range", "offset", "perspective modelview", "far away"}) {
            if (std::strcmp(state.name, name) != 0) continue;
            for (const std::string& shape : shapes()) {
                const Frame frame = frame_of(kCamera + kLit + state.commands + shape);
                const Truth truth(frame);
                renderer.render(frame, exact(programmable::Tier::kUniform));
                for (int y = 3; y < kExactSide; y += 7)
                    for (int x = 3; x < kExactSide; x += 7) {
                        if (truth.is_edge(static_cast<std::size_t>((kExactSide - 1 - y) * kExactSide + x))) continue;
                        double expected = 1;
                        for (const reference::PixelFragment& fragment :
                             reference::pixel_history(frame, {{.shading = Shading::kExact}}, x, y).fragments)
                            if (fragment.passes) expected = fragment.depth;
                        float actual = 0;
                        glReadPixels(x, y, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &actual);
                        const double off = std::abs(actual - expected);
                        compared += expected < 1;
                        const bool is_offset = std::strcmp(name, "offset") == 0;
                        EXPECT_LE(off, is_offset ? kOffsetDepth : kDepth)
                            << name << ": " << shape << " at " << x << "," << y;
                        worst = std::max(worst, off);
                    }
            }
        }
    fmt::print("{} depths compared, the worst {:.2f} steps of the buffer off\n", compared, worst * (1 << 24));
    EXPECT_GT(compared, 500);
}

// In floats, because the errors are far below 1/255: exact surfaces in the shader against the finest mesh of the study.
TEST(ExactShaderFloats, AreOrdersOfMagnitudeNearerThanAFineMesh) {
    constexpr int kWide = 256;
    const auto context = make_offscreen_context(kWide, kWide, ColorBuffer::kFloat);
    programmable::Renderer renderer;
    for (const char* shape : {"glutSolidSphere(0.8, 128, 64);", "glutSolidTorus(0.3, 0.6, 64, 128);",
                              "glutSolidCone(0.8, 1.2, 128, 64);"}) {
        const Frame frame = frame_of(kCamera + kLit + shape, kWide, kWide);
        const Truth truth(frame);
        programmable::Options options = exact(programmable::Tier::kUniform);
        const Image surface = renderer.render(frame, options);
        options.shading = Shading::kPhong;
        const Image mesh = renderer.render(frame, options);
        double surface_square = 0, mesh_square = 0, worst = 0;
        int count = 0;
        for (std::size_t i = 0; i < mesh.pixels.size(); ++i) {
            if (truth.is_edge(i) || mesh.pixels[i] == Rgba{} || surface.pixels[i] == Rgba{}) continue;
            const double of_surface = apart(surface.pixels[i], truth.picture().pixels[i]);
            const double of_mesh = apart(mesh.pixels[i], truth.picture().pixels[i]);
            surface_square += of_surface * of_surface;
            mesh_square += of_mesh * of_mesh;
            worst = std::max(worst, of_surface);
            ++count;
        }
        fmt::print("{} {} pixels: rms {:.1e} of the surface, worst {:.1e}; {:.1e} of the mesh: {:.0f} times\n", shape,
                   count, std::sqrt(surface_square / count), worst, std::sqrt(mesh_square / count),
                   std::sqrt(mesh_square / surface_square));
        EXPECT_GT(count, 5000);
        EXPECT_GT(std::sqrt(mesh_square), 500 * std::sqrt(surface_square)) << shape;
    }
}

}  // namespace
}  // namespace twinlight::exact_shader_numbers_test
