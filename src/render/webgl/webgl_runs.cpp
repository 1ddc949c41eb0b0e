#include "render/webgl/webgl_runs.h"

#include <algorithm>
#include <cstdint>
#include <glm/geometric.hpp>
#include <initializer_list>
#include <span>
#include <utility>

#include "render/reference/geometry/piece.h"
#include "render/reference/vertices/vertex_stage.h"

namespace twinlight::webgl {

namespace {

// Each run costs a copy of the picture: 0.4 ms for 640 x 480 pixels in Chromium with SwiftShader.
constexpr std::size_t kMostRuns = 1000;
// A primitive is compared with all others of its run.
constexpr std::size_t kMostInRun = 4096;

std::size_t corners_of(Enum mode) { return mode == kGL_POINTS ? 1 : mode == kGL_LINES ? 2 : 3; }

struct Placed {
    std::vector<glm::dvec4> corners_clip;
    std::vector<glm::dvec2> corners;  // in the window
    glm::dvec2 low{0}, high{0};       // of all pixels
    bool is_triangle = false;         // with no pixels beside it
    bool is_known = true;             // otherwise it may be anywhere
};

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

// Whether a line through an edge of `a` lies between them. Triangles with a common edge have no common pixel (3.5.1), and common
// corners stay common. Others must be so far apart that they still are if a rasteriser rounds corners to 1/16 pixel, which turns edges.
bool edge_parts(const Placed& a, const Placed& b) {
    constexpr double kStep = 1.0 / 8;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec2 from = a.corners[i], to = a.corners[(i + 1) % 3], way = to - from;
        const double length = glm::length(way), own_side = cross(way, a.corners[(i + 2) % 3] - from);
        if (length == 0 || own_side == 0) continue;
        bool are_beyond = true;
        for (std::size_t j = 0; j < 3 && are_beyond; ++j) {
            if (b.corners_clip[j] == a.corners_clip[i] || b.corners_clip[j] == a.corners_clip[(i + 1) % 3]) continue;
            const glm::dvec2 there = b.corners[j] - from;
            const double distance = cross(way, there) / length * (own_side > 0 ? -1 : 1);
            are_beyond = distance > kStep * (1 + glm::length(there) / length);
        }
        if (are_beyond) return true;
    }
    return false;
}

bool may_overlap(const Placed& a, const Placed& b) {
    if (!a.is_known || !b.is_known) return true;
    if (a.low.x > b.high.x || a.low.y > b.high.y || b.low.x > a.high.x || b.low.y > a.high.y) return false;
    return !a.is_triangle || !b.is_triangle || (!edge_parts(a, b) && !edge_parts(b, a));
}

Placed placed(std::span<const std::uint32_t> corners, const Part& part, const Draw& draw,
              const std::vector<reference::StageVertex>& vertices) {
    const RasterState& raster = draw.raster;
    Placed result;
    result.is_triangle = part.mode == kGL_TRIANGLES && !part.has_rectangles();
    for (const std::uint32_t corner : corners) {
        const glm::dvec4 clip = vertices[part.has_vertices() ? part.vertices[corner] : corner].position_clip;
        result.is_known = result.is_known && clip.w > 0;
        result.corners_clip.push_back(clip);
        if (!result.is_known) continue;
        result.corners.emplace_back(reference::window_from_ndc(raster, glm::dvec3(clip) / clip.w));
    }
    if (!result.is_known) return result;
    // A pixel for the rounding of corners, and what lines and points have beside them.
    const double beside = 1 + (result.is_triangle ? 0 : std::max(raster.line_width, raster.point_size));
    result.low = result.high = result.corners.front();
    for (const glm::dvec2& corner : result.corners) {
        result.low = glm::min(result.low, corner);
        result.high = glm::max(result.high, corner);
    }
    result.low -= beside;
    result.high += beside;
    if (draw.draws_points() && raster.point_parameters.attenuates()) result.is_known = false;
    return result;
}

}  // namespace

Part listed(Part part) {
    const std::vector<std::uint32_t> given = std::exchange(part.indices, {});
    const std::size_t count = given.size();
    const auto add = [&](std::initializer_list<std::size_t> corners) {
        for (const std::size_t corner : corners) part.indices.push_back(given[corner]);
    };
    switch (part.mode) {
        case kGL_LINE_LOOP:
        case kGL_LINE_STRIP:
            for (std::size_t i = 0; i + 1 < count; ++i) add({i, i + 1});
            if (part.mode == kGL_LINE_LOOP && count > 1) add({count - 1, 0});
            part.mode = kGL_LINES;
            break;
        case kGL_TRIANGLE_STRIP:
            for (std::size_t i = 0; i + 2 < count; ++i) i % 2 == 0 ? add({i, i + 1, i + 2}) : add({i + 1, i, i + 2});
            part.mode = kGL_TRIANGLES;
            break;
        case kGL_TRIANGLE_FAN:
            for (std::size_t i = 1; i + 1 < count; ++i) add({0, i, i + 1});
            part.mode = kGL_TRIANGLES;
            break;
        default: part.indices = given;
    }
    return part;
}

Runs runs_of(const Part& part, const Draw& draw, bool for_any_pose) {
    const std::size_t size = corners_of(part.mode), count = part.indices.size() / size;
    const bool is_each_alone = for_any_pose && count <= kMostRuns;
    const std::vector<reference::StageVertex> vertices = reference::vertex_stage(draw);
    Runs runs;
    runs.is_exact = is_each_alone || !for_any_pose;
    std::vector<Placed> run;
    for (std::size_t i = 0; i < count; ++i) {
        Placed next = placed(std::span(part.indices).subspan(i * size, size), part, draw, vertices);
        const bool is_apart = !is_each_alone && run.size() < kMostInRun &&
                              std::ranges::none_of(run, [&](const Placed& one) { return may_overlap(one, next); });
        if (!run.empty() && !is_apart) {
            if (runs.ends.size() + 1 < kMostRuns) {
                runs.ends.push_back(i * size);
                run.clear();
            } else {
                runs.is_exact = false;
                break;
            }
        }
        run.push_back(std::move(next));
    }
    if (count > 0) runs.ends.push_back(count * size);
    return runs;
}

}  // namespace twinlight::webgl
