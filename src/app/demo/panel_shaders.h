// The panel "Shaders": the GLSL that draws the scene as it is now, and the reason for each effect in or out.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/demo/patience.h"
#include "app/session/session.h"
#include "app/session/shader_view.h"

namespace twinlight::demo {

class ShadersPanel {
  public:
    void show(session::Session& session);
    bool is_waiting() const { return patience_.is_waiting(); }

  private:
    void update(const session::Session& session);
    void make_shaders(const session::Session& session);
    void show_reasons(const session::ShownShader& shader) const;
    void show_glsl(session::Session& session);

    // The shaders are for this scene, look and kind.
    int revision_ = -1;
    Look look_{};
    Patience patience_;
    bool to_keep_ = false, made_to_keep_ = false;

    std::vector<session::ShownShader> shaders_;
    std::string trouble_;
    std::vector<ExplainedDraw> plans_;
    std::size_t shown_ = 0;
    std::size_t inked_ = 0;  // the shader that `lines_` belongs to
    std::vector<std::vector<session::InkedText>> lines_;
    bool all_reasons_ = false;
    std::shared_ptr<const CommandList> opened_;  // the scene that `shown_` was chosen for
};

}  // namespace twinlight::demo
