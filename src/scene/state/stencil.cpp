// The stencil test and what it writes (4.1.5, 4.2.2, 4.2.3).
#include <cstdint>

#include "scene/state/state.h"

namespace twinlight {

std::optional<std::vector<StencilFace*>> State::stencil_faces(const Command& c, bool names_face) {
    const Enum face = names_face ? c.enumerant(0) : Enum{kGL_FRONT_AND_BACK};
    if (!known(c, face, {kGL_FRONT, kGL_BACK, kGL_FRONT_AND_BACK})) return std::nullopt;
    std::vector<StencilFace*> faces;
    if (face != kGL_BACK) faces.push_back(&a_.stencil_test.front);
    if (face != kGL_FRONT) faces.push_back(&a_.stencil_test.back);
    return faces;
}

void State::stencil_func(const Command& c) {
    const bool names_face = c.id == CommandId::glStencilFuncSeparate;
    const auto faces = stencil_faces(c, names_face);
    if (!faces) return;
    const std::size_t first = names_face ? 1 : 0;
    const Enum func = c.enumerant(first);
    if (!known(c, func,
               {kGL_NEVER, kGL_LESS, kGL_EQUAL, kGL_LEQUAL, kGL_GREATER, kGL_NOTEQUAL, kGL_GEQUAL, kGL_ALWAYS}))
        return;
    for (StencilFace* face : *faces) {
        face->func = func;
        face->ref = static_cast<int>(c.number(first + 1));
        face->mask = static_cast<std::uint32_t>(c.number(first + 2));
    }
}

void State::stencil_op(const Command& c) {
    const bool names_face = c.id == CommandId::glStencilOpSeparate;
    const auto faces = stencil_faces(c, names_face);
    if (!faces) return;
    const std::size_t first = names_face ? 1 : 0;
    for (std::size_t i = first; i < c.arguments.size(); ++i)
        if (!known(c, c.enumerant(i),
                   {kGL_KEEP, kGL_ZERO, kGL_REPLACE, kGL_INCR, kGL_DECR, kGL_INVERT, kGL_INCR_WRAP, kGL_DECR_WRAP}))
            return;
    for (StencilFace* face : *faces) {
        face->fail = c.enumerant(first);
        face->depth_fail = c.enumerant(first + 1);
        face->depth_pass = c.enumerant(first + 2);
    }
}

void State::stencil_mask(const Command& c) {
    const bool names_face = c.id == CommandId::glStencilMaskSeparate;
    const auto faces = stencil_faces(c, names_face);
    if (!faces) return;
    for (StencilFace* face : *faces) face->write_mask = static_cast<std::uint32_t>(c.number(names_face ? 1 : 0));
}

void State::clear_stencil(const Command& c) { a_.clear.clear_stencil = static_cast<int>(c.number(0)); }

}  // namespace twinlight
