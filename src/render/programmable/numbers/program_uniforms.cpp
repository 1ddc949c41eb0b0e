#include "render/programmable/numbers/program_uniforms.h"

#include <fmt/format.h>

#include <array>

namespace twinlight::programmable {

std::string clip_plane_name(int i) { return fmt::format("u_clip_plane{}_object", i); }

ValueSet<DrawValue> values_of_draw(const EffectSet& effects, const Form& form) {
    using enum DrawValue;
    ValueSet<DrawValue> values;
    values.add(kClipFromObject);
    values.add(kGeneratedEyeFromObject, effects.generates_from_direction());
    values.add(kGeneratedNormalFromObject, effects.generated_normal() != GeneratedNormal::kUnused);
    values.add({kPointEyeFromObject, kPointAttenuation, kPointSizes}, effects.attenuated_points);
    if (effects.has_fog()) {
        const bool is_linear = effects.fog == FogEffect::kLinear;
        values.add(kEyeZFromObject, !effects.fog_coords);
        values.add(kEyeWFromObject, !effects.fog_coords && effects.vertex_w);
        values.add(kFogColor);
        values.add({kFogEnd, kFogScale}, is_linear);
        values.add(kFogDensity, !is_linear);
    }
    if (!effects.lighting) return values;
    if (form.wide_range) {
        values.add({kObjectScale, kEyeFromObjectTurned});
        values.add({kViewerNearObject, kViewerWayEye}, effects.local_viewer);
    } else if (form.object_space) {
        values.add(effects.local_viewer ? kViewerObject : kViewerDirObject);
    } else {
        values.add(kEyeFromObject, effects.needs_position_eye());
    }
    if (effects.needs_normal()) {
        values.add(kEyeFromObjectNormal, !form.object_space);
        values.add(kNormalScale, form.rescale);
        values.add(kNormalUnit, form.sized_normals);
    }
    return values;
}

ValueSet<TextureValue> values_of_texture(const TextureEffects& texture, const Form& form, std::size_t unit) {
    using enum TextureValue;
    ValueSet<TextureValue> values;
    values.add(kSampler);
    values.add(kMatrix, texture.matrix);
    values.add(kEnvColor, texture.environment == TextureEnvironment::kBlend ||
                              texture.environment == TextureEnvironment::kCombine);
    constexpr std::array kObjectPlanes = {kPlaneSObject, kPlaneTObject, kPlaneRObject, kPlaneQObject};
    constexpr std::array kEyePlanes = {kPlaneSEye, kPlaneTEye, kPlaneREye, kPlaneQEye};
    for (std::size_t i = 0; i < texture.generated.size(); ++i)
        if (texture.generated[i] == Generated::kLinear)
            values.add(form.kept && form.kept->eye_planes.at(unit)[i] ? kEyePlanes[i] : kObjectPlanes[i]);
    return values;
}

ValueSet<SurfaceValue> values_of_surface(const SurfaceForm& surface) {
    using enum SurfaceValue;
    ValueSet<SurfaceValue> values;
    switch (surface.kind) {
        case SurfaceKind::kNone: return values;
        case SurfaceKind::kSphere: values.add(kRadius); break;
        case SurfaceKind::kFrustum: values.add({kRadius, kSlope, kHalfHeight}); break;
        case SurfaceKind::kDisk:
            values.add({kInner, kOuter, kDiskSide});
            values.add(kSector, surface.sector);
            break;
        case SurfaceKind::kTorus: values.add({kTube, kRing}); break;
    }
    values.add({kRectangleNdc, kMiddleWindow, kDirection, kDirectionPerX, kDirectionPerY, kMoment, kMomentPerX,
                kMomentPerY, kClipW, kToNearPlane, kToFarPlane, kFarDepth, kHalfDepthRange, kStepX, kStepY, kStepDepth,
                kFrontSide});
    values.add({kOffsetFactor, kOffset}, surface.offset);
    values.add(kShownSide, surface.culls);
    values.add(kPointNumber, !surface.nearest);
    return values;
}

ValueSet<EsValue> es_values(const Form& form) {
    using enum EsValue;
    const bool has_lines = form.rectangles == Rectangles::kLines;
    ValueSet<EsValue> values;
    values.add(kPointSize, form.sizes_points);
    values.add(kFramebuffer, reads_stored_color(form.logic_op));
    values.add(kViewport, has_lines || form.needs_point_window());
    values.add(kLineWidth, has_lines);
    values.add({kLineStippleFactor, kLineStipplePattern}, form.line_stipple);
    values.add(kPolygonStipple, form.polygon_stipple);
    values.add(kBlendSource, form.scales_source);
    values.add(kAlphaRef, form.alpha_func != kGL_ALWAYS && form.alpha_func != kGL_NEVER);
    return values;
}

ValueSet<EsTextureValue> es_values_of_texture(const Form& form) {
    using enum EsTextureValue;
    ValueSet<EsTextureValue> values;
    values.add(kLodBias, form.lod_bias);
    values.add(kInside, form.texture_rims);
    return values;
}

UniformList uniform_list(const EffectSet& effects, const Form& form) {
    UniformList list{
        .draw = values_of_draw(effects, form), .surface = values_of_surface(form.surface), .es = es_values(form)};
    if (!effects.has_texture()) return list;
    list.texture = values_of_texture(effects.texture, form, 0);
    list.es_texture = es_values_of_texture(form);
    return list;
}

UniformList uniform_list(const UnitEffects& unit, const Form& form) {
    return {.texture = values_of_texture(unit.texture, form, unit.number), .es_texture = es_values_of_texture(form)};
}

}  // namespace twinlight::programmable
