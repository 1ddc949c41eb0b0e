// The points of an exact surface that correct renderers may see at a pixel.
//
// A ray that is cast in floats may pass a thousandth of a pixel beside the pixel's centre. So rays are cast there, too: where they do
// not meet the same faces in the same order, a silhouette or the border of a clipping plane passes beside the centre.
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "render/reference/geometry/surface_rays.h"

namespace twinlight::reference {

class PointsAround {
  public:
    PointsAround() = default;
    PointsAround(const SurfaceRays& rays, const glm::dvec2& centre_window);

    // The most points that a ray meets; they are numbered from far to near.
    int count() const { return static_cast<int>(by_number_.size()); }
    // Whether all rays meet the same faces.
    bool is_certain() const { return is_certain_; }
    // The points with this number, each met by another ray. The centre's is the first if its ray has one.
    std::span<const RayPoint> points(int number) const { return by_number_[static_cast<std::size_t>(number)]; }
    // Those that a renderer may light: of a flat part only the first, because no highlight changes on the way to the others.
    std::span<const RayPoint> lit(int number) const;

  private:
    void add(std::vector<RayPoint> points);

    std::vector<std::vector<RayPoint>> by_number_;
    bool is_certain_ = true;
};

}  // namespace twinlight::reference
