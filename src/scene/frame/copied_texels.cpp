#include "scene/frame/copied_texels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "scene/frame/pixel_image.h"
#include "scene/frame/texture_formats.h"

namespace twinlight {

namespace {

// Which of the values that renderers may have copied.
enum class Of : std::uint8_t { kPicture, kLow, kHigh };

// The pixels of one copy, row 0 at the bottom.
struct TakenPixels {
    int width = 0;
    std::vector<Rgba> picture, low, high;

    glm::dvec4 pixel(Of of, int x, int y) const {
        const std::vector<Rgba>& pixels = of == Of::kPicture || low.empty() ? picture : of == Of::kLow ? low : high;
        const Rgba& p =
            pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
        return {p[0], p[1], p[2], p[3]};
    }
};

// The smallest rectangle around both.
Rectangle around(const Rectangle& a, const Rectangle& b) {
    if (a.width == 0 || a.height == 0) return b;
    if (b.width == 0 || b.height == 0) return a;
    const int x = std::min(a.x, b.x), y = std::min(a.y, b.y);
    return {x, y, std::max(a.x + a.width, b.x + b.width) - x, std::max(a.y + a.height, b.y + b.height) - y};
}

// What of the rectangle is inside a picture. The rectangle may be anywhere.
Rectangle inside(const Rectangle& area, int width, int height) {
    const auto end = [](std::int64_t from, int size, int low, int high) {
        return static_cast<int>(std::clamp<std::int64_t>(from + size, low, high));
    };
    const int x = std::clamp(area.x, 0, width), y = std::clamp(area.y, 0, height);
    return {x, y, end(area.x, area.width, x, width) - x, end(area.y, area.height, y, height) - y};
}

// A pixel of a copy from a picture, of which `image` has at least what the copy needs. A frame that was resized has a rectangle
// of another size than its copy: then the copy has the pixel at the centre.
Rgba taken_pixel(const Image& image, const glm::ivec2& corner, const CopiedPixels& size, const Rectangle& from, int i,
                 int j, float outside) {
    const auto scaled = [](int place, int wide, int narrow) {
        return wide == narrow ? place : static_cast<std::int64_t>(std::floor((place + 0.5) * wide / narrow));
    };
    const std::int64_t x = from.x + scaled(i, from.width, size.width) - corner.x,
                       y = from.y + scaled(j, from.height, size.height) - corner.y;
    const bool is_inside = Rectangle{0, 0, image.width, image.height}.contains(x, y);
    Rgba pixel{outside, outside, outside, outside};
    if (is_inside) pixel = image.at(static_cast<int>(x), image.height - 1 - static_cast<int>(y));
    if (size.buffer == CopiedBuffer::kColors)
        for (float& channel : pixel) channel = static_cast<float>(channel_code(channel)) / 255.0F;
    return pixel;
}

// All pixels of a copy.
std::vector<Rgba> cut(const Image& image, const glm::ivec2& corner, const CopiedPixels& copy, const Rectangle& from,
                      float outside) {
    std::vector<Rgba> pixels;
    pixels.reserve(static_cast<std::size_t>(copy.width) * static_cast<std::size_t>(copy.height));
    for (int j = 0; j < copy.height; ++j)
        for (int i = 0; i < copy.width; ++i) pixels.push_back(taken_pixel(image, corner, copy, from, i, j, outside));
    return pixels;
}

// 4.3.3: gives a Draw the colours, depths or stencil values that it copies. A place that takes any colour, from an edge of the picture, is in
// doubt like one at an edge.
void fill_pixels(Draw& draw, const CopySource& from, CopyRanges* ranges) {
    WindowPixels pixels = *draw.pixels;
    const std::shared_ptr<const CopiedGroups> groups = std::exchange(pixels.copied, nullptr);
    const std::size_t count = pixels.places.size();
    const bool has_range = ranges && !from.low.pixels.empty();
    CopyRanges::OfPixels range;
    const auto taken = [&](const Image& image, std::size_t vertex, float outside) {
        const glm::ivec2& place = groups->places[vertex];
        return taken_pixel(image, from.corner, *groups->source.pixels, groups->source.from, place.x, place.y, outside);
    };
    if (groups->source.pixels->buffer == CopiedBuffer::kColors) {
        std::vector<Vertex>& vertices = draw.vertices.edit();
        if (has_range) range.colors.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            const Rgba picture = taken(from.picture, i, 0);
            Rgba low = picture, high = picture;
            if (has_range) {
                low = taken(from.low, i, 0);
                high = taken(from.high, i, 1);
            }
            if (low == Rgba{0, 0, 0, 0} && high == Rgba{1, 1, 1, 1}) range.doubtful.push_back(pixels.places[i]);
            for (int c = 0; c < 4; ++c) {
                const auto channel = static_cast<std::size_t>(c);
                const std::array<double, 256>& result = groups->colors[channel];
                vertices[i].color[c] = result[static_cast<std::size_t>(channel_code(picture[channel]))];
                if (!has_range) continue;
                const auto [least, most] = std::minmax_element(result.begin() + channel_code(low[channel]),
                                                               result.begin() + channel_code(high[channel]) + 1);
                range.colors[i][0][c] = *least;
                range.colors[i][1][c] = *most;
            }
        }
        pixels.image = image_of_pixels(pixels.places, vertices);
    } else if (pixels.has_stencils) {
        pixels.stencils.clear();
        for (std::size_t i = 0; i < count; ++i) {
            pixels.stencils.push_back(
                groups->stencils[static_cast<std::size_t>(channel_code(taken(from.picture, i, 0)[0]))]);
            if (has_range && taken(from.low, i, 0) != taken(from.high, i, 1))
                range.doubtful.push_back(pixels.places[i]);
        }
    } else {
        const auto transferred = [&](const Rgba& depth) {
            return std::clamp(groups->depth_scale * static_cast<double>(depth[0]) + groups->depth_bias, 0.0, 1.0);
        };
        pixels.depths.clear();
        for (std::size_t i = 0; i < count; ++i) {
            pixels.depths.push_back(transferred(taken(from.picture, i, 0)));
            if (!has_range) continue;
            const auto [least, most] =
                std::minmax({transferred(taken(from.low, i, 0)), transferred(taken(from.high, i, 1))});
            range.depths.emplace_back(least, most);
        }
    }
    draw.pixels = std::make_shared<const WindowPixels>(std::move(pixels));
    if (has_range) ranges->pixels[draw.pixels] = std::move(range);
}

bool has_odd_side(const TextureImage& image) {
    const auto is_odd = [](int side) { return side > 1 && side % 2 == 1; };
    return is_odd(image.width) || is_odd(image.height) || is_odd(image.depth);
}
// 3.8.8 asks for no particular filter. Two texels of an odd side are smaller than one of its half, which may be any mean of those
// that it covers.
TextureImage bound_of_half(const TextureImage& image, bool is_high) {
    TextureImage result = image.half_size();
    const auto first = [](int i, int side, int half) { return i * side / half; };
    const auto last = [](int i, int side, int half) { return ((i + 1) * side - 1) / half; };
    for (int z = 0; z < result.depth; ++z)
        for (int y = 0; y < result.height; ++y)
            for (int x = 0; x < result.width; ++x) {
                glm::vec4 bound(is_high ? 0 : 1);
                for (int k = first(z, image.depth, result.depth); k <= last(z, image.depth, result.depth); ++k)
                    for (int j = first(y, image.height, result.height); j <= last(y, image.height, result.height); ++j)
                        for (int i = first(x, image.width, result.width); i <= last(x, image.width, result.width);
                             ++i) {
                            const glm::vec4 texel = image.texel(i, j, k);
                            bound = is_high ? glm::max(bound, texel) : glm::min(bound, texel);
                        }
                result.texels.push_back(bound);
            }
    return result;
}

class Copier {
  public:
    Copier(const Frame& frame, const DrawSource& draw, CopyRanges* ranges)
        : frame_(frame), draw_(draw), ranges_(ranges) {}

