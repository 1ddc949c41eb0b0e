// View: the changes that the window makes to a scene, as pure functions from commands to commands. Uses neither GL nor GLUT.
//
// The result is an ordinary CommandList, so both renderers and the tests draw the same scene.
#pragma once

#include <array>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "scene/command/command.h"
#include "scene/state/frame.h"

namespace twinlight::demo {

struct View {
    // The camera orbits the pivot: the centre of the scene's gluLookAt.
    double yaw_deg = 0;              // about the camera's y axis: the front of the scene moves to the right
    double pitch_deg = 0;            // about its x axis: the front moves down
    double zoom = 1;                 // the pivot is at 1/zoom of its distance
    glm::dvec3 pivot_eye{0, 0, -5};  // for a scene without gluLookAt: see middle_of()

    std::optional<Enum> shade_model;                // GL_FLAT or GL_SMOOTH for the whole scene; empty: the scene's own
    std::array<bool, kMaxLights> light_inverted{};  // on where the scene has it off, and off where it has it on
    bool wireframe = false;

    friend bool operator==(const View&, const View&) = default;
};

// The matrix of the orbit: the turn about the pivot and the zoom toward it, in the camera's space.
glm::dmat4 orbit(const View& view, const glm::dvec3& pivot_eye);

// The scene with the view's changes. The default View{} changes nothing.
//
// Orbiting has the same effect as moving the eye of the scene's gluLookAt: the orbit is inserted before every gluLookAt that
// starts from a matrix without it (so each of several after glLoadIdentity, or in glPushMatrix ... glPopMatrix, gets it).
// Objects and lights that are set before gluLookAt move with the camera (a headlight, a crosshair); those after it turn. If
// only the projection has a gluLookAt, the orbit goes there. In a scene without gluLookAt, the orbit goes before the first
// glPushMatrix, transformation or drawing command with a fresh modelview matrix.
CommandList apply_view(const CommandList& scene, const View& view);

// The middle of everything that the frame draws, in eye space: the pivot of a scene without gluLookAt.
glm::dvec3 middle_of(const Frame& frame);

}  // namespace twinlight::demo
