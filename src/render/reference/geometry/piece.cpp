#include "render/reference/geometry/piece.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <optional>
#include <set>
#include <utility>

#include "render/reference/geometry/coverage.h"
#include "render/reference/geometry/surface_rays.h"

namespace twinlight::reference {

namespace {

// 2.11.1, for depths: z_w = scale z_d + offset.
struct DepthRange {
    explicit DepthRange(const RasterState& raster)
        : scale((raster.depth_far - raster.depth_near) / 2), offset((raster.depth_far + raster.depth_near) / 2) {}
    double scale, offset;
};

WindowVertex window_vertex(const RasterState& raster, const ClipVertex& v) {
    return {window_from_ndc(raster, glm::dvec3(v.position_clip) / v.position_clip.w), v.weights / v.position_clip.w};
}

constexpr double kSmallestSprite = 1e-6;  // in pixels; its texture coordinates change by 1 across it

// Twice the signed area in window coordinates, positive if counter-clockwise (2.14.1, equation 2.6).
double doubled_area(const std::vector<Corner>& corners) {
    double sum = 0;
    const glm::dvec2 origin = corners[0].position_window;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec2 a = corners[i].position_window - origin;
        const glm::dvec2 b = corners[(i + 1) % corners.size()].position_window - origin;
        sum += a.x * b.y - a.y * b.x;
    }
    return sum;
}

// Makes a clockwise polygon counter-clockwise; each edge keeps its origin.
void reverse(std::vector<Corner>& corners) {
    std::reverse(corners.begin(), corners.end());
    const EdgeOrigin first = corners[0].edge_to_next;
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) corners[i].edge_to_next = corners[i + 1].edge_to_next;
    corners.back().edge_to_next = first;
}

// M has the (x, y, w) of the three clip positions as columns. A point with weights b has M b = w (x_ndc, y_ndc, 1), so
// b / w = M^-1 (x_ndc, y_ndc, 1): linear in the window, whatever clipping removes (Olano and Greer, "Triangle scan
// conversion using 2D homogeneous coordinates", 1997). There are none if the triangle is seen edge on.
std::optional<Planes> planes_of(const RasterState& raster, const std::array<glm::dvec4, 3>& clip) {
    const Rectangle& viewport = raster.viewport;
    glm::dmat3 m;
    for (int i = 0; i < 3; ++i) m[i] = {clip[i].x, clip[i].y, clip[i].w};
    if (glm::determinant(m) == 0) return std::nullopt;
    Planes planes;
    const glm::dmat3 weights_from_ndc = glm::inverse(m);
    // ndc = scale * window + offset
    const glm::dvec2 scale(2.0 / viewport.width, 2.0 / viewport.height);
    const glm::dvec2 offset = -glm::dvec2(viewport.x, viewport.y) * scale - 1.0;
    glm::dvec3 z_over_w(0);
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 row(weights_from_ndc[0][i], weights_from_ndc[1][i], weights_from_ndc[2][i]);
        const glm::dvec3 plane(row.x * scale.x, row.y * scale.y, row.z + row.x * offset.x + row.y * offset.y);
        planes.weight_over_w[i] = plane;
        z_over_w += clip[i].z * plane;
    }
    const DepthRange depth(raster);
    planes.depth = depth.scale * z_over_w + glm::dvec3(0, 0, depth.offset);
    return planes;
}

double on_plane(const glm::dvec3& plane, const glm::dvec2& position_window) {
    return plane.x * position_window.x + plane.y * position_window.y + plane.z;
}

// The position along the line nearest to `position_window`, measured on its major axis: 0 at `from`, 1 at `to`.
double along(const Ends& line, const glm::dvec2& position_window) {
    const glm::dvec2 from(line.from.position_window), d = glm::dvec2(line.to.position_window) - from;
    const int major = std::abs(d.x) >= std::abs(d.y) ? 0 : 1;
    return d[major] == 0 ? 0 : std::clamp((position_window[major] - from[major]) / d[major], 0.0, 1.0);
}

