#include "judge/oracle/oracle.h"

#include <algorithm>
#include <cctype>
#include <functional>
#include <limits>
#include <optional>
#include <random>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "judge/oracle/algebra.h"

namespace twinlight::oracle {
namespace {

// ---- The state (2.14.2, tables 2.9 to 2.11) ----

template <class Number>
struct LightState {
    using Vector4 = Vec4<Number>;
    bool enabled = false;
    Vector4 ambient{0, 0, 0, 1}, diffuse{0, 0, 0, 1}, specular{0, 0, 0, 1}, position_eye{0, 0, 1, 0};
    Vec3<Number> spot_direction_eye{0, 0, -1};
    Number exponent = 0, cutoff_deg = 180, k0 = 1, k1 = 0, k2 = 0;
};
template <class Number>
struct MaterialState {
    using Vector4 = Vec4<Number>;
    Vector4 ambient{Number(0.2), Number(0.2), Number(0.2), 1}, diffuse{Number(0.8), Number(0.8), Number(0.8), 1},
        specular{0, 0, 0, 1}, emission{0, 0, 0, 1};
    Number shininess = 0;
};

template <class Number>
class Machine {
    using Vector3 = Vec3<Number>;
    using Vector4 = Vec4<Number>;
    using Matrix3 = Mat3<Number>;
    using Matrix4 = Mat4<Number>;
    using Light = LightState<Number>;
    using Material = MaterialState<Number>;

  public:
    explicit Machine(const Options& options) : options_(options), random_(options.seed) {
        lights_[0].diffuse = lights_[0].specular = {1, 1, 1, 1};
    }

    void execute(const Command& command) {
        const Function& function = functions().at(static_cast<std::size_t>(command.id));
        if (!function) throw std::invalid_argument("the oracle does not know " + std::string(command.name()));
        function(*this, command);
    }
    std::vector<Vertex> take_vertices() { return std::move(vertices_); }
    // Whether a light and a vertex agree in so many digits that Exact has too few.
    bool agrees() const { return agrees_; }

  private:
    using Function = std::function<void(Machine&, const Command&)>;

    // ---- Rounding, for Options ----
    Number perturbed(const Number& x, double by) {
        if (by == 0) return x;
        return x * (1 + Number(by) * (static_cast<double>(random_() >> 11) * 0x1p-52 - 1));
    }
    bool rounds() const { return options_.matrix_rounding != 0 || options_.value_rounding != 0; }
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

    static constexpr double kFewDigits = 1e-25;  // of the 60 digits, 35 are left

    struct Towards {
        Vector3 dir{};
        Number distance = 0;
        bool is_infinite = false;
        Number uncertainty = 0;  // of the direction, from value_rounding
    };
    static Vector3 divided(const Vector4& p) { return p[3] == 1 ? xyz(p) : times(Number(1 / p[3]), xyz(p)); }
    static Number largest(const Vector3& v) {
        return std::max({Number(abs(v[0])), Number(abs(v[1])), Number(abs(v[2]))});
    }
    static double relative_to(const Vector4& p, const Number& distance) {
        const Number size = largest(divided(p));
        return size > 0 ? static_cast<double>(Number(distance / size)) : HUGE_VAL;
    }
    static Towards from_vector(const Vector3& v) {
        const Measured<Number> m = measured(v);
        return {m.dir, m.length};
    }
    // A difference of rounded numbers: where they may be equal, some are.
    Vector3 with_losses(Vector3 difference, const Vector3& a, const Vector3& b) {
        if (options_.value_rounding == 0) return difference;
        const Number share = 2 * Number(options_.value_rounding);
        for (std::size_t i = 0; i < 3; ++i) {
            const bool may_be_equal = abs(difference[i]) < share * std::max(Number(abs(a[i])), Number(abs(b[i])));
            if (may_be_equal && random_() % 2 == 0) difference[i] = 0;
        }
        return difference;
    }
    // The vector from p1 to p2, which are homogeneous: the unit vector, and its length before.
    Towards towards(const Vector4& p1, const Vector4& p2) {
        if (p1[3] != 0 && p2[3] != 0) {
            const Vector3 from = divided(p1), to = divided(p2);
            const Vector3 v = minus(to, from);
            agrees_ = agrees_ || largest(v) <= kFewDigits * std::max(largest(from), largest(to));
            if (options_.value_rounding == 0) return from_vector(v);
            // What rounding may add to each end.
            const Number share = 2 * Number(options_.value_rounding),
                         slack = share * std::max(length(from), length(to));
            Towards result = from_vector(with_losses(v, from, to));
            if (slack == 0 || result.distance == 0) return result;
            result.uncertainty = std::min(Number(slack / result.distance), Number(2));
            if (options_.border == Border::kInside)
                result.distance = std::max(Number(result.distance - slack), Number(0));
            if (options_.border == Border::kOutside) result.distance += slack;
            return result;
        }
        if (p1[3] == 0 && p2[3] == 0) return {unit(with_losses(minus(xyz(p2), xyz(p1)), xyz(p1), xyz(p2))), 0, true};
        if (p2[3] == 0) return {unit(xyz(p2)), 0, true};
        return {unit(negative(xyz(p1))), 0, true};
    }

