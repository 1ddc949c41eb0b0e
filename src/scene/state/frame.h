// Frame: what the commands of one picture come to. The programmable and the reference renderer see only this.
//
// Everything is in double precision, in GL's words, with GL's initial values (GL 2.1 tables 6.5 to 6.13).
// Spaces: object -> eye (modelview) -> clip (projection) -> ndc -> window (viewport, depth range).
#pragma once

#include <algorithm>
#include <array>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/math/arithmetic.h"
#include "scene/command/command.h"
#include "scene/shape/surface.h"
#include "scene/spectrum/samples.h"

namespace twinlight {

inline constexpr int kMaxLights = 8;  // GL_MAX_LIGHTS (table 6.29: 8 at least)
// The numbers of lights that GL does not have, `#pragma twinlight light(i, ...)`, end before this.
inline constexpr int kMaxExtraLights = 1 << 16;

// ---- What lights a Draw ----

struct Material {  // 2.14.2, table 2.10
    glm::dvec4 ambient{0.2, 0.2, 0.2, 1};
    glm::dvec4 diffuse{0.8, 0.8, 0.8, 1};
    glm::dvec4 specular{0, 0, 0, 1};
    glm::dvec4 emission{0, 0, 0, 1};
    double shininess = 0;
    glm::dvec3 color_indexes{0, 1, 1};  // of color index mode: changes nothing here

    // The reflectances whose colours these are, `#pragma twinlight reflectance(face, pname, name)`; null: just a colour. Not in GL.
    struct Reflectances {
        const Spectrum* ambient = nullptr;
        const Spectrum* diffuse = nullptr;
        const Spectrum* specular = nullptr;
    };
    Reflectances reflectances{};
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

    // The light whose colours these are, `#pragma twinlight illuminant(light, pname, name, scale)`: not in GL.
    struct Illuminant {
        const Spectrum* spectrum = nullptr;  // null: just a colour
        double scale = 1;
    };
    Illuminant diffuse_illuminant, specular_illuminant;
};

// "GL_LIGHT3"; "light(8)" for one that GL does not have.
inline std::string light_name(int number) {
    return number < kMaxLights ? "GL_LIGHT" + std::to_string(number) : "light(" + std::to_string(number) + ")";
}

struct LightModel {  // 2.14.2, table 2.10
    glm::dvec4 ambient{0.2, 0.2, 0.2, 1};
    bool local_viewer = false;
    bool two_side = false;
    Enum color_control = kGL_SINGLE_COLOR;

    // The lecture's variants: not in GL.
    Word specular = Word::half_vector;      // or Word::reflection: (r.v)^n
    Word light_ambient = Word::attenuated;  // or Word::unattenuated: ambient outside attenuation and spot
    // `#pragma twinlight spectrum(n)`: what colours are multiplied in, and red, green and blue made from; null: in these.
    std::shared_ptr<const SpectralSamples> spectrum;
};

struct ColorMaterial {  // 2.14.3
    bool enabled = false;
    Enum face = kGL_FRONT_AND_BACK;
    Enum mode = kGL_AMBIENT_AND_DIFFUSE;
};

struct LightingState {
    LightingState() : lights(kMaxLights) { lights[0].diffuse = lights[0].specular = glm::dvec4(1); }

    bool enabled = false;  // GL_LIGHTING
    // GL_LIGHT0 to GL_LIGHT7, and behind them those that a scene defines by pragmas: kMaxLights or more.
    std::vector<LightSource> lights;
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

struct PolygonOffset {  // 3.5.5
    double factor = 0;
    double units = 0;
    bool point = false, line = false, fill = false;  // GL_POLYGON_OFFSET_POINT, _LINE, _FILL

    bool is_enabled_for(Enum polygon_mode) const {
        return polygon_mode == kGL_FILL ? fill : polygon_mode == kGL_LINE ? line : point;
    }
};

inline constexpr int kMaxClipPlanes = 8;  // GL asks for six at least (table 6.29); Mesa has eight

struct RasterState {
    Viewport viewport;
    double depth_near = 0, depth_far = 1;  // glDepthRange (2.11.1)
    Enum front_face = kGL_CCW;
    bool cull_enabled = false;
    Enum cull_face = kGL_BACK;
    Enum polygon_mode_front = kGL_FILL;
    Enum polygon_mode_back = kGL_FILL;
    PolygonOffset polygon_offset;
    double line_width = 1;  // 3.4: rounded to a whole number of pixels, 1 at least, without smoothing
    double point_size = 1;  // 3.3: the same
    std::array<std::optional<glm::dvec4>, kMaxClipPlanes>
        clip_planes_eye;  // the enabled ones (2.12), in eye coordinates
    bool depth_test = false;
    Enum depth_func = kGL_LESS;
    bool depth_mask = true;
};

// ---- What happens to its fragments: textures (3.8), fog (3.10), the per-fragment operations (4.1) ----

// One level of a texture. Texels are what GL keeps of the image after its transfer: the components of the base
// internal format (table 3.15) as numbers in [0,1], rounded to the bits of the internal format; the others are 0
// (alpha 1). Row 0 is t = 0.
struct TextureImage {
    int width = 0, height = 1;        // without the border (borders are refused)
    Enum base_format = kGL_RGBA;      // GL_ALPHA, _LUMINANCE, _LUMINANCE_ALPHA, _INTENSITY, _RGB or _RGBA
    Enum internal_format = kGL_RGBA;  // as it was asked for: the levels of a complete texture have the same
    std::vector<glm::vec4> texels{};  // (R, G, B, A); of luminance or intensity R = G = B = the value

