#include "judge/compare/vertex_colors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "render/context/driver_name.h"
#include "render/context/gl.h"
#include "render/fixed/fixed.h"
#include "scene/command/text.h"
#include "scene/state/state.h"

namespace twinlight::compare {

namespace {

glm::dvec2 ndc(const reference::LitVertex& vertex) { return glm::dvec2(vertex.position_clip) / vertex.position_clip.w; }

// Whether each vertex is in a different corner of the view, where feedback and the shaders' picture expect it.
bool are_in_different_corners(const std::vector<reference::LitVertex>& lit) {
    std::array<bool, 4> taken{};
    for (const reference::LitVertex& vertex : lit) {
        const glm::dvec2 place = ndc(vertex);
        const glm::dvec2 size = glm::abs(place);
        const double depth = std::abs(vertex.position_clip.z / vertex.position_clip.w);
        const bool is_in_corner =
            vertex.position_clip.w > 0 && std::min(size.x, size.y) > 0.5 && std::max({size.x, size.y, depth}) < 1;
        bool& corner = taken.at((place.x > 0 ? 1u : 0u) + (place.y > 0 ? 2u : 0u));
        if (!is_in_corner || corner) return false;
        corner = true;
    }
    return true;
}

}  // namespace

glm::dvec2 VertexScene::place(std::size_t vertex) const { return ndc(lit.at(vertex)) * 0.5 + 0.5; }

// The sign of a triangle's area in window space decides its face (2.14.1); points and lines show the front.
bool VertexScene::shows_back() const {
    if (!draw().lighting.light_model.two_side || !draws_polygons(draw().mode)) return false;
    const glm::dvec2 a = ndc(lit[0]), b = ndc(lit[1]), c = ndc(lit[2]);
    const double area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
    return draw().raster.front_face == kGL_CCW ? area <= 0 : area >= 0;
}

std::optional<VertexScene> make_vertex_scene(Scene made, std::string& error) {
    VertexScene scene{std::move(made), {}};
    const Frame& frame = scene.scene.frame;
    const Draw* draw = frame.items.empty() ? nullptr : std::get_if<Draw>(&frame.items.back());
    const std::size_t least = draw && draws_polygons(draw->mode) ? 3 : 1;
    if (!draw || !draw->lighting.enabled || draw->vertices.size() < least || draw->vertices.size() > 3)
        error = "the scene must end with a lit primitive of at most three vertices";
    else if (!frame.unsupported.empty())
        error = frame.unsupported.front().name + " is not supported";
    if (!error.empty()) return std::nullopt;
    scene.lit = reference::light_vertices(*draw, {kGlsOwnModel}, false);
    if (!are_in_different_corners(scene.lit)) error = "the vertices must be in different corners of the view";
    if (!error.empty()) return std::nullopt;
    return scene;
}

std::optional<VertexScene> make_vertex_scene(const std::shared_ptr<const CommandList>& commands, std::string& error) {
    try {
        return make_vertex_scene(make_scene(commands, {.width = kVertexWindow, .height = kVertexWindow}), error);
    } catch (const SceneError& refused) {
        error = refused.what();
        return std::nullopt;
    }
}

// ---- The fixed function ----

namespace {

// Without this extension colours are clamped, and glClampColor would raise an error that is not the scene's.
bool can_show_unclamped_colors() {
    const auto* const extensions = reinterpret_cast<const char*>(glGetString(GL_EXTENSIONS));
    return extensions && std::string_view(extensions).find("GL_ARB_color_buffer_float") != std::string_view::npos;
}

}  // namespace

// Finds the vertices in the feedback buffer by their window positions.
std::vector<Color> fixed_colors(const VertexScene& scene) {
    std::vector<Color> colors(scene.lit.size());
    std::array<GLfloat, 512> buffer{};
    glFeedbackBuffer(static_cast<GLsizei>(buffer.size()), GL_3D_COLOR, buffer.data());
    fixed::Driver driver(kVertexWindow, kVertexWindow);
    const bool unclamped = can_show_unclamped_colors();
    if (unclamped) glClampColor(GL_CLAMP_VERTEX_COLOR, GL_FALSE);
    glRenderMode(GL_FEEDBACK);
    scene.scene.recording->for_each([&](const Step& step) {
        if (step.kind == Step::Kind::kCommand) driver.execute(step.command);
        return true;
    });
    const GLint written = glRenderMode(GL_RENDER);
    if (unclamped) glClampColor(GL_CLAMP_VERTEX_COLOR, GL_TRUE);
    constexpr std::size_t kPerVertex = 7;  // GL_3D_COLOR: x, y, z, r, g, b, a
    for (std::size_t i = 0; i < static_cast<std::size_t>(std::max(written, 0));) {
        const auto token = static_cast<GLenum>(buffer[i++]);
        std::size_t vertices = token == GL_POINT_TOKEN ? 1 : 2;
        if (token == GL_POLYGON_TOKEN) vertices = static_cast<std::size_t>(buffer[i++]);
        for (; vertices > 0; --vertices, i += kPerVertex) {
            const glm::dvec2 window(buffer[i], buffer[i + 1]);
            for (std::size_t v = 0; v < scene.lit.size(); ++v) {
                const glm::dvec2 expected = scene.place(v) * static_cast<double>(kVertexWindow);
                if (glm::length(window - expected) > 0.5) continue;
                colors[v] = glm::dvec4(buffer[i + 3], buffer[i + 4], buffer[i + 5], buffer[i + 6]);
            }
        }
    }
    return colors;
}

// ---- Shaders ----

namespace {

// The Draw as points at its vertices, inside the tile. softpipe may draw a point on the view's border beside it, hence the scissor.
Draw as_points(const VertexScene& scene, const Rectangle& tile) {
    Draw draw = scene.draw();
    if (!draws_polygons(draw.mode)) {
        draw.mode = kGL_POINTS;
        draw.indices = {};
    }
    RasterState raster;  // keeps only the facing
    raster.front_face = draw.raster.front_face;
    raster.viewport = tile;
    raster.polygon_mode_front = raster.polygon_mode_back = kGL_POINT;
    draw.state_number = 0;
    draw.raster = raster;
    draw.fragment.scissor = {.enabled = true, .box = tile};
    return draw;
}

}  // namespace

std::vector<std::vector<Color>> shader_colors(std::span<const std::optional<VertexScene>> scenes,
                                              programmable::Renderer& renderer, const programmable::Options& options) {
    Frame frame;
    frame.width = frame.height = kShaderPicture;
    std::vector<Rectangle> tiles;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        const int n = static_cast<int>(i);
        tiles.push_back({n % kShaderTiles * kShaderTile, n / kShaderTiles * kShaderTile, kShaderTile, kShaderTile});
        if (scenes[i]) frame.items.emplace_back(as_points(*scenes[i], tiles.back()));
    }
    const Image image = renderer.render(frame, options);
    std::vector<std::vector<Color>> colors(scenes.size());
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        if (!scenes[i]) continue;
        for (std::size_t v = 0; v < scenes[i]->lit.size(); ++v) {
            const glm::dvec2 in_tile = scenes[i]->place(v) * static_cast<double>(kShaderTile);
            const int x = tiles[i].x + std::clamp(static_cast<int>(in_tile.x), 0, kShaderTile - 1);
            const int y = tiles[i].y + std::clamp(static_cast<int>(in_tile.y), 0, kShaderTile - 1);
            const Rgba& pixel = image.at(x, frame.height - 1 - y);
            colors[i].emplace_back(glm::dvec4(pixel[0], pixel[1], pixel[2], pixel[3]));
        }
    }
    return colors;
}

