// Rules about normals and the sides of polygons.
#include <algorithm>
#include <cmath>

#include "base/math/normal_matrix.h"
#include "base/text/translation.h"
#include "judge/lint/watch.h"

namespace twinlight::lint {

namespace {

// Normals within 5 % of length 1 change a colour by less than anyone sees.
constexpr double kLengthTolerance = 0.05;

// The length furthest from 1 among normals that are not 0; 1 if all are near.
double worst_length(const std::vector<glm::dvec3>& normals) {
    double worst = 1;
    for (const glm::dvec3& normal : normals) {
        const double length = glm::length(normal);
        if (length > 0 && std::abs(std::log(length)) > std::abs(std::log(worst))) worst = length;
    }
    return std::abs(worst - 1) > kLengthTolerance ? worst : 1;
}

std::vector<glm::dvec3> object_normals(const Draw& draw) {
    std::vector<glm::dvec3> normals;
    for (const Vertex& vertex : draw.vertices) normals.push_back(vertex.normal_object);
    return normals;
}

std::vector<glm::dvec3> eye_normals(const Draw& draw) {
    std::vector<glm::dvec3> normals;
    for (const EyeVertex& vertex : eye_vertices(draw)) normals.push_back(vertex.normal);
    return normals;
}

Edit normalize_before(const Place& place) { return {.place = place, .insert = "glEnable(GL_NORMALIZE);"}; }

// The modelview matrix makes normals of length 1 longer or shorter.
class ScaledNormals : public Watch {
    void drawn(const Draw& draw, const State&) override {
        if (!uses_normals(draw) || draw.lighting.normalize || is_flattened(draw) ||
            worst_length(object_normals(draw)) != 1)
            return;
        const double length = worst_length(eye_normals(draw));
        if (length == 1) return;
        warn({.place = draw.place,
              .message = tr("the modelview matrix scales this object, and its normals with it: to length {:.2g} "
                            "instead of 1, so it is too {}",
                            length, length < 1 ? tr("dark") : tr("bright")),
              .fix = "glEnable(GL_NORMALIZE);",
              .edits = {normalize_before(draw.place)},
              .key = fmt::format("{:.1f}", length)});
    }
};

class LongNormals : public Watch {
    void drawn(const Draw& draw, const State&) override {
        if (!uses_normals(draw) || draw.lighting.normalize || is_flattened(draw)) return;
        const double length = worst_length(object_normals(draw));
        if (length == 1 || worst_length(eye_normals(draw)) == 1) return;
        warn({.place = draw.place,
              .message = tr("normals of this object have length {:.2g} instead of 1, so it is too {}", length,
                            length < 1 ? tr("dark") : tr("bright")),
              .fix = "glEnable(GL_NORMALIZE);",
              .edits = {normalize_before(draw.place)},
              .key = fmt::format("{:.1f}", length)});
    }
};

class ZeroNormal : public Watch {
  public:
    void after(const Command& command, const State&) override {
        if (!is_effect(command, "normal")) return;
        const bool is_zero = std::ranges::all_of(command.arguments, [](double v) { return v == 0; });
        if (is_zero && zero_.line == 0) zero_ = command.place;
    }
    void drawn(const Draw& draw, const State& state) override {
        if (!uses_normals(draw)) return;
        const bool has_zero =
            std::ranges::any_of(draw.vertices, [](const Vertex& v) { return v.normal_object == glm::dvec3(0); });
        if (!has_zero) return;
        if (zero_.line > 0)
            warn({.place = zero_,
                  .message = tr("this normal is (0, 0, 0): no light reaches the vertex"),
                  .fix = tr("give the direction that the surface faces, such as glNormal3f(0, 0, 1)"),
                  .key = "zero"});
        else if (state.arrays().client().normal.enabled)
            warn({.place = draw.place,
                  .message = tr("the array of glNormalPointer has normals (0, 0, 0): no light reaches these vertices"),
                  .fix = tr("fill the array with the direction that the surface faces at each vertex"),
                  .key = "array"});
    }

  private:
    Place zero_;
};

// The normal of a triangle's plane in eye coordinates, of length 1; 0 for one without a direction.
glm::dvec3 plane_normal(const Draw& draw, const std::vector<EyeVertex>& vertices, const Triangle& triangle) {
    if (!has_direction(draw, triangle)) return glm::dvec3(0);
    const glm::dvec3 a = vertices[triangle[0]].position, b = vertices[triangle[1]].position,
                     c = vertices[triangle[2]].position;
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double length = glm::length(normal);
    return length > 0 ? normal / length : glm::dvec3(0);
}

// Flat polygons whose one normal does not fit their plane.
class NormalDoesNotFit : public Watch {
  public:
    explicit NormalDoesNotFit(bool is_never_set) : wants_never_set_(is_never_set) {}

