// The scene from outside, beside the tutor's picture, with its camera and its lights. A drag turns the view or moves a light, as in the
// window (app/session/world.h).
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/session/session.h"
#include "app/session/world.h"
#include "render/webgl/webgl_frame.h"

namespace twinlight::web {

class PageWorld {
  public:
    // Of a session with a scene. The frame's labels name the camera and the lights.
    webgl::WebglFrame frame(const session::Session& session);
    // The mouse was pressed at this pixel of the last frame, from the top left. Then drag() moves the light that is there; if there is
    // none, it turns the view.
    void press(const session::Session& session, int x, int y);
    // In pixels from the press, y down.
    void drag(session::Session& session, int dx, int dy);
    void zoom(int steps) { session::zoom(camera_, steps); }  // of the wheel; positive is nearer

  private:
    // What a drag starts from.
    struct Drag {
        session::OutsideCamera camera{};
        std::optional<session::Handle> handle{};
        std::shared_ptr<const CommandList> commands{};
        Frame frame{};
        session::World world{};
    };

    session::World world_{};
    session::OutsideCamera camera_{};
    session::WorldProjection projection_{};
    std::shared_ptr<const CommandList> opened_{};  // the scene that the surroundings are of
    Drag drag_{};
};

}  // namespace twinlight::web
