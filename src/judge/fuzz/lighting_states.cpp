// Random scenes for the lighting equation.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "base/math/as_float.h"
#include "judge/compare/departures.h"
#include "judge/fuzz/random_states.h"
#include "scene/frame/frame.h"

namespace twinlight::fuzz {

namespace {

// The departure with the greatest number for this seed. So a new departure changes only the states that are about it.
ShownBug chosen_departure(std::uint64_t seed) {
    ShownBug chosen;
    std::uint64_t greatest = 0;
    for (const compare::Departure& departure : compare::departures()) {
        std::uint64_t number = seed;
        for (const char c : departure.name) number = (number ^ static_cast<unsigned char>(c)) * 0x9E3779B97F4A7C15ULL;
        number ^= number >> 32;
        if (number < greatest) continue;
        greatest = number;
        chosen = ShownBug(&departure);
    }
    return chosen;
}

}  // namespace

ShownBug departure_of(const Seed& seed, Random& structure) {
    const bool about_one = structure.chance(0.1);
    const std::uint64_t which = structure.next();
    if (!seed.departure.empty()) {
        const auto& all = compare::departures();
        const auto found = std::ranges::find(all, seed.departure, &compare::Departure::name);
        return found == all.end() ? ShownBug() : ShownBug(&*found);
    }
    return about_one ? chosen_departure(which) : ShownBug();
}

namespace {

using Id = CommandId;

class LightingState {
  public:
    explicit LightingState(const Seed& seed)
        : structure_(seed.structure), values_(seed.values), departure_(departure_of(seed, structure_)) {}

    CommandList build() {
        color_form_ = structure_.below(8);
        scale_ = structure_.chance(0.5) ? 1.5 : 0.4;  // 0.4 keeps colours below 1, 1.5 does not
        projection();
        // A light's position is transformed by the modelview matrix at the time of its command (2.14.2).
        const bool lights_first = chance(0.3) || projects() || shows(compare::is_at_exact_edge_of_cone);
        if (lights_first) lights();
        modelview();
        if (!lights_first) lights();
        if (chance(0.5)) {
            light_model();
            materials();
        } else {
            materials();
            light_model();
        }
        add(Id::glEnable, {kGL_LIGHTING});
        about_stacks();
        primitive();
        return std::move(list_);
    }

  private:
    void add(Id id, std::vector<double> arguments = {}) {
        // Numbers are rounded to floats, as the driver gets them.
        const std::vector<Parameter>& parameters = signature(id).parameters;
        if (!parameters.empty() && parameters.back().kind == Kind::kFloat) {
            for (double& value : arguments) value = as_float(value);
        }
        list_.commands.push_back({id, std::move(arguments), {}});
    }
    template <class Rule>
    bool shows(Rule* rule) const {
        return departure_.is(rule);
    }
    bool projects() const { return shows(compare::has_normals_in_projection); }
    bool shows_w_0() const { return shows(compare::has_w_0_under_directional_light); }

    // ---- Values ----
    double uniform(double low, double high) { return values_.uniform(low, high); }
    double coordinate() { return uniform(0.05, 1) * (values_.chance(0.5) ? 1 : -1); }
    glm::dvec3 direction() { return glm::normalize(glm::dvec3(coordinate(), coordinate(), coordinate())); }

    // ---- Structure ----
    bool chance(double probability) { return structure_.chance(probability); }
    Enum one_of(std::initializer_list<Enum> choices) {
        return choices.begin()[structure_.below(static_cast<int>(choices.size()))];
    }

    void color(Id id, std::vector<double> head = {}) {
        const bool has_negative = values_.chance(0.05);
        for (int i = 0; i < 4; ++i) head.push_back(uniform(has_negative ? -0.3 : 0, scale_));
        add(id, std::move(head));
    }

    // ---- Matrices (2.11.2) ----

