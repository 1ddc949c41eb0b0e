#include "render/programmable/text/lighting_text.h"

#include <fmt/format.h>

#include "render/programmable/text/lighting_names.h"

namespace twinlight::programmable {
namespace {

class Writer : LightingWriter {
  public:
    using LightingWriter::LightingWriter;

    LightingText text() {
        LightingText text;
        text.clip_position =
            "    // Term by term: with a matrix of constants, too, this gives the same depths.\n"
            "    gl_Position = u_clip_from_object[0] * position.x + u_clip_from_object[1] * position.y +\n"
            "        u_clip_from_object[2] * position.z + u_clip_from_object[3] * position.w;\n";
        // Only these shaders draw the scene, so the driver may choose the order of the sum.
        if (form_.kept) text.clip_position = "    gl_Position = u_clip_from_object * position;\n";
        text.vertex_position = form_.wide_range     ? "u_object_scale * position"
                               : form_.object_space ? "position"
                                                    : "u_eye_from_object * position";
        const std::string normal = form_.sized_normals ? "(a_normal / size_of(a_normal))" : "a_normal";
        text.vertex_normal = form_.object_space ? normal : "u_eye_from_object_normal * " + normal;
        if (form_.rescale) text.vertex_normal = fmt::format("u_normal_scale * ({})", text.vertex_normal);
        if (effects_.normalize)
            text.vertex_normal =
                fmt::format("{}({})", form_.wide_normals ? "unit_of_any" : "unit", text.vertex_normal);  // GL_NORMALIZE
        if (!effects_.lighting) return text;
        std::string faces;
        for (const std::string& name : names_.faces()) faces += face(name);
        text.functions = fmt::format(
            "// The lighting equation (GL 2.1, section 2.14.1), in {} coordinates:\n"
            "//\n"
            "//   c_pri = e_cm + a_cm a_cs + sum_i att_i spot_i [ a_cm a_cli + (n . VP_i) d_cm d_cli\n"
            "//                                                   + f_i (n . h_i)^s_rm s_cm s_cli ]\n"
            "//\n"
            "{}{}{}",
            names_.space(),
            form_.kept ? "// Only the lights that are on and the terms that are not 0 are here.\n"
                       : "// Only the terms that this draw needs are here. Products of light and material colours are "
                         "uniforms;\n"
                         "// material colours that come with each vertex are multiplied here.\n",
            names_.structs(), faces);
        text.uniforms = names_.declarations();
        return text;
    }

  private:
    // ---- A face ----

    std::string face(const std::string& name) {
        const FaceEffects& varying = name == "back" ? effects_.back : effects_.front;
        text_ = fmt::format("// The colours of the {} face (section 2.14.1).\nLit light_{}({}) {{\n    Lit lit;\n",
                            name, name, names_.has_surface() ? "Surface surface" : "");
        if (effects_.needs_primary()) {
            add("    lit.primary.rgb = {};  // e_cm + a_cm a_cs\n", names_.scene_color(name, varying));
            add("    lit.primary.a = {};\n", names_.alpha(name, varying));
        }
        if (effects_.separate_specular) add("    lit.secondary = vec3(0.0);\n");
        if (effects_.needs_normal() && form_.sized_normals)
            add("    vec3 n = {0} / size_of({0});\n"
                "    // n is very short or long: its size comes later.\n"
                "    float n_size = min(size_of({0}) * size_of(a_normal) * u_normal_unit, 1e37);\n",
                names_.normal());
        else if (effects_.needs_normal())
            add("    vec3 n = {};\n", names_.normal());
        if (needs_vpe_dir()) add("    vec3 vpe_dir = {}\n", vpe_dir());
        if (effects_.spectral_groups > 0) start_samples();
        for (std::size_t i = 0; i < effects_.lights.size(); ++i) light(i, name, varying);
        if (effects_.spectral_groups > 0) add_samples();
        if (effects_.needs_primary()) {
            if (effects_.clamp)
                add("    lit.primary = clamp(lit.primary, 0.0, 1.0);  // section 2.14.6\n");
            else
                // The clamp keeps Mesa from treating the alpha as a constant instead of interpolating it. That would
                // change which pixels show surfaces that cross at a small angle, compared with the fixed function.
                add("    lit.primary.a = clamp(lit.primary.a, 0.0, 1.0);\n");
        }
        if (effects_.separate_specular && effects_.clamp) add("    lit.secondary = clamp(lit.secondary, 0.0, 1.0);\n");
        return text_ + "    return lit;\n}\n\n";
    }

