// Capabilities, facing, depth, clearing (2.11.1, 3.5, 4.1.6, 4.2.3).
#include <fmt/format.h>

#include <algorithm>

#include "state/state.h"

namespace twinlight {

namespace {

// Capabilities that this state does not follow. Those marked false change no pixel of what Twinlight draws.
struct Elsewhere {
    Enum cap;
    bool changes_pixels;
};
constexpr Elsewhere kElsewhere[] = {
    {kGL_POINT_SMOOTH, true},
    {kGL_LINE_SMOOTH, true},
    {kGL_LINE_STIPPLE, true},
    {kGL_POLYGON_SMOOTH, true},
    {kGL_POLYGON_STIPPLE, true},
    {kGL_FOG, true},
    {kGL_STENCIL_TEST, true},
    {kGL_ALPHA_TEST, true},
    {kGL_BLEND, true},
    {kGL_COLOR_LOGIC_OP, true},
    {kGL_SCISSOR_TEST, true},
    {kGL_TEXTURE_1D, true},
    {kGL_TEXTURE_2D, true},
    {kGL_CLIP_PLANE0, true},
    {kGL_CLIP_PLANE1, true},
    {kGL_CLIP_PLANE2, true},
    {kGL_CLIP_PLANE3, true},
    {kGL_CLIP_PLANE4, true},
    {kGL_CLIP_PLANE5, true},
    {kGL_POLYGON_OFFSET_POINT, true},
    {kGL_POLYGON_OFFSET_LINE, true},
    {kGL_POLYGON_OFFSET_FILL, true},
    {kGL_COLOR_SUM, true},
    {kGL_MULTISAMPLE, false},
    {kGL_DITHER, false},
};

}  // namespace

void State::set_capability(const Command& c, bool enabled) {
    const Enum cap = c.enumerant(0);
    if (cap >= kGL_LIGHT0 && cap < kGL_LIGHT0 + kMaxLights) {
        lighting_.lights[cap - kGL_LIGHT0].enabled = enabled;
        return;
    }
    switch (cap) {
        case kGL_LIGHTING: lighting_.enabled = enabled; return;
        case kGL_NORMALIZE: lighting_.normalize = enabled; return;
        case kGL_RESCALE_NORMAL: lighting_.rescale_normal = enabled; return;
        case kGL_CULL_FACE: raster_.cull_enabled = enabled; return;
        case kGL_DEPTH_TEST: raster_.depth_test = enabled; return;
        case kGL_COLOR_MATERIAL:
            lighting_.color_material.enabled = enabled;
            track_color();  // 2.14.3: from the moment of glEnable on
            return;
        default: break;
    }
    const auto elsewhere =
        std::find_if(std::begin(kElsewhere), std::end(kElsewhere), [cap](const Elsewhere& e) { return e.cap == cap; });
    if (elsewhere == std::end(kElsewhere)) {
        return raise(kGL_INVALID_ENUM, c,
                     fmt::format("{} is given {}, which is no capability; expected GL_LIGHTING, GL_LIGHT0, "
                                 "GL_DEPTH_TEST, ...",
                                 c.name(), enum_name(cap)));
    }
    if (enabled && elsewhere->changes_pixels) {
        enabled_elsewhere_.emplace(cap, c.place);
    } else {
        enabled_elsewhere_.erase(cap);
    }
}

void State::enable(const Command& c) { set_capability(c, true); }
void State::disable(const Command& c) { set_capability(c, false); }

void State::front_face(const Command& c) {
    if (known(c, c.enumerant(0), {kGL_CW, kGL_CCW})) raster_.front_face = c.enumerant(0);
}

void State::cull_face(const Command& c) {
    if (known(c, c.enumerant(0), {kGL_FRONT, kGL_BACK, kGL_FRONT_AND_BACK})) raster_.cull_face = c.enumerant(0);
}

void State::polygon_mode(const Command& c) {
    const Enum face = c.enumerant(0), mode = c.enumerant(1);
    if (!known(c, face, {kGL_FRONT, kGL_BACK, kGL_FRONT_AND_BACK})) return;
    if (!known(c, mode, {kGL_POINT, kGL_LINE, kGL_FILL})) return;
    if (face != kGL_BACK) raster_.polygon_mode_front = mode;
    if (face != kGL_FRONT) raster_.polygon_mode_back = mode;
}

void State::depth_func(const Command& c) {
    if (known(c, c.enumerant(0),
              {kGL_NEVER, kGL_LESS, kGL_EQUAL, kGL_LEQUAL, kGL_GREATER, kGL_NOTEQUAL, kGL_GEQUAL, kGL_ALWAYS})) {
        raster_.depth_func = c.enumerant(0);
    }
}

void State::depth_mask(const Command& c) { raster_.depth_mask = c.number(0) != 0; }

void State::clear_depth(const Command& c) { clear_.clear_depth = std::clamp(c.number(0), 0.0, 1.0); }

void State::clear_color(const Command& c) {
    for (int i = 0; i < 4; ++i) clear_.clear_color[i] = c.number(static_cast<std::size_t>(i));
}

void State::clear(const Command& c) {
    constexpr Enum kBits = kGL_COLOR_BUFFER_BIT | kGL_DEPTH_BUFFER_BIT | kGL_STENCIL_BUFFER_BIT | kGL_ACCUM_BUFFER_BIT;
    const Enum mask = c.enumerant(0);
    if ((mask & ~kBits) != 0) {
        return raise(
            kGL_INVALID_VALUE, c,
            fmt::format("glClear is given the bits {:#x}, which name no buffer; expected GL_COLOR_BUFFER_BIT | "
                        "GL_DEPTH_BUFFER_BIT",
                        mask & ~kBits));
    }
    Clear clear = clear_;
    clear.color = (mask & kGL_COLOR_BUFFER_BIT) != 0;
    clear.depth = (mask & kGL_DEPTH_BUFFER_BIT) != 0 && raster_.depth_mask;
    if (clear.color || clear.depth) items_.emplace_back(clear);
}

void State::flush(const Command&) {}

}  // namespace twinlight
