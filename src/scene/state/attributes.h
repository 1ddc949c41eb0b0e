// State that is not part of a Draw: texture objects, pixel storage, hints, and all attributes that glPushAttrib saves.
#pragma once

#include <array>
#include <initializer_list>
#include <map>
#include <memory>

#include "scene/frame/frame.h"
#include "scene/frame/parameter_rows.h"

namespace twinlight {

// The texture objects (3.8). Draws share them; a shared one is copied before it is changed.
struct TextureObjects {
    std::map<std::uint32_t, std::shared_ptr<Texture>> named;  // null: the name was generated but not yet bound
    // The textures of name 0 (3.8.12).
    std::shared_ptr<Texture> default_1d = std::make_shared<Texture>(Texture{.target = kGL_TEXTURE_1D});
    std::shared_ptr<Texture> default_2d = std::make_shared<Texture>();
    std::shared_ptr<Texture> default_3d = std::make_shared<Texture>(Texture{.target = kGL_TEXTURE_3D});
    std::shared_ptr<Texture> default_cube = std::make_shared<Texture>(Texture{.target = kGL_TEXTURE_CUBE_MAP});
    std::size_t texels = 0;  // in all of them
};

std::size_t texels_of(const Texture& texture);  // in all its images
bool is_driver_only_image(Enum target);         // a target of glTexImage that only the driver supports
// Puts texels over an image with copied pixels.
void add_part(TextureImage& image, ImagePart part);

// The depth of the stacks of glPushAttrib and glPushClientAttrib: at least 16 (table 6.33); 16 in Mesa.
inline constexpr std::size_t kAttributeStackDepth = 16;
inline constexpr std::size_t kClientAttributeStackDepth = 16;

// GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT: at least 2 (EXT_texture_filter_anisotropic); 16 in Mesa
inline constexpr double kMaxAnisotropy = 16;
inline constexpr double kMaxLodBias = 16;  // GL_MAX_TEXTURE_LOD_BIAS: at least 2 (table 6.31); 16 in Mesa

// The kinds of textures that all renderers draw.
inline constexpr std::initializer_list<Enum> kTextureTargets{kGL_TEXTURE_1D, kGL_TEXTURE_2D, kGL_TEXTURE_3D,
                                                             kGL_TEXTURE_CUBE_MAP};

// An image of a texture, by the target of glTexImage.
struct ImageTarget {
    Enum texture = kGL_TEXTURE_2D;
    std::size_t face = 0;  // see Texture::face()
};

// nullopt for other targets, proxies among them.
std::optional<ImageTarget> image_target(Enum target);
// Whether the command on images has the dimensions of the texture: glTexImage3D those of GL_TEXTURE_3D.
bool has_dimensions_of(const Command& command, Enum texture);
// 1 to 3, from the name of a command on images.
int image_dimensions(const Command& command);

// How a texture coordinate is generated (2.11.4), and whether it is.
struct TexGen {
    bool enabled = false;
    Enum mode = kGL_EYE_LINEAR;
    glm::dvec4 object_plane{0};
    glm::dvec4 plane_eye{0};  // times the inverse of the modelview matrix at the call
};

// The bindings, capabilities and environment of a texture unit (3.8.13, 3.8.16).
struct TextureBindings {
    std::uint32_t bound_1d = 0, bound_2d = 0, bound_3d = 0, bound_cube = 0;
    bool enabled_1d = false, enabled_2d = false, enabled_3d = false, enabled_cube = false;
    Enum env_mode = kGL_MODULATE;
    glm::dvec4 env_color{0, 0, 0, 0};
    Combine combine;
    double lod_bias = 0;
    bool coord_replace = false;  // 3.3.1
    // Of s, t, r and q.
    std::array<TexGen, 4> tex_gen{TexGen{.object_plane = {1, 0, 0, 0}, .plane_eye = {1, 0, 0, 0}},
                                  TexGen{.object_plane = {0, 1, 0, 0}, .plane_eye = {0, 1, 0, 0}}, TexGen{}, TexGen{}};

