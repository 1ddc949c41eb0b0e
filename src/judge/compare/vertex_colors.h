// The colours of a lit primitive's vertices at float precision: the driver's fixed function in feedback mode (5.3), unclamped;
// shaders into a buffer of floats, clamped to [0,1] (2.14.6).
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "render/programmable/programmable.h"
#include "render/reference/reference.h"
#include "scene/state/scene.h"

namespace twinlight::compare {

using Color = std::optional<glm::dvec4>;  // nothing where a renderer shows no such vertex

// A scene whose last Draw is lit and has three vertices or fewer, each in a corner of the view of its own.
struct VertexScene {
    Scene scene;
    std::vector<reference::LitVertex> lit;  // GL's own model, unclamped

    const Draw& draw() const { return std::get<Draw>(scene.frame.items.back()); }
    bool shows_back() const;
};

// Nothing, and the reason, for a scene that GL refuses or that is not of this form.
std::optional<VertexScene> make_vertex_scene(const std::shared_ptr<const CommandList>& commands, std::string& error);
// The same of a scene of kVertexWindow by kVertexWindow pixels that is made.
std::optional<VertexScene> make_vertex_scene(Scene scene, std::string& error);
inline constexpr int kVertexWindow = 64;  // of the fixed function's feedback

// In the order of the vertices: the colours that feedback returns, unclamped where the driver can. Of two-sided polygons those of the face that shows.
std::vector<Color> fixed_colors(const VertexScene& scene);

// The same of shaders, for all scenes at once, in a context of kShaderPicture by kShaderPicture pixels of floats. At most
// kMostVertexScenes.
std::vector<std::vector<Color>> shader_colors(std::span<const std::optional<VertexScene>> scenes,
                                              programmable::Renderer& renderer, const programmable::Options& options);
inline constexpr int kShaderTile = 4;    // of a scene: a vertex stands in each corner
inline constexpr int kShaderTiles = 32;  // in a row
inline constexpr int kShaderPicture = kShaderTiles * kShaderTile;
inline constexpr std::size_t kMostVertexScenes = std::size_t{kShaderTiles} * kShaderTiles;

// The sum of primary and secondary colour as fragments have it (2.14.6, 3.9).
glm::dvec4 color_sum(const glm::dvec4& primary, const glm::dvec4& secondary);

// One face of a vertex of the reference.
struct FaceColors {
    glm::dvec4 primary, secondary;
    glm::dvec4 magnitude;  // of the terms that make them up

    glm::dvec4 sum() const { return color_sum(primary, secondary); }
};
FaceColors face_colors(const reference::LitVertex& vertex, bool back);

// What a channel at float precision may be off by, relative to the magnitude: the last places that float operations lose.
double vertex_tolerance(const Draw& draw, const Vertex& vertex);

// GL's own model.
inline constexpr Look kGlsOwnModel{.shading = {}, .lecture_variants = false};

// softpipe's gl_FrontFacing is not that of the polygon where polygons are drawn as points (docs/architecture.md).
bool knows_faces_of_corners();

}  // namespace twinlight::compare