    Frame result() {
        std::vector<const FrameItems*> needed;
        note_uses(frame_.items);
        for (auto picture = frame_.earlier.rbegin(); picture != frame_.earlier.rend(); ++picture) {
            if (!std::ranges::any_of(**picture, [&](const FrameItem& item) { return is_used(item); })) continue;
            note_uses(**picture);
            needed.push_back(picture->get());
        }
        for (auto picture = needed.rbegin(); picture != needed.rend(); ++picture) go_through(**picture);
        go_through(frame_.items);
        Frame result = frame_without_items();
        result.items = std::move(hidden_);
        std::move(shown_.begin(), shown_.end(), std::back_inserter(result.items));
        return result;
    }

  private:
    void note_use(const CopiedPixels& copied) {
        if (used_.insert(&copied).second && copied.drawn) note_uses(copied.drawn->items);
    }
    void note_uses(const TextureImage& image) {
        if (image.half_of) note_uses(*image.half_of);
        for (const ImagePart& part : image.parts)
            if (part.copied) note_use(*part.copied);
    }
    void note_uses(const FrameItems& items) {
        for (const FrameItem& item : items) {
            const Draw* draw = std::get_if<Draw>(&item);
            if (!draw) continue;
            draw->for_each_unit([&](std::size_t, const TextureUnit& unit) {
                for (std::size_t i = 0; i < unit.texture->face_count(); ++i)
                    for (const TextureImage& image : unit.texture->face(i)) note_uses(image);
            });
            if (draw->pixels && draw->pixels->copied) note_use(*draw->pixels->copied->source.pixels);
        }
    }
    bool is_used(const FrameItem& item) const {
        const TakePixels* copy = std::get_if<TakePixels>(&item);
        return copy && used_.contains(copy->pixels.get());
    }

