// Exact surfaces: rays through window positions against the surfaces that a shape's mesh stands for.
//
// In: a Draw, one of its surfaces, a window position. Out: the points that are seen there, with all that a vertex of a mesh
// would have there: the surface's own normal, and depth, face and texture coordinates of that very point. What clips and
// culls polygons (2.12, 3.5.1) does so here point by point. Silhouettes are the surface's: a pixel is covered where its centre is.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <optional>

#include "render/reference/draw_lighting.h"
#include "render/reference/texture.h"
#include "render/reference/vertex_stage.h"
#include "scene/shape/surface.h"

namespace twinlight::reference {

// Where a ray meets a surface.
struct RayPoint {
    Vertex object;       // where it is, and its outward normal: a unit vector
    StageVertex vertex;  // the normal is a unit vector
    double depth = 0;    // in the window, with polygon offset
    Face face = Face::kFront;
    TexturePlace place;
};

class SurfaceRays {
  public:
    // The Draw must outlive it. RULING: under matrices without an inverse a surface is not seen.
    SurfaceRays(const Draw& draw, const Surface& surface);

    // The points in the order of the ray, from far to near; and that which has this number.
    std::vector<RayPoint> points(const glm::dvec2& position_window) const;
    std::optional<RayPoint> point(const glm::dvec2& position_window, int number) const;

    // A ray meets the surface so often at most.
    int most_points() const;
    // Window positions outside of this rectangle see nothing of it.
    glm::dvec2 low_window() const { return low_window_; }
    glm::dvec2 high_window() const { return high_window_; }

  private:
    // Two directions on the surface that with its outward normal make a right-handed system, and how the window position (x, y,
    // depth) changes along them.
    struct Tangents {
        Vec u, v;
        glm::dvec3 window_per_u, window_per_v;
        bool is_counter_clockwise;  // what goes from u to v, as it is seen

        // Object space: how far one goes on the tangent plane for this change of the window position.
        glm::dvec3 object_step(const glm::dvec2& window_step) const;
    };

    // Calls visit(position_object, normal_object, tangents) for each point, until it returns false.
    template <class Visit>
    void for_each_crossing(const glm::dvec2& position_window, const Visit& visit) const;
    glm::dvec4 clip(const glm::dvec4& position_object) const { return clip_from_object_ * position_object; }
    bool is_inside(const glm::dvec4& position_object) const;
    Tangents tangents(const glm::dvec4& position_object, const Vec& normal_object) const;
    Face face(const Tangents& tangents) const;
    double depth(const glm::dvec4& position_object, const Tangents& tangents) const;
    glm::dvec2 tex_coord(const glm::dvec3& position_object) const;
    TexturePlace texture_place(const glm::dvec3& position_object, const Tangents& tangents) const;
    RayPoint seen(const glm::dvec4& position_object, const Vec& normal_object, const Tangents& tangents) const;
    void find_window_bounds();

    const Draw& draw_;
    Surface surface_;
    glm::dmat4 clip_from_object_{1}, object_from_clip_{1};
    glm::dmat3 normal_eye_from_object_{1};
    bool has_inverse_ = false;
    glm::dvec2 low_window_{0}, high_window_{0};
};

}  // namespace twinlight::reference