    Number attenuation(const Light& light, const Towards& vp) {
        if (light.position_eye[3] == 0) return 1;
        // RULING: infinitely far from a positional light: the limit.
        if (vp.is_infinite) return light.k1 == 0 && light.k2 == 0 && light.k0 > 0 ? Number(1 / light.k0) : Number(0);
        const Number divisor =
            value(light.k0) + value(light.k1) * vp.distance + value(light.k2) * vp.distance * vp.distance;
        return divisor > 0 ? Number(1 / divisor) : Number(0);  // RULING: not positive
    }

    static Number power(const Number& base, const Number& exponent) {
        if (exponent == 0) return 1;  // 2.1.1
        return base > 0 ? Number(pow(base, exponent)) : Number(0);
    }

    // a >= b, where rounding may decide.
    bool is_border(const Number& difference, const Number& scale, const Number& uncertainty) const {
        return options_.border != Border::kExact && abs(difference) <= (options_.width + uncertainty) * scale;
    }
    bool reaches(const Number& a, const Number& b, const Number& scale, const Number& uncertainty) const {
        if (is_border(a - b, scale, uncertainty)) return options_.border == Border::kInside;
        return a >= b - Noise<Number>::kTie * scale;
    }

    Number spot(const Light& light, const Towards& vp) {
        if (light.cutoff_deg == 180) return 1;
        const Number cosine =
            std::max(Number(-dot(vp.dir, value(unit(light.spot_direction_eye)))), Number(0));  // the circled dot
        const Number cos_cutoff = cleaned(cosine_of(light.cutoff_deg));
        // Behind a cone of 90 degrees both are 0, whatever is rounded.
        if (cos_cutoff > 0 && !reaches(cosine, cos_cutoff, 1, vp.uncertainty)) return 0;
        return power(cosine, light.exponent);
    }

    // x as a double, and the rest.
    static void split(const Number& x, double& value, double& rest) {
        constexpr double kLargest = std::numeric_limits<double>::max();
        value = std::clamp(static_cast<double>(x), -kLargest, kLargest);
        rest = std::abs(value) < kLargest ? static_cast<double>(Number(x - value)) : 0;
    }

    Colors lit(const Vector4& v, const Vector3& n, const Material& material) {
        Vector3 primary = xyz(material.emission), secondary{}, magnitude{};
        const auto is_denormal = [](const Number& x) { return x > 0 && x < 0x1p-126; };
        bool has_denormal_power = false;
        const auto add = [&](Vector3& sum, const Number& factor, const Vector4& a, const Vector4& b) {
            for (std::size_t i = 0; i < 3; ++i) {
                if (a[i] == 0 || b[i] == 0) continue;  // `factor` may be infinite
                const Number term = factor * a[i] * b[i];
                sum[i] += term;
                magnitude[i] += abs(term);
                if (has_denormal_power) of_denormal_powers_ += static_cast<double>(Number(abs(term)));
            }
        };
        for (std::size_t i = 0; i < 3; ++i) magnitude[i] = abs(primary[i]);
        add(primary, 1, material.ambient, scene_ambient_);
        const Vector3 vpe = local_viewer_ ? value(towards(v, {0, 0, 0, 1}).dir) : Vector3{0, 0, 1};
        const Number scale = length(n);
        for (const Light& light : lights_) {
            if (!light.enabled) continue;
            Towards vp = towards(v, value_of_position(light.position_eye));
            if (vp.distance > 0) closest_light_ = std::min(closest_light_, relative_to(v, vp.distance));
            vp.dir = value(vp.dir);
            const Number cone = spot(light, vp), reach = attenuation(light, vp) * cone;
            has_denormal_power = is_denormal(cone);
            add(primary, reach, material.ambient, light.ambient);
            const Number n_dot_vp = dot(n, vp.dir);
            add(primary, reach * std::max(n_dot_vp, Number(0)), material.diffuse, light.diffuse);
            // f_i: n . VP is not 0, where . means max(..., 0).
            const bool behind = is_border(n_dot_vp, scale, vp.uncertainty) ? options_.border == Border::kOutside
                                                                           : n_dot_vp <= Noise<Number>::kTie * scale;
            if (behind) continue;
            const auto [h, size] = measured(plus(vp.dir, vpe));
            shortest_half_vector_ = std::min(shortest_half_vector_, static_cast<double>(size));
            const Number highlight = power(std::max(Number(dot(n, h)), Number(0)), material.shininess);
            has_denormal_power |= is_denormal(highlight);
            add(separate_ ? secondary : primary, reach * highlight, material.specular, light.specular);
        }
        Colors colors;
        for (std::size_t i = 0; i < 3; ++i) {
            split(primary[i], colors.primary[i], colors.primary_rest[i]);
            split(secondary[i], colors.secondary[i], colors.secondary_rest[i]);
            colors.magnitude[i] = static_cast<double>(magnitude[i]);
        }
        colors.primary[3] = static_cast<double>(material.diffuse[3]);
        return colors;
    }

