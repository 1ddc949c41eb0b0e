#include "judge/lint/watch.h"

#include <algorithm>
#include <cmath>

#include "base/math/directions.h"
#include "base/math/normal_matrix.h"
#include "base/text/translation.h"
#include "render/reference/geometry/primitive_assembly.h"
#include "render/reference/vertices/vertex_stage.h"
#include "scene/frame/resized.h"

namespace twinlight::lint {

std::string_view view_lines() {
    return "glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);\n"
           "glEnable(GL_DEPTH_TEST);\n"
           "glMatrixMode(GL_PROJECTION);\n"
           "gluPerspective(45, 4.0 / 3.0, 1, 100);\n"
           "glMatrixMode(GL_MODELVIEW);\n"
           "gluLookAt(0, 2, 6,  0, 0, 0,  0, 1, 0);\n";
}

std::string_view light_lines() {
    return "glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){3, 4, 5, 1});\n"
           "glEnable(GL_LIGHTING);\n"
           "glEnable(GL_LIGHT0);\n";
}

bool is_effect(const Command& command, std::string_view effect) {
    return kEffects[static_cast<std::size_t>(command.id)] == effect;
}

std::optional<int> light_number(Enum light) {
    if (light < kGL_LIGHT0 || light >= kGL_LIGHT0 + kMaxLights) return std::nullopt;
    return static_cast<int>(light - kGL_LIGHT0);
}

std::optional<int> light_of(const Command& command) {
    return is_effect(command, "light") ? light_number(command.enumerant(0)) : std::nullopt;
}

std::string where(const Place& place) {
    if (place.calls) return fmt::format("{}:{}", *place.file, place.line);  // the program may have several files
    return place.column == Place::kCallNumber ? tr("call {}", place.line) : tr("line {}", place.line);
}

std::vector<int> enabled_lights(const Draw& draw) {
    std::vector<int> numbers;
    if (!draw.lighting.enabled) return numbers;
    for (std::size_t i = 0; i < draw.lighting.lights.size(); ++i)
        if (draw.lighting.lights[i].enabled) numbers.push_back(static_cast<int>(i));
    return numbers;
}

bool LitOverlays::is_overlay(const Draw& draw) {
    const bool is_orthographic = draw.clip_from_eye[2][3] == 0;
    if (!is_orthographic) has_perspective_ |= draw.lighting.enabled;
    if (!is_orthographic || draw.raster.depth_test || !draw.lighting.enabled) return false;
    // Flat drawing may be lit on purpose if it is the whole picture; so may text, but not without a light.
    const bool has_light = !enabled_lights(draw).empty();
    return draw.pixels ? !has_light || has_perspective_ : has_light && has_perspective_;
}

bool has_specular_light(const Draw& draw) {
    return draw.lighting.enabled && std::ranges::any_of(draw.lighting.lights, [](const LightSource& light) {
               return light.enabled && !is_black(light.specular);
           });
}

bool uses_normals(const Draw& draw) {
    return std::ranges::any_of(enabled_lights(draw), [&](int light) {
        const LightSource& source = draw.lighting.lights[static_cast<std::size_t>(light)];
        return !is_black(source.diffuse) || !is_black(source.specular);
    });
}

bool is_flattened(const Draw& draw) {
    const glm::dmat4& m = draw.eye_from_object;
    if (is_singular(glm::dmat3(m))) return true;
    // A lamp's shadow is a projection. Unless its plane contains the origin, only the whole matrix has no inverse; its entries are floats.
    if (m[0][3] == 0 && m[1][3] == 0 && m[2][3] == 0) return false;
    constexpr double kRounding = 1e-6;
    double columns = 1;
    for (int i = 0; i < 4; ++i) columns *= glm::length(m[i]);
    return std::abs(glm::determinant(m)) <= kRounding * columns;
}

glm::dvec3 to_viewer(const Draw& draw, const glm::dvec3& point_eye) {
    if (draw.clip_from_eye[2][3] != 0) return -point_eye;
    return {0, 0, draw.clip_from_eye[2][2] > 0 ? -1 : 1};
}

std::size_t differing_pixels(const Image& a, const Image& b, float visible) {
    std::size_t differing = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const Rgba &p = a.pixels[i], &q = b.pixels[i];
        differing += std::max({std::abs(p[0] - q[0]), std::abs(p[1] - q[1]), std::abs(p[2] - q[2])}) > visible;
    }
    return differing;
}

Frame smaller(const Frame& frame) {
    constexpr double kSide = 128;
    const double factor = std::min(1.0, kSide / std::max(frame.width, frame.height));
    const auto less = [&](int side) { return std::max(1, static_cast<int>(std::lround(side * factor))); };
    return resized(frame, less(frame.width), less(frame.height));
}

std::vector<Triangle> triangles_of(const Draw& draw) {
    std::vector<Triangle> triangles;
    if (!draws_polygons(draw.mode)) return triangles;
    for (const reference::Primitive& primitive : reference::assemble(draw, reference::QuadCut::kFirstToThird))
        if (primitive.shape == reference::Shape::kTriangle) triangles.push_back(primitive.vertices);
    return triangles;
}

bool has_direction(const Draw& draw, const Triangle& triangle) {
    constexpr double kRounding = 1e-6;
    std::array<glm::dvec3, 3> corners;
    double size = 0, longest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec4& position = draw.vertices[triangle[i]].position_object;
        corners[i] = glm::dvec3(position) / (position.w != 0 ? position.w : 1);
        size = std::max(size, glm::length(corners[i]));
    }
    for (std::size_t i = 0; i < 3; ++i) longest = std::max(longest, glm::distance(corners[i], corners[(i + 1) % 3]));
    const double twice_area = glm::length(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
    return twice_area > kRounding * size * longest;
}

std::vector<EyeVertex> eye_vertices(const Draw& draw) {
    std::vector<EyeVertex> vertices;
    vertices.reserve(draw.vertices.size());
    for (const reference::StageVertex& vertex : reference::vertex_stage(draw)) {
        const double w = vertex.position_eye.w;
        vertices.push_back({glm::dvec3(vertex.position_eye) / (w == 0 ? 1 : w), vertex.normal_eye});
    }
    return vertices;
}

}  // namespace twinlight::lint
