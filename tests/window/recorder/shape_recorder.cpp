// Records what the real freeglut and GLU send for their shapes, without drawing anything.
//
// freeglut draws a shape through a handful of GL's functions (vertex arrays of floats, 16-bit indices), GLU between
// glBegin and glEnd. This program defines those functions itself; the dynamic linker finds them before libGL's, so the
// libraries' calls arrive here. freeglut needs a display for glutInit, but neither a window nor a context; GLU needs nothing.
//
//   shape-recorder "glutSolidSphere 1 8 6" "gluSphere GLU_FLAT GLU_OUTSIDE GLU_FILL 1 1 8 6" ...
//
// (a quadric's normals, orientation, draw style and whether it has texture coordinates stand before its arguments)
// prints, for each argument, "call <argument>", for each batch "draw arrays|immediate <mode> <count>" and a line a vertex, in
// the order they are sent: "x y z nx ny nz s t". A normal or texture coordinate that the shape has not sent is of "-".
// "error <code>": GLU called the error callback.
#include <GL/freeglut.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

namespace {

[[noreturn]] void give_up(const std::string& why) {
    std::fprintf(stderr, "shape-recorder: %s\n", why.c_str());
    std::exit(2);
}

template <std::size_t n>
using Floats = std::array<float, n>;

template <std::size_t n>
void print(const std::optional<Floats<n>>& values) {
    for (std::size_t i = 0; i < n; ++i) {
        if (values) {
            std::printf("%.9g ", static_cast<double>((*values)[i]));
        } else {
            std::printf("- ");
        }
    }
}

struct Vertex {
    std::optional<Floats<3>> position, normal;
    std::optional<Floats<2>> tex_coord;
};

void print(const char* how, GLenum mode, const std::vector<Vertex>& vertices) {
    std::printf("draw %s %u %zu\n", how, mode, vertices.size());
    for (const Vertex& vertex : vertices) {
        print(vertex.position);
        print(vertex.normal);
        print(vertex.tex_coord);
        std::printf("\n");
    }
}

// ---- Vertex arrays ----

template <std::size_t n>
struct Array {
    const char* name;
    bool enabled = false;
    const float* values = nullptr;

    void set(GLint size, GLenum type, GLsizei stride, const void* pointer) {
        if (size != n || type != GL_FLOAT || stride != 0) {
            give_up(std::string(name) + ": freeglut sends another kind of array than packed floats");
        }
        values = static_cast<const float*>(pointer);
    }
    std::optional<Floats<n>> at(std::size_t index) const {
        if (!enabled) return std::nullopt;
        Floats<n> result;
        for (std::size_t i = 0; i < n; ++i) result[i] = values[n * index + i];
        return result;
    }
};

Array<3> positions{"glVertexPointer"}, normals{"glNormalPointer"};
Array<2> tex_coords{"glTexCoordPointer"};

void enable(GLenum array, bool enabled) {
    switch (array) {
        case GL_VERTEX_ARRAY: positions.enabled = enabled; break;
        case GL_NORMAL_ARRAY: normals.enabled = enabled; break;
        case GL_TEXTURE_COORD_ARRAY: tex_coords.enabled = enabled; break;
        default: give_up("freeglut sends another array than positions, normals and texture coordinates");
    }
}

Vertex array_vertex(std::size_t index) { return {positions.at(index), normals.at(index), tex_coords.at(index)}; }

// ---- Between glBegin and glEnd ----

Vertex current;  // the position is not used
GLenum open_mode = 0;
std::vector<Vertex> open_vertices;

}  // namespace

extern "C" {

void GLAPIENTRY glEnableClientState(GLenum array) { enable(array, true); }
void GLAPIENTRY glDisableClientState(GLenum array) { enable(array, false); }

void GLAPIENTRY glVertexPointer(GLint size, GLenum type, GLsizei stride, const void* pointer) {
    positions.set(size, type, stride, pointer);
}
void GLAPIENTRY glNormalPointer(GLenum type, GLsizei stride, const void* pointer) {
    normals.set(3, type, stride, pointer);
}
void GLAPIENTRY glTexCoordPointer(GLint size, GLenum type, GLsizei stride, const void* pointer) {
    tex_coords.set(size, type, stride, pointer);
}

void GLAPIENTRY glDrawArrays(GLenum mode, GLint first, GLsizei count) {
    std::vector<Vertex> vertices;
    for (GLsizei i = 0; i < count; ++i) vertices.push_back(array_vertex(static_cast<std::size_t>(first + i)));
    print("arrays", mode, vertices);
}

void GLAPIENTRY glDrawElements(GLenum mode, GLsizei count, GLenum type, const void* indices) {
    if (type != GL_UNSIGNED_SHORT) give_up("freeglut sends another kind of index than GL_UNSIGNED_SHORT");
    std::vector<Vertex> vertices;
    for (GLsizei i = 0; i < count; ++i) vertices.push_back(array_vertex(static_cast<const std::uint16_t*>(indices)[i]));
    print("arrays", mode, vertices);
}

void GLAPIENTRY glBegin(GLenum mode) {
    open_mode = mode;
    open_vertices.clear();
}
void GLAPIENTRY glEnd() { print("immediate", open_mode, open_vertices); }
void GLAPIENTRY glNormal3f(GLfloat x, GLfloat y, GLfloat z) { current.normal = {x, y, z}; }
void GLAPIENTRY glTexCoord2f(GLfloat s, GLfloat t) { current.tex_coord = {s, t}; }
void GLAPIENTRY glVertex3f(GLfloat x, GLfloat y, GLfloat z) {
    open_vertices.push_back({Floats<3>{x, y, z}, current.normal, current.tex_coord});
}

}  // extern "C"