    Frame frame_without_items() const {
        Frame frame{.width = frame_.width, .height = frame_.height};
        frame.unsupported = frame_.unsupported;
        frame.lists_called_before_made = frame_.lists_called_before_made;
        frame.typed_lights = frame_.typed_lights;
        return frame;
    }

    void go_through(const FrameItems& items) {
        hidden_.clear();
        shown_.clear();
        sources_.clear();
        areas_.clear();
        for (const FrameItem& item : items)
            if (const TakePixels* copy = copy_from_here(item)) {
                Rectangle& area = areas_[copy->pixels->buffer];
                area = around(area, inside(copy->from, frame_.width, frame_.height));
            }
        for (const FrameItem& item : items) {
            if (std::holds_alternative<TakePixels>(item)) {
                if (is_used(item)) take(std::get<TakePixels>(item));
                continue;
            }
            const Draw* given = std::get_if<Draw>(&item);
            std::optional<CopySource> copied;
            if (given && given->pixels && given->pixels->copied) {
                const CopiedPixels& from = *given->pixels->copied->source.pixels;
                copied = from.drawn ? source(*from.drawn, from.buffer, given->pixels->copied->source.from)
                                    : source(from.buffer);
            }
            sources_.clear();
            shown_.push_back(item);
            if (Draw* draw = std::get_if<Draw>(&shown_.back())) {
                if (copied) fill_pixels(*draw, *copied, ranges_);
                fill(*draw);
            }
            const auto hidden = static_cast<std::ptrdiff_t>(hidden_items(shown_));
            std::move(shown_.begin(), shown_.begin() + hidden, std::back_inserter(hidden_));
            shown_.erase(shown_.begin(), shown_.begin() + hidden);
        }
    }

    // What the item copies of the picture that these items draw, if anything.
    const TakePixels* copy_from_here(const FrameItem& item) const {
        if (is_used(item)) return std::get_if<TakePixels>(&item);
        const Draw* draw = std::get_if<Draw>(&item);
        if (!draw || !draw->pixels || !draw->pixels->copied) return nullptr;
        const TakePixels& source = draw->pixels->copied->source;
        return source.pixels->drawn ? nullptr : &source;
    }

    // A picture of what is shown now, at least of areas_.
    const CopySource& source(CopiedBuffer buffer) {
        auto source = sources_.find(buffer);
        if (source == sources_.end()) {
            Frame picture = frame_without_items();
            picture.items = std::move(shown_);
            source = sources_.emplace(buffer, draw_(picture, buffer, areas_[buffer])).first;
            shown_ = std::move(picture.items);
        }
        return source->second;
    }

