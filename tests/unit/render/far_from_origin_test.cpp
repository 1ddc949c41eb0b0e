// Objects and a camera far from the origin: shaders are as exact there as near it (docs/hard-cases.md, "Rulings").
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "render/context/context.h"
#include "render/programmable/export/shader_text.h"
#include "render/programmable/programmable.h"
#include "render/reference/reference.h"
#include "scene/command/text.h"
#include "scene/state/state.h"

namespace twinlight::programmable::far_from_origin_test {
namespace {

constexpr int kSide = 96;

// A rotated camera, a spot and a highlight on a bowl of vertices around (far, 0, -far), whose first vertex is far from
// the eye, and on a sphere with its own coordinates there.
Frame far_frame(double far) {
    std::string text = fmt::format(
        "glMatrixMode(GL_PROJECTION); glFrustum(-0.5, 0.5, -0.5, 0.5, 1, 100); glMatrixMode(GL_MODELVIEW);\n"
        "glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glEnable(GL_DEPTH_TEST); glEnable(GL_NORMALIZE);\n"
        "glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_TRUE);\n"
        "glMaterialfv(GL_FRONT, GL_SPECULAR, (GLfloat[]){{0.5, 0.5, 0.5, 1}}); glMaterialf(GL_FRONT, GL_SHININESS, "
        "9);\n"
        "glTranslatef(0, 0, -4); glRotatef(25, 1, 0.5, 0); glTranslated(-{0:.17g}, 0, {0:.17g});\n"
        "glPushMatrix(); glTranslated({0:.17g}, 0, -{0:.17g});\n"  // lights close to the object
        "glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){{1, 1.5, 2, 1}}); glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 60);\n"
        "glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, (GLfloat[]){{-1, -1.5, -2}}); glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, "
        "2);\n"
        "glLightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, 0.1);\n"
        "glutSolidSphere(0.6, 8, 6); glPopMatrix();\n"
        "glBegin(GL_TRIANGLES);\n",
        far);
    constexpr int kSteps = 4;
    const auto vertex = [&](int i, int j) {
        const double x = 2.4 * i / kSteps - 1.2, y = 2.4 * j / kSteps - 1.2;
        text += fmt::format("glNormal3d({}, {}, 1); glVertex3d({:.17g}, {:.17g}, {:.17g});\n", -0.6 * x, -0.6 * y,
                            far + x, y, -far - 1 + 0.3 * (x * x + y * y));
    };
    for (int i = 0; i < kSteps; ++i)
        for (int j = 0; j < kSteps; ++j) {
            for (const auto& [di, dj] : {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1)}) vertex(i + di, j + dj);
            for (const auto& [di, dj] : {std::pair(0, 0), std::pair(1, 1), std::pair(0, 1)}) vertex(i + di, j + dj);
        }
    text += "glEnd();\n";
    return make_frame(read_scene(text, "far.gl", "far"), {.width = kSide, .height = kSide});
}

// The largest difference of a channel from the reference, inside triangles.
double off(Renderer& renderer, const Frame& frame, const Options& options) {
    const reference::Options truth_options{options};
    const Image truth = reference::render(frame, truth_options), image = renderer.render(frame, options);
    const AllowedDifference allowed = reference::allowed_difference(frame, truth_options);
    double worst = 0;
    int seen = 0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        if (allowed.edge[i]) continue;
        seen += truth.pixels[i][0] > 0 ? 1 : 0;
        for (std::size_t channel = 0; channel < 3; ++channel)
            worst = std::max(worst, std::abs(double{image.pixels[i][channel]} - double{truth.pixels[i][channel]}));
    }
    EXPECT_GT(seen, kSide * kSide / 20);
    return worst;
}

TEST(FarFromTheOrigin, EveryShadingIsAsExactAsNearIt) {
    const auto context = make_offscreen_context(kSide, kSide, ColorBuffer::kFloat);
    Renderer renderer;
    for (const Shading shading : {Shading::kFlat, Shading::kGouraud, Shading::kPhong, Shading::kExact})
        for (const Tier tier : {Tier::kUniform, Tier::kBaked, Tier::kAuto}) {
            Options options{{{.shading = shading}, 0}};
            options.tier = tier;
            const double near_off = off(renderer, far_frame(0), options);
            for (const double far : {1e6, 1e7, 1e8}) {
                SCOPED_TRACE(
                    fmt::format("shading {}, tier {}, {}", static_cast<int>(shading), static_cast<int>(tier), far));
                // The doubles' rounding errors, a few units in the last place, change a colour by about as much.
                const double rounding = 16 * far * std::numeric_limits<double>::epsilon();
                EXPECT_LE(off(renderer, far_frame(far), options), 2 * near_off + rounding);
            }
        }
}

// The exported shaders' numbers are small: only the printed origin is as large as the distance from the origin.
TEST(FarFromTheOrigin, ExportedValuesAreRelativeToAPlaceAmongTheVertices) {
    const std::string far = shader_source(far_frame(1e7), {});
    EXPECT_NE(far.find("// a_position is relative to (1000000"), std::string::npos);
    EXPECT_EQ(shader_source(far_frame(0), {}).find("a_position is relative"), std::string::npos);
    std::istringstream lines(far);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t equals = line.find(" = ");
        if (!line.starts_with("//   u_") || equals == line.npos) continue;
        std::istringstream values(line.substr(equals + 3));
        for (double value = 0; values >> value;) EXPECT_LT(std::abs(value), 1000) << line;
    }
}

}  // namespace
}  // namespace twinlight::programmable::far_from_origin_test
