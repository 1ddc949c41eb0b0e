#include "render/webgl/webgl_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <utility>

#include "render/programmable/export/core_elements.h"
#include "render/reference/geometry/piece.h"

namespace twinlight::webgl {

namespace {

using programmable::Rectangles;
using reference::Piece, reference::Shape, reference::Face;

// More parts of one Draw would take long.
constexpr std::size_t kMostParts = 64;

// The first and the last vertex of a line or of a triangle's edge, or the vertex of a corner twice. Nothing for what clipping adds
// to polygons.
std::optional<std::pair<std::uint32_t, std::uint32_t>> ends_of(const Piece& piece) {
    const auto& v = piece.primitive.vertices;
    const glm::dvec3 from = piece.ends().from.weights_over_w, to = piece.ends().to.weights_over_w;
    if (piece.shape == Shape::kPoint) {
        for (int i = 0; i < 3; ++i)
            if (from[i] != 0 && from[(i + 1) % 3] == 0 && from[(i + 2) % 3] == 0)
                return std::pair(v[static_cast<std::size_t>(i)], v[static_cast<std::size_t>(i)]);
        return std::nullopt;
    }
    if (piece.primitive.shape == Shape::kLine) return std::pair(v[0], v[1]);
    for (int third = 0; third < 3; ++third)
        if (from[third] == 0 && to[third] == 0)
            return std::pair(v[static_cast<std::size_t>((third + 1) % 3)],
                             v[static_cast<std::size_t>((third + 2) % 3)]);
    return std::nullopt;
}

enum Kind : std::uint8_t { kFaces, kThinLines, kLines, kCorners, kSquares };

// An empty part.
Part part_for(const Draw& draw, Kind kind) {
    Part part;
    if (kind == kThinLines) part.mode = kGL_LINES;
    if (kind == kCorners) part.mode = kGL_POINTS;
    if (kind == kLines) part.rectangles = Rectangles::kLines;
    if (kind == kSquares) part.rectangles = Rectangles::kPoints;
    const bool is_point = kind == kCorners || kind == kSquares, is_wide_line = kind == kLines;
    part.counts = is_wide_line && draw.raster.line_stipple;
    part.is_smooth = is_point ? draw.raster.point_smooth : is_wide_line && draw.raster.line_smooth;
    return part;
}

// Whether a depth test decides what is seen, and not the order.
bool has_depths(const Draw& draw) {
    const RasterState& raster = draw.raster;
    const bool keeps_nearer = raster.depth_func == kGL_LESS || raster.depth_func == kGL_LEQUAL;
    return raster.depth_test && raster.depth_mask && keeps_nearer && !draw.fragment.blend && !draw.fragment.logic_op &&
           !draw.fragment.stencil;
}

class PartMaker {
  public:
    // in_order: a new part begins wherever the kind changes; else each kind has one part.
    PartMaker(const Draw& draw, const PartOptions& options, bool in_order)
        : draw_(draw), options_(options), in_order_(in_order), positions_(reference::vertex_positions(draw)) {}

    Parts made() {
        const reference::QuadCut cut =
            options_.flat ? reference::QuadCut::kSecondToFourth : reference::QuadCut::kFirstToThird;
        if (options_.for_any_pose && !draw_.draws_borders() && !draw_.raster.line_stipple) {
            for (const reference::Primitive& line : reference::assemble(draw_, cut))
                add_line({line.vertices[0], line.vertices[1]}, line.vertices[1], Face::kFront, 0, {});
            return std::move(made_);
        }
        std::vector<Piece> pieces;
        reference::Options options;
        options.quad_cut = cut;
        options.border = HUGE_VAL;  // small polygons, too: the page may be larger
        reference::add_pieces(draw_, 0, positions_, options, pieces);
        for (const Piece& piece : pieces)
            if (!has_too_many()) add(piece);
        return std::move(made_);
    }

