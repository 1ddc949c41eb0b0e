// The world view: the scene from outside, with its camera's frustum, its axes and its lights, which can be dragged.
#pragma once

#include <optional>
#include <string>

#include "app/demo/pane_worker.h"
#include "app/demo/texture.h"
#include "app/session/layout.h"
#include "app/session/outside_view.h"
#include "app/session/session.h"
#include "app/session/world.h"

namespace twinlight::demo {

class WorldView {
  public:
    // The picture of the scene at the session's size, if something changed.
    std::optional<PaneJob> next_job(const session::Session& session);
    void take(const PanePicture& picture);
    // Puts the picture on ImGui's background, with markers and bars, and carries out what the mouse does: a drag turns the
    // view or moves a light, the wheel zooms, a click selects a light. `inside` is the texture of the scene's own picture, or 0.
    void show(session::Session& session, const session::Cell& cell, unsigned inside);

  private:
    struct Wanted {
        int revision = -1;
        session::OutsideCamera camera{};
        int width = 0, height = 0;

        friend bool operator==(const Wanted&, const Wanted&) = default;
    };
    void carry_out_mouse(session::Session& session, const Rectangle& box);
    void show_markers(const session::Session& session, const Rectangle& box) const;
    void show_inside(const Rectangle& box, unsigned inside) const;
    std::string described(const session::Session& session, const session::LightMarker& light) const;

    session::OutsideView view_{};
    Wanted wanted_{};
    bool is_waiting_ = false;  // for its picture
    std::string error_;        // of the renderer
    std::optional<session::HandleDrag> drag_;
    std::optional<session::Handle> under_mouse_;
    bool orbits_ = false, dragged_ = false;  // since the button was pressed
    Texture texture_{GL_NEAREST};
};

}  // namespace twinlight::demo