    // Sets the matrix with one of the commands that can.
    void load(const glm::dmat4& matrix, bool multiply) {
        const glm::dmat4 transposed = glm::transpose(matrix);
        const std::vector<double> columns(glm::value_ptr(matrix), glm::value_ptr(matrix) + 16);
        const std::vector<double> rows(glm::value_ptr(transposed), glm::value_ptr(transposed) + 16);
        switch (structure_.below(4)) {
            case 0: return add(multiply ? Id::glMultMatrixf : Id::glLoadMatrixf, columns);
            case 1: return add(multiply ? Id::glMultMatrixd : Id::glLoadMatrixd, columns);
            case 2: return add(multiply ? Id::glMultTransposeMatrixf : Id::glLoadTransposeMatrixf, rows);
            default: return add(multiply ? Id::glMultTransposeMatrixd : Id::glLoadTransposeMatrixd, rows);
        }
    }

    void projection() {
        add(Id::glMatrixMode, {kGL_PROJECTION});
        const double near = 0.5, far = 30, half = uniform(0.3, 1);
        if (shows_w_0()) {  // sees vertices with w = 0, at a depth of 0.9
            clip_from_eye_ = glm::frustum(-half, half, -half, half, near, far);
            clip_from_eye_[2][2] = -0.9;
            load(clip_from_eye_, false);
            return add(Id::glMatrixMode, {kGL_MODELVIEW});
        }
        switch (structure_.below(4)) {
            case 0:
                add(Id::glOrtho, {-2, 2, -2, 2, -20, 20});
                clip_from_eye_ = glm::ortho(-2.0, 2.0, -2.0, 2.0, -20.0, 20.0);
                break;
            case 1:
                add(Id::glFrustum, {-half, half, -half, half, near, far});
                clip_from_eye_ = glm::frustum(-half, half, -half, half, near, far);
                break;
            case 2:
                add(Id::gluPerspective, {60, 1, near, far});
                clip_from_eye_ = glm::perspective(glm::radians(60.0), 1.0, near, far);
                break;
            default: clip_from_eye_ = glm::frustum(-half, half, -half, half, near, far); load(clip_from_eye_, false);
        }
        add(Id::glMatrixMode, {kGL_MODELVIEW});
    }

    void modelview() {
        if (chance(0.2)) {
            const glm::dvec3 eye = 3.0 * direction(), center(coordinate(), 0, 0), up(0.1, 1, 0.2);
            add(Id::gluLookAt, {eye.x, eye.y, eye.z, center.x, center.y, center.z, up.x, up.y, up.z});
            eye_from_object_ = glm::lookAt(eye, center, up);
        }
        const glm::dvec3 moved(coordinate(), coordinate(), coordinate() - 3), axis = direction();
        const double angle_deg = uniform(-180, 180);
        if (chance(0.5)) {
            const bool is_double = chance(0.5);
            add(is_double ? Id::glTranslated : Id::glTranslatef, {moved.x, moved.y, moved.z});
            add(is_double ? Id::glRotated : Id::glRotatef, {angle_deg, axis.x, axis.y, axis.z});
        } else {
            load(glm::rotate(glm::translate(glm::dmat4(1), moved), glm::radians(angle_deg), axis), true);
        }
        eye_from_object_ = glm::rotate(glm::translate(eye_from_object_, moved), glm::radians(angle_deg), axis);
        const auto scaled = [&](const glm::dvec3& by) {
            add(chance(0.5) ? Id::glScaled : Id::glScalef, {by.x, by.y, by.z});
            eye_from_object_ = glm::scale(eye_from_object_, by);
        };
        if (projects()) {
            glm::dmat4 by_depth(1);
            by_depth[2][3] = uniform(0.02, 0.05);
            load(by_depth, true);
            eye_from_object_ *= by_depth;
        }
        if (shows(compare::rescales_much)) {
            scaled(glm::dvec3(1e7));
            return add(Id::glEnable, {kGL_RESCALE_NORMAL});
        }
        if (shows(compare::has_overflowing_highlight)) return scaled(glm::dvec3(0.1));
        switch (structure_.below(5)) {
            case 0: break;
            case 1:  // 2.11.3: normals keep a length other than 1
                scaled({uniform(0.7, 1.4), uniform(0.7, 1.4), uniform(0.7, 1.4)});
                break;
            case 2:
                scaled(glm::dvec3(uniform(0.4, 2.5)));
                add(Id::glEnable, {kGL_RESCALE_NORMAL});
                break;
            default: scaled({uniform(0.5, 2), uniform(0.5, 2), uniform(0.5, 2)}); add(Id::glEnable, {kGL_NORMALIZE});
        }
    }

