// Commands that only the driver supports. State notes them as unsupported if they can change the picture.
#include <fmt/format.h>

#include <algorithm>

#include "scene/state/pixel_unpacking.h"
#include "scene/state/state.h"

namespace twinlight {

// These set state that affects pictures only together with a capability or a command that is itself noted.
void State::driver_only_state(const Command&) {}
// The same, but also allowed between Begin and End: the indices of color index mode.
void State::driver_only_attribute(const Command&) {}

// A scene cannot use the results of queries, and only the driver knows all their names.
void State::driver_only_query(const Command&) {}

// These change the picture.
void State::driver_only_drawing(const Command& c) { note_unsupported(std::string(c.name()), c.place); }

// 3.6.3: scales and biases the pixels of every glTexImage.
void State::driver_only_pixel_transfer(const Command& c) {
    const Enum pname = c.enumerant(0);
    if (!known(c, pname,
               {kGL_MAP_COLOR, kGL_MAP_STENCIL, kGL_INDEX_SHIFT, kGL_INDEX_OFFSET, kGL_RED_SCALE, kGL_GREEN_SCALE,
                kGL_BLUE_SCALE, kGL_ALPHA_SCALE, kGL_DEPTH_SCALE, kGL_RED_BIAS, kGL_GREEN_BIAS, kGL_BLUE_BIAS,
                kGL_ALPHA_BIAS, kGL_DEPTH_BIAS}))
        return;
    const bool scales = pname == kGL_RED_SCALE || pname == kGL_GREEN_SCALE || pname == kGL_BLUE_SCALE ||
                        pname == kGL_ALPHA_SCALE || pname == kGL_DEPTH_SCALE;
    if (c.number(1) != (scales ? 1 : 0)) note_lasting(fmt::format("glPixelTransfer({})", enum_name(pname)), c.place);
}

// ---- Pixels ----

// Section 3.7. A bitmap without pixels only moves the raster position.
void State::driver_only_bitmap(const Command& c) {
    const int width = static_cast<int>(c.number(0)), height = static_cast<int>(c.number(1));
    if (width < 0 || height < 0)
        return raise(kGL_INVALID_VALUE, c, "glBitmap is given the size {} x {}; it cannot be negative", width, height);
    const std::size_t needed = bitmap_bytes(width, height, pixel_store_);
    if (needed == 0) return;
    const double there = c.memory ? static_cast<double>(c.memory->bytes.size()) - c.number(6) : 0;
    if (!arrays_.pixel_unpack_buffer() && static_cast<double>(needed) > there) {
        return raise(kGL_INVALID_OPERATION, c,
                     "glBitmap reads {} bytes, but its array has {}; check GL_UNPACK_ALIGNMENT, which is {}", needed,
                     there, pixel_store_.unpack_alignment);
    }
    driver_only_drawing(c);
}

// 4.2.1. There is one colour buffer, so all names but GL_NONE mean the same.
void State::draw_buffer(const Command& c) {
    const Enum mode = c.enumerant(0);
    if (!known(c, mode,
               {kGL_NONE, kGL_FRONT, kGL_BACK, kGL_LEFT, kGL_RIGHT, kGL_FRONT_AND_BACK, kGL_FRONT_LEFT, kGL_FRONT_RIGHT,
                kGL_BACK_LEFT, kGL_BACK_RIGHT}))
        return;
    a_.draws_color = mode != kGL_NONE;
}

}  // namespace twinlight
