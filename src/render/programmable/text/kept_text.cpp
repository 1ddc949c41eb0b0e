#include "render/programmable/text/kept_text.h"

#include <cstddef>
#include <string>

#include "scene/frame/frame.h"

namespace twinlight::programmable {

namespace {

// Also those of the texture units of a Draw that combines textures: "u_texture_matrix1" becomes "TextureMatrix1".
Words names_with_units(Words names) {
    const Words of_one = names;
    for (const auto& [name, kept] : of_one) {
        const bool is_unit = name == "a_tex_coord" || name.starts_with("u_texture") || name.starts_with("u_plane");
        if (!is_unit) continue;
        const std::size_t end = kept.find_first_of("0[");
        for (std::size_t unit = 0; unit < kMaxTextureUnits; ++unit)
            names[name + std::to_string(unit)] = kept.substr(0, end) + std::to_string(unit);
    }
    return names;
}

}  // namespace

const Words& kept_names() {
    static const Words kNames = names_with_units({{"a_position", "Vertex"},
                                                  {"a_normal", "Normal"},
                                                  {"a_color", "Color"},
                                                  {"a_tex_coord", "MultiTexCoord0"},
                                                  {"a_secondary_color", "SecondaryColor"},
                                                  {"a_fog_coord", "FogCoord"},
                                                  {"a_pixel_ndc", "PixelNdc"},
                                                  {"u_clip_from_object", "ModelViewProjectionMatrix"},
                                                  {"u_eye_from_object", "ModelViewMatrix"},
                                                  {"u_eye_from_object_normal", "NormalMatrix"},
                                                  {"u_normal_scale", "NormalScale"},
                                                  {"u_texture_matrix", "TextureMatrix[0]"},
                                                  {"u_generated_eye_from_object", "ModelViewMatrix"},
                                                  {"u_generated_normal_from_object", "NormalMatrix"},
                                                  {"u_plane_s_object", "ObjectPlaneS[0]"},
                                                  {"u_plane_t_object", "ObjectPlaneT[0]"},
                                                  {"u_plane_r_object", "ObjectPlaneR[0]"},
                                                  {"u_plane_q_object", "ObjectPlaneQ[0]"},
                                                  {"u_plane_s_eye", "EyePlaneS[0]"},
                                                  {"u_plane_t_eye", "EyePlaneT[0]"},
                                                  {"u_plane_r_eye", "EyePlaneR[0]"},
                                                  {"u_plane_q_eye", "EyePlaneQ[0]"},
                                                  {"u_texture", "Texture0"},
                                                  {"u_texture_env_color", "TextureEnvColor[0]"},
                                                  {"u_texture_lod_bias", "TextureLodBias"},
                                                  {"u_texture_inside", "TextureInside"},
                                                  {"u_framebuffer", "Framebuffer"},
                                                  {"u_viewport", "Viewport"},
                                                  {"u_line_width", "LineWidth"},
                                                  {"u_line_stipple_factor", "LineStippleFactor"},
                                                  {"u_line_stipple_pattern", "LineStipplePattern"},
                                                  {"u_polygon_stipple", "PolygonStipple"},
                                                  {"a_edge_position", "EdgePosition"},
                                                  {"a_line_other", "LineOther"},
                                                  {"a_line_corner", "LineCorner"},
                                                  {"a_point_corner", "PointCorner"},
                                                  {"a_line_count", "LineCount"},
                                                  {"u_point_size", "PointSize"},
                                                  {"u_point_eye_from_object", "ModelViewMatrix"},
                                                  {"u_point_attenuation", "PointAttenuation"},
                                                  {"u_point_sizes", "PointSizes"},
                                                  {"u_blend_source", "BlendSource"},
                                                  {"u_alpha_ref", "AlphaRef"},
                                                  {"u_fog_color", "Fog.color.rgb"},
                                                  {"u_fog_end", "Fog.end"},
                                                  {"u_fog_scale", "Fog.scale"},
                                                  {"u_fog_density", "Fog.density"}});
    return kNames;
}

}  // namespace twinlight::programmable
