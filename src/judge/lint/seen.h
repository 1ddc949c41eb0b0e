// Which points of a frame's surfaces its picture shows.
#pragma once

#include <vector>

#include "judge/lint/watch.h"
#include "render/reference/geometry/primitive_assembly.h"
#include "render/reference/vertices/vertex_stage.h"

namespace twinlight::lint {

// Whether culling removes a triangle; false if it is partly behind the camera.
bool culls(const Draw& draw, const reference::Primitive& primitive,
           const std::vector<reference::StageVertex>& vertices);

// Which triangle of a frame: its Draw's number (Frame::draws()), and its own in triangles_of().
struct TriangleNumber {
    std::size_t draw = 0, triangle = 0;
    friend auto operator<=>(const TriangleNumber&, const TriangleNumber&) = default;
};

class SeenPoints {
  public:
    explicit SeenPoints(const Frame& frame);

    // Whether the picture may show a point of this triangle: it is in view, the triangle is not culled, and no other triangle hides
    // the point. What is blended hides as well.
    bool shows(const TriangleNumber& triangle, const glm::dvec4& point_clip) const;

  private:
    struct Face {
        TriangleNumber number;
        std::array<glm::dvec4, 3> corners_clip;
        glm::dvec2 low, high;  // in normalised device coordinates; infinite if the triangle is partly behind the eye
    };
    bool hides(const Face& face, const Face& own, const glm::dvec3& point_ndc, bool at_border) const;

    // The picture in cells, each with the numbers of the faces that may be in it. Large faces are apart.
    static constexpr int kCells = 64;  // across and up
    static int cell_at(double ndc);

    std::vector<const Draw*> draws_;
    std::vector<Face> faces_;  // those that are not culled, in the order of drawing
    std::vector<std::vector<std::uint32_t>> cells_{static_cast<std::size_t>(kCells) * kCells};
    std::vector<std::uint32_t> large_;
};

}  // namespace twinlight::lint
