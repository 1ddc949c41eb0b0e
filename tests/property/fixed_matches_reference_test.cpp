// The driver's own lighting, vertex by vertex in unclamped floats (feedback mode), against the reference, over seeded
// random states.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "command/text.h"
#include "context/context.h"
#include "context/gl.h"
#include "fixed/fixed.h"
#include "random_states.h"
#include "reference/reference.h"
#include "state/state.h"

namespace twinlight {

namespace {

constexpr int kStates = 13000;
constexpr int kTriangles = 1;
// The bar of the comparison, relative to the sum of the magnitudes of a colour's terms. Its causes: 2.1.1 allows each
// operation 1e-5; what the driver really loses is float rounding (6e-8 an operation, some forty operations deep) and,
// for large exponents, that of n.h times the exponent.
constexpr double kBar = 1e-5;

using Color = std::array<double, 4>;

// The colours of GL_TRIANGLES as feedback returns them, in the order of the vertices.
std::vector<Color> feedback_colors(const CommandList& scene, std::size_t vertices) {
    constexpr std::size_t kPerVertex = 7;   // GL_3D_COLOR: x, y, z, r, g, b, a
    constexpr std::size_t kPerPolygon = 2;  // GL_POLYGON_TOKEN, count
    std::vector<GLfloat> buffer(vertices * (kPerVertex + kPerPolygon));
    glFeedbackBuffer(static_cast<GLsizei>(buffer.size()), GL_3D_COLOR, buffer.data());
    fixed::Driver driver(64, 64);
    glClampColor(GL_CLAMP_VERTEX_COLOR, GL_FALSE);
    glRenderMode(GL_FEEDBACK);
    for (const Command& command : scene.commands) driver.execute(command);
    const GLint written = glRenderMode(GL_RENDER);
    glClampColor(GL_CLAMP_VERTEX_COLOR, GL_TRUE);
    std::vector<Color> colors;
    for (std::size_t i = 0; i < static_cast<std::size_t>(std::max(written, 0));) {
        EXPECT_EQ(buffer[i], static_cast<GLfloat>(GL_POLYGON_TOKEN));
        EXPECT_EQ(buffer[i + 1], 3);
        i += kPerPolygon;
        for (int v = 0; v < 3; ++v, i += kPerVertex) {
            colors.push_back({buffer[i + 3], buffer[i + 4], buffer[i + 5], buffer[i + 6]});
        }
    }
    return colors;
}

// The sign of a triangle's area in window space decides its face (2.14.1).
bool shows_back(const std::vector<reference::LitVertex>& lit, std::size_t first) {
    const auto ndc = [&](std::size_t i) { return glm::dvec2(lit[i].position_clip) / lit[i].position_clip.w; };
    const glm::dvec2 a = ndc(first), b = ndc(first + 1), c = ndc(first + 2);
    return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y) <= 0;
}

struct Difference {
    double relative = 0;  // to the sum of the magnitudes of the terms
    std::string what;
};

// The largest difference of a vertex's channels.
Difference difference(const Color& driver, const glm::dvec4& expected, const glm::dvec4& magnitude) {
    Difference worst;
    for (int channel = 0; channel < 4; ++channel) {
        const double value = driver[static_cast<std::size_t>(channel)];
        const double relative = std::abs(value - expected[channel]) / magnitude[channel];
        if (!(relative <= worst.relative)) {
            worst = {relative, fmt::format("channel {}: driver {}, reference {}, {:.2e} of the terms' magnitude {}",
                                           channel, value, expected[channel], relative, magnitude[channel])};
        }
    }
    return worst;
}

TEST(FixedMatchesReference, InUnclampedFloatsOverRandomStates) {
    const auto context = make_offscreen_context(64, 64);
    struct LeftOut {
        int vertices = 0, differing = 0;
    };
    std::map<const Exclusion*, LeftOut> left_out;
    int compared = 0, compared_states = 0, failing_states = 0;
    double worst = 0;
    std::uint64_t worst_seed = 0;
    for (std::uint64_t seed = 0; seed < kStates && failing_states < 3; ++seed) {
        const auto scene = std::make_shared<const CommandList>(random_state(seed, kTriangles));
        const Frame frame = make_frame(scene, {.width = 64, .height = 64});
        const Draw& draw = std::get<Draw>(frame.items.back());
        const auto lit = reference::light_vertices(draw, {}, false);
        const std::vector<Color> driver = feedback_colors(*scene, draw.vertices.size());
        ASSERT_EQ(driver.size(), draw.vertices.size()) << "seed " << seed;
        std::string failures;
        const int compared_before = compared;
        for (std::size_t i = 0; i < driver.size(); ++i) {
            const bool back = draw.lighting.light_model.two_side && shows_back(lit, i / 3 * 3);
            const Difference found = difference(driver[i], back ? lit[i].back_primary : lit[i].front_primary,
                                                back ? lit[i].back_magnitude : lit[i].front_magnitude);
            const auto excluded = std::find_if(exclusions().begin(), exclusions().end(),
                                               [&](const Exclusion& e) { return e.applies(draw, draw.vertices[i]); });
            if (excluded != exclusions().end()) {
                ++left_out[&*excluded].vertices;
                if (!(found.relative <= kBar)) ++left_out[&*excluded].differing;
                continue;
            }
            ++compared;
            if (!(found.relative <= worst)) {
                worst = found.relative;
                worst_seed = seed;
            }
            if (!(found.relative <= kBar)) {
                failures += fmt::format("vertex {}, {} face, {}\n", i, back ? "back" : "front", found.what);
            }
        }
        if (compared > compared_before) ++compared_states;
        if (failures.empty()) continue;
        ++failing_states;
        ADD_FAILURE() << fmt::format("seed {}\n{}{}", seed, failures, print_scene(*scene));
    }
    fmt::print("{} vertices of {} states compared, the worst {:.2e} off (seed {})\n", compared, compared_states, worst,
               worst_seed);
    for (const auto& [exclusion, count] : left_out) {
        fmt::print("  {} left out, {} of them differing: {}\n", count.vertices, count.differing, exclusion->name);
    }
    EXPECT_GE(compared_states, 10000);
    // A departure that the driver no longer shows must leave the list.
    for (const Exclusion& exclusion : exclusions()) {
        if (exclusion.departure && is_listed_driver()) {
            EXPECT_GT(left_out[&exclusion].differing, 0) << exclusion.name;
        }
    }
}

}  // namespace

}  // namespace twinlight
