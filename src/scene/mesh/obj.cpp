#include "scene/mesh/obj.h"

#include <fmt/format.h>

#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <span>
#include <stdexcept>
#include <tuple>

#include "base/text/input_text.h"
#include "base/text/translation.h"
#include "scene/command/lexer.h"

namespace twinlight {

namespace {

// Reads the files that mtllib names.
class Materials : public tinyobj::MaterialReader {
  public:
    explicit Materials(const MeshFiles& files) : files_(files) {}

    bool operator()(const std::string& name, std::vector<tinyobj::material_t>* materials,
                    std::map<std::string, int>* numbers, std::string* warning, std::string* error) override {
        std::string text;
        try {
            text = files_.text(name);
            if (text.size() > kMaxMtlBytes)
                throw std::runtime_error(tr("the file has more than {} MiB", kMaxMtlBytes >> 20));
            if (text.find('\0') != std::string::npos) throw std::runtime_error(tr("this is not a text file"));
        } catch (const std::runtime_error& failure) {
            throw std::runtime_error(fmt::format("{}: {}", in_quotes(name), failure.what()));
        }
        InputText in(text);
        tinyobj::LoadMtl(numbers, materials, &in, warning, error);
        return true;
    }

  private:
    const MeshFiles& files_;
};

std::shared_ptr<const Memory> memory_of(Kind kind, const void* values, std::size_t bytes) {
    Memory memory{.kind = kind, .bytes = std::vector<std::byte>(bytes)};
    if (bytes > 0) std::memcpy(memory.bytes.data(), values, bytes);
    return std::make_shared<const Memory>(std::move(memory));
}

MeshMaterial material_of(const tinyobj::material_t& from, const MeshFiles& files) {
    const auto color = [&](const tinyobj::real_t(&rgb)[3], float alpha) {
        const std::array<float, 4> made = {rgb[0], rgb[1], rgb[2], alpha};
        if (!std::ranges::all_of(made, [](float c) { return std::isfinite(c); }))
            throw std::runtime_error(tr("the material {} has a colour that is not finite", in_quotes(from.name)));
        return made;
    };
    MeshMaterial made;
    made.ambient = color(from.ambient, 1);
    made.diffuse = color(from.diffuse, from.dissolve);
    // Illumination model 1 has no highlight.
    if (from.illum != 1) made.specular = color(from.specular, 1);
    made.emission = color(from.emission, 1);
    // OBJ files have exponents up to 1000; GL_SHININESS ends at 128 (2.14.1).
    made.shininess = from.shininess > 0 ? std::min(from.shininess, 128.F) : 0.F;
    if (from.diffuse_texname.empty()) return made;
    try {
        ImageFile image = files.image(from.diffuse_texname);
        made.texture_width = image.width;
        made.texture_height = image.height;
        made.texture =
            std::make_shared<const Memory>(Memory{Kind::kUbyte, std::move(image.rgba), from.diffuse_texname});
    } catch (const std::runtime_error& failure) {
        throw std::runtime_error(tr("the material {} has the picture {}: {}", in_quotes(from.name),
                                    in_quotes(from.diffuse_texname), failure.what()));
    }
    return made;
}

// Builds the arrays of a Mesh from the triangles that tinyobjloader made.
class Builder {
  public:
    explicit Builder(const tinyobj::attrib_t& attributes)
        : attributes_(attributes),
          has_tex_coords_(!attributes.texcoords.empty()),
          sums_(attributes.vertices.size() / 3, glm::dvec3(0)) {}

    // Adds a triangle's unit normal to the sums of its vertices. A triangle without an area has none.
    void add_normal(std::span<const tinyobj::index_t> corners) {
        const glm::dvec3 a = position(corners[0]);
        const glm::dvec3 across = glm::cross(position(corners[1]) - a, position(corners[2]) - a);
        const double length = glm::length(across);
        if (!(length > 0) || !std::isfinite(length)) return;
        for (const tinyobj::index_t& corner : corners)
            sums_[static_cast<std::size_t>(corner.vertex_index)] += across / length;
    }

    // The number of the vertex with these indices.
    std::uint32_t vertex(const tinyobj::index_t& corner) {
        const auto [known, is_new] =
            numbers_.try_emplace({corner.vertex_index, corner.texcoord_index, corner.normal_index},
                                 static_cast<std::uint32_t>(numbers_.size()));
        if (!is_new) return known->second;
        if (has_tex_coords_) {
            for (int i = 0; i < 2; ++i)
                values_.push_back(corner.texcoord_index < 0 ? 0
                                                            : attributes_.texcoords[at(corner.texcoord_index, 2, i)]);
        }
        const glm::dvec3 normal = normal_of(corner);
        for (int i = 0; i < 3; ++i) values_.push_back(static_cast<float>(normal[i]));
        for (int i = 0; i < 3; ++i) values_.push_back(attributes_.vertices[at(corner.vertex_index, 3, i)]);
        return known->second;
    }

