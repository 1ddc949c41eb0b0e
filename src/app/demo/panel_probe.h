// The panel "Probe": the lighting equation at a pixel or vertex, with the numbers in it.
#pragma once

#include <array>
#include <optional>

#include "app/demo/patience.h"
#include "app/session/probe.h"
#include "app/session/session.h"
#include "base/image/image.h"

namespace twinlight::demo {

class ProbePanel {
  public:
    // A tooltip with the sum for the probed pixel.
    void show_under_pointer(session::Session& session);
    // `colors`: what each pane shows at the probed pixel, where that is known.
    void show(session::Session& session, const std::array<std::optional<Rgba>, session::kPanes>& colors);

    bool is_waiting() const { return patience_.is_waiting(); }

  private:
    // Returns whether there is an answer for the scene as it is now.
    bool update(session::Session& session);
    void show_choice(session::Session& session);
    void show_colors(const session::Session& session, const std::array<std::optional<Rgba>, session::kPanes>& colors);
    void show_fragment(session::Session& session);
    void show_equation(session::Session& session, const session::ProbePoint& point);

    // The answer is for this scene, look and probe.
    std::optional<session::ProbeAnswer> answer_;
    int revision_ = -1;
    Look look_{};
    Patience patience_;

    std::vector<session::ProbeFragment> fragments_;
    std::size_t fragment_ = 0, point_ = 0;
    std::optional<int> light_{};  // empty: all lights
};

}  // namespace twinlight::demo
