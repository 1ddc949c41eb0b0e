// Frame: one picture as a list of clears, draws, accumulations and copies of pixels, with all state resolved. The programmable and the reference
// renderer see only this, not the commands.
//
// All numbers are doubles. Names and initial values are those of GL (GL 2.1 tables 6.5 to 6.13).
// Spaces: object -> eye (modelview) -> clip (projection) -> ndc -> window (viewport, depth range).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/image/rectangle.h"
#include "base/math/arithmetic.h"
#include "scene/command/names.h"
#include "scene/command/place.h"
#include "scene/frame/shared_vector.h"
#include "scene/frame/vertex_attributes.h"
#include "scene/shape/surface.h"
#include "scene/spectrum/samples.h"

namespace twinlight {

inline constexpr int kMaxLights = 8;  // GL_MAX_LIGHTS: at least 8 (table 6.29)
// `#pragma twinlight light(i, ...)` adds lights that GL lacks; their numbers are below this.
inline constexpr int kMaxExtraLights = 1 << 16;

// ---- Lighting ----

struct Material {  // 2.14.2, table 2.10
    glm::dvec4 ambient{0.2, 0.2, 0.2, 1};
    glm::dvec4 diffuse{0.8, 0.8, 0.8, 1};
    glm::dvec4 specular{0, 0, 0, 1};
    glm::dvec4 emission{0, 0, 0, 1};
    double shininess = 0;
    glm::dvec3 color_indexes{0, 1, 1};  // only for color index mode: no effect here

    // Not in GL: `#pragma twinlight reflectance(face, pname, name)`. The spectra that the colours above were computed
    // from; null if a colour was given as numbers.
    struct Reflectances {
        const Spectrum* ambient = nullptr;
        const Spectrum* diffuse = nullptr;
        const Spectrum* specular = nullptr;

        friend bool operator==(const Reflectances&, const Reflectances&) = default;
    };
    Reflectances reflectances{};

    friend bool operator==(const Material&, const Material&) = default;
};

// What makes a light weaker away from an axis: nothing, GL's cone (2.14.1), or the lecture's smooth cone, which replaces GL's.
enum class SpotCone : std::uint8_t { kNone, kGl, kSmooth };

struct LightSource {  // 2.14.2, table 2.10; GL_LIGHT0 has white diffuse and specular (LightingState sets it)
    bool enabled = false;
    std::uint32_t typed = 0;  // index into Frame::typed_lights
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

    // Not in GL: the lecture's smooth cone, `#pragma twinlight spot_cone(light, inner_deg, outer_deg)`.
    struct SmoothCone {
        double inner_deg = 0;
        double outer_deg = 0;

        friend bool operator==(const SmoothCone&, const SmoothCone&) = default;
    };
    std::optional<SmoothCone> smooth_cone;

    // Not in GL: `#pragma twinlight illuminant(light, pname, name, scale)`. The spectrum that a colour was computed
    // from.
    struct Illuminant {
        const Spectrum* spectrum = nullptr;  // null if the colour was given as numbers
        double scale = 1;

        friend bool operator==(const Illuminant&, const Illuminant&) = default;
    };
    Illuminant diffuse_illuminant, specular_illuminant;

    friend bool operator==(const LightSource&, const LightSource&) = default;
    bool is_directional() const { return position_eye.w == 0; }
    bool has_initial_attenuation() const {
        return constant_attenuation == 1 && linear_attenuation == 0 && quadratic_attenuation == 0;
    }
    // Whether att_i (2.14.1) has factors that count and may be other than 1.
    bool is_attenuated() const { return !is_directional() && !has_initial_attenuation(); }
    void clear_attenuation() {
        constant_attenuation = 1;
        linear_attenuation = quadratic_attenuation = 0;
    }
    bool has_cutoff() const { return spot_cutoff_deg != 180; }
    bool is_spot() const { return has_cutoff() || smooth_cone; }
    // Whether spot_i (2.14.1) is less than 1 anywhere. A cosine that is clamped to 0 is never less than cos 90, and 0^0 is 1.
    bool has_cone() const { return has_cutoff() && (spot_cutoff_deg != 90 || spot_exponent != 0); }
    SpotCone cone() const { return smooth_cone ? SpotCone::kSmooth : has_cone() ? SpotCone::kGl : SpotCone::kNone; }
};

// What glLight was given for GL_POSITION and GL_SPOT_DIRECTION. LightSource has the same in eye coordinates: the product
// with the modelview matrix at the call (2.14.1).
struct TypedLight {
    template <class Vector>
    struct Value {
        Vector value;
        Place place{};  // of glLight
        glm::dmat4 eye_from_typed{1};

        bool is_initial() const { return place == Place{}; }
        friend bool operator==(const Value&, const Value&) = default;
    };
    Value<glm::dvec4> position{{0, 0, 1, 0}};
    Value<glm::dvec3> spot_direction{{0, 0, -1}};

    friend bool operator==(const TypedLight&, const TypedLight&) = default;
};

// "GL_LIGHT3"; "light(8)" for a light that GL lacks.
inline std::string light_name(int number) {
    return number < kMaxLights ? "GL_LIGHT" + std::to_string(number) : "light(" + std::to_string(number) + ")";
}

struct LightModel {  // 2.14.2, table 2.10
    glm::dvec4 ambient{0.2, 0.2, 0.2, 1};
    bool local_viewer = false;
    bool two_side = false;
    Enum color_control = kGL_SINGLE_COLOR;

