// gluBuild1DMipmaps to gluBuild3DMipmaps, with the arithmetic of libglu 9.0.2 (libutil/mipmap.c), which computes in
// the type of the pixels.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "scene/shape/written_out.h"
#include "scene/state/packed_types.h"
#include "scene/state/pixel_unpacking.h"
#include "scene/state/state.h"

namespace twinlight {

namespace {

// An RGBA image. For a whole-number type `largest` is the number that means 1; for other types it is 0.
struct Pixels {
    int width = 0, height = 0, depth = 1;
    std::vector<glm::dvec4> rgba{};
    double largest = 0;

    std::size_t index(int x, int y, int z) const {
        const std::size_t row =
            static_cast<std::size_t>(z) * static_cast<std::size_t>(height) + static_cast<std::size_t>(y);
        return row * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
    const glm::dvec4& at(int x, int y, int z = 0) const { return rgba[index(x, y, z)]; }
    // A mean as the type stores it: adds `rounding` units, then rounds down.
    glm::dvec4 as_stored(const glm::dvec4& mean, double rounding) const {
        constexpr double kDust = 1e-6;  // sums of n / 255 may fall this far below a whole number
        return largest == 0 ? mean : glm::floor(mean * largest + rounding + kDust) / largest;
    }
};

// nearestPower(): 3 becomes 4, 5 becomes 4, 6 becomes 8.
int nearest_power(int value) {
    int power = 1;
    for (;; value /= 2, power *= 2) {
        if (value == 1) return power;
        if (value == 3) return power * 4;
    }
}

// scale_internal_*(): each new pixel is the mean of the area that it covers.
Pixels scaled(const Pixels& image, int width, int height) {
    Pixels result{.width = width, .height = height, .largest = image.largest};
    const double step_x = static_cast<double>(image.width) / width;
    const double step_y = static_cast<double>(image.height) / height;
    const auto overlap = [](double low, double high, int cell) {
        return std::max(0.0, std::min(high, cell + 1.0) - std::max(low, static_cast<double>(cell)));
    };
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const double x0 = x * step_x, x1 = x0 + step_x, y0 = y * step_y, y1 = y0 + step_y;
            glm::dvec4 sum(0);
            for (int v = static_cast<int>(y0); v < std::min<double>(image.height, y1); ++v)
                for (int u = static_cast<int>(x0); u < std::min<double>(image.width, x1); ++u)
                    sum += image.at(u, v) * (overlap(x0, x1, u) * overlap(y0, y1, v));
            result.rgba.push_back(result.as_stored(sum / (step_x * step_y), 0));
        }
    }
    return result;
}

// fillImage3D(): a component as GLU scales it, in 16 bits. Those of signed types wrap.
int in_16_bits(double value, Enum type) {
    const auto whole = [](double number) { return static_cast<std::int64_t>(std::floor(number + 0.5)); };
    const auto from_signed = [&](double largest) { return whole((value * largest - 1) / 2); };  // table 2.9
    constexpr std::int64_t kAll = 65535;
    switch (type) {
        case kGL_UNSIGNED_BYTE:
        case kGL_UNSIGNED_SHORT: return static_cast<int>(whole(value * kAll));
        case kGL_UNSIGNED_INT: return static_cast<int>(whole(value * 4294967295.0) >> 16);
        case kGL_BYTE: return static_cast<int>(from_signed(255) * 516 & kAll);
        case kGL_SHORT: return static_cast<int>(from_signed(65535) * 2 & kAll);
        case kGL_INT: return static_cast<int>(from_signed(4294967295.0) >> 15 & kAll);
        default: return static_cast<int>(std::clamp(static_cast<float>(value), 0.0F, 1.0F) * 65535);
    }
}

// emptyImage3D(): back to a component of the type.
double from_16_bits(int value, Enum type, int packed_bits) {
    switch (type) {
        case kGL_UNSIGNED_BYTE: return (value >> 8) / 255.0;
        case kGL_BYTE: return (2 * (value >> 9) + 1) / 255.0;
        case kGL_SHORT: return (2 * (value >> 1) + 1) / 65535.0;
        case kGL_INT: return (2 * std::floor(value * 65537.0 / 2) + 1) / 4294967295.0;
        default: break;
    }
    const double number = value / 65535.0;
    const double largest = std::exp2(packed_bits) - 1;
    return packed_bits == 0 ? number : std::floor(number * largest + 0.5) / largest;
}

// The pixels under a new pixel along an axis, with their weights: scaleInternal3D(), in floats as there. An image that becomes larger
// is filtered over one of its pixels, and goes on at its other end.
std::vector<std::vector<std::pair<int, float>>> box_filters(int from, int to) {
    std::vector<std::vector<std::pair<int, float>>> filters;
    const float step = static_cast<float>(from) / static_cast<float>(to), half_step = step / 2;
    for (int i = 0; i < to; ++i) {
        const auto middle = static_cast<float>(static_cast<double>(step) * (i + 0.5));
        const float high = from > to ? middle + half_step : static_cast<float>(static_cast<double>(middle) + 0.5),
                    low = from > to ? middle - half_step : static_cast<float>(static_cast<double>(middle) - 0.5);
        std::vector<std::pair<int, float>>& filter = filters.emplace_back();
        auto cell = static_cast<int>(std::floor(low));
        for (float at = low; at < high; at = static_cast<float>(cell)) {
            const auto end = static_cast<float>(cell + 1);
            filter.emplace_back((cell + from) % from, (high < end ? high : end) - at);
            ++cell;
        }
    }
    return filters;
}

// gluScaleImage3D().
Pixels scaled_volume(const Pixels& image, int width, int height, int depth, Enum type,
                     const std::array<int, 4>& packed_bits) {
    Pixels result{.width = width, .height = height, .depth = depth, .largest = image.largest};
    const bool is_signed = type == kGL_BYTE || type == kGL_SHORT || type == kGL_INT;
    std::vector<std::array<int, 4>> codes;
    codes.reserve(image.rgba.size());
    for (const glm::dvec4& rgba : image.rgba) {
        std::array<int, 4>& code = codes.emplace_back();
        for (int i = 0; i < 4; ++i) code[static_cast<std::size_t>(i)] = in_16_bits(rgba[i], type);
    }
    const auto in_x = box_filters(image.width, width), in_y = box_filters(image.height, height),
               in_z = box_filters(image.depth, depth);
    for (const auto& along_z : in_z)
        for (const auto& along_y : in_y)
            for (const auto& along_x : in_x) {
                std::array<float, 4> totals{};
                float volume = 0;
                for (const auto& [z, part_z] : along_z)
                    for (const auto& [y, part_y] : along_y)
                        for (const auto& [x, part_x] : along_x) {
                            const float part = part_x * part_y * part_z;
                            volume += part;
                            const std::array<int, 4>& code = codes[image.index(x, y, z)];
                            for (std::size_t i = 0; i < 4; ++i) totals[i] += static_cast<float>(code[i]) * part;
                        }
                glm::dvec4& rgba = result.rgba.emplace_back();
                for (int i = 0; i < 4; ++i) {
                    const auto channel = static_cast<std::size_t>(i);
                    const auto mean = static_cast<int>((static_cast<double>(totals[channel]) + 0.5) / volume);
                    const bool is_absent = is_signed && image.rgba[0][i] == 0;  // no signed number is 0
                    rgba[i] = is_absent ? 0 : from_16_bits(mean, type, packed_bits[channel]);
                }
            }
    return result;
}

// halveImage_*(): (sum + 2) / 4 of four pixels, sum / 2 of two, in whole numbers; halveImage3D(): the mean of up to eight, rounded
// down.
Pixels halved(const Pixels& image) {
    Pixels result{.width = std::max(1, image.width / 2),
                  .height = std::max(1, image.height / 2),
                  .depth = std::max(1, image.depth / 2),
                  .largest = image.largest};
    const int dx = image.width > 1 ? 1 : 0, dy = image.height > 1 ? 1 : 0, dz = image.depth > 1 ? 1 : 0;
    for (int z = 0; z < result.depth; ++z) {
        for (int y = 0; y < result.height; ++y) {
            for (int x = 0; x < result.width; ++x) {
                const int u = x * (1 + dx), v = y * (1 + dy), w = z * (1 + dz);
                const auto sum = [&](int layer) {
                    return image.at(u, v, layer) + image.at(u + dx, v, layer) + image.at(u, v + dy, layer) +
                           image.at(u + dx, v + dy, layer);
                };
                const glm::dvec4 mean = (sum(w) + sum(w + dz)) / 8.0;
                result.rgba.push_back(result.as_stored(mean, dx + dy == 2 && dz == 0 ? 0.5 : 0));
            }
        }
    }
    return result;
}

// The image and its halves, down to one pixel.
void fill_levels(std::vector<TextureImage>& levels, Pixels image, const InternalFormat& format, Enum internal_format) {
    for (std::size_t level = 0;; ++level) {
        if (levels.size() <= level) levels.resize(level + 1);
        levels[level] = {.width = image.width,
                         .height = image.height,
                         .depth = image.depth,
                         .base_format = format.base_format,
                         .internal_format = internal_format};
        levels[level].texels.reserve(image.rgba.size());
        for (const glm::dvec4& rgba : image.rgba) levels[level].texels.push_back(stored(rgba, format));
        if (!levels[level].is_halved()) return;
        image = halved(image);
    }
}

double largest_of(Enum type) {
    switch (type) {
        case kGL_UNSIGNED_BYTE: return 255;
        case kGL_UNSIGNED_SHORT: return 65535;
        case kGL_UNSIGNED_INT: return 4294967295.0;
        default: return 0;
    }
}

}  // namespace

