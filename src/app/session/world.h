// The world view: the scene from outside, with its camera and lights. Pure data; nothing here draws.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/session/overlays.h"
#include "scene/command/command.h"
#include "scene/frame/frame.h"

namespace twinlight::session {

// A light that is on in a lit Draw. One that is set differently for several Draws has a marker for each setting.
struct LightMarker {
    int number = 0;           // of GL_LIGHTi
    std::uint32_t typed = 0;  // index into Frame::typed_lights
    bool is_directional = false;
    // A directional light's marker is where its arrow starts, 0.8 radii of the surroundings from the middle.
    glm::dvec3 place_world{0};
    std::optional<double> cutoff_deg{};  // of a spotlight
    glm::dvec3 spot_dir_world{0, 0, -1};
    glm::dvec3 color{1};    // the brightest of its colours, scaled so that the largest channel is 1
    bool is_black = false;  // all its colours are 0

    friend bool operator==(const LightMarker&, const LightMarker&) = default;
};

// What the world view shows: a sphere around what is drawn, the camera and the point lights near them.
struct Surroundings {
    glm::dvec3 middle_world{0};
    double radius = 1;
    glm::dvec3 front_dir_world{0, 0, 1};  // level, from the middle to the camera
};

// World coordinates are those of the scene's first gluLookAt; without one, eye coordinates.
struct World {
    glm::dmat4 eye_from_world{1};
    glm::dmat4 clip_from_eye{1};  // the projection that most vertices have; Draws with another one are left out
    glm::dvec3 up_dir_world{0, 1, 0};
    std::optional<glm::dvec3> camera_world{};  // empty for a parallel projection
    double frustum_depth = 1;                  // in normalised device coordinates: the deepest visible vertex
    Surroundings around{};
    std::vector<LightMarker> lights{};  // black ones last, each by its number
};
// `around`: those to keep, so that the view stands still while things move.
World world_of(const CommandList& commands, const Frame& frame, const std::optional<Surroundings>& around = {});

// The camera of the world view: it orbits the middle, not below it.
struct OutsideCamera {
    double yaw_deg = 40, pitch_deg = 25;
    double zoom = 1.2;  // 1 shows the whole sphere around the surroundings

    friend bool operator==(const OutsideCamera&, const OutsideCamera&) = default;
};
// The one to start with: from the side of the camera where the lights are, so that it sees lit surfaces.
OutsideCamera first_camera(const World& world);
void orbit(OutsideCamera& camera, double dx_pixels, double dy_pixels);
void zoom(OutsideCamera& camera, double steps);  // of the wheel; positive is nearer

// How the world is projected on a picture of this size.
struct WorldProjection {
    int width = 0, height = 0;
    glm::dmat4 clip_from_world{1};

    // In pixels from the top left, with the depth from 0 to 1; empty for a point behind the eye.
    std::optional<glm::dvec3> place_of(const glm::dvec3& point_world) const;
    // The opposite.
    glm::dvec3 point_at(const glm::dvec3& place) const;
};
WorldProjection projection_of(const World& world, const OutsideCamera& camera, int width, int height);

// The frame from outside. Only positions on the picture change: lighting stays that of the scene's own camera.
Frame as_seen_from_outside(const Frame& frame, const World& world, const WorldProjection& projection);

// The camera's frustum and the world's axes, as lines in clip coordinates. The frustum ends at the deepest point that is drawn.
std::vector<OverlayVertex> world_lines(const World& world, const WorldProjection& projection);

// The outline of a light's cone: the points of its rim, as far from the light as `length`. Cones of 90 degrees or more get a
// rim at 80 degrees.
std::vector<glm::dvec3> cone_rim(const LightMarker& light, double length);
// How long arrows and cones are drawn.
double arrow_length(const World& world);
// Where the arrow of a directional light ends: toward the middle, as its light goes.
glm::dvec3 arrow_tip(const World& world, const LightMarker& light);

// What can be dragged: a light's marker, or the tip of a spotlight's cone.
struct Handle {
    std::size_t light = 0;  // index into World::lights
    bool is_spot_direction = false;

    friend bool operator==(const Handle&, const Handle&) = default;
};
glm::dvec3 place_of(const World& world, const Handle& handle);  // in world coordinates
// The nearest handle within `reach` pixels of this place; of several at one place the first.
std::optional<Handle> handle_at(const World& world, const WorldProjection& projection, const glm::dvec2& place,
                                double reach = 12);

// The index of the call that set the handle's place; empty if none did.
std::optional<std::size_t> command_of(const CommandList& commands, const Frame& frame, const World& world,
                                      const Handle& handle);

// The commands with a handle moved to this place. The glLight call that set the value changes; a light whose value was never
// set gets a call at the start. Values are rounded to three digits of the world's radius.
CommandList with_handle_at(const CommandList& commands, const Frame& frame, const World& world, const Handle& handle,
                           const glm::dvec3& place_world);
// With a handle moved by so many pixels, in the plane of the picture through it.
CommandList with_handle_moved(const CommandList& commands, const Frame& frame, const World& world,
                              const WorldProjection& projection, const Handle& handle, const glm::dvec2& by_pixels);

// With a light (an index into World::lights) turned around the middle of the surroundings, about the up direction.
CommandList with_light_turned(const CommandList& commands, const Frame& frame, const World& world, std::size_t light,
                              double degrees);

// Whether all three are finite.
bool has_numbers(const glm::dvec3& v);

}  // namespace twinlight::session
