// glCopyTexImage and glCopyTexSubImage (3.8.2), and the pictures that textures have copies of.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "scene/state/pixel_unpacking.h"
#include "scene/state/state.h"

namespace twinlight {

namespace {

int copies_in_a_row(const TextureImage& image) {
    int depth = image.half_of ? copies_in_a_row(*image.half_of) : 0;
    for (const ImagePart& part : image.parts)
        if (part.copied) depth = std::max(depth, part.copied->depth);
    return depth;
}

CopiedBuffer buffer_for(Enum base_format) {
    return base_format == kGL_DEPTH_COMPONENT ? CopiedBuffer::kDepths : CopiedBuffer::kColors;
}

// Copies have no proxies.
bool is_driver_only_copy(Enum target) { return is_driver_only_image(target) && target != kGL_PROXY_TEXTURE_RECTANGLE; }

// sRGB, and formats of later versions.
bool is_driver_only_format(Enum format) {
    constexpr std::pair<Enum, Enum> kRanges[] = {{0x8C40, 0x8C4B}, {0x8814, 0x881B}};
    return std::ranges::any_of(kRanges,
                               [&](const auto& range) { return format >= range.first && format <= range.second; });
}

// The texels of the texture that the bound framebuffer object reads its colours from, if they are all known: if nothing was drawn or
// copied into it. nullopt if they are not, or if the rectangle reaches beyond them. `format`: of the image that gets them.
std::optional<std::vector<glm::vec4>> texels_to_copy(const Framebuffers& framebuffers, const TextureObjects& textures,
                                                     const Rectangle& from, const InternalFormat& format) {
    if (framebuffers.read == 0 || format.base_format == kGL_DEPTH_COMPONENT) return std::nullopt;
    const FramebufferObject& object = *framebuffers.named.at(framebuffers.read);
    const Attachment* attachment = object.color(object.read_buffer);
    if (!attachment || !attachment->is_whole_texture()) return std::nullopt;
    const TextureImage& image = textures.named.at(attachment->name)->face(0).at(0);
    const InternalFormat source = internal_format(image.internal_format).value_or(InternalFormat{});
    const bool is_exact = source.red == 8 && (source.base_format == kGL_RGB || source.base_format == kGL_RGBA);
    if (image.has_copies() || !is_exact || from.x < 0 || from.y < 0 || from.x > image.width - from.width ||
        from.y > image.height - from.height)
        return std::nullopt;
    std::vector<glm::vec4> texels;
    for (int y = 0; y < from.height; ++y)
        for (int x = 0; x < from.width; ++x)
            texels.push_back(stored(image.texels[image.index(from.x + x, from.y + y)], format));
    return texels;
}

}  // namespace

int copies_in_a_row(const FrameItems& items) {
    int depth = 0;
    const auto add = [&](std::size_t, const TextureUnit& unit) {
        for (std::size_t i = 0; i < unit.texture->face_count(); ++i)
            for (const TextureImage& image : unit.texture->face(i)) depth = std::max(depth, copies_in_a_row(image));
    };
    for (const FrameItem& item : items) {
        const Draw* draw = std::get_if<Draw>(&item);
        if (!draw) continue;
        draw->for_each_unit(add);
        if (draw->pixels && draw->pixels->copied) depth = std::max(depth, draw->pixels->copied->source.pixels->depth);
    }
    return depth;
}

void add_part(TextureImage& image, ImagePart part) {
    std::erase_if(image.parts, [&](const ImagePart& older) { return part.covers(older); });
    if (image.depth == 1 && part.covers({.width = image.width, .height = image.height})) image.half_of.reset();
    image.parts.push_back(std::move(part));
}

std::shared_ptr<const CopiedPixels> State::copied_pixels(const Command& c, CopiedBuffer buffer, const Rectangle& from,
                                                         double count) {
    if (!has_time(c, count + static_cast<double>(items_.size()))) return nullptr;
    std::shared_ptr<const ObjectPicture> drawn;
    if (framebuffers_.read != 0 && !(drawn = read_picture(c, buffer))) return nullptr;
    const int depth = drawn ? drawn->depth : 1 + (copies_pixels_ ? copies_in_a_row(items_) : 0);
    if (depth > kMostCopiesInARow) {
        note_lasting(fmt::format("{} of a picture that shows {} copies in a row", c.name(), kMostCopiesInARow),
                     c.place);
        return nullptr;
    }
    if (!has_room(c, sizeof items_[0] + static_cast<std::size_t>(count) * sizeof(glm::vec4))) return nullptr;
    copies_pixels_ = true;
    return std::make_shared<const CopiedPixels>(CopiedPixels{.buffer = buffer,
                                                             .width = from.width,
                                                             .height = from.height,
                                                             .depth = depth,
                                                             .drawn = std::move(drawn),
                                                             .x = from.x,
                                                             .y = from.y});
}

std::shared_ptr<const CopiedPixels> State::take_pixels(const Command& c, CopiedBuffer buffer, const Rectangle& from) {
    if (!a_.pixel_transfer.is_initial()) note_lasting(fmt::format("{} with glPixelTransfer", c.name()), c.place);
    auto pixels = copied_pixels(c, buffer, from, static_cast<double>(from.width) * from.height);
    if (pixels && !pixels->drawn) items_.emplace_back(TakePixels{pixels, from});
    return pixels;
}

void State::copy_tex_image(const Command& c) {
    const bool two = c.id == CommandId::glCopyTexImage2D;
    const bool is_driver_only = two && is_driver_only_copy(c.enumerant(0));
    const std::optional<ImageTarget> target = is_driver_only ? ImageTarget{} : image_target(c);
    if (!target) return;
    const auto whole = [&c](std::size_t i) { return static_cast<int>(c.number(i)); };
    const int level = whole(1), border = whole(two ? 7 : 6);
    Rectangle from{whole(3), whole(4), whole(5), two ? whole(6) : 1};
    const int largest = level >= 0 && level < kMaxTextureLevels ? kMaxTextureSize >> level : 0;
    const auto fits = [&](int side) { return side >= 2 * border && side <= largest + 2 * border; };
    const auto raise_size = [&] {
        raise(kGL_INVALID_VALUE, c,
              "{} cannot make level {} with {} x {} texels and a border of {}; each side of level 0 can have at "
              "most {}, and the border must be 0 or 1",
              c.name(), level, from.width, from.height, border, kMaxTextureSize);
    };
    if (largest == 0 || (border != 0 && border != 1)) return raise_size();
    const double internal = without_compression(c.number(2));
    const std::optional<InternalFormat> format = internal_format(internal);
    const bool is_unsupported = is_driver_only_format(c.enumerant(2));
    if (!is_unsupported && (!format || c.number(2) <= 4)) {
        return raise(kGL_INVALID_ENUM, c, "{} is given the internal format {}; expected GL_RGB, GL_RGBA8, ...",
                     c.name(), enum_name(c.enumerant(2)));
    }
    if (!fits(from.width) || (two && !fits(from.height))) return raise_size();
    if (target->texture == kGL_TEXTURE_CUBE_MAP && from.width != from.height)
        return raise(kGL_INVALID_VALUE, c, "the image is {} x {}; those of a cube map must be square", from.width,
                     from.height);
    if (is_unsupported) return note_lasting(fmt::format("{}({})", c.name(), enum_name(c.enumerant(2))), c.place);
    if (is_driver_only) return note_lasting(c.name(), c.place);
    if (!check_depths(c, target->texture, format->base_format, format->base_format)) return;
    // RULING: borders are cut off, as by glTexImage.
    if (border == 1) note_lasting(fmt::format("{} with a border", c.name()), c.place);
    from = {from.x + border, from.y + (two ? border : 0), from.width - 2 * border,
            from.height - (two ? 2 * border : 0)};
    const auto index = static_cast<std::size_t>(level);
    const std::vector<TextureImage>& bound = bound_texture(target->texture).face(target->face);
    const std::size_t replaced = index < bound.size() ? bound[index].texels.size() : 0;
    const auto count = static_cast<std::size_t>(from.width) * static_cast<std::size_t>(from.height);
    if (!has_texels(c, static_cast<double>(count), replaced)) return;
    TextureImage image{.width = from.width,
                       .height = from.height,
                       .base_format = format->base_format,
                       .internal_format = static_cast<Enum>(internal),
                       .texels = std::vector<glm::vec4>(count, stored({0, 0, 0, 1}, *format))};
    if (count > 0) {
        const std::size_t errors = error_count_;
        if (auto texels = texels_to_copy(framebuffers_, textures_, from, *format)) {
            if (has_time(c, static_cast<double>(texels->size()))) image.texels = std::move(*texels);
        } else if (auto pixels = take_pixels(c, buffer_for(format->base_format), from)) {
            image.parts.push_back({.width = from.width, .height = from.height, .copied = std::move(pixels)});
        }
        if (error_count_ > errors) return;
    }
    Texture* texture = writable_texture(c, target->texture);
    if (!texture) return;
    textures_.texels -= texels_of(*texture);
    std::vector<TextureImage>& levels = texture->face(target->face);
    if (levels.size() <= index) levels.resize(index + 1);
    levels[index] = std::move(image);
    if (level == texture->base_level) generate_mipmaps(*texture, target->face);
    textures_.texels += texels_of(*texture);
}

void State::copy_tex_sub_image(const Command& c) {
    const auto dimensions = static_cast<std::size_t>(image_dimensions(c));
    const bool is_flat = dimensions == 1, is_volume = dimensions == 3;
    const bool is_driver_only = dimensions == 2 && is_driver_only_copy(c.enumerant(0));
    const std::optional<ImageTarget> target = is_driver_only ? ImageTarget{} : image_target(c);
    if (!target) return;
    const auto whole = [&c](std::size_t i) { return static_cast<int>(c.number(i)); };
    const int level = whole(1), x0 = whole(2), y0 = is_flat ? 0 : whole(3), z0 = is_volume ? whole(4) : 0;
    const std::size_t at = 2 + dimensions;
    const Rectangle from{whole(at), whole(at + 1), whole(at + 2), is_flat ? 1 : whole(at + 3)};
    const int levels_at_most = is_volume ? kMax3dTextureLevels : kMaxTextureLevels;
    if (level < 0 || level >= levels_at_most)
        return raise(kGL_INVALID_VALUE, c, "the level is {}; it must be in [0, {}]", level, levels_at_most - 1);
    if (is_driver_only) return note_lasting(c.name(), c.place);
    const auto index = static_cast<std::size_t>(level);
    const Texture& bound = bound_texture(target->texture);
    const std::vector<TextureImage>& images = bound.face(target->face);
    if (images.size() <= index || images[index].texels.empty()) {
        return raise(kGL_INVALID_OPERATION, c, "level {} has no image yet; give it one with glTexImage{}D", level,
                     dimensions);
    }
    if (from.width < 0 || from.height < 0)
        return raise(kGL_INVALID_VALUE, c, "{} is given the size {} x {}; it cannot be negative", c.name(), from.width,
                     from.height);
    const TextureImage& old = images[index];
    if (z0 < 0 || z0 >= old.depth)
        return raise(kGL_INVALID_VALUE, c, "the image has {} layers, not a layer {}", old.depth, z0);
    if (x0 < 0 || y0 < 0 || x0 > old.width - from.width || y0 > old.height - from.height) {
        return raise(kGL_INVALID_VALUE, c, "{} x {} texels at ({}, {}) are not inside the image of {} x {}", from.width,
                     from.height, x0, y0, old.width, old.height);
    }
    if (from.width == 0 || from.height == 0) return;
    const bool is_base = level == bound.base_level;
    if (is_base && bound.generate_mipmap && !has_time(c, static_cast<double>(texels_of(bound)))) return;
    Texture* texture = writable_texture(c, target->texture);
    if (!texture) return;
    TextureImage& image = texture->face(target->face)[index];
    ImagePart part{.x = x0, .y = y0, .z = z0, .width = from.width, .height = from.height};
    if (auto texels = texels_to_copy(framebuffers_, textures_, from, *internal_format(image.internal_format))) {
        if (!has_time(c, static_cast<double>(texels->size()))) return;
        part.texels = std::move(*texels);
    } else if (!(part.copied = take_pixels(c, buffer_for(image.base_format), from))) {
        return;
    }
    textures_.texels -= texels_of(*texture);
    for (std::size_t i = 0; i < part.texels.size(); ++i) {
        const std::size_t row = i / static_cast<std::size_t>(from.width);
        image.texels[image.index(x0, y0 + static_cast<int>(row), z0) + i % static_cast<std::size_t>(from.width)] =
            part.texels[i];
    }
    if (part.copied || image.has_copies()) add_part(image, std::move(part));
    if (is_base) generate_mipmaps(*texture, target->face);
    textures_.texels += texels_of(*texture);
}

// ---- Earlier pictures ----

void State::keep_for_copies(std::size_t count) {
    if (!copies_pixels_) return;
    const auto end = items_.begin() + static_cast<std::ptrdiff_t>(count);
    KeptPicture kept;
    FrameItems dropped(std::make_move_iterator(items_.begin()), std::make_move_iterator(end));
    // The last copy that a texture still has, and what came before it.
    const auto is_kept = [](const FrameItem& item) {
        const TakePixels* copy = std::get_if<TakePixels>(&item);
        return copy && copy->pixels.use_count() > 1;
    };
    while (!dropped.empty() && !is_kept(dropped.back())) dropped.pop_back();
    if (!dropped.empty()) {
        kept.bytes = bytes_of(dropped);
        for (const FrameItem& item : dropped)
            if (const TakePixels* copy = std::get_if<TakePixels>(&item)) kept.copies.emplace_back(copy->pixels);
        kept.items = std::make_shared<const FrameItems>(std::move(dropped));
        kept_pictures_.push_back(std::move(kept));
    }
    // An older picture may only be kept for the draws of a newer one.
    for (std::size_t i = kept_pictures_.size(); i-- > 0;) {
        const bool is_copied =
            std::ranges::any_of(kept_pictures_[i].copies, [](const auto& copy) { return copy.use_count() > 1; });
        if (!is_copied) kept_pictures_.erase(kept_pictures_.begin() + static_cast<std::ptrdiff_t>(i));
    }
}

}  // namespace twinlight
