// The scene from outside, beside the tutor's picture, with its camera and its lights. A drag turns the view or moves a light, as in the
// window (app/session/world.h).
#pragma once

#include <optional>

#include "app/session/outside_view.h"
#include "render/webgl/webgl_frame.h"

namespace twinlight::web {

class PageWorld {
  public:
    // The session must have a scene. The frame's labels name the camera and the lights.
    webgl::WebglFrame frame(const session::Session& session);
    // The mouse was pressed at this pixel of the last frame, from the top left. Then drag() moves the light that is there; if there is
    // none, it turns the view.
    void press(const session::Session& session, int x, int y);
    // In pixels from the press, y down.
    void drag(session::Session& session, int dx, int dy);
    void zoom(int steps) { session::zoom(view_.camera, steps); }  // of the wheel; positive is nearer

  private:
    session::OutsideView view_{};
    session::OutsideCamera before_{};            // what a drag of the view starts from
    std::optional<session::HandleDrag> drag_{};  // of a light
};

}  // namespace twinlight::web
