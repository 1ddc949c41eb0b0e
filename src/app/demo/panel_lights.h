// The panel of what lights one drawing command: the eight lights, the material, the light model, colour material and the
// mesh. Every change is an edit of the call that set the value.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/session/light_values.h"
#include "app/session/mesh_error.h"
#include "app/session/session.h"

namespace twinlight::demo {

class LightsPanel {
  public:
    void show(session::Session& session);

  private:
    void refresh(const session::Session& session);
    void show_drawing(session::Session& session);
    void show_light(session::Session& session, int light);
    void show_light_details(session::Session& session, int light);
    void show_spot(session::Session& session, int light);
    void show_material(session::Session& session);
    void show_face(session::Session& session, Enum face);
    void show_presets(session::Session& session);
    void show_model(session::Session& session);
    void show_color_material(session::Session& session);
    void show_mesh(session::Session& session);

    // A label at the left, which names the call that set the value; a click shows the call.
    void label(session::Session& session, const char* text, const session::SetBy& by) const;
    const session::SetBy& set_by(int light, Enum pname) const;
    void edit_light(session::Session& session, int light, Enum pname, const std::vector<double>& numbers);
    void edit_material(session::Session& session, Enum face, Enum pname, const std::vector<double>& numbers);

    std::shared_ptr<const CommandList> shown_;
    std::vector<session::DrawingCommand> drawing_;
    std::size_t chosen_ = 0;  // index into drawing_
    std::optional<std::size_t> selected_command_;
    std::optional<session::LightingValues> values_;
    session::MeshError mesh_error_;
    int mesh_revision_ = -1;
    std::optional<int> opened_light_;
};

}  // namespace twinlight::demo