    std::shared_ptr<const Memory> vertices() const {
        return memory_of(Kind::kFloat, values_.data(), values_.size() * sizeof(float));
    }

  private:
    static std::size_t at(int index, std::size_t size, int i) {
        return static_cast<std::size_t>(index) * size + static_cast<std::size_t>(i);
    }

    glm::dvec3 position(const tinyobj::index_t& corner) const {
        const auto value = [&](int i) { return attributes_.vertices[at(corner.vertex_index, 3, i)]; };
        return {value(0), value(1), value(2)};
    }

    glm::dvec3 normal_of(const tinyobj::index_t& corner) const {
        if (corner.normal_index >= 0) {
            const auto value = [&](int i) { return attributes_.normals[at(corner.normal_index, 3, i)]; };
            return {value(0), value(1), value(2)};
        }
        const glm::dvec3 sum = sums_[static_cast<std::size_t>(corner.vertex_index)];
        const double length = glm::length(sum);
        return length > 0 ? sum / length : glm::dvec3(0);
    }

    const tinyobj::attrib_t& attributes_;
    bool has_tex_coords_;
    std::vector<glm::dvec3> sums_;  // of the normals around each position
    std::map<std::tuple<int, int, int>, std::uint32_t> numbers_;
    std::vector<float> values_;
};

void check_indices(const tinyobj::attrib_t& attributes, const std::vector<tinyobj::shape_t>& shapes) {
    const auto is_in = [](int index, std::size_t values, std::size_t size, bool may_be_missing) {
        return index < 0 ? may_be_missing : static_cast<std::size_t>(index) < values / size;
    };
    for (const tinyobj::shape_t& shape : shapes)
        for (const tinyobj::index_t& corner : shape.mesh.indices)
            if (!is_in(corner.vertex_index, attributes.vertices.size(), 3, false) ||
                !is_in(corner.texcoord_index, attributes.texcoords.size(), 2, true) ||
                !is_in(corner.normal_index, attributes.normals.size(), 3, true))
                throw std::runtime_error(tr("a face uses a vertex that the file does not have"));
}

}  // namespace

std::shared_ptr<const Mesh> read_obj(std::string_view text, const MeshFiles& files) {
    InputText lines(obj_lines(text));
    tinyobj::attrib_t attributes;
    std::vector<tinyobj::shape_t> shapes;
    std::vector<tinyobj::material_t> materials;
    std::string warning, error;
    Materials reader(files);
    if (!tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error, &lines, &reader, true, false))
        throw std::runtime_error(error.empty() ? tr("this is no OBJ file") : error.substr(0, error.find('\n')));
    check_indices(attributes, shapes);

    Builder builder(attributes);
    for (const tinyobj::shape_t& shape : shapes)
        for (std::size_t i = 0; i + 3 <= shape.mesh.indices.size(); i += 3)
            builder.add_normal(std::span(shape.mesh.indices).subspan(i, 3));

    Mesh mesh;
    mesh.has_tex_coords = !attributes.texcoords.empty();
    std::vector<std::uint32_t> indices;
    int material = -1;
    std::map<int, MeshMaterial> made;
    const auto end_part = [&] {
        if (indices.empty()) return;
        MeshPart part{.indices = memory_of(Kind::kUint, indices.data(), indices.size() * sizeof(std::uint32_t))};
        if (material >= 0) {
            const auto number = static_cast<std::size_t>(material);
            const auto known = made.find(material);
            part.material =
                known != made.end() ? known->second : made[material] = material_of(materials.at(number), files);
        }
        mesh.parts.push_back(std::move(part));
        indices.clear();
    };
    for (const tinyobj::shape_t& shape : shapes) {
        for (std::size_t i = 0; i + 3 <= shape.mesh.indices.size(); i += 3) {
            const int own = shape.mesh.material_ids.at(i / 3);
            if (own != material) end_part();
            material = own;
            for (std::size_t k = 0; k < 3; ++k) indices.push_back(builder.vertex(shape.mesh.indices[i + k]));
        }
    }
    end_part();
    if (mesh.parts.empty()) throw std::runtime_error(tr("the faces of this file have no area"));
    mesh.vertices = builder.vertices();
    return std::make_shared<const Mesh>(std::move(mesh));
}

}  // namespace twinlight
