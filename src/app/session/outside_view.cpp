#include "app/session/outside_view.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "base/text/translation.h"
#include "scene/command/names.h"

namespace twinlight::session {

void OutsideView::follow(const Session& session) {
    if (std::exchange(revision_, session.revision) != session.revision) {
        const bool is_same = opened_ == session.opened;
        opened_ = session.opened;
        world = world_of(commands(session), session.scene.frame, is_same ? std::optional(world.around) : std::nullopt);
        if (!is_same) camera = first_camera(world);
    }
    projection = projection_of(world, camera, session.width, session.height);
}

HandleDrag::HandleDrag(const Session& session, const World& begun_in, const Handle& dragged)
    : handle(dragged), commands(session.history.now()), frame(session.scene.frame), world(begun_in) {}

void carry_out(Session& session, const HandleDrag& drag, const WorldProjection& projection,
               const glm::dvec2& by_pixels) {
    const int light = drag.world.lights[drag.handle.light].number;
    const std::string what =
        drag.handle.is_spot_direction ? tr("turn {}", light_name(light)) : tr("move {}", light_name(light));
    edit(session, with_handle_moved(*drag.commands, drag.frame, drag.world, projection, drag.handle, by_pixels), what,
         fmt::format("light {}", light));
}

}  // namespace twinlight::session
