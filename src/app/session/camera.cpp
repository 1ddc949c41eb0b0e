#include "app/session/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "base/math/directions.h"
#include "base/text/translation.h"
#include "scene/command/command_set.h"

namespace twinlight::session {
namespace {

constexpr double kMostElevationDeg = 89;   // at 90 degrees gluLookAt has no side
constexpr double kLeastAboveFloorDeg = 1;  // how near to the floor a camera above it comes
constexpr int kDigits = 6;                 // of a changed argument, counted from the first digit of the distance
constexpr double kUsualDistance = 5;       // of a pivot that has none of its own

struct LookAt {
    glm::dvec3 eye, centre, up;

    explicit LookAt(const Command& command)
        : eye(point(command, 0)), centre(point(command, 3)), up(point(command, 6)) {}

    static glm::dvec3 point(const Command& c, std::size_t i) { return {c.number(i), c.number(i + 1), c.number(i + 2)}; }
};

// A number of the scene's text: as few digits as make no visible difference.
glm::dvec3 rounded(const glm::dvec3& value, double distance) {
    const int digits = kDigits - 1 - static_cast<int>(std::floor(std::log10(distance)));
    // Dividing by a power of ten gives the double that the decimal digits mean.
    const double power = std::pow(10.0, std::abs(digits));
    const auto round = [&](double x) {
        const double result = digits >= 0 ? std::round(x * power) / power : std::round(x / power) * power;
        return result == 0 ? 0.0 : result;  // no -0
    };
    return {round(value.x), round(value.y), round(value.z)};
}

// A direction as a heading on the plane at right angles to `up_dir` and an elevation above it.
struct Heading {
    glm::dvec3 level_dir;
    double elevation_deg;

    Heading(const glm::dvec3& dir, const glm::dvec3& up_dir) {
        const double sine = std::clamp(glm::dot(dir, up_dir), -1.0, 1.0);
        elevation_deg = glm::degrees(std::asin(sine));
        glm::dvec3 level = dir - sine * up_dir;
        if (glm::length(level) < 1e-9) {  // straight up or down: any heading
            const glm::dvec3 other_dir = std::abs(up_dir.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
            level = other_dir - glm::dot(other_dir, up_dir) * up_dir;
        }
        level_dir = unit(level);
    }

    // Counterclockwise, seen from the tip of `up_dir`.
    void turn(double deg, const glm::dvec3& up_dir) {
        const double angle = glm::radians(deg);
        level_dir = std::cos(angle) * level_dir + std::sin(angle) * glm::cross(up_dir, level_dir);
    }
    // Stays within the limits; where it starts outside, it may stay there.
    void raise(double deg, double least_deg, double most_deg) {
        elevation_deg =
            std::clamp(elevation_deg + deg, std::min(least_deg, elevation_deg), std::max(most_deg, elevation_deg));
        elevation_deg = std::clamp(elevation_deg, -kMostElevationDeg, kMostElevationDeg);
    }
    glm::dvec3 dir(const glm::dvec3& up_dir) const {
        const double elevation = glm::radians(elevation_deg);
        return std::cos(elevation) * level_dir + std::sin(elevation) * up_dir;
    }
};

bool is_finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

Command moved(const Command& command, const CameraMove& move) {
    LookAt camera(command);
    const glm::dvec3 up_dir = unit(camera.up);
    double distance = glm::distance(camera.eye, camera.centre);
    if (!is_finite(camera.eye) || !is_finite(camera.centre) || !(distance > 0) || !(glm::length(up_dir) > 0))
        return command;

    if (move.yaw_deg != 0 || move.pitch_deg != 0 || move.zoom != 1) {
        Heading from_centre((camera.eye - camera.centre) / distance, up_dir);
        const bool stays_above = from_centre.elevation_deg > 0 && !move.may_go_under;
        from_centre.turn(-move.yaw_deg, up_dir);
        from_centre.raise(move.pitch_deg, stays_above ? kLeastAboveFloorDeg : -kMostElevationDeg, kMostElevationDeg);
        distance /= move.zoom;
        camera.eye = camera.centre + distance * from_centre.dir(up_dir);
    }
    if (!(distance > 0) || !std::isfinite(distance)) return command;
    const Heading view((camera.centre - camera.eye) / distance, up_dir);
    const glm::dvec3 walk =
        distance * (move.forward * view.level_dir + move.right * glm::cross(view.level_dir, up_dir) + move.up * up_dir);
    camera.eye += walk;
    camera.centre += walk;
    if (move.look_yaw_deg != 0 || move.look_pitch_deg != 0) {
        Heading looked = view;
        looked.turn(-move.look_yaw_deg, up_dir);
        looked.raise(move.look_pitch_deg, -kMostElevationDeg, kMostElevationDeg);
        camera.centre = camera.eye + distance * looked.dir(up_dir);
    }

    const LookAt before(command);
    Command result = command;
    const auto store = [&](std::size_t first, const glm::dvec3& from, const glm::dvec3& to) {
        if (from == to) return;
        const glm::dvec3 value = rounded(to, distance);
        for (int i = 0; i < 3; ++i) result.arguments[first + static_cast<std::size_t>(i)] = value[i];
    };
    store(0, before.eye, camera.eye);
    store(3, before.centre, camera.centre);
    const LookAt after(result);
    return is_finite(after.eye) && is_finite(after.centre) && after.eye != after.centre ? result : command;
}

// The matrix mode of the scene's gluLookAt calls: the modelview's, if there are any.
std::optional<Enum> look_at_mode(const CommandList& commands) {
    Enum mode = kGL_MODELVIEW;
    std::optional<Enum> found;
    for (const Command& command : commands.commands) {
        if (command.id == CommandId::glMatrixMode) mode = command.enumerant(0);
        if (command.id != CommandId::gluLookAt) continue;
        if (mode == kGL_MODELVIEW) return mode;
        found = mode;
    }
    return found;
}

// The file of inserted commands.
const std::shared_ptr<const std::string>& window_camera() {
    static const auto kFile = std::make_shared<const std::string>(tr("the window's camera"));
    return kFile;
}

// Copies commands and moves each camera. Tracks which matrices of the stack already have one.
class CameraWriter {
  public:
    CameraWriter(const CommandList& commands, const CameraMove& move, const glm::dvec3& pivot_eye)
        : move_(move),
          look_at_mode_(look_at_mode(commands)),
          camera_mode_(look_at_mode_.value_or(kGL_MODELVIEW)),
          inserted_(camera_at(pivot_eye)) {
        inserted_.back() = moved(inserted_.back(), move_);
    }

