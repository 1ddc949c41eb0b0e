// glTexImage, glTexSubImage and glPixelStore (3.6.1, 3.8.1, 3.8.2).
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "scene/frame/parameter_rows.h"
#include "scene/state/pixel_unpacking.h"
#include "scene/state/state.h"

namespace twinlight {

namespace {

// The size of an image, from the argument at `at` on.
PixelSource size_at(const Command& c, std::size_t at) {
    const int dimensions = image_dimensions(c);
    PixelSource size{.width = static_cast<int>(c.number(at)), .is_volume = dimensions == 3};
    if (dimensions > 1) size.height = static_cast<int>(c.number(at + 1));
    if (dimensions > 2) size.depth = static_cast<int>(c.number(at + 2));
    return size;
}

double texel_count(const PixelSource& source) {
    return static_cast<double>(source.width) * source.height * source.depth;
}

std::string size_text(const PixelSource& source) {
    const std::string flat = fmt::format("{} x {}", source.width, source.height);
    return source.is_volume ? fmt::format("{} x {}", flat, source.depth) : flat;
}

// The arguments of glTexImage1D to glTexImage3D, by name.
struct ImageArguments {
    explicit ImageArguments(const Command& c) {
        target = c.enumerant(0);
        level = static_cast<int>(c.number(1));
        internal_format = without_compression(c.number(2));
        source = size_at(c, 3);
        const std::size_t border_at = 3 + static_cast<std::size_t>(image_dimensions(c));
        border = static_cast<int>(c.number(border_at));
        source.format = c.enumerant(border_at + 1);
        source.type = c.enumerant(border_at + 2);
        offset = c.number(border_at + 3);
    }
    Enum target = 0;
    int level = 0;
    double internal_format = 0;
    int border = 0;
    PixelSource source;
    double offset = 0;
};

}  // namespace

void State::pixel_store(const Command& c) {
    const Enum pname = c.enumerant(0);
    const auto values = parameter_values(c, Owner::kPixelStore, pname);
    if (!values) return;
    const int value = static_cast<int>(std::clamp(std::round(values->front()), -0x1p31, 0x1p31 - 1));
    const bool is_alignment = pname == kGL_UNPACK_ALIGNMENT || pname == kGL_PACK_ALIGNMENT;
    if (is_alignment && value != 1 && value != 2 && value != 4 && value != 8)
        return raise(kGL_INVALID_VALUE, c, "{} is {}; it must be 1, 2, 4 or 8", enum_name(pname), value);
    const std::array<double, 4> numbers{static_cast<double>(value)};
    set_parameter(pixel_store_, *find_parameter_row<PixelStore>(pname), numbers);
}

// 3.6.4: checks that the format and the type are known and can be used together.
bool State::check_pixel_type(const Command& c, const PixelSource& source) {
    const bool is_drawn = c.id == CommandId::glDrawPixels;
    const bool is_stencil = is_drawn && source.format == kGL_STENCIL_INDEX;
    if (source.type == kGL_BITMAP || source.format == kGL_COLOR_INDEX) {
        if (is_drawn)  // changes only this picture
            note_unsupported(fmt::format("glDrawPixels({})", enum_name(source.format)), c.place);
        else
            note_lasting(fmt::format("{} with {} and {}", c.name(), enum_name(source.format), enum_name(source.type)),
                         c.place);
        return false;
    }
    if (!is_stencil && !components_of(source.format)) {
        raise(kGL_INVALID_ENUM, c, "{} is given the format {}; expected GL_RGB, GL_RGBA, GL_LUMINANCE, ...", c.name(),
              enum_name(source.format));
        return false;
    }
    if (pixel_bytes(is_stencil ? Enum{kGL_RED} : source.format, source.type)) return true;
    const bool is_type = pixel_bytes(kGL_RGB, source.type) || pixel_bytes(kGL_RGBA, source.type);
    if (is_type)
        raise(kGL_INVALID_OPERATION, c, "the type {} cannot be used with the format {}", enum_name(source.type),
              enum_name(source.format));
    else
        raise(kGL_INVALID_ENUM, c, "{} is given the type {}; expected GL_UNSIGNED_BYTE, GL_FLOAT, ...", c.name(),
              enum_name(source.type));
    return false;
}

// 3.8.1, 3.8.2: only pixels of depths are for images of depths.
bool State::check_depths(const Command& c, Enum texture, Enum base_format, Enum pixels) {
    const bool are_depths = pixels == kGL_DEPTH_COMPONENT, has_depths = base_format == kGL_DEPTH_COMPONENT;
    if (are_depths != has_depths) {
        raise(kGL_INVALID_OPERATION, c, "{} puts pixels of {} into an image of {}", c.name(),
              are_depths ? tr("depths") : tr("colours"), has_depths ? tr("depths") : tr("colours"));
        return false;
    }
    // OpenGL 3.0 allows depths in cube maps, so drivers do.
    if (!has_depths || (texture != kGL_TEXTURE_3D && texture != kGL_TEXTURE_CUBE_MAP)) return true;
    raise(kGL_INVALID_OPERATION, c, "{} of depths; {} can only have colours", c.name(),
          texture == kGL_TEXTURE_3D ? tr("a texture of three dimensions") : tr("a cube map"));
    return false;
}

std::optional<std::span<const std::byte>> State::pixel_memory(const Command& c, std::size_t needed) {
    if (needed == 0) return std::span<const std::byte>();
    const BufferObject* buffer = lists_.nesting > 0 ? nullptr : arrays_.pixel_unpack_buffer();
    if (buffer && (c.memory || buffer->mapped)) {
        raise(kGL_INVALID_OPERATION, c, "{} reads the buffer that is bound to GL_PIXEL_UNPACK_BUFFER, {}", c.name(),
              c.memory ? tr("but is given an array; give an offset") : tr("which is mapped; call glUnmapBuffer first"));
        return std::nullopt;
    }
    const std::span<const std::byte> bytes = buffer     ? std::span(buffer->bytes)
                                             : c.memory ? std::span(c.memory->bytes)
                                                        : std::span<const std::byte>();
    const double offset = c.arguments.back();
    if (offset < 0 || offset > static_cast<double>(bytes.size()) ||
        needed > bytes.size() - static_cast<std::size_t>(offset)) {
        raise(kGL_INVALID_OPERATION, c,
              "{} reads {} bytes, but its array has {}; check GL_UNPACK_ALIGNMENT, which is {}", c.name(), needed,
              static_cast<double>(bytes.size()) - offset, pixel_store_.unpack_alignment);
        return std::nullopt;
    }
    return bytes.subspan(static_cast<std::size_t>(offset));
}

// RULING: a null pointer gives pixels of value 0; 3.8.1 leaves them undefined.
std::optional<PixelRows> State::pixels(const Command& c, const PixelSource& source) {
    const bool has_buffer = lists_.nesting == 0 && arrays_.pixel_unpack_buffer();
    if (!c.memory && !has_buffer) return PixelRows{source, pixel_store_, {}};
    const auto memory = pixel_memory(c, bytes_read(source, pixel_store_));
    if (!memory) return std::nullopt;
    return PixelRows{source, pixel_store_, *memory, a_.pixel_transfer, &pixel_maps_};
}

std::size_t texels_of(const Texture& texture) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < texture.face_count(); ++i)
        for (const TextureImage& image : texture.face(i)) count += image.texels.size();
    return count;
}