    // ---- Lights, the light model, materials (2.14) ----

    void light_model() {
        color(Id::glLightModelfv, {kGL_LIGHT_MODEL_AMBIENT});
        const auto flag = [&](Enum name, double probability) {
            const double on = chance(probability) ? 1 : 0;
            add(chance(0.5) ? Id::glLightModeli : Id::glLightModelf, {static_cast<double>(name), on});
        };
        flag(kGL_LIGHT_MODEL_LOCAL_VIEWER, 0.5);
        const bool of_two_sides = shows(compare::has_shininess_0_on_one_side) ||
                                  shows(compare::has_color_material_on_back_alone) ||
                                  shows(compare::sets_sides_apart) || shows(compare::sets_both_sides_after_vertex);
        two_sided_ = of_two_sides;
        flag(kGL_LIGHT_MODEL_TWO_SIDE, of_two_sides ? 1 : 0.5);
        add(Id::glLightModeli, {kGL_LIGHT_MODEL_COLOR_CONTROL,
                                static_cast<double>(departure_.is_none() && chance(0.3) ? kGL_SEPARATE_SPECULAR_COLOR
                                                                                        : kGL_SINGLE_COLOR)});
    }

    void lights() {
        bool any = false;
        for (int i = 0; i < kMaxLights; ++i) {
            const bool last = i == kMaxLights - 1 && !any;
            if (!chance(0.25) && !(last && !departure_.is_none())) continue;
            light(kGL_LIGHT0 + i);
            any = true;
        }
    }

    void light(double l) {
        for (const double pname : {kGL_AMBIENT, kGL_DIFFUSE, kGL_SPECULAR}) color(Id::glLightfv, {l, pname});
        const bool needs_place =
            shows(compare::has_w_under_positional_light) || shows(compare::has_shininess_0_with_factors);
        const bool tiny = shows(compare::has_extreme_direction);
        const bool directional = tiny || shows_w_0() || projects() || (!needs_place && chance(0.4));
        const double reach = tiny ? 1e-30 : directional ? 1 : 4;
        add(Id::glLightfv, {l, kGL_POSITION, reach * coordinate(), reach * coordinate(), reach * coordinate(),
                            directional ? 0 : uniform(0.5, 2)});
        if (shows(compare::is_at_exact_edge_of_cone)) {
            // Every vertex is on the axis or at 90 degrees from it.
            add(Id::glLightfv, {l, kGL_POSITION, 0, 0, 1, 0});
            const bool narrow = chance(0.5);
            add(Id::glLightfv, {l, kGL_SPOT_DIRECTION, narrow ? 0.0 : 1.0, 0, narrow ? -1.0 : 0.0});
            add(Id::glLightf, {l, kGL_SPOT_CUTOFF, narrow ? 0.0 : 90.0});
        } else if (!shows(compare::has_shininess_0_on_one_side) && chance(0.4)) {
            const glm::dvec3 d = direction();
            add(Id::glLightfv, {l, kGL_SPOT_DIRECTION, d.x, d.y, d.z});
            add(Id::glLightf, {l, kGL_SPOT_CUTOFF, uniform(20, 89)});
            add(Id::glLightf, {l, kGL_SPOT_EXPONENT, chance(0.3) ? 0 : uniform(0.5, 40)});
        }
        const bool factors = shows(compare::has_shininess_0_with_factors);
        if (!shows(compare::has_shininess_0_on_one_side) && chance(factors ? 1 : 0.5)) {
            add(Id::glLightf, {l, kGL_CONSTANT_ATTENUATION, uniform(0.2, 2)});
            add(Id::glLightf, {l, kGL_LINEAR_ATTENUATION, uniform(0, 1)});
            add(Id::glLightf, {l, kGL_QUADRATIC_ATTENUATION, uniform(0, 0.5)});
        }
        add(Id::glEnable, {l});
    }

