#include "programmable/textures.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "context/gl.h"
#include "effect/fragment_effects.h"

namespace twinlight::programmable {
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

void set_parameters(const Texture& texture) {
    const auto set = [&](GLenum name, Enum value) { glTexParameteri(texture.target, name, static_cast<GLint>(value)); };
    set(GL_TEXTURE_MIN_FILTER, texture.min_filter);
    set(GL_TEXTURE_MAG_FILTER, texture.mag_filter);
    // GL_CLAMP: the shader clamps, to where the border begins; half of it is in a linear filter's sight.
    const Enum clamped = filters_linearly(texture) ? kGL_CLAMP_TO_BORDER : kGL_CLAMP_TO_EDGE;
    set(GL_TEXTURE_WRAP_S, texture.wrap_s == kGL_CLAMP ? clamped : texture.wrap_s);
    set(GL_TEXTURE_WRAP_T, texture.wrap_t == kGL_CLAMP ? clamped : texture.wrap_t);
    const glm::vec4 border(texture.border_color);
    glTexParameterfv(texture.target, GL_TEXTURE_BORDER_COLOR, &border[0]);
}

}  // namespace

Textures::~Textures() {
    for (const auto& [key, uploaded] : uploaded_) glDeleteTextures(1, &uploaded.name);
}

void Textures::bind(const TextureUnit& unit) {
    const Texture& texture = *unit.texture;
    const auto [found, is_new] = uploaded_.try_emplace(&texture, Uploaded{.texture = unit.texture});
    Uploaded& uploaded = found->second;
    uploaded.used = true;
    if (is_new) glGenTextures(1, &uploaded.name);
    glBindTexture(texture.target, uploaded.name);
    if (is_new) {
        while (glGetError() != GL_NO_ERROR) {
        }  // those of others
        set_parameters(texture);
        upload(texture);
    }
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

}  // namespace twinlight::programmable