// 3.4.2: the rectangle about the line. 3.3: the circle about the point, as a polygon of the same area. RULING: smaller
// sizes than 1 are 1, because 3.3 and 3.4 let the implementation choose the smallest.
std::vector<Corner> outline(const glm::dvec2& from, const glm::dvec2& to, double width) {
    const glm::dvec2 way = to - from;
    const double length = glm::length(way);
    if (length == 0) return {};
    const glm::dvec2 across = std::max(width, 1.0) / 2 / length * glm::dvec2(-way.y, way.x);
    return {{from - across}, {to - across}, {to + across}, {from + across}};
}
std::vector<Corner> outline(const glm::dvec2& centre, double size) {
    constexpr int kCorners = 48;
    const double step = 2 * M_PI / kCorners, radius = std::max(size, 1.0) / 2 * std::sqrt(step / std::sin(step));
    std::vector<Corner> corners;
    for (int i = 0; i < kCorners; ++i)
        corners.push_back({centre + radius * glm::dvec2(std::cos(i * step), std::sin(i * step))});
    return corners;
}

// The axis along which the line is longer: 0 is x.
int major_axis(const Ends& line) {
    const glm::dvec3 way = glm::abs(line.to.position_window - line.from.position_window);
    return way.x >= way.y ? 0 : 1;
}

// 1 if the line's fragments follow the axis, -1 if they go against it.
int direction_along(const Ends& line, int axis) {
    return line.from.position_window[axis] <= line.to.position_window[axis] ? 1 : -1;
}

// Whether a pixel's centre lies in the rectangle around the corners, or beside it by at most `border`.
bool is_near_a_centre(const std::vector<Corner>& corners, double border) {
    for (const int axis : {0, 1}) {
        const auto [low, high] =
            std::ranges::minmax(corners, {}, [&](const Corner& corner) { return corner.position_window[axis]; });
        if (std::ceil(low.position_window[axis] - border - 0.5) + 0.5 > high.position_window[axis] + border)
            return false;
    }
    return true;
}

constexpr PixelRect kEverywhere{-(1 << 24), -(1 << 24), 1 << 24, 1 << 24};

class PieceMaker {
  public:
    PieceMaker(const Draw& draw, std::uint32_t draw_index, std::span<const VertexPosition> positions,
               const Options& options, std::vector<Piece>& pieces)
        : draw_(draw),
          draw_index_(draw_index),
          positions_(positions),
          border_(options.border),
          keeps_what_lies_in_planes_(options.in_clip_plane == InClipPlane::kPerhaps),
          whole_volume_(draw.raster),
          volume_(whole_volume_),
          pieces_(pieces) {}

    void add(const Primitive& primitive) {
        if (!keeps_what_lies_in_planes_) return add_parts(primitive);
        std::array<ClipVertex, 3> vertices;
        const std::size_t count = count_of(primitive.shape);
        for (std::size_t i = 0; i < count; ++i) vertices[i] = vertex(primitive, static_cast<int>(i));
        const std::optional<ClipVolume> without = whole_volume_.without_planes_of({vertices.data(), count});
        if (!without) return add_parts(primitive);
        const std::size_t first = pieces_.size();
        volume_ = *without;
        add_parts(primitive);
        volume_ = whole_volume_;
        for (std::size_t i = first; i < pieces_.size(); ++i) pieces_[i].is_perhaps_clipped = true;
    }

  private:
    static std::size_t count_of(Shape shape) {
        switch (shape) {
            case Shape::kPoint: return 1;
            case Shape::kLine: return 2;
            case Shape::kTriangle: return 3;
            case Shape::kSurface: break;
        }
        return 0;
    }

    void add_parts(const Primitive& primitive) {
        switch (primitive.shape) {
            case Shape::kPoint: point(primitive, Face::kFront, vertex(primitive, 0)); break;
            case Shape::kLine: line(primitive, Face::kFront, vertex(primitive, 0), vertex(primitive, 1)); break;
            case Shape::kTriangle: triangle(primitive); break;
            case Shape::kSurface: break;
        }
    }

    ClipVertex vertex(const Primitive& primitive, int i) const {
        const VertexPosition& position = positions_[primitive.vertices[i]];
        ClipVertex v{.position_clip = position.position_clip, .position_eye = position.position_eye};
        v.weights[i] = 1;
        v.edge_to_next = primitive.boundary[i] ? EdgeOrigin::kBoundary : EdgeOrigin::kInner;
        return v;
    }

    Piece& append(const Primitive& primitive, Face face, Shape shape) {
        pieces_.push_back({.primitive = primitive, .face = face, .draw = draw_index_, .shape = shape});
        return pieces_.back();
    }

