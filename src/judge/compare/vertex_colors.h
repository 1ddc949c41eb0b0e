// The colours of a lit primitive's vertices in floats: from the driver's fixed function in feedback mode (5.3), unclamped; from
// shaders in a float framebuffer, clamped to [0,1] (2.14.6).
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "render/programmable/programmable.h"
#include "render/reference/vertices/lit_vertices.h"
#include "scene/frame/scene.h"

namespace twinlight::compare {

using Color = std::optional<glm::dvec4>;  // empty if the renderer does not show the vertex

// A scene whose last Draw is lit and has at most three vertices, each in a different corner of the view.
struct VertexScene {
    Scene scene;
    std::vector<reference::LitVertex> lit;  // GL's own model, unclamped

    // The place of a vertex in a window of 1 x 1; the origin is the lower left corner.
    glm::dvec2 place(std::size_t vertex) const;
    const Draw& draw() const { return std::get<Draw>(scene.frame.items.back()); }
    bool shows_back() const;
};

// Empty, with the reason in `error`, for a scene that has a GL error or is not of this kind.
std::optional<VertexScene> make_vertex_scene(const std::shared_ptr<const CommandList>& commands, std::string& error);
// The same for a Scene of kVertexWindow by kVertexWindow pixels.
std::optional<VertexScene> make_vertex_scene(Scene scene, std::string& error);
inline constexpr int kVertexWindow = 64;  // the window's side, for feedback

// The vertices' colours from feedback, in order; unclamped if the driver can. Two-sided polygons give the visible face's colours.
std::vector<Color> fixed_colors(const VertexScene& scene);

// The same by shaders, for up to kMostVertexScenes scenes at once. The current context must have kShaderPicture by kShaderPicture
// pixels of floats.
std::vector<std::vector<Color>> shader_colors(std::span<const std::optional<VertexScene>> scenes,
                                              programmable::Renderer& renderer, const programmable::Options& options);
inline constexpr int kShaderTile = 4;    // side of a scene's tile, which has a vertex in each corner
inline constexpr int kShaderTiles = 32;  // tiles in a row
inline constexpr int kShaderPicture = kShaderTiles * kShaderTile;
inline constexpr std::size_t kMostVertexScenes = std::size_t{kShaderTiles} * kShaderTiles;

// The sum of primary and secondary colour in a fragment (2.14.6, 3.9).
glm::dvec4 color_sum(const glm::dvec4& primary, const glm::dvec4& secondary);

// The reference's colours for one face of a vertex.
struct FaceColors {
    glm::dvec4 primary, secondary;
    glm::dvec4 magnitude;  // the sum of the magnitudes of the terms

    glm::dvec4 sum() const { return color_sum(primary, secondary); }
};
FaceColors face_colors(const reference::LitVertex& vertex, bool back);

// The allowed error of a channel in floats, relative to the magnitude, from the rounding of float operations.
double vertex_tolerance(const Draw& draw, const Vertex& vertex);

// GL's own model, without the lecture's variants.
inline constexpr Look kGlsOwnModel{.shading = {}, .lecture_variants = false};

// False on softpipe, whose gl_FrontFacing is wrong for polygons drawn as points (docs/architecture.md).
bool knows_faces_of_corners();

}  // namespace twinlight::compare
