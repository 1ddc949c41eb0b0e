#include "judge/oracle/oracle.h"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cctype>
#include <functional>
#include <map>
#include <random>
#include <span>
#include <stdexcept>
#include <string>

namespace twinlight::oracle {
namespace {

namespace mp = boost::multiprecision;
using Number = mp::number<mp::cpp_bin_float<60, mp::digit_base_10, void, std::int32_t>, mp::et_off>;

// ---- Vectors and matrices: rows and columns as the specification writes them ----

using Vector3 = std::array<Number, 3>;
using Vector4 = std::array<Number, 4>;
using Matrix3 = std::array<Vector3, 3>;  // [row][column]
using Matrix4 = std::array<Vector4, 4>;

Number dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Number length(const Vector3& v) { return mp::sqrt(dot(v, v)); }
Vector3 times(const Number& factor, const Vector3& v) { return {factor * v[0], factor * v[1], factor * v[2]}; }
Vector3 plus(const Vector3& a, const Vector3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vector3 xyz(const Vector4& v) { return {v[0], v[1], v[2]}; }
bool is_zero(const Vector3& v) { return v[0] == 0 && v[1] == 0 && v[2] == 0; }
// The unit vector; 0 stays 0 (a ruling each time: there is no direction).
Vector3 unit(const Vector3& v) { return is_zero(v) ? v : times(1 / length(v), v); }

Matrix4 identity() {
    Matrix4 m{};
    for (std::size_t i = 0; i < 4; ++i) m[i][i] = 1;
    return m;
}
Matrix4 product(const Matrix4& a, const Matrix4& b) {
    Matrix4 m{};
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            for (std::size_t k = 0; k < 4; ++k) m[i][j] += a[i][k] * b[k][j];
    return m;
}
Vector4 transformed(const Matrix4& m, const Vector4& v) {
    Vector4 result{};
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t k = 0; k < 4; ++k) result[i] += m[i][k] * v[k];
    return result;
}

Number radians(const Number& degrees) { return degrees * boost::math::constants::pi<Number>() / 180; }

// Rotations by 90 degrees must have exact zeros: pi in 60 digits leaves 1e-61.
Number cleaned(const Number& x) { return mp::abs(x) < Number("1e-55") ? Number(0) : x; }

Matrix4 rotation(const Number& angle_deg, const Vector3& axis) {  // 2.11.2
    if (is_zero(axis)) return identity();                         // undefined
    const Vector3 u = unit(axis);
    const Number c = cleaned(mp::cos(radians(angle_deg))), s = cleaned(mp::sin(radians(angle_deg)));
    Matrix4 m = identity();
    const std::array<std::array<Number, 3>, 3> cross = {{{0, -u[2], u[1]}, {u[2], 0, -u[0]}, {-u[1], u[0], 0}}};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
            const Number uu = u[i] * u[j];
            m[i][j] = uu + c * ((i == j ? Number(1) : Number(0)) - uu) + s * cross[i][j];
        }
    return m;
}

Vector3 cross(const Vector3& a, const Vector3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Matrix4 translation(const Vector3& by) {
    Matrix4 m = identity();
    for (std::size_t i = 0; i < 3; ++i) m[i][3] = by[i];
    return m;
}

Matrix4 look_at(std::span<const double> a) {  // gluLookAt's rotation; the translation by -eye follows
    const Vector3 f = unit({Number(a[3]) - a[0], Number(a[4]) - a[1], Number(a[5]) - a[2]});
    const Vector3 s = unit(cross(f, unit({a[6], a[7], a[8]}))), u = cross(s, f);
    Matrix4 m = identity();
    for (std::size_t j = 0; j < 3; ++j) m[0][j] = s[j], m[1][j] = u[j], m[2][j] = -f[j];
    return m;
}

// ---- Normals: n' = n M^-1 (2.11.3) ----

Matrix3 adjugate(const Matrix3& m) {
    const Matrix3 columns = {{{m[0][0], m[1][0], m[2][0]}, {m[0][1], m[1][1], m[2][1]}, {m[0][2], m[1][2], m[2][2]}}};
    return {cross(columns[1], columns[2]), cross(columns[2], columns[0]), cross(columns[0], columns[1])};
}
Number norm(const Matrix3& m) { return mp::sqrt(dot(m[0], m[0]) + dot(m[1], m[1]) + dot(m[2], m[2])); }

// RULING: a matrix is singular if its rank is less than 3 for numbers of 21 bits, after its rows and columns are scaled (which
// glScale does, and which loses no digits).
constexpr double kSingular = 0x1p21;
bool is_singular(Matrix3 m) {
    for (int round = 0; round < 8; ++round) {
        for (Vector3& row : m) {
            const Number largest =
                std::max({Number(mp::abs(row[0])), Number(mp::abs(row[1])), Number(mp::abs(row[2]))});
            if (largest == 0) return true;
            row = times(1 / largest, row);
        }
        for (std::size_t j = 0; j < 3; ++j) {
            const Number largest =
                std::max({Number(mp::abs(m[0][j])), Number(mp::abs(m[1][j])), Number(mp::abs(m[2][j]))});
            if (largest == 0) return true;
            for (Vector3& row : m) row[j] /= largest;
        }
    }
    const Matrix3 adjoint = adjugate(m);
    const Number determinant = m[0][0] * adjoint[0][0] + m[0][1] * adjoint[1][0] + m[0][2] * adjoint[2][0];
    return norm(m) * norm(adjoint) >= Number(kSingular) * mp::abs(determinant);
}

// ---- The state (2.14.2, tables 2.9 to 2.11) ----

struct LightState {
    bool enabled = false;
    Vector4 ambient{0, 0, 0, 1}, diffuse{0, 0, 0, 1}, specular{0, 0, 0, 1}, position_eye{0, 0, 1, 0};
    Vector3 spot_direction_eye{0, 0, -1};
    Number exponent = 0, cutoff_deg = 180, k0 = 1, k1 = 0, k2 = 0;
};
struct MaterialState {
    Vector4 ambient{0.2, 0.2, 0.2, 1}, diffuse{0.8, 0.8, 0.8, 1}, specular{0, 0, 0, 1}, emission{0, 0, 0, 1};
    Number shininess = 0;
};

class Machine {
  public:
    explicit Machine(const Options& options) : options_(options), random_(options.seed) {
        lights_[0].diffuse = lights_[0].specular = {1, 1, 1, 1};
    }

    void execute(const Command& command) {
        const auto found = functions().find(command.name());
        if (found == functions().end())
            throw std::invalid_argument("the oracle does not know " + std::string(command.name()));
        found->second(*this, command);
    }
    std::vector<Vertex> take_vertices() { return std::move(vertices_); }

  private:
    using Function = std::function<void(Machine&, const Command&)>;

    // ---- Rounding, for Options ----
    Number perturbed(const Number& x, double by) {
        if (by == 0) return x;
        return x * (1 + Number(by) * (static_cast<double>(random_() >> 11) * 0x1p-52 - 1));
    }
    Number value(const Number& x) { return perturbed(x, options_.value_rounding); }
    template <std::size_t N>
    std::array<Number, N> value(std::array<Number, N> v) {
        for (Number& x : v) x = value(x);
        return v;
    }
    Matrix4 rounded(Matrix4 m) {
        for (Vector4& row : m)
            for (Number& x : row) x = perturbed(x, options_.matrix_rounding);
        return m;
    }
    Matrix4 modelview() { return rounded(modelviews_.back()); }

    // ---- The equation (2.14.1) ----

    struct Towards {
        Vector3 dir{};
        Number distance = 0;
        bool is_infinite = false;
        Number uncertainty = 0;  // of the direction, from value_rounding
    };
    // The vector from p1 to p2, which are homogeneous: the unit vector, and its length before.
    Towards towards(const Vector4& p1, const Vector4& p2) const {
        if (p1[3] != 0 && p2[3] != 0) {
            const Vector3 from = times(1 / p1[3], xyz(p1)), to = times(1 / p2[3], xyz(p2));
            Vector3 v = plus(to, times(-1, from));
            // What rounding may add to each end.
            const Number share = 2 * Number(options_.value_rounding),
                         slack = share * std::max(length(from), length(to));
            for (std::size_t i = 0; i < 3 && options_.border == Border::kInside; ++i)
                if (mp::abs(v[i]) < share * std::max(Number(mp::abs(from[i])), Number(mp::abs(to[i])))) v[i] = 0;
            Towards result{unit(v), length(v)};
            if (slack == 0 || result.distance == 0) return result;
            result.uncertainty = std::min(Number(slack / result.distance), Number(2));
            if (options_.border == Border::kInside)
                result.distance = std::max(Number(result.distance - slack), Number(0));
            if (options_.border == Border::kOutside) result.distance += slack;
            return result;
        }
        if (p1[3] == 0 && p2[3] == 0) return {unit(plus(xyz(p2), times(-1, xyz(p1)))), 0, true};
        if (p2[3] == 0) return {unit(xyz(p2)), 0, true};
        return {unit(times(-1, xyz(p1))), 0, true};
    }

    Number attenuation(const LightState& light, const Towards& vp) {
        if (light.position_eye[3] == 0) return 1;
        // RULING: infinitely far from a positional light: the limit.
        if (vp.is_infinite) return light.k1 == 0 && light.k2 == 0 && light.k0 > 0 ? Number(1 / light.k0) : Number(0);
        const Number divisor =
            value(light.k0) + value(light.k1) * vp.distance + value(light.k2) * vp.distance * vp.distance;
        return divisor > 0 ? Number(1 / divisor) : Number(0);  // RULING: not positive
    }

    static Number power(const Number& base, const Number& exponent) {
        if (exponent == 0) return 1;  // 2.1.1
        return base > 0 ? Number(mp::pow(base, exponent)) : Number(0);
    }

    // a >= b, where rounding may decide.
    bool is_border(const Number& difference, const Number& scale, const Number& uncertainty) const {
        return options_.border != Border::kExact && mp::abs(difference) <= (options_.width + uncertainty) * scale;
    }
    bool reaches(const Number& a, const Number& b, const Number& scale, const Number& uncertainty) const {
        if (is_border(a - b, scale, uncertainty)) return options_.border == Border::kInside;
        return a >= b - Number("1e-45") * scale;
    }

    Number spot(const LightState& light, const Towards& vp) {
        if (light.cutoff_deg == 180) return 1;
        const Number cosine = -dot(vp.dir, value(unit(light.spot_direction_eye)));
        const Number cos_cutoff = cleaned(mp::cos(radians(light.cutoff_deg)));
        if (!reaches(cosine, cos_cutoff, 1, vp.uncertainty))
            return 0;  // RULING: a cone of 90 degrees is dark behind the light
        return power(cosine, light.exponent);
    }

    Colors lit(const Vector4& v, const Vector3& n, const MaterialState& material) {
        Vector3 primary = xyz(material.emission), secondary{}, magnitude{};
        const auto add = [&](Vector3& sum, const Number& factor, const Vector4& a, const Vector4& b) {
            for (std::size_t i = 0; i < 3; ++i) {
                sum[i] += factor * a[i] * b[i];
                magnitude[i] += mp::abs(factor * a[i] * b[i]);
            }
        };
        for (std::size_t i = 0; i < 3; ++i) magnitude[i] = mp::abs(primary[i]);
        add(primary, 1, material.ambient, scene_ambient_);
        const Vector3 vpe = local_viewer_ ? value(towards(v, {0, 0, 0, 1}).dir) : Vector3{0, 0, 1};
        for (const LightState& light : lights_) {
            if (!light.enabled) continue;
            Towards vp = towards(v, value_of_position(light.position_eye));
            vp.dir = value(vp.dir);
            const Number reach = attenuation(light, vp) * spot(light, vp);
            add(primary, reach, material.ambient, light.ambient);
            const Number n_dot_vp = dot(n, vp.dir);
            add(primary, reach * std::max(n_dot_vp, Number(0)), material.diffuse, light.diffuse);
            // f_i: n . VP is not 0, where . means max(..., 0).
            const Number scale = length(n);
            const bool behind = is_border(n_dot_vp, scale, vp.uncertainty) ? options_.border == Border::kOutside
                                                                           : n_dot_vp <= Number("1e-45") * scale;
            if (behind) continue;
            const Vector3 sum = plus(vp.dir, vpe), h = unit(sum);
            shortest_half_vector_ = std::min(shortest_half_vector_, length(sum).convert_to<double>());
            add(separate_ ? secondary : primary,
                reach * power(std::max(Number(dot(n, h)), Number(0)), material.shininess), material.specular,
                light.specular);
        }
        Colors colors;
        for (std::size_t i = 0; i < 3; ++i) {
            colors.primary[i] = primary[i].convert_to<double>();
            colors.secondary[i] = secondary[i].convert_to<double>();
            colors.magnitude[i] = magnitude[i].convert_to<double>();
        }
        colors.primary[3] = material.diffuse[3].convert_to<double>();
        return colors;
    }

    Vector4 value_of_position(const Vector4& p) {
        const Vector3 v = value(xyz(p));
        return {v[0], v[1], v[2], p[3]};
    }

    Vector3 normal_eye() {
        const Matrix4 m = modelview();
        const Matrix3 upper = {xyz(m[0]), xyz(m[1]), xyz(m[2])};
        if (is_singular(upper)) return {};  // RULING
        const Matrix3 adjoint = adjugate(upper);
        const Number determinant =
            upper[0][0] * adjoint[0][0] + upper[0][1] * adjoint[1][0] + upper[0][2] * adjoint[2][0];
        Matrix3 inverse = adjoint;
        for (Vector3& row : inverse) row = value(times(1 / determinant, row));
        Vector3 n{};  // a row vector times the inverse
        for (std::size_t j = 0; j < 3; ++j)
            for (std::size_t i = 0; i < 3; ++i) n[j] += normal_[i] * inverse[i][j];
        if (normalize_ || options_.unit_normals) return value(unit(n));
        if (rescale_) return times(1 / length(inverse[2]), n);
        return value(n);
    }

    void vertex(const Vector4& position) {
        Matrix4 m = modelview();
        // Without an inverse that keeps w, only eye coordinates in floats can be used, from a matrix in floats.
        const bool keeps_w = m[3][0] == 0 && m[3][1] == 0 && m[3][2] == 0 && modelviews_.back()[3][3] == 1;
        for (std::size_t i = 0; i < 4 && !keeps_w; ++i) m[i] = value(m[i]);
        const Vector4 v = value(transformed(m, position));
        const Vector3 n = normal_eye();
        Vertex result;
        for (std::size_t i = 0; i < 4; ++i) result.position_eye[i] = v[i].convert_to<double>();
        shortest_half_vector_ = 2;
        result.front = lit(v, n, materials_[0]);
        if (two_side_) result.back = lit(v, times(-1, n), materials_[1]);
        result.shortest_half_vector = shortest_half_vector_;
        vertices_.push_back(result);
    }

    // ---- Commands ----

    // Table 2.6: a component of a colour or normal given as an integer.
    static Number normalized(double c, Kind kind) {
        const auto number = [&](bool is_signed, int bits) {
            const Number most = mp::ldexp(Number(1), bits) - 1;
            return is_signed ? Number((2 * Number(c) + 1) / most) : Number(Number(c) / most);
        };
        switch (kind) {
            case Kind::kByte: return number(true, 8);
            case Kind::kShort: return number(true, 16);
            case Kind::kInt: return number(true, 32);
            case Kind::kUbyte: return number(false, 8);
            case Kind::kUshort: return number(false, 16);
            case Kind::kUint: return number(false, 32);
            default: return c;
        }
    }
    static Kind kind_of(const Command& command) { return command.sig().parameters.back().kind; }
    static Vector4 vector4(std::span<const double> values) {
        Vector4 v = {0, 0, 0, 1};
        for (std::size_t i = 0; i < values.size() && i < 4; ++i) v[i] = values[i];
        return v;
    }

    void track_color() {
        if (color_material_) set_material(color_face_, color_mode_, color_);
    }
    void color(const Command& command) {
        color_ = {0, 0, 0, 1};
        for (std::size_t i = 0; i < command.arguments.size(); ++i)
            color_[i] = normalized(command.arguments[i], kind_of(command));
        track_color();
    }
    void normal(const Command& command) {
        for (std::size_t i = 0; i < 3; ++i) normal_[i] = normalized(command.arguments[i], kind_of(command));
    }

    void set_light(const Command& command) {
        LightState& light = lights_.at(command.enumerant(0) - kGL_LIGHT0);
        const std::span<const double> values = std::span(command.arguments).subspan(2);
        switch (command.enumerant(1)) {
            case kGL_AMBIENT: light.ambient = vector4(values); break;
            case kGL_DIFFUSE: light.diffuse = vector4(values); break;
            case kGL_SPECULAR: light.specular = vector4(values); break;
            case kGL_POSITION: light.position_eye = transformed(modelview(), vector4(values)); break;
            case kGL_SPOT_DIRECTION: {
                const Matrix4 m = modelview();
                for (std::size_t i = 0; i < 3; ++i)
                    light.spot_direction_eye[i] = dot(xyz(m[i]), {values[0], values[1], values[2]});
                break;
            }
            case kGL_SPOT_EXPONENT: light.exponent = values[0]; break;
            case kGL_SPOT_CUTOFF: light.cutoff_deg = values[0]; break;
            case kGL_CONSTANT_ATTENUATION: light.k0 = values[0]; break;
            case kGL_LINEAR_ATTENUATION: light.k1 = values[0]; break;
            case kGL_QUADRATIC_ATTENUATION: light.k2 = values[0]; break;
            default: throw std::invalid_argument("the oracle does not know this light parameter");
        }
    }
    void set_material(Enum face, Enum pname, const Vector4& values) {
        for (std::size_t i = 0; i < 2; ++i) {
            if (face == (i == 0 ? kGL_BACK : kGL_FRONT)) continue;
            MaterialState& m = materials_.at(i);
            switch (pname) {
                case kGL_AMBIENT: m.ambient = values; break;
                case kGL_DIFFUSE: m.diffuse = values; break;
                case kGL_AMBIENT_AND_DIFFUSE: m.ambient = m.diffuse = values; break;
                case kGL_SPECULAR: m.specular = values; break;
                case kGL_EMISSION: m.emission = values; break;
                case kGL_SHININESS: m.shininess = values[0]; break;
                default: throw std::invalid_argument("the oracle does not know this material parameter");
            }
        }
    }
    // 2.14.3: while it is enabled, the current colour rules the property that glColorMaterial names.
    void material(const Command& command) {
        set_material(command.enumerant(0), command.enumerant(1), vector4(std::span(command.arguments).subspan(2)));
        track_color();
    }
    void light_model(const Command& command) {
        const std::span<const double> values = std::span(command.arguments).subspan(1);
        switch (command.enumerant(0)) {
            case kGL_LIGHT_MODEL_AMBIENT: scene_ambient_ = vector4(values); break;
            case kGL_LIGHT_MODEL_LOCAL_VIEWER: local_viewer_ = values[0] != 0; break;
            case kGL_LIGHT_MODEL_TWO_SIDE: two_side_ = values[0] != 0; break;
            case kGL_LIGHT_MODEL_COLOR_CONTROL: separate_ = values[0] == kGL_SEPARATE_SPECULAR_COLOR; break;
            default: throw std::invalid_argument("the oracle does not know this light model parameter");
        }
    }
    void enable(Enum capability, bool on) {
        if (capability >= kGL_LIGHT0 && capability < kGL_LIGHT0 + lights_.size())
            lights_.at(capability - kGL_LIGHT0).enabled = on;
        else if (capability == kGL_NORMALIZE)
            normalize_ = on;
        else if (capability == kGL_RESCALE_NORMAL)
            rescale_ = on;
        else if (capability == kGL_COLOR_MATERIAL) {
            color_material_ = on;
            track_color();
        } else if (capability != kGL_LIGHTING && capability != kGL_DEPTH_TEST)
            throw std::invalid_argument("the oracle does not know this capability");
    }

    void multiply(const Matrix4& by) { set_matrix(product(modelview(), rounded(by))); }
    void set_matrix(const Matrix4& m) {
        if (is_modelview_) modelviews_.back() = m;  // projections do not change a vertex's light
    }
    static Matrix4 matrix(std::span<const double> values, bool by_rows) {
        Matrix4 m{};
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j < 4; ++j) m[i][j] = values[by_rows ? 4 * i + j : 4 * j + i];
        return m;
    }

    static const std::map<std::string_view, Function>& functions() {
        static const std::map<std::string_view, Function> all = make_functions();
        return all;
    }
    static std::map<std::string_view, Function> make_functions() {
        std::map<std::string_view, Function> all;
        const auto set = [&](std::initializer_list<std::string_view> names, const Function& function) {
            for (const std::string_view name : names) all[name] = function;
        };
        set({"glFrustum", "glOrtho", "gluPerspective", "glShadeModel", "glEnd", "glClear", "glClearColor",
             "glDepthRange"},
            [](Machine&, const Command&) {});
        set({"glMatrixMode"}, [](Machine& m, const Command& c) { m.is_modelview_ = c.enumerant(0) == kGL_MODELVIEW; });
        set({"glLoadIdentity"}, [](Machine& m, const Command&) { m.set_matrix(identity()); });
        set({"glLoadMatrixf", "glLoadMatrixd"},
            [](Machine& m, const Command& c) { m.set_matrix(matrix(c.arguments, false)); });
        set({"glLoadTransposeMatrixf", "glLoadTransposeMatrixd"},
            [](Machine& m, const Command& c) { m.set_matrix(matrix(c.arguments, true)); });
        set({"glMultMatrixf", "glMultMatrixd"},
            [](Machine& m, const Command& c) { m.multiply(matrix(c.arguments, false)); });
        set({"glMultTransposeMatrixf", "glMultTransposeMatrixd"},
            [](Machine& m, const Command& c) { m.multiply(matrix(c.arguments, true)); });
        set({"glTranslatef", "glTranslated"}, [](Machine& m, const Command& c) {
            m.multiply(translation({c.number(0), c.number(1), c.number(2)}));
        });
        set({"glScalef", "glScaled"}, [](Machine& m, const Command& c) {
            Matrix4 t = identity();
            for (std::size_t i = 0; i < 3; ++i) t[i][i] = c.number(i);
            m.multiply(t);
        });
        set({"glRotatef", "glRotated"}, [](Machine& m, const Command& c) {
            m.multiply(rotation(c.number(0), {c.number(1), c.number(2), c.number(3)}));
        });
        set({"gluLookAt"}, [](Machine& m, const Command& c) {
            m.multiply(look_at(c.arguments));
            m.multiply(translation({-c.number(0), -c.number(1), -c.number(2)}));
        });
        set({"glPushMatrix"}, [](Machine& m, const Command&) {
            if (m.is_modelview_) m.modelviews_.push_back(m.modelviews_.back());
        });
        set({"glPopMatrix"}, [](Machine& m, const Command&) {
            if (m.is_modelview_) m.modelviews_.pop_back();
        });
        set({"glLightf", "glLightfv", "glLighti"}, [](Machine& m, const Command& c) { m.set_light(c); });
        set({"glMaterialf", "glMaterialfv", "glMateriali"}, [](Machine& m, const Command& c) { m.material(c); });
        set({"glLightModelf", "glLightModelfv", "glLightModeli"},
            [](Machine& m, const Command& c) { m.light_model(c); });
        set({"glColorMaterial"}, [](Machine& m, const Command& c) {
            m.color_face_ = c.enumerant(0), m.color_mode_ = c.enumerant(1);
            m.track_color();
        });
        set({"glEnable"}, [](Machine& m, const Command& c) { m.enable(c.enumerant(0), true); });
        set({"glDisable"}, [](Machine& m, const Command& c) { m.enable(c.enumerant(0), false); });
        set({"glBegin"}, [](Machine& m, const Command&) { m.vertices_.clear(); });
        for (const Signature& signature : signatures()) {
            if (signature.name.starts_with("glColor3") || signature.name.starts_with("glColor4"))
                all[signature.name] = [](Machine& m, const Command& c) { m.color(c); };
            if (signature.name.starts_with("glNormal3"))
                all[signature.name] = [](Machine& m, const Command& c) { m.normal(c); };
            if (signature.name.starts_with("glVertex") && std::isdigit(signature.name[8]) != 0)
                all[signature.name] = [](Machine& m, const Command& c) { m.vertex(vector4(c.arguments)); };
        }
        return all;
    }

    const Options options_;
    std::mt19937_64 random_;
    bool is_modelview_ = true;
    std::vector<Matrix4> modelviews_{identity()};
    std::array<LightState, 8> lights_{};
    std::array<MaterialState, 2> materials_{};  // front, back
    Vector4 scene_ambient_{0.2, 0.2, 0.2, 1};
    double shortest_half_vector_ = 2;
    bool local_viewer_ = false, separate_ = false, two_side_ = false, normalize_ = false, rescale_ = false;
    bool color_material_ = false;
    Enum color_face_ = kGL_FRONT_AND_BACK, color_mode_ = kGL_AMBIENT_AND_DIFFUSE;
    Vector4 color_{1, 1, 1, 1};
    Vector3 normal_{0, 0, 1};
    std::vector<Vertex> vertices_;
};

}  // namespace

std::vector<Vertex> light(const CommandList& commands, const Options& options) {
    Machine machine(options);
    for (const Command& command : commands.commands) machine.execute(command);
    return machine.take_vertices();
}

}  // namespace twinlight::oracle
