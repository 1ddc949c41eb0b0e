#include "judge/explain/explain.h"

#include <glm/mat4x4.hpp>
#include <utility>

#include "scene/command/names.h"

namespace twinlight::explain {

using reference::Face;

PixelExplanation explain_pixel(const Frame& frame, const Look& look, const Pixel& pixel) {
    return {pixel,
            look,
            reference::pixel_history(frame, reference::Options{look}, pixel.x, frame.height - 1 - pixel.y),
            {}};
}

VertexExplanation explain_vertex(const Frame& frame, const Look& look, const VertexOfDraw& vertex) {
    const Draw& draw = *frame.draws()[vertex.draw];
    VertexExplanation explanation{vertex, look, {}};
    std::vector<Face> faces = {Face::kFront};
    if (draw.lighting.light_model.two_side && draws_polygons(draw.mode)) faces.push_back(Face::kBack);
    for (const Face face : faces)
        explanation.faces.push_back(
            {reference::vertex_history(draw, reference::Options{look}, static_cast<std::uint32_t>(vertex.vertex), face),
             {}});
    return explanation;
}

Frame picture_of(const Draw& draw, std::uint32_t vertex, Face face) {
    Draw point;
    point.mode = kGL_POINTS;
    Vertex sent = draw.vertices[vertex];
    point.lighting = draw.lighting;
    point.lighting.shade_model = kGL_SMOOTH;
    point.lighting.light_model.two_side = false;
    const Materials materials =
        draw.materials.empty() ? Materials{draw.lighting.front, draw.lighting.back} : draw.materials[sent.material];
    sent.material = 0;
    point.lighting.front = face == Face::kFront ? materials.front : materials.back;
    if (face == Face::kBack) {
        ColorMaterial& tracking = point.lighting.color_material;
        tracking.enabled = tracking.enabled && tracking.face != kGL_FRONT;
        tracking.face = kGL_FRONT_AND_BACK;
        sent.normal_object = -sent.normal_object;
    }
    point.raster.viewport = {0, 0, 1, 1};
    point.eye_from_object = draw.eye_from_object;
    const double w_eye = (draw.eye_from_object * sent.position_object).w;
    point.clip_from_eye = glm::dmat4(0);
    point.clip_from_eye[3][3] = w_eye < 0 ? -1 : 1;
    point.place = draw.place;
    point.vertices = {sent};
    Frame frame{.width = 1, .height = 1};
    frame.items.emplace_back(std::move(point));
    return frame;
}

}  // namespace twinlight::explain
