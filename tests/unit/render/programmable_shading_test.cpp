// The programmable renderer over whole primitives: flat, gouraud and phong; and compared with the driver's fixed
// function.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../hand_built_draws.h"
#include "../pictures.h"
#include "render/fixed/fixed.h"
#include "scene/command/text.h"
#include "scene/state/state.h"

namespace twinlight::programmable::programmable_shading_test {
namespace {

// ---- Shading ----

// Emission follows the colours: 2 on the left, 0 on the right.
Draw ramp() {
    LightingState lighting = dark();
    lighting.color_material = {.enabled = true, .face = kGL_FRONT_AND_BACK, .mode = kGL_EMISSION};
    Draw draw = square(lighting);
    for (Vertex& v : draw.vertices.edit()) v.color = v.position_object.x < 0 ? grey(2) : grey(0);
    return draw;
}

TEST(Programmable, ClampsAtTheVertexBeforeItInterpolates) {
    const Image image = picture(ramp(), 8);
    for (int x = 0; x < 8; ++x) EXPECT_NEAR(image.at(x, 4)[0], 1 - (x + 0.5) / 8, kFloatArithmetic);
}

TEST(Programmable, ClampsEachFragmentInPhongShading) {
    const Image image = picture(ramp(), 8, kPhong);
    for (int x = 0; x < 8; ++x) EXPECT_NEAR(image.at(x, 4)[0], std::min(1.0, 2 - (x + 0.5) / 4), kFloatArithmetic);
}

TEST(Programmable, FindsInPhongShadingTheHighlightThatGouraudMisses) {
    LightingState lighting = shiny(128);
    lighting.front.specular = grey(1);
    lighting.lights[0].position_eye = {0, 0, 0.5, 1};
    const double half_pixel = 1.0 / 9;
    const int middle = 4;  // of 9: its centre is (0, 0), right below the light
    EXPECT_NEAR(picture(square(lighting), 9).at(middle, middle)[0], 0, kFloatArithmetic);
    const Image phong = picture(square(lighting), 9, kPhong);
    EXPECT_NEAR(phong.at(middle, middle)[0], 1, kFloatArithmetic);
    const glm::dvec3 to_light = glm::normalize(glm::dvec3(-2 * half_pixel, 0, 0.5));
    const double n_dot_h = glm::normalize(to_light + glm::dvec3(0, 0, 1)).z;
    EXPECT_NEAR(phong.at(middle + 1, middle)[0], std::pow(n_dot_h, 128), 128 * kFloatArithmetic);
}

TEST(Programmable, MakesInterpolatedNormalsUnitInPhongShading) {
    LightingState lighting = dark();
    lighting.front.diffuse = grey(1);
    Draw draw = square(lighting);
    for (Vertex& v : draw.vertices.edit())
        v.normal_object = {v.position_object.x * kHalfRoot3, 0, 0.5};  // +-60 degrees
    EXPECT_NEAR(picture(draw, 9, kPhong).at(4, 4)[0], 1, kFloatArithmetic);
    EXPECT_NEAR(picture(draw, 9).at(4, 4)[0], 0.5, kFloatArithmetic);
}

// ---- Compared with the driver's fixed function ----

// Uses the same kind of call: llvmpipe cuts a quadrilateral from its first to its third vertex in glBegin and
// glDrawArrays, and from its second to its fourth in glDrawElements (GL 2.1 leaves it open).
void draw_unlit_by_fixed_function(const Draw& draw) {
    glShadeModel(draw.lighting.shade_model);
    glPolygonMode(GL_FRONT_AND_BACK, draw.raster.polygon_mode_front);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    glVertexPointer(4, GL_DOUBLE, sizeof(Vertex), &draw.vertices[0].position_object);
    glColorPointer(4, GL_DOUBLE, sizeof(Vertex), &draw.vertices[0].color);
    const auto count = static_cast<GLsizei>(draw.count());
    if (draw.indices.empty())
        glDrawArrays(draw.mode, 0, count);
    else
        glDrawElements(draw.mode, count, GL_UNSIGNED_INT, draw.indices.data());
    glFinish();
}

// A zigzag for strips, a ring for fans and polygons; every vertex has a different colour.
Draw primitives(Enum mode) {
    Draw draw;
    draw.mode = mode;
    const int count = 8;
    const bool ring = mode == kGL_POLYGON || mode == kGL_TRIANGLE_FAN || mode == kGL_LINE_LOOP;
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * 3.14159265358979 * (i + 0.3) / count;
        glm::dvec2 p = ring ? 0.9 * glm::dvec2(std::cos(angle), std::sin(angle))
                            : glm::dvec2(-0.9 + 0.25 * (i - i % 2) + 0.07 * (i % 2), i % 2 ? 0.83 : -0.77);
        if (mode == kGL_QUADS && i % 4 >= 2) p.y = -p.y;
        draw.vertices.edit().push_back({.position_object = {p, 0, 1},
                                        .normal_object = {0, 0, 1},
                                        .color = {(i & 1) ? 1 : 0.2, (i & 2) ? 1 : 0.2, (i & 4) ? 1 : 0.2, 1}});
    }
    return draw;
}

TEST(Programmable, TakesEachPrimitivesProvokingVertexFromTheDriver) {
    const int size = 64;
    for (Enum mode = kGL_POINTS; mode <= kGL_POLYGON; ++mode)
        for (const Enum shade_model : {kGL_FLAT, kGL_SMOOTH})
            for (const Enum polygon_mode : {kGL_FILL, kGL_LINE, kGL_POINT})
                for (const bool indexed : {false, true}) {
                    Draw draw = primitives(mode);
                    draw.lighting.shade_model = shade_model;
                    draw.raster.polygon_mode_front = draw.raster.polygon_mode_back = polygon_mode;
                    if (indexed) draw.indices = {0, 1, 2, 3, 4, 5, 6, 7};
                    const Image ours = quantised(picture(draw, size));
                    const auto context = make_offscreen_context(size, size, ColorBuffer::kFloat);
                    draw_unlit_by_fixed_function(draw);
                    const Image drivers = quantised(read_pixels(size, size));
                    int differing = 0;
                    for (std::size_t i = 0; i < ours.pixels.size(); ++i)
                        differing += ours.pixels[i] != drivers.pixels[i];
                    EXPECT_EQ(differing, 0) << fmt::format("mode {} shade model {:#x} polygon mode {:#x} indexed {}",
                                                           mode, shade_model, polygon_mode, indexed);
                }
}

TEST(Programmable, FollowsTable212sProvokingVertexOfPolygonsQuadsAndStrips) {
    struct Case {
        Enum mode;
        std::size_t provoking;  // of the first primitive
    };
    for (const Case& c : {Case{kGL_POLYGON, 0}, Case{kGL_QUADS, 3}, Case{kGL_QUAD_STRIP, 3}, Case{kGL_TRIANGLES, 2},
                          Case{kGL_TRIANGLE_STRIP, 2}, Case{kGL_TRIANGLE_FAN, 2}}) {
        Draw draw = square();
        draw.mode = c.mode;
        if (c.mode == kGL_QUAD_STRIP) std::swap(draw.vertices.edit()[2], draw.vertices.edit()[3]);
        if (c.mode == kGL_TRIANGLES) draw.vertices.edit().pop_back();
        draw.lighting.enabled = false;
        for (Vertex& v : draw.vertices.edit()) v.color = grey(0.25);
        draw.vertices.edit()[c.provoking].color = grey(0.75);
        const Image image = picture(draw, 8, {{{.shading = Shading::kFlat}}});
        EXPECT_EQ(image.at(5, 6)[0], 0.75f) << "mode " << c.mode;  // near (1, -1), which is in each first primitive
    }
}

// Lighting states that light a scene's spheres differently, in every way that GL has.
constexpr const char* kScene = R"(
glMatrixMode(GL_PROJECTION);
gluPerspective(45, 1, 0.1, 100);
glMatrixMode(GL_MODELVIEW);
gluLookAt(0, 1, 6,  0, 0, 0,  0, 1, 0);
GLfloat key[] = {2, 3, 4, 1}, red[] = {1, 0.3, 0.2, 1}, shiny[] = {0.7, 0.8, 0.9, 1};
glLightfv(GL_LIGHT0, GL_POSITION, key);
glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 0.09);
glLightfv(GL_LIGHT0, GL_AMBIENT, (GLfloat[]){0.2, 0.1, 0.3, 1});
glLightfv(GL_LIGHT1, GL_POSITION, (GLfloat[]){-2, 1, 3, 0});
glLightfv(GL_LIGHT1, GL_DIFFUSE, (GLfloat[]){0.2, 0.3, 0.5, 1});
glLightfv(GL_LIGHT1, GL_SPECULAR, (GLfloat[]){0.5, 0.5, 0.5, 1});
glLightfv(GL_LIGHT2, GL_POSITION, (GLfloat[]){0, 3, 1, 1});
glLightfv(GL_LIGHT2, GL_SPOT_DIRECTION, (GLfloat[]){0, -3, -1});
glLightf(GL_LIGHT2, GL_SPOT_CUTOFF, 40);
glLightf(GL_LIGHT2, GL_SPOT_EXPONENT, 7);
glLightfv(GL_LIGHT2, GL_DIFFUSE, (GLfloat[]){0, 0.5, 0, 1});
glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glEnable(GL_LIGHT1); glEnable(GL_LIGHT2);
glEnable(GL_DEPTH_TEST); glEnable(GL_NORMALIZE);
glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
glMaterialfv(GL_FRONT, GL_DIFFUSE, red);
glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, shiny);
glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 32);
glutSolidSphere(1, 24, 12);
glTranslatef(1.5, 0, 0);
glScalef(0.5, 1, 0.5);
glRotatef(120, 1, 0.2, 0);
glutSolidCone(0.8, 1.2, 16, 4);
)";

