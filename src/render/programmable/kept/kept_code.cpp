#include "render/programmable/kept/kept_code.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include "scene/command/names.h"

namespace twinlight::programmable {
namespace {

constexpr int kMostKeptLights = 16;  // MOST_LIGHTS of loader.c; OpenGL promises room for this many uniforms

}  // namespace

Code kept_code(const Draw& draw, const Plan& plan, Glsl version) {
    Code code{plan.effects, {}, {}, {}};
    EffectSet& effects = code.effects;
    Form& form = code.form;
    form.position_w = !plan.vertices.w_is_1;
    form.rescale = plan.lighting.rescale_normal && effects.needs_normal() && !effects.normalize &&
                   effects.shading != Shading::kPhong;
    KeptForm kept;
    for (const PlannedLight& light : plan.lights) {
        kept.lights.push_back(light.number);
        kept.light_count = std::max(kept.light_count, light.number + 1);
    }
    for (int i = 0; i < kMaxClipPlanes; ++i)
        if (draw.raster.clip_planes_eye[static_cast<std::size_t>(i)]) kept.clip_planes.push_back(i);
    const TextureEffects& texture = effects.texture;
    for (const GeneratedCoordinate& one : draw.texture.generated) {
        const auto i = static_cast<std::size_t>(one.coordinate);
        kept.eye_planes[i] = texture.generated[i] == Generated::kLinear && one.mode == kGL_EYE_LINEAR;
    }
    kept.rescales_generated = texture.generated_normal == GeneratedNormal::kUnchanged && draw.lighting.rescale_normal;
    form.kept = std::move(kept);
    set_dialect(code, draw, version);
    return code;
}

std::string why_not_kept(const Frame& frame) {
    if (frame.copies_pixels) return "it copies pixels of its picture (glCopyPixels)";
    for (const Draw* draw : frame.draws()) {
        if (!draw->further_units.empty()) return "it uses more than one texture unit (glActiveTexture)";
        if (draw->combines_textures()) return "it combines textures with GL_COMBINE (glTexEnv)";
        if (draw->raster.point_parameters.depends_on_distance())
            return "its points become smaller with the distance (glPointParameter)";
        if (!draw->lighting.enabled) continue;
        if (draw->lighting.light_model.spectrum) return "it multiplies colours as spectra (#pragma twinlight spectrum)";
        for (std::size_t i = kMostKeptLights; i < draw->lighting.lights.size(); ++i)
            if (draw->lighting.lights[i].enabled)
                return fmt::format("it uses {}, and they have at most {} lights", light_name(static_cast<int>(i)),
                                   kMostKeptLights);
    }
    return "";
}

}  // namespace twinlight::programmable
