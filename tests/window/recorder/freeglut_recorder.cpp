// Records what the real freeglut sends for its shapes, without drawing anything.
//
// freeglut draws a shape through a handful of GL's functions (vertex arrays of floats, 16-bit indices). This
// program defines those functions itself; the dynamic linker finds them before libGL's, so freeglut's calls
// arrive here. freeglut needs a display for glutInit, but neither a window nor a context.
//
//   freeglut-recorder "glutSolidSphere 1 8 6" ...
//
// prints, for each argument, "call <argument>", and for each batch "draw <mode> <count>" and a line "x y z nx
// ny nz" a vertex, in the order they are sent.
#include <GL/freeglut.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <sstream>
#include <string>

namespace {

const float* positions = nullptr;
const float* normals = nullptr;

void print_vertex(std::size_t index) {
    const float* p = positions + 3 * index;
    const float* n = normals + 3 * index;
    std::printf("%.9g %.9g %.9g %.9g %.9g %.9g\n", static_cast<double>(p[0]), static_cast<double>(p[1]),
                static_cast<double>(p[2]), static_cast<double>(n[0]), static_cast<double>(n[1]),
                static_cast<double>(n[2]));
}

[[noreturn]] void give_up(const std::string& why) {
    std::fprintf(stderr, "freeglut-recorder: %s\n", why.c_str());
    std::exit(2);
}

const float* packed_floats(GLenum type, GLsizei stride, const void* pointer) {
    if (type != GL_FLOAT || stride != 0) give_up("freeglut sends another kind of array than packed floats");
    return static_cast<const float*>(pointer);
}

}  // namespace

extern "C" {

void GLAPIENTRY glEnableClientState(GLenum) {}
void GLAPIENTRY glDisableClientState(GLenum) {}

void GLAPIENTRY glVertexPointer(GLint size, GLenum type, GLsizei stride, const void* pointer) {
    if (size != 3) give_up("freeglut sends positions that have not three coordinates");
    positions = packed_floats(type, stride, pointer);
}

void GLAPIENTRY glNormalPointer(GLenum type, GLsizei stride, const void* pointer) {
    normals = packed_floats(type, stride, pointer);
}

void GLAPIENTRY glDrawArrays(GLenum mode, GLint first, GLsizei count) {
    std::printf("draw %u %d\n", mode, count);
    for (GLsizei i = 0; i < count; ++i) print_vertex(static_cast<std::size_t>(first) + static_cast<std::size_t>(i));
}

void GLAPIENTRY glDrawElements(GLenum mode, GLsizei count, GLenum type, const void* indices) {
    if (type != GL_UNSIGNED_SHORT) give_up("freeglut sends another kind of index than GL_UNSIGNED_SHORT");
    std::printf("draw %u %d\n", mode, count);
    for (GLsizei i = 0; i < count; ++i) print_vertex(static_cast<const std::uint16_t*>(indices)[i]);
}

}  // extern "C"

int main(int argc, char** argv) {
    glutInit(&argc, argv);

    double a = 0, b = 0;
    int m = 0, n = 0;
    std::istringstream words;
    const auto round_shape = [&](auto draw) {
        return [&, draw] {
            words >> a >> m >> n;
            draw(a, m, n);
        };
    };
    const auto tall_shape = [&](auto draw) {
        return [&, draw] {
            words >> a >> b >> m >> n;
            draw(a, b, m, n);
        };
    };
    const auto cube = [&](auto draw) {
        return [&, draw] {
            words >> a;
            draw(a);
        };
    };
    const std::map<std::string, std::function<void()>> shapes{
        {"glutSolidSphere", round_shape(glutSolidSphere)},
        {"glutWireSphere", round_shape(glutWireSphere)},
        {"glutSolidCube", cube(glutSolidCube)},
        {"glutWireCube", cube(glutWireCube)},
        {"glutSolidCone", tall_shape(glutSolidCone)},
        {"glutWireCone", tall_shape(glutWireCone)},
        {"glutSolidCylinder", tall_shape(glutSolidCylinder)},
        {"glutWireCylinder", tall_shape(glutWireCylinder)},
        {"glutSolidTorus", tall_shape(glutSolidTorus)},
        {"glutWireTorus", tall_shape(glutWireTorus)},
    };

    for (int i = 1; i < argc; ++i) {
        words = std::istringstream(argv[i]);
        std::string name;
        words >> name;
        const auto shape = shapes.find(name);
        if (shape == shapes.end()) give_up("no shape is called '" + name + "'");
        std::printf("call %s\n", argv[i]);
        shape->second();
        if (words.fail()) give_up(std::string("too few arguments: ") + argv[i]);
    }
    return 0;
}
