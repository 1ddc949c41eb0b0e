#include "scene/state/copied_texels.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "scene/state/pixel_unpacking.h"

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

// The pixels of an image in a rectangle, y up. A frame that was resized has a rectangle of another size than its copy: then
// each texel has the pixel at its centre.
std::vector<Rgba> cut(const Image& image, const CopyPixels& copy, float outside) {
    const CopiedPixels& size = *copy.pixels;
    std::vector<Rgba> pixels;
    pixels.reserve(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
    for (int j = 0; j < size.height; ++j) {
        const double y = copy.from.y + std::floor((j + 0.5) * copy.from.height / size.height);
        for (int i = 0; i < size.width; ++i) {
            const double x = copy.from.x + std::floor((i + 0.5) * copy.from.width / size.width);
            const bool is_inside = x >= 0 && x < image.width && y >= 0 && y < image.height;
            Rgba pixel{outside, outside, outside, outside};
            if (is_inside) pixel = image.at(static_cast<int>(x), image.height - 1 - static_cast<int>(y));
            if (size.buffer == CopiedBuffer::kColors)
                for (float& channel : pixel) channel = static_cast<float>(channel_code(channel)) / 255.0F;
            pixels.push_back(pixel);
        }
    }
    return pixels;
}

class Copier {
  public:
    Copier(const Frame& frame, const DrawSource& draw) : frame_(frame), draw_(draw) {}

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
    static void note_uses(const TextureImage& image, std::set<const CopiedPixels*>& used) {
        if (image.half_of) note_uses(*image.half_of, used);
        for (const ImagePart& part : image.parts) used.insert(part.copied.get());
    }
    void note_uses(const FrameItems& items) {
        for (const FrameItem& item : items)
            if (const Draw* draw = std::get_if<Draw>(&item))
                draw->for_each_unit([&](std::size_t, const TextureUnit& unit) {
                    for (std::size_t i = 0; i < unit.texture->face_count(); ++i)
                        for (const TextureImage& image : unit.texture->face(i)) note_uses(image, used_);
                });
    }
    bool is_used(const FrameItem& item) const {
        const CopyPixels* copy = std::get_if<CopyPixels>(&item);
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
        for (const FrameItem& item : items) {
            if (std::holds_alternative<CopyPixels>(item)) {
                if (is_used(item)) take(std::get<CopyPixels>(item));
                continue;
            }
            sources_.clear();
            shown_.push_back(item);
            if (Draw* draw = std::get_if<Draw>(&shown_.back())) {
                fill(draw->texture);
                for (FurtherUnit& further : draw->further_units) fill(further.unit);
            }
            const auto hidden = static_cast<std::ptrdiff_t>(hidden_items(shown_));
            std::move(shown_.begin(), shown_.begin() + hidden, std::back_inserter(hidden_));
            shown_.erase(shown_.begin(), shown_.begin() + hidden);
        }
    }

    void take(const CopyPixels& copy) {
        const CopiedBuffer buffer = copy.pixels->buffer;
        auto source = sources_.find(buffer);
        if (source == sources_.end()) {
            Frame picture = frame_without_items();
            picture.items = std::move(shown_);
            source = sources_.emplace(buffer, draw_(picture, buffer)).first;
            shown_ = std::move(picture.items);
        }
        const auto& [picture, low, high] = source->second;
        TakenPixels& taken = taken_[copy.pixels.get()];
        taken.width = copy.pixels->width;
        taken.picture = cut(picture, copy, 0);
        if (low.pixels.empty()) return;
        taken.low = cut(low, copy, 0);
        taken.high = cut(high, copy, 1);
        has_range_ = true;
    }

    void fill(TextureUnit& unit) {
        if (!unit.texture || !unit.texture->has_copies()) return;
        std::shared_ptr<const Texture>& filled = filled_[unit.texture.get()];
        if (!filled) {
            Texture texture = with_levels(*unit.texture, Of::kPicture);
            if (has_range_)
                texture.range = std::make_shared<const TextureRange>(
                    TextureRange{with_levels(*unit.texture, Of::kLow), with_levels(*unit.texture, Of::kHigh)});
            filled = std::make_shared<const Texture>(std::move(texture));
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
        if (image.half_of) result.texels = half(whole(*image.half_of, of), format).texels;
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
    bool has_range_ = false;
    std::map<const CopiedPixels*, TakenPixels> taken_;
    std::map<const Texture*, std::shared_ptr<const Texture>> filled_;
};

}  // namespace

Frame with_copied_texels(const Frame& frame, const DrawSource& draw) { return Copier(frame, draw).result(); }

}  // namespace twinlight
