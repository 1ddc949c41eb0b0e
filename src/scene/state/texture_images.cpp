// glTexImage, glTexSubImage and glPixelStore (3.6.1, 3.8.1, 3.8.2).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/state/pixel_unpacking.h"
#include "scene/state/state.h"

namespace twinlight {

namespace {

// The arguments of glTexImage1D and glTexImage2D, by name.
struct ImageArguments {
    explicit ImageArguments(const Command& c) {
        const bool two = c.id == CommandId::glTexImage2D;
        target = c.enumerant(0);
        level = static_cast<int>(c.number(1));
        internal_format = c.number(2);
        source.width = static_cast<int>(c.number(3));
        source.height = two ? static_cast<int>(c.number(4)) : 1;
        const std::size_t border_at = two ? 5 : 4;
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
    for (const PixelStoreRow& row : kPixelStoreRows) {
        if (row.pname != pname) continue;
        std::visit([&]<class T>(T PixelStore::*at) { pixel_store_.*at = static_cast<T>(value); }, row.member);
    }
}

// 3.6.4: checks that the format and the type are known and can be used together.
bool State::check_pixel_type(const Command& c, const PixelSource& source) {
    const bool is_drawn = c.id == CommandId::glDrawPixels;
    if (source.type == kGL_BITMAP || source.format == kGL_COLOR_INDEX ||
        (source.format == kGL_DEPTH_COMPONENT && is_drawn)) {
        if (is_drawn)  // changes only this picture
            note_unsupported(fmt::format("glDrawPixels({})", enum_name(source.format)), c.place);
        else
            note_lasting(fmt::format("{} with {} and {}", c.name(), enum_name(source.format), enum_name(source.type)),
                         c.place);
        return false;
    }
    if (!components_of(source.format)) {
        raise(kGL_INVALID_ENUM, c, "{} is given the format {}; expected GL_RGB, GL_RGBA, GL_LUMINANCE, ...", c.name(),
              enum_name(source.format));
        return false;
    }
    if (pixel_bytes(source.format, source.type)) return true;
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
              are_depths ? "depths" : "colours", has_depths ? "depths" : "colours");
        return false;
    }
    if (!has_depths || texture != kGL_TEXTURE_CUBE_MAP) return true;
    note_lasting(fmt::format("{} of depths for a cube map", c.name()), c.place);  // GL 3.0
    return false;
}

std::optional<std::span<const std::byte>> State::pixel_memory(const Command& c, std::size_t needed) {
    if (needed == 0) return std::span<const std::byte>();
    const BufferObject* buffer = lists_.nesting > 0 ? nullptr : arrays_.pixel_unpack_buffer();
    if (buffer && (c.memory || buffer->mapped)) {
        raise(kGL_INVALID_OPERATION, c, "{} reads the buffer that is bound to GL_PIXEL_UNPACK_BUFFER, {}", c.name(),
              c.memory ? "but is given an array; give an offset" : "which is mapped; call glUnmapBuffer first");
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
    if (target == kGL_TEXTURE_1D || target == kGL_TEXTURE_2D) return ImageTarget{target, 0};
    if (target < kGL_TEXTURE_CUBE_MAP_POSITIVE_X || target > kGL_TEXTURE_CUBE_MAP_NEGATIVE_Z) return std::nullopt;
    return ImageTarget{kGL_TEXTURE_CUBE_MAP, target - kGL_TEXTURE_CUBE_MAP_POSITIVE_X};
}

std::optional<ImageTarget> State::image_target(const Command& c, bool two, bool allows_proxy) {
    const Enum target = c.enumerant(0);
    const std::optional<ImageTarget> result = twinlight::image_target(target);
    if (result && two != (target == kGL_TEXTURE_1D)) return result;
    if (allows_proxy && two && target == kGL_PROXY_TEXTURE_CUBE_MAP) return ImageTarget{kGL_TEXTURE_CUBE_MAP, 0};
    const Enum flat = two ? kGL_TEXTURE_2D : kGL_TEXTURE_1D, proxy = two ? kGL_PROXY_TEXTURE_2D : kGL_PROXY_TEXTURE_1D;
    if (allows_proxy && target == proxy) return ImageTarget{flat, 0};
    known(c, target, {flat});  // raises the error
    return std::nullopt;
}

void State::tex_image(const Command& c) {
    const ImageArguments a(c);
    const bool two = c.id == CommandId::glTexImage2D;
    if (two && is_driver_only_image(a.target)) return;
    const std::optional<ImageTarget> target = image_target(c, two, true);
    if (!target) return;
    const PixelSource& source = a.source;
    if (a.level < 0 || a.level >= kMaxTextureLevels)
        return raise(kGL_INVALID_VALUE, c, "the level is {}; it must be in [0, {}]", a.level, kMaxTextureLevels - 1);
    if (a.border != 0 && a.border != 1)
        return raise(kGL_INVALID_VALUE, c, "the border is {}; it must be 0 or 1", a.border);
    const int largest = kMaxTextureSize >> a.level;
    for (int side : two ? std::vector<int>{source.width, source.height} : std::vector<int>{source.width}) {
        if (side < 0 || side > largest + 2 * a.border || side < 2 * a.border) {
            return raise(kGL_INVALID_VALUE, c, "the image is {} x {}; each side of level {} must be in [0, {}]",
                         source.width, source.height, a.level, largest);
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
    if (!has_texels(c, static_cast<double>(source.width) * source.height, replaced)) return;
    const auto rows = pixels(c, source);
    if (!rows) return;
    // RULING: borders are cut off, as in drivers, and the picture is reported as partial.
    if (a.border == 1) note_lasting(fmt::format("{} with a border", c.name()), c.place);
    const int dx = a.border, dy = two ? a.border : 0;
    TextureImage image{
        source.width - 2 * dx, source.height - 2 * dy, format->base_format, static_cast<Enum>(a.internal_format), {}};
    image.texels.reserve(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
    std::vector<glm::dvec4> row;
    for (int y = 0; y < image.height; ++y) {
        rows->unpack(y + dy, row);
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
    const bool two = c.id == CommandId::glTexSubImage2D;
    if (two && is_driver_only_image(c.enumerant(0))) return;
    const std::optional<ImageTarget> target = image_target(c, two);
    if (!target) return;
    const auto whole = [&c](std::size_t i) { return static_cast<int>(c.number(i)); };
    const int level = whole(1), x0 = whole(2), y0 = two ? whole(3) : 0;
    const PixelSource source{.width = whole(two ? 4 : 3),
                             .height = two ? whole(5) : 1,
                             .format = c.enumerant(two ? 6 : 4),
                             .type = c.enumerant(two ? 7 : 5)};
    if (level < 0 || level >= kMaxTextureLevels || source.width < 0 || source.height < 0) {
        return raise(
            kGL_INVALID_VALUE, c,
            "{} is given level {} and the size {} x {}; the level must be in [0, {}], the size cannot be negative",
            c.name(), level, source.width, source.height, kMaxTextureLevels - 1);
    }
    if (!check_pixel_type(c, source)) return;
    const Texture& bound = bound_texture(target->texture);
    const std::vector<TextureImage>& images = bound.face(target->face);
    if (images.size() <= static_cast<std::size_t>(level) || images[static_cast<std::size_t>(level)].texels.empty()) {
        return raise(kGL_INVALID_OPERATION, c, "level {} has no image yet; give it one with {}", level,
                     two ? "glTexImage2D" : "glTexImage1D");
    }
    const TextureImage& old = images[static_cast<std::size_t>(level)];
    if (!check_depths(c, target->texture, old.base_format, source.format)) return;
    if (x0 < 0 || y0 < 0 || x0 > old.width - source.width || y0 > old.height - source.height) {
        return raise(kGL_INVALID_VALUE, c, "{} x {} texels at ({}, {}) are not inside the image of {} x {}",
                     source.width, source.height, x0, y0, old.width, old.height);
    }
    const auto rows = pixels(c, source);
    if (!rows || source.width == 0 || source.height == 0) return;
    const bool is_base = level == bound.base_level;
    const bool mipmaps = is_base && bound.generate_mipmap;
    if (!has_time(
            c, static_cast<double>(mipmaps ? texels_of(bound) : 0) + static_cast<double>(source.width) * source.height))
        return;
    Texture* texture = writable_texture(c, target->texture);
    if (!texture) return;
    textures_.texels -= texels_of(*texture);
    TextureImage& image = texture->face(target->face)[static_cast<std::size_t>(level)];
    const InternalFormat format = *internal_format(image.internal_format);
    std::vector<glm::dvec4> row;
    ImagePart part{.x = x0, .y = y0, .width = source.width, .height = source.height};
    for (int y = 0; y < source.height; ++y) {
        rows->unpack(y, row);
        if (image.has_copies())
            for (const glm::dvec4& texel : row) part.texels.push_back(stored(texel, format));
        const auto to =
            static_cast<std::size_t>(y0 + y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x0);
        for (std::size_t x = 0; x < row.size(); ++x) image.texels[to + x] = stored(row[x], format);
    }
    if (image.has_copies()) add_part(image, std::move(part));
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
    while ((levels.back().width > 1 || levels.back().height > 1) &&
           levels.size() <= static_cast<std::size_t>(texture.max_level)) {
        TextureImage next = half(levels.back(), format);
        if (levels.back().has_copies()) next.half_of = std::make_shared<const TextureImage>(levels.back());
        levels.push_back(std::move(next));
    }
}

}  // namespace twinlight