    // Not in GL: the lecture's variants.
    Word specular = Word::half_vector;      // or Word::reflection: (r.v)^n
    Word light_ambient = Word::attenuated;  // or Word::unattenuated: the ambient term ignores attenuation and spot
    // `#pragma twinlight spectrum(n)`: colours are multiplied as spectra with these samples and then converted to red,
    // green and blue. Null: red, green and blue are multiplied directly.
    std::shared_ptr<const SpectralSamples> spectrum;

    friend bool operator==(const LightModel&, const LightModel&) = default;
};

struct ColorMaterial {  // 2.14.3
    bool enabled = false;
    Enum face = kGL_FRONT_AND_BACK;
    Enum mode = kGL_AMBIENT_AND_DIFFUSE;

    friend bool operator==(const ColorMaterial&, const ColorMaterial&) = default;
};

// A list of light sources that copies share until one of them is changed: a frame may have a hundred thousand Draws with
// the same lights. Only functions that are not const copy the list, so read a list as a const one, and keep no reference
// to a light of a list that is copied.
class LightSources {
  public:
    explicit LightSources(std::size_t count) : shared_(std::make_shared<std::vector<LightSource>>(count)) {}
    LightSources(std::initializer_list<LightSource> lights)
        : shared_(std::make_shared<std::vector<LightSource>>(lights)) {}
    // Without moves, so that there always is a list.
    LightSources(const LightSources&) = default;
    LightSources& operator=(const LightSources&) = default;
    ~LightSources() = default;

    std::size_t size() const { return shared_->size(); }
    bool empty() const { return shared_->empty(); }
    const LightSource& operator[](std::size_t i) const { return (*shared_)[i]; }
    const LightSource& at(std::size_t i) const { return shared_->at(i); }
    const LightSource& front() const { return shared_->front(); }
    const LightSource& back() const { return shared_->back(); }
    auto begin() const { return shared_->cbegin(); }
    auto end() const { return shared_->cend(); }

    LightSource& operator[](std::size_t i) { return own()[i]; }
    LightSource& at(std::size_t i) { return own().at(i); }
    LightSource& back() { return own().back(); }
    auto begin() { return own().begin(); }
    auto end() { return own().end(); }
    void clear() { shared_ = std::make_shared<std::vector<LightSource>>(); }
    void resize(std::size_t count) { own().resize(count); }
    void resize(std::size_t count, const LightSource& light) { own().resize(count, light); }
    void push_back(const LightSource& light) { own().push_back(light); }

    bool is_shared() const { return shared_.use_count() > 1; }

    friend bool operator==(const LightSources& a, const LightSources& b) {
        return a.shared_ == b.shared_ || *a.shared_ == *b.shared_;
    }

  private:
    std::vector<LightSource>& own() {
        if (is_shared()) shared_ = std::make_shared<std::vector<LightSource>>(*shared_);
        return *shared_;
    }

    std::shared_ptr<std::vector<LightSource>> shared_;
};

struct LightingState {
    LightingState() : lights(kMaxLights) { lights[0].diffuse = lights[0].specular = glm::dvec4(1); }

    bool enabled = false;  // GL_LIGHTING
    // GL_LIGHT0 to GL_LIGHT7, followed by the lights that pragmas define. At least kMaxLights.
    LightSources lights;
    LightModel light_model;
    // The materials at the start of the Draw. If color_material is enabled, each vertex's colour replaces the
    // properties that track it (2.14.3).
    Material front, back;
    ColorMaterial color_material;
    bool normalize = false;
    bool rescale_normal = false;
    Enum shade_model = kGL_SMOOTH;

    friend bool operator==(const LightingState&, const LightingState&) = default;
};

// ---- Rasterisation ----

struct PolygonOffset {  // 3.5.5
    double factor = 0;
    double units = 0;
    bool point = false, line = false, fill = false;  // GL_POLYGON_OFFSET_POINT, _LINE, _FILL

    friend bool operator==(const PolygonOffset&, const PolygonOffset&) = default;
    bool is_enabled_for(Enum polygon_mode) const {
        return polygon_mode == kGL_FILL ? fill : polygon_mode == kGL_LINE ? line : point;
    }
};

// 3.5.2: a bit for each pixel of 32 rows, from the bottom; bit 0 is the leftmost. A fragment is drawn if its bit is 1.
using PolygonStipple = std::array<std::uint32_t, 32>;

// 3.4.2: each bit counts for `factor` fragments of a line, from the lowest bit. A fragment is drawn if its bit is 1.
struct LineStipple {
    int factor = 1;  // 1 to 256
    std::uint16_t pattern = 0xFFFF;

    friend bool operator==(const LineStipple&, const LineStipple&) = default;
};

// 3.3 lets the implementation choose the largest point; here it is llvmpipe's.
inline constexpr double kMaxPointSize = 255;

struct PointParameters {  // 3.3, 3.3.1: glPointParameter
    double size_min = 0, size_max = kMaxPointSize;
    double fade_threshold_size = 1;  // only for multisampling
    glm::dvec3 distance_attenuation{1, 0, 0};
    Enum sprite_coord_origin = kGL_UPPER_LEFT;  // or GL_LOWER_LEFT

