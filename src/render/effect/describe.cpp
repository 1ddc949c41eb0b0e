// Prints the facts of an EffectSet.
#include <fmt/format.h>

#include <initializer_list>
#include <utility>

#include "base/text/translation.h"
#include "render/effect/effect_set.h"

namespace twinlight {
namespace {

std::string describe(const LightEffects& light) {
    std::string text = tr(light.directional || light.meets_directions ? "directional" : "positional");
    const auto add = [&](bool fact, const char* name) {
        if (fact) text += tr(", ") + std::string(tr(name));
    };
    add(light.meets_directions, "vertices with w = 0");
    add(light.attenuated, "attenuated");
    add(light.cone == SpotCone::kGl, "spot");
    add(light.spot_exponent == Power::kWhole, "integer spot exponent");
    add(light.spot_exponent == Power::kReal, "spot exponent");
    add(light.cone == SpotCone::kSmooth, "smooth cone");
    add(light.ambient, "ambient");
    add(light.diffuse, "diffuse");
    add(light.specular, "specular");
    return text;
}

// The names of the facts that hold: "emission, diffuse".
std::string listed(std::initializer_list<std::pair<bool, const char*>> facts) {
    std::string text;
    for (const auto& [holds, name] : facts)
        if (holds) text += (text.empty() ? "" : tr(", ")) + std::string(tr(name));
    return text;
}

std::string tracked_names(const FaceEffects& face) {
    return listed({{face.tracks_emission, "emission"},
                   {face.tracks_ambient, "ambient"},
                   {face.tracks_diffuse, "diffuse"},
                   {face.tracks_specular, "specular"}});
}

std::string varying_names(const FaceEffects& face) {
    return listed({{face.varies_emission, "emission"},
                   {face.varies_ambient, "ambient"},
                   {face.varies_diffuse, "diffuse"},
                   {face.varies_specular, "specular"},
                   {face.varies_shininess, "shininess"}});
}

const char* name_of(TextureEnvironment environment) {
    switch (environment) {
        case TextureEnvironment::kNone: return "none";
        case TextureEnvironment::kModulate: return "modulate";
        case TextureEnvironment::kDecal: return "decal";
        case TextureEnvironment::kReplace: return "replace";
        case TextureEnvironment::kBlend: return "blend";
        case TextureEnvironment::kAdd: return "add";
        case TextureEnvironment::kCombine: return "combine";
    }
    return "";
}

const char* name_of(Texels texels) {
    switch (texels) {
        case Texels::kColor: return "colour";
        case Texels::kAlpha: return "alpha";
        case Texels::kColorAndAlpha: return "colour and alpha";
        case Texels::kIntensity: return "intensity";
    }
    return "";
}

const char* name_of(Generated generated) {
    switch (generated) {
        case Generated::kNot: return "the vertex";
        case Generated::kLinear: return "a plane";
        case Generated::kSphereMap: return "a sphere map";
        case Generated::kReflectionMap: return "the reflection";
        case Generated::kNormalMap: return "the normal";
    }
    return "";
}

std::string describe(const TextureEffects& texture) {
    std::string text = tr("{} texture with {}, {}",
                          tr(texture.one_dimensional     ? "1D"
                             : texture.three_dimensional ? "3D"
                             : texture.cube              ? "cube map"
                                                         : "2D"),
                          tr(name_of(texture.texels)), tr(name_of(texture.environment)));
    const auto add = [&](bool fact, const char* name) {
        if (fact) text += tr(", ") + std::string(tr(name));
    };
    add(texture.depth_mode != 0, texture.compares ? "depths that are compared with r" : "depths");
    add(texture.matrix, "texture matrix");
    add(texture.q, "division by q");
    add(texture.clamp_s, "GL_CLAMP of s");
    add(texture.clamp_t, "GL_CLAMP of t");
    add(texture.clamp_r, "GL_CLAMP of r");
    add(texture.gradients, "explicit gradients");
    for (std::size_t i = 0; i < texture.generated.size(); ++i)
        add(texture.generated[i] != Generated::kNot,
            tr("{} from {}", "strq"[i], tr(name_of(texture.generated[i]))).c_str());
    add(texture.generated_normal == GeneratedNormal::kUnit, "unit normals for them");
    add(texture.generated_w, "any w for them");
    return text;
}

}  // namespace

std::string describe(const EffectSet& effects) {
    std::string text;
    const auto add = [&](bool fact, const std::string& line) {
        if (fact) text += tr(std::string_view(line)) + "\n";
    };
    add(effects.lighting, "lighting");
    add(!effects.lighting, "no lighting");
    add(effects.shading == Shading::kFlat, "flat shading");
    add(effects.shading == Shading::kGouraud, "gouraud shading");
    add(effects.shading == Shading::kPhong, "phong shading");
    add(effects.clamp, "clamp");
    add(effects.two_side, "two-sided lighting");
    add(effects.local_viewer, "local viewer");
    add(effects.vertex_w, "division by w");
    add(effects.normalize, "normalize");
    add(effects.separate_specular, "separate specular colour");
    add(effects.highlight == Highlight::kReflection, "highlights by the reflection vector");
    add(effects.shininess == Power::kWhole, "integer shininess");
    add(effects.shininess == Power::kReal, "shininess");
    for (const auto& [face, name] : {std::pair{effects.front, "front"}, {effects.back, "back"}}) {
        add(face.tracks(), tr("{} material from glColor: {}", tr(name), tracked_names(face)));
        add(face.varies(), tr("{} material per vertex: {}", tr(name), varying_names(face)));
    }
    for (std::size_t i = 0; i < effects.lights.size(); ++i)
        add(true, fmt::format("light {}: {}", i, describe(effects.lights[i])));
    add(effects.has_texture(), describe(effects.texture));
    for (const UnitEffects& unit : effects.units)
        add(true, tr("texture unit {}: {}", unit.number, describe(unit.texture)));
    add(effects.fog == FogEffect::kLinear, "linear fog");
    add(effects.fog == FogEffect::kExp, "exponential fog");
    add(effects.fog == FogEffect::kExp2, "squared exponential fog");
    add(effects.fog_coords, "fog coordinates");
    add(effects.attenuated_points, "size of points by distance");
    add(effects.secondary_color, "secondary colours of vertices");
    add(effects.spectral_products, "spectral colour products");
    add(effects.spectral_groups > 0, tr("groups of three spectral samples: {}", effects.spectral_groups));
    add(effects.srgb_coded, "sRGB output");
    add(effects.at_pixels, "drawn at pixels of the window");
    add(effects.clip_plane_count > 0, tr("clip planes: {}", effects.clip_plane_count));
    return text;
}

}  // namespace twinlight