    Vector4 value_of_position(const Vector4& p) {
        const Vector3 v = value(xyz(p));
        return {v[0], v[1], v[2], p[3]};
    }

    // The inverse of the matrix for normals; empty if it is singular.
    std::optional<Matrix3> inverse() {
        const Matrix4 m = modelview();
        const Matrix3 upper = {xyz(m[0]), xyz(m[1]), xyz(m[2])};
        if (is_singular(upper)) return std::nullopt;
        Matrix3 inverse = adjugate(upper);
        const Number factor = 1 / determinant(upper, inverse);
        for (Vector3& row : inverse) row = value(times(factor, row));
        return inverse;
    }

    Vector3 normal_eye() {
        if (!inverse_ || rounds()) inverse_ = inverse();
        if (!*inverse_) return {};  // RULING
        const Matrix3& by = **inverse_;
        Vector3 n{};  // a row vector times the inverse
        for (std::size_t j = 0; j < 3; ++j)
            for (std::size_t i = 0; i < 3; ++i) n[j] += normal_[i] * by[i][j];
        if (normalize_ || options_.unit_normals) return value(unit(n));
        if (rescale_) return times(Number(1 / length(by[2])), n);
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
        for (std::size_t i = 0; i < 4; ++i) result.position_eye[i] = static_cast<double>(v[i]);
        closest_light_ = HUGE_VAL;
        shortest_half_vector_ = 2;
        of_denormal_powers_ = 0;
        result.front = lit(v, n, materials_[0]);
        if (two_side_) result.back = lit(v, negative(n), materials_[1]);
        result.closest_light = closest_light_;
        result.shortest_half_vector = shortest_half_vector_;
        result.of_denormal_powers = of_denormal_powers_;
        vertices_.push_back(result);
    }

    // ---- Commands ----

