#include "app/demo/view.h"

#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/trigonometric.hpp>
#include <limits>

namespace twinlight::demo {
namespace {

// Inserted commands have a place of their own, so that an error in one does not point into the scene's text.
Command make_command(CommandId id, std::vector<double> arguments) {
    static const auto kFile = std::make_shared<const std::string>("the window's view");
    return {id, std::move(arguments), {kFile, 0, 0}};
}

Command mult_matrix(const glm::dmat4& matrix) {
    const double* first = glm::value_ptr(matrix);
    return make_command(CommandId::glMultMatrixd, {first, first + 16});
}

bool draws(const Command& command) {
    return command.id == CommandId::glBegin || command.sig().family == Family::kShape ||
           command.id == CommandId::pragma_shape;
}

// Moves, turns or scales objects. The projections do not count: an orbit before them would turn about a point
// of clip space.
bool transforms(CommandId id) {
    switch (id) {
        case CommandId::glMultMatrixf:
        case CommandId::glMultMatrixd:
        case CommandId::glRotatef:
        case CommandId::glRotated:
        case CommandId::glScalef:
        case CommandId::glScaled:
        case CommandId::glTranslatef:
        case CommandId::glTranslated: return true;
        default: return false;
    }
}

glm::dvec3 look_at_pivot(const Command& look_at) {
    const auto point = [&](std::size_t i) {
        return glm::dvec3(look_at.number(i), look_at.number(i + 1), look_at.number(i + 2));
    };
    return {0, 0, -glm::distance(point(0), point(3))};  // gluLookAt puts the eye at 0, looking along -z
}

// The matrix mode of the scene's gluLookAt calls: the modelview's, if there are any.
std::optional<Enum> look_at_mode(const CommandList& scene) {
    Enum mode = kGL_MODELVIEW;
    std::optional<Enum> found;
    for (const Command& command : scene.commands) {
        if (command.id == CommandId::glMatrixMode) mode = command.enumerant(0);
        if (command.id != CommandId::gluLookAt) continue;
        if (mode == kGL_MODELVIEW) return mode;
        found = mode;
    }
    return found;
}

// Copies commands and inserts the orbit. Tracks which matrices of the stack already have it.
class OrbitWriter {
  public:
    OrbitWriter(const View& view, const CommandList& scene)
        : view_(view), look_at_mode_(look_at_mode(scene)), orbit_mode_(look_at_mode_.value_or(kGL_MODELVIEW)) {}

    void write(const Command& command, std::vector<Command>& out) {
        const bool own_mode = mode_ == orbit_mode_;
        if (look_at_mode_) {
            if (command.id == CommandId::gluLookAt && own_mode) turn(look_at_pivot(command), out);
        } else if (draws(command) || (own_mode && (transforms(command.id) || command.id == CommandId::glPushMatrix))) {
            turn(view_.pivot_eye, out);
        } else if (own_mode && is_load_matrix(command.id)) {
            // orbit * the loaded matrix
            out.push_back(make_command(CommandId::glLoadIdentity, {}));
            turned_.back() = false;
            turn(view_.pivot_eye, out);
            Command product = command;
            product.id = command.id == CommandId::glLoadMatrixf ? CommandId::glMultMatrixf : CommandId::glMultMatrixd;
            out.push_back(std::move(product));
            return;
        }
        out.push_back(command);
        follow(command, own_mode);
    }

  private:
    static bool is_load_matrix(CommandId id) {
        return id == CommandId::glLoadMatrixf || id == CommandId::glLoadMatrixd;
    }

    void turn(const glm::dvec3& pivot_eye, std::vector<Command>& out) {
        if (turned_.back()) return;
        turned_.back() = true;
        const bool switch_mode = mode_ != orbit_mode_;  // a scene that draws while another matrix is current
        if (switch_mode) out.push_back(make_command(CommandId::glMatrixMode, {static_cast<double>(orbit_mode_)}));
        out.push_back(mult_matrix(orbit(view_, pivot_eye)));
        if (switch_mode) out.push_back(make_command(CommandId::glMatrixMode, {static_cast<double>(mode_)}));
    }

