#include "scene/state/pixel_unpacking.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "scene/state/packed_types.h"

namespace twinlight {

namespace {

// ---- Types (tables 3.5 and 3.8) ----

std::optional<int> element_bytes(Enum type) {
    switch (type) {
        case kGL_BYTE:
        case kGL_UNSIGNED_BYTE: return 1;
        case kGL_SHORT:
        case kGL_UNSIGNED_SHORT: return 2;
        case kGL_INT:
        case kGL_UNSIGNED_INT:
        case kGL_FLOAT: return 4;
        default: return std::nullopt;
    }
}

// The unsigned number of `size` bytes at `at`, in this machine's byte order; in the other order if `swapped`.
std::uint32_t number_at(const std::byte* at, int size, bool swapped) {
    std::uint32_t value = 0;
    for (int i = 0; i < size; ++i) {
        const bool low_first = (std::endian::native == std::endian::little) != swapped;
        const int shift = 8 * (low_first ? i : size - 1 - i);
        value |= std::to_integer<std::uint32_t>(at[i]) << shift;
    }
    return value;
}

// Table 2.9: whole numbers as [0,1] or [-1,1].
double element_at(const std::byte* at, Enum type, bool swapped) {
    const auto from_signed = [](double c, int bits) { return (2 * c + 1) / (std::exp2(bits) - 1); };
    const std::uint32_t raw = number_at(at, *element_bytes(type), swapped);
    switch (type) {
        case kGL_UNSIGNED_BYTE: return raw / 255.0;
        case kGL_BYTE: return from_signed(static_cast<std::int8_t>(raw), 8);
        case kGL_UNSIGNED_SHORT: return raw / 65535.0;
        case kGL_SHORT: return from_signed(static_cast<std::int16_t>(raw), 16);
        case kGL_UNSIGNED_INT: return raw / 4294967295.0;
        case kGL_INT: return from_signed(static_cast<std::int32_t>(raw), 32);
        default: return static_cast<double>(std::bit_cast<float>(raw));
    }
}

// The values of one pixel, in the order of its format.
void read_pixel(const std::byte* at, Enum type, int count, bool swapped, double* values) {
    if (const Packed* packed = find_packed(type)) {
        const std::uint32_t raw = number_at(at, packed->bytes, swapped);
        int shift = packed->reversed ? 0 : 8 * packed->bytes;
        for (int i = 0; i < count; ++i) {
            const int bits = packed->bits[i];
            if (!packed->reversed) shift -= bits;
            const std::uint32_t largest = (1u << bits) - 1;
            values[i] = ((raw >> shift) & largest) / static_cast<double>(largest);
            if (packed->reversed) shift += bits;
        }
        return;
    }
    const int size = *element_bytes(type);
    for (int i = 0; i < count; ++i) values[i] = element_at(at + i * size, type, swapped);
}

// 3.6.4, "Conversion to RGB" and "Final expansion to RGBA".
glm::dvec4 rgba(Enum format, const double* v) {
    switch (format) {
        case kGL_RED: return {v[0], 0, 0, 1};
        case kGL_GREEN: return {0, v[0], 0, 1};
        case kGL_BLUE: return {0, 0, v[0], 1};
        case kGL_ALPHA: return {0, 0, 0, v[0]};
        case kGL_RGB: return {v[0], v[1], v[2], 1};
        case kGL_BGR: return {v[2], v[1], v[0], 1};
        case kGL_RGBA: return {v[0], v[1], v[2], v[3]};
        case kGL_BGRA: return {v[2], v[1], v[0], v[3]};
        case kGL_LUMINANCE:
        case kGL_DEPTH_COMPONENT: return {v[0], v[0], v[0], 1};
        default: return {v[0], v[0], v[0], v[1]};  // GL_LUMINANCE_ALPHA
    }
}

std::size_t row_pixels(const PixelSource& source, const PixelStore& store) {
    return static_cast<std::size_t>(store.unpack_row_length > 0 ? store.unpack_row_length : source.width);
}

// 3.6.4, formula 3.13: the bytes from one row to the next. Packed types count as one element.
std::size_t row_bytes(const PixelSource& source, const PixelStore& store) {
    const auto bytes = static_cast<std::size_t>(*pixel_bytes(source.format, source.type)) * row_pixels(source, store);
    const auto alignment = static_cast<std::size_t>(store.unpack_alignment);
    return (bytes + alignment - 1) / alignment * alignment;
}

// 3.8.1: the rows from the pointer to image z.
double rows_before(const PixelSource& source, const PixelStore& store, int z) {
    if (!source.is_volume) return 0;
    const int height = store.unpack_image_height > 0 ? store.unpack_image_height : source.height;
    return (static_cast<double>(store.unpack_skip_images) + z) * height;
}

}  // namespace

glm::dvec4 transferred(glm::dvec4 color, const PixelTransfer& transfer, const PixelMaps* maps) {
    if (transfer.is_initial()) return color;
    color = color * transfer.scale + transfer.bias;
    for (int i = 0; transfer.map_color && i < 4; ++i) {
        const std::vector<double>& map = maps->at(static_cast<std::size_t>(i));
        const double inside = color[i] > 0 ? std::min(color[i], 1.0) : 0;
        color[i] = map[static_cast<std::size_t>(std::floor(inside * static_cast<double>(map.size() - 1) + 0.5))];
    }
    return color;
}

std::optional<int> components_of(Enum format) {
    switch (format) {
        case kGL_RED:
        case kGL_GREEN:
        case kGL_BLUE:
        case kGL_ALPHA:
        case kGL_LUMINANCE:
        case kGL_DEPTH_COMPONENT: return 1;
        case kGL_LUMINANCE_ALPHA: return 2;
        case kGL_RGB:
        case kGL_BGR: return 3;
        case kGL_RGBA:
        case kGL_BGRA: return 4;
        default: return std::nullopt;
    }
}

std::optional<int> pixel_bytes(Enum format, Enum type) {
    const std::optional<int> components = components_of(format);
    if (!components) return std::nullopt;
    if (const Packed* packed = find_packed(type)) {
        const bool fits = packed->bits[3] == 0 ? format == kGL_RGB : *components == 4;
        return fits ? std::optional(packed->bytes) : std::nullopt;
    }
    const std::optional<int> element = element_bytes(type);
    return element ? std::optional(*element * *components) : std::nullopt;
}

namespace {

// The bytes from one row of a bitmap to the next (3.7).
std::size_t bitmap_row_bytes(int width, const PixelStore& store) {
    const auto alignment = static_cast<std::size_t>(store.unpack_alignment), bits_of_unit = 8 * alignment;
    const auto pixels = static_cast<std::size_t>(store.unpack_row_length > 0 ? store.unpack_row_length : width);
    return (pixels + bits_of_unit - 1) / bits_of_unit * alignment;
}

}  // namespace

std::size_t bitmap_bytes(int width, int height, const PixelStore& store) {
    if (width <= 0 || height <= 0) return 0;
    const auto at_least_0 = [](int value) { return static_cast<std::size_t>(std::max(0, value)); };
    const std::size_t rows = at_least_0(store.unpack_skip_rows) + at_least_0(height) - 1;
    return rows * bitmap_row_bytes(width, store) + (at_least_0(store.unpack_skip_pixels) + at_least_0(width) + 7) / 8;
}

std::vector<bool> bitmap_bits(int width, int height, std::span<const std::byte> bytes, const PixelStore& store) {
    const auto whole = [](int number) { return static_cast<std::size_t>(number); };
    const std::size_t row_size = bitmap_row_bytes(width, store);
    std::vector<bool> bits;
    bits.reserve(whole(width) * whole(height));
    for (std::size_t y = 0; y < whole(height); ++y)
        for (std::size_t x = 0; x < whole(width); ++x) {
            const std::size_t bit = whole(store.unpack_skip_pixels) + x;
            const auto byte =
                std::to_integer<unsigned>(bytes[(whole(store.unpack_skip_rows) + y) * row_size + bit / 8]);
            bits.push_back((byte >> (store.unpack_lsb_first ? bit % 8 : 7 - bit % 8) & 1U) != 0);
        }
    return bits;
}

std::vector<std::int64_t> stencil_values(const PixelSource& source, const PixelStore& store,
                                         std::span<const std::byte> bytes) {
    std::vector<std::int64_t> values;
    const auto size = static_cast<std::size_t>(*element_bytes(source.type));
    const auto value_at = [&](const std::byte* at) -> std::int64_t {
        const std::uint32_t raw = number_at(at, static_cast<int>(size), store.unpack_swap_bytes);
        switch (source.type) {
            case kGL_BYTE: return static_cast<std::int8_t>(raw);
            case kGL_SHORT: return static_cast<std::int16_t>(raw);
            case kGL_INT: return static_cast<std::int32_t>(raw);
            case kGL_FLOAT: {
                const auto number = static_cast<double>(std::bit_cast<float>(raw));
                return std::abs(number) < 0x1p62 ? static_cast<std::int64_t>(std::floor(number)) : 0;
            }
            default: return raw;
        }
    };
    for (int y = 0; y < source.height; ++y)
        for (int x = 0; x < source.width; ++x) {
            const auto row = static_cast<std::size_t>(store.unpack_skip_rows + y),
                       column = static_cast<std::size_t>(store.unpack_skip_pixels + x);
            values.push_back(value_at(bytes.data() + row * row_bytes(source, store) + column * size));
        }
    return values;
}

std::size_t bytes_read(const PixelSource& source, const PixelStore& store) {
    if (source.width <= 0 || source.height <= 0 || source.depth <= 0) return 0;
    const auto pixel = static_cast<std::size_t>(*pixel_bytes(source.format, source.type));
    const double rows =
        rows_before(source, store, source.depth - 1) + static_cast<double>(store.unpack_skip_rows) + source.height - 1;
    const auto pixels = static_cast<std::size_t>(store.unpack_skip_pixels) + static_cast<std::size_t>(source.width);
    // There may be 2^63 rows of 2^35 bytes. A double is exact for all sizes that fit into memory.
    const double bytes =
        rows * static_cast<double>(row_bytes(source, store)) + static_cast<double>(pixels) * static_cast<double>(pixel);
    return bytes < 0x1p53 ? static_cast<std::size_t>(bytes) : std::numeric_limits<std::size_t>::max();
}

void PixelRows::unpack(int y, std::vector<glm::dvec4>& row, int z) const {
    row.assign(static_cast<std::size_t>(source.width), glm::dvec4(0));
    if (!bytes.data()) return;
    const int components = *components_of(source.format);
    const auto pixel = static_cast<std::size_t>(*pixel_bytes(source.format, source.type));
    const auto rows = static_cast<std::size_t>(rows_before(source, store, z)) +
                      static_cast<std::size_t>(store.unpack_skip_rows) + static_cast<std::size_t>(y);
    const std::byte* at =
        bytes.data() + rows * row_bytes(source, store) + static_cast<std::size_t>(store.unpack_skip_pixels) * pixel;
    for (glm::dvec4& texel : row) {
        double values[4] = {};
        read_pixel(at, source.type, components, store.unpack_swap_bytes, values);
        const glm::dvec4 color = rgba(source.format, values);
        texel = source.format == kGL_DEPTH_COMPONENT
                    ? glm::dvec4(glm::dvec3(color * transfer.depth_scale + transfer.depth_bias), 1)
                    : transferred(color, transfer, maps);
        at += pixel;
    }
}

}  // namespace twinlight