    void after(const Command& command, const State&) override {
        // Shapes send normals, too.
        if (is_effect(command, "normal") || is_effect(command, "quadric_shape") || is_effect(command, "client_arrays"))
            is_set_ = true;
    }
    void drawn(const Draw& draw, const State&) override {
        if (is_set_ == wants_never_set_ || draw.surfaces || !uses_normals(draw) || draw.vertices.size() < 3) return;
        const std::vector<EyeVertex> vertices = eye_vertices(draw);
        const auto lies_along = [&](const Triangle& triangle) {
            const glm::dvec3 normal = draw.vertices[triangle[0]].normal_object;
            if (normal != draw.vertices[triangle[1]].normal_object ||
                normal != draw.vertices[triangle[2]].normal_object)
                return false;
            const glm::dvec3 plane = plane_normal(draw, vertices, triangle);
            const double length = glm::length(vertices[triangle[0]].normal);
            if (plane == glm::dvec3(0) || length == 0) return false;
            const double cosine = std::abs(glm::dot(plane, vertices[triangle[0]].normal)) / length;
            // 60 degrees; 30 where no normal is set at all, and so none can be meant for the face
            return !(cosine > (wants_never_set_ ? 0.87 : 0.5));
        };
        if (std::ranges::none_of(triangles_of(draw), lies_along)) return;
        const char* message = wants_never_set_
                                  ? tr("this object is lit, but no glNormal was called: all its normals are (0, 0, 1)")
                                  : tr("a polygon has a normal that lies along it: a glNormal is missing, and the last "
                                       "one is still in use");
        warn({.place = draw.place,
              .message = message,
              .fix = tr("call glNormal3f before the vertices of each face, with the direction that it faces")});
    }

  private:
    bool wants_never_set_;
    bool is_set_ = false;
};
struct NormalNeverSet : NormalDoesNotFit {
    NormalNeverSet() : NormalDoesNotFit(true) {}
};
struct NormalStale : NormalDoesNotFit {
    NormalStale() : NormalDoesNotFit(false) {}
};

// glNormalPointer, but GL_NORMAL_ARRAY is not enabled.
class NormalArrayOff : public Watch {
  public:
    void before(const Command& command, const State&) override { from_arrays_ = draws_arrays(command.id); }
    void after(const Command& command, const State&) override {
        if (command.id == CommandId::glNormalPointer) pointer_ = command.place;
    }
    void drawn(const Draw& draw, const State& state) override {
        if (!from_arrays_ || pointer_.line == 0 || state.arrays().client().normal.enabled || !uses_normals(draw))
            return;
        const glm::dvec3 normal = draw.vertices.front().normal_object;
        const std::string call = "glEnableClientState(GL_NORMAL_ARRAY);";
        warn({.place = pointer_,
              .message = tr("this array has no effect: GL_NORMAL_ARRAY is not enabled, so all vertices have the "
                            "current normal ({:.3g}, {:.3g}, {:.3g})",
                            normal.x, normal.y, normal.z),
              .fix = call,
              .edits = {{.place = pointer_, .insert = call, .is_after = true}},
              .key = "off"});
    }

  private:
    Place pointer_;
    bool from_arrays_ = false;
};

// Front faces, by their vertices' order, whose normals point to the other side, where that matters.
class WindingAgainstNormals : public Watch {
  public:
    void after(const Command& command, const State&) override {
        if (is_effect(command, "shape")) shape_ = command;
    }
    void drawn(const Draw& draw, const State&) override {
        const bool is_two_sided = draw.lighting.light_model.two_side && uses_normals(draw);
        const bool culls = draw.raster.cull_enabled && draw.raster.cull_face != kGL_FRONT_AND_BACK;
        if (!draw.lighting.enabled || (!is_two_sided && !culls)) return;
        // Back faces are kept on purpose: the inside of a room.
        if (culls && draw.raster.cull_face == kGL_FRONT) return;
        const std::vector<EyeVertex> vertices = eye_vertices(draw);
        std::size_t triangles = 0, disagree = 0;
        for (const Triangle& triangle : triangles_of(draw)) {
            const glm::dvec3 plane =
                plane_normal(draw, vertices, triangle) * (draw.raster.front_face == kGL_CCW ? 1.0 : -1.0);
            const glm::dvec3 sum =
                vertices[triangle[0]].normal + vertices[triangle[1]].normal + vertices[triangle[2]].normal;
            const double length = glm::length(sum);
            const double cosine = length > 0 ? glm::dot(plane, sum) / length : 0;
            if (plane == glm::dvec3(0)) continue;
            ++triangles;
            disagree += cosine < -0.7;  // other normals fit no side
        }
        if (disagree == 0 || disagree * 10 < triangles * 9) return;
        const bool is_tea =
            shape_ && shape_->place == draw.place && shape_->name().find("Tea") != std::string_view::npos;
        const std::string other = draw.raster.front_face == kGL_CCW ? "glFrontFace(GL_CW);" : "glFrontFace(GL_CCW);";
        warn({.place = draw.place,
              .message = tr("{}: GL takes the outside of this object for its back{}",
                            is_tea ? tr("the triangles of GLUT's tea set are clockwise")
                                   : tr("the vertices' order does not match the normals"),
                            culls ? tr(", and culls it") : tr(", and lights it with the turned normal")),
              .fix = tr("{} before it, and back after it", other),
              .edits = {{.place = draw.place, .insert = other}}});
    }

