#include "render/webgl/webgl_vertices.h"

#include <cstddef>
#include <utility>

#include "render/programmable/numbers/draw_values.h"
#include "render/programmable/numbers/vertex_attributes.h"

namespace twinlight::webgl {

namespace {

// Some values of each vertex.
struct Values {
    std::vector<float> all;
    std::size_t first, taken;
};

std::vector<float> interleaved(const std::vector<Values>& arrays, std::size_t count) {
    std::vector<float> values;
    for (std::size_t i = 0; i < count; ++i)
        for (const auto& [all, first, taken] : arrays) {
            const auto begin = all.begin() + static_cast<std::ptrdiff_t>(i * (all.size() / count) + first);
            values.insert(values.end(), begin, begin + static_cast<std::ptrdiff_t>(taken));
        }
    return values;
}

}  // namespace

std::vector<float> vertex_values(const Part& part, const Draw& draw, const EffectSet& effects,
                                 const glm::dvec3& origin_object) {
    constexpr std::size_t kPosition = 4;  // the first values
    const std::size_t count = part.vertices.size();
    const auto values_of = [&](const std::vector<std::uint32_t>& vertices) {
        return programmable::vertex_array(draw, effects, vertices, origin_object);
    };
    const std::vector<float> own = values_of(part.vertices);
    std::vector<Values> values;
    if (part.colors_from.empty()) {
        values.push_back({own, 0, own.size() / count});
    } else {
        // The vertex that gives the colour is lit, but an edge has its own texture and fog coordinates.
        const std::vector<float> colors = values_of(part.colors_from);
        std::size_t first = 0;
        for (const programmable::Attribute& attribute : programmable::attributes(effects)) {
            const bool is_own = attribute.name.starts_with("a_tex_coord") || attribute.name == "a_fog_coord";
            const auto size = static_cast<std::size_t>(attribute.size);
            values.push_back({is_own ? own : colors, first, size});
            first += size;
        }
        values.push_back({own, 0, kPosition});
    }
    if (part.rectangles == programmable::Rectangles::kLines) values.push_back({values_of(part.others), 0, kPosition});
    if (part.has_rectangles()) values.push_back({part.corners, 0, part.corners.size() / count});
    return interleaved(values, count);
}

}  // namespace twinlight::webgl
