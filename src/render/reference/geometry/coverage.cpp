#include "render/reference/geometry/coverage.h"

#include <glm/common.hpp>

namespace twinlight::reference {

namespace {

// In pixels. Where an edge meets two clipping planes at once, rounding leaves an edge of length 0 with a random
// direction.
constexpr double kShortestEdge = 1e-9;

int floor_to_pixel(double x) { return static_cast<int>(std::floor(std::clamp(x, -1e9, 1e9))); }
int ceil_to_pixel(double x) { return static_cast<int>(std::ceil(std::clamp(x, -1e9, 1e9))); }

// The pixel column of a coordinate slightly smaller than x: 3.4.1 moves every line by (-e, -e^2).
int pixel_below(double x) { return ceil_to_pixel(x) - 1; }

// Whether a point, moved by (-e, -e^2), lies in the diamond of its pixel.
bool in_diamond(const glm::dvec2& p, int x, int y) {
    const glm::dvec2 d = p - pixel_centre(x, y);
    const double distance = std::abs(d.x) + std::abs(d.y);
    return distance < 0.5 || (distance == 0.5 && d.x > 0);
}

}  // namespace

PixelRect bounds(const Corners& polygon, const PixelRect& within, double margin) {
    glm::dvec2 low = polygon.position_window(0), high = low;
    for (std::size_t i = 1; i < polygon.size(); ++i) {
        const glm::dvec2 corner = polygon.position_window(i);
        low = {std::min(low.x, corner.x), std::min(low.y, corner.y)};
        high = {std::max(high.x, corner.x), std::max(high.y, corner.y)};
    }
    return {std::max(within.x0, floor_to_pixel(low.x - margin)), std::max(within.y0, floor_to_pixel(low.y - margin)),
            std::min(within.x1, floor_to_pixel(high.x + margin) + 1),
            std::min(within.y1, floor_to_pixel(high.y + margin) + 1)};
}

PixelRect bounds(const SurfaceRays& rays, const PixelRect& within) {
    const glm::dvec2 low = rays.low_window(), high = rays.high_window();
    return {std::max(within.x0, floor_to_pixel(low.x)), std::max(within.y0, floor_to_pixel(low.y)),
            std::min(within.x1, floor_to_pixel(high.x) + 1), std::min(within.y1, floor_to_pixel(high.y) + 1)};
}

PixelRect reach_of(const Piece& piece, const PixelRect& within) {
    constexpr double kNeighbours = 2;  // beside lines and points (allowed_difference.cpp)
    switch (piece.shape) {
        case Shape::kPoint:
        case Shape::kLine: {
            const Ends& ends = piece.ends();
            const Corner from{glm::dvec2(ends.from.position_window)}, to{glm::dvec2(ends.to.position_window)};
            return bounds(Corners({from, piece.shape == Shape::kLine ? to : from}), within, piece.size + kNeighbours);
        }
        case Shape::kTriangle: return bounds(piece.corners, within, 1);
        case Shape::kSurface: break;
    }
    return within;
}

PixelRows rows_of(const Piece& piece, double border) {
    constexpr int kFar = 1 << 24;
    const PixelRect reach = reach_of(piece, {-kFar, -kFar, kFar, kFar});
    const int beside = ceil_to_pixel(border) + 1;  // and the third neighbour of lines and points
    return {reach.y0 - beside, reach.y1 + beside};
}

Edge::Edge(const Corner& from, const Corner& to) : origin_(from.edge_to_next) {
    const glm::dvec2 a = from.position_window, b = to.position_window;
    const bool forward = a.x < b.x || (a.x == b.x && a.y < b.y);
    start_ = forward ? a : b;
    way_ = forward ? b - a : a - b;
    sign_ = forward ? 1 : -1;
    const glm::dvec2 direction = b - a;
    owns_centres_ = direction.y < 0 || (direction.y == 0 && direction.x > 0);
}

std::vector<Edge> edges_of(const Corners& polygon) {
    std::vector<Edge> edges;
    edges.reserve(polygon.size());
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Corner from = polygon[i], to = polygon[i + 1 < polygon.size() ? i + 1 : 0];
        const glm::dvec2 way = glm::abs(to.position_window - from.position_window);
        if (way.x > kShortestEdge || way.y > kShortestEdge) edges.emplace_back(from, to);
    }
    return edges;
}