    const glm::vec4& texel(int x, int y) const {
        return texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    }
};

struct Texture {                         // 3.8.4, table 3.18
    Enum target = kGL_TEXTURE_2D;        // or GL_TEXTURE_1D
    std::vector<TextureImage> levels{};  // levels[0] is the base; empty images where none was given
    Enum min_filter = kGL_NEAREST_MIPMAP_LINEAR;
    Enum mag_filter = kGL_LINEAR;
    Enum wrap_s = kGL_REPEAT;
    Enum wrap_t = kGL_REPEAT;
    glm::dvec4 border_color{0, 0, 0, 0};
    double priority = 1;
    bool generate_mipmap = false;

    // Whether a filter is linear: then GL_CLAMP takes in the border's colour (3.8.7), else it is GL_CLAMP_TO_EDGE.
    bool filters_linearly() const {
        return mag_filter == kGL_LINEAR || min_filter == kGL_LINEAR || min_filter == kGL_LINEAR_MIPMAP_NEAREST ||
               min_filter == kGL_LINEAR_MIPMAP_LINEAR;
    }
};

struct TextureUnit {
    std::shared_ptr<const Texture>
        texture;                   // what the Draw is textured with: null where that is off, or incomplete (3.8.10)
    Enum env_mode = kGL_MODULATE;  // 3.8.13: or GL_DECAL, GL_REPLACE, GL_BLEND, GL_ADD
    glm::dvec4 env_color{0, 0, 0, 0};
    double lod_bias = 0;           // of GL_TEXTURE_FILTER_CONTROL
    glm::dmat4 texture_matrix{1};  // what every texture coordinate is multiplied by (2.11.2)
};

struct Fog {  // 3.10; the colour is blended in with f by the distance to the eye's plane, |z_eye|
    bool enabled = false;
    Enum mode = kGL_EXP;  // or GL_LINEAR, GL_EXP2
    double density = 1;
    double start = 0;
    double end = 1;
    glm::dvec4 color{0, 0, 0, 0};
};

struct Scissor {  // 4.1.2
    bool enabled = false;
    Viewport box;
};

struct FragmentState {
    Scissor scissor;
    bool alpha_test = false;  // 4.1.4
    Enum alpha_func = kGL_ALWAYS;
    double alpha_ref = 0;
    bool blend = false;                        // 4.1.8
    Enum blend_equation = kGL_FUNC_ADD;        // or GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT, GL_MIN, GL_MAX
    Enum blend_equation_alpha = kGL_FUNC_ADD;  // the same, but for glBlendEquationSeparate
    Enum blend_src = kGL_ONE, blend_dst = kGL_ZERO;
    Enum blend_src_alpha = kGL_ONE, blend_dst_alpha = kGL_ZERO;  // the same, but for glBlendFuncSeparate
    glm::dvec4 blend_color{0, 0, 0, 0};
    std::array<bool, 4> color_mask{true, true, true, true};  // 4.2.2
    bool color_sum = false;  // 3.9: without lighting; with it the secondary colour is always added
    // `#pragma twinlight transfer(srgb)`, not in GL: a fragment's colour is linear light, and coded as sRGB behind the fog.
    bool srgb_coded = false;
};

// ---- Draws ----

struct Vertex {
    glm::dvec4 position_object{0, 0, 0, 1};
    glm::dvec3 normal_object{0, 0, 1};
    glm::dvec4 color{1, 1, 1, 1};
    glm::dvec4 tex_coord{0, 0, 0, 1};
    bool edge_flag = true;  // 2.6.2: of independent triangles, quadrilaterals and polygons; the edge to the next vertex
    std::uint32_t material = 0;  // which of Draw::materials; 0 where there are none
};

// Both faces' materials.
struct Materials {
    Material front, back;
};

// Whether glBegin's mode draws polygons (2.6.1), which have two faces, and not points or lines.
inline bool draws_polygons(Enum mode) { return mode >= kGL_TRIANGLES; }

// One batch of primitives, with the state that draws it.
struct Draw {
    Enum mode = kGL_TRIANGLES;  // glBegin's primitive type
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;  // into vertices, in the order they are sent; empty: 0, 1, 2, ...