  private:
    bool has_too_many() const { return made_.parts.size() > kMostParts; }

    // The part to which the next primitive of this kind belongs.
    Part& part(Kind kind) {
        const auto found = in_order_ ? (kinds_.empty() || kinds_.back() != kind ? kinds_.end() : kinds_.end() - 1)
                                     : std::ranges::find(kinds_, kind);
        if (found != kinds_.end()) return made_.parts[static_cast<std::size_t>(found - kinds_.begin())];
        kinds_.push_back(kind);
        return made_.parts.emplace_back(part_for(draw_, kind));
    }

    void add(const Piece& piece) {
        if (piece.shape == Shape::kTriangle) return add_face(piece.primitive);
        const auto ends = ends_of(piece);
        if (!ends) {
            made_.lacks_clipped = true;
            return;
        }
        const RasterState& raster = draw_.raster;
        const bool is_border = piece.primitive.shape == Shape::kTriangle;
        const bool needs_rectangle =
            is_border && ((piece.face == Face::kBack && options_.two_side) ||
                          raster.polygon_offset.is_enabled_for(piece.shape == Shape::kLine ? kGL_LINE : kGL_POINT));
        if (piece.shape == Shape::kLine) {
            if (needs_rectangle || piece.size > 1 || raster.line_stipple || raster.line_smooth)
                add_line(*ends, piece.primitive.provoking, piece.face, depth_offset(piece), count_of(piece));
            else
                for (const std::uint32_t end : {ends->first, ends->second})
                    add_vertex(part(kThinLines), end, piece.primitive.provoking);
        } else if (needs_rectangle && !raster.point_sprite && !raster.point_parameters.attenuates()) {
            add_square(piece, ends->first);
        } else {
            add_vertex(part(kCorners), ends->first, piece.primitive.provoking);
        }
    }

    void add_vertex(Part& to, std::uint32_t vertex, std::uint32_t provoking) const {
        if (!has_flat_edges()) return to.indices.push_back(vertex);
        to.indices.push_back(static_cast<std::uint32_t>(to.vertices.size()));
        add_corner(to, vertex, provoking);
    }
    void add_corner(Part& to, std::uint32_t vertex, std::uint32_t provoking) const {
        to.vertices.push_back(vertex);
        if (has_flat_edges()) to.colors_from.push_back(provoking);
    }
    // The last vertex of a line gives its colour anyway.
    bool has_flat_edges() const { return options_.flat_edges && draw_.draws_borders(); }

    // With the vertex last that gives a flat colour.
    void add_face(const reference::Primitive& primitive) {
        std::array<std::uint32_t, 3> corners = primitive.vertices;
        const auto provoking = std::ranges::find(corners, primitive.provoking);
        if (provoking != corners.end()) std::rotate(corners.begin(), provoking + 1, corners.end());
        std::vector<std::uint32_t>& indices = part(kFaces).indices;
        indices.insert(indices.end(), corners.begin(), corners.end());
    }

    // The fragment at (x, y) has the number dot(count, (x, y, 1)).
    std::vector<float> count_of(const Piece& piece) const {
        if (!draw_.raster.line_stipple) return {};
        const glm::dvec2 way(piece.ends().to.position_window - piece.ends().from.position_window);
        const int major = std::abs(way.x) >= std::abs(way.y) ? 0 : 1;
        // The reference counts from coordinate 0 of the line's longer axis.
        glm::vec3 count(0, 0, piece.stipple_from);
        count[major] = way[major] < 0 ? -1 : 1;
        return {count.x, count.y, count.z};
    }