// 3.4.1, and 3.4.2.1 for other widths: the line is moved down (or left, if it is higher than wide) by (width - 1) / 2,
// and each fragment of the moved line is the lowest (leftmost) of `width` fragments.
//
// A line that is wider than high covers one pixel per column: where it crosses the column's centre line, it is inside
// that pixel's diamond. The ends need care: the line also leaves the diamond that it starts in, and does not leave the
// diamond that it ends in. For a line that is higher than wide, x and y are exchanged.
std::vector<std::pair<int, int>> line_pixels(const glm::dvec2& from_given, const glm::dvec2& to_given, int width,
                                             const PixelRect& within) {
    const glm::dvec2 d = to_given - from_given;
    const int major = std::abs(d.x) >= std::abs(d.y) ? 0 : 1, minor = 1 - major;
    if (d[major] == 0) return {};
    glm::dvec2 from_window = from_given, to_window = to_given;
    for (glm::dvec2* end : {&from_window, &to_window}) (*end)[minor] -= (width - 1) / 2.0;
    const double slope = d[minor] / d[major];
    const auto pixel_at = [&](int step) {  // where the line crosses the centre of the column (row)
        const double at = from_window[minor] + (step + 0.5 - from_window[major]) * slope;
        // On a border the shift by (-e, -e^2) decides; for a rising line -e outweighs -e^2.
        const bool rising = major == 0 && slope > 0;
        const int across = rising ? floor_to_pixel(at) : pixel_below(at);
        return major == 0 ? std::pair(step, across) : std::pair(across, step);
    };

    const double low = std::min(from_window[major], to_window[major]);
    const double high = std::max(from_window[major], to_window[major]);
    const int first_visible = major == 0 ? within.x0 : within.y0, end_visible = major == 0 ? within.x1 : within.y1;
    std::vector<std::pair<int, int>> pixels;
    for (int step = std::max(first_visible, ceil_to_pixel(low - 0.5)); step < end_visible && step + 0.5 < high; ++step)
        pixels.push_back(pixel_at(step));
    if (d[major] < 0) std::reverse(pixels.begin(), pixels.end());

    const std::pair start(pixel_below(from_window.x), pixel_below(from_window.y));
    const std::pair end(pixel_below(to_window.x), pixel_below(to_window.y));
    const bool ends_in_diamond = in_diamond(to_window, end.first, end.second);
    if (in_diamond(from_window, start.first, start.second) && (pixels.empty() || pixels.front() != start))
        pixels.insert(pixels.begin(), start);
    if (ends_in_diamond && !pixels.empty() && pixels.back() == end) pixels.pop_back();

    std::vector<std::pair<int, int>> seen;
    seen.reserve(pixels.size());
    const int low_across = major == 0 ? within.y0 : within.x0, high_across = major == 0 ? within.y1 : within.x1;
    for (const auto& [x, y] : pixels) {
        const int first = major == 0 ? y : x, step = major == 0 ? x : y;
        if (step < first_visible || step >= end_visible) continue;
        for (int i = std::max(first, low_across); i < std::min(first + width, high_across); ++i)
            seen.emplace_back(major == 0 ? step : i, major == 0 ? i : step);
    }
    return seen;
}

PixelRect point_square(const glm::dvec2& position_window, int size, const PixelRect& within) {
    const double to_centre = size % 2 == 0 ? 0.5 : 0;
    const int x = floor_to_pixel(position_window.x + to_centre) - size / 2;
    const int y = floor_to_pixel(position_window.y + to_centre) - size / 2;
    return {std::max(x, within.x0), std::max(y, within.y0), std::min(x + size, within.x1),
            std::min(y + size, within.y1)};
}

PixelRect sprite_square(const glm::dvec2& position_window, double size, const PixelRect& within) {
    const auto first_centre_from = [](double side) { return ceil_to_pixel(side - 0.5); };
    const glm::dvec2 low = position_window - size / 2, high = position_window + size / 2;
    return {std::max(first_centre_from(low.x), within.x0), std::max(first_centre_from(low.y), within.y0),
            std::min(first_centre_from(high.x), within.x1), std::min(first_centre_from(high.y), within.y1)};
}

PixelRect square_of(const Piece& point, const PixelRect& within) {
    const glm::dvec2 at(point.ends().from.position_window);
    return point.sprite_size > 0 ? sprite_square(at, point.sprite_size, within) : point_square(at, point.size, within);
}

namespace {

using Outline = std::vector<glm::dvec2>;

// The part of a convex polygon where sign * position[axis] <= sign * border.
Outline cut(const Outline& polygon, int axis, double border, double sign) {
    Outline inside;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double from = sign * (a[axis] - border), to = sign * (b[axis] - border);
        if (from <= 0) inside.push_back(a);
        if ((from < 0 && to > 0) || (from > 0 && to < 0)) inside.push_back(a + from / (from - to) * (b - a));
    }
    return inside;
}

// The part between first and first + 1.
Outline strip(const Outline& polygon, int axis, int first) {
    return cut(cut(polygon, axis, first + 1, 1), axis, first, -1);
}

Outline outline_of(const Piece& piece) {
    Outline outline;
    outline.reserve(piece.corners.size());
    for (std::size_t i = 0; i < piece.corners.size(); ++i) outline.push_back(piece.corners.position_window(i));
    return outline;
}

double area(const Outline& polygon) {
    double doubled = 0;
    for (std::size_t i = 0; i + 2 < polygon.size(); ++i) {
        const glm::dvec2 a = polygon[i + 1] - polygon[0], b = polygon[i + 2] - polygon[0];
        doubled += a.x * b.y - a.y * b.x;
    }
    return doubled / 2;
}

}  // namespace

double coverage_of(const Piece& piece, int x, int y) {
    return std::clamp(area(strip(strip(outline_of(piece), 1, y), 0, x)), 0.0, 1.0);
}

std::vector<std::pair<int, int>> smooth_pixels(const Piece& piece, const PixelRect& within) {
    std::vector<std::pair<int, int>> pixels;
    if (piece.corners.size() == 0) return pixels;
    const PixelRect box = bounds(piece.corners, within, 0);
    const Outline outline = outline_of(piece);
    for (int y = box.y0; y < box.y1; ++y) {
        const Outline row = strip(outline, 1, y);
        if (row.empty()) continue;
        double low = row.front().x, high = low;
        for (const glm::dvec2& corner : row) {
            low = std::min(low, corner.x);
            high = std::max(high, corner.x);
        }
        const int first = std::max(box.x0, static_cast<int>(std::floor(std::max(low, box.x0 - 1.0))));
        for (int x = first; x < box.x1 && x < high; ++x)
            if (area(strip(row, 0, x)) > 0) pixels.emplace_back(x, y);
    }
    return pixels;
}

}  // namespace twinlight::reference