    // A picture of what a framebuffer object shows.
    CopySource source(const ObjectPicture& object, CopiedBuffer buffer, const Rectangle& area) {
        Frame picture = frame_without_items();
        picture.width = object.width;
        picture.height = object.height;
        picture.is_object = true;
        picture.items = object.items;
        for (FrameItem& item : picture.items) {
            Draw* draw = std::get_if<Draw>(&item);
            if (!draw) continue;
            if (draw->pixels && draw->pixels->copied) {
                const CopiedPixels& from = *draw->pixels->copied->source.pixels;
                fill_pixels(*draw, source(*from.drawn, from.buffer, draw->pixels->copied->source.from), ranges_);
            }
            fill(*draw);
        }
        return draw_(picture, buffer, inside(area, object.width, object.height));
    }

    void take(const TakePixels& copy) { take(source(copy.pixels->buffer), *copy.pixels, copy.from); }
    void take(const CopySource& source, const CopiedPixels& copy, const Rectangle& from) {
        const auto& [picture, low, high, corner] = source;
        TakenPixels& taken = taken_[&copy];
        taken.width = copy.width;
        taken.picture = cut(picture, corner, copy, from, 0);
        if (low.pixels.empty()) return;
        taken.low = cut(low, corner, copy, from, 0);
        taken.high = cut(high, corner, copy, from, 1);
        has_range_ = true;
    }
    // The pixels that framebuffer objects have drawn into an image.
    void take_drawn(const TextureImage& image) {
        if (image.half_of) take_drawn(*image.half_of);
        for (const ImagePart& part : image.parts) {
            if (!part.copied || !part.copied->drawn || taken_.contains(part.copied.get())) continue;
            const CopiedPixels& copy = *part.copied;
            const Rectangle area{copy.x, copy.y, copy.width, copy.height};
            take(source(*copy.drawn, copy.buffer, area), copy, area);
        }
    }

    void fill(Draw& draw) {
        fill(draw.texture);
        for (FurtherUnit& further : draw.further_units) fill(further.unit);
    }

    void fill(TextureUnit& unit) {
        if (!unit.texture || !unit.texture->has_copies()) return;
        std::shared_ptr<const Texture>& filled = filled_[unit.texture.get()];
        if (!filled) {
            for (std::size_t i = 0; i < unit.texture->face_count(); ++i)
                for (const TextureImage& image : unit.texture->face(i)) take_drawn(image);
            Texture texture = with_levels(*unit.texture, Of::kPicture);
            filled = std::make_shared<const Texture>(std::move(texture));
            if (has_range_ && ranges_)
                ranges_->textures[filled] = {with_levels(*unit.texture, Of::kLow),
                                             with_levels(*unit.texture, Of::kHigh)};
        }
        unit.texture = filled;
    }

    Texture with_levels(Texture texture, Of of) const {
        for (std::size_t i = 0; i < texture.face_count(); ++i)
            for (TextureImage& image : texture.face(i))
                if (image.has_copies()) image = whole(image, of);
        return texture;
    }

    TextureImage whole(const TextureImage& image, Of of) const {
        const InternalFormat format = *internal_format(image.internal_format);
        TextureImage result = image;
        result.parts.clear();
        result.half_of.reset();
        if (image.half_of) {
            const TextureImage larger = whole(*image.half_of, of);
            const bool is_exact = of == Of::kPicture || !has_odd_side(larger);
            result.texels = (is_exact ? half(larger, format) : bound_of_half(larger, of == Of::kHigh)).texels;
        }
        for (const ImagePart& part : image.parts) {
            const auto taken = taken_.find(part.copied.get());
            if (part.copied && taken == taken_.end()) continue;
            for (int y = 0; y < part.height; ++y)
                for (int x = 0; x < part.width; ++x) {
                    const auto from = static_cast<std::size_t>(y) * static_cast<std::size_t>(part.width) +
                                      static_cast<std::size_t>(x);
                    const std::size_t to = image.index(part.x + x, part.y + y, part.z);
                    result.texels[to] = part.copied ? stored(taken->second.pixel(of, x, y), format) : part.texels[from];
                }
        }
        return result;
    }

    const Frame& frame_;
    const DrawSource& draw_;
    std::set<const CopiedPixels*> used_;          // by Draws
    FrameItems hidden_, shown_;                   // the picture so far: before and since the last Clear that hides all
    std::map<CopiedBuffer, CopySource> sources_;  // of shown_
    std::map<CopiedBuffer, Rectangle> areas_;     // what is copied while these items are gone through
    bool has_range_ = false;
    CopyRanges* ranges_;
    std::map<const CopiedPixels*, TakenPixels> taken_;
    std::map<const Texture*, std::shared_ptr<const Texture>> filled_;
};

}  // namespace