    double shininess(bool front) {
        if (shows(compare::has_shininess_0_with_factors)) return 0;
        if (shows(compare::has_shininess_0_on_one_side)) return front ? 0 : 5;
        if (shows(compare::has_overflowing_highlight)) return 128;
        // 0 is rare, because drivers have known bugs there.
        const double any = uniform(0.5, 128);
        const double choices[] = {1, 2, 5, 32, 64, 128, any, any, any, any};
        const double chosen = choices[structure_.below(10)];
        return chance(0.03) ? 0 : chosen;
    }

    void materials() {
        for (const double face : {kGL_FRONT, kGL_BACK}) {
            for (const double pname : {kGL_AMBIENT, kGL_DIFFUSE, kGL_SPECULAR, kGL_EMISSION}) {
                if (pname == kGL_SPECULAR && shows(compare::has_overflowing_highlight))
                    add(Id::glMaterialfv, {face, pname, 0, 0, 0, 1});
                else
                    color(Id::glMaterialfv, {face, pname});
            }
            add(Id::glMaterialf, {face, kGL_SHININESS, shininess(face == kGL_FRONT)});
        }
        const bool about =
            departure_.is_any(compare::sets_material_before_tracking, compare::has_color_material_on_back_alone,
                              compare::sets_color_before_new_mode, compare::restores_tracked_color,
                              compare::mixes_glcolor3_and_4, compare::tracks_color_before_list);
        if (!about && !chance(0.4)) return;
        const auto mode = [&] {
            return one_of({kGL_EMISSION, kGL_AMBIENT, kGL_DIFFUSE, kGL_SPECULAR, kGL_AMBIENT_AND_DIFFUSE});
        };
        double face = one_of({kGL_FRONT, kGL_FRONT_AND_BACK});
        if (shows(compare::has_color_material_on_back_alone)) face = kGL_BACK;
        if (shows(compare::sets_color_before_new_mode)) {
            add(Id::glColorMaterial, {face, kGL_AMBIENT});
            add(Id::glEnable, {kGL_COLOR_MATERIAL});
            vertex_color();
            add(Id::glGetMaterialfv, {kGL_FRONT, kGL_AMBIENT});
            vertex_color();
            vertex_color();
            add(Id::glColorMaterial, {face, kGL_DIFFUSE});
        } else {
            const bool of_alpha = shows(compare::mixes_glcolor3_and_4);  // only the diffuse material shows alpha
            add(Id::glColorMaterial, {face, static_cast<double>(of_alpha ? kGL_DIFFUSE : mode())});
            add(Id::glEnable, {kGL_COLOR_MATERIAL});
        }
        keep_color_ = shows(compare::sets_material_before_tracking);
        if (!keep_color_) vertex_color();
        if (shows(compare::tracks_color_before_list)) {
            add(Id::glNewList, {1, kGL_COMPILE});
            add(Id::glEndList);
            keep_color_ = true;
        }
    }

    // Draws a point out of sight, so that the driver uses the state of this moment. With several colours the point
    // comes before the last one.
    void draw_elsewhere(const std::vector<int>& color_forms = {}) {
        add(Id::glBegin, {kGL_POINTS});
        for (std::size_t i = 0; i < color_forms.size(); ++i) {
            color_form_ = color_forms[i];
            if (i + 1 == color_forms.size()) add(Id::glVertex4f, {0, 0, 1e6, 1});
            vertex_color();
        }
        if (color_forms.empty()) add(Id::glVertex4f, {0, 0, 1e6, 1});
        add(Id::glEnd);
    }

