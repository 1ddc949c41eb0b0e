#include "render/programmable/text/lighting_names.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>

#include "render/programmable/numbers/vertex_attributes.h"

namespace twinlight::programmable {
namespace {

// GL's name of a face's material, in shaders to keep.
std::string kept_material(const std::string& face) { return face == "back" ? "BackMaterial" : "FrontMaterial"; }

}  // namespace

bool shares_faces(const EffectSet& effects) {
    return effects.two_side && effects.shading == Shading::kPhong && effects.front == effects.back;
}

std::vector<std::string> LightingNames::faces() const {
    if (shares_faces(effects_)) return {"shown"};
    return effects_.two_side ? std::vector<std::string>{"front", "back"} : std::vector<std::string>{"front"};
}

std::string LightingNames::uniform(std::string_view type, const std::string& name, std::string_view comment,
                                   const std::string& array) {
    if (declared_.insert(name).second)
        declarations_ +=
            fmt::format("uniform {} {}{};{}{}\n", type, name, array, comment.empty() ? "" : "  // ", comment);
    return name;
}

template <class Name>
std::string LightingNames::of_face(const std::string& face, const Name& name) {
    if (face != "shown") return name(face);
    const std::string front = name("front"), back = name("back");
    return fmt::format("({} ? {} : {})", is_front(), front, back);
}

// ---- Lights ----

// The uniform of a light, of a face's colours too.
std::string LightingNames::light_uniform(std::size_t i, const LightUniform& one, const std::string& face) {
    const int length = loop_length(effects_, form_, i);
    const std::string name = name_of(i, one, face);
    return length == 0 ? uniform(one.type, name, one.comment)
                       : uniform(one.type, name, one.comment, fmt::format("[{}]", length)) + "[i]";
}

// No Draw gives a value that is not in the list.
LightUniform LightingNames::listed(std::size_t i, LightValue value) const {
    const LightUniform one = declaration_of(value, effects_, form_, i);
    if (!values_of_light(effects_, form_, i).contains(value))
        throw std::logic_error(fmt::format("values_of_light() lacks {} of light {}", one.name, i));
    return one;
}

std::string LightingNames::light(std::size_t i, LightValue value) {
    return form_.kept ? kept_light(i, value) : light_uniform(i, listed(i, value));
}

// The same from GL's own state.
std::string LightingNames::kept_light(std::size_t i, LightValue value) {
    const int number = form_.kept->lights.at(i);
    const std::string source = fmt::format("LightSource[{}].", number);
    switch (value) {
        case LightValue::kPosition: return fmt::format("{0}position.xyz / {0}position.w", source);
        case LightValue::kToward: return source + "position.xyz";
        case LightValue::kDirection: return fmt::format("unit({}position.xyz)", source);
        case LightValue::kHalfDir: return source + "halfVector.xyz";
        case LightValue::kSpotDir: return fmt::format("unit({}spotDirection)", source);
        case LightValue::kCosCutoff: return source + "spotCosCutoff - 4.8e-7";  // kCosineRounding
        case LightValue::kSpotExponent:
            return effects_.lights[i].spot_exponent == Power::kWhole ? fmt::format("int({}spotExponent)", source)
                                                                     : source + "spotExponent";
        case LightValue::kAttenuation:
            return fmt::format(
                "vec3({0}constantAttenuation, {0}linearAttenuation,\n                {0}quadraticAttenuation)", source);
        case LightValue::kCosOuter:
        case LightValue::kConeSlope:
            return uniform("float", kept_cone_name(number, value), "the lecture's smooth cone (not in GL)");
        case LightValue::kAmbient: return source + "ambient";
        case LightValue::kDiffuse: return source + "diffuse";
        case LightValue::kSpecular: return source + "specular";
        case LightValue::kNearVertex:
        case LightValue::kWay: break;  // shaders to keep have no wide range
    }
    throw std::logic_error("shaders to keep have no such value of a light");
}

std::string LightingNames::light_block(std::size_t i) {
    if (form_.kept) return fmt::format("    {{  // {}\n", light_name(form_.kept->lights.at(i)));
    if (loop_length(effects_, form_, i) == 0) return fmt::format("    {{  // light{}\n", i);
    const std::string count = uniform("int", name_of_count(i), "the number of lights in this loop");
    return fmt::format("    for (int i = 0; i < {}; ++i) {{  // light{}\n", count, i);
}

std::string LightingNames::product(std::size_t i, const std::string& face, LightValue light_color,
                                   PerVertexColor per_vertex) {
    LightUniform one = listed(i, light_color);
    const std::string term(one.name);
    if (form_.kept) {
        const std::string color = per_vertex ? per_vertex_color(face, term, per_vertex) + ".rgb"
                                             : of_face(face, [&](const std::string& name) {
                                                   return fmt::format("{}.{}.rgb", kept_material(name), term);
                                               });
        return fmt::format("{} * {}.rgb", color, kept_light(i, light_color));
    }
    if (per_vertex) {
        one.type = effects_.spectral_products ? "mat3" : "vec3";
        one.comment.remove_prefix(one.comment.find(' ') + 1);  // "a_cm a_cli"
    }
    const std::string color = of_face(face, [&](const std::string& name) { return light_uniform(i, one, name); });
    return per_vertex ? fmt::format("({} * {}.rgb)", color, per_vertex_color(face, term, per_vertex)) : color;
}

std::string LightingNames::sample_product(std::size_t i, const std::string& face, LightValue light_color) {
    const char letter = listed(i, light_color).name.front();
    if (!sampled_colors(effects_).contains(light_color))
        throw std::logic_error("sampled_colors() lacks a colour of light " + std::to_string(i));
    const auto samples = [&](const std::string& name, const char* whose) {
        return uniform("vec3", name, letter + std::string(whose), fmt::format("[{}]", effects_.spectral_groups)) +
               "[g]";
    };
    const std::string material =
        of_face(face, [&](const std::string& name) { return samples(name_of_face_samples(name, light_color), "_cm"); });
    return fmt::format("({} * {})", material, samples(name_of_light_samples(i, light_color), "_cli"));
}

// ---- Materials ----

std::string LightingNames::model(ModelValue value) {
    const Declaration one = declaration_of(value, effects_);
    if (!values_of_model(effects_).contains(value))
        throw std::logic_error(fmt::format("values_of_model() lacks {}", one.name));
    const bool is_array = value == ModelValue::kRgbFromSamples;
    return uniform(one.type, std::string(one.name), one.comment,
                   is_array ? fmt::format("[{}]", effects_.spectral_groups) : "");
}

std::string LightingNames::material(const std::string& face, FaceValue value) {
    const Declaration one = declaration_of(value, effects_);
    if (!values_of_face(effects_, face == "back" ? effects_.back : effects_.front).contains(value))
        throw std::logic_error(fmt::format("values_of_face() lacks {} of the {} face", one.name, face));
    return uniform(one.type, name_of(face, value, effects_), one.comment);
}

std::string LightingNames::per_vertex_color(const std::string& face, const std::string& property,
                                            PerVertexColor per_vertex) {
    if (per_vertex.tracks) return "surface.color";
    return of_face(face, [&](const std::string& name) { return fmt::format("surface.{}_{}", name, property); });
}

std::string LightingNames::scene_color(const std::string& face, const FaceEffects& varying) {
    const PerVertexColor emission = emission_of(varying), ambient = ambient_of(varying);
    if (form_.kept) {
        const auto color = [&](const char* property, PerVertexColor per_vertex) {
            if (per_vertex) return per_vertex_color(face, property, per_vertex) + ".rgb";
            return of_face(
                face, [&](const std::string& name) { return fmt::format("{}.{}.rgb", kept_material(name), property); });
        };
        return fmt::format("{} + {} * LightModel.ambient.rgb", color("emission", emission), color("ambient", ambient));
    }
    std::string sum;
    const auto add = [&](const std::string& term) { sum += (sum.empty() ? "" : " + ") + term; };
    if (emission) add(per_vertex_color(face, "emission", emission) + ".rgb");
    if (!emission || !ambient)
        add(of_face(face, [&](const std::string& name) { return material(name, FaceValue::kBase); }));
    if (ambient) add(model(ModelValue::kConstantAmbient) + " * " + per_vertex_color(face, "ambient", ambient) + ".rgb");
    return sum;
}

std::string LightingNames::alpha(const std::string& face, const FaceEffects& varying) {
    if (const PerVertexColor diffuse = diffuse_of(varying)) return per_vertex_color(face, "diffuse", diffuse) + ".a";
    return of_face(face, [&](const std::string& name) {
        if (form_.kept) return kept_material(name) + ".diffuse.a";
        return material(name, FaceValue::kAlpha);
    });
}

std::string LightingNames::shininess(const std::string& face, const FaceEffects& varying) {
    const bool whole = effects_.shininess == Power::kWhole;
    if (varying.varies_shininess) {
        const std::string value =
            of_face(face, [&](const std::string& name) { return fmt::format("surface.{}_shininess", name); });
        return whole ? fmt::format("int({})", value) : value;
    }
    if (form_.kept) {
        const std::string value =
            of_face(face, [&](const std::string& name) { return kept_material(name) + ".shininess"; });
        return whole ? fmt::format("int({})", value) : value;
    }
    // softpipe's compiler takes the wrong face in a choice between the integers 1 and 0.
    const bool is_chosen = whole && face == "shown";
    const std::string value = of_face(face, [&](const std::string& name) {
        const std::string one = material(name, FaceValue::kShininess);
        return is_chosen ? fmt::format("float({}) + 0.5", one) : one;
    });
    return is_chosen ? fmt::format("int({})", value) : value;
}

// ---- Structures ----

bool LightingNames::has_surface() const {
    return effects_.needs_position_eye() || effects_.needs_normal() || effects_.needs_color() ||
           effects_.front.varies() || effects_.back.varies();
}

std::string LightingNames::structs() const {
    std::string text;
    if (has_surface()) {
        text += "struct Surface {\n";
        if (effects_.needs_position_eye())
            text += fmt::format("    {} {};  // V\n", position_is_homogeneous() ? "vec4" : "vec3", position_field());
        if (has_homogeneous()) text += "    vec4 homogeneous_eye;  // V before the division by w\n";
        if (effects_.needs_normal()) text += fmt::format("    vec3 normal_{};  // n\n", space());
        if (effects_.needs_color()) text += "    vec4 color;  // GL_COLOR_MATERIAL (section 2.14.3)\n";
        for (const VertexProperty& property : vertex_properties(effects_))
            text += fmt::format("    {} {};  // glMaterial between glBegin and glEnd (section 2.14.2)\n",
                                property.type(), property.name);
        text += "};\n\n";
    }
    text += "struct Lit {\n";
    if (effects_.needs_primary()) text += "    vec4 primary;  // c_pri\n";
    if (effects_.separate_specular) text += "    vec3 secondary;  // c_sec\n";
    return text + "};\n\n";
}

std::string LightingNames::surface(const std::string& position, const std::string& homogeneous,
                                   const std::string& normal, const std::string& prefix) const {
    std::vector<std::string> fields;
    if (effects_.needs_position_eye()) fields.push_back(position);
    if (has_homogeneous()) fields.push_back(homogeneous);
    if (effects_.needs_normal()) fields.push_back(normal);
    if (effects_.needs_color()) fields.push_back(prefix + "color");
    for (const VertexProperty& property : vertex_properties(effects_)) fields.push_back(prefix + property.name);
    return fmt::format("Surface({})", fmt::join(fields, ", "));
}

}  // namespace twinlight::programmable