    bool attenuates() const { return distance_attenuation != glm::dvec3(1, 0, 0); }
    bool depends_on_distance() const { return distance_attenuation.y != 0 || distance_attenuation.z != 0; }
    // RULING: a negative factor counts by its size, and where the limits are in the wrong order, that of the smallest size
    // counts. 3.3 leaves both open.
    double derived_size(double size, double distance_eye) const {
        const glm::dvec3& f = distance_attenuation;
        const double factor = attenuates() ? f.x + distance_eye * (f.y + distance_eye * f.z) : 1;
        return std::max(size_min, std::min(size_max, size / std::sqrt(std::abs(factor))));
    }
    friend bool operator==(const PointParameters&, const PointParameters&) = default;
};

inline constexpr int kMaxClipPlanes = 8;  // GL requires at least 6 (table 6.29); Mesa has 8

struct RasterState {
    Rectangle viewport;                    // in window coordinates, y up
    double depth_near = 0, depth_far = 1;  // glDepthRange (2.11.1)
    Enum front_face = kGL_CCW;
    bool cull_enabled = false;
    Enum cull_face = kGL_BACK;
    Enum polygon_mode_front = kGL_FILL;
    Enum polygon_mode_back = kGL_FILL;
    PolygonOffset polygon_offset;
    double line_width = 1;  // 3.4: without smoothing, rounded to a whole number of pixels, at least 1
    double point_size = 1;  // 3.3: the same, after the point parameters
    PointParameters point_parameters{};
    bool point_sprite = false;                                // 3.3.1
    std::optional<LineStipple> line_stipple{};                // nothing: off
    std::shared_ptr<const PolygonStipple> polygon_stipple{};  // null: off
    bool line_smooth = false, point_smooth = false;           // 3.3, 3.4.2
    std::array<std::optional<glm::dvec4>, kMaxClipPlanes>
        clip_planes_eye;  // the enabled ones (2.12), in eye coordinates
    bool depth_test = false;
    Enum depth_func = kGL_LESS;
    bool depth_mask = true;

    friend bool operator==(const RasterState&, const RasterState&) = default;
    int clip_plane_count() const {
        return static_cast<int>(
            std::ranges::count_if(clip_planes_eye, [](const auto& plane) { return plane.has_value(); }));
    }
};

// ---- Fragments: textures (3.8), fog (3.10), per-fragment operations (4.1) ----

// What of a picture is copied.
enum class CopiedBuffer : std::uint8_t { kColors, kDepths, kStencil };

struct ObjectPicture;

// The pixels that glCopyTexImage, glCopyTexSubImage (3.8.2) or glCopyPixels (4.3.3) takes from the picture, or that a framebuffer
// object has drawn into a texture. Each renderer takes them from its own picture: with_copied_texels(). Two are the same if they
// are the same object.
struct CopiedPixels {
    CopiedBuffer buffer = CopiedBuffer::kColors;
    int width = 0, height = 1;
    // How many copies follow each other: 1 if the picture shows no copied pixels, 2 if it shows those of such a picture.
    int depth = 1;
    // What a framebuffer object shows, and the lower left corner there; null: the window's picture, at a TakePixels.
    std::shared_ptr<const ObjectPicture> drawn{};
    int x = 0, y = 0;
};

// Takes pixels from a rectangle of the picture as it is now: an item of the frame for a texture, or what a Draw begins with.
struct TakePixels {
    std::shared_ptr<const CopiedPixels> pixels;
    Rectangle from;  // of the same size, unless the frame was resized
};

// Texels of an image over those that it had before, all in one layer.
struct ImagePart {
    int x = 0, y = 0, z = 0, width = 0, height = 1;
    std::shared_ptr<const CopiedPixels> copied{};  // of the same size; null: `texels`
    std::vector<glm::vec4> texels{};               // as TextureImage has them

    // Whether none of `other` can be seen.
    bool covers(const ImagePart& other) const {
        return x <= other.x && y <= other.y && z == other.z && x + width >= other.x + other.width &&
               y + height >= other.y + other.height;
    }
};

// One level of a texture. The texels hold the components of the base internal format (table 3.15) as numbers in [0,1],
// rounded to the bits of the internal format; other components are 0 (alpha 1). Row 0 is t = 0; layer 0 is r = 0.
struct TextureImage {
    int width = 0, height = 1, depth = 1;  // without the border
    // GL_ALPHA, _LUMINANCE, _LUMINANCE_ALPHA, _INTENSITY, _RGB, _RGBA or _DEPTH_COMPONENT
    Enum base_format = kGL_RGBA;
    Enum internal_format = kGL_RGBA;  // as given; all levels of a complete texture have the same
    std::vector<glm::vec4> texels{};  // (R, G, B, A); luminance, intensity and depths have R = G = B = the value
    // What only pictures decide: copied pixels, and the image with copied pixels whose mipmap this is (3.8.8). A renderer
    // draws with images that have neither.
    std::vector<ImagePart> parts{};  // over the texels, in this order
    std::shared_ptr<const TextureImage> half_of{};