    void point(const Primitive& primitive, Face face, const ClipVertex& v, double depth_offset = 0) {
        if (!volume_.contains(v)) return;
        Piece& piece = append(primitive, face, Shape::kPoint);
        const double size = point_size(v);
        piece.size = whole_pixels(size);
        if (draw_.raster.point_sprite) piece.sprite_size = std::clamp(size, kSmallestSprite, kMaxPointSize);
        Ends ends{.from = window_vertex(draw_.raster, v)};
        ends.from.position_window.z += depth_offset;
        piece.place = ends;
        piece.is_smooth = draw_.raster.point_smooth;
        if (piece.is_smooth) piece.corners = Corners(outline(glm::dvec2(ends.from.position_window), size));
    }

    // 3.3: the size at a vertex.
    double point_size(const ClipVertex& v) const {
        const PointParameters& parameters = draw_.raster.point_parameters;
        const double distance =
            parameters.attenuates() ? glm::length(glm::dvec3(v.position_eye) / v.position_eye.w) : 0;
        return parameters.derived_size(draw_.raster.point_size, distance);
    }

    void line(const Primitive& primitive, Face face, const ClipVertex& from, const ClipVertex& to,
              double depth_offset = 0) {
        const std::vector<ClipVertex> ends = volume_.line(from, to);
        if (draw_.raster.line_stipple) begin_stipple(primitive, ends, from, to);
        if (ends.empty()) return;
        Piece& piece = append(primitive, face, Shape::kLine);
        piece.size = whole_pixels(draw_.raster.line_width);
        Ends placed{window_vertex(draw_.raster, ends[0]), window_vertex(draw_.raster, ends[1])};
        for (WindowVertex* end : {&placed.from, &placed.to}) end->position_window.z += depth_offset;
        piece.place = placed;
        if (draw_.raster.line_stipple) stipple(piece, placed);
        piece.is_smooth = draw_.raster.line_smooth;
        if (piece.is_smooth)
            piece.corners = Corners(outline(glm::dvec2(placed.from.position_window),
                                            glm::dvec2(placed.to.position_window), draw_.raster.line_width));
    }

    // Counts the line's fragments: those of a wide line as often as those of a line of width 1 (3.4.2.2).
    void stipple(Piece& piece, const Ends& ends) {
        const glm::dvec2 from(ends.from.position_window), to(ends.to.position_window);
        const PixelRect around = bounds(Corners({{from}, {to}}), kEverywhere, piece.size + 1);
        const std::vector<std::pair<int, int>> pixels = line_pixels(from, to, piece.size, around);
        const int axis = major_axis(ends);
        const int first = pixels.empty() ? 0 : axis == 0 ? pixels.front().first : pixels.front().second;
        piece.stipple_from = stipple_from_ - direction_along(ends, axis) * first;
        piece.stipple_doubt = static_cast<std::uint8_t>(stipple_doubt_);
        const int period = 16 * draw_.raster.line_stipple->factor;
        stipple_from_ = (stipple_from_ + static_cast<int>(pixels.size()) / piece.size) % period;
        // A driver that measures the line instead of counting its fragments differs by less than 1.
        stipple_doubt_ = std::min(stipple_doubt_ + 1, kAnyCount);
    }

    // 3.4.2: the count begins with each line of GL_LINES, and with each strip and loop.
    // RULING: only fragments inside the view count, and each polygon drawn as lines starts again. 3.4.2 says neither, so the
    // judge allows any count there. (If the first line of a strip is outside the view, Mesa continues the count of what it
    // drew before.) It allows any count for smooth lines too, because their fragments have no order.
    void begin_stipple(const Primitive& primitive, const std::vector<ClipVertex>& ends, const ClipVertex& from,
                       const ClipVertex& to) {
        const bool is_border = primitive.shape == Shape::kTriangle;
        const bool begins = is_border ? stippled_ != primitive.provoking : draw_.mode == kGL_LINES || !stippled_;
        stippled_ = primitive.provoking;
        if (begins) stipple_from_ = stipple_doubt_ = 0;
        const bool is_whole = ends.size() == 2 && ends[0].position_clip == from.position_clip &&
                              ends[1].position_clip == to.position_clip;
        if (!is_whole || is_border || draw_.raster.line_smooth) stipple_doubt_ = kAnyCount;
    }

