// The world view: the scene from outside, with its camera's frustum, its axes and its lights, which can be dragged.
#pragma once

#include <optional>
#include <string>

#include "app/demo/texture.h"
#include "app/session/layout.h"
#include "app/session/outside_view.h"
#include "app/session/session.h"
#include "app/session/world.h"
#include "render/programmable/programmable.h"

namespace twinlight::demo {

class WorldView {
  public:
    // Draws the scene at the session's size, if something changed, at the back buffer's lower left corner.
    void update(const session::Session& session, programmable::Renderer& renderer);
    // Puts the picture on ImGui's background, with markers and bars, and carries out what the mouse does: a drag turns the
    // view or moves a light, the wheel zooms, a click selects a light. `inside` is the texture of the scene's own picture, or 0.
    void show(session::Session& session, const session::Cell& cell, unsigned inside);

  private:
    struct Made {
        int revision = -1;
        session::OutsideCamera camera{};
        int width = 0, height = 0;

        friend bool operator==(const Made&, const Made&) = default;
    };
    void carry_out_mouse(session::Session& session, const Rectangle& box);
    void show_markers(const session::Session& session, const Rectangle& box) const;
    void show_inside(const Rectangle& box, unsigned inside) const;
    std::string described(const session::Session& session, const session::LightMarker& light) const;

    session::OutsideView view_{};
    Made made_{};
    std::string error_;  // of the renderer
    std::optional<session::HandleDrag> drag_;
    std::optional<session::Handle> under_mouse_;
    bool orbits_ = false, dragged_ = false;  // since the button was pressed
    Texture texture_{GL_LINEAR};
};

}  // namespace twinlight::demo
