#include "render/reference/fragment_operations.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace twinlight::reference {

double quantised(double channel) { return std::floor(clamp01(channel) * kColorCodes + 0.5) / kColorCodes; }

glm::dvec4 quantised(const glm::dvec4& color) {
    return {quantised(color.r), quantised(color.g), quantised(color.b), quantised(color.a)};
}

PixelRect scissored(const Scissor& scissor, const PixelRect& rect) {
    if (!scissor.enabled) return rect;
    const auto end = [](int start, int size) {  // the sum may be more than an int holds
        return static_cast<int>(std::min<std::int64_t>(std::int64_t{start} + size, INT32_MAX));
    };
    return {std::max(rect.x0, scissor.box.x), std::max(rect.y0, scissor.box.y),
            std::min(rect.x1, end(scissor.box.x, scissor.box.width)),
            std::min(rect.y1, end(scissor.box.y, scissor.box.height))};
}

bool alpha_passes(const FragmentState& state, double alpha) {
    const double incoming = quantised(alpha), reference = quantised(state.alpha_ref);
    switch (state.alpha_func) {
        case kGL_NEVER: return false;
        case kGL_LESS: return incoming < reference;
        case kGL_EQUAL: return incoming == reference;
        case kGL_LEQUAL: return incoming <= reference;
        case kGL_GREATER: return incoming > reference;
        case kGL_NOTEQUAL: return incoming != reference;
        case kGL_GEQUAL: return incoming >= reference;
    }
    return true;  // GL_ALWAYS
}

bool overwrites_color(const FragmentState& state) {
    const bool adds = state.blend_equation == kGL_FUNC_ADD && state.blend_equation_alpha == kGL_FUNC_ADD;
    const bool blends = state.blend && (!adds || state.blend_src != kGL_ONE || state.blend_dst != kGL_ZERO ||
                                        state.blend_src_alpha != kGL_ONE || state.blend_dst_alpha != kGL_ZERO);
    return !blends && std::ranges::all_of(state.color_mask, [](bool on) { return on; });
}

bool writes_color(const FragmentState& state) {
    return std::ranges::any_of(state.color_mask, [](bool on) { return on; });
}

}  // namespace twinlight::reference
