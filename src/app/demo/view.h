// View: what the window changes about a scene, as pure functions from commands to commands. Neither GL nor GLUT here.
//
// The scene that is shown is an ordinary CommandList again, so both renderers, and the tests, draw the same thing.
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
    double yaw_deg = 0;              // about the camera's y axis: the front of the scene goes to the right
    double pitch_deg = 0;            // about its x axis: the front goes down
    double zoom = 1;                 // the pivot stands at 1/zoom of its distance
    glm::dvec3 pivot_eye{0, 0, -5};  // of a scene without gluLookAt: see middle_of()

    std::optional<Enum> shade_model;  // GL_FLAT or GL_SMOOTH for the whole scene; nothing: as the scene says
    std::array<bool, kMaxLights> light_inverted{};  // on where the scene says off, and off where it says on
    bool wireframe = false;

    friend bool operator==(const View&, const View&) = default;
};

// The matrix of the orbit: the turn about the pivot and the zoom toward it, in the camera's space.
glm::dmat4 orbit(const View& view, const glm::dvec3& pivot_eye);

// The scene as the view shows it. The plain View{} changes nothing.
//
// Orbiting does what moving the eye of the scene's gluLookAt would do: the orbit stands before every
// gluLookAt that starts from a matrix without it (several after glLoadIdentity, or in glPushMatrix ...
// glPopMatrix, each get it). What is set before gluLookAt is held by the camera (a headlight, a crosshair)
// and stays with it; what comes after, lights too, turns. Where only the projection has a gluLookAt, the
// orbit stands there. A scene without gluLookAt turns from the first glPushMatrix, transformation or drawing
// of a fresh modelview matrix.
CommandList apply_view(const CommandList& scene, const View& view);

// The middle of all that the frame draws, in eye space: the pivot of a scene without gluLookAt.
glm::dvec3 middle_of(const Frame& frame);

}  // namespace twinlight::demo
