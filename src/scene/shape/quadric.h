// A quadric of GLU: how gluSphere and its kin are sent.
#pragma once

#include <string>
#include <vector>

#include "scene/shape/shape.h"
#include "scene/shape/surface.h"

namespace twinlight {

// With GLU's initial values (GLU 1.3, chapter 6).
struct Quadric {
    Enum normals = kGLU_SMOOTH;
    bool texture = false;
    Enum orientation = kGLU_OUTSIDE;
    Enum draw_style = kGLU_FILL;
};

// Carries gluQuadricNormals and its kin out; false, and no change, for a value that GLU refuses with GLU_INVALID_ENUM.
bool set(Quadric& quadric, const Command& command);
// What the command may be given: "GLU_SMOOTH, GLU_FLAT, GLU_NONE".
std::string choices(CommandId id);

// Whether a command is gluSphere, gluCylinder, gluDisk or gluPartialDisk; what it sends.
bool draws_quadric(const Command& command);
std::vector<ShapePart> quadric_parts(const Quadric& quadric, const Command& command);
// The surface that it stands for; nothing where it is not filled or has no normals. Its normals are the surface's own: turned
// inside, GLU's of a cone lean the wrong way.
std::vector<Surface> quadric_surfaces(const Quadric& quadric, const Command& command);

}  // namespace twinlight
