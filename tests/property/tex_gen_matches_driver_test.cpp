// Random generated texture coordinates: those of the driver's feedback (5.3) and of the reference are the same, in floats.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <optional>

#include "judge/fuzz/random.h"
#include "render/context/context.h"
#include "render/context/gl.h"
#include "render/fixed/fixed.h"
#include "render/reference/tex_gen.h"
#include "render/reference/vertex_stage.h"
#include "scene/command/text.h"
#include "scene/state/state.h"

namespace twinlight {
namespace {

constexpr int kStates = 3000;
constexpr int kSide = 64;

class Builder {
  public:
    explicit Builder(std::uint64_t seed) : random_(seed) {}

    std::string text() {
        add("GLubyte texel[] = {9, 9, 9, 9}; glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, "
            "GL_UNSIGNED_BYTE, "
            "texel); glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST); glEnable(GL_TEXTURE_2D);");
        add("glMatrixMode(GL_PROJECTION); glFrustum(-1, 1, -1, 1, 1, 100); glMatrixMode(GL_MODELVIEW);");
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
        const std::string w = random_.chance(0.2) ? fmt::format(", {:.3f}", random_.uniform(0.5, 2)) : ", 1";
        add(fmt::format("glBegin(GL_POINTS); glTexCoord4f({}); glNormal3f({}); glVertex4f({}{}); glEnd();", numbers(4),
                        numbers(3), numbers(3), w));
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

// The texture coordinates of the only vertex, after the texture matrix.
std::optional<glm::dvec4> of_driver(const CommandList& scene) {
    std::array<GLfloat, 64> buffer{};
    glFeedbackBuffer(static_cast<GLsizei>(buffer.size()), GL_4D_COLOR_TEXTURE, buffer.data());
    fixed::Driver driver(kSide, kSide);
    glRenderMode(GL_FEEDBACK);
    for (const Command& command : scene.commands) driver.execute(command);
    constexpr GLint kPoint = 1 + 4 + 4 + 4;  // the token; x, y, z, w; r, g, b, a; s, t, r, q
    if (glRenderMode(GL_RENDER) != kPoint) return std::nullopt;
    return glm::dvec4(buffer[9], buffer[10], buffer[11], buffer[12]);
}

TEST(TexGenMatchesDriver, InFloatsOverRandomStates) {
    const auto context = make_offscreen_context(kSide, kSide);
    int compared = 0;
    for (std::uint64_t seed = 1; seed <= kStates && !HasFailure(); ++seed) {
        const CommandList scene = read_scene(Builder(seed).text(), "scene", "scene");
        SCOPED_TRACE(fmt::format("seed {}\n{}", seed, print_scene(scene)));
        const Frame frame = make_frame(scene, {.width = kSide, .height = kSide});
        const Draw& draw = std::get<Draw>(frame.items.back());
        const reference::StageVertex vertex = reference::vertex_stage(draw).front();
        const std::optional<glm::dvec4> driver = of_driver(scene);
        if (!driver) continue;  // the vertex is outside the view
        ++compared;
        constexpr double kMatrix = 32 * 0x1p-24;  // the product with the texture matrix, and the commands that make it
        const double error = reference::generated_error(draw, draw.vertices.front(), vertex);
        for (int i = 0; i < 4; ++i)
            EXPECT_NEAR((*driver)[i], vertex.tex_coord[i], error + kMatrix * (1 + 20)) << "strq"[i];
    }
    EXPECT_GT(compared, kStates / 2);
}

}  // namespace
}  // namespace twinlight
