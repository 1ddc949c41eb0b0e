// Attributes: the vertex data that the program of an EffectSet takes.
#pragma once

#include <string>
#include <vector>

#include "render/effect/effect_set.h"
#include "render/programmable/numbers/form.h"
#include "scene/frame/vertex_attributes.h"

namespace twinlight::programmable {

// A material property of a face that comes with each vertex.
struct VertexProperty {
    std::string name;  // "front_ambient"
    int size = 3;      // in floats: 4 for the diffuse colour, whose alpha counts, 1 for the shininess, else 3
    Material Materials::*face = nullptr;
    glm::dvec4 Material::*color = nullptr;  // null: the shininess

    std::string type() const { return size == 1 ? "float" : "vec" + std::to_string(size); }  // in GLSL
};

std::vector<VertexProperty> vertex_properties(const EffectSet& effects);

struct Attribute {
    std::string name;  // "a_position"
    int size = 4;      // in floats; the normal has a spare one, because llvmpipe fetches four faster than three
    std::string type = "vec4";  // in GLSL

    friend bool operator==(const Attribute&, const Attribute&) = default;
};

// Attribute numbers are positions in this list. A vertex's floats have the same order: the position, then as needed the
// normal, colour, texture coordinates and material properties.
std::vector<Attribute> attributes(const EffectSet& effects);

// Of these, the columns of a Draw, and all texture coordinates if units are combined.
std::vector<VertexAttribute> further_attributes(const EffectSet& effects);

// Those that follow in the program of a Form with rectangles or flat edges.
std::vector<Attribute> line_attributes(const Form& form);

// Whether the program scales normals to length 1; then the array may have them in any length.
bool makes_normals_unit(const EffectSet& effects);

}  // namespace twinlight::programmable