TEST(Programmable, DrawsWhatTheDriversFixedFunctionDraws) {
    constexpr int kSize = 200;
    const auto scene = std::make_shared<const CommandList>(read_scene(kScene, "scene.gl", "scene"));
    StateOptions state_options;
    state_options.width = state_options.height = kSize;
    const Scene made = make_scene(scene, state_options);
    const Frame& frame = made.frame;
    for (const Shading shading : {Shading::kFlat, Shading::kGouraud}) {
        const auto context = make_offscreen_context(kSize, kSize);
        const Image before = fixed::render(made, {.shading = shading});
        Renderer renderer;
        const Image ours = renderer.render(frame, {{{.shading = shading}}});
        EXPECT_EQ(fixed::render(made, {.shading = shading}).pixels, before.pixels) << "the context is as it was";
        int differing = 0;
        double largest = 0;
        for (std::size_t i = 0; i < ours.pixels.size(); ++i) {
            double difference = 0;
            for (std::size_t c = 0; c < 4; ++c)
                difference = std::max(difference, std::abs(double(ours.pixels[i][c]) - before.pixels[i][c]));
            differing += difference > 0.5 / 255;
            largest = std::max(largest, difference);
        }
        EXPECT_LT(differing, kSize * kSize / 1000);
        RecordProperty(fmt::format("differing_{}", int(shading)), differing);
        EXPECT_LT(largest, 1.5 / 255);  // 1/255, and a margin
    }
}

TEST(Programmable, LeavesTheContextAsItWas) {
    const auto context = make_offscreen_context(8, 8);
    Draw draw = square();
    draw.indices = {0, 1, 2, 3};
    draw.raster.depth_test = draw.raster.cull_enabled = true;
    draw.raster.polygon_mode_front = kGL_LINE;
    draw.raster.viewport = {1, 2, 3, 4};
    Renderer renderer;
    renderer.draw({.width = 8, .height = 8, .items = {Clear{.color = true, .clear_color = grey(0.5)}, draw}}, {});
    const auto value = [](GLenum name) {
        GLint values[4] = {};
        glGetIntegerv(name, values);
        return values[0];
    };
    for (const GLenum name : {GL_CURRENT_PROGRAM, GL_VERTEX_ARRAY_BINDING, GL_ARRAY_BUFFER_BINDING,
                              GL_ELEMENT_ARRAY_BUFFER_BINDING, GL_DEPTH_TEST, GL_CULL_FACE, GL_VIEWPORT})
        EXPECT_EQ(value(name), 0) << name;
    EXPECT_EQ(value(GL_POLYGON_MODE), GL_FILL);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

}  // namespace
}  // namespace twinlight::programmable::programmable_shading_test
