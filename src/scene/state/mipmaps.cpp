// gluBuild1DMipmaps to gluBuild3DMipmaps, with the arithmetic of libglu 9.0.2 (libutil/mipmap.c), which computes in
// the type of the pixels.

#include <algorithm>
#include <cmath>

#include "scene/shape/written_out.h"
#include "scene/state/pixel_unpacking.h"
#include "scene/state/state.h"

namespace twinlight {

namespace {

// An RGBA image. For a whole-number type `largest` is the number that means 1; for other types it is 0.
struct Pixels {
    int width = 0, height = 0, depth = 1;
    std::vector<glm::dvec4> rgba{};
    double largest = 0;

    const glm::dvec4& at(int x, int y, int z = 0) const {
        const std::size_t row =
            static_cast<std::size_t>(z) * static_cast<std::size_t>(height) + static_cast<std::size_t>(y);
        return rgba[row * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    }
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
    const std::optional<InternalFormat> format = internal_format(c.number(1));
    const int largest_side = source.is_volume ? kMax3dTextureSize : kMaxTextureSize;
    const auto fits = [&](int side) { return side >= 1 && side <= largest_side; };
    if (!target || !has_dimensions_of(c, target->texture) || !format || !fits(source.width) || !fits(source.height) ||
        !fits(source.depth) || !pixel_bytes(source.format, source.type))
        return;
    if (source.format == kGL_DEPTH_COMPONENT || format->base_format == kGL_DEPTH_COMPONENT)
        return note_lasting(fmt::format("{} of depths", c.name()), c.place);
    if (!c.memory) return raise(kGL_INVALID_OPERATION, c, "{} is given NULL; it needs an array of pixels", c.name());
    const int width = nearest_power(source.width), height = nearest_power(source.height);
    const bool is_scaled =
        width != source.width || height != source.height || nearest_power(source.depth) != source.depth;
    if (source.is_volume && is_scaled)
        return note_lasting(fmt::format("{} with a side that is not a power of 2", c.name()), c.place);
    // The images of this arithmetic need four times the memory.
    const double largest =
        std::max(static_cast<double>(width) * height, static_cast<double>(source.width) * source.height) * source.depth;
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
    if (is_scaled) image = scaled(image, width, height);
    Texture* texture = writable_texture(c, target->texture);
    if (!texture) return;
    textures_.texels -= texels_of(*texture);
    fill_levels(texture->face(target->face), std::move(image), *format, static_cast<Enum>(c.number(1)));
    textures_.texels += texels_of(*texture);
}

void State::texture_file(const Command& c) { build_mipmaps(*gl_command_of(c)); }

}  // namespace twinlight
