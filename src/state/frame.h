// Frame: what the commands of one picture come to. The programmable and the reference renderer see only this.
//
// Everything is in double precision, in GL's words, with GL's initial values (GL 2.1 tables 6.5 to 6.13).
// Spaces: object -> eye (modelview) -> clip (projection) -> ndc -> window (viewport, depth range).
#pragma once

#include <array>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "command/command.h"

namespace twinlight {

inline constexpr int kMaxLights = 8;

// ---- What lights a Draw ----

struct Material {  // 2.14.2, table 2.10
    glm::dvec4 ambient{0.2, 0.2, 0.2, 1};
    glm::dvec4 diffuse{0.8, 0.8, 0.8, 1};
    glm::dvec4 specular{0, 0, 0, 1};
    glm::dvec4 emission{0, 0, 0, 1};
    double shininess = 0;
    glm::dvec3 color_indexes{0, 1, 1};  // of color index mode: changes nothing here
};

struct LightSource {  // 2.14.2, table 2.10; GL_LIGHT0 has white diffuse and specular (LightingState sets it)
    bool enabled = false;
    glm::dvec4 ambient{0, 0, 0, 1};
    glm::dvec4 diffuse{0, 0, 0, 1};
    glm::dvec4 specular{0, 0, 0, 1};
    glm::dvec4 position_eye{0, 0, 1, 0};
    glm::dvec3 spot_direction_eye{0, 0, -1};
    double spot_exponent = 0;
    double spot_cutoff_deg = 180;
    double constant_attenuation = 1;
    double linear_attenuation = 0;
    double quadratic_attenuation = 0;

    // The lecture's smooth cone, `#pragma twinlight spot_cone(light, inner_deg, outer_deg)`: not in GL.
    struct SmoothCone {
        double inner_deg = 0;
        double outer_deg = 0;
    };
    std::optional<SmoothCone> smooth_cone;
};

struct LightModel {  // 2.14.2, table 2.10
    glm::dvec4 ambient{0.2, 0.2, 0.2, 1};
    bool local_viewer = false;
    bool two_side = false;
    Enum color_control = kGL_SINGLE_COLOR;

    // The lecture's variants: not in GL.
    Word specular = Word::half_vector;      // or Word::reflection: (r.v)^n
    Word light_ambient = Word::attenuated;  // or Word::unattenuated: ambient outside attenuation and spot
};

struct ColorMaterial {  // 2.14.3
    bool enabled = false;
    Enum face = kGL_FRONT_AND_BACK;
    Enum mode = kGL_AMBIENT_AND_DIFFUSE;
};

struct LightingState {
    LightingState() { lights[0].diffuse = lights[0].specular = glm::dvec4(1); }

    bool enabled = false;  // GL_LIGHTING
    std::array<LightSource, kMaxLights> lights;
    LightModel light_model;
    // The materials at the start of the Draw; where color_material is enabled, each vertex's colour replaces the
    // property that it tracks (2.14.3).
    Material front, back;
    ColorMaterial color_material;
    bool normalize = false;
    bool rescale_normal = false;
    Enum shade_model = kGL_SMOOTH;
};

// ---- How it is rasterised ----

struct Viewport {
    int x = 0, y = 0;  // the lower left corner, in window coordinates (y up)
    int width = 0, height = 0;
};

struct RasterState {
    Viewport viewport;
    Enum front_face = kGL_CCW;
    bool cull_enabled = false;
    Enum cull_face = kGL_BACK;
    Enum polygon_mode_front = kGL_FILL;
    Enum polygon_mode_back = kGL_FILL;
    bool depth_test = false;
    Enum depth_func = kGL_LESS;
    bool depth_mask = true;
};

// ---- Draws ----

struct Vertex {
    glm::dvec4 position_object{0, 0, 0, 1};
    glm::dvec3 normal_object{0, 0, 1};
    glm::dvec4 color{1, 1, 1, 1};
};

// One batch of primitives, with the state that draws it.
struct Draw {
    Enum mode = kGL_TRIANGLES;  // glBegin's primitive type
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;  // into vertices, in the order they are sent; empty: 0, 1, 2, ...

    LightingState lighting;
    RasterState raster;
    glm::dmat4 eye_from_object{1};
    glm::dmat4 clip_from_eye{1};
    Place place;  // of the glBegin or the shape

    std::size_t count() const { return indices.empty() ? vertices.size() : indices.size(); }
    std::uint32_t index(std::size_t i) const { return indices.empty() ? static_cast<std::uint32_t>(i) : indices[i]; }
};

struct Clear {
    bool color = false;
    bool depth = false;
    glm::dvec4 clear_color{0, 0, 0, 0};
    double clear_depth = 1;
};

// A command or state that a renderer does not do yet: named, counted, placed.
struct Unsupported {
    std::string name;  // "glEnable(GL_FOG)"
    int count = 0;
    Place first;
    std::vector<std::string> renderers;  // which do not do it
};

struct Frame {
    int width = 0;
    int height = 0;
    std::vector<std::variant<Clear, Draw>> items;  // in the order of the commands
    std::vector<Unsupported> unsupported;
    std::shared_ptr<const CommandList> commands;  // what it was made from: the fixed renderer executes these
};

// ---- What a renderer is asked for ----

enum class Shading : std::uint8_t { kFlat, kGouraud, kPhong };

// Where a quadrilateral is cut into triangles. The specification leaves it open (3.5: any correct algorithm), it shows
// wherever colours do not vary linearly over it, and a driver may do now this, now that. Only the reference asks.
enum class QuadCut : std::uint8_t { kFirstToThird, kSecondToFourth };  // corners in their order around it

struct RenderOptions {
    std::optional<Shading> shading;  // nothing: flat or gouraud, as each Draw's glShadeModel says
    QuadCut quad_cut = QuadCut::kFirstToThird;
    bool lecture_variants = true;  // false: GL's own model, the pragmas' variants off
};

}  // namespace twinlight
