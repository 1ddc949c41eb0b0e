// Random scenes at the limits of the lighting equation: numbers of all magnitudes that a float has, and places where the equation
// changes its mind (the border of a cone, the horizon, a light at the vertex, singular matrices).
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "judge/fuzz/random_states.h"
#include "scene/command/text.h"

namespace twinlight::fuzz {
namespace {

using Id = CommandId;

double as_float(double x) { return static_cast<double>(static_cast<float>(x)); }

class ExtremeState {
  public:
    explicit ExtremeState(const Seed& seed) : structure_(seed.structure), values_(seed.values) {}

    CommandList build() {
        reach_ = structure_.below(4);
        matrix_ = structure_.below(9);
        const bool lights_first = chance(0.2);
        if (lights_first) lights();
        modelview();
        vertex_object_ = place(true);
        if (!lights_first) lights();
        light_model();
        materials();
        add(Id::glEnable, {kGL_LIGHTING});
        projection();
        primitive();
        return std::move(list_);
    }

  private:
    void add(Id id, std::vector<double> arguments = {}) {
        for (double& value : arguments) value = as_float(value);
        list_.commands.push_back({id, std::move(arguments), {}});
    }
    bool chance(double probability) { return structure_.chance(probability); }
    double uniform(double low, double high) { return values_.uniform(low, high); }
    double sign() { return values_.chance(0.5) ? 1 : -1; }

    // ---- Magnitudes ----