namespace {

// ---- The calls ----

std::istringstream words;  // the arguments of the call being recorded

template <class T>
T next() {
    T value{};
    words >> value;
    if (words.fail()) give_up("too few arguments: " + words.str());
    return value;
}

GLenum next_name() {
    static const std::map<std::string, GLenum> names{
        {"GLU_SMOOTH", GLU_SMOOTH}, {"GLU_FLAT", GLU_FLAT},       {"GLU_NONE", GLU_NONE},
        {"GLU_POINT", GLU_POINT},   {"GLU_LINE", GLU_LINE},       {"GLU_FILL", GLU_FILL},
        {"GLU_INSIDE", GLU_INSIDE}, {"GLU_OUTSIDE", GLU_OUTSIDE}, {"GLU_SILHOUETTE", GLU_SILHOUETTE},
    };
    const auto found = names.find(next<std::string>());
    if (found == names.end()) give_up("not a GLU name: " + words.str());
    return found->second;
}

void GLAPIENTRY print_error(GLenum code) { std::printf("error %u\n", code); }

struct DeleteQuadric {
    void operator()(GLUquadric* quadric) const { gluDeleteQuadric(quadric); }
};
using Quadric = std::unique_ptr<GLUquadric, DeleteQuadric>;

Quadric next_quadric() {
    Quadric quadric(gluNewQuadric());
    gluQuadricCallback(quadric.get(), GLU_ERROR, reinterpret_cast<_GLUfuncptr>(print_error));
    gluQuadricNormals(quadric.get(), next_name());
    gluQuadricOrientation(quadric.get(), next_name());
    gluQuadricDrawStyle(quadric.get(), next_name());
    gluQuadricTexture(quadric.get(), static_cast<GLboolean>(next<int>()));
    return quadric;
}

// Reads the words in the order of the function's parameters, then calls it.
template <class... Parameters>
std::function<void()> call(void (*function)(Parameters...)) {
    return [function] {
        const std::tuple<Parameters...> arguments{next<Parameters>()...};  // braces: from left to right
        std::apply(function, arguments);
    };
}

template <class... Parameters>
std::function<void()> call(void (*function)(GLUquadric*, Parameters...)) {
    return [function] {
        const Quadric quadric = next_quadric();
        const std::tuple<Parameters...> arguments{next<Parameters>()...};
        std::apply([&](Parameters... values) { function(quadric.get(), values...); }, arguments);
    };
}

std::function<void()> call(void (*function)(int, double*, double)) {
    return [function] {
        const int levels = next<int>();
        double offset[3] = {next<double>(), next<double>(), next<double>()};
        function(levels, offset, next<double>());
    };
}

const std::map<std::string, std::function<void()>>& shapes() {
#define SOLID_AND_WIRE(name) \
    {"glutSolid" #name, call(glutSolid##name)}, { "glutWire" #name, call(glutWire##name) }
    static const std::map<std::string, std::function<void()>> table{
        SOLID_AND_WIRE(Sphere),
        SOLID_AND_WIRE(Cone),
        SOLID_AND_WIRE(Cylinder),
        SOLID_AND_WIRE(Torus),
        SOLID_AND_WIRE(Cube),
        SOLID_AND_WIRE(Tetrahedron),
        SOLID_AND_WIRE(Octahedron),
        SOLID_AND_WIRE(Dodecahedron),
        SOLID_AND_WIRE(Icosahedron),
        SOLID_AND_WIRE(Teapot),
        SOLID_AND_WIRE(Teacup),
        SOLID_AND_WIRE(Teaspoon),
        SOLID_AND_WIRE(RhombicDodecahedron),
        SOLID_AND_WIRE(SierpinskiSponge),
        {"gluSphere", call(gluSphere)},
        {"gluCylinder", call(gluCylinder)},
        {"gluDisk", call(gluDisk)},
        {"gluPartialDisk", call(gluPartialDisk)},
    };
#undef SOLID_AND_WIRE
    return table;
}

}  // namespace

int main(int argc, char** argv) {
    bool glut_is_ready = false;
    for (int i = 1; i < argc; ++i) {
        words = std::istringstream(argv[i]);
        const auto name = next<std::string>();
        const auto shape = shapes().find(name);
        if (shape == shapes().end()) give_up("no shape is called '" + name + "'");
        if (name.starts_with("glut") && !glut_is_ready) {
            int one = 1;
            glutInit(&one, argv);
            glut_is_ready = true;
        }
        std::printf("call %s\n", argv[i]);
        current = {};
        shape->second();
    }
    return 0;
}