    bool has_copies() const { return !parts.empty() || half_of; }
    // The number of a texel in `texels`.
    std::size_t index(int x, int y, int z = 0) const {
        const std::size_t row =
            static_cast<std::size_t>(z) * static_cast<std::size_t>(height) + static_cast<std::size_t>(y);
        return row * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
    const glm::vec4& texel(int x, int y, int z = 0) const { return texels[index(x, y, z)]; }
    bool has_size_of(const TextureImage& other) const {
        return width == other.width && height == other.height && depth == other.depth;
    }
    // Whether a level of half the size follows it (3.8.8).
    bool is_halved() const { return width > 1 || height > 1 || depth > 1; }
    TextureImage half_size() const {  // without texels
        return {.width = std::max(1, width / 2),
                .height = std::max(1, height / 2),
                .depth = std::max(1, depth / 2),
                .base_format = base_format,
                .internal_format = internal_format};
    }
};

struct Texture {                         // 3.8.4, table 3.18
    Enum target = kGL_TEXTURE_2D;        // or GL_TEXTURE_1D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP
    std::vector<TextureImage> levels{};  // levels[0] is the base; missing levels are empty images
    // A cube map's levels for the faces -x, +y, -y, +z and -z; `levels` holds those of +x. Row 0 is at t = 0 of the face.
    std::array<std::vector<TextureImage>, 5> further_faces{};
    Enum min_filter = kGL_NEAREST_MIPMAP_LINEAR;
    Enum mag_filter = kGL_LINEAR;
    Enum wrap_s = kGL_REPEAT;
    Enum wrap_t = kGL_REPEAT;
    Enum wrap_r = kGL_REPEAT;
    glm::dvec4 border_color{0, 0, 0, 0};
    double priority = 1;
    bool generate_mipmap = false;
    double lod_bias = 0;                     // a Draw's is in its TextureUnit
    double min_lod = -1000, max_lod = 1000;  // limits of the level of detail
    double max_anisotropy = 1;  // EXT_texture_filter_anisotropic: at most as many samples along the longer axis
    // Only for textures that hold depths (3.8.14). The texture environment gets the depth, or, if depths are compared with r,
    // the outcome: 0 or 1. It gets that as a texel of the format depth_mode.
    Enum depth_mode = kGL_LUMINANCE;  // or GL_INTENSITY, GL_ALPHA
    Enum compare_mode = kGL_NONE;     // or GL_COMPARE_R_TO_TEXTURE
    Enum compare_func = kGL_LEQUAL;
    // The first level in use, and the last. A Draw's texture has only the levels in use: they count from 0 again.
    int base_level = 0, max_level = 1000;

    bool is_cube() const { return target == kGL_TEXTURE_CUBE_MAP; }
    bool is_flat() const { return target == kGL_TEXTURE_1D; }    // no t
    bool is_volume() const { return target == kGL_TEXTURE_3D; }  // s, t and r
    std::size_t face_count() const { return is_cube() ? 1 + further_faces.size() : 1; }
    const std::vector<TextureImage>& face(std::size_t i) const { return i == 0 ? levels : further_faces.at(i - 1); }
    std::vector<TextureImage>& face(std::size_t i) { return i == 0 ? levels : further_faces.at(i - 1); }
    bool has_copies() const {
        const auto has = [](const std::vector<TextureImage>& images) {
            return std::ranges::any_of(images, &TextureImage::has_copies);
        };
        return has(levels) || std::ranges::any_of(further_faces, has);
    }
    // A texture that has images either has depths or colours.
    bool has_depths() const { return levels.front().base_format == kGL_DEPTH_COMPONENT; }
    bool compares() const { return has_depths() && compare_mode == kGL_COMPARE_R_TO_TEXTURE; }
    bool needs_r() const { return is_cube() || is_volume() || compares(); }
    // The base internal format that the texture environment sees.
    Enum base_format() const { return has_depths() ? depth_mode : levels.front().base_format; }
    // The border's colour with the components that the texels have (table 3.15).
    glm::dvec4 border_texel() const {
        const glm::dvec4 c = glm::clamp(border_color, 0.0, 1.0);
        switch (levels.front().base_format) {
            case kGL_ALPHA: return {0, 0, 0, c.a};
            case kGL_DEPTH_COMPONENT:
            case kGL_LUMINANCE: return {c.r, c.r, c.r, 1};
            case kGL_LUMINANCE_ALPHA: return {c.r, c.r, c.r, c.a};
            case kGL_INTENSITY: return {c.r, c.r, c.r, c.r};
            case kGL_RGB: return {c.r, c.g, c.b, 1};
            default: return c;
        }
    }
    // Whether a filter is linear. Then GL_CLAMP blends in the border colour (3.8.7); otherwise it equals
    // GL_CLAMP_TO_EDGE.
    bool filters_linearly() const {
        return mag_filter == kGL_LINEAR || min_filter == kGL_LINEAR || min_filter == kGL_LINEAR_MIPMAP_NEAREST ||
               min_filter == kGL_LINEAR_MIPMAP_LINEAR;
    }
};

// A texture coordinate that GL computes from each vertex (2.11.4).
struct GeneratedCoordinate {
    int coordinate = 0;          // 0 to 3: s, t, r, q
    Enum mode = kGL_EYE_LINEAR;  // or GL_OBJECT_LINEAR, GL_SPHERE_MAP, GL_REFLECTION_MAP, GL_NORMAL_MAP
    glm::dvec4 plane{0};         // of GL_OBJECT_LINEAR in object coordinates, of GL_EYE_LINEAR in eye coordinates

