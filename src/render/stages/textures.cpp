#include "render/stages/textures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "base/text/translation.h"
#include "render/context/context.h"
#include "render/context/gl.h"
#include "render/context/render_target.h"
#include "scene/frame/parameter_rows.h"

namespace twinlight {
namespace {

// Texels are stored without gaps, so glPixelStore and glPixelTransfer get their initial values.
void set_unpacking() {
    for (GLenum name : {GL_UNPACK_SWAP_BYTES, GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS,
                        GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_IMAGES})
        glPixelStorei(name, 0);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
}

// Depths as the only value of a pixel.
std::vector<float> depths_of(const TextureImage& image) {
    std::vector<float> depths;
    depths.reserve(image.texels.size());
    for (const glm::vec4& texel : image.texels) depths.push_back(texel.r);
    return depths;
}

void upload(const Texture& texture) {
    set_unpacking();
    const auto upload_level = [&](std::size_t face, std::size_t i) {
        const TextureImage& image = texture.face(face)[i];
        if (image.texels.empty()) return;
        // The requested internal format: the driver then uses as many bits as for the commands themselves.
        const auto level = static_cast<GLint>(i), format = static_cast<GLint>(image.internal_format);
        const GLenum target =
            texture.is_cube() ? GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(face) : GLenum{GL_TEXTURE_2D};
        const bool has_depths = image.base_format == kGL_DEPTH_COMPONENT;
        const std::vector<float> depths = has_depths ? depths_of(image) : std::vector<float>();
        const GLenum pixels = has_depths ? GL_DEPTH_COMPONENT : GL_RGBA;
        const void* const data = has_depths ? static_cast<const void*>(depths.data()) : image.texels.data();
        if (texture.is_flat())
            glTexImage1D(GL_TEXTURE_1D, level, format, image.width, 0, pixels, GL_FLOAT, data);
        else if (texture.is_volume())
            glTexImage3D(GL_TEXTURE_3D, level, format, image.width, image.height, image.depth, 0, pixels, GL_FLOAT,
                         data);
        else
            glTexImage2D(target, level, format, image.width, image.height, 0, pixels, GL_FLOAT, data);
        if (const GLenum error = glGetError(); error != GL_NO_ERROR)
            throw std::runtime_error(tr("the driver refuses level {} of a texture, {} x {} x {} texels: GL error {:#x}",
                                        level, image.width, image.height, image.depth, error));
    };
    for (std::size_t face = 0; face < texture.face_count(); ++face)
        for (std::size_t i = 0; i < texture.face(face).size(); ++i) upload_level(face, i);
}

void set_parameters(const Texture& texture, Clamping clamping) {
    const auto set = [&](GLenum name, Enum value) { glTexParameteri(texture.target, name, static_cast<GLint>(value)); };
    set(GL_TEXTURE_MIN_FILTER, texture.min_filter);
    set(GL_TEXTURE_MAG_FILTER, texture.mag_filter);
    // If the shader clamps, a linear filter must see half of the border.
    Enum clamped = texture.filters_linearly() ? kGL_CLAMP_TO_BORDER : kGL_CLAMP_TO_EDGE;
    if (clamping == Clamping::kDriver || texture.is_cube()) clamped = kGL_CLAMP;
    set(GL_TEXTURE_WRAP_S, texture.wrap_s == kGL_CLAMP ? clamped : texture.wrap_s);
    set(GL_TEXTURE_WRAP_T, texture.wrap_t == kGL_CLAMP ? clamped : texture.wrap_t);
    set(GL_TEXTURE_WRAP_R, texture.wrap_r == kGL_CLAMP ? clamped : texture.wrap_r);
    // Drivers disagree on what this mode does in GLSL, so a shader has luminance and does the rest itself.
    set(GL_DEPTH_TEXTURE_MODE, clamping == Clamping::kDriver ? texture.depth_mode : kGL_LUMINANCE);
    set(GL_TEXTURE_COMPARE_MODE, texture.compare_mode);
    set(GL_TEXTURE_COMPARE_FUNC, texture.compare_func);
    const glm::vec4 border(texture.border_color);
    glTexParameterfv(texture.target, GL_TEXTURE_BORDER_COLOR, &border[0]);
    glTexParameterf(texture.target, GL_TEXTURE_MIN_LOD, static_cast<float>(texture.min_lod));
    glTexParameterf(texture.target, GL_TEXTURE_MAX_LOD, static_cast<float>(texture.max_lod));
    if (!texture.is_flat())  // llvmpipe 22.3 crashes there
        glTexParameterf(texture.target, GL_TEXTURE_MAX_ANISOTROPY_EXT, static_cast<float>(texture.max_anisotropy));
    glTexParameteri(texture.target, GL_TEXTURE_MAX_LEVEL, static_cast<GLint>(texture.levels.size()) - 1);
}

// A texture object with all images and parameters of the texture.
GLuint uploaded(const Texture& texture, Clamping clamping) {
    constexpr int kMostOldErrors = 16;
    for (int i = 0; i < kMostOldErrors && glGetError() != GL_NO_ERROR; ++i) {
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

// Compares all members; the structured binding fails to compile if one is added.
bool are_same(const TextureImage& a, const TextureImage& b) {
    const auto& [width, height, depth, base_format, internal_format, texels, parts, half_of] = a;
    static_assert(sizeof(glm::vec4) == 4 * sizeof(float));
    const bool are_whole = parts.empty() && b.parts.empty() && !half_of && !b.half_of;
    return are_whole && width == b.width && height == b.height && depth == b.depth && base_format == b.base_format &&
           internal_format == b.internal_format && texels.size() == b.texels.size() &&
           (texels.empty() || std::memcmp(texels.data(), b.texels.data(), texels.size() * sizeof(glm::vec4)) == 0);
}

bool are_same(const std::vector<TextureImage>& a, const std::vector<TextureImage>& b) {
    return std::ranges::equal(a, b, [](const TextureImage& x, const TextureImage& y) { return are_same(x, y); });
}

bool are_same(const Texture& a, const Texture& b) {
    return a.target == b.target &&
           std::ranges::all_of(kTextureParameters, [&](const auto& row) { return has_equal(a, b, row); }) &&
           are_same(a.levels, b.levels) &&
           std::ranges::equal(a.further_faces, b.further_faces,
                              [](const auto& x, const auto& y) { return are_same(x, y); });
}

}  // namespace

CopySource drawn_to_copy(const Frame& picture, CopiedBuffer buffer, const Rectangle& area,
                         const std::function<void()>& draw) {
    const auto drawn = [&]() -> CopySource {
        draw();
        const auto read = buffer == CopiedBuffer::kColors   ? read_pixels
                          : buffer == CopiedBuffer::kDepths ? read_depths
                                                            : read_stencils;
        return {.picture = read(area.width, area.height, area.x, area.y), .corner = {area.x, area.y}};
    };
    if (!picture.is_object) return drawn();
    const RenderTarget target(picture.width, picture.height, ColorBuffer::kUnorm8);
    target.bind();
    CopySource source = drawn();
    target.release();
    return source;
}

Textures::~Textures() {
    for (const auto& [key, uploaded] : uploaded_) glDeleteTextures(1, &uploaded.name);
}

void Textures::bind(const TextureUnit& unit) {
    const Texture& texture = *unit.texture;
    auto found = uploaded_.find(&texture);
    if (found == uploaded_.end()) found = find_equal(unit.texture);
    if (found == uploaded_.end()) {
        ++upload_count_;
        found =
            uploaded_.emplace(&texture, Uploaded{.texture = unit.texture, .name = uploaded(texture, clamping_)}).first;
    }
    found->second.used = true;
    glBindTexture(texture.target, found->second.name);
    // The Draw's bias includes the texture's own.
    glTexParameterf(texture.target, GL_TEXTURE_LOD_BIAS, static_cast<float>(unit.lod_bias));
}

TextureUnits combined_units(const Draw& draw) {
    TextureUnits units;
    if (!draw.combines_textures()) return units;
    draw.for_each_unit([&](std::size_t number, const TextureUnit& unit) { units.emplace_back(number, unit); });
    return units;
}

// Two units may have one texture with different biases, so here the bias belongs to the unit.
void Textures::bind_units(const TextureUnits& units) {
    for (const auto& [number, unit] : units) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(number));
        bind(unit);
        glTexParameterf(unit.texture->target, GL_TEXTURE_LOD_BIAS, 0);
        glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, static_cast<float>(unit.lod_bias));
    }
}

void Textures::release_units(const TextureUnits& units) {
    for (const auto& [number, unit] : units) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(number));
        glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, 0);
    }
    glActiveTexture(GL_TEXTURE0);
}

Textures::Map::iterator Textures::find_equal(const std::shared_ptr<const Texture>& texture) {
    const auto same = std::ranges::find_if(
        uploaded_, [&](const auto& entry) { return !entry.second.used && are_same(*entry.second.texture, *texture); });
    if (same == uploaded_.end()) return same;
    Map::node_type node = uploaded_.extract(same);
    node.key() = texture.get();
    node.mapped().texture = texture;
    return uploaded_.insert(std::move(node)).position;
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

void disable_textures() {
    GLint units = 1;
    glGetIntegerv(GL_MAX_TEXTURE_UNITS, &units);
    for (GLint unit = 0; unit < units; ++unit) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        for (const GLenum target : {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP})
            glDisable(target);
    }
}

}  // namespace twinlight
