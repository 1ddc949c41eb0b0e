#include "render/webgl/webgl_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <utility>

#include "render/programmable/kept/core_elements.h"
#include "render/reference/piece.h"

namespace twinlight::webgl {

namespace {

using reference::Piece, reference::Shape, reference::Face;

// The first and the last vertex of a line or of a triangle's edge, or the vertex of a corner twice. Nothing for what clipping adds
// to polygons, which Mesa does not draw either.
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

class PartMaker {
  public:
    PartMaker(const Draw& draw, bool two_side)
        : draw_(draw), two_side_(two_side), vertices_(reference::vertex_stage(draw)) {}

    std::vector<Part> made(reference::QuadCut cut) {
        std::vector<Piece> pieces;
        reference::Options options;
        options.quad_cut = cut;
        reference::add_pieces(draw_, 0, vertices_, options, pieces);
        lines_.counts = draw_.raster.line_stipple.has_value();
        lines_.shows_ends = std::ranges::any_of(pieces, is_clipped);
        for (const Piece& piece : pieces) add(piece);
        std::vector<Part> parts;
        for (Part* part : {&faces_, &thin_lines_, &lines_, &corners_, &squares_})
            if (!part->indices.empty()) parts.push_back(std::move(*part));
        return parts;
    }

  private:
    void add(const Piece& piece) {
        if (piece.shape == Shape::kTriangle) return add_face(piece.primitive);
        const auto ends = ends_of(piece);
        if (!ends) return;
        const RasterState& raster = draw_.raster;
        const bool is_border = piece.primitive.shape == Shape::kTriangle;
        const bool needs_rectangle =
            is_border && ((piece.face == Face::kBack && two_side_) ||
                          raster.polygon_offset.is_enabled_for(piece.shape == Shape::kLine ? kGL_LINE : kGL_POINT));
        if (piece.shape == Shape::kLine) {
            if (needs_rectangle || piece.size > 1 || raster.line_stipple)
                add_line(piece, *ends);
            else
                thin_lines_.indices.insert(thin_lines_.indices.end(), {ends->first, ends->second});
        } else if (needs_rectangle && !raster.point_sprite && !raster.point_parameters.attenuates()) {
            add_square(piece, ends->first);
        } else {
            corners_.indices.push_back(ends->first);
        }
    }

    // With the vertex last that gives a flat colour.
    void add_face(const reference::Primitive& primitive) {
        std::array<std::uint32_t, 3> corners = primitive.vertices;
        const auto provoking = std::ranges::find(corners, primitive.provoking);
        if (provoking != corners.end()) std::rotate(corners.begin(), provoking + 1, corners.end());
        faces_.indices.insert(faces_.indices.end(), corners.begin(), corners.end());
    }

    // 3.4.2.1: as many pixels across the line's longer axis as it is wide.
    void add_line(const Piece& piece, const std::pair<std::uint32_t, std::uint32_t>& ends) {
        const glm::dvec2 from(piece.ends().from.position_window), to(piece.ends().to.position_window), way = to - from;
        const int major = std::abs(way.x) >= std::abs(way.y) ? 0 : 1;
        glm::dvec2 across(0);
        across[1 - major] = piece.size / 2.0;
        const double direction = way[major] < 0 ? -1 : 1;
        const bool turns_left = (major == 0) == (direction > 0);
        std::vector<float> further;
        if (lines_.shows_ends)
            for (const double x : {from.x, from.y, to.x, to.y}) further.push_back(static_cast<float>(x));
        if (lines_.counts) {
            // The reference counts a line's fragments from coordinate 0 of its longer axis.
            glm::dvec3 count(0, 0, piece.stipple_from);
            count[major] = direction;
            for (int i = 0; i < 3; ++i) further.push_back(static_cast<float>(count[i]));
        }
        add_rectangle(lines_, piece,
                      {{{ends.first, -across}, {ends.first, across}, {ends.second, -across}, {ends.second, across}}},
                      turns_left, further);
    }

    static bool is_clipped(const Piece& piece) {
        const auto is_vertex = [](const glm::dvec3& weights) {
            return (weights.x != 0 ? 1 : 0) + (weights.y != 0 ? 1 : 0) + (weights.z != 0 ? 1 : 0) == 1;
        };
        return piece.shape == Shape::kLine &&
               (!is_vertex(piece.ends().from.weights_over_w) || !is_vertex(piece.ends().to.weights_over_w));
    }

