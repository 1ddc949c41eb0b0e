// Selection and feedback (5.2, 5.3), and queries (6.1), whose arguments are checked. In GL_SELECT and GL_FEEDBACK
// nothing is drawn. A scene cannot use the results of either.

#include "scene/state/state.h"

namespace twinlight {

void State::render_mode(const Command& c) {
    const Enum mode = c.enumerant(0);
    if (!known(c, mode, {kGL_RENDER, kGL_SELECT, kGL_FEEDBACK})) return;
    if ((mode == kGL_SELECT && !has_selection_) || (mode == kGL_FEEDBACK && !has_feedback_)) {
        return raise(kGL_INVALID_OPERATION, c, "glRenderMode({}) needs a buffer; call {} first", enum_name(mode),
                     mode == kGL_SELECT ? "glSelectBuffer" : "glFeedbackBuffer");
    }
    render_mode_ = mode;
}

// glSelectBuffer and glFeedbackBuffer.
void State::hit_buffer(const Command& c) {
    const bool selects = c.id == CommandId::glSelectBuffer;
    if (render_mode_ == (selects ? kGL_SELECT : kGL_FEEDBACK))
        return raise(kGL_INVALID_OPERATION, c, "{} is not allowed in the mode {}; call glRenderMode(GL_RENDER) first",
                     c.name(), enum_name(render_mode_));
    if (c.number(0) < 0)
        return raise(kGL_INVALID_VALUE, c, "{} is given the size {}; it must be 0 or more", c.name(), c.number(0));
    const auto types = {kGL_2D, kGL_3D, kGL_3D_COLOR, kGL_3D_COLOR_TEXTURE, kGL_4D_COLOR_TEXTURE};
    if (!selects && !known(c, c.enumerant(1), types)) return;
    (selects ? has_selection_ : has_feedback_) = c.number(0) > 0;
}

void State::is_enabled(const Command& c) {
    const Enum cap = c.enumerant(0);
    // 6.1.1: arrays can be queried too.
    const bool is_array = (cap >= kGL_VERTEX_ARRAY && cap <= kGL_EDGE_FLAG_ARRAY) || cap == kGL_SECONDARY_COLOR_ARRAY ||
                          cap == kGL_FOG_COORD_ARRAY;
    if (!is_array) known_capability(c);
}

void State::query_clip_plane(const Command& c) {
    if (c.enumerant(0) - kGL_CLIP_PLANE0 < kMaxClipPlanes) return;
    raise(kGL_INVALID_ENUM, c, "glGetClipPlane is given {}; expected GL_CLIP_PLANE0 to GL_CLIP_PLANE0 + {}",
          enum_name(c.enumerant(0)), kMaxClipPlanes - 1);
}

}  // namespace twinlight