    // Inserts these commands, into a scene without gluLookAt.
    CameraWriter(const CommandList& commands, std::vector<Command> inserted)
        : look_at_mode_(look_at_mode(commands)),
          camera_mode_(look_at_mode_.value_or(kGL_MODELVIEW)),
          inserted_(std::move(inserted)) {}

    void write(Command command, std::vector<Command>& out) {
        const bool own_mode = mode_ == camera_mode_;
        if (look_at_mode_) {
            if (command.id == CommandId::gluLookAt && own_mode && !has_camera_.back()) {
                command = moved(command, move_);
                has_camera_.back() = true;
            }
        } else if (command.id == CommandId::glNewList) {
            in_list_ = true;
        } else if (command.id == CommandId::glEndList) {
            in_list_ = false;
        } else if (in_list_) {
            // The camera comes before the list's call.
        } else if (draws(command) || (own_mode && (transforms(command.id) || command.id == CommandId::glPushMatrix))) {
            insert(out);
        } else if (own_mode && product_of(command.id)) {  // camera * the loaded matrix
            out.push_back(make(CommandId::glLoadIdentity, {}));
            has_camera_.back() = false;
            insert(out);
            command.id = *product_of(command.id);
        }
        if (!in_list_ || look_at_mode_) follow(command, own_mode);
        out.push_back(std::move(command));
    }

  private:
    // An inserted command has a place of its own, so that an error in it does not point into the scene's text.
    static Command make(CommandId id, std::vector<double> arguments) {
        return {id, std::move(arguments), {window_camera(), 0, 0}};
    }

    // Commands whose product is 1, with a gluLookAt that has the pivot as its centre.
    static std::vector<Command> camera_at(const glm::dvec3& pivot_eye) {
        double distance = -pivot_eye.z;
        if (!(distance > 0)) distance = std::max(glm::length(pivot_eye), kUsualDistance);
        // A pivot near the axis is taken as on it: then gluLookAt is enough.
        const bool on_axis = pivot_eye.z < 0 && glm::length(glm::dvec2(pivot_eye)) < 0.05 * distance;
        const glm::dvec3 centre = rounded(on_axis ? glm::dvec3(0, 0, pivot_eye.z) : pivot_eye, distance);
        const glm::dvec3 eye = pivot_eye.z < 0 ? glm::dvec3(centre.x, centre.y, 0)
                                               : rounded(centre + glm::dvec3(0, 0, distance), distance);
        std::vector<Command> result;
        if (eye != glm::dvec3(0)) result.push_back(make(CommandId::glTranslated, {eye.x, eye.y, eye.z}));
        result.push_back(make(CommandId::gluLookAt, {eye.x, eye.y, eye.z, centre.x, centre.y, centre.z, 0, 1, 0}));
        return result;
    }

    // Draws, or transforms the raster position.
    static bool draws(const Command& command) {
        constexpr CommandSet kDrawing = kDrawCommands | kListCommands | CommandSet::of({"raster_pos"});
        return kDrawing.contains(command.id);
    }

