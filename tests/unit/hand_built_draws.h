// Draws built by hand, and the colours that the shader path gives them.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <limits>

#include "render/context/context.h"
#include "render/context/gl.h"
#include "render/programmable/programmable.h"
#include "scene/frame/frame.h"

namespace twinlight::programmable {

// What float arithmetic and a float colour buffer may differ from a value by hand, on colours of about 1.
inline constexpr double kFloatArithmetic = 20 * std::numeric_limits<float>::epsilon();
inline constexpr double kHalfRoot3 = 0.86602540378443865;

inline const Options kPhong{{{.shading = Shading::kPhong}}};
inline const Options kGlAlone{{{.shading = std::nullopt, .lecture_variants = false}}};

// A black material, no scene ambient, GL_LIGHT0 on: each test adds the term that it looks at.
inline LightingState dark() {
    LightingState lighting;
    lighting.enabled = true;
    lighting.lights[0].enabled = true;
    lighting.light_model.ambient = {0, 0, 0, 1};
    for (Material* material : {&lighting.front, &lighting.back}) material->ambient = material->diffuse = {0, 0, 0, 1};
    return lighting;
}

// A square over the whole picture: in object and eye coordinates from (-1, -1, 0) to (1, 1, 0),
// counterclockwise, facing along z. Clip coordinates take z away, so that it is seen wherever it lies.
inline Draw square(const LightingState& lighting = dark()) {
    Draw draw;
    draw.mode = kGL_QUADS;
    for (const glm::dvec2 corner : {glm::dvec2(-1, -1), glm::dvec2(1, -1), glm::dvec2(1, 1), glm::dvec2(-1, 1)})
        draw.vertices.edit().push_back(
            {.position_object = {corner, 0, 1}, .normal_object = {0, 0, 1}, .color = {1, 1, 1, 1}});
    draw.clip_from_eye[2][2] = 0;
    draw.lighting = lighting;
    return draw;
}

// A single vertex that fills a picture of one pixel, wherever it lies.
inline Draw point(const glm::dvec3& position, const LightingState& lighting = dark()) {
    Draw draw;
    draw.mode = kGL_POINTS;
    draw.vertices = {{.position_object = glm::dvec4(position, 1), .normal_object = {0, 0, 1}, .color = {1, 1, 1, 1}}};
    draw.clip_from_eye = glm::dmat4(0);
    draw.clip_from_eye[3][3] = 1;
    draw.lighting = lighting;
    return draw;
}

inline Image picture(Draw draw, int size, const Options& options = {}) {
    const auto context = make_offscreen_context(size, size, ColorBuffer::kFloat);
    draw.raster.viewport = {0, 0, size, size};
    Frame frame{.width = size, .height = size, .items = {draw}};
    Renderer renderer;
    Image image = renderer.render(frame, options);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    return image;
}

// The colour of a picture of one pixel.
inline glm::dvec4 color(const Draw& draw, const Options& options = {}) {
    const Rgba c = picture(draw, 1, options).at(0, 0);
    return {c[0], c[1], c[2], c[3]};
}

inline void expect_color(const glm::dvec4& actual, const glm::dvec4& expected) {
    for (int i = 0; i < 4; ++i)
        EXPECT_NEAR(actual[i], expected[i], kFloatArithmetic)
            << fmt::format("({}, {}, {}, {})", actual.r, actual.g, actual.b, actual.a);
}

inline glm::dvec4 grey(double value) { return {value, value, value, 1}; }

inline LightingState shiny(double shininess) {
    LightingState lighting = dark();
    lighting.front.specular = {1, 0.5, 0, 1};
    lighting.front.shininess = shininess;
    return lighting;
}

// GL_LIGHT0 shines on a white, shiny square from the front: with a cone and ambient light.
inline LightingState cone() {
    LightingState lighting = dark();
    lighting.front.ambient = lighting.front.diffuse = lighting.front.specular = {1, 1, 1, 1};
    lighting.front.shininess = 8;
    LightSource& light = lighting.lights[0];
    light.ambient = light.diffuse = light.specular = {0.25, 0.25, 0.25, 1};
    light.position_eye = {0, 0, 1, 1};
    light.spot_cutoff_deg = 20;
    return lighting;
}

}  // namespace twinlight::programmable
