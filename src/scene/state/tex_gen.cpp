// The generation of texture coordinates (2.11.4): what glTexGen sets. The renderers compute the coordinates.
#include <fmt/format.h>

#include <algorithm>
#include <glm/matrix.hpp>

#include "base/math/normal_matrix.h"
#include "scene/state/state.h"

namespace twinlight {

std::vector<GeneratedCoordinate> generated_coordinates(const TextureBindings& unit) {
    std::vector<GeneratedCoordinate> generated;
    for (int i = 0; i < 4; ++i) {
        const TexGen& gen = unit.tex_gen[static_cast<std::size_t>(i)];
        if (!gen.enabled) continue;
        GeneratedCoordinate one{.coordinate = i, .mode = gen.mode};
        if (gen.mode == kGL_OBJECT_LINEAR) one.plane = gen.object_plane;
        if (gen.mode == kGL_EYE_LINEAR) one.plane = gen.plane_eye;
        generated.push_back(one);
    }
    return generated;
}

void State::tex_gen(const Command& c) {
    const Enum coord = c.enumerant(0), pname = c.enumerant(1);
    if (!known(c, coord, {kGL_S, kGL_T, kGL_R, kGL_Q})) return;
    const auto values = parameter_values(c, Owner::kTexGen, pname);
    if (!values) return;
    TexGen& gen = unit().tex_gen[coord - kGL_S];
    if (pname == kGL_TEXTURE_GEN_MODE) {
        const auto mode = static_cast<Enum>(std::clamp(values->front(), 0.0, 4294967295.0));
        const bool ok =
            coord == kGL_Q ? known(c, mode, {kGL_OBJECT_LINEAR, kGL_EYE_LINEAR})
            : coord == kGL_R
                ? known(c, mode, {kGL_OBJECT_LINEAR, kGL_EYE_LINEAR, kGL_REFLECTION_MAP, kGL_NORMAL_MAP})
                : known(c, mode,
                        {kGL_OBJECT_LINEAR, kGL_EYE_LINEAR, kGL_SPHERE_MAP, kGL_REFLECTION_MAP, kGL_NORMAL_MAP});
        if (ok) gen.mode = mode;
        return;
    }
    const glm::dvec4 plane((*values)[0], (*values)[1], (*values)[2], (*values)[3]);
    if (pname == kGL_OBJECT_PLANE) {
        gen.object_plane = plane;
        return;
    }
    // 2.11.4: times the inverse of the current modelview matrix. RULING: if that is singular, the coordinate is 0
    // everywhere; the specification leaves it undefined.
    const bool singular = is_singular(glm::dmat3(modelview())) || glm::determinant(modelview()) == 0;
    gen.plane_eye = singular ? glm::dvec4(0) : glm::transpose(glm::inverse(modelview())) * plane;
}

void State::query_tex_gen(const Command& c) {
    if (known(c, c.enumerant(0), {kGL_S, kGL_T, kGL_R, kGL_Q}))
        known(c, c.enumerant(1), {kGL_TEXTURE_GEN_MODE, kGL_OBJECT_PLANE, kGL_EYE_PLANE});
}

}  // namespace twinlight