bool State::has_texels(const Command& c, double count, std::size_t replaced) {
    if (!has_time(c, count)) return false;
    if (static_cast<double>(textures_.texels - replaced) + count <= static_cast<double>(kMaxTexels)) return true;
    raise(kGL_OUT_OF_MEMORY, c, "{} adds {} texels; all textures together can have at most {}", c.name(), count,
          kMaxTexels);
    return false;
}

// Images of textures that only the driver supports.
bool is_driver_only_image(Enum target) {
    return target == kGL_TEXTURE_RECTANGLE || target == kGL_PROXY_TEXTURE_RECTANGLE;
}

std::optional<ImageTarget> image_target(Enum target) {
    if (target == kGL_TEXTURE_1D || target == kGL_TEXTURE_2D || target == kGL_TEXTURE_3D) return ImageTarget{target, 0};
    if (target < kGL_TEXTURE_CUBE_MAP_POSITIVE_X || target > kGL_TEXTURE_CUBE_MAP_NEGATIVE_Z) return std::nullopt;
    return ImageTarget{kGL_TEXTURE_CUBE_MAP, target - kGL_TEXTURE_CUBE_MAP_POSITIVE_X};
}

int image_dimensions(const Command& c) {
    const std::string_view name = c.sig().name;
    return name[name.find('D') - 1] - '0';
}

bool has_dimensions_of(const Command& c, Enum texture) {
    return image_dimensions(c) == (texture == kGL_TEXTURE_1D ? 1 : texture == kGL_TEXTURE_3D ? 3 : 2);
}

