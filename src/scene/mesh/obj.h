// Reads meshes from OBJ files, with their materials from MTL files: #pragma twinlight mesh("file.obj"). tinyobjloader reads
// them. The files are untrusted, so obj_lines() first checks every line that it will read.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "scene/command/mesh.h"
#include "scene/command/text.h"

namespace twinlight {

inline constexpr std::size_t kMaxObjBytes = 64u << 20;
inline constexpr std::size_t kMaxMtlBytes = 1u << 20;
inline constexpr std::size_t kMaxMeshVertices = 2'000'000;  // positions, and texture coordinates, and normals
inline constexpr std::size_t kMaxMeshTriangles = 1'000'000;
inline constexpr std::size_t kMaxFaceCorners = 256;

// The files that an OBJ file names. Each throws std::runtime_error with the reason and a remedy.
struct MeshFiles {
    std::function<std::string(const std::string& name)> text;  // of an MTL file
    ImageLoader image = no_images;                             // of map_Kd
};

// The lines of an OBJ file that give vertices, faces and materials, without all others. Throws std::runtime_error if one has a
// number or an index that cannot be used, if there is no face, or if there are too many: "line 12: what is wrong; remedy".
std::string obj_lines(std::string_view text);

// The mesh in an OBJ file. Polygons become triangles. Corners without a normal get the sum of the unit normals of the
// triangles around their vertex, normalised. Throws std::runtime_error.
std::shared_ptr<const Mesh> read_obj(std::string_view text, const MeshFiles& files);

}  // namespace twinlight
