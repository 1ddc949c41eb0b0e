// Fog (3.10), the per-fragment operations (4.1) and clearing (4.2.3).

#include <algorithm>

#include "scene/state/state.h"

namespace twinlight {

namespace {

glm::dvec4 clamped(const glm::dvec4& v) { return glm::clamp(v, glm::dvec4(0), glm::dvec4(1)); }

glm::dvec4 four(const Command& c) { return {c.number(0), c.number(1), c.number(2), c.number(3)}; }

}  // namespace

void State::scissor(const Command& c) {
    if (c.number(2) < 0 || c.number(3) < 0)
        return raise(kGL_INVALID_VALUE, c, "glScissor is given the size {} x {}; it cannot be negative", c.number(2),
                     c.number(3));
    const auto whole = [&c](std::size_t i) { return static_cast<int>(c.number(i)); };
    a_.fragment.scissor.box = {whole(0), whole(1), whole(2), whole(3)};
}

void State::alpha_func(const Command& c) {
    if (!known(c, c.enumerant(0),
               {kGL_NEVER, kGL_LESS, kGL_EQUAL, kGL_LEQUAL, kGL_GREATER, kGL_NOTEQUAL, kGL_GEQUAL, kGL_ALWAYS}))
        return;
    a_.fragment.alpha_func = c.enumerant(0);
    a_.fragment.alpha_ref = std::clamp(c.number(1), 0.0, 1.0);
}

// Tables 4.1 and 4.2. GL 2.1 allows SRC_ALPHA_SATURATE only for the source; drivers of GL 3 and later allow it for
// both.
void State::blend_func(const Command& c) {
    for (std::size_t i = 0; i < c.arguments.size(); ++i)
        if (!known(c, c.enumerant(i),
                   {kGL_ZERO, kGL_ONE, kGL_SRC_COLOR, kGL_ONE_MINUS_SRC_COLOR, kGL_DST_COLOR, kGL_ONE_MINUS_DST_COLOR,
                    kGL_SRC_ALPHA, kGL_ONE_MINUS_SRC_ALPHA, kGL_DST_ALPHA, kGL_ONE_MINUS_DST_ALPHA, kGL_CONSTANT_COLOR,
                    kGL_ONE_MINUS_CONSTANT_COLOR, kGL_CONSTANT_ALPHA, kGL_ONE_MINUS_CONSTANT_ALPHA,
                    kGL_SRC_ALPHA_SATURATE}))
            return;
    FragmentState& f = a_.fragment;
    f.blend_src = c.enumerant(0);
    f.blend_dst = c.enumerant(1);
    const bool separate = c.arguments.size() == 4;
    f.blend_src_alpha = separate ? c.enumerant(2) : f.blend_src;
    f.blend_dst_alpha = separate ? c.enumerant(3) : f.blend_dst;
}

void State::blend_equation(const Command& c) {
    for (double mode : c.arguments)
        if (!known(c, static_cast<Enum>(mode),
                   {kGL_FUNC_ADD, kGL_FUNC_SUBTRACT, kGL_FUNC_REVERSE_SUBTRACT, kGL_MIN, kGL_MAX}))
            return;
    a_.fragment.blend_equation = c.enumerant(0);
    a_.fragment.blend_equation_alpha = c.enumerant(c.arguments.size() - 1);
}

void State::blend_color(const Command& c) { a_.fragment.blend_color = clamped(four(c)); }

void State::color_mask(const Command& c) {
    for (std::size_t i = 0; i < 4; ++i) a_.fragment.color_mask[i] = c.number(i) != 0;
}

void State::fog(const Command& c) {
    const Enum pname = c.enumerant(0);
    const auto values = parameter_values(c, Owner::kFog, pname);
    if (!values) return;
    const auto name = static_cast<Enum>(std::clamp(values->front(), 0.0, 4294967295.0));
    switch (pname) {
        case kGL_FOG_MODE:
            if (known(c, name, {kGL_LINEAR, kGL_EXP, kGL_EXP2})) a_.fog.mode = name;
            break;
        case kGL_FOG_DENSITY: a_.fog.density = values->front(); break;
        case kGL_FOG_START: a_.fog.start = values->front(); break;
        case kGL_FOG_END: a_.fog.end = values->front(); break;
        case kGL_FOG_COLOR: a_.fog.color = clamped({(*values)[0], (*values)[1], (*values)[2], (*values)[3]}); break;
        case kGL_FOG_COORD_SRC:
            if (known(c, name, {kGL_FRAGMENT_DEPTH, kGL_FOG_COORD})) a_.fog.by_coordinates = name == kGL_FOG_COORD;
            break;
        default: break;
    }
}

// ---- Clearing ----

void State::clear_depth(const Command& c) { a_.clear.clear_depth = std::clamp(c.number(0), 0.0, 1.0); }

void State::clear_color(const Command& c) { a_.clear.clear_color = clamped(four(c)); }

void State::clear(const Command& c) {
    constexpr Enum kBits = kGL_COLOR_BUFFER_BIT | kGL_DEPTH_BUFFER_BIT | kGL_STENCIL_BUFFER_BIT | kGL_ACCUM_BUFFER_BIT;
    const Enum mask = c.enumerant(0);
    if ((mask & ~kBits) != 0) {
        return raise(kGL_INVALID_VALUE, c,
                     "glClear is given the bits {:#x}, which name no buffer; expected GL_COLOR_BUFFER_BIT | "
                     "GL_DEPTH_BUFFER_BIT",
                     mask & ~kBits);
    }
    Clear clear = a_.clear;
    clear.color = (mask & kGL_COLOR_BUFFER_BIT) != 0 && draws_color();
    clear.scissor = a_.fragment.scissor;
    clear.color_mask = a_.fragment.color_mask;
    clear.depth = (mask & kGL_DEPTH_BUFFER_BIT) != 0 && a_.raster.depth_mask;
    clear.stencil_mask = a_.stencil_test.front.write_mask;
    clear.stencil = (mask & kGL_STENCIL_BUFFER_BIT) != 0 && (clear.stencil_mask & kMaxStencil) != 0;
    clear.accumulation = (mask & kGL_ACCUM_BUFFER_BIT) != 0;
    const bool clears = clear.color || clear.depth || clear.stencil || clear.accumulation;
    if (!clears || !has_room(c, sizeof items_[0])) return;
    if (clear.hides_picture() && framebuffers_.draw == 0) labels_.clear();
    show(clear);
}

}  // namespace twinlight
