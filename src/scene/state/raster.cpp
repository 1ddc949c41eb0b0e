// Facing, depth, polygon offset, widths, hints (2.11.1, 3.3 to 3.5, 4.1.6, 5.6).

#include <algorithm>

#include "scene/state/state.h"

namespace twinlight {

void State::front_face(const Command& c) {
    if (known(c, c.enumerant(0), {kGL_CW, kGL_CCW})) a_.raster.front_face = c.enumerant(0);
}

void State::cull_face(const Command& c) {
    if (known(c, c.enumerant(0), {kGL_FRONT, kGL_BACK, kGL_FRONT_AND_BACK})) a_.raster.cull_face = c.enumerant(0);
}

void State::polygon_mode(const Command& c) {
    const Enum face = c.enumerant(0), mode = c.enumerant(1);
    if (!known(c, face, {kGL_FRONT, kGL_BACK, kGL_FRONT_AND_BACK})) return;
    if (!known(c, mode, {kGL_POINT, kGL_LINE, kGL_FILL})) return;
    if (face != kGL_BACK) a_.raster.polygon_mode_front = mode;
    if (face != kGL_FRONT) a_.raster.polygon_mode_back = mode;
}

void State::depth_func(const Command& c) {
    if (known(c, c.enumerant(0),
              {kGL_NEVER, kGL_LESS, kGL_EQUAL, kGL_LEQUAL, kGL_GREATER, kGL_NOTEQUAL, kGL_GEQUAL, kGL_ALWAYS}))
        a_.raster.depth_func = c.enumerant(0);
}

void State::depth_mask(const Command& c) { a_.raster.depth_mask = c.number(0) != 0; }

void State::depth_range(const Command& c) {  // 2.11.1: both are clamped to [0,1]
    a_.raster.depth_near = std::clamp(c.number(0), 0.0, 1.0);
    a_.raster.depth_far = std::clamp(c.number(1), 0.0, 1.0);
}

void State::polygon_offset(const Command& c) {
    a_.raster.polygon_offset.factor = c.number(0);
    a_.raster.polygon_offset.units = c.number(1);
}

void State::line_width(const Command& c) {
    if (c.number(0) <= 0) return raise(kGL_INVALID_VALUE, c, "the line width is {}; it must be above 0", c.number(0));
    a_.raster.line_width = c.number(0);
}

void State::point_size(const Command& c) {
    if (c.number(0) <= 0) return raise(kGL_INVALID_VALUE, c, "the point size is {}; it must be above 0", c.number(0));
    a_.raster.point_size = c.number(0);
}

void State::edge_flag(const Command& c) { a_.current.edge_flag = c.number(0) != 0; }

void State::hint(const Command& c) {
    if (!known(c, c.enumerant(1), {kGL_FASTEST, kGL_NICEST, kGL_DONT_CARE})) return;
    if (const auto hint = a_.hints.find(c.enumerant(0)); hint != a_.hints.end()) {
        hint->second = c.enumerant(1);
        return;
    }
    raise(kGL_INVALID_ENUM, c, "glHint is given {}; expected GL_PERSPECTIVE_CORRECTION_HINT, GL_FOG_HINT, ...",
          enum_name(c.enumerant(0)));
}

void State::flush(const Command&) {}

}  // namespace twinlight