    // The corners on the right and left of the line's start, then of its end.
    void add_line(const std::pair<std::uint32_t, std::uint32_t>& ends, std::uint32_t provoking, Face face, double depth,
                  const std::vector<float>& count) {
        Part& lines = part(kLines);
        const auto first = static_cast<std::uint32_t>(lines.vertices.size());
        for (const float end : {-1.0F, 1.0F})
            for (const float side : {-1.0F, 1.0F}) {
                add_corner(lines, end < 0 ? ends.first : ends.second, provoking);
                lines.others.push_back(end < 0 ? ends.second : ends.first);
                lines.corners.insert(lines.corners.end(), {end, side, static_cast<float>(depth * ndc_per_depth())});
                lines.corners.insert(lines.corners.end(), count.begin(), count.end());
            }
        add_rectangle(lines, first, face);
    }

    void add_square(const Piece& piece, std::uint32_t vertex) {
        Part& squares = part(kSquares);
        const auto first = static_cast<std::uint32_t>(squares.vertices.size());
        // Smooth points cover a part of the pixels around.
        const double half = draw_.raster.point_smooth ? piece.size / 2.0 + 1 : piece.size / 2.0;
        const glm::dvec2 ndc_per_pixel(2.0 / draw_.raster.viewport.width, 2.0 / draw_.raster.viewport.height);
        for (const double x : {-half, half})
            for (const double y : {-half, half}) {
                add_corner(squares, vertex, piece.primitive.provoking);
                const glm::vec3 corner(glm::dvec2(x, y) * ndc_per_pixel, depth_offset(piece) * ndc_per_depth());
                squares.corners.insert(squares.corners.end(), {corner.x, corner.y, corner.z});
            }
        add_rectangle(squares, first, piece.face);
    }

    // Two triangles that end with the last corner, which gives a flat colour. From the first corner to the third, the second is on
    // the left. They turn as their face does, so that gl_FrontFacing says which it is.
    void add_rectangle(Part& to, std::uint32_t first, Face face) const {
        const bool is_counter_clockwise = (face == Face::kFront) == (draw_.raster.front_face == kGL_CCW);
        using Order = std::array<std::uint32_t, 6>;
        for (const std::uint32_t corner : is_counter_clockwise ? Order{1, 0, 3, 0, 2, 3} : Order{0, 1, 3, 2, 0, 3})
            to.indices.push_back(first + corner);
    }

    double ndc_per_depth() const {
        const double depths = draw_.raster.depth_far - draw_.raster.depth_near;
        return depths == 0 ? 0 : 2 / depths;
    }

    // What polygon offset (3.5.5) has added to a border's window depths.
    double depth_offset(const Piece& piece) const {
        if (piece.primitive.shape != Shape::kTriangle) return 0;
        const reference::WindowVertex& from = piece.ends().from;
        glm::dvec3 ndc(0);
        for (int i = 0; i < 3; ++i)
            ndc += from.weights_over_w[i] *
                   glm::dvec3(positions_[piece.primitive.vertices[static_cast<std::size_t>(i)]].position_clip);
        return from.position_window.z - reference::window_from_ndc(draw_.raster, ndc).z;
    }

    const Draw& draw_;
    const PartOptions options_;
    const bool in_order_;
    const std::vector<reference::VertexPosition> positions_;
    Parts made_;
    std::vector<Kind> kinds_;  // of made_.parts
};

}  // namespace

Parts parts_of(const Draw& draw, const PartOptions& options) {
    const RasterState& raster = draw.raster;
    const bool has_rectangles = draw.draws_lines() && (reference::whole_pixels(raster.line_width) > 1 ||
                                                       raster.line_stipple || raster.line_smooth);
    if (draw.draws_borders() || has_rectangles) {
        const bool needs_order = !has_depths(draw);
        Parts made = PartMaker(draw, options, needs_order).made();
        if (made.parts.size() <= kMostParts) return made;
        made = PartMaker(draw, options, false).made();
        made.loses_order = true;
        return made;
    }
    auto [mode, indices] = programmable::core_elements(draw, options.flat);
    Part part{mode, std::move(indices)};
    part.is_smooth = mode == kGL_POINTS && raster.point_smooth;
    return {.parts = {std::move(part)}};
}

}  // namespace twinlight::webgl