    friend bool operator==(const GeneratedCoordinate&, const GeneratedCoordinate&) = default;
    bool needs_normal() const { return mode != kGL_OBJECT_LINEAR && mode != kGL_EYE_LINEAR; }
};

// GL_COMBINE (3.8.13, tables 3.24 and 3.25): a function of up to three arguments for the colour, another for alpha. An
// argument is a source seen through an operand.
struct Combine {
    // GL_REPLACE, GL_MODULATE, GL_ADD, GL_ADD_SIGNED, GL_INTERPOLATE or GL_SUBTRACT; `rgb` also GL_DOT3_RGB or
    // GL_DOT3_RGBA, which gives alpha too.
    Enum rgb = kGL_MODULATE, alpha = kGL_MODULATE;
    // GL_TEXTURE, GL_TEXTUREn, GL_CONSTANT, GL_PRIMARY_COLOR or GL_PREVIOUS.
    std::array<Enum, 3> rgb_sources{kGL_TEXTURE, kGL_PREVIOUS, kGL_CONSTANT};
    std::array<Enum, 3> alpha_sources{kGL_TEXTURE, kGL_PREVIOUS, kGL_CONSTANT};
    std::array<Enum, 3> rgb_operands{kGL_SRC_COLOR, kGL_SRC_COLOR, kGL_SRC_ALPHA};
    std::array<Enum, 3> alpha_operands{kGL_SRC_ALPHA, kGL_SRC_ALPHA, kGL_SRC_ALPHA};
    int rgb_scale = 1, alpha_scale = 1;  // 1, 2 or 4

    // The number of arguments of a function.
    static std::size_t arguments_of(Enum function) {
        return function == kGL_REPLACE ? 1 : function == kGL_INTERPOLATE ? 3 : 2;
    }
    // Whether `rgb` gives alpha too.
    bool gives_alpha() const { return rgb == kGL_DOT3_RGBA; }
    // Whether an argument that counts comes from texture unit `number`, named GL_TEXTUREn.
    bool reads_unit(std::size_t number) const {
        const auto reads = [&](Enum function, const std::array<Enum, 3>& sources) {
            return std::find(sources.begin(), sources.begin() + static_cast<std::ptrdiff_t>(arguments_of(function)),
                             kGL_TEXTURE0 + static_cast<Enum>(number)) !=
                   sources.begin() + static_cast<std::ptrdiff_t>(arguments_of(function));
        };
        return reads(rgb, rgb_sources) || (!gives_alpha() && reads(alpha, alpha_sources));
    }

    friend auto operator<=>(const Combine&, const Combine&) = default;  // NOLINT: not a null pointer
};

struct TextureUnit {
    std::shared_ptr<const Texture> texture;  // null if texturing is disabled or the texture incomplete (3.8.10)
    Enum env_mode = kGL_MODULATE;            // 3.8.13: or GL_DECAL, GL_REPLACE, GL_BLEND, GL_ADD, GL_COMBINE
    glm::dvec4 env_color{0, 0, 0, 0};
    Combine combine{};             // of GL_COMBINE; the initial one for other modes
    double lod_bias = 0;           // GL_TEXTURE_LOD_BIAS of the unit and of the texture: their sum, limited (3.8.8)
    glm::dmat4 texture_matrix{1};  // multiplies every texture coordinate (2.11.2)
    // They replace the vertices' own coordinates; in the order s, t, r, q.
    std::vector<GeneratedCoordinate> generated{};
    bool coord_replace = false;  // 3.3.1: point sprites have coordinates of their own

    friend bool operator==(const TextureUnit&, const TextureUnit&) = default;
};

struct Fog {  // 3.10; the factor f depends on the distance |z_eye|, or on the vertices' fog coordinates
    bool enabled = false;
    bool by_coordinates = false;  // GL_FOG_COORD_SRC is GL_FOG_COORD
    Enum mode = kGL_EXP;          // or GL_LINEAR, GL_EXP2
    double density = 1;
    double start = 0;
    double end = 1;
    glm::dvec4 color{0, 0, 0, 0};

    friend bool operator==(const Fog&, const Fog&) = default;
};

struct Scissor {  // 4.1.2
    bool enabled = false;
    Rectangle box;

    friend bool operator==(const Scissor&, const Scissor&) = default;
};

inline constexpr int kMaxStencil = 255;  // the stencil buffer of Twinlight's contexts has 8 bits

struct StencilFace {  // 4.1.5, 4.2.2
    Enum func = kGL_ALWAYS;
    int ref = 0;  // as given; the test clamps it to [0, kMaxStencil]
    std::uint32_t mask = ~0U;
    Enum fail = kGL_KEEP;        // the operation where the stencil test fails
    Enum depth_fail = kGL_KEEP;  // where only the depth test fails
    Enum depth_pass = kGL_KEEP;  // where both pass
    std::uint32_t write_mask = ~0U;

