// The stipples of lines (3.4.2) and polygons (3.5.2), and logical operations (4.1.10).
#include <algorithm>

#include "scene/state/pixel_unpacking.h"
#include "scene/state/state.h"

namespace twinlight {

std::shared_ptr<const PolygonStipple> solid_stipple() {
    static const auto solid = [] {
        PolygonStipple bits;
        bits.fill(~0U);
        return std::make_shared<const PolygonStipple>(bits);
    }();
    return solid;
}

void State::line_stipple(const Command& c) {
    a_.line_stipple = {.factor = static_cast<int>(std::clamp(c.number(0), 1.0, 256.0)),
                       .pattern = static_cast<std::uint16_t>(c.enumerant(1))};
}

// Unpacked like a bitmap (3.6.4).
void State::polygon_stipple(const Command& c) {
    constexpr int kSide = 32;
    if (arrays_.pixel_unpack_buffer()) return note_lasting("glPolygonStipple from a buffer object", c.place);
    const std::size_t needed = bitmap_bytes(kSide, kSide, pixel_store_);
    const auto bytes = c.array();
    if (needed > bytes.size()) {
        return raise(kGL_INVALID_OPERATION, c,
                     "glPolygonStipple reads {} bytes with these glPixelStore values, but its array has {}", needed,
                     bytes.size());
    }
    std::vector<std::byte> memory;
    for (const double byte : bytes) memory.push_back(static_cast<std::byte>(byte));
    const std::vector<bool> bits = bitmap_bits(kSide, kSide, memory, pixel_store_);
    PolygonStipple stipple{};
    for (std::size_t i = 0; i < bits.size(); ++i) stipple[i / kSide] |= (bits[i] ? std::uint32_t{1} : 0U) << i % kSide;
    a_.polygon_stipple = std::make_shared<const PolygonStipple>(stipple);
}

void State::logic_op(const Command& c) {
    if (known(c, c.enumerant(0),
              {kGL_CLEAR, kGL_AND, kGL_AND_REVERSE, kGL_COPY, kGL_AND_INVERTED, kGL_NOOP, kGL_XOR, kGL_OR, kGL_NOR,
               kGL_EQUIV, kGL_INVERT, kGL_OR_REVERSE, kGL_COPY_INVERTED, kGL_OR_INVERTED, kGL_NAND, kGL_SET}))
        a_.logic_op = c.enumerant(0);
}

}  // namespace twinlight