  private:
    std::optional<Command> shape_;
};

class FlattenedNormals : public Watch {
  public:
    void after(const Command& command, const State& state) override {
        if (!is_effect(command, "scale") || state.attributes().matrix_mode != kGL_MODELVIEW) return;
        const bool has_zero = command.number(0) == 0 || command.number(1) == 0 || command.number(2) == 0;
        if (has_zero) scale_ = command.place;
    }
    void drawn(const Draw& draw, const State&) override {
        if (scale_.line == 0 || !uses_normals(draw) || !is_singular(glm::dmat3(draw.eye_from_object))) return;
        warn({.place = scale_,
              .message = tr("this glScale has a factor of 0, so normals cannot be computed and the object is dark"),
              .fix = tr("use a small factor such as 0.001 and glEnable(GL_NORMALIZE)"),
              .key = "flat"});
    }

  private:
    Place scale_;
};

// Lit objects under the matrix of a planar shadow.
class LitShadow : public Watch {
  public:
    void after(const Command& command, const State&) override {
        if (is_effect(command, "scale")) has_scale_of_0_ |= std::ranges::count(command.arguments, 0.0) > 0;
    }
    void drawn(const Draw& draw, const State&) override {
        if (has_scale_of_0_ || !uses_normals(draw) || !is_flattened(draw)) return;
        warn({.place = draw.place,
              .message =
                  tr("the modelview matrix flattens this object, as for a shadow, but it is lit: normals that are "
                     "flattened have no meaning"),
              .fix = tr("glDisable(GL_LIGHTING); and the shadow's glColor before it, glEnable(GL_LIGHTING); after it"),
              .key = "shadow"});
    }