std::optional<ImageTarget> State::image_target(const Command& c, bool allows_proxy) {
    const Enum target = c.enumerant(0);
    const std::optional<ImageTarget> result = twinlight::image_target(target);
    if (result && has_dimensions_of(c, result->texture)) return result;
    constexpr std::pair<Enum, Enum> kProxies[] = {{kGL_PROXY_TEXTURE_1D, kGL_TEXTURE_1D},
                                                  {kGL_PROXY_TEXTURE_2D, kGL_TEXTURE_2D},
                                                  {kGL_PROXY_TEXTURE_3D, kGL_TEXTURE_3D},
                                                  {kGL_PROXY_TEXTURE_CUBE_MAP, kGL_TEXTURE_CUBE_MAP}};
    for (const auto& [proxy, texture] : kProxies)
        if (allows_proxy && target == proxy && has_dimensions_of(c, texture)) return ImageTarget{texture, 0};
    const Enum expected[] = {kGL_TEXTURE_1D, kGL_TEXTURE_2D, kGL_TEXTURE_3D};
    known(c, target, {expected[image_dimensions(c) - 1]});  // raises the error
    return std::nullopt;
}

void State::tex_image(const Command& c) {
    const ImageArguments a(c);
    const int dimensions = image_dimensions(c);
    if (dimensions == 2 && is_driver_only_image(a.target)) return;
    const std::optional<ImageTarget> target = image_target(c, true);
    if (!target) return;
    const PixelSource& source = a.source;
    const int levels_at_most = source.is_volume ? kMax3dTextureLevels : kMaxTextureLevels;
    if (a.level < 0 || a.level >= levels_at_most)
        return raise(kGL_INVALID_VALUE, c, "the level is {}; it must be in [0, {}]", a.level, levels_at_most - 1);
    if (a.border != 0 && a.border != 1)
        return raise(kGL_INVALID_VALUE, c, "the border is {}; it must be 0 or 1", a.border);
    const int largest = (source.is_volume ? kMax3dTextureSize : kMaxTextureSize) >> a.level;
    const int sides[] = {source.width, source.height, source.depth};
    for (const int side : std::span(sides).first(static_cast<std::size_t>(dimensions))) {
        if (side < 0 || side > largest + 2 * a.border || side < 2 * a.border) {
            return raise(kGL_INVALID_VALUE, c, "the image is {}; each side of level {} must be in [0, {}]",
                         size_text(source), a.level, largest);
        }
    }
    if (target->texture == kGL_TEXTURE_CUBE_MAP && source.width != source.height)
        return raise(kGL_INVALID_VALUE, c, "the image is {} x {}; those of a cube map must be square", source.width,
                     source.height);
    const std::optional<InternalFormat> format = internal_format(a.internal_format);
    if (!format) {
        return raise(kGL_INVALID_VALUE, c, "{} is given the internal format {}; expected 1 to 4, GL_RGB, GL_RGBA8, ...",
                     c.name(), enum_name(static_cast<Enum>(std::max(a.internal_format, 0.0))));
    }
    if (!check_pixel_type(c, source) || !check_depths(c, target->texture, format->base_format, source.format) ||
        !twinlight::image_target(a.target))
        return;
    const auto level = static_cast<std::size_t>(a.level);
    const std::vector<TextureImage>& bound = bound_texture(target->texture).face(target->face);
    const std::size_t replaced = level < bound.size() ? bound[level].texels.size() : 0;
    if (!has_texels(c, texel_count(source), replaced)) return;
    const auto rows = pixels(c, source);
    if (!rows) return;
    // RULING: borders are cut off, as in drivers, and the picture is reported as partial.
    if (a.border == 1) note_lasting(fmt::format("{} with a border", c.name()), c.place);
    const int dx = a.border, dy = dimensions > 1 ? a.border : 0, dz = dimensions > 2 ? a.border : 0;
    TextureImage image{.width = source.width - 2 * dx,
                       .height = source.height - 2 * dy,
                       .depth = source.depth - 2 * dz,
                       .base_format = format->base_format,
                       .internal_format = static_cast<Enum>(a.internal_format)};
    image.texels.reserve(image.index(0, 0, image.depth));
    std::vector<glm::dvec4> row;
    for (int z = 0; z < image.depth; ++z)
        for (int y = 0; y < image.height; ++y) {
            rows->unpack(y + dy, row, z + dz);
            for (int x = 0; x < image.width; ++x)
                image.texels.push_back(stored(row[static_cast<std::size_t>(x + dx)], *format));
        }
    Texture* texture = writable_texture(c, target->texture);
    if (!texture) return;
    textures_.texels -= texels_of(*texture);
    std::vector<TextureImage>& levels = texture->face(target->face);
    if (levels.size() <= level) levels.resize(level + 1);
    levels[level] = std::move(image);
    if (a.level == texture->base_level) generate_mipmaps(*texture, target->face);
    textures_.texels += texels_of(*texture);
}

