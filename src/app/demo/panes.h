// Panes: the pictures of the window, each drawn by its renderer when something changed, and kept in a texture.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/demo/overlays.h"
#include "app/demo/pair_verdict.h"
#include "app/demo/pane_worker.h"
#include "app/demo/texture.h"
#include "app/demo/world_view.h"
#include "app/session/layout.h"
#include "app/session/reference_worker.h"
#include "app/session/session.h"
#include "base/image/difference.h"

namespace twinlight::demo {

// The times of one second's frames.
class FrameTimes {
  public:
    void add(double ms);
    std::optional<double> median_ms() const;
    std::optional<double> last_ms() const;

  private:
    using Clock = std::chrono::steady_clock;
    std::deque<std::pair<Clock::time_point, double>> times_;
};

class Panes {
  public:
    // Needs the window's context to be current, here and until the end.
    Panes() = default;
    Panes(const Panes&) = delete;
    Panes& operator=(const Panes&) = delete;

    // Draws what changed, and waits for it for a short time or, if `waits`, until it is drawn. The back buffer's lower left corner may be
    // overwritten.
    void update(const session::Session& session, const session::Layout& layout, bool waits);
    // Puts the pictures on ImGui's background, between the bars.
    void show(session::Session& session, const session::Layout& layout);
    // Whether another frame would show more: the driver or the reference is at work, or pictures are still to be compared. `wait`
    // waits for them.
    bool is_busy(const session::Session& session) const;
    void wait(const session::Session& session) const;
    // Whether the last frame lacks a picture that the driver is drawing, and to wait for it.
    bool is_late() const { return is_late_; }
    void wait_for_driver() const { painter_.wait(); }

    // The texture of a small picture of a built-in scene, which is drawn when nothing else is; 0 until then.
    unsigned small_picture(const std::string& scene);
    static constexpr WindowSize kSmallPicture{320, 240};

    // How long the pane's last picture took.
    std::optional<double> last_ms(std::size_t pane) const { return drawn_[pane].times.last_ms(); }

    // The colour of a pixel (from the top left) as each pane of session.panes shows it; empty where it does not know.
    std::array<std::optional<Rgba>, session::kPanes> colors_at(int x, int y) const;

  private:
    struct Wanted {  // of the fixed function or the shaders
        session::Pane pane;
        Look look{};
        int revision = -1;
        int width = 0, height = 0;

        friend bool operator==(const Wanted&, const Wanted&) = default;
    };
    struct Drawn {                       // what a texture holds
        std::optional<Wanted> wanted{};  // the picture asked for last; empty for the reference
        std::optional<session::Pane> pane;
        Look look{};
        int revision = -1;
        int width = 0, height = 0;
        Texture texture{GL_NEAREST};
        int version = 0;                                          // counts the texture's pictures
        OverlaidPicture overlaid{};                               // the texture with the overlays
        std::shared_ptr<const std::vector<std::uint8_t>> rgba{};  // not of the reference
        bool is_new = false;                                      // since the last frame
        Image image{};                                            // empty unless it was needed
        std::shared_ptr<const session::ReferencePicture> reference{};
        std::chrono::steady_clock::time_point since{};  // the reference's picture is from then
        std::string error{};                            // of the renderer
        FrameTimes times{};
    };
    struct Difference {
        int revision = -1;
        session::Pair pair{};
        int amplification = 1;
        bool has_allowed = false;
        std::array<const void*, 2> images{};  // what it was made from
        ImageDifference numbers{};
        std::optional<PairVerdict> verdict{};  // empty while the reference is at work
        Texture texture{GL_NEAREST};
    };

    bool lacks_images(const session::Session& session) const;
    bool wants_image(const session::Session& session, std::size_t pane) const;
    void request_picture(const session::Session& session, std::size_t pane);
    void request_overlaid(const session::Session& session, std::size_t pane);
    void take_pictures();
    void take_picture(PanePicture& picture);
    void take_small_picture(const PanePicture& picture);
    void make_images(const session::Session& session);
    bool is_behind(const Drawn& drawn) const;
    void request_reference(const session::Session& session, const std::array<bool, session::kPanes>& shown);
    void take_reference(const session::Session& session);
    void update_difference(const session::Session& session);
    const Rectangle& time_bar(const session::Session& session, const session::Cell& cell) const;
    void show_header(session::Session& session, const session::Cell& cell);
    void show_footer(session::Session& session, const session::Cell& cell);
    std::pair<std::string, unsigned> footer_of(const session::Session& session, std::size_t pane, float room) const;
    void show_amplification(session::Session& session, const Rectangle& picture);
    void show_slider(session::Session& session, const session::Cell& cell);
    void show_slider_bars(session::Session& session, const session::Cell& cell);
    void show_sides(session::Session& session, const Rectangle& bar);
    void show_picture(session::Session& session, const session::Cell& cell);
    bool has_difference(const session::Session& session) const { return difference_.revision == session.revision; }
    std::string time_of(const session::Session& session, std::size_t pane) const;
    bool shows_overlays(const session::Session& session, std::size_t pane) const;
    unsigned shown_texture(const session::Session& session, std::size_t pane) const;

    std::array<Drawn, session::kPanes> drawn_;
    Difference difference_;
    WorldView world_;
    PaneWorker painter_;
    bool is_late_ = false;                                   // the last frame did not get all pictures
    std::map<std::string, std::unique_ptr<Texture>> small_;  // by scene
    std::optional<std::string> small_wanted_{};              // the one at work
    std::shared_ptr<const Scene> scene_;                     // the session's, for painter_
    int scene_revision_ = -1;
    session::ReferenceWorker worker_;
    std::vector<std::shared_ptr<const session::ReferencePicture>> references_;  // the newest of each look
    std::shared_ptr<const session::ReferenceAllowed> allowed_;
};

}  // namespace twinlight::demo