    void follow(const Command& command, bool own_mode) {
        if (command.id == CommandId::glMatrixMode) mode_ = command.enumerant(0);
        if (!own_mode) return;
        if (command.id == CommandId::glLoadIdentity || is_load_matrix(command.id)) turned_.back() = false;
        if (command.id == CommandId::glPushMatrix) turned_.push_back(turned_.back());
        if (command.id == CommandId::glPopMatrix && turned_.size() > 1) turned_.pop_back();
    }

    const View& view_;
    const std::optional<Enum> look_at_mode_;
    const Enum orbit_mode_;
    Enum mode_ = kGL_MODELVIEW;
    std::vector<bool> turned_{false};  // a flag for each matrix on the stack of orbit_mode_
};

bool switches_light(const Command& command, int light) {
    return (command.id == CommandId::glEnable || command.id == CommandId::glDisable) &&
           command.enumerant(0) == kGL_LIGHT0 + static_cast<Enum>(light);
}

}  // namespace

glm::dmat4 orbit(const View& view, const glm::dvec3& pivot_eye) {
    const glm::dvec3 nearer_pivot_eye(pivot_eye.x, pivot_eye.y, pivot_eye.z / view.zoom);
    glm::dmat4 matrix = glm::translate(glm::dmat4(1), nearer_pivot_eye);
    matrix = glm::rotate(matrix, glm::radians(view.pitch_deg), glm::dvec3(1, 0, 0));
    matrix = glm::rotate(matrix, glm::radians(view.yaw_deg), glm::dvec3(0, 1, 0));
    return glm::translate(matrix, -pivot_eye);
}

CommandList apply_view(const CommandList& scene, const View& view) {
    CommandList seen{scene.name, {}};
    seen.commands.reserve(scene.commands.size() + 16);

    // The view's state comes first; the scene's own commands for it are then dropped.
    if (view.shade_model) {
        seen.commands.push_back(make_command(CommandId::glShadeModel, {static_cast<double>(*view.shade_model)}));
    }
    if (view.wireframe) {
        seen.commands.push_back(make_command(CommandId::glPolygonMode, {kGL_FRONT_AND_BACK, kGL_LINE}));
    }
    for (int i = 0; i < kMaxLights; ++i) {
        // A light is off until the scene enables it (table 6.11), so an inverted one starts on.
        if (view.light_inverted[static_cast<std::size_t>(i)]) {
            seen.commands.push_back(
                make_command(CommandId::glEnable, {static_cast<double>(kGL_LIGHT0 + static_cast<Enum>(i))}));
        }
    }

    const bool moved = view.yaw_deg != 0 || view.pitch_deg != 0 || view.zoom != 1;
    OrbitWriter orbit_writer(view, scene);
    for (Command command : scene.commands) {
        if (view.shade_model && command.id == CommandId::glShadeModel) continue;
        if (view.wireframe && command.id == CommandId::glPolygonMode) continue;
        for (int i = 0; i < kMaxLights; ++i) {
            if (view.light_inverted[static_cast<std::size_t>(i)] && switches_light(command, i)) {
                command.id = command.id == CommandId::glEnable ? CommandId::glDisable : CommandId::glEnable;
            }
        }
        if (moved) {
            orbit_writer.write(command, seen.commands);
        } else {
            seen.commands.push_back(std::move(command));
        }
    }
    return seen;
}

glm::dvec3 middle_of(const Frame& frame) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    glm::dvec3 least(kInfinity), most(-kInfinity);
    for (const Draw* draw : frame.draws()) {
        for (const Vertex& vertex : draw->vertices) {
            const glm::dvec4 position_eye = draw->eye_from_object * vertex.position_object;
            const glm::dvec3 point = glm::dvec3(position_eye) / position_eye.w;
            if (!std::isfinite(point.x) || !std::isfinite(point.y) || !std::isfinite(point.z)) continue;
            least = glm::min(least, point);
            most = glm::max(most, point);
        }
    }
    return least.x <= most.x ? (least + most) / 2.0 : View{}.pivot_eye;
}

}  // namespace twinlight::demo
