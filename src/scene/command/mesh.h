// The mesh of #pragma twinlight mesh("file.obj"), as the arrays and materials that GL draws it with.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scene/command/command.h"

namespace twinlight {

// Colours are red, green, blue and alpha; the shininess is in [0, 128].
struct MeshMaterial {
    std::array<float, 4> ambient{}, diffuse{}, specular{}, emission{};
    float shininess = 0;
    // The picture of map_Kd, as Command::memory of #pragma twinlight texture has it; null without one.
    std::shared_ptr<const Memory> texture = nullptr;
    int texture_width = 0, texture_height = 0;

    friend bool operator==(const MeshMaterial& a, const MeshMaterial& b);
};

// Triangles that follow each other and have the same material.
struct MeshPart {
    std::optional<MeshMaterial> material{};  // nullopt: the scene's
    std::shared_ptr<const Memory> indices;   // kUint, three for each triangle

    friend bool operator==(const MeshPart& a, const MeshPart& b);
};

struct Mesh {
    bool has_tex_coords = false;
    // kFloat, for glInterleavedArrays: GL_T2F_N3F_V3F with texture coordinates, GL_N3F_V3F without.
    std::shared_ptr<const Memory> vertices;
    std::vector<MeshPart> parts{};

    std::size_t vertex_count() const { return vertices->bytes.size() / (has_tex_coords ? 8 : 6) / sizeof(float); }
    std::size_t triangle_count() const;
    std::size_t bytes() const;  // of all arrays and pictures

    friend bool operator==(const Mesh& a, const Mesh& b);
};

}  // namespace twinlight