    // Moves, turns or scales objects. The projections do not count: a camera before them would turn about a point of
    // clip space.
    static bool transforms(CommandId id) {
        switch (id) {
            case CommandId::glMultMatrixf:
            case CommandId::glMultMatrixd:
            case CommandId::glMultTransposeMatrixf:
            case CommandId::glMultTransposeMatrixd:
            case CommandId::glRotatef:
            case CommandId::glRotated:
            case CommandId::glScalef:
            case CommandId::glScaled:
            case CommandId::glTranslatef:
            case CommandId::glTranslated: return true;
            default: return false;
        }
    }

    // glMultMatrix for glLoadMatrix.
    static std::optional<CommandId> product_of(CommandId load) {
        switch (load) {
            case CommandId::glLoadMatrixf: return CommandId::glMultMatrixf;
            case CommandId::glLoadMatrixd: return CommandId::glMultMatrixd;
            case CommandId::glLoadTransposeMatrixf: return CommandId::glMultTransposeMatrixf;
            case CommandId::glLoadTransposeMatrixd: return CommandId::glMultTransposeMatrixd;
            default: return std::nullopt;
        }
    }

    void insert(std::vector<Command>& out) {
        if (has_camera_.back()) return;
        has_camera_.back() = true;
        const bool switch_mode = mode_ != camera_mode_;  // a scene that draws while another matrix is current
        if (switch_mode) out.push_back(make(CommandId::glMatrixMode, {static_cast<double>(camera_mode_)}));
        out.insert(out.end(), inserted_.begin(), inserted_.end());
        if (switch_mode) out.push_back(make(CommandId::glMatrixMode, {static_cast<double>(mode_)}));
    }

    void follow(const Command& command, bool own_mode) {
        if (command.id == CommandId::glMatrixMode) mode_ = command.enumerant(0);
        if (!own_mode) return;
        if (command.id == CommandId::glLoadIdentity || product_of(command.id)) has_camera_.back() = false;
        if (command.id == CommandId::glPushMatrix) has_camera_.push_back(has_camera_.back());
        if (command.id == CommandId::glPopMatrix && has_camera_.size() > 1) has_camera_.pop_back();
    }

    CameraMove move_{};
    const std::optional<Enum> look_at_mode_;
    const Enum camera_mode_;
    std::vector<Command> inserted_;  // into a scene without gluLookAt
    Enum mode_ = kGL_MODELVIEW;
    bool in_list_ = false;
    std::vector<bool> has_camera_{false};  // a flag for each matrix on the stack of camera_mode_
};

}  // namespace

CommandList with_camera_moved(const CommandList& commands, const CameraMove& move, const glm::dvec3& pivot_eye) {
    CameraMove nowhere;
    nowhere.may_go_under = move.may_go_under;
    if (move == nowhere) return commands;
    CommandList result = commands;
    result.commands.clear();
    result.commands.reserve(commands.commands.size() + 8);
    CameraWriter writer(commands, move, pivot_eye);
    for (const Command& command : commands.commands) writer.write(command, result.commands);
    return result;
}

CommandList with_camera_of(const CommandList& commands, const CommandList& opened, const CommandList& now) {
    CommandList result = commands;
    if (look_at_mode(opened)) {
        const auto cameras = [](auto& list) {
            std::vector<decltype(&list.commands.front())> found;
            for (auto& command : list.commands)
                if (command.id == CommandId::gluLookAt) found.push_back(&command);
            return found;
        };
        const auto before = cameras(opened), after = cameras(now);
        const auto written = cameras(result);
        // Steps with other numbers of cameras have no common ones.
        if (before.size() != after.size() || before.size() != written.size()) return result;
        for (std::size_t i = 0; i < before.size(); ++i)
            if (after[i]->arguments != before[i]->arguments) written[i]->arguments = after[i]->arguments;
        return result;
    }
    // The first camera that the window has inserted, without the changes of the matrix mode around it.
    std::vector<Command> inserted;
    for (const Command& command : now.commands) {
        if (command.place.file != window_camera()) continue;
        if (command.id == CommandId::glTranslated) inserted.push_back(command);
        if (command.id != CommandId::gluLookAt) continue;
        inserted.push_back(command);
        break;
    }
    if (inserted.empty() || look_at_mode(commands)) return result;
    result.commands.clear();
    CameraWriter writer(commands, std::move(inserted));
    for (const Command& command : commands.commands) writer.write(command, result.commands);
    return result;
}

glm::dvec3 middle_of(const Frame& frame) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    glm::dvec3 least(kInfinity), most(-kInfinity);
    for (const Draw* draw : frame.draws()) {
        for (const Vertex& vertex : draw->vertices) {
            const glm::dvec4 position_eye = draw->eye_from_object * vertex.position_object;
            const glm::dvec3 point = glm::dvec3(position_eye) / position_eye.w;
            if (!is_finite(point)) continue;
            least = glm::min(least, point);
            most = glm::max(most, point);
        }
    }
    return least.x <= most.x ? (least + most) / 2.0 : glm::dvec3(0, 0, -kUsualDistance);
}

}  // namespace twinlight::session
