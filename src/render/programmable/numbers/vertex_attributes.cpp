#include "render/programmable/numbers/vertex_attributes.h"

#include <fmt/format.h>

namespace twinlight::programmable {

std::vector<VertexProperty> vertex_properties(const EffectSet& effects) {
    std::vector<VertexProperty> properties;
    const auto add_face = [&](const char* name, const FaceEffects& varying, Material Materials::*face) {
        const auto add = [&](bool varies, const char* property, int size, glm::dvec4 Material::*color) {
            if (varies) properties.push_back({fmt::format("{}_{}", name, property), size, face, color});
        };
        add(varying.varies_emission, "emission", 3, &Material::emission);
        add(varying.varies_ambient, "ambient", 3, &Material::ambient);
        add(varying.varies_diffuse, "diffuse", 4, &Material::diffuse);
        add(varying.varies_specular, "specular", 3, &Material::specular);
        add(varying.varies_shininess, "shininess", 1, nullptr);
    };
    add_face("front", effects.front, &Materials::front);
    add_face("back", effects.back, &Materials::back);
    return properties;
}

std::vector<VertexAttribute> further_attributes(const EffectSet& effects) {
    std::vector<VertexAttribute> list;
    for (const UnitEffects& unit : effects.units)
        if (!unit.texture.generates_all()) list.push_back(tex_coord_attribute(unit.number));
    if (effects.secondary_color) list.push_back(VertexAttribute::kSecondaryColor);
    if (effects.fog_coords) list.push_back(VertexAttribute::kFogCoord);
    return list;
}

std::vector<Attribute> attributes(const EffectSet& effects) {
    std::vector<Attribute> list;
    list.reserve(4);
    list.push_back({"a_position", 4});
    if (effects.takes_normal()) list.push_back({"a_normal", 4, "vec3"});
    if (effects.needs_color()) list.push_back({"a_color", 4});
    if (effects.takes_tex_coord()) list.push_back({"a_tex_coord", 4});
    for (const VertexAttribute further : further_attributes(effects)) {
        const auto& [name, size] = row_of(further);
        list.push_back({fmt::format("a_{}", name), size, size == 1 ? "float" : fmt::format("vec{}", size)});
    }
    if (effects.at_pixels) list.push_back({"a_pixel_ndc", 3, "vec3"});
    for (const VertexProperty& property : vertex_properties(effects))
        list.push_back({"a_" + property.name, property.size, property.type()});
    return list;
}

std::vector<Attribute> line_attributes(const Form& form) {
    std::vector<Attribute> list;
    if (form.flat_edges) list.push_back({"a_edge_position", 4});
    if (form.rectangles == Rectangles::kLines) {
        list.push_back({"a_line_other", 4});
        list.push_back({"a_line_corner", 3, "vec3"});
    }
    if (form.rectangles == Rectangles::kPoints) list.push_back({"a_point_corner", 3, "vec3"});
    if (form.line_stipple) list.push_back({"a_line_count", 3, "vec3"});
    return list;
}

bool makes_normals_unit(const EffectSet& effects) {
    using enum GeneratedNormal;
    const GeneratedNormal generated = effects.generated_normal();
    const bool lighting_does = effects.normalize || effects.shading == Shading::kPhong || !effects.needs_normal();
    return effects.takes_normal() && lighting_does && (generated == kUnused || generated == kUnit);
}

}  // namespace twinlight::programmable
