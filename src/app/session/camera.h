// The camera: moves of the mouse and the keys as edits of the scene's gluLookAt calls.
#pragma once

#include <glm/vec3.hpp>

#include "scene/command/command.h"
#include "scene/frame/frame.h"

namespace twinlight::session {

// Moves are carried out in this order: around the centre of gluLookAt, along the floor, about the eye. The camera's up vector
// stays as it is, so the horizon stays level.
struct CameraMove {
    // Around the centre, as if the scene stood on a turntable.
    double yaw_deg = 0;    // positive: the front of the scene moves to the right
    double pitch_deg = 0;  // positive: the front moves down, and the camera up
    double zoom = 1;       // the centre is then at 1/zoom of its distance
    // Walking moves eye and centre. The unit is the distance from the eye to the centre.
    double forward = 0, right = 0;  // level, at right angles to the up vector
    double up = 0;
    // Looking moves the centre around the eye.
    double look_yaw_deg = 0;    // positive: to the right
    double look_pitch_deg = 0;  // positive: up

    bool may_go_under = false;  // the plane through the centre, where the floor often is; see with_camera_moved()

    friend bool operator==(const CameraMove&, const CameraMove&) = default;
};

// The commands with the camera moved.
//
// Every gluLookAt that starts from a matrix without a camera gets new arguments (so each of several after glLoadIdentity,
// or in glPushMatrix ... glPopMatrix, moves). Objects and lights that are set before gluLookAt move with the camera (a
// headlight, a crosshair). If only the projection has a gluLookAt, that one moves. In a scene without gluLookAt, one with the
// centre `pivot_eye` is inserted, before the first glPushMatrix, transformation or drawing command of each fresh modelview matrix.
//
// The elevation above the centre stays from -89 to 89 degrees, and a camera above the plane through the centre stays above it
// unless the move may go under. Arguments that change are rounded to six digits of the camera's distance.
// A gluLookAt whose eye is its centre, or whose up vector is 0, stays as it is.
CommandList with_camera_moved(const CommandList& commands, const CameraMove& move, const glm::dvec3& pivot_eye);

// The commands of another step of the scene, seen by the camera of `now`: each gluLookAt that differs from that of `opened`,
// which is the step that `now` was made from.
CommandList with_camera_of(const CommandList& commands, const CommandList& opened, const CommandList& now);

// The middle of everything that the frame draws, in eye space: the pivot of a scene without gluLookAt.
glm::dvec3 middle_of(const Frame& frame);

}  // namespace twinlight::session
