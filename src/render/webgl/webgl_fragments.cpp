#include "render/webgl/webgl_fragments.h"

#include <algorithm>

namespace twinlight::webgl {

bool has_two_stencils(const Draw& draw) {
    return draw.fragment.stencil && draws_polygons(draw.mode) &&
           draw.fragment.stencil->front != draw.fragment.stencil->back;
}

bool needs_each_side(const Draw& draw) {
    if (!has_two_stencils(draw) || draw.raster.cull_enabled) return false;
    const StencilFace &front = draw.fragment.stencil->front, &back = draw.fragment.stencil->back;
    const auto differ = [&](auto member) { return front.*member != back.*member; };
    return differ(&StencilFace::ref) || differ(&StencilFace::mask) || differ(&StencilFace::write_mask);
}

Json stencil_json(const Draw& draw) {
    const StencilFace *front = &draw.fragment.stencil->front, *back = &draw.fragment.stencil->back;
    // Where one face is culled, the other's values are those of both.
    if (has_two_stencils(draw) && draw.raster.cull_enabled)
        (draw.raster.cull_face == kGL_FRONT ? front : back) = draw.raster.cull_face == kGL_FRONT ? back : front;
    Json faces = Json::array();
    for (const StencilFace* face : {front, back})
        faces.push_back({face->func, std::clamp(face->ref, 0, kMaxStencil), face->mask & kMaxStencil, face->fail,
                         face->depth_fail, face->depth_pass, face->write_mask & kMaxStencil});
    return faces;
}

bool mixes_constants(const FragmentState& fragment) {
    const auto is_color = [](Enum factor) {
        return factor == kGL_CONSTANT_COLOR || factor == kGL_ONE_MINUS_CONSTANT_COLOR;
    };
    const auto is_alpha = [](Enum factor) {
        return factor == kGL_CONSTANT_ALPHA || factor == kGL_ONE_MINUS_CONSTANT_ALPHA;
    };
    const Enum source = fragment.blend_src, destination = fragment.blend_dst;
    return fragment.blend && !fragment.logic_op &&
           ((is_color(source) && is_alpha(destination)) || (is_alpha(source) && is_color(destination)));
}
glm::dvec3 constant_factor(const FragmentState& fragment) {
    const glm::dvec4& constant = fragment.blend_color;
    switch (fragment.blend_src) {
        case kGL_CONSTANT_COLOR: return glm::dvec3(constant);
        case kGL_ONE_MINUS_CONSTANT_COLOR: return 1.0 - glm::dvec3(constant);
        case kGL_CONSTANT_ALPHA: return glm::dvec3(constant.a);
        default: return glm::dvec3(1 - constant.a);
    }
}

Json blend_json(const FragmentState& fragment) {
    const Enum source = mixes_constants(fragment) ? Enum{kGL_ONE} : fragment.blend_src;
    const glm::dvec4& color = fragment.blend_color;
    return {{"factors", {source, fragment.blend_dst, fragment.blend_src_alpha, fragment.blend_dst_alpha}},
            {"equations", {fragment.blend_equation, fragment.blend_equation_alpha}},
            {"color", {color.r, color.g, color.b, color.a}}};
}

}  // namespace twinlight::webgl
