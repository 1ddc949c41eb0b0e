// The world view's handles: lights and spot directions that are dragged, and the calls that change with them.
#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <vector>

#include "app/session/edits.h"
#include "app/session/world.h"
#include "base/math/as_float.h"
#include "base/math/directions.h"
#include "base/text/translation.h"

namespace twinlight::session {
namespace {

// Whether the command sets a parameter of this light.
bool sets(const Command& command, int light, Enum pname) {
    switch (command.id) {
        case CommandId::glLightfv:
        case CommandId::glLightiv:
            return command.enumerant(0) == kGL_LIGHT0 + static_cast<Enum>(light) && command.enumerant(1) == pname;
        case CommandId::pragma_light:
            return static_cast<int>(command.number(0)) == light && command.enumerant(1) == pname;
        default: return false;
    }
}

// As the scene's text would have it: few digits, and a float.
double nice(double value, double size) {
    const double power = std::pow(10.0, std::floor(std::log10(size)) - 2);
    const double result =
        power >= 1 ? std::round(value / power) * power : std::round(value * (1 / power)) / (1 / power);
    return result == 0 ? 0 : as_float(result);
}

// Whether the command gave the light this position or direction.
template <class Vector>
bool gave(const Command& command, int light, Enum pname, const TypedLight::Value<Vector>& typed) {
    constexpr auto kLength = static_cast<std::size_t>(Vector::length());
    if (!sets(command, light, pname) || !(command.place == typed.place) || command.arguments.size() != 2 + kLength)
        return false;
    for (std::size_t i = 0; i < kLength; ++i)  // a loop gives several calls one place
        if (command.arguments[2 + i] != typed.value[static_cast<int>(i)]) return false;
    return true;
}

// New values for a position or direction that `typed` was given.
template <class Vector>
CommandList with_values(const CommandList& commands, int light, Enum pname, const TypedLight::Value<Vector>& typed,
                        const Vector& value) {
    std::vector<double> numbers;
    for (int i = 0; i < Vector::length(); ++i) numbers.push_back(value[i]);
    CommandList result = commands;
    if (typed.is_initial()) {
        static const auto kFile = std::make_shared<const std::string>(tr("the window's light"));
        const bool is_extra = light >= kMaxLights;
        const Enum name = static_cast<Enum>(light) + (is_extra ? 0 : kGL_LIGHT0);
        Command command{is_extra ? CommandId::pragma_light : CommandId::glLightfv,
                        {static_cast<double>(name), static_cast<double>(pname)},
                        {kFile, 1, 0}};
        command.arguments.insert(command.arguments.end(), numbers.begin(), numbers.end());
        result.commands.insert(result.commands.begin(), std::move(command));
        return result;
    }
    for (Command& command : result.commands) {
        if (!gave(command, light, pname, typed)) continue;
        if (command.id == CommandId::glLightiv) command.id = CommandId::glLightfv;
        std::ranges::copy(numbers, command.arguments.begin() + 2);
    }
    return result;
}

// What is drawn at the lamp, such as a small cube, moves with it: the translations by just its position.
CommandList with_lamp_moved(CommandList commands, const glm::dvec4& from, const glm::dvec4& to) {
    if (from.w != 1 || glm::dvec3(from) == glm::dvec3(0)) return commands;
    for (Command& command : commands.commands) {
        if (command.id != CommandId::glTranslatef && command.id != CommandId::glTranslated) continue;
        bool is_there = true;
        for (int i = 0; i < 3; ++i)
            is_there = is_there && as_float(command.number(static_cast<std::size_t>(i))) == as_float(from[i]);
        if (!is_there) continue;
        for (int i = 0; i < 3; ++i) command.arguments[static_cast<std::size_t>(i)] = to[i];
    }
    return commands;
}

}  // namespace

glm::dvec3 place_of(const World& world, const Handle& handle) {
    const LightMarker& light = world.lights.at(handle.light);
    return handle.is_spot_direction ? light.place_world + arrow_length(world) * light.spot_dir_world
                                    : light.place_world;
}

std::optional<Handle> handle_at(const World& world, const WorldProjection& projection, const glm::dvec2& place,
                                double reach) {
    std::optional<Handle> nearest;
    double least = reach;
    for (std::size_t i = 0; i < world.lights.size(); ++i) {
        for (const bool is_spot_direction : {false, true}) {
            if (is_spot_direction && !world.lights[i].cutoff_deg) continue;
            const Handle handle{i, is_spot_direction};
            const auto at = projection.place_of(place_of(world, handle));
            if (!at || glm::distance(glm::dvec2(*at), place) >= least) continue;
            least = glm::distance(glm::dvec2(*at), place);
            nearest = handle;
        }
    }
    return nearest;
}

std::optional<std::size_t> command_of(const CommandList& commands, const Frame& frame, const World& world,
                                      const Handle& handle) {
    const LightMarker& light = world.lights.at(handle.light);
    if (light.typed >= frame.typed_lights.size()) return {};
    const TypedLight& typed = frame.typed_lights[light.typed];
    const auto gives = [&](const Command& command) {
        return handle.is_spot_direction ? gave(command, light.number, kGL_SPOT_DIRECTION, typed.spot_direction)
                                        : gave(command, light.number, kGL_POSITION, typed.position);
    };
    const auto found = std::ranges::find_if(commands.commands, gives);
    if (found == commands.commands.end()) return {};
    return static_cast<std::size_t>(found - commands.commands.begin());
}

CommandList with_handle_moved(const CommandList& commands, const Frame& frame, const World& world,
                              const WorldProjection& projection, const Handle& handle, const glm::dvec2& by_pixels) {
    const auto place = projection.place_of(place_of(world, handle));
    if (!place || by_pixels == glm::dvec2(0)) return commands;
    return with_handle_at(commands, frame, world, handle, projection.point_at(*place + glm::dvec3(by_pixels, 0)));
}

CommandList with_light_turned(const CommandList& commands, const Frame& frame, const World& world, std::size_t light,
                              double degrees) {
    const glm::dvec3 from_middle = world.lights.at(light).place_world - world.around.middle_world;
    const glm::dmat4 turn = glm::rotate(glm::dmat4(1), glm::radians(degrees), world.up_dir_world);
    return with_handle_at(commands, frame, world, {light, false},
                          world.around.middle_world + glm::dmat3(turn) * from_middle);
}

CommandList with_handle_at(const CommandList& commands, const Frame& frame, const World& world, const Handle& handle,
                           const glm::dvec3& moved_world) {
    const LightMarker& light = world.lights.at(handle.light);
    if (light.typed >= frame.typed_lights.size()) return commands;
    const TypedLight& typed = frame.typed_lights[light.typed];

    // A direction keeps the length that it was given.
    const auto direction = [&](const glm::dvec3& dir_world, const glm::dmat4& eye_from_typed,
                               const glm::dvec3& before) {
        const glm::dvec3 dir_eye = glm::dmat3(world.eye_from_world) * dir_world;
        const double length = glm::length(before);
        const glm::dvec3 after = length * unit(glm::inverse(glm::dmat3(eye_from_typed)) * dir_eye);
        return glm::dvec3(nice(after.x, length), nice(after.y, length), nice(after.z, length));
    };
    if (handle.is_spot_direction) {
        const auto& spot = typed.spot_direction;
        const glm::dvec3 value = direction(moved_world - light.place_world, spot.eye_from_typed, spot.value);
        return has_numbers(value) ? with_values(commands, light.number, kGL_SPOT_DIRECTION, spot, value) : commands;
    }
    const auto& position = typed.position;
    if (light.is_directional) {
        const glm::dvec3 value =
            direction(moved_world - world.around.middle_world, position.eye_from_typed, glm::dvec3(position.value));
        if (!has_numbers(value)) return commands;
        return with_values(commands, light.number, kGL_POSITION, position, glm::dvec4(value, 0));
    }
    const glm::dvec4 point = glm::inverse(position.eye_from_typed) * world.eye_from_world * glm::dvec4(moved_world, 1);
    const double w = position.value.w;
    const glm::dvec3 value = glm::dvec3(point) * (w / point.w);
    if (!has_numbers(value)) return commands;
    const double size = world.around.radius * std::abs(w);
    const glm::dvec4 moved(nice(value.x, size), nice(value.y, size), nice(value.z, size), w);
    return with_lamp_moved(with_values(commands, light.number, kGL_POSITION, position, moved), position.value, moved);
}

}  // namespace twinlight::session
