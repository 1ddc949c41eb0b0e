#include "scene/command/mesh.h"

namespace twinlight {

namespace {

bool is_same(const std::shared_ptr<const Memory>& a, const std::shared_ptr<const Memory>& b) {
    return a == b || (a && b && a->bytes == b->bytes);
}

}  // namespace

bool operator==(const MeshMaterial& a, const MeshMaterial& b) {
    return a.ambient == b.ambient && a.diffuse == b.diffuse && a.specular == b.specular && a.emission == b.emission &&
           a.shininess == b.shininess && is_same(a.texture, b.texture) && a.texture_width == b.texture_width;
}

bool operator==(const MeshPart& a, const MeshPart& b) {
    return a.material == b.material && is_same(a.indices, b.indices);
}

bool operator==(const Mesh& a, const Mesh& b) {
    return a.has_tex_coords == b.has_tex_coords && is_same(a.vertices, b.vertices) && a.parts == b.parts;
}

std::size_t Mesh::triangle_count() const {
    std::size_t count = 0;
    for (const MeshPart& part : parts) count += part.indices->bytes.size() / sizeof(std::uint32_t) / 3;
    return count;
}

std::size_t Mesh::bytes() const {
    std::size_t bytes = vertices->bytes.size();
    for (const MeshPart& part : parts) {
        bytes += part.indices->bytes.size();
        if (part.material && part.material->texture) bytes += part.material->texture->bytes.size();
    }
    return bytes;
}

}  // namespace twinlight