    void triangle(const Primitive& primitive) {
        const RasterState& raster = draw_.raster;
        const std::array<ClipVertex, 3> whole = {vertex(primitive, 0), vertex(primitive, 1), vertex(primitive, 2)};
        const std::vector<ClipVertex> polygon = volume_.polygon(whole);
        if (polygon.size() < 3) return;
        std::vector<Corner> corners;
        corners.reserve(polygon.size());
        for (const ClipVertex& v : polygon)
            corners.push_back({glm::dvec2(window_vertex(raster, v).position_window), v.edge_to_next});

        // 2.14.1: a face with area <= 0 is a back face; GL_CW reverses the sign.
        const double area = doubled_area(corners);
        const Face face = (raster.front_face == kGL_CW ? -area : area) > 0 ? Face::kFront : Face::kBack;
        if (culled(raster, face)) return;
        const Enum mode = face == Face::kFront ? raster.polygon_mode_front : raster.polygon_mode_back;
        if (mode == kGL_FILL && !is_near_a_centre(corners, border_)) return;
        std::optional<Planes> planes =
            planes_of(raster, {whole[0].position_clip, whole[1].position_clip, whole[2].position_clip});
        // RULING: a polygon that is seen edge on has no slope, so its border is not offset.
        const double offset = polygon_offset(raster, mode, planes ? glm::dvec2(planes->depth) : glm::dvec2(0));
        if (mode == kGL_FILL) {
            if (!planes) return;
            planes->depth.z += offset;
            if (area < 0) reverse(corners);
            Piece& piece = append(primitive, face, Shape::kTriangle);
            piece.corners = Corners(corners);
            piece.place = *planes;
            return;
        }
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            if (polygon[i].edge_to_next == EdgeOrigin::kInner) continue;
            if (mode == kGL_LINE)
                line(primitive, face, polygon[i], polygon[(i + 1) % polygon.size()], offset);
            else
                point(primitive, face, polygon[i], offset);
        }
    }

    const Draw& draw_;
    const std::uint32_t draw_index_;
    const std::span<const VertexPosition> positions_;
    const double border_;
    const bool keeps_what_lies_in_planes_;
    const ClipVolume whole_volume_;
    ClipVolume volume_;  // what the primitive is clipped to
    std::vector<Piece>& pieces_;
    std::optional<std::uint32_t> stippled_;  // the provoking vertex of the last stippled line
    int stipple_from_ = 0, stipple_doubt_ = 0;
};

}  // namespace

// RULING: the implementation chooses the largest width and size; here they are llvmpipe's.
int whole_pixels(double width) { return static_cast<int>(std::clamp(std::floor(width + 0.5), 1.0, kMaxPointSize)); }

Corners::Corners(const std::vector<Corner>& corners) {
    if (corners.size() > kFew) {
        more_ = std::make_shared<const std::vector<Corner>>(corners);
        return;
    }
    for (const Corner& corner : corners) {
        positions_window_[count_] = corner.position_window;
        edges_[count_++] = corner.edge_to_next;
    }
}

bool operator==(const Corners& a, const Corners& b) {
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (a[i] != b[i]) return false;
    return true;
}

glm::dvec3 window_from_ndc(const RasterState& raster, const glm::dvec3& ndc) {
    const Rectangle& viewport = raster.viewport;
    const DepthRange depth(raster);
    return {(ndc.x + 1) * 0.5 * viewport.width + viewport.x, (ndc.y + 1) * 0.5 * viewport.height + viewport.y,
            ndc.z * depth.scale + depth.offset};
}

// o = m * factor + r * units, with m = max(|dz/dx|, |dz/dy|), which the specification allows instead of the length of
// the gradient.
double polygon_offset(const RasterState& raster, Enum mode, const glm::dvec2& slope) {
    const PolygonOffset& offset = raster.polygon_offset;
    if (!offset.is_enabled_for(mode)) return 0;
    return std::max(std::abs(slope.x), std::abs(slope.y)) * offset.factor + kDepthStep * offset.units;
}

bool culled(const RasterState& raster, Face face) {
    if (!raster.cull_enabled) return false;
    return raster.cull_face == kGL_FRONT_AND_BACK || (raster.cull_face == kGL_FRONT) == (face == Face::kFront);
}

void add_surface_pieces(const Draw& draw, std::uint32_t draw_index, std::vector<Piece>& pieces) {
    for (const Surface& surface : *draw.surfaces) {
        const auto rays = std::make_shared<const SurfaceRays>(draw, surface);
        for (int point = 0; point < rays->most_points(); ++point)
            pieces.push_back({.primitive = {.shape = Shape::kSurface},
                              .draw = draw_index,
                              .shape = Shape::kSurface,
                              .rays = rays,
                              .point = point});
    }
}

