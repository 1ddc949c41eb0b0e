// Panels: the tabs at the window's left.
#pragma once

#include "app/demo/panel_accuracy.h"
#include "app/demo/panel_commands.h"
#include "app/demo/panel_lesson.h"
#include "app/demo/panel_lights.h"
#include "app/demo/panel_lint.h"
#include "app/demo/panel_probe.h"
#include "app/demo/panel_save.h"
#include "app/demo/panel_shaders.h"
#include "app/demo/panes.h"
#include "app/session/layout.h"
#include "app/session/session.h"

namespace twinlight::demo {

class Panels {
  public:
    // To be called in every frame, also when the panels are hidden.
    void update(session::Session& session);
    void show(session::Session& session, const Rectangle& box, const Panes& panes);
    // The tutor's calls, and the pixel under the pointer.
    void show_tutor(session::Session& session, const Rectangle& box);
    // Whether a panel works in the background, so that the window must go on drawing frames.
    bool is_busy(const session::Session& session) const {
        return lint_.is_busy() || lesson_.is_busy() || save_.is_busy() || accuracy_.is_busy() ||
               (session.panel == session::Panel::kProbe && probe_.is_waiting()) ||
               (session.panel == session::Panel::kShaders && shaders_.is_waiting());
    }
    bool is_typing() const { return commands_.is_typing(); }
    SavePanel& saving() { return save_; }

  private:
    AccuracyPanel accuracy_;
    CommandsPanel commands_;
    LessonPanel lesson_;
    LightsPanel lights_;
    LintPanel lint_;
    ProbePanel probe_;
    SavePanel save_;
    ShadersPanel shaders_;
};

}  // namespace twinlight::demo
