#include "app/session/world.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <utility>

#include "base/math/directions.h"
#include "scene/state/state.h"

namespace twinlight::session {
namespace {

constexpr double kFieldOfViewDeg = 40;
constexpr double kTurnDegPerPixel = 0.4;
constexpr double kOutsideZoomPerStep = 1.1, kMostOutsideZoom = 20;
constexpr double kFarLight = 3;            // a light farther away than so many radii does not enlarge the view
constexpr double kArrowShare = 0.22;       // of the radius
constexpr double kDirectionalShare = 0.8;  // of the radius: how far from the middle a directional light's marker is
constexpr double kWidestRimDeg = 80;
constexpr int kRimPoints = 32;
constexpr glm::dvec4 kOutsideBackground{0.13, 0.14, 0.17, 1};
constexpr glm::vec4 kFrustum{0.94F, 0.7F, 0.28F, 1};
constexpr glm::vec4 kAxes[] = {{0.9F, 0.3F, 0.3F, 1}, {0.4F, 0.8F, 0.4F, 1}, {0.35F, 0.55F, 1, 1}};

glm::dmat4 inverse_or_1(const glm::dmat4& matrix) {
    const glm::dmat4 result = glm::inverse(matrix);
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!std::isfinite(result[column][row])) return glm::dmat4(1);
    return result;
}

// The modelview matrix after the scene's first gluLookAt, and its up vector.
void find_camera(const CommandList& commands, const Frame& frame, World& world) {
    StateOptions options;
    options.width = frame.width;
    options.height = frame.height;
    State state(options);
    Enum mode = kGL_MODELVIEW;
    for (const Command& command : commands.commands) {
        state.apply(command);
        if (command.id == CommandId::glMatrixMode) mode = command.enumerant(0);
        if (command.id != CommandId::gluLookAt) continue;
        const glm::dvec3 up(command.number(6), command.number(7), command.number(8));
        if (glm::length(up) > 0 && has_numbers(up)) world.up_dir_world = unit(up);
        if (mode != kGL_MODELVIEW) continue;  // then world coordinates are eye coordinates
        if (glm::determinant(state.modelview()) != 0) world.eye_from_world = state.modelview();
        return;
    }
}

// Of all projections of the frame, the one with the most vertices.
glm::dmat4 main_projection(const Frame& frame) {
    std::vector<std::pair<glm::dmat4, std::size_t>> counts;
    for (const Draw* draw : frame.draws()) {
        const auto same = [draw](const auto& count) { return count.first == draw->clip_from_eye; };
        const auto found = std::ranges::find_if(counts, same);
        if (found == counts.end())
            counts.emplace_back(draw->clip_from_eye, draw->count());
        else
            found->second += draw->count();
    }
    if (counts.empty()) return glm::dmat4(1);
    return std::ranges::max_element(counts, {}, [](const auto& count) { return count.second; })->first;
}

struct Box3 {
    glm::dvec3 least{std::numeric_limits<double>::infinity()}, most{-std::numeric_limits<double>::infinity()};

    void add(const glm::dvec3& point) {
        if (!has_numbers(point)) return;
        least = glm::min(least, point);
        most = glm::max(most, point);
    }
    bool is_empty() const { return !(least.x <= most.x); }
    glm::dvec3 middle() const { return is_empty() ? glm::dvec3(0) : (least + most) / 2.0; }
    double radius() const { return is_empty() || least == most ? 1 : glm::length(most - least) / 2; }
};

Surroundings surroundings_of(const World& world, Box3 box, const Frame& frame) {
    const glm::dmat4 world_from_eye = inverse_or_1(world.eye_from_world);
    const double near = kFarLight * box.radius();
    const glm::dvec3 middle = box.middle();
    const auto add_near = [&](const glm::dvec3& point) {
        if (glm::distance(point, middle) <= near) box.add(point);
    };
    if (world.camera_world) add_near(*world.camera_world);
    for (const Draw* draw : frame.draws()) {
        for (const LightSource& light : draw->lighting.lights)
            if (draw->lighting.enabled && light.enabled && !light.is_directional())
                add_near(glm::dvec3(world_from_eye * light.position_eye) / light.position_eye.w);
    }
    Surroundings around{box.middle(), box.radius(), {}};
    // The camera looks along -z in eye coordinates.
    glm::dvec3 front = world.camera_world ? *world.camera_world - middle : glm::dvec3(world_from_eye[2]);
    front -= glm::dot(front, world.up_dir_world) * world.up_dir_world;
    if (!(glm::length(front) > 1e-9 * around.radius))
        front = glm::cross(world.up_dir_world,
                           std::abs(world.up_dir_world.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1));
    around.front_dir_world = unit(front);
    return around;
}

std::optional<LightMarker> marker_of(const LightSource& light, int number, const World& world) {
    const glm::dmat4 world_from_eye = inverse_or_1(world.eye_from_world);
    LightMarker marker;
    marker.number = number;
    marker.typed = light.typed;
    marker.is_directional = light.is_directional();
    const glm::dvec4 position_world = world_from_eye * light.position_eye;
    if (marker.is_directional) {
        const glm::dvec3 dir = unit(glm::dvec3(position_world));
        if (!(glm::length(dir) > 0)) return {};
        marker.place_world = world.around.middle_world + kDirectionalShare * world.around.radius * dir;
    } else {
        marker.place_world = glm::dvec3(position_world) / position_world.w;
        const glm::dvec3 spot_dir = unit(glm::dmat3(world_from_eye) * light.spot_direction_eye);
        if (light.has_cutoff() && glm::length(spot_dir) > 0) {
            marker.cutoff_deg = light.spot_cutoff_deg;
            marker.spot_dir_world = spot_dir;
        }
    }
    if (!has_numbers(marker.place_world)) return {};
    const auto largest = [](const glm::dvec4& c) { return std::max({c.r, c.g, c.b}); };
    const glm::dvec4& color =
        std::max({light.diffuse, light.specular, light.ambient},
                 [&](const glm::dvec4& a, const glm::dvec4& b) { return largest(a) < largest(b); });
    marker.is_black = !(largest(color) > 0);
    marker.color = marker.is_black ? glm::dvec3(0.5) : glm::max(glm::dvec3(color) / largest(color), 0.0);
    return marker;
}

}  // namespace