namespace {

// 3.6.4, 3.7: each vertex is drawn at its pixel.
void add_pixels(const Draw& draw, std::uint32_t draw_index, InClipPlane in_clip_plane, std::vector<Piece>& pieces,
                const CopyRanges* ranges) {
    const auto add = [&](const glm::ivec2& place, std::uint32_t vertex) -> Piece& {
        Piece piece{.primitive = {.shape = Shape::kPoint, .vertices = {vertex}, .provoking = vertex},
                    .draw = draw_index};
        piece.place = Ends{.from = {.position_window = {glm::dvec2(place) + 0.5, draw.pixels->depth(vertex)},
                                    .weights_over_w = {1, 0, 0}}};
        return pieces.emplace_back(std::move(piece));
    };
    // A pixel in doubt may also keep what was there before, so that nothing is certain there.
    std::set<std::pair<int, int>> in_doubt;
    if (in_clip_plane == InClipPlane::kPerhaps)
        for (const glm::ivec2& place : draw.pixels->doubtful) in_doubt.emplace(place.x, place.y);
    for (std::uint32_t i = 0; const glm::ivec2& place : draw.pixels->places) {
        if (!in_doubt.contains({place.x, place.y})) add(place, i);
        ++i;
    }
    if (in_clip_plane != InClipPlane::kPerhaps) return;
    for (const glm::ivec2& place : draw.pixels->doubtful) add(place, 0).is_perhaps_clipped = true;
    if (const CopyRanges::OfPixels* copied = CopyRanges::of(ranges, draw.pixels))
        for (const glm::ivec2& place : copied->doubtful) add(place, 0).is_perhaps_clipped = true;
}

}  // namespace

void add_pieces(const Draw& draw, std::uint32_t draw_index, std::span<const VertexPosition> positions,
                const Options& options, std::vector<Piece>& pieces, const CopyRanges* ranges) {
    if (draw.pixels) return add_pixels(draw, draw_index, options.in_clip_plane, pieces, ranges);
    if (draw.raster.viewport.width <= 0 || draw.raster.viewport.height <= 0) return;
    const std::vector<Primitive> primitives = assemble(draw, options.cut_of(draw_index));
    // A vector that grows while it is filled holds everything twice for a moment. Memory that nothing fills costs nothing.
    const std::size_t most = pieces.size() + primitives.size();
    if (most > pieces.capacity()) pieces.reserve(std::max(most, 2 * pieces.capacity()));
    PieceMaker maker(draw, draw_index, positions, options, pieces);
    for (const Primitive& primitive : primitives) maker.add(primitive);
}

int stipple_count(const Piece& line, int x, int y) {
    const int axis = major_axis(line.ends());
    return std::max(0, line.stipple_from + direction_along(line.ends(), axis) * (axis == 0 ? x : y));
}

double depth_at(const Piece& piece, const glm::dvec2& position_window) {
    if (piece.shape == Shape::kTriangle) return std::clamp(on_plane(piece.planes().depth, position_window), 0.0, 1.0);
    const Ends& ends = piece.ends();
    double depth = ends.from.position_window.z;
    if (piece.shape == Shape::kLine) depth += along(ends, position_window) * (ends.to.position_window.z - depth);
    return std::clamp(depth, 0.0, 1.0);
}

Linear3 weights_over_w_at(const Piece& piece, const glm::dvec2& position_window) {
    Linear3 result;
    if (piece.shape == Shape::kTriangle) {
        for (int i = 0; i < 3; ++i) {
            const glm::dvec3& plane = piece.planes().weight_over_w[i];
            result.value[i] = on_plane(plane, position_window);
            result.per_x[i] = plane.x;
            result.per_y[i] = plane.y;
        }
        return result;
    }
    const Ends& ends = piece.ends();
    result.value = ends.from.weights_over_w;
    if (piece.shape == Shape::kLine) {
        const glm::dvec3 whole = ends.to.weights_over_w - ends.from.weights_over_w;
        const double length = glm::distance(glm::dvec2(ends.from.position_window), glm::dvec2(ends.to.position_window));
        result.value += along(ends, position_window) * whole;
        if (length > 0) result.per_x = whole / length;
    }
    return result;
}

glm::dvec3 weights_at(const Piece& piece, const glm::dvec2& position_window) {
    const glm::dvec3 over_w = weights_over_w_at(piece, position_window).value;
    return over_w / (over_w.x + over_w.y + over_w.z);
}

}  // namespace twinlight::reference
