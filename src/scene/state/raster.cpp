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

// 3.3, 3.3.1, table 6.12.
void State::point_parameter(const Command& c) {
    const Enum pname = c.enumerant(0);
    const auto values = parameter_values(c, Owner::kPoint, pname);
    if (!values) return;
    PointParameters& parameters = a_.raster.point_parameters;
    const double value = values->front();
    switch (pname) {
        case kGL_POINT_SIZE_MIN: parameters.size_min = value; break;
        case kGL_POINT_SIZE_MAX: parameters.size_max = value; break;
        case kGL_POINT_FADE_THRESHOLD_SIZE: parameters.fade_threshold_size = value; break;
        case kGL_POINT_DISTANCE_ATTENUATION:
            parameters.distance_attenuation = {value, (*values)[1], (*values)[2]};
            break;
        default: {
            const auto origin = static_cast<Enum>(std::clamp(value, 0.0, 4294967295.0));
            if (known(c, origin, {kGL_LOWER_LEFT, kGL_UPPER_LEFT})) parameters.sprite_coord_origin = origin;
        }
    }
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