bool has_numbers(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

World world_of(const CommandList& commands, const Frame& frame, const std::optional<Surroundings>& around) {
    World world;
    find_camera(commands, frame, world);
    world.clip_from_eye = main_projection(frame);
    const glm::dmat4 world_from_eye = inverse_or_1(world.eye_from_world);

    // The eye of a perspective projection is where x, y and w of clip coordinates are 0.
    if (glm::determinant(world.clip_from_eye) != 0) {
        const glm::dvec4 apex = world_from_eye * inverse_or_1(world.clip_from_eye) * glm::dvec4(0, 0, 1, 0);
        const glm::dvec3 point = glm::dvec3(apex) / apex.w;
        if (std::abs(apex.w) > 1e-9 * glm::length(glm::dvec3(apex)) && has_numbers(point)) world.camera_world = point;
    }

    Box3 box;
    double deepest = -1;
    for (const Draw* draw : frame.draws()) {
        if (draw->clip_from_eye != world.clip_from_eye) continue;
        const glm::dmat4 world_from_object = world_from_eye * draw->eye_from_object;
        const glm::dmat4 clip_from_object = draw->clip_from_eye * draw->eye_from_object;
        for (const Vertex& vertex : draw->vertices) {
            const glm::dvec4 position_world = world_from_object * vertex.position_object;
            box.add(glm::dvec3(position_world) / position_world.w);
            const glm::dvec4 clip = clip_from_object * vertex.position_object;
            if (clip.w > 0 && std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w)
                deepest = std::max(deepest, clip.z / clip.w);
        }
    }
    world.frustum_depth = deepest > -1 ? std::min(deepest, 1.0) : 1;
    world.around = around ? *around : surroundings_of(world, box, frame);

    for (const Draw* draw : frame.draws()) {
        if (!draw->lighting.enabled) continue;
        for (std::size_t i = 0; i < draw->lighting.lights.size(); ++i) {
            const LightSource& light = draw->lighting.lights[i];
            if (!light.enabled) continue;
            const auto known = [&](const LightMarker& marker) {
                return marker.number == static_cast<int>(i) && marker.typed == light.typed;
            };
            if (std::ranges::any_of(world.lights, known)) continue;
            if (const auto marker = marker_of(light, static_cast<int>(i), world)) world.lights.push_back(*marker);
        }
    }
    std::ranges::stable_sort(world.lights, {}, [](const LightMarker& l) { return std::pair(l.is_black, l.number); });
    return world;
}

OutsideCamera first_camera(const World& world) {
    const glm::dvec3 side_dir = glm::cross(world.up_dir_world, world.around.front_dir_world);
    double side = 0;
    for (const LightMarker& light : world.lights)
        if (!light.is_black) side += glm::dot(light.place_world - world.around.middle_world, side_dir);
    OutsideCamera camera;
    if (side < 0) camera.yaw_deg = -camera.yaw_deg;
    return camera;
}

void orbit(OutsideCamera& camera, double dx_pixels, double dy_pixels) {
    camera.yaw_deg = std::remainder(camera.yaw_deg - kTurnDegPerPixel * dx_pixels, 360.0);
    camera.pitch_deg = std::clamp(camera.pitch_deg + kTurnDegPerPixel * dy_pixels, 0.0, 89.0);
}

void zoom(OutsideCamera& camera, double steps) {
    camera.zoom =
        std::clamp(camera.zoom * std::pow(kOutsideZoomPerStep, steps), 1 / kMostOutsideZoom, kMostOutsideZoom);
}

std::optional<glm::dvec3> WorldProjection::place_of(const glm::dvec3& point_world) const {
    const glm::dvec4 clip = clip_from_world * glm::dvec4(point_world, 1);
    if (!(clip.w > 0)) return {};
    const glm::dvec3 ndc = glm::dvec3(clip) / clip.w;
    return glm::dvec3((ndc.x + 1) / 2 * width, (1 - ndc.y) / 2 * height, (ndc.z + 1) / 2);
}

glm::dvec3 WorldProjection::point_at(const glm::dvec3& place) const {
    const glm::dvec4 ndc(2 * place.x / width - 1, 1 - 2 * place.y / height, 2 * place.z - 1, 1);
    const glm::dvec4 point = inverse_or_1(clip_from_world) * ndc;
    return glm::dvec3(point) / point.w;
}

WorldProjection projection_of(const World& world, const OutsideCamera& camera, int width, int height) {
    const Surroundings& around = world.around;
    const double aspect = static_cast<double>(width) / height;
    // The sphere fits into the narrower side of the picture.
    const double half = glm::radians(kFieldOfViewDeg / 2);
    const double half_narrow = aspect < 1 ? std::atan(aspect * std::tan(half)) : half;
    const double distance = around.radius / std::sin(half_narrow) / camera.zoom;
    const double yaw = glm::radians(camera.yaw_deg), pitch = glm::radians(camera.pitch_deg);
    const glm::dvec3 level_dir =
        std::cos(yaw) * around.front_dir_world + std::sin(yaw) * glm::cross(world.up_dir_world, around.front_dir_world);
    const glm::dvec3 eye =
        around.middle_world + distance * (std::cos(pitch) * level_dir + std::sin(pitch) * world.up_dir_world);
    const glm::dmat4 clip_from_outside =
        glm::perspective(2 * half, aspect, 0.02 * distance, distance + 4 * around.radius);
    return {width, height, clip_from_outside * glm::lookAt(eye, around.middle_world, world.up_dir_world)};
}

Frame as_seen_from_outside(const Frame& frame, const World& world, const WorldProjection& projection) {
    Frame seen;
    seen.width = projection.width;
    seen.height = projection.height;
    Clear clear;
    clear.color = clear.depth = true;
    clear.clear_color = kOutsideBackground;
    seen.items.emplace_back(clear);
    for (const Draw* draw : frame.draws()) {
        if (draw->clip_from_eye != world.clip_from_eye) continue;
        Draw outside = *draw;
        outside.clip_from_eye = projection.clip_from_world * inverse_or_1(world.eye_from_world);
        outside.raster.viewport = {0, 0, projection.width, projection.height};
        outside.raster.depth_near = 0;
        outside.raster.depth_far = 1;
        outside.fragment.scissor.enabled = false;
        outside.fragment.stencil.reset();
        seen.items.emplace_back(std::move(outside));
    }
    seen.typed_lights = frame.typed_lights;
    return seen;
}

double arrow_length(const World& world) { return kArrowShare * world.around.radius; }

glm::dvec3 arrow_tip(const World& world, const LightMarker& light) {
    const glm::dvec3 toward = world.around.middle_world - light.place_world;
    return light.place_world + 1.4 * arrow_length(world) / glm::length(toward) * toward;
}

std::vector<OverlayVertex> world_lines(const World& world, const WorldProjection& projection) {
    std::vector<OverlayVertex> lines;
    const auto line = [&](const glm::dvec4& a_world, const glm::dvec4& b_world, const glm::vec4& color) {
        lines.push_back({glm::vec4(projection.clip_from_world * a_world), color});
        lines.push_back({glm::vec4(projection.clip_from_world * b_world), color});
    };
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec4 tip(0, 0, 0, 1);
        tip[axis] = arrow_length(world);
        line({0, 0, 0, 1}, tip, kAxes[axis]);
    }
    if (glm::determinant(world.clip_from_eye) == 0) return lines;
    const glm::dmat4 world_from_clip = inverse_or_1(world.eye_from_world) * inverse_or_1(world.clip_from_eye);
    const auto corner = [&](int i, double depth) {
        constexpr std::pair<int, int> kAround[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
        const auto [x, y] = kAround[i % 4];
        const glm::dvec4 point = world_from_clip * glm::dvec4(x, y, depth, 1);
        return point / point.w;
    };
    for (int i = 0; i < 4; ++i) {
        line(corner(i, -1), corner(i + 1, -1), kFrustum);
        line(corner(i, world.frustum_depth), corner(i + 1, world.frustum_depth), kFrustum);
        line(world.camera_world ? glm::dvec4(*world.camera_world, 1) : corner(i, -1), corner(i, world.frustum_depth),
             kFrustum);
    }
    return lines;
}

std::vector<glm::dvec3> cone_rim(const LightMarker& light, double length) {
    const double angle = glm::radians(std::min(light.cutoff_deg.value_or(0), kWidestRimDeg));
    const glm::dvec3& axis = light.spot_dir_world;
    const glm::dvec3 side = unit(glm::cross(axis, std::abs(axis.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0)));
    const glm::dvec3 other = glm::cross(axis, side);
    std::vector<glm::dvec3> rim;
    for (int i = 0; i < kRimPoints; ++i) {
        const double turn = glm::radians(360.0 * i / kRimPoints);
        rim.push_back(
            light.place_world +
            length * (std::cos(angle) * axis + std::sin(angle) * (std::cos(turn) * side + std::sin(turn) * other)));
    }
    return rim;
}

}  // namespace twinlight::session
