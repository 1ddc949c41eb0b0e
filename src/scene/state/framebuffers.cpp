// Framebuffer objects: names, attachments, completeness, and the pictures that are drawn into them.
#include "scene/state/framebuffers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <utility>

#include "scene/command/command_set.h"
#include "scene/state/state.h"

namespace twinlight {

namespace {

constexpr std::initializer_list<Enum> kFramebufferTargets{kGL_FRAMEBUFFER, kGL_DRAW_FRAMEBUFFER, kGL_READ_FRAMEBUFFER};
constexpr CommandSet kDraws = kDrawCommands | CommandSet::of({"clear"});
constexpr CommandSet kReads = CommandSet::of({"copy_tex_image", "copy_tex_sub_image", "copy_pixels"});
// The commands that may need the picture so far in the object's images, or change what is drawn into.
constexpr CommandSet kEndsPicture = CommandSet::of(
    {"bind_framebuffer", "delete_framebuffers", "framebuffer_texture", "framebuffer_renderbuffer",
     "renderbuffer_storage", "delete_renderbuffers", "draw_buffer", "tex_image", "tex_sub_image", "copy_tex_image",
     "copy_tex_sub_image", "copy_pixels", "build_mipmaps", "texture_file", "generate_mipmap", "delete_textures"});

bool is_packed(Enum format) { return format == kGL_DEPTH_STENCIL || format == kGL_DEPTH24_STENCIL8; }
bool has_depths(Enum format) {
    const std::optional<InternalFormat> known = internal_format(format);
    return is_packed(format) || (known && known->base_format == kGL_DEPTH_COMPONENT);
}
bool has_stencil(Enum format) {
    return is_packed(format) || format == kGL_STENCIL_INDEX ||
           (format >= kGL_STENCIL_INDEX1 && format <= kGL_STENCIL_INDEX16);
}
bool has_colors(Enum format) { return !has_depths(format) && !has_stencil(format); }

// Formats of later versions that drivers have.
bool is_driver_only_storage(Enum format) {
    const auto is_in = [format](Enum first, Enum last) { return format >= first && format <= last; };
    return is_in(0x8814, 0x881B) || is_in(0x8C40, 0x8C43) || is_in(0x8CAC, 0x8CAD) || is_in(0x8227, 0x823C) ||
           is_in(0x8D70, 0x8D8E) || is_in(0x8D62, 0x8D62) || is_in(0x8C3A, 0x8C3D) || is_in(0x8F94, 0x8F9B);
}

// Whether the renderers' pictures, with 8 bits for each colour, show what the image would: with or without alpha.
bool is_drawn_exactly(Enum internal) {
    const std::optional<InternalFormat> format = internal_format(internal);
    if (!format) return false;
    const bool has_three = format->red == 8 && format->green == 8 && format->blue == 8;
    return has_three && (format->base_format == kGL_RGB || (format->base_format == kGL_RGBA && format->alpha == 8));
}
bool has_alpha(Enum internal) { return internal_format(internal)->base_format == kGL_RGBA; }

constexpr std::uint32_t kIncomplete = 0;        // the name of a deleted image that could not be drawn into
constexpr int kAnySize = kMaxRenderbufferSize;  // of an image that is not known

// What a target of framebuffer commands means (OpenGL 3.0, section 4.4.1): GL_FRAMEBUFFER is the one for drawing.
std::uint32_t bound_to(const Framebuffers& framebuffers, Enum target) {
    return target == kGL_READ_FRAMEBUFFER ? framebuffers.read : framebuffers.draw;
}

std::string size_text(int width, int height) { return fmt::format("{} x {}", width, height); }

}  // namespace

// ---- Names ----

void State::gen_framebuffers(const Command& c) {
    if (!counts(c, "framebuffers")) return;
    for (double name : c.array()) framebuffers_.named.try_emplace(static_cast<std::uint32_t>(name));
}

void State::gen_renderbuffers(const Command& c) {
    if (!counts(c, "renderbuffers")) return;
    for (double name : c.array()) framebuffers_.renderbuffers.try_emplace(static_cast<std::uint32_t>(name));
}

// RULING: names that were never generated create an object, as in EXT_framebuffer_object. OpenGL 3.0 has GL_INVALID_OPERATION.
void State::bind_framebuffer(const Command& c) {
    const Enum target = c.enumerant(0);
    if (!known(c, target, kFramebufferTargets)) return;
    const std::uint32_t name = c.enumerant(1);
    if (name != 0 && !framebuffers_.named[name]) framebuffers_.named[name].emplace();
    if (target != kGL_READ_FRAMEBUFFER) framebuffers_.draw = name;
    if (target != kGL_DRAW_FRAMEBUFFER) framebuffers_.read = name;
}

void State::bind_renderbuffer(const Command& c) {
    if (!known(c, c.enumerant(0), {kGL_RENDERBUFFER})) return;
    const std::uint32_t name = framebuffers_.renderbuffer = c.enumerant(1);
    if (name != 0 && !framebuffers_.renderbuffers[name]) framebuffers_.renderbuffers[name].emplace();
}

// Deleted framebuffers are unbound; 0 and unused names are ignored.
void State::delete_framebuffers(const Command& c) {
    if (!counts(c, "framebuffers")) return;
    for (double value : c.array()) {
        const auto name = static_cast<std::uint32_t>(value);
        framebuffers_.named.erase(name);
        for (std::uint32_t* bound : {&framebuffers_.draw, &framebuffers_.read})
            if (*bound == name) *bound = 0;
    }
}

void State::delete_renderbuffers(const Command& c) {
    if (!counts(c, "renderbuffers")) return;
    for (double value : c.array()) {
        const auto name = static_cast<std::uint32_t>(value);
        if (name == 0 || !framebuffers_.renderbuffers.contains(name)) continue;
        detach(kGL_RENDERBUFFER, name);
        framebuffers_.renderbuffers.erase(name);
        if (framebuffers_.renderbuffer == name) framebuffers_.renderbuffer = 0;
    }
}

// A deleted image leaves the bound objects. Others keep it.
void State::detach(Enum type, std::uint32_t name) {
    for (auto& [number, named] : framebuffers_.named) {
        if (!named) continue;
        FramebufferObject& object = *named;
        const bool is_bound = number == framebuffers_.draw || number == framebuffers_.read;
        object.for_each([&](Attachment& attachment) {
            if (attachment.type != type || attachment.name != name || attachment.is_deleted) return;
            const std::optional<AttachedImage> image = attached_image(attachment);
            const auto is_right = &attachment == &object.depth     ? has_depths
                                  : &attachment == &object.stencil ? has_stencil
                                                                   : has_colors;
            if (!image || !is_right(image->format)) attachment.name = kIncomplete;
            attachment.is_deleted = true;
            if (is_bound) attachment = {};
        });
    }
}

// ---- Images ----

void State::renderbuffer_storage(const Command& c) {
    if (!known(c, c.enumerant(0), {kGL_RENDERBUFFER})) return;
    if (framebuffers_.renderbuffer == 0)
        return raise(kGL_INVALID_OPERATION, c, "{}: no renderbuffer is bound; call glBindRenderbuffer first", c.name());
    const Enum format = c.enumerant(1);
    const bool is_color = c.number(1) > 4 && internal_format(format) && !has_depths(format);
    if (!is_color && !has_depths(format) && !has_stencil(format) && !is_driver_only_storage(format))
        return raise(kGL_INVALID_ENUM, c,
                     "{} is given the format {}; expected GL_DEPTH_COMPONENT24, GL_DEPTH24_STENCIL8, GL_RGBA8, ...",
                     c.name(), enum_name(format));
    const int width = static_cast<int>(c.number(2)), height = static_cast<int>(c.number(3));
    if (std::min(width, height) < 0 || std::max(width, height) > kMaxRenderbufferSize)
        return raise(kGL_INVALID_VALUE, c, "{} is given the size {}; each side must be in [0, {}]", c.name(),
                     size_text(width, height), kMaxRenderbufferSize);
    if (!has_time(c, static_cast<double>(width) * height)) return;
    *framebuffers_.renderbuffers.at(framebuffers_.renderbuffer) = {format, width, height};
}

// The attachments that a command changes: two for GL_DEPTH_STENCIL_ATTACHMENT. Raises the error and returns none if it is wrong.
std::vector<Attachment*> State::attachments(const Command& c) {
    const Enum target = c.enumerant(0), attachment = c.enumerant(1);
    const std::uint32_t name = bound_to(framebuffers_, target);
    if (name == 0) {
        raise(kGL_INVALID_OPERATION, c, "{}: no framebuffer object is bound; call glBindFramebuffer first", c.name());
        return {};
    }
    FramebufferObject& object = *framebuffers_.named.at(name);
    if (attachment == kGL_DEPTH_ATTACHMENT) return {&object.depth};
    if (attachment == kGL_STENCIL_ATTACHMENT) return {&object.stencil};
    if (attachment == kGL_DEPTH_STENCIL_ATTACHMENT) return {&object.depth, &object.stencil};
    const Enum number = attachment - kGL_COLOR_ATTACHMENT0;
    if (number < kMaxColorAttachments) return {&object.colors[number]};
    raise(number <= kGL_COLOR_ATTACHMENT15 - kGL_COLOR_ATTACHMENT0 ? kGL_INVALID_OPERATION : kGL_INVALID_ENUM, c,
          "{} is given {}; expected GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT or GL_STENCIL_ATTACHMENT", c.name(),
          enum_name(attachment));
    return {};
}

void State::framebuffer_texture(const Command& c) {
    if (!known(c, c.enumerant(0), kFramebufferTargets)) return;
    const Enum target = c.enumerant(2);
    const std::uint32_t name = c.enumerant(3);
    Attachment attachment;
    bool is_drawable = true;
    if (name != 0) {
        const auto texture = textures_.named.find(name);
        if (texture == textures_.named.end() || !texture->second)
            return raise(kGL_INVALID_OPERATION, c, "there is no texture {}; bind it first", name);
        const std::optional<ImageTarget> image = twinlight::image_target(target);
        const bool is_driver_only = is_driver_only_image(target);
        if (!image && !is_driver_only) {
            known(c, target, {kGL_TEXTURE_2D});
            return;
        }
        if (!is_driver_only && (texture->second->target != image->texture || !has_dimensions_of(c, image->texture)))
            return raise(kGL_INVALID_OPERATION, c, "texture {} is a {}, not a {}", name,
                         enum_name(texture->second->target), enum_name(target));
        const double level = c.number(4);
        if (level < 0 || level >= kMaxTextureLevels)
            return raise(kGL_INVALID_VALUE, c, "the level is {}; it must be in [0, {}]", level, kMaxTextureLevels - 1);
        attachment = {.type = kGL_TEXTURE,
                      .name = name,
                      .face = is_driver_only ? 0 : image->face,
                      .level = static_cast<std::size_t>(level)};
        is_drawable = !is_driver_only && image->texture == kGL_TEXTURE_2D && level == 0;
    }
    const std::vector<Attachment*> changed = attachments(c);
    if (!changed.empty() && !is_drawable)
        note_lasting(fmt::format("{} with {} of level {}", c.name(), enum_name(target), attachment.level), c.place);
    for (Attachment* one : changed) *one = attachment;
}

void State::framebuffer_renderbuffer(const Command& c) {
    if (!known(c, c.enumerant(0), kFramebufferTargets) || !known(c, c.enumerant(2), {kGL_RENDERBUFFER})) return;
    const std::uint32_t name = c.enumerant(3);
    const auto found = framebuffers_.renderbuffers.find(name);
    if (name != 0 && (found == framebuffers_.renderbuffers.end() || !found->second))
        return raise(kGL_INVALID_OPERATION, c, "there is no renderbuffer {}; bind it first", name);
    for (Attachment* one : attachments(c))
        *one = name == 0 ? Attachment{} : Attachment{.type = kGL_RENDERBUFFER, .name = name};
}

std::optional<State::AttachedImage> State::attached_image(const Attachment& attachment) const {
    if (attachment.is_deleted && attachment.name == kIncomplete) return std::nullopt;
    if (attachment.is_deleted) return AttachedImage{kAnySize, kAnySize, 0};
    if (attachment.type == kGL_RENDERBUFFER) {
        const Renderbuffer& buffer = *framebuffers_.renderbuffers.at(attachment.name);
        if (buffer.width == 0 || buffer.height == 0) return std::nullopt;
        return AttachedImage{buffer.width, buffer.height, buffer.internal_format};
    }
    const std::vector<TextureImage>& levels = textures_.named.at(attachment.name)->face(attachment.face);
    if (attachment.level >= levels.size() || levels[attachment.level].texels.empty()) return std::nullopt;
    const TextureImage& image = levels[attachment.level];
    return AttachedImage{image.width, image.height, image.internal_format};
}

// OpenGL 3.0, section 4.4.4. RULING: as in OpenGL 4.1 a buffer to draw to or to read may lack an image; and the depths and the
// stencil must be one image, which the section leaves to the implementation, as in Mesa.
Enum State::status_of(const FramebufferObject& object) const {
    bool has_any = false, is_wrong = false;
    const auto check = [&](const Attachment& attachment, bool (*is_right)(Enum)) {
        if (attachment.type == kGL_NONE) return;
        has_any = true;
        const std::optional<AttachedImage> image = attached_image(attachment);
        is_wrong = is_wrong || !image || (!attachment.is_deleted && !is_right(image->format));
    };
    for (const Attachment& color : object.colors) check(color, has_colors);
    check(object.depth, has_depths);
    check(object.stencil, has_stencil);
    if (is_wrong) return kGL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT;
    if (!has_any) return kGL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT;
    const bool has_both = object.depth.type != kGL_NONE && object.stencil.type != kGL_NONE;
    if (has_both && object.depth != object.stencil) return kGL_FRAMEBUFFER_UNSUPPORTED;
    return kGL_FRAMEBUFFER_COMPLETE;
}

Enum State::framebuffer_status(Enum target) const {
    const std::uint32_t name = bound_to(framebuffers_, target);
    return name == 0 ? kGL_FRAMEBUFFER_COMPLETE : status_of(*framebuffers_.named.at(name));
}

// ---- Drawing ----

bool State::draws_color() const {
    if (framebuffers_.draw == 0) return a_.draws_color;
    return framebuffers_.drawn().color(framebuffers_.drawn().draw_buffer) != nullptr;
}

// Called before each command. Ends the picture of an object, or prepares for drawing into it. Returns false if the command is an
// error.
bool State::use_framebuffers(const Command& c) {
    if (object_ && kEndsPicture.contains(c.id)) end_object_picture(c);
    const bool draws = framebuffers_.draw != 0 && kDraws.contains(c.id);
    const bool reads = framebuffers_.read != 0 && kReads.contains(c.id);
    if (!draws && !reads) return true;
    for (const auto& [is_used, name] : {std::pair(draws, framebuffers_.draw), {reads, framebuffers_.read}}) {
        const Enum status = is_used ? status_of(*framebuffers_.named.at(name)) : kGL_FRAMEBUFFER_COMPLETE;
        if (status == kGL_FRAMEBUFFER_COMPLETE) continue;
        raise(kGL_INVALID_FRAMEBUFFER_OPERATION, c,
              "the bound framebuffer object is not complete: glCheckFramebufferStatus returns {}", enum_name(status));
        return false;
    }
    return !draws || object_ || begin_object_picture(c);
}

// What an attached image shows, if it is exactly one picture.
std::shared_ptr<const ObjectPicture> State::whole_picture(const Attachment& attachment, CopiedBuffer buffer) const {
    if (attachment.type == kGL_RENDERBUFFER && !attachment.is_deleted)
        return framebuffers_.renderbuffers.at(attachment.name)->drawn;
    if (!attachment.is_whole_texture()) return nullptr;
    const TextureImage& image = textures_.named.at(attachment.name)->levels.front();
    if (image.parts.size() != 1 || !image.parts.front().copied) return nullptr;
    const CopiedPixels& copy = *image.parts.front().copied;
    const bool is_whole = copy.drawn && copy.buffer == buffer && copy.x == 0 && copy.y == 0 &&
                          copy.width == image.width && copy.height == image.height &&
                          copy.drawn->width == image.width && copy.drawn->height == image.height;
    return is_whole ? copy.drawn : nullptr;
}

namespace {

// A rectangle that gives a picture the colours of a texture, texel by texel.
Draw image_draw(std::shared_ptr<const Texture> texture, int width, int height, const Place& place) {
    const TextureImage& image = texture->levels.front();
    const double s = static_cast<double>(width) / image.width, t = static_cast<double>(height) / image.height;
    Draw draw;
    draw.mode = kGL_TRIANGLE_STRIP;
    draw.place = place;
    draw.raster.viewport = {0, 0, width, height};
    draw.raster.depth_mask = false;
    draw.texture.texture = std::move(texture);
    draw.texture.env_mode = kGL_REPLACE;
    for (const double y : {0.0, 1.0})
        for (const double x : {0.0, 1.0})
            draw.vertices.edit().push_back(
                {.position_object = {2 * x - 1, 2 * y - 1, 0, 1}, .tex_coord = {x * s, y * t, 0, 1}});
    return draw;
}

// All of an object's picture, as a part of a texture's image.
ImagePart whole_part(const std::shared_ptr<const ObjectPicture>& picture, CopiedBuffer buffer) {
    return {.width = picture->width,
            .height = picture->height,
            .copied = std::make_shared<const CopiedPixels>(CopiedPixels{.buffer = buffer,
                                                                        .width = picture->width,
                                                                        .height = picture->height,
                                                                        .depth = picture->depth,
                                                                        .drawn = picture})};
}

// Whether a Draw without depths replaces all colours of a picture: a rectangle over all of it.
bool hides_all(const Draw& draw, int width, int height, bool has_alpha) {
    const FragmentState& fragment = draw.fragment;
    const RasterState& raster = draw.raster;
    std::array<bool, 4> mask = fragment.color_mask;
    mask[3] = mask[3] || !has_alpha;
    const Rectangle& box = fragment.scissor.box;
    const bool is_cut = fragment.scissor.enabled &&
                        (box.x > 0 || box.y > 0 || box.x + box.width < width || box.y + box.height < height);
    const bool fills = raster.polygon_mode_front == kGL_FILL && raster.polygon_mode_back == kGL_FILL &&
                       !raster.cull_enabled && !raster.polygon_stipple && raster.clip_plane_count() == 0;
    const bool is_rectangle = draw.mode == kGL_TRIANGLE_STRIP || draw.mode == kGL_TRIANGLE_FAN ||
                              draw.mode == kGL_QUADS || draw.mode == kGL_POLYGON;
    if (draw.pixels || is_cut || !fills || !is_rectangle || mask != Clear().color_mask || fragment.alpha_test ||
        fragment.blend || fragment.logic_op || draw.vertices.size() != 4 || !draw.indices.empty())
        return false;
    std::array<std::size_t, 4> around{0, 1, 2, 3};
    if (draw.mode == kGL_TRIANGLE_STRIP) std::swap(around[2], around[3]);
    std::array<glm::dvec2, 4> corners;
    for (std::size_t i = 0; i < 4; ++i) {
        const glm::dvec4 clip = draw.clip_from_eye * (draw.eye_from_object * draw.vertices[around[i]].position_object);
        if (!(clip.w > 0) || !(std::abs(clip.z) <= clip.w)) return false;
        const Rectangle& v = raster.viewport;
        corners[i] = {v.x + v.width * (clip.x / clip.w + 1) / 2, v.y + v.height * (clip.y / clip.w + 1) / 2};
    }
    const auto is_beyond = [&](int axis, int size) {  // 2 corners below 0, 2 above the size, in turn or in pairs
        int below = 0, above = 0;
        for (const glm::dvec2& corner : corners) {
            below += corner[axis] <= 1e-6 ? 1 : 0;
            above += corner[axis] >= size - 1e-6 ? 1 : 0;
        }
        return below == 2 && above == 2;
    };
    const auto is_low = [&](std::size_t i, int axis) { return corners[i][axis] <= 1e-6; };
    for (std::size_t i = 0; i < 4; ++i) {  // neighbours differ in one coordinate
        const std::size_t next = (i + 1) % 4;
        if ((is_low(i, 0) != is_low(next, 0)) == (is_low(i, 1) != is_low(next, 1))) return false;
    }
    return is_beyond(0, width) && is_beyond(1, height);
}

// An image without alpha has an alpha of 1.
Clear opaque() { return {.color = true, .color_mask = {false, false, false, true}, .clear_color = {0, 0, 0, 1}}; }

void draw_no_colors(FrameItems& items) {
    for (FrameItem& item : items) {
        if (Draw* draw = std::get_if<Draw>(&item)) {
            draw->fragment.color_mask.fill(false);
            draw->state_number = 0;
        }
        if (Clear* clear = std::get_if<Clear>(&item)) clear->color = false;
    }
}

}  // namespace

// Starts with what the images show: the picture that was drawn into them. If colours and depths come from different pictures,
// those of the depths are drawn without colours, and the colours as a texture.
bool State::begin_object_picture(const Command& c) {
    const FramebufferObject& object = framebuffers_.drawn();
    OpenObject open;
    int width = kMaxRenderbufferSize, height = kMaxRenderbufferSize;
    const auto limit = [&](const Attachment& attachment) {
        if (attachment.type == kGL_NONE) return;
        const AttachedImage image = *attached_image(attachment);
        width = std::min(width, image.width);
        height = std::min(height, image.height);
    };
    for (const Attachment& color : object.colors) limit(color);
    limit(object.depth);
    limit(object.stencil);
    open.picture.width = width;
    open.picture.height = height;
    const Attachment* const color = object.color(object.draw_buffer);
    const Attachment& depth = object.depth.type != kGL_NONE ? object.depth : object.stencil;
    const auto is_drawable = [](const Attachment& attachment) {
        return attachment.is_whole_texture() || (attachment.type == kGL_RENDERBUFFER && !attachment.is_deleted);
    };
    if (color && is_drawable(*color)) {
        const Enum format = attached_image(*color)->format;
        open.has_color = true;
        open.has_alpha = internal_format(format) && has_alpha(format);
        if (!is_drawn_exactly(format))
            note_unsupported(fmt::format("drawing into an image of {}", enum_name(format)), c.place);
    }
    open.has_depth = object.depth.type != kGL_NONE;
    if (open.has_depth)
        if (const auto format = internal_format(attached_image(object.depth)->format)) open.depth_bits = format->red;
    open.has_stencil = object.stencil.type != kGL_NONE;
    open.is_lost = (color && !is_drawable(*color)) || (depth.type != kGL_NONE && !is_drawable(depth));
    if (open.is_lost)
        note_unsupported("drawing into an image that is deleted or no level 0 of a GL_TEXTURE_2D", c.place);
    const auto of_size = [&](std::shared_ptr<const ObjectPicture> picture) {
        return picture && picture->width == width && picture->height == height ? picture : nullptr;
    };
    const auto colors = open.has_color ? of_size(whole_picture(*color, CopiedBuffer::kColors)) : nullptr;
    const auto depths = of_size(whole_picture(depth, CopiedBuffer::kDepths));
    open.knows_depths = depths != nullptr;
    const auto keeps = depths ? depths : colors;
    if (keeps && !has_room(c, keeps->bytes)) return false;
    if (keeps) open.picture.items = keeps->items;
    const bool needs_colors = open.has_color && (!colors || colors != keeps);
    if (needs_colors) draw_no_colors(open.picture.items);
    if (needs_colors && !open.has_alpha) open.picture.items.emplace_back(opaque());
    const bool clears_colors = c.id == CommandId::glClear && (c.enumerant(0) & kGL_COLOR_BUFFER_BIT) != 0 &&
                               !a_.fragment.scissor.enabled && a_.fragment.color_mask == Clear().color_mask;
    if (needs_colors && !clears_colors)
        if (auto texture = attached_texture(c, *color))
            open.picture.items.emplace_back(image_draw(std::move(texture), width, height, c.place));
    object_ = std::move(open);
    return true;
}

// The colours of an attachment as a texture, which is drawn texel by texel. Null if they are undefined.
std::shared_ptr<const Texture> State::attached_texture(const Command& c, const Attachment& attachment) {
    Texture texture{.min_filter = kGL_NEAREST, .mag_filter = kGL_NEAREST};
    if (attachment.type == kGL_TEXTURE) {
        const TextureImage& image = textures_.named.at(attachment.name)->levels.front();
        if (!has_room(c, image.texels.size() * sizeof(glm::vec4))) return nullptr;
        texture.levels.push_back(image);
        return std::make_shared<const Texture>(std::move(texture));
    }
    const Renderbuffer& buffer = *framebuffers_.renderbuffers.at(attachment.name);
    if (!buffer.drawn) return nullptr;
    const auto count = static_cast<std::size_t>(buffer.width) * static_cast<std::size_t>(buffer.height);
    if (!has_room(c, count * sizeof(glm::vec4))) return nullptr;
    TextureImage image{.width = buffer.width, .height = buffer.height, .texels = std::vector<glm::vec4>(count)};
    add_part(image, whole_part(buffer.drawn, CopiedBuffer::kColors));
    texture.levels.push_back(std::move(image));
    return std::make_shared<const Texture>(std::move(texture));
}

// 4.1.5: without a depth buffer or a stencil buffer their tests always pass.
void State::show_in_object(FrameItem item) {
    OpenObject& open = *object_;
    if (open.is_lost) return;
    if (Draw* draw = std::get_if<Draw>(&item)) {
        RasterState& raster = draw->raster;
        raster.depth_test = raster.depth_test && open.has_depth;
        raster.depth_mask = raster.depth_mask && open.has_depth;
        if (!open.has_stencil) draw->fragment.stencil.reset();
        if (!open.has_alpha) draw->fragment.color_mask[3] = false;
        // A unit is the smallest step of the depths (3.5.5). Renderers draw into depths of 24 bits.
        raster.polygon_offset.units = std::ldexp(raster.polygon_offset.units, 24 - open.depth_bits);
        const bool hides = open.has_color && !open.has_depth && !open.has_stencil &&
                           hides_all(*draw, open.picture.width, open.picture.height, open.has_alpha);
        if (hides) open.picture.items.clear();
        if (hides && !open.has_alpha) open.picture.items.emplace_back(opaque());
        if (raster.depth_test && !open.knows_depths)
            note_unsupported("the depths of a framebuffer object before glClear", draw->place);
        draw->for_each_unit([&](std::size_t, const TextureUnit& unit) {
            framebuffers_.drawn().for_each([&](const Attachment& attachment) {
                if (!attachment.is_whole_texture()) return;
                const std::shared_ptr<Texture>& attached = textures_.named.at(attachment.name);
                const auto part = parts_of_textures_.find(attached.get());
                const bool is_part = part != parts_of_textures_.end() && part->second.second == unit.texture;
                if (unit.texture == attached || is_part)
                    note_unsupported("drawing with a texture that is drawn into", draw->place);
            });
        });
    } else if (Clear* clear = std::get_if<Clear>(&item)) {
        clear->stencil = clear->stencil && open.has_stencil;
        clear->accumulation = false;
        const bool clears = (clear->color && open.has_color) || (clear->depth && open.has_depth) || clear->stencil;
        if (!clears) return;
        open.knows_depths = open.knows_depths || (clear->depth && !clear->scissor.enabled);
        // What has no image may be cleared as well, so that the Clear hides more.
        if (!open.has_color) clear->color_mask.fill(true);
        clear->color = clear->color || !open.has_color;
        clear->depth = clear->depth || !open.has_depth;
        if (!open.has_alpha) {
            clear->clear_color.a = 1;
            clear->color_mask[3] = true;
        }
    }
    open.is_changed = true;
    FrameItems& items = open.picture.items;
    items.push_back(std::move(item));
    items.erase(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(hidden_items(items)));
}

// Gives the object's images the picture.
void State::end_object_picture(const Command& c) {
    OpenObject open = std::move(*object_);
    object_.reset();
    if (!open.is_changed) return;
    auto picture = std::make_shared<ObjectPicture>(std::move(open.picture));
    picture->bytes = bytes_of(picture->items);
    picture->depth = 1 + copies_in_a_row(picture->items);
    if (picture->depth > kMostCopiesInARow)
        return note_lasting(fmt::format("a framebuffer object that shows {} others in a row", kMostCopiesInARow),
                            c.place);
    const FramebufferObject& object = framebuffers_.drawn();
    const auto give = [&](const Attachment& attachment, CopiedBuffer buffer) {
        if (attachment.type == kGL_RENDERBUFFER) framebuffers_.renderbuffers.at(attachment.name)->drawn = picture;
        if (!attachment.is_whole_texture()) return;
        std::shared_ptr<Texture>& texture = textures_.named.at(attachment.name);
        const auto count = static_cast<double>(picture->width) * picture->height;
        if (!has_time(c, count) || !has_room(c, static_cast<std::size_t>(count) * sizeof(glm::vec4))) return;
        if (texture.use_count() > 1) {
            if (!has_room(c, texels_of(*texture) * sizeof(glm::vec4))) return;
            texture = std::make_shared<Texture>(*texture);
        }
        copies_pixels_ = true;
        add_part(texture->levels.front(), whole_part(picture, buffer));
    };
    if (open.has_color) give(*object.color(object.draw_buffer), CopiedBuffer::kColors);
    if (open.has_depth) give(object.depth, CopiedBuffer::kDepths);
    if (open.has_stencil && !open.has_depth) give(object.stencil, CopiedBuffer::kDepths);
    std::erase_if(object_pictures_, [](const auto& old) { return old.expired(); });
    object_pictures_.push_back(picture);
}

std::size_t State::bytes_of_object_pictures() const {
    std::size_t bytes = object_ ? bytes_of(object_->picture.items) : 0;
    for (const auto& held : object_pictures_)
        if (const auto picture = held.lock()) bytes += picture->bytes;
    return bytes;
}

bool State::has_buffer(const Command& c, CopiedBuffer buffer) {
    const bool is_read = c.id == CommandId::glCopyPixels;
    for (const auto& [is_used, name] : {std::pair(true, framebuffers_.draw), {is_read, framebuffers_.read}}) {
        if (!is_used || name == 0) continue;
        const FramebufferObject& object = *framebuffers_.named.at(name);
        const bool is_stencil = buffer == CopiedBuffer::kStencil;
        if ((is_stencil ? object.stencil : object.depth).type != kGL_NONE) continue;
        raise(kGL_INVALID_OPERATION, c, "{}: the bound framebuffer object has no {}", c.name(),
              is_stencil ? tr("stencil buffer") : tr("depth buffer"));
        return false;
    }
    return true;
}

// What copies from the bound object show. Null if it has no such image; then raises the error.
std::shared_ptr<const ObjectPicture> State::read_picture(const Command& c, CopiedBuffer buffer) {
    const FramebufferObject& object = *framebuffers_.named.at(framebuffers_.read);
    const Attachment* attachment = buffer == CopiedBuffer::kColors   ? object.color(object.read_buffer)
                                   : buffer == CopiedBuffer::kDepths ? &object.depth
                                                                     : &object.stencil;
    if (!attachment || attachment->type == kGL_NONE) {
        raise(kGL_INVALID_OPERATION, c, "{}: the bound framebuffer object has no image to copy from", c.name());
        return nullptr;
    }
    auto picture = whole_picture(*attachment, buffer);
    if (!picture) note_lasting(fmt::format("{} of an image that no framebuffer object drew", c.name()), c.place);
    return picture;
}

// 3.8.8, 4.4.7 of OpenGL 3.0.
void State::generate_mipmap(const Command& c) {
    const Enum target = c.enumerant(0);
    if (is_driver_only_texture(target) || !known(c, target, kTextureTargets)) return;
    const Texture& bound = bound_texture(target);
    const auto base = static_cast<std::size_t>(bound.base_level);
    const auto has_image = [&](std::size_t face) {
        return base < bound.face(face).size() && !bound.face(face)[base].texels.empty();
    };
    for (std::size_t face = 0; face < bound.face_count(); ++face) {
        if (has_image(face)) continue;
        if (bound.is_cube()) raise(kGL_INVALID_OPERATION, c, "a face of the cube map has no image of level {}", base);
        return;
    }
    if (!has_texels(c, static_cast<double>(texels_of(bound)))) return;
    Texture* texture = writable_texture(c, target);
    if (!texture) return;
    textures_.texels -= texels_of(*texture);
    const bool automatic = std::exchange(texture->generate_mipmap, true);
    for (std::size_t face = 0; face < texture->face_count(); ++face) generate_mipmaps(*texture, face);
    texture->generate_mipmap = automatic;
    textures_.texels += texels_of(*texture);
}

// ---- Buffers to draw to and to read ----

// 4.2.1. A window has one colour buffer here, so all its names but GL_NONE mean the same.
void State::draw_buffer(const Command& c) {
    const Enum mode = c.enumerant(0);
    if (!check_buffer(c, framebuffers_.draw)) return;
    if (framebuffers_.draw != 0)
        framebuffers_.drawn().draw_buffer = mode;
    else
        a_.draws_color = mode != kGL_NONE;
}

// 4.3.2. Only copies from an object depend on it.
void State::read_buffer(const Command& c) {
    if (framebuffers_.read != 0 && check_buffer(c, framebuffers_.read))
        framebuffers_.named.at(framebuffers_.read)->read_buffer = c.enumerant(0);
}

bool State::check_buffer(const Command& c, std::uint32_t framebuffer) {
    const Enum mode = c.enumerant(0), attachment = mode - kGL_COLOR_ATTACHMENT0;
    const bool is_attachment = attachment <= kGL_COLOR_ATTACHMENT15 - kGL_COLOR_ATTACHMENT0;
    if (!is_attachment && !known(c, mode,
                                 {kGL_NONE, kGL_FRONT, kGL_BACK, kGL_LEFT, kGL_RIGHT, kGL_FRONT_AND_BACK,
                                  kGL_FRONT_LEFT, kGL_FRONT_RIGHT, kGL_BACK_LEFT, kGL_BACK_RIGHT}))
        return false;
    if (mode == kGL_NONE || (framebuffer == 0 ? !is_attachment : attachment < kMaxColorAttachments)) return true;
    raise(kGL_INVALID_OPERATION, c, "{} is given {}; {}", c.name(), enum_name(mode),
          framebuffer == 0 ? tr("the window has no attachments")
                           : tr("a framebuffer object has GL_COLOR_ATTACHMENT0 to 7"));
    return false;
}

}  // namespace twinlight