    // Table 2.6: a component of a colour or normal given as an integer.
    static Number normalized(double c, Kind kind) {
        const auto number = [&](bool is_signed, int bits) {
            const Number most = std::ldexp(1.0, bits) - 1;
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
        Light& light = lights_.at(command.enumerant(0) - kGL_LIGHT0);
        const std::span<const double> values = std::span(command.arguments).subspan(2);
        switch (command.enumerant(1)) {
            case kGL_AMBIENT: light.ambient = vector4(values); break;
            case kGL_DIFFUSE: light.diffuse = vector4(values); break;
            case kGL_SPECULAR: light.specular = vector4(values); break;
            case kGL_POSITION: light.position_eye = transformed(modelview(), vector4(values)); break;
            case kGL_SPOT_DIRECTION: {
                const Matrix4 m = modelview();
                for (std::size_t i = 0; i < 3; ++i)
                    light.spot_direction_eye[i] = dot(xyz(m[i]), Vector3{values[0], values[1], values[2]});
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
            Material& m = materials_.at(i);
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
        if (!is_modelview_) return;  // projections do not change a vertex's light
        modelviews_.back() = m;
        inverse_.reset();
    }
    static Matrix4 matrix(std::span<const double> values, bool by_rows) {
        Matrix4 m{};
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j < 4; ++j) m[i][j] = values[by_rows ? 4 * i + j : 4 * j + i];
        return m;
    }

    // By CommandId; empty for those that the oracle does not know.
    static const std::vector<Function>& functions() {
        static const std::vector<Function> all = make_functions();
        return all;
    }
    static std::vector<Function> make_functions() {
        std::vector<Function> all(signatures().size());
        const auto set = [&](std::initializer_list<std::string_view> names, const Function& function) {
            for (const std::string_view name : names) all.at(static_cast<std::size_t>(*find_command(name))) = function;
        };
        set({"glShadeModel", "glEnd", "glClear", "glClearColor", "glDepthRange"}, [](Machine&, const Command&) {});
        set({"glFrustum", "glOrtho", "gluPerspective"}, [](Machine& m, const Command& c) {
            if (m.is_modelview_) throw std::invalid_argument(fmt::format("{} in the modelview matrix", c.name()));
        });
        set({"glMatrixMode"}, [](Machine& m, const Command& c) { m.is_modelview_ = c.enumerant(0) == kGL_MODELVIEW; });
        set({"glLoadIdentity"}, [](Machine& m, const Command&) { m.set_matrix(identity<Number>()); });
        set({"glLoadMatrixf", "glLoadMatrixd"},
            [](Machine& m, const Command& c) { m.set_matrix(matrix(c.arguments, false)); });
        set({"glLoadTransposeMatrixf", "glLoadTransposeMatrixd"},
            [](Machine& m, const Command& c) { m.set_matrix(matrix(c.arguments, true)); });
        set({"glMultMatrixf", "glMultMatrixd"},
            [](Machine& m, const Command& c) { m.multiply(matrix(c.arguments, false)); });
        set({"glMultTransposeMatrixf", "glMultTransposeMatrixd"},
            [](Machine& m, const Command& c) { m.multiply(matrix(c.arguments, true)); });
        set({"glTranslatef", "glTranslated"}, [](Machine& m, const Command& c) {
            m.multiply(translation(Vector3{c.number(0), c.number(1), c.number(2)}));
        });
        set({"glScalef", "glScaled"}, [](Machine& m, const Command& c) {
            Matrix4 t = identity<Number>();
            for (std::size_t i = 0; i < 3; ++i) t[i][i] = c.number(i);
            m.multiply(t);
        });
        set({"glRotatef", "glRotated"}, [](Machine& m, const Command& c) {
            m.multiply(rotation(Number(c.number(0)), Vector3{c.number(1), c.number(2), c.number(3)}));
        });
        set({"gluLookAt"}, [](Machine& m, const Command& c) {
            m.multiply(look_at<Number>(c.arguments));
            m.multiply(translation(Vector3{-c.number(0), -c.number(1), -c.number(2)}));
        });
        set({"glPushMatrix"}, [](Machine& m, const Command&) {
            if (m.is_modelview_) m.modelviews_.push_back(m.modelviews_.back());
        });
        set({"glPopMatrix"}, [](Machine& m, const Command&) {
            if (!m.is_modelview_) return;
            m.modelviews_.pop_back();
            m.inverse_.reset();
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
        for (std::size_t i = 0; i < all.size(); ++i) {
            const std::string_view name = signatures()[i].name;
            if (name.starts_with("glColor3") || name.starts_with("glColor4"))
                all[i] = [](Machine& m, const Command& c) { m.color(c); };
            if (name.starts_with("glNormal3")) all[i] = [](Machine& m, const Command& c) { m.normal(c); };
            if (name.starts_with("glVertex") && std::isdigit(name[8]) != 0)
                all[i] = [](Machine& m, const Command& c) { m.vertex(vector4(c.arguments)); };
        }
        return all;
    }

    const Options options_;
    std::mt19937_64 random_;
    bool is_modelview_ = true;
    std::vector<Matrix4> modelviews_{identity<Number>()};
    std::optional<std::optional<Matrix3>> inverse_;  // of the current matrix, if nothing is rounded
    std::array<Light, 8> lights_{};
    std::array<Material, 2> materials_{};  // front, back
    Vector4 scene_ambient_{Number(0.2), Number(0.2), Number(0.2), 1};
    double closest_light_ = HUGE_VAL, shortest_half_vector_ = 2, of_denormal_powers_ = 0;
    bool agrees_ = false;
    bool local_viewer_ = false, separate_ = false, two_side_ = false, normalize_ = false, rescale_ = false;
    bool color_material_ = false;
    Enum color_face_ = kGL_FRONT_AND_BACK, color_mode_ = kGL_AMBIENT_AND_DIFFUSE;
    Vector4 color_{1, 1, 1, 1};
    Vector3 normal_{0, 0, 1};
    std::vector<Vertex> vertices_;
};

template <class Number>
Machine<Number> executed(const CommandList& commands, const Options& options) {
    Machine<Number> machine(options);
    for (const Command& command : commands.commands) machine.execute(command);
    return machine;
}

}  // namespace

std::vector<Vertex> light(const CommandList& commands, const Options& options) {
    const bool rounds = options.matrix_rounding != 0 || options.value_rounding != 0;
    if (rounds) return executed<Rough>(commands, options).take_vertices();
    Machine<Exact> machine = executed<Exact>(commands, options);
    return machine.agrees() ? executed<Whole>(commands, options).take_vertices() : machine.take_vertices();
}

}  // namespace twinlight::oracle