    LightingState lighting;
    RasterState raster;
    TextureUnit texture;
    Fog fog;
    FragmentState fragment;
    // Where glMaterial stands between glBegin and glEnd: the materials that the vertices name. materials[0] is then
    // lighting.front and lighting.back. Empty where the whole Draw has one material.
    std::vector<Materials> materials;
    glm::dmat4 eye_from_object{1};
    glm::dmat4 clip_from_eye{1};
    Place place;  // of the glBegin or the shape
    // The curved surfaces that a shape's mesh stands for; null where the mesh is the shape. The Draws that share them are the
    // parts of one shape, and follow each other.
    std::shared_ptr<const std::vector<Surface>> surfaces;

    // Whether there are polygons of a face that glPolygonMode has drawn so (3.5.4), if nothing culls them.
    bool draws_polygons_as(Enum polygon_mode) const {
        return draws_polygons(mode) &&
               (raster.polygon_mode_front == polygon_mode || raster.polygon_mode_back == polygon_mode);
    }
    // Polygons as their edges or corners.
    bool draws_borders() const { return draws_polygons_as(kGL_LINE) || draws_polygons_as(kGL_POINT); }
    bool draws_points() const { return mode == kGL_POINTS || draws_polygons_as(kGL_POINT); }
    bool draws_lines() const { return (mode != kGL_POINTS && !draws_polygons(mode)) || draws_polygons_as(kGL_LINE); }

    // Whether it has surfaces that Shading::kExact draws in the place of its mesh: only filled ones have equations.
    bool has_exact_surfaces() const {
        return surfaces && !draws_borders() && raster.viewport.width > 0 && raster.viewport.height > 0;
    }

    std::size_t count() const { return indices.empty() ? vertices.size() : indices.size(); }
    std::uint32_t index(std::size_t i) const { return indices.empty() ? static_cast<std::uint32_t>(i) : indices[i]; }
};

// Whether a Draw and the next are parts of one shape, or of one glBegin.
inline bool are_one_shape(const Draw& draw, const Draw& next) {
    return draw.place == next.place && draw.surfaces == next.surfaces;
}

// The Draw's vertices of these numbers in this order; all of them where there is none.
template <class Visit>
void for_each_vertex(const Draw& draw, const std::vector<std::uint32_t>& numbers, const Visit& visit) {
    if (numbers.empty()) {
        for (const Vertex& vertex : draw.vertices) visit(vertex);
    } else {
        for (const std::uint32_t number : numbers) visit(draw.vertices.at(number));
    }
}

struct Clear {
    bool color = false;
    bool depth = false;
    Scissor scissor{};  // 4.2.3: clearing obeys the scissor and the colour mask
    std::array<bool, 4> color_mask{true, true, true, true};
    glm::dvec4 clear_color{0, 0, 0, 0};
    double clear_depth = 1;
};

// Where a command or state of the scene is missing.
enum class MissingFrom : std::uint8_t {
    kFrame,          // only the driver carries it out: whatever is drawn from the Frame lacks it
    kEverything,     // not even the driver is sent it
    kShaders,        // the Frame has it
    kFixedFunction,  // the Frame has it
};

// A command or state that not everything draws: named, counted, placed.
struct Unsupported {
    std::string name;  // "glEnable(GL_FOG)"
    int count = 0;
    Place first;
    MissingFrom missing_from = MissingFrom::kFrame;
};

// The picture that State makes of a scene's commands.
struct Frame {
    int width = 0;
    int height = 0;
    std::vector<std::variant<Clear, Draw>> items{};  // in the order of the commands
    std::vector<Unsupported> unsupported{};
    // The names of display lists that other lists call, but that were not there yet when these were compiled.
    std::vector<std::uint32_t> lists_called_before_made{};

    // The Draws alone.
    std::vector<const Draw*> draws() const { return draws_of<const Draw>(items); }
    std::vector<Draw*> draws() { return draws_of<Draw>(items); }

  private:
    template <class Type, class Items>
    static std::vector<Type*> draws_of(Items& items) {
        std::vector<Type*> draws;
        for (auto& item : items)
            if (Type* draw = std::get_if<Draw>(&item)) draws.push_back(draw);
        return draws;
    }
};

}  // namespace twinlight
