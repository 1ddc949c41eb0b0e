#include "stages/textures.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "context/gl.h"
#include "effect/fragment_effects.h"

namespace twinlight {
namespace {

// The texels lie in order, as nothing else is said to glPixelStore and glPixelTransfer.
void set_unpacking() {
    for (GLenum name : {GL_UNPACK_SWAP_BYTES, GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS})
        glPixelStorei(name, 0);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
}

void upload(const Texture& texture) {
    set_unpacking();
    for (std::size_t i = 0; i < texture.levels.size(); ++i) {
        const TextureImage& image = texture.levels[i];
        if (image.texels.empty()) continue;
        // The internal format that was asked for: the driver then has as many bits as for the commands themselves.
        const auto level = static_cast<GLint>(i), format = static_cast<GLint>(image.internal_format);
        if (texture.target == kGL_TEXTURE_1D)
            glTexImage1D(GL_TEXTURE_1D, level, format, image.width, 0, GL_RGBA, GL_FLOAT, image.texels.data());
        else
            glTexImage2D(GL_TEXTURE_2D, level, format, image.width, image.height, 0, GL_RGBA, GL_FLOAT,
                         image.texels.data());
        if (const GLenum error = glGetError(); error != GL_NO_ERROR)
            throw std::runtime_error(
                fmt::format("the driver refuses level {} of a texture, {} x {} texels: GL error {:#x}", level,
                            image.width, image.height, error));
    }
}

void set_parameters(const Texture& texture, Clamping clamping) {
    const auto set = [&](GLenum name, Enum value) { glTexParameteri(texture.target, name, static_cast<GLint>(value)); };
    set(GL_TEXTURE_MIN_FILTER, texture.min_filter);
    set(GL_TEXTURE_MAG_FILTER, texture.mag_filter);
    // Where the shader clamps, half of the border is in a linear filter's sight.
    Enum clamped = filters_linearly(texture) ? kGL_CLAMP_TO_BORDER : kGL_CLAMP_TO_EDGE;
    if (clamping == Clamping::kDriver) clamped = kGL_CLAMP;
    set(GL_TEXTURE_WRAP_S, texture.wrap_s == kGL_CLAMP ? clamped : texture.wrap_s);
    set(GL_TEXTURE_WRAP_T, texture.wrap_t == kGL_CLAMP ? clamped : texture.wrap_t);
    const glm::vec4 border(texture.border_color);
    glTexParameterfv(texture.target, GL_TEXTURE_BORDER_COLOR, &border[0]);
}

// A texture object that has all of it.
GLuint uploaded(const Texture& texture, Clamping clamping) {
    constexpr int kErrorsOfOthers = 16;
    for (int i = 0; i < kErrorsOfOthers && glGetError() != GL_NO_ERROR; ++i) {
    }
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(texture.target, name);
    set_parameters(texture, clamping);
    try {
        upload(texture);
    } catch (...) {
        glDeleteTextures(1, &name);
        throw;
    }
    return name;
}

}  // namespace

Textures::~Textures() {
    for (const auto& [key, uploaded] : uploaded_) glDeleteTextures(1, &uploaded.name);
}

void Textures::bind(const TextureUnit& unit) {
    const Texture& texture = *unit.texture;
    auto found = uploaded_.find(&texture);
    if (found == uploaded_.end())
        found =
            uploaded_.emplace(&texture, Uploaded{.texture = unit.texture, .name = uploaded(texture, clamping_)}).first;
    found->second.used = true;
    glBindTexture(texture.target, found->second.name);
    // 3.8.8 adds the unit's bias to the texture's own, which a Texture does not have.
    glTexParameterf(texture.target, GL_TEXTURE_LOD_BIAS, static_cast<float>(unit.lod_bias));
}

void Textures::drop_unused() {
    for (auto at = uploaded_.begin(); at != uploaded_.end();) {
        if (!std::exchange(at->second.used, false)) {
            glDeleteTextures(1, &at->second.name);
            at = uploaded_.erase(at);
        } else {
            ++at;
        }
    }
}

}  // namespace twinlight