void State::tex_sub_image(const Command& c) {
    const auto dimensions = static_cast<std::size_t>(image_dimensions(c));
    if (dimensions == 2 && is_driver_only_image(c.enumerant(0))) return;
    const std::optional<ImageTarget> target = image_target(c);
    if (!target) return;
    const auto whole = [&c](std::size_t i) { return static_cast<int>(c.number(i)); };
    const int level = whole(1), x0 = whole(2), y0 = dimensions > 1 ? whole(3) : 0, z0 = dimensions > 2 ? whole(4) : 0;
    PixelSource source = size_at(c, 2 + dimensions);
    source.format = c.enumerant(2 + 2 * dimensions);
    source.type = c.enumerant(3 + 2 * dimensions);
    const int levels_at_most = source.is_volume ? kMax3dTextureLevels : kMaxTextureLevels;
    if (level < 0 || level >= levels_at_most || source.width < 0 || source.height < 0 || source.depth < 0) {
        return raise(kGL_INVALID_VALUE, c,
                     "{} is given level {} and the size {}; the level must be in [0, {}], the size cannot be negative",
                     c.name(), level, size_text(source), levels_at_most - 1);
    }
    if (!check_pixel_type(c, source)) return;
    const Texture& bound = bound_texture(target->texture);
    const std::vector<TextureImage>& images = bound.face(target->face);
    if (images.size() <= static_cast<std::size_t>(level) || images[static_cast<std::size_t>(level)].texels.empty()) {
        return raise(kGL_INVALID_OPERATION, c, "level {} has no image yet; give it one with glTexImage{}D", level,
                     dimensions);
    }
    const TextureImage& old = images[static_cast<std::size_t>(level)];
    if (!check_depths(c, target->texture, old.base_format, source.format)) return;
    if (x0 < 0 || y0 < 0 || z0 < 0 || x0 > old.width - source.width || y0 > old.height - source.height ||
        z0 > old.depth - source.depth) {
        const PixelSource size{
            .width = old.width, .height = old.height, .depth = old.depth, .is_volume = source.is_volume};
        return raise(kGL_INVALID_VALUE, c, "{} texels at ({}, {}{}) are not inside the image of {}", size_text(source),
                     x0, y0, source.is_volume ? fmt::format(", {}", z0) : "", size_text(size));
    }
    const auto rows = pixels(c, source);
    if (!rows || texel_count(source) == 0) return;
    const bool is_base = level == bound.base_level;
    const bool mipmaps = is_base && bound.generate_mipmap;
    if (!has_time(c, static_cast<double>(mipmaps ? texels_of(bound) : 0) + texel_count(source))) return;
    Texture* texture = writable_texture(c, target->texture);
    if (!texture) return;
    textures_.texels -= texels_of(*texture);
    TextureImage& image = texture->face(target->face)[static_cast<std::size_t>(level)];
    const InternalFormat format = *internal_format(image.internal_format);
    std::vector<glm::dvec4> row;
    for (int z = 0; z < source.depth; ++z) {
        ImagePart part{.x = x0, .y = y0, .z = z0 + z, .width = source.width, .height = source.height};
        for (int y = 0; y < source.height; ++y) {
            rows->unpack(y, row, z);
            if (image.has_copies())
                for (const glm::dvec4& texel : row) part.texels.push_back(stored(texel, format));
            const std::size_t to = image.index(x0, y0 + y, z0 + z);
            for (std::size_t x = 0; x < row.size(); ++x) image.texels[to + x] = stored(row[x], format);
        }
        if (image.has_copies()) add_part(image, std::move(part));
    }
    if (is_base) generate_mipmaps(*texture, target->face);
    textures_.texels += texels_of(*texture);
}

// 3.8.8, "Automatic mipmap generation".
void State::generate_mipmaps(Texture& texture, std::size_t face) const {
    const auto base = static_cast<std::size_t>(texture.base_level);
    std::vector<TextureImage>& levels = texture.face(face);
    if (!texture.generate_mipmap || levels[base].texels.empty()) return;
    const InternalFormat format = *internal_format(levels[base].internal_format);
    levels.resize(base + 1);
    while (levels.back().is_halved() && levels.size() <= static_cast<std::size_t>(texture.max_level)) {
        TextureImage next = half(levels.back(), format);
        if (levels.back().has_copies()) next.half_of = std::make_shared<const TextureImage>(levels.back());
        levels.push_back(std::move(next));
    }
}

}  // namespace twinlight