    // The direction to the viewer is needed for reflection, and for h_i unless it is the same at every vertex.
    bool needs_vpe_dir() const {
        if (effects_.local_viewer) return true;
        bool near_light = false;
        for (const LightEffects& light : effects_.lights) near_light |= light.specular && !light.directional;
        return effects_.shininess != Power::kZero && effects_.any_light(&LightEffects::specular) &&
               (near_light || is_reflection());
    }
    std::string vpe_dir() const {
        if (effects_.local_viewer && form_.wide_range)
            return fmt::format("unit_of_any({});  // GL_LIGHT_MODEL_LOCAL_VIEWER",
                               vector_to("u_viewer_near_object", "u_viewer_way_eye"));
        if (effects_.local_viewer && form_.homogeneous)
            return fmt::format("unit_of_any(vector_from({}, vec3(0.0)));  // GL_LIGHT_MODEL_LOCAL_VIEWER",
                               names_.position());
        if (effects_.local_viewer)
            return fmt::format("unit({}{});  // GL_LIGHT_MODEL_LOCAL_VIEWER",
                               form_.object_space ? "u_viewer_object - " : "-", names_.position());
        return form_.object_space ? "u_viewer_dir_object;  // the infinite viewer"
                                  : "vec3(0.0, 0.0, 1.0);  // the infinite viewer";
    }

    // In a wide range: the vector from the vertex to a place, times the vertex's |w|, by way of the nearest vertex.
    std::string vector_to(const std::string& near_object, const std::string& way_eye) const {
        return fmt::format("vector_to{0}({1}, {3}) + abs({3}.w) * {2}", form_.position_w ? "_vertex" : "", near_object,
                           way_eye, names_.position());
    }

    // ---- A light ----

    // att_i spot_i; empty if both are 1.
    std::string reach(std::size_t i) {
        const LightEffects& light = effects_.lights[i];
        std::string reach;
        if (light.attenuated) {
            const std::string k = names_.light(i, LightValue::kAttenuation);
            reach = names_.position_is_homogeneous() ? fmt::format("attenuation_of({}, vp, {}.w)", k, names_.position())
                                                     : fmt::format("attenuation({}, length(vp))", k);
        }
        if (light.cone == SpotCone::kNone) return reach;
        if (!reach.empty()) reach += " *\n            ";
        const std::string spot_dir = names_.light(i, LightValue::kSpotDir);
        if (light.cone == SpotCone::kSmooth) {
            const std::string cos_outer = names_.light(i, LightValue::kCosOuter);
            const std::string slope = names_.light(i, LightValue::kConeSlope);
            return reach + fmt::format("smooth_cone({}, {}, {}, vp_dir)", spot_dir, cos_outer, slope);
        }
        const std::string cos_cutoff = names_.light(i, LightValue::kCosCutoff);
        const std::string exponent =
            light.spot_exponent == Power::kZero ? "0" : names_.light(i, LightValue::kSpotExponent);
        return reach + fmt::format("spot({}, {}, {}, vp_dir)", spot_dir, cos_cutoff, exponent);
    }

    bool is_reflection() const { return effects_.highlight == Highlight::kReflection; }

    // f_i (n . h_i)^s_rm, or the lecture's term with the reflection vector.
    std::string highlight(std::size_t i, const std::string& face, const FaceEffects& varying) {
        if (effects_.shininess == Power::kZero) return is_reflection() ? "1.0" : "f_i(n_dot_vp)";
        const std::string shininess = names_.shininess(face, varying);
        std::string highlight;
        if (is_reflection()) {
            highlight = fmt::format("reflected_highlight(n, vp_dir, vpe_dir, {})", shininess);
        } else {
            const bool same_half_dir = effects_.lights[i].directional && !effects_.local_viewer;
            const std::string n_dot_h = same_half_dir
                                            ? fmt::format("positive_dot(n, {})", names_.light(i, LightValue::kHalfDir))
                                            : "cosine_to_half(n, vp_dir, vpe_dir)";
            highlight = fmt::format("highlight(n_dot_vp, {}{}, {})", n_dot_h, form_.sized_normals ? " * n_size" : "",
                                    shininess);
        }
        const bool unit_normals = effects_.normalize || effects_.shading == Shading::kPhong;
        return unit_normals ? highlight : fmt::format("bounded({})", highlight);
    }