// For a wrong argument GLU returns its own error code and leaves the texture unchanged. So does this.
void State::build_mipmaps(const Command& c) {
    const auto dimensions = static_cast<std::size_t>(image_dimensions(c));
    const std::optional<ImageTarget> target = twinlight::image_target(c.enumerant(0));
    const PixelSource source{.width = static_cast<int>(c.number(2)),
                             .height = dimensions > 1 ? static_cast<int>(c.number(3)) : 1,
                             .depth = dimensions > 2 ? static_cast<int>(c.number(4)) : 1,
                             .format = c.enumerant(2 + dimensions),
                             .type = c.enumerant(3 + dimensions),
                             .is_volume = dimensions == 3};
    const double internal = without_compression(c.number(1));
    const std::optional<InternalFormat> format = internal_format(internal);
    const int largest_side = source.is_volume ? kMax3dTextureSize : kMaxTextureSize;
    const auto fits = [&](int side) { return side >= 1 && side <= largest_side; };
    if (!target || !has_dimensions_of(c, target->texture) || !format || !fits(source.width) || !fits(source.height) ||
        !fits(source.depth) || !pixel_bytes(source.format, source.type))
        return;
    if (source.format == kGL_DEPTH_COMPONENT || format->base_format == kGL_DEPTH_COMPONENT)
        return note_lasting(fmt::format("{} of depths", c.name()), c.place);
    if (!c.memory) return raise(kGL_INVALID_OPERATION, c, "{} is given NULL; it needs an array of pixels", c.name());
    const int width = nearest_power(source.width), height = nearest_power(source.height),
              depth = nearest_power(source.depth);
    const bool is_scaled = width != source.width || height != source.height || depth != source.depth;
    // The images of this arithmetic need four times the memory.
    const double largest = std::max(static_cast<double>(width) * height * depth,
                                    static_cast<double>(source.width) * source.height * source.depth);
    if (!has_texels(c, 4 * largest)) return;
    const auto rows = pixels(c, source);
    if (!rows) return;
    // GLU scales the images first, and then glTexImage transfers each level by itself.
    if (!a_.pixel_transfer.is_initial()) note_lasting(fmt::format("{} with glPixelTransfer", c.name()), c.place);
    Pixels image{
        .width = source.width, .height = source.height, .depth = source.depth, .largest = largest_of(source.type)};
    image.rgba.reserve(static_cast<std::size_t>(static_cast<double>(source.width) * source.height * source.depth));
    std::vector<glm::dvec4> row;
    for (int z = 0; z < source.depth; ++z)
        for (int y = 0; y < source.height; ++y) {
            rows->unpack(y, row, z);
            image.rgba.insert(image.rgba.end(), row.begin(), row.end());
        }
    const Packed* const packed = find_packed(source.type);
    if (is_scaled && source.is_volume)
        image = scaled_volume(image, width, height, depth, source.type, packed ? packed->bits : std::array<int, 4>{});
    else if (is_scaled)
        image = scaled(image, width, height);
    Texture* texture = writable_texture(c, target->texture);
    if (!texture) return;
    textures_.texels -= texels_of(*texture);
    fill_levels(texture->face(target->face), std::move(image), *format, static_cast<Enum>(internal));
    textures_.texels += texels_of(*texture);
}

void State::texture_file(const Command& c) { build_mipmaps(*gl_command_of(c)); }

}  // namespace twinlight
