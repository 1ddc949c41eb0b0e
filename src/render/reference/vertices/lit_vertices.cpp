#include "render/reference/vertices/lit_vertices.h"

#include "render/reference/vertices/draw_lighting.h"
#include "render/reference/vertices/vertex_stage.h"

namespace twinlight::reference {

std::vector<LitVertex> light_vertices(const Draw& draw, const Options& options, bool clamp) {
    const DrawLighting lighting(draw, options.lecture_variants);
    const auto finish = [&](const glm::dvec4& color) { return clamp ? clamped(color) : color; };
    const std::vector<StageVertex> vertices = vertex_stage(draw);
    std::vector<LitVertex> result;
    result.reserve(vertices.size());
    for (const StageVertex& v : vertices) {
        const Colors front = lighting.colors(v, Face::kFront);
        const Colors back = lighting.two_side() ? lighting.colors(v, Face::kBack) : front;
        result.push_back({.position_clip = v.position_clip,
                          .front_primary = finish(front.primary),
                          .front_secondary = finish(front.secondary),
                          .back_primary = finish(back.primary),
                          .back_secondary = finish(back.secondary),
                          .front_magnitude = front.magnitude,
                          .back_magnitude = back.magnitude});
    }
    if (options.arithmetic == Arithmetic{} || !lighting.enabled()) return result;
    // With another arithmetic than double: lights the vertices as pictures are lit.
    const auto light = [&](Face face, glm::dvec4 LitVertex::*primary, glm::dvec4 LitVertex::*secondary) {
        PointBatch batch(lighting, PointBatch::Normals::kAsTheyAre);
        for (const StageVertex& v : vertices) batch.add(v, face, [&] { return lighting.material(v, face); });
        batch.light(options.arithmetic, [&](std::size_t i, const glm::dvec4& first, const glm::dvec4& second) {
            result[i].*primary = finish(first);
            result[i].*secondary = finish(second);
        });
    };
    light(Face::kFront, &LitVertex::front_primary, &LitVertex::front_secondary);
    light(lighting.two_side() ? Face::kBack : Face::kFront, &LitVertex::back_primary, &LitVertex::back_secondary);
    return result;
}

}  // namespace twinlight::reference
