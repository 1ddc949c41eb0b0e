// The attributes of a vertex that OpenGL calls current values (2.7), a row each. Vertex has those that most programs set; a Draw has the
// others as columns beside its vertices, and only those that its picture needs.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <string_view>
#include <vector>

namespace twinlight {

inline constexpr std::size_t kMaxTextureUnits = 8;  // GL_MAX_TEXTURE_UNITS: at least 2 (table 6.31); 8 in Mesa

enum class VertexAttribute : std::uint8_t {
    kPosition,
    kNormal,
    kColor,
    kTexCoord0,  // unit n: tex_coord_attribute(n)
    kSecondaryColor = kTexCoord0 + kMaxTextureUnits,
    kFogCoord,
};
constexpr std::size_t number_of(VertexAttribute attribute) { return static_cast<std::size_t>(attribute); }
constexpr VertexAttribute tex_coord_attribute(std::size_t unit) {
    return static_cast<VertexAttribute>(number_of(VertexAttribute::kTexCoord0) + unit);
}
// The texture unit of texture coordinates; nothing for other attributes.
constexpr std::optional<std::size_t> texture_unit_of(VertexAttribute attribute) {
    const std::size_t unit = number_of(attribute) - number_of(VertexAttribute::kTexCoord0);
    return unit < kMaxTextureUnits ? std::optional(unit) : std::nullopt;
}

struct VertexAttributeRow {
    std::string_view name;  // in GLSL after a_
    int size;               // how many of the four values renderers get
};
inline constexpr std::array kVertexAttributes{
    VertexAttributeRow{"position", 4},   VertexAttributeRow{"normal", 3},     VertexAttributeRow{"color", 4},
    VertexAttributeRow{"tex_coord0", 4}, VertexAttributeRow{"tex_coord1", 4}, VertexAttributeRow{"tex_coord2", 4},
    VertexAttributeRow{"tex_coord3", 4}, VertexAttributeRow{"tex_coord4", 4}, VertexAttributeRow{"tex_coord5", 4},
    VertexAttributeRow{"tex_coord6", 4}, VertexAttributeRow{"tex_coord7", 4}, VertexAttributeRow{"secondary_color", 3},
    VertexAttributeRow{"fog_coord", 1}};
static_assert(kVertexAttributes.size() == number_of(VertexAttribute::kFogCoord) + 1);
constexpr const VertexAttributeRow& row_of(VertexAttribute attribute) {
    return kVertexAttributes[number_of(attribute)];
}

struct Vertex {
    glm::dvec4 position_object{0, 0, 0, 1};
    glm::dvec3 normal_object{0, 0, 1};
    glm::dvec4 color{1, 1, 1, 1};
    glm::dvec4 tex_coord{0, 0, 0, 1};  // of texture unit 0
    // 2.6.2: whether the edge to the next vertex is drawn; for separate triangles, quads and polygons
    bool edge_flag = true;
    std::uint32_t material = 0;  // index into Draw::materials; 0 if that is empty
};

// An attribute that Vertex does not have, of each of a Draw's vertices.
struct VertexColumn {
    VertexAttribute attribute = VertexAttribute::kFogCoord;
    std::vector<glm::dvec4> values{};  // a fog coordinate is in x
};

// The current value of every attribute.
struct VertexValues : Vertex {
    // Of an attribute that Vertex does not have.
    glm::dvec4& further(VertexAttribute attribute) { return further_.at(place(attribute)); }
    const glm::dvec4& further(VertexAttribute attribute) const { return further_.at(place(attribute)); }
    glm::dvec4& tex_coord_of(std::size_t unit) { return unit == 0 ? tex_coord : further(tex_coord_attribute(unit)); }
    const glm::dvec4& tex_coord_of(std::size_t unit) const {
        return unit == 0 ? tex_coord : further(tex_coord_attribute(unit));
    }

  private:
    static constexpr std::size_t kFirst = number_of(VertexAttribute::kTexCoord0) + 1;
    static constexpr std::size_t place(VertexAttribute attribute) { return number_of(attribute) - kFirst; }
    static constexpr std::array<glm::dvec4, kVertexAttributes.size() - kFirst> initial() {
        std::array<glm::dvec4, kVertexAttributes.size() - kFirst> all{};
        all.fill({0, 0, 0, 1});
        return all;
    }
    std::array<glm::dvec4, kVertexAttributes.size() - kFirst> further_ = initial();
};

}  // namespace twinlight