    // 2^low to 2^high, each exponent as likely as any other.
    double log_uniform(double low, double high) { return std::exp2(uniform(low, high)); }
    // From the smallest denormal to the largest float; in most structures within 2^-40 to 2^40, in some about 1.
    double magnitude() {
        switch (reach_) {
            case 0: return log_uniform(-3, 3);
            case 1: return log_uniform(-20, 20);
            case 2: return values_.chance(0.6) ? log_uniform(-3, 3) : log_uniform(-50, 50);
            default: return values_.chance(0.5) ? log_uniform(-3, 3) : log_uniform(-149, 127.9);
        }
    }
    glm::dvec3 direction() {
        glm::dvec3 v;
        do v = {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
        while (glm::length(v) > 1 || glm::length(v) < 0.05);
        if (values_.chance(0.15)) v = glm::dvec3(0), v[values_.below(3)] = sign();  // along an axis
        return glm::normalize(v);
    }
    // A homogeneous position.
    glm::dvec4 place(bool is_vertex) {
        double w = 1;
        if (values_.chance(0.3)) w = sign() * magnitude();
        if (values_.chance(is_vertex ? 0.03 : 0.1)) w = 0;
        const glm::dvec3 p = direction() * magnitude();
        return {as_float(p.x), as_float(p.y), as_float(p.z), as_float(w)};
    }

    // ---- Matrices ----

    void scaled(const glm::dvec3& by) {
        add(Id::glScalef, {by.x, by.y, by.z});
        eye_from_object_ = glm::scale(eye_from_object_, glm::dvec3(as_float(by.x), as_float(by.y), as_float(by.z)));
    }
    void rotated() {
        const glm::dvec3 axis = direction();
        const double angle_deg = as_float(values_.chance(0.2) ? 90.0 * values_.below(4) : uniform(-180, 180));
        add(Id::glRotatef, {angle_deg, axis.x, axis.y, axis.z});
        eye_from_object_ = glm::rotate(eye_from_object_, glm::radians(angle_deg), axis);
    }
    void translated(double far) {
        const glm::dvec3 t = direction() * far;
        add(Id::glTranslatef, {t.x, t.y, t.z});
        eye_from_object_ = glm::translate(eye_from_object_, glm::dvec3(as_float(t.x), as_float(t.y), as_float(t.z)));
    }
    void multiplied(const glm::dmat4& m) {
        std::vector<double> columns(glm::value_ptr(m), glm::value_ptr(m) + 16);
        for (double& x : columns) x = as_float(x);
        eye_from_object_ = eye_from_object_ * glm::make_mat4(columns.data());
        add(Id::glMultMatrixf, columns);
    }
    void modelview() {
        switch (matrix_) {
            case 0: break;
            case 1: rotated(); break;
            case 2: translated(magnitude()), rotated(); break;
            case 3: scaled(glm::dvec3(magnitude())), rotated(); break;
            case 4: rotated(), scaled({magnitude(), magnitude(), magnitude()}), translated(magnitude()); break;
            case 5: {  // a camera, perhaps far away
                const glm::dvec3 center = direction() * magnitude(), eye = center + direction() * magnitude();
                const glm::dvec3 up = direction();
                add(Id::gluLookAt, {eye.x, eye.y, eye.z, center.x, center.y, center.z, up.x, up.y, up.z});
                eye_from_object_ = glm::lookAt(eye, center, up);
                rotated();
                break;
            }
            case 6: {  // singular: flattened along an axis, between rotations
                if (values_.chance(0.7)) rotated();
                glm::dvec3 by(uniform(0.5, 2), uniform(0.5, 2), uniform(0.5, 2));
                by[values_.below(3)] = 0;
                scaled(by);
                if (values_.chance(0.7)) rotated();
                break;
            }
            case 7: {  // a planar shadow, or a mirror, of a light through a plane
                const glm::dvec4 plane(direction(), uniform(-2, 2));
                const glm::dvec4 light(direction() * uniform(3, 6), values_.chance(0.5) ? 1 : 0);
                rotated();
                if (chance(0.5)) {
                    glm::dmat4 shadow = glm::dot(plane, light) * glm::dmat4(1);
                    for (int i = 0; i < 4; ++i)
                        for (int j = 0; j < 4; ++j) shadow[i][j] -= light[j] * plane[i];
                    multiplied(shadow);
                } else {
                    glm::dmat4 mirror(1);
                    const glm::dvec3 n(plane);
                    for (int i = 0; i < 3; ++i)
                        for (int j = 0; j < 3; ++j) mirror[i][j] -= 2 * n[i] * n[j];
                    multiplied(mirror);
                }
                break;
            }
            default: {  // any matrix
                glm::dmat4 m(1);
                for (int i = 0; i < 4; ++i)
                    for (int j = 0; j < 3; ++j) m[i][j] = uniform(-1, 1) * magnitude();
                multiplied(m);
            }
        }
    }

    // The vertex appears at a corner of the view: this matrix uses only its largest eye coordinate.
    void projection() {
        const glm::dvec4 eye = eye_from_object_ * vertex_object_;
        int largest = 3;
        for (int i = 0; i < 3; ++i)
            if (std::abs(eye[i]) > std::abs(eye[largest])) largest = i;
        const double to_one = std::clamp(1 / std::abs(eye[largest]), 1e-37, 1e37) * (eye[largest] < 0 ? -1 : 1);
        glm::dmat4 m(0);
        m[largest] = to_one * glm::dvec4(-0.75, -0.75, 0, 1);
        add(Id::glMatrixMode, {kGL_PROJECTION});
        add(Id::glLoadMatrixf, std::vector<double>(glm::value_ptr(m), glm::value_ptr(m) + 16));
        add(Id::glMatrixMode, {kGL_MODELVIEW});
    }

    // ---- Lights, the light model, materials ----

    void color(Id id, std::vector<double> head = {}, double most = 1) {
        for (int i = 0; i < 4; ++i) head.push_back(uniform(0, most));
        add(id, std::move(head));
    }

    void lights() {
        count_ = 1 + structure_.below(chance(0.3) ? 8 : 3);
        for (int i = 0; i < count_; ++i) light(static_cast<double>(kGL_LIGHT0) + i);
    }

    void light(double l) {
        const bool directional = chance(0.2), cone = chance(0.35), attenuated = chance(0.4);
        for (const double pname : {kGL_AMBIENT, kGL_DIFFUSE, kGL_SPECULAR})
            color(Id::glLightfv, {l, pname}, 1.0 / count_);
        glm::dvec4 p = place(false);
        if (directional) p.w = 0;
        const bool at_vertex = values_.chance(0.06), near_vertex = values_.chance(0.06);
        if (!directional && (at_vertex || near_vertex)) p = vertex_object_;
        if (!directional && near_vertex) p += glm::dvec4(direction() * p.w * log_uniform(-40, 0), 0);
        add(Id::glLightfv, {l, kGL_POSITION, p.x, p.y, p.z, p.w});
        if (cone) {
            const glm::dvec3 d = direction() * magnitude();
            add(Id::glLightfv, {l, kGL_SPOT_DIRECTION, d.x, d.y, d.z});
            const double cutoffs[] = {0, 90, 45, 60, uniform(0, 90), uniform(0, 90), uniform(0, 90)};
            add(Id::glLightf, {l, kGL_SPOT_CUTOFF, cutoffs[values_.below(7)]});
            add(Id::glLightf, {l, kGL_SPOT_EXPONENT, chance(0.5) ? values_.below(129) : uniform(0, 128)});
        }
        if (attenuated) {
            const auto factor = [&] { return values_.chance(0.3) ? 0 : magnitude(); };
            add(Id::glLightf, {l, kGL_CONSTANT_ATTENUATION, factor()});
            add(Id::glLightf, {l, kGL_LINEAR_ATTENUATION, factor()});
            add(Id::glLightf, {l, kGL_QUADRATIC_ATTENUATION, factor()});
        }
        add(Id::glEnable, {l});
    }

    void light_model() {
        color(Id::glLightModelfv, {kGL_LIGHT_MODEL_AMBIENT}, 0.3);
        add(Id::glLightModeli, {kGL_LIGHT_MODEL_LOCAL_VIEWER, chance(0.5) ? 1.0 : 0.0});
        const bool separate = chance(0.2);
        add(Id::glLightModeli, {kGL_LIGHT_MODEL_COLOR_CONTROL,
                                static_cast<double>(separate ? kGL_SEPARATE_SPECULAR_COLOR : kGL_SINGLE_COLOR)});
        if (chance(0.5)) add(Id::glEnable, {kGL_NORMALIZE});
        if (chance(0.2)) add(Id::glEnable, {kGL_RESCALE_NORMAL});
    }

    void materials() {
        for (const double pname : {kGL_AMBIENT, kGL_DIFFUSE, kGL_SPECULAR})
            color(Id::glMaterialfv, {kGL_FRONT_AND_BACK, pname});
        color(Id::glMaterialfv, {kGL_FRONT_AND_BACK, kGL_EMISSION}, 0.2);
        const bool whole = chance(0.5);
        const double shininess = whole ? values_.below(129) : uniform(0, 128);
        add(Id::glMaterialf,
            {kGL_FRONT_AND_BACK, kGL_SHININESS, chance(0.05) ? std::min(magnitude(), 128.0) : shininess});
        if (!chance(0.3)) return;
        static constexpr Enum kModes[] = {kGL_EMISSION, kGL_AMBIENT, kGL_DIFFUSE, kGL_SPECULAR,
                                          kGL_AMBIENT_AND_DIFFUSE};
        add(Id::glColorMaterial, {kGL_FRONT_AND_BACK, static_cast<double>(kModes[structure_.below(5)])});
        add(Id::glEnable, {kGL_COLOR_MATERIAL});
    }

    void primitive() {
        add(Id::glBegin, {kGL_POINTS});
        color(Id::glColor4f);
        glm::dvec3 n = direction();
        if (reach_ > 0 && values_.chance(0.5)) n *= magnitude();
        add(Id::glNormal3f, {n.x, n.y, n.z});
        add(Id::glVertex4f, {vertex_object_.x, vertex_object_.y, vertex_object_.z, vertex_object_.w});
        add(Id::glEnd);
    }

    Random structure_, values_;
    int reach_ = 0, matrix_ = 0, count_ = 1;
    glm::dmat4 eye_from_object_{1};
    glm::dvec4 vertex_object_{0, 0, 0, 1};
    CommandList list_;
};

}  // namespace

CommandList extreme_state(const Seed& seed) { return ExtremeState(seed).build(); }

}  // namespace twinlight::fuzz
