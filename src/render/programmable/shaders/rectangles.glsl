// Functions for lines and points that OpenGL ES lacks: wide, stippled and smooth ones, drawn as rectangles.

// The place in the window of a position in clip coordinates (GL 2.1, section 2.11.1).
vec2 in_window(vec4 clip, vec4 viewport) {
    return (0.5 * clip.xy / clip.w + 0.5) * viewport.zw + viewport.xy;
}

// The part of a line where a value that changes linearly is not negative (section 2.12). part.x and part.y: where the part before
// begins and ends, from 0 to 1. Nothing is left if part.x > part.y.
vec2 clipped_part(vec2 part, float from, float to) {
    if (from < 0.0 && to < 0.0) return vec2(1.0, 0.0);
    if (from < 0.0) part.x = max(part.x, from / (from - to));
    if (to < 0.0) part.y = min(part.y, from / (from - to));
    return part;
}

// The part of a line that is inside the view volume.
vec2 part_in_view(vec4 from_clip, vec4 to_clip) {
    vec2 part = vec2(0.0, 1.0);
    for (int i = 0; i < 3; ++i) {
        part = clipped_part(part, from_clip.w - from_clip[i], to_clip.w - to_clip[i]);
        part = clipped_part(part, from_clip.w + from_clip[i], to_clip.w + to_clip[i]);
    }
    return part;
}

// Whether the line from `ends.xy` to `ends.zw` is wider than high. Where it is nearly as wide, floats do not decide.
bool is_wider(vec4 ends) {
    vec2 way = abs(ends.zw - ends.xy);
    return way.x >= 0.99999 * way.y;
}

// From the line's end to a corner of its rectangle (section 3.4.2.1), in pixels: corner.y is 1 on the line's left, -1 on its right.
vec2 beside_line(vec4 ends, vec2 corner, float width) {
    vec2 way = ends.zw - ends.xy;
    float beside = 0.5 * width * corner.y;
    return is_wider(ends) ? vec2(0.0, way.x < 0.0 ? -beside : beside) : vec2(way.y < 0.0 ? beside : -beside, 0.0);
}

// The same for a smooth line (section 3.4.2), with room for all pixels that it covers in part. corner.x is -1 at the line's start, 1 at its end.
vec2 beside_smooth_line(vec4 ends, vec2 corner, float width) {
    vec2 way = ends.zw - ends.xy, dir = way / max(length(way), 1e-6);
    return corner.x * dir + (0.5 * max(width, 1.0) + 1.0) * corner.y * vec2(-dir.y, dir.x);
}

// Whether a pixel's centre is on a line of this width (section 3.4.2.1): the width is measured along y if the line is wider than
// high, else along x. Where the rectangle has a side, the rasteriser decides: that is rounding's part here.
bool is_on_line(vec4 ends, vec2 centre, float width) {
    const float rounding = 1.0 / 64.0;
    vec2 way = ends.zw - ends.xy, from_start = centre - ends.xy;
    if (!is_wider(ends)) {
        way = way.yx;
        from_start = from_start.yx;
    }
    float along = from_start.x * sign(way.x), across = from_start.y - from_start.x * way.y / way.x;
    return along >= -rounding && along <= abs(way.x) + rounding && abs(across) <= 0.5 * width + rounding;
}

// The integral of clamp(y, 0, 1).
float clamped_sum(float y) {
    float within = clamp(y, 0.0, 1.0);
    return 0.5 * within * within + max(y - 1.0, 0.0);
}

// The part of the square from (0, 0) to (1, 1) below an edge, negative if the edge leads to the left.
float part_below(vec2 from, vec2 to) {
    float x0 = clamp(from.x, 0.0, 1.0), x1 = clamp(to.x, 0.0, 1.0);
    if (x0 == x1) return 0.0;
    float slope = (to.y - from.y) / (to.x - from.x), y0 = from.y + (x0 - from.x) * slope, y1 = from.y + (x1 - from.x) * slope;
    // Where y hardly changes, the difference of the integrals has no digits.
    const float hardly = 1e-3;
    float mean = abs(y1 - y0) < hardly ? clamp(0.5 * (y0 + y1), 0.0, 1.0) : (clamped_sum(y1) - clamped_sum(y0)) / (y1 - y0);
    return (x1 - x0) * mean;
}

// The share of a pixel's square that a smooth line covers (section 3.4.2). pixel: the square's lower left corner.
float line_coverage(vec4 ends, float width, vec2 pixel) {
    vec2 way = ends.zw - ends.xy, from = ends.xy - pixel, to = ends.zw - pixel;
    float size = length(way);
    if (size == 0.0) return 0.0;
    vec2 across = 0.5 * max(width, 1.0) / size * vec2(-way.y, way.x);
    float share = part_below(from - across, to - across) + part_below(to - across, to + across) +
                  part_below(to + across, from + across) + part_below(from + across, from - across);
    return clamp(-share, 0.0, 1.0);
}

// The same for a smooth point (section 3.3), whose circle is a polygon of the same area.
float point_coverage(vec2 centre, float size, vec2 pixel) {
    const int corners = 48;
    const float turn = 6.2831853 / float(corners);
    float radius = 0.5 * max(size, 1.0) * sqrt(turn / sin(turn)), share = 0.0;
    vec2 from = centre - pixel + vec2(radius, 0.0);
    for (int i = 1; i <= corners; ++i) {
        vec2 to = centre - pixel + radius * vec2(cos(turn * float(i)), sin(turn * float(i)));
        share += part_below(from, to);
        from = to;
    }
    return clamp(-share, 0.0, 1.0);
}
