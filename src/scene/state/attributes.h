// What State holds beside what a Draw does: the texture objects, the pixel store, the hints, and what glPushAttrib saves.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <variant>

#include "scene/state/frame.h"

namespace twinlight {

// 3.8: the texture objects. They are shared with the Draws that use them, and copied before they are changed where a
// Draw holds one.
struct TextureObjects {
    std::map<std::uint32_t, std::shared_ptr<Texture>> named;  // null: a name that was generated and not bound yet
    // The textures of name 0 (3.8.12).
    std::shared_ptr<Texture> default_1d = std::make_shared<Texture>(Texture{.target = kGL_TEXTURE_1D});
    std::shared_ptr<Texture> default_2d = std::make_shared<Texture>();
    std::size_t texels = 0;  // of all of them
};

std::size_t texels_of(const Texture& texture);  // of all its images

// The stacks of glPushAttrib and glPushClientAttrib (table 6.33: at least this; Mesa's).
inline constexpr std::size_t kAttributeStackDepth = 16;
inline constexpr std::size_t kClientAttributeStackDepth = 16;

inline constexpr std::size_t kMaxTextureUnits = 8;  // GL_MAX_TEXTURE_UNITS: two at least (table 6.31), eight in Mesa

// A texture unit: its bindings, capabilities and environment (3.8.13, 3.8.16). Draws are textured by unit 0; where
// another is on, that is named as unsupported.
struct TextureBindings {
    std::uint32_t bound_1d = 0, bound_2d = 0;
    bool enabled_1d = false, enabled_2d = false;
    Enum env_mode = kGL_MODULATE;
    glm::dvec4 env_color{0, 0, 0, 0};
    double lod_bias = 0;
};

// Whether this is a target of textures that State does not follow: a picture that is drawn with one enabled says so.
bool is_driver_only_texture(Enum target);

// How pixels lie in client memory (3.6.1, table 3.1); glPixelStore sets them by name.
struct PixelStore {
    bool unpack_swap_bytes = false, unpack_lsb_first = false;
    int unpack_row_length = 0, unpack_skip_rows = 0, unpack_skip_pixels = 0, unpack_alignment = 4;
    int unpack_image_height = 0, unpack_skip_images = 0;
    bool pack_swap_bytes = false, pack_lsb_first = false;
    int pack_row_length = 0, pack_skip_rows = 0, pack_skip_pixels = 0, pack_alignment = 4;
    int pack_image_height = 0, pack_skip_images = 0;
};

// The members of PixelStore by the names of glPixelStore.
struct PixelStoreRow {
    Enum pname;
    std::variant<bool PixelStore::*, int PixelStore::*> member;

    double value(const PixelStore& store) const {
        return std::visit([&](auto at) { return static_cast<double>(store.*at); }, member);
    }
};
inline constexpr PixelStoreRow kPixelStoreRows[] = {
    {kGL_UNPACK_SWAP_BYTES, &PixelStore::unpack_swap_bytes},
    {kGL_UNPACK_LSB_FIRST, &PixelStore::unpack_lsb_first},
    {kGL_UNPACK_ROW_LENGTH, &PixelStore::unpack_row_length},
    {kGL_UNPACK_SKIP_ROWS, &PixelStore::unpack_skip_rows},
    {kGL_UNPACK_SKIP_PIXELS, &PixelStore::unpack_skip_pixels},
    {kGL_UNPACK_ALIGNMENT, &PixelStore::unpack_alignment},
    {kGL_UNPACK_IMAGE_HEIGHT, &PixelStore::unpack_image_height},
    {kGL_UNPACK_SKIP_IMAGES, &PixelStore::unpack_skip_images},
    {kGL_PACK_SWAP_BYTES, &PixelStore::pack_swap_bytes},
    {kGL_PACK_LSB_FIRST, &PixelStore::pack_lsb_first},
    {kGL_PACK_ROW_LENGTH, &PixelStore::pack_row_length},
    {kGL_PACK_SKIP_ROWS, &PixelStore::pack_skip_rows},
    {kGL_PACK_SKIP_PIXELS, &PixelStore::pack_skip_pixels},
    {kGL_PACK_ALIGNMENT, &PixelStore::pack_alignment},
    {kGL_PACK_IMAGE_HEIGHT, &PixelStore::pack_image_height},
    {kGL_PACK_SKIP_IMAGES, &PixelStore::pack_skip_images},
};

struct ClipPlane {  // 2.12
    bool enabled = false;
    glm::dvec4 equation_eye{0, 0, 0, 0};
};

// 5.6: hints change no pixel here; they can be asked for. By target.
using Hints = std::map<Enum, Enum>;

// All that a bit of glPushAttrib saves (6.1.14, tables 6.5 to 6.35): State's own copy of it is what commands change.
struct Attributes {
    LightingState lighting;
    RasterState raster;  // without the clip planes, which a Draw gets from clip_planes
    FragmentState fragment;
    Fog fog;
    std::array<TextureBindings, kMaxTextureUnits> units;
    std::size_t active_unit = 0;  // glActiveTexture's
    std::array<ClipPlane, kMaxClipPlanes> clip_planes;
    Vertex current;           // colour, normal, texture coordinates, edge flag
    Clear clear;              // the clear colour and depth
    bool draws_color = true;  // false: glDrawBuffer(GL_NONE)
    // What a picture is partial by, where it is drawn with it: values of which Draws have none, and where they were set.
    std::optional<Place> secondary_color;    // other than black
    std::optional<Place> fog_coordinates;    // GL_FOG_COORD_SRC is GL_FOG_COORD
    std::map<Enum, Place> point_parameters;  // that are not GL's initial ones
    Hints hints{{kGL_PERSPECTIVE_CORRECTION_HINT, kGL_DONT_CARE},
                {kGL_POINT_SMOOTH_HINT, kGL_DONT_CARE},
                {kGL_LINE_SMOOTH_HINT, kGL_DONT_CARE},
                {kGL_POLYGON_SMOOTH_HINT, kGL_DONT_CARE},
                {kGL_FOG_HINT, kGL_DONT_CARE},
                {kGL_GENERATE_MIPMAP_HINT, kGL_DONT_CARE},
                {kGL_TEXTURE_COMPRESSION_HINT, kGL_DONT_CARE}};
    Enum matrix_mode = kGL_MODELVIEW;
    std::uint32_t list_base = 0;
    // Capabilities that State does not follow and that are on, with where that was said: by the capability and its
    // texture unit, 0 for those that have none.
    std::map<std::pair<Enum, std::size_t>, Place> driver_only{{{kGL_DITHER, 0}, {}}, {{kGL_MULTISAMPLE, 0}, {}}};
};

}  // namespace twinlight
