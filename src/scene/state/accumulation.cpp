// The accumulation buffer (4.2.3, 4.2.4).
#include "scene/state/state.h"

namespace twinlight {

void State::clear_accumulation(const Command& c) {
    const glm::dvec4 color(c.number(0), c.number(1), c.number(2), c.number(3));
    a_.clear.clear_accumulation = glm::clamp(color, glm::dvec4(-1), glm::dvec4(1));
}

void State::accumulate(const Command& c) {
    const Enum op = c.enumerant(0);
    if (!known(c, op, {kGL_ACCUM, kGL_LOAD, kGL_RETURN, kGL_MULT, kGL_ADD})) return;
    if (framebuffers_.draw != 0 || framebuffers_.read != 0)
        return raise(kGL_INVALID_OPERATION, c, "glAccum: a framebuffer object has no accumulation buffer");
    if (!has_room(c, sizeof items_[0])) return;
    Accumulate accumulate{.op = op, .value = c.number(1), .scissor = a_.fragment.scissor};
    accumulate.color_mask = a_.fragment.color_mask;
    if (!a_.draws_color) accumulate.color_mask.fill(false);
    show(accumulate);
}

}  // namespace twinlight
