// Exact surfaces: casts rays through window positions at the surfaces that a shape's mesh approximates.
//
// In: a Draw, one of its surfaces, a window position. Out: the visible points there, each with the attributes that a
// vertex would have there: normal, depth, face and texture coordinates. Clipping and culling (2.12, 3.5.1) work point
// by point. Silhouettes are the surface's own: a pixel is covered if its centre is.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <optional>

#include "render/reference/textures/texture.h"
#include "render/reference/vertices/draw_lighting.h"
#include "render/reference/vertices/vertex_stage.h"
#include "scene/shape/surface.h"

namespace twinlight::reference {

// A point where a ray meets a surface.
struct RayPoint {
    Vertex object;       // its position, and its outward normal of length 1
    StageVertex vertex;  // the normal has length 1
    double depth = 0;    // in the window, with polygon offset
    Face face = Face::kFront;
    TexturePlace place;
};

class SurfaceRays {
  public:
    // The Draw must outlive it. RULING: if a matrix has no inverse, the surface is not visible.
    SurfaceRays(const Draw& draw, const Surface& surface);

    // points(): the points along the ray, from far to near. point(): the one with this number. slack: by which part of what is added
    // up for its distance a point may lie outside of a clipping plane; if negative, must lie inside.
    std::vector<RayPoint> points(const glm::dvec2& position_window, double slack = 0) const;
    std::optional<RayPoint> point(const glm::dvec2& position_window, int number) const;

    // The most points where a ray can meet the surface.
    int most_points() const;
    // The surface is not visible outside this rectangle of the window.
    glm::dvec2 low_window() const { return low_window_; }
    glm::dvec2 high_window() const { return high_window_; }

  private:
    // Two directions on the surface that form a right-handed system with its outward normal, and the change of the
    // window position (x, y, depth) along them.
    struct Tangents {
        Vec u, v;
        glm::dvec3 window_per_u, window_per_v;
        bool is_counter_clockwise;  // whether the turn from u to v is counter-clockwise in the window

        // The step on the tangent plane, in object space, that changes the window position by `window_step`.
        glm::dvec3 object_step(const glm::dvec2& window_step) const;
    };

    // Calls visit(position_object, normal_object, tangents) for each point, until it returns false.
    template <class Visit>
    void for_each_crossing(const glm::dvec2& position_window, double slack, const Visit& visit) const;
    glm::dvec4 clip(const glm::dvec4& position_object) const { return clip_from_object_ * position_object; }
    bool is_inside(const glm::dvec4& position_object, double slack) const;
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
