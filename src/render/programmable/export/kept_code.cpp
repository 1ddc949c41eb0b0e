#include "render/programmable/export/kept_code.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include "base/text/translation.h"
#include "scene/command/names.h"

namespace twinlight::programmable {
Code kept_code(const Draw& draw, const Plan& plan, Glsl version) {
    Code code{plan.effects, {}, {}, {}};
    EffectSet& effects = code.effects;
    Form& form = code.form;
    form.rescale = plan.lighting.rescale_normal && effects.needs_normal() && !effects.normalize &&
                   effects.shading != Shading::kPhong;
    KeptForm kept;
    for (const PlannedLight& light : plan.lights) {
        kept.lights.push_back(light.number);
        kept.light_count = std::max(kept.light_count, light.number + 1);
    }
    for (int i = 0; i < kMaxClipPlanes; ++i)
        if (draw.raster.clip_planes_eye[static_cast<std::size_t>(i)]) kept.clip_planes.push_back(i);
    const auto add_unit = [&](std::size_t number, const TextureEffects& texture, const TextureUnit& unit) {
        std::array<bool, 4>& eye_planes = kept.eye_planes[number];
        for (const GeneratedCoordinate& one : unit.generated) {
            const auto i = static_cast<std::size_t>(one.coordinate);
            eye_planes[i] = texture.generated[i] == Generated::kLinear && one.mode == kGL_EYE_LINEAR;
        }
        kept.rescales_generated = kept.rescales_generated || (texture.generated_normal == GeneratedNormal::kUnchanged &&
                                                              draw.lighting.rescale_normal);
    };
    if (effects.has_texture()) add_unit(0, effects.texture, draw.texture);
    for (const UnitEffects& effect : effects.units)
        draw.for_each_unit([&](std::size_t number, const TextureUnit& unit) {
            if (number == effect.number) add_unit(number, effect.texture, unit);
        });
    // Otherwise the size is a number: point_size().
    if (!draw.raster.point_parameters.depends_on_distance()) effects.attenuated_points = false;
    form.kept = std::move(kept);
    set_dialect(code, draw, version);
    return code;
}

std::string why_not_kept(const Frame& frame) {
    for (const Draw* draw : frame.draws()) {
        if (!draw->lighting.enabled) continue;
        if (draw->lighting.light_model.spectrum)
            return tr("it multiplies colours as spectra (#pragma twinlight spectrum)");
        for (std::size_t i = kMostKeptLights; i < draw->lighting.lights.size(); ++i)
            if (draw->lighting.lights[i].enabled)
                return tr("it uses {}, and they have at most {} lights", light_name(static_cast<int>(i)),
                          kMostKeptLights);
    }
    return "";
}

}  // namespace twinlight::programmable