  private:
    bool has_scale_of_0_ = false;  // scale-zero warns then
};

}  // namespace

std::vector<Rule> normal_rules() {
    return {
        {"scale-without-normalize",
         "The modelview matrix scales a lit object, and with it the length of its normals. The object is too dark or "
         "too bright.",
         "Section 2.11.3: normals are multiplied by the inverse of the modelview matrix, so a scale of 3 makes them a "
         "third as long. Lighting needs length 1. (`GL_NORMALIZE` costs little.)",
         "glEnable(GL_NORMALIZE);",
         R"(// the view
// the light
+glEnable(GL_NORMALIZE);
 glScalef(3, 3, 3);
 glutSolidSphere(0.5, 40, 20);
)",
         make_watch<ScaledNormals>},
        {"normal-length", "The normals of a lit object do not have length 1. The object is too dark or too bright.",
         "Section 2.14.1: the lighting equation takes the normal as it is. Section 2.11.3: `GL_NORMALIZE` gives it "
         "length 1.",
         "glEnable(GL_NORMALIZE);",
         R"(// the view
// the light
+glEnable(GL_NORMALIZE);
 glBegin(GL_TRIANGLES);
 glNormal3f(0, 0.2, 0.4);
 glVertex3f(-2, -1, 0);
 glVertex3f(2, -1, 0);
 glVertex3f(0, 2, -1.5);
 glEnd();
)",
         make_watch<LongNormals>},
        {"normal-zero", "A normal is (0, 0, 0). No light reaches the vertex.",
         "Section 2.14.1: n . VP is 0, so neither diffuse nor specular light is added.", "glNormal3f(0, 0, 1);",
         R"(// the view
// the light
 glBegin(GL_TRIANGLES);
-glNormal3f(0, 0, 0);
+glNormal3f(0, 0, 1);
 glVertex3f(-2, -1, 0);
 glVertex3f(2, -1, 0);
 glVertex3f(0, 2, 0);
 glEnd();
)",
         make_watch<ZeroNormal>},
        {"normal-missing",
         "An object is lit, but `glNormal` is never called. All its normals are (0, 0, 1).",
         "Section 2.7: the initial current normal is (0, 0, 1), and a vertex has the current normal.",
         "glNormal3f(0, 1, 0);",
         R"(// the view
// the light
 glBegin(GL_QUADS);
+glNormal3f(0, 1, 0);
 glVertex3f(-2, 0, 2);
 glVertex3f(2, 0, 2);
 glVertex3f(2, 0, -2);
 glVertex3f(-2, 0, -2);
 glEnd();
)",
         make_watch<NormalNeverSet>,
         {"normal-array-off"}},
        {"normal-stale",
         "A face has no `glNormal` of its own. It has the normal of the face before it, which lies along its surface.",
         "Section 2.7: the current normal holds until the next `glNormal`.",
         "glNormal3f(0, 0, 1);",
         R"(// the view
// the light
 glBegin(GL_QUADS);
 glNormal3f(0, 1, 0);
 glVertex3f(-2, 0, 2);
 glVertex3f(2, 0, 2);
 glVertex3f(2, 0, -2);
 glVertex3f(-2, 0, -2);
+glNormal3f(0, 0, 1);
 glVertex3f(-2, -1, 2);
 glVertex3f(2, -1, 2);
 glVertex3f(2, 0, 2);
 glVertex3f(-2, 0, 2);
 glEnd();
)",
         make_watch<NormalStale>,
         {"normal-array-off"}},
        {"normal-array-off",
         "`glNormalPointer` gives an array of normals, but `GL_NORMAL_ARRAY` is not enabled. All vertices have the "
         "current normal.",
         "Section 2.8: drawing reads an array only while it is enabled; otherwise the vertices have the current value.",
         "glEnableClientState(GL_NORMAL_ARRAY);",
         R"(// the view
// the light
 GLfloat floor_at[] = {-2, 0, 2,  2, 0, 2,  2, 0, -2,  -2, 0, -2};
 GLfloat up[] = {0, 1, 0,  0, 1, 0,  0, 1, 0,  0, 1, 0};
 glEnableClientState(GL_VERTEX_ARRAY);
+glEnableClientState(GL_NORMAL_ARRAY);
 glVertexPointer(3, GL_FLOAT, 0, floor_at);
 glNormalPointer(GL_FLOAT, 0, up);
 glDrawArrays(GL_QUADS, 0, 4);
)",
         make_watch<NormalArrayOff>},
        {"winding-against-normals",
         "Faces are culled or lit on both sides, but the order of an object's vertices does not match its normals: GL "
         "takes the outside for the back. GLUT's teapot is such an object.",
         "Section 3.5.1: `glFrontFace` decides by the order of the vertices in the window, not by normals. Section "
         "2.14.1: a back face is lit with the turned normal.",
         "glFrontFace(GL_CW);",
         R"(// the view
// the light
 glEnable(GL_CULL_FACE);
+glFrontFace(GL_CW);
 glutSolidTeapot(1.3);
)",
         make_watch<WindingAgainstNormals>},
        {"scale-zero",
         "`glScale` with a factor of 0 flattens a lit object. Its normals cannot be computed, and it is dark.",
         "Section 2.11.3: normals need the inverse of the modelview matrix, which does not exist.",
         "glScalef(1, 0.001, 1); glEnable(GL_NORMALIZE);",
         R"(// the view
// the light
+glEnable(GL_NORMALIZE);
-glScalef(1, 0, 1);
+glScalef(1, 0.001, 1);
 glutSolidSphere(1.5, 40, 20);
)",
         make_watch<FlattenedNormals>},
        {"lit-shadow",
         "A matrix flattens an object, as for its shadow on a plane, while lighting is on. The shadow gets light.",
         "Section 2.11.3: normals need the inverse of the modelview matrix, which does not exist. A shadow has no "
         "light "
         "to compute: it needs one dark colour.",
         "glDisable(GL_LIGHTING);",
         R"(// the view
// the light
 glutSolidSphere(0.7, 40, 20);
// the plane y = -1; the light is far away in the direction (1, 2, 1)
 glMultMatrixf((GLfloat[]){2, 0, 0, 0,  -1, 0, -1, 0,  0, 0, 2, 0,  -1, -2, -1, 2});
+glDisable(GL_LIGHTING);
+glColor3f(0.1, 0.1, 0.1);
 glutSolidSphere(0.7, 40, 20);
)",
         make_watch<LitShadow>},
    };
}

}  // namespace twinlight::lint
