// Attributes: what the program of an EffectSet takes of each vertex.
#pragma once

#include <string>
#include <vector>

#include "render/effect/effect_set.h"

namespace twinlight::programmable {

// A property of a face's material that every vertex brings.
struct VertexProperty {
    std::string name;  // "front_ambient"
    int size = 3;      // in floats: 4 of the diffuse colour, whose alpha counts; 1 of the shininess
    Material Materials::*face = nullptr;
    glm::dvec4 Material::*color = nullptr;  // null: the shininess

    std::string type() const { return size == 1 ? "float" : "vec" + std::to_string(size); }  // in GLSL
};

std::vector<VertexProperty> vertex_properties(const EffectSet& effects);

struct Attribute {
    std::string name;  // "a_position"
    int size = 4;  // in floats of the array; llvmpipe fetches four faster than three, so the normal has one to spare
    std::string type = "vec4";  // in GLSL

    friend bool operator==(const Attribute&, const Attribute&) = default;
};

// Their numbers are their places in the list; a vertex's floats stand in this order, too: the position, then as they are
// called for the normal, the colour, the texture coordinate, and the material's properties.
std::vector<Attribute> attributes(const EffectSet& effects);

// Whether the program makes normals unit vectors: then the array may have them in any length.
bool makes_normals_unit(const EffectSet& effects);

}  // namespace twinlight::programmable