    void light(std::size_t i, const std::string& face, const FaceEffects& varying) {
        const LightEffects& light = effects_.lights[i];
        text_ += names_.light_block(i);
        if (light.meets_directions)
            add("        vec3 vp = between_directions({}, {}, {}.w);\n", names_.light(i, LightValue::kToward),
                form_.wide_range ? fmt::format("u_eye_from_object_turned * {}.xyz", names_.position())
                                 : names_.homogeneous() + ".xyz",
                form_.wide_range ? names_.position() : names_.homogeneous());
        else if (!light.directional && form_.wide_range) {
            const std::string near = names_.light(i, LightValue::kNearVertex);
            const std::string way = names_.light(i, LightValue::kWay);
            add("        vec3 vp = {};\n", vector_to(near, way));
        } else if (!light.directional && form_.homogeneous)
            add("        vec3 vp = vector_from({}, {});\n", names_.position(), names_.light(i, LightValue::kPosition));
        else if (!light.directional)
            add("        vec3 vp = {} - {};\n", names_.light(i, LightValue::kPosition), names_.position());
        if (needs_light_direction(effects_, i))
            add("        vec3 vp_dir = {};\n", light.directional ? names_.light(i, LightValue::kDirection)
                                               : names_.position_is_homogeneous() || light.meets_directions
                                                   ? "unit_of_any(vp)"
                                                   : "unit(vp)");
        if (needs_light_cosine(effects_, i)) add("        float n_dot_vp = positive_dot(n, vp_dir);\n");
        const std::string reach_value = reach(i), reach_times = reach_value.empty() ? "" : "reach * ";
        if (!reach_value.empty()) add("        float reach = {};\n", reach_value);

        if (light.ambient) term(i, face, LightValue::kAmbient, reach_times, ambient_of(varying));
        if (light.diffuse)
            term(i, face, LightValue::kDiffuse,
                 reach_times + (form_.sized_normals ? "n_dot_vp * n_size * " : "n_dot_vp * "), diffuse_of(varying));
        if (light.specular)
            term(i, face, LightValue::kSpecular, reach_times + highlight(i, face, varying) + " * ",
                 specular_of(varying));
        text_ += "    }\n";
    }

    // `factor` ends with " * ", or is empty.
    void term(std::size_t i, const std::string& face, LightValue color, const std::string& factor,
              PerVertexColor per_vertex) {
        const bool is_secondary = effects_.separate_specular && color == LightValue::kSpecular;
        std::string sum = is_secondary ? "        lit.secondary" : "        lit.primary.rgb", product;
        if (effects_.spectral_groups > 0) {
            sum = fmt::format("        for (int g = 0; g < {}; ++g)\n            {}[g]", effects_.spectral_groups,
                              is_secondary ? "secondary_samples" : "samples");
            product = names_.sample_product(i, face, color);
        } else {
            product = names_.product(i, face, color, per_vertex);
        }
        constexpr std::size_t kLongest = 120;
        const bool fits = sum.size() + factor.size() + product.size() < kLongest;
        add("{} += {}{}{};\n", sum, fits ? factor : factor.substr(0, factor.rfind(' ')), fits ? "" : "\n            ",
            product);
    }

    // ---- Spectral samples: in groups of three, like red, green and blue ----

    std::vector<std::pair<const char*, const char*>> sampled_sums() const {
        std::vector<std::pair<const char*, const char*>> sums = {{"samples", "lit.primary.rgb"}};
        if (effects_.separate_specular) sums.emplace_back("secondary_samples", "lit.secondary");
        return sums;
    }
    void start_samples() {
        const int groups = effects_.spectral_groups;
        for (const auto& [samples, sum] : sampled_sums())
            add("    vec3 {0}[{1}];  // spectral samples, three in each vec3\n"
                "    for (int g = 0; g < {1}; ++g) {0}[g] = vec3(0.0);\n",
                samples, groups);
    }
    void add_samples() {
        const int groups = effects_.spectral_groups;
        const std::string weights = names_.model(ModelValue::kRgbFromSamples);
        for (const auto& [samples, sum] : sampled_sums())
            add("    for (int g = 0; g < {}; ++g) {} += {}[g] * {}[g];\n", groups, sum, weights, samples);
    }
};

}  // namespace

LightingText lighting_text(const EffectSet& effects, const Form& form) { return Writer(effects, form).text(); }

}  // namespace twinlight::programmable
