// Overlays: wireframes, normals and marks over a picture, drawn with plain GL; their labels, drawn by ImGui.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "app/demo/pane_worker.h"
#include "app/demo/texture.h"
#include "app/session/layout.h"
#include "app/session/overlays.h"
#include "app/session/session.h"

namespace twinlight::demo {

// Draws the picture in `texture` into the current back buffer's lower left corner, and the overlays over it. What the scene's
// own faces hide is hidden. Leaves GL's initial state and a depth buffer without meaning.
void draw_overlays(const session::OverlayPicture& overlays, unsigned texture, int width, int height);

// Lines in clip coordinates over what was drawn last, with its depth buffer; hidden parts are faint.
void draw_lines(const std::vector<session::OverlayVertex>& lines, int width, int height);

// The scene's own labels (#pragma twinlight label), on ImGui's background, at the picture's place in the window. Leaves out those
// that would lie over another.
void show_scene_labels(const std::vector<SceneLabel>& labels, const Rectangle& picture);
// The overlays' labels, in the same way.
void show_labels(const session::OverlayPicture& overlays, const Rectangle& picture);

// A texture that keeps a picture with its overlays, made again when either changed.
class OverlaidPicture {
  public:
    // The job that makes it, if something changed. `upload` fills a texture with session.scene's picture, whose `version` changes
    // whenever its content does. `look` is the pane's.
    std::optional<PaneJob> next_job(const session::Session& session, const Look& look, int version,
                                    std::function<void(Texture&)> upload);
    void take(const PanePicture& picture);
    void forget();
    // Whether the picture that is shown lacks what was chosen last.
    bool is_behind() const { return made_ != shown_; }
    // Null until a picture is there.
    const session::OverlayPicture* overlays() const { return shown_.get(); }
    unsigned texture() const { return texture_.name(); }

  private:
    struct Wanted {
        session::Overlays overlays;
        int revision = -1, version = -1;
        std::optional<Shading> shading;
        bool lecture_variants = false;

        friend bool operator==(const Wanted&, const Wanted&) = default;
    };
    Wanted wanted_{};
    std::shared_ptr<const session::OverlayPicture> made_{}, shown_{};
    Texture texture_{GL_NEAREST};
};

// The check boxes of all overlays, with a line of help for each. Emits widgets only.
void overlays_panel(session::Session& session);

}  // namespace twinlight::demo
