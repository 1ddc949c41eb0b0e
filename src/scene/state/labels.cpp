// Labels: texts over the picture, at a point of the scene.
#include "scene/state/state.h"

namespace twinlight {

// The point is transformed as a vertex is. A label that the view volume (2.12) does not contain is not shown; clip planes and
// depths do not hide it.
void State::label(const Command& c) {
    if (render_mode_ != kGL_RENDER || framebuffers_.draw != 0) return;
    const glm::dvec4 clip = projection() * (modelview() * glm::dvec4(c.number(0), c.number(1), c.number(2), 1));
    const auto is_inside = [&](double x) { return std::abs(x) <= clip.w; };
    if (!(clip.w > 0) || !is_inside(clip.x) || !is_inside(clip.y) || !is_inside(clip.z)) return;
    if (!has_room(c, sizeof labels_[0] + c.text().size())) return;
    const Rectangle& viewport = a_.raster.viewport;
    const glm::dvec2 corner(viewport.x, viewport.y), size(viewport.width, viewport.height);
    const glm::dvec2 place_window = corner + (glm::dvec2(clip) / clip.w + 1.0) / 2.0 * size;
    labels_.push_back({std::string(c.text()), place_window / glm::dvec2(options_.width, options_.height)});
}

}  // namespace twinlight
