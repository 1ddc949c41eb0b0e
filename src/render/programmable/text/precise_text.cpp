#include "render/programmable/text/precise_text.h"

#include <fmt/format.h>

#include "render/programmable/text/lighting_names.h"

namespace twinlight::programmable {
namespace {

class PreciseWriter : LightingWriter {
  public:
    using LightingWriter::LightingWriter;

    LightingText text() {
        LightingText text{
            .version = "400",  // the first with `precise`
            .libraries = {"precise.glsl", "equation.glsl"},
            .clip_position = "    gl_Position = transformed(u_clip_from_object, position);\n",
            .vertex_position = "transformed(u_eye_from_object, position)",
            .vertex_normal = form_.object_space ? "a_normal" : "transformed_normal(u_eye_from_object_normal, a_normal)",
            .uniforms = "",
            .functions = ""};
        if (effects_.normalize)
            text.vertex_normal = fmt::format("unit({})", text.vertex_normal);
        else if (form_.rescale)
            text.vertex_normal = fmt::format("rescaled({}, u_normal_scale)", text.vertex_normal);
        if (!effects_.lighting) return text;
        text.functions = names_.structs();
        for (const std::string& name : names_.faces()) text.functions += face(name);
        text.uniforms = names_.declarations();
        return text;
    }

  private:
    const char* specular_sum() const { return effects_.separate_specular ? "secondary" : "primary"; }

    std::string face(const std::string& name) {
        const FaceEffects& varying = name == "back" ? effects_.back : effects_.front;
        text_ = fmt::format("// The colours of the {} face (section 2.14.1).\nLit light_{}({}) {{\n", name, name,
                            names_.has_surface() ? "Surface surface" : "");
        if (effects_.needs_primary())
            add("    precise vec3 primary = {};  // e_cm + a_cm a_cs\n", names_.scene_color(name, varying));
        if (effects_.separate_specular) add("    precise vec3 secondary = vec3(0.0);\n");
        if (effects_.needs_normal()) add("    vec3 n = {};\n", names_.normal());
        if (effects_.local_viewer)
            add("    vec3 from_viewer_dir = unit({});  // -VPe: GL_LIGHT_MODEL_LOCAL_VIEWER\n", names_.position());
        for (std::size_t i = 0; i < effects_.lights.size(); ++i) light(i, name, varying);
        add("    Lit lit;\n");
        if (effects_.needs_primary()) add("    lit.primary = vec4(primary, {});\n", names_.alpha(name, varying));
        if (effects_.separate_specular) add("    lit.secondary = secondary;\n");
        if (effects_.needs_primary() && effects_.clamp)
            add("    lit.primary = clamp(lit.primary, 0.0, 1.0);  // section 2.14.6\n");
        if (effects_.separate_specular && effects_.clamp) add("    lit.secondary = clamp(lit.secondary, 0.0, 1.0);\n");
        return text_ + "    return lit;\n}\n\n";
    }

    // att_i spot_i; empty if both are 1.
    std::string reach(std::size_t i) {
        const LightEffects& light = effects_.lights[i];
        std::string reach;
        if (light.attenuated) reach = fmt::format("attenuation({}, vp)", names_.light(i, LightValue::kAttenuation));
        if (light.cone == SpotCone::kNone) return reach;
        const std::string spot_dir = names_.light(i, LightValue::kSpotDir);
        const std::string cos_cutoff = names_.light(i, LightValue::kCosCutoff);
        const std::string exponent = names_.light(i, LightValue::kSpotExponent);
        return reach + (reach.empty() ? "" : " * ") +
               fmt::format("spot({}, {}, {}, vp_dir)", spot_dir, cos_cutoff, exponent);
    }

    // f_i (n . h_i)^s_rm.
    std::string highlight(std::size_t i, const std::string& face, const FaceEffects& varying) {
        if (effects_.shininess == Power::kZero) return "f_i(n_dot_vp)";
        std::string n_dot_h;
        if (effects_.lights[i].directional && !effects_.local_viewer) {
            n_dot_h = fmt::format("dot3(n, {})", names_.light(i, LightValue::kHalfDir));
        } else {
            add("        precise vec3 half_sum = vp_dir {};\n",
                effects_.local_viewer ? "- from_viewer_dir" : "+ vec3(0.0, 0.0, 1.0)");
            n_dot_h = "cosine_to(n, half_sum)";
        }
        const std::string highlight =
            fmt::format("highlight(n_dot_vp, {}, {})", n_dot_h, names_.shininess(face, varying));
        return effects_.normalize ? highlight : fmt::format("bounded({})", highlight);
    }

    void light(std::size_t i, const std::string& face, const FaceEffects& varying) {
        const LightEffects& light = effects_.lights[i];
        text_ += names_.light_block(i);
        if (light.directional) {
            add("        vec3 vp_dir = {};\n", names_.light(i, LightValue::kDirection));
        } else {
            add("        precise vec3 vp = {} - {};\n", names_.light(i, LightValue::kPosition), names_.position());
            add("        vec3 vp_dir = unit(vp);\n");
        }
        add("        precise float n_dot_vp = dot3(n, vp_dir);\n");
        const std::string reach = this->reach(i);
        if (!reach.empty()) add("        precise float reach = {};\n", reach);
        const char* times = reach.empty() ? "" : " * reach";
        if (light.ambient)
            add("        primary = {}{} + primary;\n", reach.empty() ? "" : "reach * ",
                names_.product(i, face, LightValue::kAmbient, ambient_of(varying)));
        if (light.diffuse) {
            add("        precise float diffuse = max(n_dot_vp, 0.0){};\n", times);
            add("        primary = diffuse * {} + primary;\n",
                names_.product(i, face, LightValue::kDiffuse, diffuse_of(varying)));
        }
        const std::string highlight = this->highlight(i, face, varying);
        add("        precise float specular = {}{};\n", highlight, times);
        add("        {0} = specular * {1} + {0};\n    }}\n", specular_sum(),
            names_.product(i, face, LightValue::kSpecular, specular_of(varying)));
    }
};

}  // namespace

LightingText precise_lighting_text(const EffectSet& effects, const Form& form) {
    return PreciseWriter(effects, form).text();
}

}  // namespace twinlight::programmable