    friend bool operator==(const StencilFace&, const StencilFace&) = default;
};

struct StencilTest {
    StencilFace front, back;  // front also counts for points and lines

    friend bool operator==(const StencilTest&, const StencilTest&) = default;
};

struct FragmentState {
    Scissor scissor;
    bool alpha_test = false;  // 4.1.4
    Enum alpha_func = kGL_ALWAYS;
    double alpha_ref = 0;
    std::optional<StencilTest> stencil{};      // nothing: the test is off
    bool blend = false;                        // 4.1.8
    Enum blend_equation = kGL_FUNC_ADD;        // or GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT, GL_MIN, GL_MAX
    Enum blend_equation_alpha = kGL_FUNC_ADD;  // differs only by glBlendEquationSeparate
    Enum blend_src = kGL_ONE, blend_dst = kGL_ZERO;
    Enum blend_src_alpha = kGL_ONE, blend_dst_alpha = kGL_ZERO;  // differ only by glBlendFuncSeparate
    glm::dvec4 blend_color{0, 0, 0, 0};
    std::optional<Enum> logic_op{};                          // 4.1.10, in place of blending; nothing: off
    std::array<bool, 4> color_mask{true, true, true, true};  // 4.2.2
    bool color_sum = false;  // 3.9: only without lighting; with lighting the secondary colour is always added
    // Not in GL: `#pragma twinlight transfer(srgb)`. Colours are linear light and are converted to sRGB after fog.
    bool srgb_coded = false;

    friend bool operator==(const FragmentState&, const FragmentState&) = default;
};

// ---- Draws ----

// The materials of both faces.
struct Materials {
    Material front, back;

    friend bool operator==(const Materials&, const Materials&) = default;
};

// Whether a mode of glBegin draws polygons (2.6.1), which have two faces, rather than points or lines.
inline bool draws_polygons(Enum mode) { return mode >= kGL_TRIANGLES; }

// A texture unit above unit 0 that has a texture.
struct FurtherUnit {
    std::size_t number = 1;
    TextureUnit unit{};
};

// Where glCopyPixels has the colours, depths or stencil values of a Draw's pixels from.
struct CopiedGroups {
    TakePixels source;               // just before the Draw
    std::vector<glm::ivec2> places;  // in the source, of each of the Draw's vertices
    // Pixel transfer (3.6.5): what becomes of each 8-bit value of red, green, blue and alpha, in [0,1]; of a depth; and of each
    // stencil value.
    std::array<std::array<double, 256>, 4> colors{};
    double depth_scale = 1, depth_bias = 0;
    std::array<std::uint8_t, kMaxStencil + 1> stencils{};
};

// The pixels of a bitmap or of a pixel rectangle, with (0, 0) in the lower left corner of the window. They are drawn at their
// places whatever the Draw's matrices and viewport are.
struct WindowPixels {
    std::vector<glm::ivec2> places{};  // of each of the Draw's vertices
    std::vector<double> depths{};      // of each of them, or one of all, in [0,1]
    // 4.3.1: stencil values, which are written instead of colours and depths. Then the Draw has a stencil test that always writes,
    // with any reference value: by_stencil_value(). Empty until they are copied.
    bool has_stencils = false;
    std::vector<std::uint8_t> stencils{};  // of each of the vertices
    // The colours of the vertices once more, as a texture with a texel for each pixel, if many pixels with colours of their own fill a
    // rectangle: image_of_pixels(). Null otherwise.
    std::shared_ptr<const Texture> image{};
    // Where correct renderers may draw the Draw or not: rounding decides where the raster position is.
    std::vector<glm::ivec2> doubtful{};
    // What only pictures decide. A renderer draws with pixels that have none: with_copied_texels().
    std::shared_ptr<const CopiedGroups> copied{};

    double depth(std::size_t vertex) const { return depths.size() == 1 ? depths.front() : depths[vertex]; }
    friend bool operator==(const WindowPixels&, const WindowPixels&) = default;
};
// Pixels beyond are not kept. A viewport of this size, a power of two, puts their centres exactly there with floats.
inline constexpr int kMostWindowPixels = 8192;
inline constexpr Rectangle kWindowOfPixels{0, 0, kMostWindowPixels, kMostWindowPixels};

// A call of a display list (5.4).
struct ListCall {
    std::uint32_t name = 0;
    Place place;                              // of glCallList or glCallLists; in a list, of the line that compiled it
    glm::dmat4 eye_from_object{1};            // the modelview matrix then
    std::shared_ptr<const ListCall> outer{};  // the call of the list that calls it; null if none does
};

// One batch of primitives with all state that affects it.
struct Draw {
    Enum mode = kGL_TRIANGLES;  // glBegin's primitive type
    SharedVector<Vertex> vertices;
    // In the order of their attributes: texture coordinates of further_units; secondary colours, which are added after texturing,
    // without lighting (3.9), unless all are black or GL_COLOR_SUM is off; fog coordinates, if fog asks for them.
    std::vector<VertexColumn> columns;
    SharedVector<std::uint32_t> indices;  // into vertices, in drawing order; empty: 0, 1, 2, ...

