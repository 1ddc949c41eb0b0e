// A quadric of GLU: the settings for gluSphere, gluCylinder, gluDisk and gluPartialDisk.
#pragma once

#include <string>
#include <vector>

#include "scene/shape/shape.h"
#include "scene/shape/surface.h"

namespace twinlight {

// The initial values are GLU's (GLU 1.3, chapter 6).
struct Quadric {
    Enum normals = kGLU_SMOOTH;
    bool texture = false;
    Enum orientation = kGLU_OUTSIDE;
    Enum draw_style = kGLU_FILL;
};

// Executes gluQuadricNormals, gluQuadricTexture, ... Returns false and changes nothing if GLU raises GLU_INVALID_ENUM.
bool set(Quadric& quadric, const Command& command);
// The allowed values of the command, for messages: "GLU_SMOOTH, GLU_FLAT, GLU_NONE".
std::string choices(CommandId id);

// Whether a command is gluSphere, gluCylinder, gluDisk or gluPartialDisk; and the parts that it sends.
bool draws_quadric(const Command& command);
std::vector<ShapePart> quadric_parts(const Quadric& quadric, const Command& command);
// The curved surface that the command draws; none if it is not filled or has no normals. Normals are those of the
// surface itself; GLU's normals of a cone with GLU_INSIDE lean the wrong way.
std::vector<Surface> quadric_surfaces(const Quadric& quadric, const Command& command);

}  // namespace twinlight