    void add_square(const Piece& piece, std::uint32_t vertex) {
        const double half = piece.size / 2.0;
        add_rectangle(
            squares_, piece,
            {{{vertex, {-half, -half}}, {vertex, {-half, half}}, {vertex, {half, -half}}, {vertex, {half, half}}}},
            true, {});
    }

    struct RectangleCorner {
        std::uint32_t vertex;
        glm::dvec2 beside;  // in pixels
    };

    // Two triangles that end with the last corner, which gives a flat colour. turns_left: seen from the first corner toward the
    // third, the second is on the left.
    void add_rectangle(Part& part, const Piece& piece, const std::array<RectangleCorner, 4>& corners, bool turns_left,
                       const std::vector<float>& further) {
        const RasterState& raster = draw_.raster;
        const auto first = static_cast<std::uint32_t>(part.vertices.size());
        const double depths = raster.depth_far - raster.depth_near;
        const glm::dvec3 ndc_per_window(2.0 / raster.viewport.width, 2.0 / raster.viewport.height,
                                        depths == 0 ? 0 : 2 / depths);
        const double depth = depth_offset(piece);
        for (const RectangleCorner& corner : corners) {
            part.vertices.push_back(corner.vertex);
            const glm::dvec3 beside_ndc = glm::dvec3(corner.beside, depth) * ndc_per_window;
            for (int i = 0; i < 3; ++i) part.line_attributes.push_back(static_cast<float>(beside_ndc[i]));
            part.line_attributes.insert(part.line_attributes.end(), further.begin(), further.end());
        }
        // As its face, so that gl_FrontFacing says which it is.
        const bool is_counter_clockwise = (piece.face == Face::kFront) == (raster.front_face == kGL_CCW);
        const auto is_behind = [&](const RectangleCorner& corner) {
            return vertices_[corner.vertex].position_clip.w <= 0;
        };
        using Order = std::vector<std::uint32_t>;
        Order order = is_counter_clockwise == turns_left ? Order{1, 0, 3, 0, 2, 3} : Order{0, 1, 3, 2, 0, 3};
        // If one end is behind the eye, the sides cross there. Then one triangle with both corners of the other end covers the
        // visible part, and is_on_line() leaves out the rest.
        if (is_behind(corners[3])) order.resize(3);
        if (is_behind(corners[0])) order.erase(order.begin(), order.begin() + 3);
        for (const std::uint32_t corner : order) part.indices.push_back(first + corner);
    }

    // What polygon offset (3.5.5) has added to a border's window depths.
    double depth_offset(const Piece& piece) const {
        if (piece.primitive.shape != Shape::kTriangle) return 0;
        const reference::WindowVertex& from = piece.ends().from;
        glm::dvec3 ndc(0);
        for (int i = 0; i < 3; ++i)
            ndc += from.weights_over_w[i] *
                   glm::dvec3(vertices_[piece.primitive.vertices[static_cast<std::size_t>(i)]].position_clip);
        return from.position_window.z - reference::window_from_ndc(draw_.raster, ndc).z;
    }

    const Draw& draw_;
    const bool two_side_;
    const std::vector<reference::StageVertex> vertices_;
    Part faces_{kGL_TRIANGLES}, thin_lines_{kGL_LINES}, corners_{kGL_POINTS}, lines_{kGL_TRIANGLES},
        squares_{kGL_TRIANGLES};
};

}  // namespace

std::vector<Part> parts_of(const Draw& draw, bool flat, bool two_side) {
    constexpr double kWide = 1.5;  // rounds to 2 pixels (3.4.2.1)
    const bool has_rectangles = draw.draws_lines() && (draw.raster.line_width >= kWide || draw.raster.line_stipple);
    if (draw.draws_borders() || has_rectangles)
        return PartMaker(draw, two_side)
            .made(flat ? reference::QuadCut::kSecondToFourth : reference::QuadCut::kFirstToThird);
    auto [mode, indices] = programmable::core_elements(draw, flat);
    return {{mode, std::move(indices)}};
}

}  // namespace twinlight::webgl