    LightingState lighting;
    RasterState raster;
    TextureUnit texture;                     // unit 0
    std::vector<FurtherUnit> further_units;  // those with a texture, in ascending order
    Fog fog;
    FragmentState fragment;
    // The materials of the vertices, if glMaterial is called between glBegin and glEnd. Then materials[0] equals
    // lighting.front and lighting.back. Empty if the whole Draw has one material.
    std::vector<Materials> materials;
    glm::dmat4 eye_from_object{1};
    glm::dmat4 clip_from_eye{1};
    Place place;           // the place of glBegin or of the shape
    bool in_list = false;  // a display list draws it; then a driver may cut quadrilaterals the other way
    std::shared_ptr<const ListCall> list{};  // the call of the innermost list that draws it; null if none does
    // Draws with the same number, unless it is 0, have the same state: at most `mode`, `materials` and the values of vertices
    // differ. Different numbers say nothing. Whoever changes the state of a frame's Draw sets it to 0, as
    // Frame::editable_draws() does.
    std::uint64_t state_number = 0;
    // Of glBitmap, glDrawPixels and glCopyPixels (3.6.4, 3.7, 4.3.3), otherwise null. The mode is GL_POINTS, the viewport kWindowOfPixels. The
    // vertices have the values of the raster position, which make the colours as for any point.
    std::shared_ptr<const WindowPixels> pixels{};
    // The curved surfaces that the mesh approximates; null if the mesh is exact. Draws that share them are the parts of
    // one shape and follow each other.
    std::shared_ptr<const std::vector<Surface>> surfaces;

    // Whether glPolygonMode draws a face of polygons in this mode (3.5.4), unless culling removes it.
    bool draws_polygons_as(Enum polygon_mode) const {
        return draws_polygons(mode) &&
               (raster.polygon_mode_front == polygon_mode || raster.polygon_mode_back == polygon_mode);
    }
    // Whether polygons are drawn as edges or corners.
    bool draws_borders() const { return draws_polygons_as(kGL_LINE) || draws_polygons_as(kGL_POINT); }
    bool draws_points() const { return mode == kGL_POINTS || draws_polygons_as(kGL_POINT); }
    bool draws_sprites() const { return raster.point_sprite && draws_points(); }
    // Whether every fragment is a point's.
    bool draws_only_points() const {
        return mode == kGL_POINTS || (draws_polygons(mode) && raster.polygon_mode_front == kGL_POINT &&
                                      raster.polygon_mode_back == kGL_POINT);
    }
    bool draws_lines() const { return (mode != kGL_POINTS && !draws_polygons(mode)) || draws_polygons_as(kGL_LINE); }

    // Whether textures are combined by more than one texture unit or by GL_COMBINE.
    bool combines_textures() const {
        return !further_units.empty() || (texture.texture && texture.env_mode == kGL_COMBINE);
    }
    // Whether the picture gets pixels->image as it is: nothing but fragment operations changes its colours.
    bool shows_only_image() const {
        return pixels && pixels->image && !texture.texture && further_units.empty() && !lighting.enabled &&
               !fog.enabled && !column(VertexAttribute::kSecondaryColor);
    }
    // Visits the texture units that have a texture: visit(number, unit), in ascending order.
    template <class Visit>
    void for_each_unit(const Visit& visit) const {
        if (texture.texture) visit(std::size_t{0}, texture);
        for (const FurtherUnit& further : further_units) visit(further.number, further.unit);
    }
    bool shows_copies() const {
        bool shows = pixels && pixels->copied;
        for_each_unit([&](std::size_t, const TextureUnit& unit) { shows = shows || unit.texture->has_copies(); });
        return shows;
    }
    // Calls change(Rectangle&) for the rectangle of the window that the Draw's pixels are copied from, if they are.
    template <class Change>
    void change_source(const Change& change) {
        if (!pixels || !pixels->copied || pixels->copied->source.pixels->drawn) return;
        CopiedGroups groups = *pixels->copied;
        change(groups.source.from);
        WindowPixels changed = *pixels;
        changed.copied = std::make_shared<const CopiedGroups>(std::move(groups));
        pixels = std::make_shared<const WindowPixels>(std::move(changed));
    }
    // The values of an attribute that Vertex does not have; null if the Draw needs none.
    const std::vector<glm::dvec4>* column(VertexAttribute attribute) const {
        const auto found = std::ranges::find(columns, attribute, &VertexColumn::attribute);
        return found == columns.end() ? nullptr : &found->values;
    }
    // A texture coordinate of a vertex, of a unit that has a texture.
    const glm::dvec4& tex_coord(std::size_t unit, std::size_t vertex) const {
        const std::vector<glm::dvec4>* further = column(tex_coord_attribute(unit));
        return further ? (*further)[vertex] : vertices[vertex].tex_coord;
    }

    // Whether Shading::kExact draws surfaces instead of the mesh. It does so only for filled polygons whose texture
    // coordinates are not generated (GL generates them for vertices), that have at most one texture and no GL_COMBINE,
    // no texture that needs r (a cube map, one of three dimensions, depths to compare r with), no secondary colours
    // without lighting and no fog coordinates,
    // and only if both faces have the same stencil test: shaders draw a surface as a rectangle, whose face is not the
    // surface's.
    bool has_exact_surfaces() const {
        return surfaces && !draws_borders() && !combines_textures() && texture.generated.empty() &&
               !(texture.texture && texture.texture->needs_r()) && !column(VertexAttribute::kSecondaryColor) &&
               !column(VertexAttribute::kFogCoord) && raster.viewport.width > 0 && raster.viewport.height > 0 &&
               (!fragment.stencil || fragment.stencil->front == fragment.stencil->back);
    }