    bool is_enabled() const { return enabled_1d || enabled_2d || enabled_3d || enabled_cube; }
    // The enabled target with more dimensions (3.8.15), if one is enabled.
    Enum target() const {
        return enabled_cube ? kGL_TEXTURE_CUBE_MAP
               : enabled_3d ? kGL_TEXTURE_3D
               : enabled_2d ? kGL_TEXTURE_2D
                            : kGL_TEXTURE_1D;
    }
    // The name of the texture that is bound to one of kTextureTargets.
    std::uint32_t& bound(Enum target) {
        switch (target) {
            case kGL_TEXTURE_1D: return bound_1d;
            case kGL_TEXTURE_2D: return bound_2d;
            case kGL_TEXTURE_3D: return bound_3d;
            default: return bound_cube;
        }
    }
    std::uint32_t bound(Enum target) const { return const_cast<TextureBindings&>(*this).bound(target); }  // NOLINT
};

// Those that are enabled, in the order s, t, r, q.
std::vector<GeneratedCoordinate> generated_coordinates(const TextureBindings& unit);

// Whether only the driver supports this texture target. A picture with one enabled is reported as partial.
bool is_driver_only_texture(Enum target);

// The layout of pixels in client memory (3.6.1, table 3.1), set by glPixelStore.
struct PixelStore {
    bool unpack_swap_bytes = false, unpack_lsb_first = false;
    int unpack_row_length = 0, unpack_skip_rows = 0, unpack_skip_pixels = 0, unpack_alignment = 4;
    int unpack_image_height = 0, unpack_skip_images = 0;
    bool pack_swap_bytes = false, pack_lsb_first = false;
    int pack_row_length = 0, pack_skip_rows = 0, pack_skip_pixels = 0, pack_alignment = 4;
    int pack_image_height = 0, pack_skip_images = 0;
};

inline constexpr std::array kPixelStoreParameters = {
    ParameterRow<PixelStore>{kGL_UNPACK_SWAP_BYTES, &PixelStore::unpack_swap_bytes},
    ParameterRow<PixelStore>{kGL_UNPACK_LSB_FIRST, &PixelStore::unpack_lsb_first},
    ParameterRow<PixelStore>{kGL_UNPACK_ROW_LENGTH, &PixelStore::unpack_row_length},
    ParameterRow<PixelStore>{kGL_UNPACK_SKIP_ROWS, &PixelStore::unpack_skip_rows},
    ParameterRow<PixelStore>{kGL_UNPACK_SKIP_PIXELS, &PixelStore::unpack_skip_pixels},
    ParameterRow<PixelStore>{kGL_UNPACK_ALIGNMENT, &PixelStore::unpack_alignment},
    ParameterRow<PixelStore>{kGL_UNPACK_IMAGE_HEIGHT, &PixelStore::unpack_image_height},
    ParameterRow<PixelStore>{kGL_UNPACK_SKIP_IMAGES, &PixelStore::unpack_skip_images},
    ParameterRow<PixelStore>{kGL_PACK_SWAP_BYTES, &PixelStore::pack_swap_bytes},
    ParameterRow<PixelStore>{kGL_PACK_LSB_FIRST, &PixelStore::pack_lsb_first},
    ParameterRow<PixelStore>{kGL_PACK_ROW_LENGTH, &PixelStore::pack_row_length},
    ParameterRow<PixelStore>{kGL_PACK_SKIP_ROWS, &PixelStore::pack_skip_rows},
    ParameterRow<PixelStore>{kGL_PACK_SKIP_PIXELS, &PixelStore::pack_skip_pixels},
    ParameterRow<PixelStore>{kGL_PACK_ALIGNMENT, &PixelStore::pack_alignment},
    ParameterRow<PixelStore>{kGL_PACK_IMAGE_HEIGHT, &PixelStore::pack_image_height},
    ParameterRow<PixelStore>{kGL_PACK_SKIP_IMAGES, &PixelStore::pack_skip_images},
};
template <>
inline constexpr std::span<const ParameterRow<PixelStore>> kParameterRows<PixelStore> = kPixelStoreParameters;

std::shared_ptr<const PolygonStipple> solid_stipple();  // every bit is 1

// The values of the vertex that glRasterPos was given, and of the state that its colours and texture coordinates come from
// (2.13). Renderers light it when it draws.
struct RasterVertex {
    VertexValues vertex;
    bool fog_by_coordinates = false;
    struct Unit {
        glm::dmat4 texture_matrix{1};
        std::vector<GeneratedCoordinate> generated{};
    };
    std::array<Unit, kMaxTextureUnits> units;
    LightingState lighting;
    glm::dmat4 eye_from_object{1}, clip_from_eye{1};
};

struct RasterPosition {
    glm::dvec4 position_window{0, 0, 0, 1};  // w is that of clip coordinates
    bool is_valid = true;
    bool is_doubtful = false;  // whether it is valid depends on rounding
    double doubt = 0;          // how far off a driver may be, in pixels; 0 if the position was given in whole pixels
    std::shared_ptr<const RasterVertex> vertex = std::make_shared<const RasterVertex>();
};

// What glDrawPixels and glTexImage do with colours (3.6.3, 3.6.5). The tables of glPixelMap are used if map_color is set.
struct PixelTransfer {
    glm::dvec4 scale{1}, bias{0};
    double depth_scale = 1, depth_bias = 0;
    bool map_color = false;

