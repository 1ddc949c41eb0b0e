// Chooses the surfaces for a command.
#include "scene/shape/surface.h"

#include "scene/shape/quadric.h"

namespace twinlight {

namespace {

std::vector<Surface> frustum(double base, double top, double height, bool y_up) {
    return {{.equation = FrustumSurface{base, top, height}, .y_up = y_up}};
}

Surface cap(double radius, double z, bool faces_up, bool y_up) {
    return {.equation = DiskSurface{.inner = 0, .outer = radius, .z = z, .faces_up = faces_up}, .y_up = y_up};
}

std::vector<Surface> closed_cylinder(double radius, double height, bool y_up) {
    std::vector<Surface> surfaces = frustum(radius, radius, height, y_up);
    surfaces.push_back(cap(radius, 0, false, y_up));
    surfaces.push_back(cap(radius, height, true, y_up));
    return surfaces;
}

std::vector<Surface> closed_cone(double radius, double height, bool y_up) {
    std::vector<Surface> surfaces = frustum(radius, 0, height, y_up);
    surfaces.push_back(cap(radius, 0, false, y_up));
    return surfaces;
}

std::vector<Surface> of_pragma(const Command& command) {
    const auto number = [&](std::size_t i) { return command.number(i); };
    switch (command.word(0)) {
        case Word::cylinder: return closed_cylinder(number(1), number(2), true);
        case Word::cone: return closed_cone(number(1), number(2), true);
        case Word::sphere: return {{.equation = SphereSurface{number(1)}, .y_up = true}};
        default: return {};  // the cube is flat, and cylinder_triangles is about the normals of its mesh
    }
}

std::vector<Surface> of_freeglut(const Command& command) {
    const auto number = [&](std::size_t i) { return command.number(i); };
    switch (command.id) {
        case CommandId::glutSolidSphere: return {{.equation = SphereSurface{number(0)}}};
        case CommandId::glutSolidCone: return closed_cone(number(0), number(1), false);
        case CommandId::glutSolidCylinder: return closed_cylinder(number(0), number(1), false);
        case CommandId::glutSolidTorus: return {{.equation = TorusSurface{number(0), number(1)}}};
        default: return {};
    }
}

// A torus may intersect itself in the middle.
bool has_size(const Surface& surface) {
    if (const auto* sphere = std::get_if<SphereSurface>(&surface.equation)) return sphere->radius > 0;
    if (const auto* torus = std::get_if<TorusSurface>(&surface.equation)) return torus->tube > 0 && torus->ring > 0;
    if (const auto* disk = std::get_if<DiskSurface>(&surface.equation)) return disk->inner >= 0 && disk->outer > 0;
    const auto& frustum = std::get<FrustumSurface>(surface.equation);
    return frustum.base >= 0 && frustum.top >= 0 && frustum.base + frustum.top > 0 && frustum.height > 0;
}

std::vector<Surface> all_or_none(std::vector<Surface> surfaces) {
    if (!std::all_of(surfaces.begin(), surfaces.end(), has_size)) surfaces.clear();
    return surfaces;
}

}  // namespace

std::vector<Surface> shape_surfaces(const Command& command) {
    return all_or_none(command.id == CommandId::pragma_shape ? of_pragma(command) : of_freeglut(command));
}

std::vector<Surface> quadric_surfaces(const Quadric& quadric, const Command& command) {
    if (quadric.draw_style != kGLU_FILL || quadric.normals == kGLU_NONE) return {};
    const auto number = [&](std::size_t i) { return command.number(i); };
    Surface surface{.equation = SphereSurface{number(1)}};
    if (command.id == CommandId::gluCylinder) surface.equation = FrustumSurface{number(1), number(2), number(3)};
    if (command.id == CommandId::gluDisk || command.id == CommandId::gluPartialDisk) {
        DiskSurface disk{.inner = number(1), .outer = number(2), .z = 0, .faces_up = true};
        if (command.id == CommandId::gluPartialDisk) {
            disk.start_deg = number(5);
            disk.sweep_deg = number(6);
        }
        surface.equation = disk;
    }
    surface.inside = quadric.orientation == kGLU_INSIDE;
    surface.textured = quadric.texture;
    return all_or_none({surface});
}

}  // namespace twinlight
