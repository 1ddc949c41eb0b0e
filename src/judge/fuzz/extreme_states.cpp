// Random scenes at the limits of the lighting equation: numbers of all magnitudes that a float has, and places where the equation
// changes its mind (the border of a cone, the horizon, an opposite half vector, a light at the vertex, singular matrices).
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <utility>
#include <vector>

#include "base/math/as_float.h"
#include "judge/fuzz/random_states.h"
#include "scene/command/text.h"

namespace twinlight::fuzz {
namespace {

using Id = CommandId;

glm::dvec4 as_floats(const glm::dvec4& v) { return {as_float(v.x), as_float(v.y), as_float(v.z), as_float(v.w)}; }
bool is_finite(const glm::dvec4& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w);
}

class ExtremeState {
  public:
    explicit ExtremeState(const Seed& seed) : structure_(seed.structure), values_(seed.values) {}

    CommandList build() {
        reach_ = structure_.below(4);
        matrix_ = structure_.below(11);
        local_viewer_ = chance(0.5);
        is_triangle_ = chance(0.35);
        two_sided_ = is_triangle_ && chance(0.8);
        has_vertex_w_ = chance(0.3);
        is_vertex_direction_ = chance(0.04);
        const bool lights_first = chance(0.2);

        modelview();
        const std::vector<Command> matrices = std::exchange(list_.commands, {});
        vertices();
        if (!lights_first) list_.commands = matrices;
        lights(lights_first ? glm::dmat4(1) : eye_from_object_);
        if (lights_first) list_.commands.insert(list_.commands.end(), matrices.begin(), matrices.end());
        light_model();
        materials();
        add(Id::glEnable, {kGL_LIGHTING});
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
    // Exactly 0, or so small that it hardly matters, or a little more.
    double nearly_zero() { return values_.chance(0.4) ? 0 : sign() * log_uniform(-30, -3); }

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
    void translated(const glm::dvec3& t) {
        add(Id::glTranslatef, {t.x, t.y, t.z});
        eye_from_object_ = glm::translate(eye_from_object_, glm::dvec3(as_float(t.x), as_float(t.y), as_float(t.z)));
    }
    void multiplied(const glm::dmat4& m) {
        std::vector<double> columns(glm::value_ptr(m), glm::value_ptr(m) + 16);
        for (double& x : columns) x = as_float(x);
        eye_from_object_ = eye_from_object_ * glm::make_mat4(columns.data());
        add(Id::glMultMatrixf, columns);
    }
    void looked_at(const glm::dvec3& eye, const glm::dvec3& center) {
        const glm::dvec3 up = direction();
        add(Id::gluLookAt, {eye.x, eye.y, eye.z, center.x, center.y, center.z, up.x, up.y, up.z});
        eye_from_object_ = glm::lookAt(eye, center, up);
    }
    void modelview() {
        switch (matrix_) {
            case 0: break;
            case 1: rotated(); break;
            case 2: translated(direction() * magnitude()), rotated(); break;
            case 3: scaled(glm::dvec3(magnitude())), rotated(); break;
            case 4:
                rotated(), scaled({magnitude(), magnitude(), magnitude()}), translated(direction() * magnitude());
                break;
            case 5: {  // a camera
                const glm::dvec3 center = direction() * magnitude();
                looked_at(center + direction() * magnitude(), center);
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
            case 7: {  // a planar shadow of a light
                const glm::dvec4 plane(direction(), uniform(-2, 2));
                const glm::dvec4 light(direction() * uniform(3, 6), values_.chance(0.5) ? 1 : 0);
                if (values_.chance(0.7)) rotated();
                glm::dmat4 shadow = glm::dot(plane, light) * glm::dmat4(1);
                for (int i = 0; i < 4; ++i)
                    for (int j = 0; j < 4; ++j) shadow[i][j] -= light[j] * plane[i];
                multiplied(shadow);
                break;
            }
            case 8: {  // a mirror in a plane
                const glm::dvec3 n = direction();
                const double distance = uniform(-2, 2);
                glm::dmat4 mirror(1);
                for (int i = 0; i < 3; ++i)
                    for (int j = 0; j < 3; ++j) mirror[i][j] -= 2 * n[i] * n[j];
                mirror[3] = glm::dvec4(2 * distance * n, 1);
                if (values_.chance(0.7)) rotated();
                multiplied(mirror);
                break;
            }
            case 9: {  // a camera and its object far from the origin
                const glm::dvec3 far = direction() * log_uniform(0, 24);
                const glm::dvec3 center(as_float(far.x), as_float(far.y), as_float(far.z));
                looked_at(center + direction() * log_uniform(-3, 3), center);
                translated(center);
                rotated();
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

    // ---- Vertices ----

    void vertices() {
        double w = has_vertex_w_ ? sign() * magnitude() : 1;
        if (is_vertex_direction_) w = 0;
        const double size = magnitude();
        for (int i = 0; i < 3; ++i)
            vertices_object_.push_back(as_floats(glm::dvec4(direction() * (size * log_uniform(-2, 0)), w)));
        if (!is_triangle_ || !project_triangle()) {
            vertices_object_.resize(1);
            project_point();
        }
    }

    void set_projection(const glm::dmat4& m) {
        projection_ = {{Id::glMatrixMode, {kGL_PROJECTION}, {}}, {}, {Id::glMatrixMode, {kGL_MODELVIEW}, {}}};
        std::vector<double> columns(glm::value_ptr(m), glm::value_ptr(m) + 16);
        for (double& x : columns) x = as_float(x);
        projection_[1] = {Id::glLoadMatrixf, std::move(columns), {}};
    }

    // The vertex appears at a corner of the view: this matrix uses only its largest eye coordinate.
    void project_point() {
        const glm::dvec4 eye = eye_from_object_ * vertices_object_[0];
        int largest = 3;
        for (int i = 0; i < 3; ++i)
            if (std::abs(eye[i]) > std::abs(eye[largest])) largest = i;
        const double to_one = std::clamp(1 / std::abs(eye[largest]), 1e-37, 1e37) * (eye[largest] < 0 ? -1 : 1);
        glm::dmat4 m(0);
        m[largest] = to_one * glm::dvec4(-0.75, -0.75, 0, 1);
        set_projection(m);
    }

    // The vertices appear at three corners of the view, each way around. False if their eye coordinates are too near a line for that.
    bool project_triangle() {
        glm::dvec4 size(0);
        glm::dmat3x4 eye;  // a column for each vertex
        for (int i = 0; i < 3; ++i) {
            eye[i] = eye_from_object_ * vertices_object_[static_cast<std::size_t>(i)];
            size = glm::max(size, glm::abs(eye[i]));
        }
        for (int row = 0; row < 4; ++row) {
            if (size[row] == 0) size[row] = 1;
            if (!(size[row] > 1e-36 && size[row] < 1e36)) return false;
        }
        for (int i = 0; i < 3; ++i) eye[i] /= size;
        int corners[] = {0, 1, 2, 3};
        for (int i = 3; i > 0; --i) std::swap(corners[i], corners[values_.below(i + 1)]);
        glm::dmat3x4 clip;
        for (int i = 0; i < 3; ++i)
            clip[i] = glm::dvec4(corners[i] % 2 ? 0.75 : -0.75, corners[i] / 2 ? 0.75 : -0.75, 0, 1);
        // The matrix of least norm with matrix * eye = clip.
        glm::dmat4 m = clip * glm::inverse(glm::transpose(eye) * eye) * glm::transpose(eye);
        constexpr double kMost = 1e3;  // so that floats are exact enough
        for (int column = 0; column < 4; ++column) {
            for (int row = 0; row < 4; ++row)
                if (!(std::abs(m[column][row]) < kMost)) return false;
            m[column] /= size[column];
        }
        const glm::dmat4 clip_from_object = m * eye_from_object_;
        for (const glm::dvec4& vertex : vertices_object_)
            for (int row = 0; row < 4; ++row) {
                double sum = 0;
                for (int column = 0; column < 4; ++column) {
                    const double element = std::abs(clip_from_object[column][row]);
                    if (!(element < 1e37)) return false;
                    sum += element * std::abs(vertex[column]);
                }
                if (!(sum < kMost)) return false;
            }
        set_projection(m);
        return true;
    }

    // ---- Lights, the light model, materials ----

    void color(Id id, std::vector<double> head = {}, double most = 1) {
        for (int i = 0; i < 4; ++i) head.push_back(uniform(0, most));
        add(id, std::move(head));
    }

    // `eye_from_call`: the modelview matrix of the calls.
    void lights(const glm::dmat4& eye_from_call) {
        eye_from_call_ = eye_from_call;
        call_from_eye_ = glm::inverse(eye_from_call);
        count_ = 1 + structure_.below(chance(0.15) ? 8 : 3);
        for (int i = 0; i < count_; ++i) light(static_cast<double>(kGL_LIGHT0) + i);
    }

    // A vertex as the light's position may be given, divided by its w.
    glm::dvec4 vertex_for_light() {
        const glm::dvec4& vertex =
            vertices_object_[static_cast<std::size_t>(values_.below(static_cast<int>(vertices_object_.size())))];
        vertex_eye_ = eye_from_object_ * vertex;
        return eye_from_call_ == eye_from_object_ ? vertex : vertex_eye_;
    }

    // Where the equation changes its mind; else somewhere.
    glm::dvec4 position(bool directional, bool has_w) {
        const glm::dvec4 vertex = vertex_for_light();
        const double w = directional ? 0 : has_w ? sign() * magnitude() : 1;
        const glm::dvec4 somewhere(direction() * magnitude(), w);
        const int kind = values_.below(10);
        glm::dvec4 p = somewhere;
        const glm::dvec3 place = glm::dvec3(vertex) / vertex.w;
        const double size = glm::length(place);
        if (kind == 0 && !directional) {  // at the vertex
            p = has_w ? vertex : glm::dvec4(place, 1);
        } else if (kind == 1 && !directional) {  // near it
            p = glm::dvec4(place + direction() * size * log_uniform(-26, 2), 1);
        } else if (kind == 2 && !directional) {  // very near, where a coordinate of the vertex is 0
            p = glm::dvec4(place, 1);
            for (int i = 0; i < 3; ++i)
                if (p[i] == 0) p[i] = sign() * log_uniform(-149, 0);
        } else if (kind == 3) {  // opposite to the viewer
            glm::dvec3 away = glm::dmat3(call_from_eye_) * glm::dvec3(0, 0, -1);
            if (local_viewer_) away = place - glm::dvec3(call_from_eye_[3]) / call_from_eye_[3].w;
            away += direction() * glm::length(away) * nearly_zero();
            p = directional ? glm::dvec4(away, 0) : glm::dvec4(place + away * log_uniform(-3, 3), 1);
        } else if (kind == 4) {  // far behind or in front of all others
            p = glm::dvec4(direction() * log_uniform(-149, 127.9), w);
        }
        p = as_floats(p);
        return is_finite(p) ? p : as_floats(somewhere);
    }

    void light(double l) {
        const bool directional = chance(0.25), has_w = chance(0.25), cone = chance(0.35), attenuated = chance(0.4);
        const bool whole_exponent = chance(0.5);
        for (const double pname : {kGL_AMBIENT, kGL_DIFFUSE, kGL_SPECULAR})
            color(Id::glLightfv, {l, pname}, 1.0 / count_);
        const glm::dvec4 p = position(directional, has_w);
        add(Id::glLightfv, {l, kGL_POSITION, p.x, p.y, p.z, p.w});
        const glm::dvec4 p_eye = eye_from_call_ * p;
        vp_eye_ = p.w == 0 ? glm::dvec3(p_eye) : glm::dvec3(p_eye) / p_eye.w - glm::dvec3(vertex_eye_) / vertex_eye_.w;
        if (cone) {
            glm::dvec3 d = direction() * magnitude();
            const double cosine = glm::dot(glm::normalize(-vp_eye_), glm::normalize(glm::dmat3(eye_from_call_) * d));
            if (cosine < 0) d = -d;
            // The vertex on the cone's border, or a little beside it.
            double border = std::acos(std::min(std::abs(cosine), 1.0)) * 180 / glm::pi<double>() * (1 + nearly_zero());
            if (!(border >= 0 && border <= 90)) border = 30;
            add(Id::glLightfv, {l, kGL_SPOT_DIRECTION, d.x, d.y, d.z});
            const double cutoffs[] = {0, 90, 45, uniform(0, 90), uniform(0, 90), border, border};
            add(Id::glLightf, {l, kGL_SPOT_CUTOFF, cutoffs[values_.below(7)]});
            add(Id::glLightf, {l, kGL_SPOT_EXPONENT, whole_exponent ? 1 + values_.below(128) : uniform(0, 128)});
        }
        if (attenuated) {
            const auto factor = [&] { return chance(0.3) ? 0 : magnitude(); };
            add(Id::glLightf, {l, kGL_CONSTANT_ATTENUATION, factor()});
            add(Id::glLightf, {l, kGL_LINEAR_ATTENUATION, factor()});
            add(Id::glLightf, {l, kGL_QUADRATIC_ATTENUATION, factor()});
        }
        add(Id::glEnable, {l});
    }

    void light_model() {
        color(Id::glLightModelfv, {kGL_LIGHT_MODEL_AMBIENT}, 0.3);
        add(Id::glLightModeli, {kGL_LIGHT_MODEL_LOCAL_VIEWER, local_viewer_ ? 1.0 : 0.0});
        if (two_sided_) add(Id::glLightModeli, {kGL_LIGHT_MODEL_TWO_SIDE, 1});
        const bool separate = chance(0.2);
        add(Id::glLightModeli, {kGL_LIGHT_MODEL_COLOR_CONTROL,
                                static_cast<double>(separate ? kGL_SEPARATE_SPECULAR_COLOR : kGL_SINGLE_COLOR)});
        if (chance(0.5)) add(Id::glEnable, {kGL_NORMALIZE});
        if (chance(0.2)) add(Id::glEnable, {kGL_RESCALE_NORMAL});
    }

    void material(double face) {
        for (const double pname : {kGL_AMBIENT, kGL_DIFFUSE, kGL_SPECULAR}) color(Id::glMaterialfv, {face, pname});
        color(Id::glMaterialfv, {face, kGL_EMISSION}, 0.2);
        const int kind = structure_.below(20);
        const double shininess = kind == 0   ? std::min(magnitude(), 128.0)
                                 : kind == 1 ? 0
                                 : kind < 10 ? 1 + values_.below(128)
                                             : uniform(0, 128);
        add(Id::glMaterialf, {face, kGL_SHININESS, shininess});
    }

    void materials() {
        if (two_sided_) {
            material(kGL_FRONT);
            material(kGL_BACK);
        } else {
            material(kGL_FRONT_AND_BACK);
        }
        if (!chance(0.3)) return;
        static constexpr Enum kModes[] = {kGL_EMISSION, kGL_AMBIENT, kGL_DIFFUSE, kGL_SPECULAR,
                                          kGL_AMBIENT_AND_DIFFUSE};
        static constexpr Enum kFaces[] = {kGL_FRONT, kGL_BACK, kGL_FRONT_AND_BACK};
        const Enum face = kFaces[structure_.below(3)], mode = kModes[structure_.below(5)];
        add(Id::glColorMaterial, {static_cast<double>(face), static_cast<double>(mode)});
        add(Id::glEnable, {kGL_COLOR_MATERIAL});
    }

    // At right angles to the direction to the last light, or nearly; else any.
    glm::dvec3 normal() {
        glm::dvec3 n = direction();
        if (values_.chance(0.2)) {
            // n . VP is the same in object coordinates: (n M^-1) (M d) = n d.
            const glm::dvec3 d = glm::inverse(glm::dmat3(eye_from_object_)) * vp_eye_;
            const glm::dvec3 across = glm::normalize(glm::cross(d, n)) + glm::normalize(d) * nearly_zero();
            if (is_finite(glm::dvec4(across, 0))) n = across;
        }
        if (reach_ > 0 && values_.chance(0.4)) n *= magnitude();
        return n;
    }

    void primitive() {
        list_.commands.insert(list_.commands.end(), projection_.begin(), projection_.end());
        add(Id::glBegin, {static_cast<double>(vertices_object_.size() == 3 ? kGL_TRIANGLES : kGL_POINTS)});
        for (const glm::dvec4& vertex : vertices_object_) {
            color(Id::glColor4f);
            const glm::dvec3 n = normal();
            add(Id::glNormal3f, {n.x, n.y, n.z});
            add(Id::glVertex4f, {vertex.x, vertex.y, vertex.z, vertex.w});
        }
        add(Id::glEnd);
    }

    Random structure_, values_;
    int reach_ = 0, matrix_ = 0, count_ = 1;
    bool local_viewer_ = false, is_triangle_ = false, two_sided_ = false;
    bool has_vertex_w_ = false, is_vertex_direction_ = false;
    glm::dmat4 eye_from_object_{1};
    glm::dmat4 eye_from_call_{1}, call_from_eye_{1};  // of the calls for lights
    std::vector<glm::dvec4> vertices_object_;
    glm::dvec4 vertex_eye_{0, 0, 0, 1};  // that the last light was placed for
    glm::dvec3 vp_eye_{0, 0, 1};         // from it to the light
    std::vector<Command> projection_;
    CommandList list_;
};

}  // namespace

CommandList extreme_state(const Seed& seed) { return ExtremeState(seed).build(); }

}  // namespace twinlight::fuzz