    // Known bugs of glPushAttrib and glPopAttrib.
    void about_stacks() {
        if (shows(compare::sets_material_before_pop)) {
            add(Id::glPushAttrib, {kGL_LIGHTING_BIT});
            add(Id::glShadeModel, {kGL_FLAT});
            color(Id::glMaterialfv, {kGL_FRONT_AND_BACK, kGL_EMISSION});
            add(Id::glPopAttrib);
        } else if (shows(compare::switches_lights_before_pop)) {
            add(Id::glPushAttrib, {kGL_ENABLE_BIT});
            for (int i = 0; i < kMaxLights; ++i) add(Id::glDisable, {static_cast<double>(kGL_LIGHT0) + i});
            add(Id::glPopAttrib);
        } else if (shows(compare::mixes_glcolor3_and_4)) {
            // The last colour stays current.
            color_form_ = 0;
            draw_elsewhere({0, 1});
            draw_elsewhere({1, 0, 1});
            keep_color_ = true;
        } else if (shows(compare::restores_tracked_color)) {
            // Something is drawn in between, so that the driver copies the colour into the material.
            add(Id::glPushAttrib, {kGL_CURRENT_BIT});
            vertex_color();
            draw_elsewhere();
            add(Id::glPopAttrib);
            keep_color_ = true;
        }
    }

    // ---- Vertices (2.6, 2.7) ----

    // One form of glColor for the whole scene: a scene with and without alpha shows a known bug.
    void vertex_color() {
        switch (color_form_) {
            case 0: return color(Id::glColor4f);
            case 1: return add(Id::glColor3f, {uniform(0, scale_), uniform(0, scale_), uniform(0, scale_)});
            case 2: {
                const auto byte = [&] { return static_cast<double>(values_.below(256)); };
                return add(Id::glColor4ub, {byte(), byte(), byte(), byte()});
            }
            case 3: {
                const auto number = [&] { return static_cast<double>(values_.below(65536) - 32768); };
                return add(Id::glColor4s, {number(), number(), number(), number()});
            }
            default:
                return add(Id::glColor4d, {uniform(0, scale_), uniform(0, scale_), uniform(0, scale_), uniform(0, 1)});
        }
    }

    void vertex_normal() {
        const glm::dvec3 n = direction() * (shows(compare::has_extreme_direction) && chance(0.5) ? 1e25 : 1.0);
        switch (normal_form_) {
            case 0: return add(Id::glNormal3b, {std::round(127 * n.x), std::round(127 * n.y), std::round(127 * n.z)});
            case 1:
                return add(Id::glNormal3s, {std::round(32767 * n.x), std::round(32767 * n.y), std::round(32767 * n.z)});
            case 2: return add(Id::glNormal3d, {n.x, n.y, n.z});
            default: return add(Id::glNormal3f, {n.x, n.y, n.z});
        }
    }

    // The first vertex sets every material that a later vertex sets: see "glMaterial of two sides after a vertex".
    void vertex_material(bool is_first) {
        const bool is_late = shows(compare::sets_both_sides_after_vertex);
        for (const auto& [face, pname] : vertex_materials_) {
            if (is_first == is_late || (!is_first && values_.chance(0.4))) continue;
            if (pname == kGL_SHININESS)
                add(Id::glMaterialf, {static_cast<double>(face), kGL_SHININESS, uniform(1, 128)});
            else
                color(Id::glMaterialfv, {static_cast<double>(face), static_cast<double>(pname)});
        }
    }