glm::dvec4 color_sum(const glm::dvec4& primary, const glm::dvec4& secondary) {
    const auto clamped = [](const glm::dvec4& color) { return glm::clamp(color, 0.0, 1.0); };
    return clamped(clamped(primary) + glm::dvec4(glm::dvec3(clamped(secondary)), 0));
}

FaceColors face_colors(const reference::LitVertex& vertex, bool back) {
    return back ? FaceColors{vertex.back_primary, vertex.back_secondary, vertex.back_magnitude}
                : FaceColors{vertex.front_primary, vertex.front_secondary, vertex.front_magnitude};
}

bool knows_faces_of_corners() { return current_driver().name != "softpipe"; }

// ---- The tolerance ----

namespace {

// The allowed error of a channel, relative to the sum of the magnitudes of a colour's terms, in units of a float's last place.
// 2.1.1 allows each operation an error of 1e-5; drivers and shaders are more accurate.
constexpr double kUlp = 0x1p-23;
constexpr double kArithmeticUlps = 40;  // the depth of the computation, in operations
// The error of n.h, which the power multiplies by the exponent: for a unit normal, and for one transformed by an inverse matrix
// in floats.
constexpr double kUnitCosineUlps = 1, kCosineUlps = 3;
// The error of the logarithm inside a power, multiplied by the exponent. It matters if n.h is greater than 1, because the power is
// then by far the largest term.
constexpr double kLogarithmUlps = 5;
// The error of each of the two unit vectors whose normalised sum is h_i. If they nearly cancel, the short sum has the same error.
constexpr double kHalfVectorUlps = 1;

// The length of the shortest sum of the directions to a light and to the viewer; at most 2.
double shortest_half_vector(const Draw& draw, const Vertex& vertex) {
    const glm::dvec4 at = draw.eye_from_object * vertex.position_object;
    const glm::dvec3 position_eye = glm::dvec3(at) / at.w;
    const glm::dvec3 to_viewer =
        draw.lighting.light_model.local_viewer ? glm::normalize(-position_eye) : glm::dvec3(0, 0, 1);
    double shortest = 2;
    for (const LightSource& light : draw.lighting.lights) {
        if (!light.enabled) continue;
        const glm::dvec3 direction(light.position_eye);
        const double w = light.position_eye.w;
        const glm::dvec3 to_light = glm::normalize(w == 0 ? direction : direction / w - position_eye);
        shortest = std::min(shortest, glm::length(to_light + to_viewer));
    }
    return shortest;
}

}  // namespace

double vertex_tolerance(const Draw& draw, const Vertex& vertex) {
    const LightingState& lighting = draw.lighting;
    const Materials materials =
        draw.materials.empty() ? Materials{lighting.front, lighting.back} : draw.materials[vertex.material];
    const double exponent = std::max(materials.front.shininess, materials.back.shininess);
    const double of_half_vector = 2 * kHalfVectorUlps / shortest_half_vector(draw, vertex);
    if (lighting.normalize) return kUlp * (kArithmeticUlps + (kUnitCosineUlps + of_half_vector) * exponent);
    const glm::dvec3 normal_eye = glm::transpose(glm::inverse(glm::dmat3(draw.eye_from_object))) * vertex.normal_object;
    const double length = lighting.rescale_normal ? 1 : std::max(1.0, glm::length(normal_eye));
    return kUlp * (kArithmeticUlps + (kCosineUlps + of_half_vector + kLogarithmUlps * std::log(length)) * exponent);
}

}  // namespace twinlight::compare
