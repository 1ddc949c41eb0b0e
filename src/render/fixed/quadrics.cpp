#include "render/fixed/quadrics.h"

#include <stdexcept>
#include <string>

#include "render/context/gl.h"
#include "render/fixed/draw_parts.h"

namespace twinlight::fixed {

namespace {

// Whether GLU 9.0.2 sends uninitialised numbers (src/libutil/quad.c): normals for GLU_FLAT without facets, and at the
// second pole of a sphere with more stacks than slices, where it looks up the last stack among the slices.
bool sends_unwritten_memory(const Quadric& quadric, const Command& command) {
    const bool is_sphere = command.id == CommandId::gluSphere;
    if (!is_sphere && command.id != CommandId::gluCylinder) return false;
    if (quadric.normals == kGLU_FLAT) {
        return quadric.draw_style == kGLU_POINT || quadric.draw_style == kGLU_SILHOUETTE;
    }
    const bool has_fans = quadric.draw_style == kGLU_FILL && !quadric.texture;
    return is_sphere && has_fans && quadric.normals == kGLU_SMOOTH && command.number(3) > command.number(2);
}

}  // namespace

void Quadrics::Delete::operator()(GLUquadric* object) const { gluDeleteQuadric(object); }

void Quadrics::execute(const Command& command) {
    const double number = command.number(0);
    if (command.id == CommandId::gluNewQuadric) {
        entries_[number] = {std::unique_ptr<GLUquadric, Delete>(gluNewQuadric()), {}};
        return;
    }
    const auto found = entries_.find(number);
    if (found == entries_.end() || !found->second.object) return;
    if (command.id == CommandId::gluDeleteQuadric) {
        entries_.erase(found);
    } else if (draws_quadric(command)) {
        draw(found->second, command);
    } else {
        set(found->second, command);
    }
}

void Quadrics::set(Entry& entry, const Command& command) {
    twinlight::set(entry.quadric, command);
    GLUquadric* object = entry.object.get();
    const Enum value = command.enumerant(1);
    switch (command.id) {
        case CommandId::gluQuadricNormals: return gluQuadricNormals(object, value);
        case CommandId::gluQuadricTexture: return gluQuadricTexture(object, static_cast<GLboolean>(value));
        case CommandId::gluQuadricOrientation: return gluQuadricOrientation(object, value);
        case CommandId::gluQuadricDrawStyle: return gluQuadricDrawStyle(object, value);
        default: throw std::invalid_argument(std::string(command.name()) + " does not set a quadric");
    }
}

void Quadrics::draw(const Entry& entry, const Command& command) {
    if (sends_unwritten_memory(entry.quadric, command)) {
        return draw_immediately(quadric_parts(entry.quadric, command));
    }
    GLUquadric* object = entry.object.get();
    const auto number = [&](std::size_t i) { return command.number(i); };
    const auto count = [&](std::size_t i) { return static_cast<GLint>(command.number(i)); };
    switch (command.id) {
        case CommandId::gluSphere: return gluSphere(object, number(1), count(2), count(3));
        case CommandId::gluCylinder: return gluCylinder(object, number(1), number(2), number(3), count(4), count(5));
        case CommandId::gluDisk: return gluDisk(object, number(1), number(2), count(3), count(4));
        case CommandId::gluPartialDisk:
            return gluPartialDisk(object, number(1), number(2), count(3), count(4), number(5), number(6));
        default: throw std::invalid_argument(std::string(command.name()) + " does not draw a quadric");
    }
}

}  // namespace twinlight::fixed
