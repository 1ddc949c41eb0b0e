// Random generated texture coordinates: those of the driver's feedback (5.3) and of the reference are the same, in floats.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "judge/fuzz/random.h"
#include "render/context/context.h"
#include "render/reference/vertices/tex_gen.h"
#include "render/reference/vertices/vertex_stage.h"
#include "scene/command/text.h"
#include "scene/state/state.h"
#include "sent_points.h"

namespace twinlight::tex_gen_matches_driver_test {
namespace {

constexpr int kStates = 100;  // the driver compiles a program for each
constexpr int kVertices = 12;
constexpr int kSide = 64;

class Builder {
  public:
    explicit Builder(std::uint64_t seed) : random_(seed) {}

    std::string text() {
        add(kOneTexel);
        add("glMatrixMode(GL_PROJECTION); glOrtho(-99, 99, -99, 99, -99, 99); glMatrixMode(GL_MODELVIEW);");
        for (int coordinate = 0; coordinate < 4; ++coordinate)
            if (random_.chance(0.7)) generate(coordinate);
        if (random_.chance(0.3)) add("glEnable(GL_NORMALIZE);");
        if (random_.chance(0.3)) add("glEnable(GL_RESCALE_NORMAL);");
        if (random_.chance(0.3)) add("glEnable(GL_LIGHTING); glEnable(GL_LIGHT0);");
        if (random_.chance(0.4))
            add(fmt::format(
                "glMatrixMode(GL_TEXTURE); glTranslatef({}); glRotatef({:.2f}, {}); glMatrixMode(GL_MODELVIEW);",
                numbers(3), random_.uniform(-180, 180), numbers(3)));
        add(fmt::format("glTranslatef(0, 0, {:.3f});", random_.uniform(-40, -6)));
        turn();
        add("glBegin(GL_POINTS);");
        for (int i = 0; i < kVertices; ++i)
            add(fmt::format("glTexCoord4f({}); glNormal3f({}); glVertex4f({}, {:.3f});", numbers(4), numbers(3),
                            numbers(3), random_.chance(0.8) ? 1 : random_.uniform(0.5, 2)));
        add("glEnd();");
        return std::move(text_);
    }

  private:
    void add(const std::string& line) { text_ += line + "\n"; }
    std::string numbers(int count) {
        std::string all;
        for (int i = 0; i < count; ++i) all += fmt::format("{}{:.4f}", i ? ", " : "", random_.uniform(-1.5, 1.5));
        return all;
    }
    void turn() {
        add(fmt::format("glRotatef({:.2f}, {});", random_.uniform(-180, 180), numbers(3)));
        if (random_.chance(0.5))
            add(fmt::format("glScalef({0:.3f}, {1:.3f}, {0:.3f});", random_.uniform(0.4, 2), random_.uniform(0.4, 2)));
    }
    void generate(int coordinate) {
        const char* const modes[] = {"GL_OBJECT_LINEAR", "GL_EYE_LINEAR", "GL_REFLECTION_MAP", "GL_NORMAL_MAP",
                                     "GL_SPHERE_MAP"};
        const int most = coordinate == 3 ? 2 : coordinate == 2 ? 4 : 5;
        const char name = "STRQ"[coordinate];
        add(fmt::format("glTexGeni(GL_{0}, GL_TEXTURE_GEN_MODE, {1}); glEnable(GL_TEXTURE_GEN_{0});", name,
                        modes[random_.below(most)]));
        add("glPushMatrix();");
        turn();
        for (const char* plane : {"OBJECT", "EYE"})
            add(fmt::format("glTexGenfv(GL_{}, GL_{}_PLANE, (GLfloat[]){{{}}});", name, plane, numbers(4)));
        add("glPopMatrix();");
    }

    fuzz::Random random_;
    std::string text_;
};

// After the texture matrix.
TEST(TexGenMatchesDriver, InFloatsOverRandomStates) {
    const auto context = make_offscreen_context(kSide, kSide);
    for (std::uint64_t seed = 1; seed <= kStates && !HasFailure(); ++seed) {
        const CommandList scene = read_scene(Builder(seed).text(), "scene", "scene");
        SCOPED_TRACE(fmt::format("seed {}\n{}", seed, print_scene(scene)));
        const Frame frame = make_frame(scene, {.width = kSide, .height = kSide});
        const Draw& draw = std::get<Draw>(frame.items.back());
        const std::vector<reference::StageVertex> vertices = reference::vertex_stage(draw);
        const std::vector<SentPoint> driver = sent_by_driver(scene, kSide);
        ASSERT_EQ(driver.size(), vertices.size());
        for (std::size_t n = 0; n < vertices.size(); ++n) {
            constexpr double kMatrix =
                32 * 0x1p-24;  // the product with the texture matrix, and the commands that make it
            const double error = reference::generated_error(draw, draw.texture, draw.vertices[n], vertices[n]);
            for (int i = 0; i < 4; ++i)
                EXPECT_NEAR(driver[n].tex_coord[i], vertices[n].tex_coord[i], error + kMatrix * (1 + 20))
                    << n << "strq"[i];
        }
    }
}

}  // namespace
}  // namespace twinlight::tex_gen_matches_driver_test
