// A fragment's place in its texture (3.4.1, 3.5.1, 3.8.8), and the largest error of correct implementations.
//
// In: a piece and its stage vertices. Out: (s, t, r) divided by q and its derivatives over the window.
#pragma once

#include <optional>
#include <vector>

#include "lighting/marked.h"
#include "render/reference/geometry/piece.h"
#include "render/reference/textures/interval.h"
#include "render/reference/textures/texture.h"
#include "render/reference/vertices/staged_vertices.h"

namespace twinlight::reference {

// The texture coordinates of a texture unit at a Draw's staged vertices, which must outlive it.
class TexCoords {
  public:
    // sprite_origin: GL_POINT_SPRITE_COORD_ORIGIN, if point sprites have coordinates of their own (3.3.1). further: those of a unit above
    // 0 at the kept vertices; null for unit 0.
    TexCoords(const StagedVertices& vertices, std::optional<Enum> sprite_origin, const std::vector<glm::dvec4>* further)
        : vertices_(&vertices), further_(further), sprite_origin_(sprite_origin) {}

    const glm::dvec4& operator[](std::size_t vertex) const {
        return further_ ? (*further_)[vertices_->place(vertex)] : (*vertices_)[vertex].tex_coord;
    }

    // Whether the piece has the coordinates of a sprite in place of its vertices'.
    bool are_replaced(const Piece& piece) const { return sprite_origin_ && piece.sprite_size > 0; }
    // Those at a place of the window, with their changes. Equation 3.1: from 0 to 1 across the sprite.
    struct OfSprite {
        glm::dvec2 st{0};
        glm::dvec2 per_x{0}, per_y{0};
    };
    OfSprite of_sprite(const Piece& piece, const glm::dvec2& position_window) const;

  private:
    const StagedVertices* vertices_;
    const std::vector<glm::dvec4>* further_;
    std::optional<Enum> sprite_origin_;
};

// In a cube map: the place on a face.
TexturePlace texture_place(const TexCoords& tex_coords, const Piece& piece, const glm::dvec2& position_window,
                           const Texture& texture);

// The input of texture_bounds.h.
struct TexturePlaceBounds {
    glm::dvec3 str{0}, str_error{0};
    Interval rho{};
    std::size_t face = 0;
    glm::dvec3 change{0};  // of s, t and r within a pixel
};
// What may be off in a driver's place.
struct PlaceErrors {
    double vertex = 0;  // the largest error of a vertex's s, t, q and, where it counts, r
    double snap = 0;    // Options::snap
    bool approximates_rho = false;
};
TexturePlaceBounds texture_place_bounds(const TexCoords& tex_coords, const Piece& piece,
                                        const glm::dvec2& position_window, const Texture& texture,
                                        const PlaceErrors& errors);

// The same for a point of an exact surface. The derivatives are those of its tangent plane, and 3.8.8 leaves open how rho follows from
// them.
TexturePlaceBounds surface_place_bounds(const TexturePlace& place, const Texture& texture);

// The same for a cube map: a place on each face that the direction may point to. 3.8.8 allows any rho between half and twice
// the ideal one. That is used here, because drivers find the change of the direction in ways of their own, and what they find by
// differences between pixels, which is more where the direction bends much within a pixel.
std::vector<TexturePlaceBounds> cube_place_bounds(const TexCoords& tex_coords, const Piece& piece,
                                                  const glm::dvec2& position_window, const Texture& texture,
                                                  const PlaceErrors& errors);

// The rulings that the place depends on, for a mesh.
lighting::RulingSet texture_rulings(const TexCoords& tex_coords, const Piece& piece, const glm::dvec2& position_window,
                                    const Texture& texture);

}  // namespace twinlight::reference
