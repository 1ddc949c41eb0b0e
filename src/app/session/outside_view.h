// The scene seen from outside, and a drag of one of its lights: what the window and the page keep of it.
#pragma once

#include <memory>

#include "app/session/session.h"
#include "app/session/world.h"

namespace twinlight::session {

struct OutsideView {
    World world{};
    OutsideCamera camera{};
    WorldProjection projection{};

    // Takes the session's scene and size. The view of one scene stays where it is while things move; another one gets the camera to
    // start with.
    void follow(const Session& session);

  private:
    std::shared_ptr<const CommandList> opened_{};  // the scene that the surroundings are of
    int revision_ = -1;                            // of the session, that the world is of
};

// A drag of a handle starts from the commands and the world that it began with.
struct HandleDrag {
    HandleDrag(const Session& session, const World& world, const Handle& handle);

    Handle handle;
    std::shared_ptr<const CommandList> commands;
    Frame frame;
    World world;
};
// The edit that moves it by so many pixels since then.
void carry_out(Session& session, const HandleDrag& drag, const WorldProjection& projection,
               const glm::dvec2& by_pixels);

}  // namespace twinlight::session