namespace {

// The levels of one face, if any of them was made of an image with an odd side: their least and their largest values.
bool find_range(const std::vector<TextureImage>& levels, std::vector<TextureImage>& low,
                std::vector<TextureImage>& high) {
    bool has_range = false, is_open = false;
    for (std::size_t i = 1; i < levels.size(); ++i) {
        const TextureImage &larger = levels[i - 1], &image = levels[i];
        const auto format = internal_format(image.internal_format);
        const bool is_made =
            format && image.has_size_of(larger.half_size()) && half(larger, *format).texels == image.texels;
        is_open = is_made && (is_open || has_odd_side(larger));
        if (!is_open) continue;
        low[i].texels = bound_of_half(low[i - 1], false).texels;
        high[i].texels = bound_of_half(high[i - 1], true).texels;
        has_range = true;
    }
    return has_range;
}

}  // namespace

void add_generated_levels(const Frame& frame, CopyRanges& ranges) {
    for (const Draw* draw : frame.draws())
        draw->for_each_unit([&](std::size_t, const TextureUnit& unit) {
            const Texture& texture = *unit.texture;
            if (!texture.generate_mipmap || texture.has_copies() || ranges.textures.contains(unit.texture)) return;
            CopyRanges::OfTexels range{texture, texture};
            bool has_range = false;
            for (std::size_t face = 0; face < texture.face_count(); ++face)
                has_range |= find_range(texture.face(face), range.low.face(face), range.high.face(face));
            if (has_range) ranges.textures[unit.texture] = std::move(range);
        });
}

Frame with_copied_texels(const Frame& frame, const DrawSource& draw, CopyRanges* ranges) {
    return Copier(frame, draw, ranges).result();
}

namespace {

class DrawsOfAllPictures {
  public:
    void add(const FrameItems& items) {
        for (const FrameItem& item : items)
            if (const Draw* draw = std::get_if<Draw>(&item)) add(*draw);
    }
    std::vector<const Draw*> result;

  private:
    void add(const Draw& draw) {
        result.push_back(&draw);
        if (draw.pixels && draw.pixels->copied) add(draw.pixels->copied->source.pixels->drawn.get());
        draw.for_each_unit([&](std::size_t, const TextureUnit& unit) {
            for (std::size_t face = 0; face < unit.texture->face_count(); ++face)
                for (const TextureImage& image : unit.texture->face(face)) add(image);
        });
    }
    void add(const TextureImage& image) {
        if (image.half_of) add(*image.half_of);
        for (const ImagePart& part : image.parts)
            if (part.copied) add(part.copied->drawn.get());
    }
    void add(const ObjectPicture* picture) {
        if (picture && added_.insert(picture).second) add(picture->items);
    }

    std::set<const ObjectPicture*> added_;
};

}  // namespace

std::vector<const Draw*> draws_of_all_pictures(const Frame& frame) {
    DrawsOfAllPictures draws;
    if (frame.copies_pixels)
        for (const auto& items : frame.earlier) draws.add(*items);
    draws.add(frame.items);
    return std::move(draws.result);
}

std::vector<Draw> by_stencil_value(const Draw& draw) {
    std::map<int, std::vector<std::size_t>> vertices_of;
    for (std::size_t i = 0; i < draw.pixels->stencils.size(); ++i) vertices_of[draw.pixels->stencils[i]].push_back(i);
    std::vector<Draw> draws;
    for (const auto& [value, numbers] : vertices_of) {
        Draw& one = draws.emplace_back(draw);
        one.fragment.stencil->front.ref = one.fragment.stencil->back.ref = value;
        WindowPixels pixels{.depths = {0}};
        for (const std::size_t i : numbers) pixels.places.push_back(draw.pixels->places[i]);
        one.vertices = std::vector<Vertex>(numbers.size(), draw.vertices[0]);
        one.pixels = std::make_shared<const WindowPixels>(std::move(pixels));
    }
    return draws;
}

}  // namespace twinlight