    void choose_vertex_materials() {
        const bool of_back = shows(compare::sets_sides_apart);
        const bool of_both = shows(compare::sets_both_sides_after_vertex);
        const bool of_another = !departure_.is_none();
        if (!of_back && !of_both && (of_another || !chance(0.25))) return;
        for (int i = structure_.below(3); i >= 0; --i) {
            const Enum face = of_back   ? kGL_BACK
                              : of_both ? kGL_FRONT_AND_BACK
                                        : one_of({kGL_FRONT, kGL_FRONT, kGL_BACK, kGL_FRONT_AND_BACK});
            // The known bug of the back is in products with a light's colour.
            const Enum pname = of_back ? one_of({kGL_AMBIENT, kGL_DIFFUSE, kGL_SPECULAR})
                                       : one_of({kGL_AMBIENT, kGL_DIFFUSE, kGL_SPECULAR, kGL_EMISSION, kGL_SHININESS});
            vertex_materials_.emplace_back(face, pname);
        }
    }

    void vertex_position(int corner) {
        // In a corner of the picture, at any depth.
        const double x_ndc = (corner % 2 ? 1 : -1) * uniform(0.55, 0.95);
        const double y_ndc = (corner / 2 ? 1 : -1) * uniform(0.55, 0.95);
        const double z_eye = uniform(-6, -2), w = clip_from_eye_[2][3] * z_eye + clip_from_eye_[3][3];
        const glm::dvec4 eye(x_ndc * w / clip_from_eye_[0][0], y_ndc * w / clip_from_eye_[1][1], z_eye, 1);
        glm::dvec4 object = glm::inverse(eye_from_object_) * eye;
        if (projects()) object /= object.w;
        if (shows_w_0()) {
            const glm::dvec3 direction = glm::inverse(glm::dmat3(eye_from_object_)) * glm::dvec3(eye);
            return add(Id::glVertex4f, {direction.x, direction.y, direction.z, 0});
        }
        const double w_object = shows(compare::has_w_under_positional_light) ? uniform(1.5, 3) : 1;
        const std::vector<double> v{object.x * w_object, object.y * w_object, object.z * w_object, w_object};
        if (w_object != 1) return add(Id::glVertex4f, v);
        switch (position_form_) {
            case 0: return add(Id::glVertex3d, {v[0], v[1], v[2]});
            case 1: return add(Id::glVertex3fv, {v[0], v[1], v[2]});
            default: return add(Id::glVertex3f, {v[0], v[1], v[2]});
        }
    }

    void primitive() {
        normal_form_ = structure_.below(8);
        position_form_ = structure_.below(4);
        choose_vertex_materials();
        const double mode = one_of({kGL_TRIANGLES, kGL_TRIANGLES, kGL_TRIANGLES, kGL_TRIANGLE_STRIP, kGL_TRIANGLE_FAN,
                                    kGL_POLYGON, kGL_POINTS, kGL_LINE_STRIP});
        add(Id::glBegin, {two_sided_ ? kGL_TRIANGLES : mode});
        int corners[] = {0, 1, 2, 3};
        for (int i = 3; i > 0; --i) std::swap(corners[i], corners[values_.below(i + 1)]);
        for (int i = 0; i < 3; ++i) {
            if (!keep_color_ && (i == 0 || values_.chance(0.6))) vertex_color();
            vertex_normal();
            vertex_material(i == 0);
            vertex_position(corners[i]);
        }
        add(Id::glEnd);
    }

    Random structure_, values_;
    ShownBug departure_;
    CommandList list_;
    double scale_ = 1;
    glm::dmat4 clip_from_eye_{1}, eye_from_object_{1};
    std::vector<std::pair<Enum, Enum>> vertex_materials_;  // face, parameter
    int color_form_ = 0, normal_form_ = 0, position_form_ = 0;
    bool keep_color_ = false, two_sided_ = false;
};

}  // namespace

CommandList lighting_state(const Seed& seed) { return LightingState(seed).build(); }

}  // namespace twinlight::fuzz