    std::size_t count() const { return indices.empty() ? vertices.size() : indices.size(); }
    std::uint32_t index(std::size_t i) const { return indices.empty() ? static_cast<std::uint32_t>(i) : indices[i]; }
};

// Whether a Draw and the next one are parts of one shape or of one glBegin.
inline bool are_one_shape(const Draw& draw, const Draw& next) {
    return draw.place == next.place && draw.surfaces == next.surfaces;
}

// Visits the vertices with these numbers in this order; all vertices if `numbers` is empty.
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
    bool stencil = false;
    bool accumulation = false;
    int clear_stencil = 0;             // of which the buffer has the lowest 8 bits
    std::uint32_t stencil_mask = ~0U;  // the front's
    glm::dvec4 clear_accumulation{0, 0, 0, 0};

    // Whether the picture before shows neither in colours nor in depths.
    bool hides_picture() const {
        return color && depth && !scissor.enabled && color_mask == std::array{true, true, true, true};
    }
};

// glAccum (4.2.4). Obeys the scissor; GL_RETURN also obeys the colour mask.
struct Accumulate {
    Enum op = kGL_LOAD;  // GL_ACCUM, GL_LOAD, GL_RETURN, GL_MULT or GL_ADD
    double value = 1;
    Scissor scissor{};
    std::array<bool, 4> color_mask{true, true, true, true};
};

using FrameItem = std::variant<Clear, Draw, Accumulate, TakePixels>;
using FrameItems = std::vector<FrameItem>;

// What the images that are attached to a framebuffer object show at one time. A picture of its own, which textures have as copied
// pixels; the items of a Frame are only those of the window.
struct ObjectPicture {
    int width = 0, height = 0;
    FrameItems items{};
    std::size_t bytes = 0;
    int depth = 1;  // as CopiedPixels has it
};

// A Draw of stencil values as one Draw for each value, with that reference value.
std::vector<Draw> by_stencil_value(const Draw& draw);

// How many of the first items no later item can show, because a Clear or a glAccum at the end hides them.
std::size_t hidden_items(std::span<const FrameItem> items);

// Which renderers lack a command or state of the scene.
enum class MissingFrom : std::uint8_t {
    kFrame,          // the Frame lacks it, so shaders and the reference do; the driver executes it
    kEverything,     // all renderers lack it; it is not sent to the driver either
    kShaders,        // only the shaders lack it
    kFixedFunction,  // only the fixed function lacks it
};

// A command or state that some renderer lacks: its name, how often it occurs, and its first place.
struct Unsupported {
    std::string name;  // "glEnable(GL_FOG)"
    int count = 0;
    Place first;
    MissingFrom missing_from = MissingFrom::kFrame;
};

// A text over the picture (#pragma twinlight label). No renderer draws it.
struct SceneLabel {
    std::string text;
    glm::dvec2 place_picture;  // (0, 0): the picture's lower left corner; (1, 1): its upper right one
};

// The picture that State builds from a scene's commands.
struct Frame {
    int width = 0;
    int height = 0;
    std::vector<FrameItem> items{};  // in the order of the commands
    std::vector<Unsupported> unsupported{};
    // The names of display lists that another list called before they existed.
    std::vector<std::uint32_t> lists_called_before_made{};
    // What LightSource::typed counts; the first has GL's initial values. Empty in a Frame that State did not make.
    std::vector<TypedLight> typed_lights{};
    std::vector<SceneLabel> labels{};
    // Whether Draws show copied pixels. Then a renderer draws with_copied_texels() of this.
    bool copies_pixels = false;
    // Earlier pictures that textures have copies of, oldest first, each up to the last TakePixels that counts.
    std::vector<std::shared_ptr<const FrameItems>> earlier{};
    bool is_object = false;  // an ObjectPicture: only for a DrawSource
    // What StateOptions::memory counts of it, and the pixels of the largest picture of a framebuffer object.
    std::size_t bytes = 0, object_pixels = 0;

    // The items that are Draws, without the others.
    std::vector<const Draw*> draws() const { return draws_of<const Draw>(items); }
    // The same to change their state. From now on none is known to have the state of another.
    std::vector<Draw*> editable_draws() {
        std::vector<Draw*> all = draws_of<Draw>(items);
        for (Draw* draw : all) draw->state_number = 0;
        return all;
    }

  private:
    template <class Type, class Items>
    static std::vector<Type*> draws_of(Items& items) {
        std::vector<Type*> draws;
        for (auto& item : items)
            if (Type* draw = std::get_if<Draw>(&item)) draws.push_back(draw);
        return draws;
    }
};

// Whether glAccum combines pictures.
inline bool accumulates(const Frame& frame) {
    return std::ranges::any_of(frame.items,
                               [](const FrameItem& item) { return std::holds_alternative<Accumulate>(item); });
}

}  // namespace twinlight