    bool is_initial() const { return *this == PixelTransfer{}; }
    friend bool operator==(const PixelTransfer&, const PixelTransfer&) = default;
};
using PixelMaps = std::array<std::vector<double>, 4>;  // from red to red, ...
// What glDrawPixels and glCopyPixels do with stencil values (3.6.3, 3.6.5).
struct StencilTransfer {
    int shift = 0, offset = 0;
    bool map = false;  // by the table of GL_PIXEL_MAP_S_TO_S
};
inline constexpr int kMaxPixelMap = 256;  // GL_MAX_PIXEL_MAP_TABLE: at least 32 (table 6.32); 256 in Mesa

struct ClipPlane {  // 2.12
    bool enabled = false;
    glm::dvec4 equation_eye{0, 0, 0, 0};
};

// One variable of glMapGrid (5.1): `segments` equal steps from `first` to `last`.
struct MapGrid {
    int segments = 1;
    double first = 0, last = 1;

    double at(int i) const { return i == 0 ? first : i == segments ? last : first + i * ((last - first) / segments); }
};

// Hints (5.6), by target. They change no pixel, but can be queried.
using Hints = std::map<Enum, Enum>;

// All state that some bit of glPushAttrib saves (6.1.14, tables 6.5 to 6.35).
struct Attributes {
    LightingState lighting;
    RasterState raster;      // without what a Draw gets only if it is enabled: clip planes, stipples
    FragmentState fragment;  // without what a Draw gets only if it is enabled: the stencil test, the logical operation
    bool line_stipple_enabled = false, polygon_stipple_enabled = false, logic_op_enabled = false;
    LineStipple line_stipple;
    std::shared_ptr<const PolygonStipple> polygon_stipple = solid_stipple();
    Enum logic_op = kGL_COPY;
    bool stencil_enabled = false;
    StencilTest stencil_test;
    Fog fog;
    std::array<TextureBindings, kMaxTextureUnits> units;
    std::size_t active_unit = 0;  // glActiveTexture's
    std::array<ClipPlane, kMaxClipPlanes> clip_planes;
    VertexValues current;
    RasterPosition raster_position;
    PixelTransfer pixel_transfer;
    StencilTransfer stencil_transfer;
    glm::dvec2 pixel_zoom{1, 1};
    Clear clear;              // the values to clear with
    bool draws_color = true;  // false: glDrawBuffer(GL_NONE)
    Hints hints{{kGL_PERSPECTIVE_CORRECTION_HINT, kGL_DONT_CARE},
                {kGL_POINT_SMOOTH_HINT, kGL_DONT_CARE},
                {kGL_LINE_SMOOTH_HINT, kGL_DONT_CARE},
                {kGL_POLYGON_SMOOTH_HINT, kGL_DONT_CARE},
                {kGL_FOG_HINT, kGL_DONT_CARE},
                {kGL_GENERATE_MIPMAP_HINT, kGL_DONT_CARE},
                {kGL_TEXTURE_COMPRESSION_HINT, kGL_DONT_CARE}};
    MapGrid grid1, grid2_u, grid2_v;
    Enum matrix_mode = kGL_MODELVIEW;
    std::uint32_t list_base = 0;
    // The enabled capabilities that only the driver supports, with the place of glEnable. The key is the capability and
    // its texture unit (0 for capabilities without units).
    std::map<std::pair<Enum, std::size_t>, Place> driver_only{{{kGL_DITHER, 0}, {}}, {{kGL_MULTISAMPLE, 0}, {}}};
};

}  // namespace twinlight
