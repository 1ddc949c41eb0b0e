// The points that the driver's fixed function makes of a scene, in feedback mode (5.3).
#pragma once

#include <algorithm>
#include <glm/vec4.hpp>
#include <vector>

#include "render/context/gl.h"
#include "render/fixed/fixed.h"
#include "scene/command/command.h"

namespace twinlight {

// Texture coordinates are computed only where a texture is complete: one of one texel.
inline constexpr const char* kOneTexel =
    "GLubyte texel[] = {9, 9, 9, 9};\n"
    "glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);\n"
    "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST); glEnable(GL_TEXTURE_2D);";

struct SentPoint {
    glm::dvec4 window, color, tex_coord;  // window: x, y, z, and the clip coordinate w
};

// A window of `side` x `side` pixels. Needs a current context.
inline std::vector<SentPoint> sent_by_driver(const CommandList& scene, int side) {
    std::vector<GLfloat> buffer(4096);
    glFeedbackBuffer(static_cast<GLsizei>(buffer.size()), GL_4D_COLOR_TEXTURE, buffer.data());
    fixed::Driver driver(side, side);
    glRenderMode(GL_FEEDBACK);
    for (const Command& command : scene.commands) driver.execute(command);
    const GLint written = glRenderMode(GL_RENDER);
    std::vector<SentPoint> all;
    constexpr std::size_t kPoint = 13;  // the token; x, y, z, w; r, g, b, a; s, t, r, q
    for (std::size_t i = 0; i + kPoint <= static_cast<std::size_t>(std::max(written, 0)); i += kPoint) {
        const auto four = [&](std::size_t at) {
            return glm::dvec4(buffer[i + at], buffer[i + at + 1], buffer[i + at + 2], buffer[i + at + 3]);
        };
        all.push_back({four(1), four(5), four(9)});
    }
    return all;
}

}  // namespace twinlight
