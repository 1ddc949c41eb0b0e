// The reference's equation (lighting/equation.h) in fifty digits, from the commands on, against the oracle in sixty. In doubles one
// colour in sixteen at the limits of floats is off for a reason with a name, always rounding. Here almost nothing rounds, so a mistake
// in a formula would show.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "../unit/effort.h"
#include "base/math/normal_matrix.h"
#include "judge/fuzz/against_oracle.h"
#include "judge/oracle/algebra.h"
#include "judge/oracle/oracle.h"
#include "lighting/equation.h"
#include "lighting/real_cast.h"
#include "render/reference/vertices/draw_lighting.h"
#include "scene/command/text.h"
#include "scene/state/state.h"

namespace twinlight {

namespace {

using Extended = oracle::Digits<50>;
// Coordinates from 1e-45 to 1e38, and their products with such matrices, span more digits than 60. This has all of them.
using oracle::Whole;

template <class Real>
struct ExtendedLimits {
    inline static const Real largest = std::numeric_limits<Real>::max();
    inline static const Real epsilon = std::numeric_limits<Real>::epsilon();
    inline static const Real big = ldexp(Real(1), 1 << 29), small = 1 / big;
    inline static const Real scale_up = ldexp(Real(1), 3 << 28), scale_down = 1 / scale_up;
};

}  // namespace

namespace lighting {

template <>
struct Limits<Extended> : ExtendedLimits<Extended> {};
template <>
struct Limits<Whole> : ExtendedLimits<Whole> {};

}  // namespace lighting

namespace {

// The lighting of a random scene, with all numbers from the commands on in Real.
template <class Real>
class Evaluation {
  public:
    explicit Evaluation(const CommandList& commands)
        : frame_(make_frame(commands, {.width = 64, .height = 64})), draw_(std::get<Draw>(frame_.items.back())) {
        positions_.fill({{0, 0, 1}, 0});
        spot_directions_.fill({0, 0, -1});
        for (const Command& command : commands.commands) execute(command);
    }

    const Draw& draw() const { return draw_; }

    lighting::Lit<Real> lit(const Vertex& vertex, reference::Face face) const {
        const Vec4 position = eye_from_object_ * vertex.position_object;
        const Vec far = lighting::unit(position.xyz) * lighting::Limits<Real>::big;
        const Vec normal = normal_eye(vertex.normal_object);
        const lighting::SurfacePoint<Real> surface{position.w == 0 ? far : position.xyz / position.w,
                                                   face == reference::Face::kFront ? normal : -normal};
        reference::StageVertex stage;
        stage.color = vertex.color;
        stage.material = vertex.material;
        const std::vector<lighting::Light<Real>> lights = lights_for(position);
        return lighting::light_surface<Real>(lighting::real_cast<Real>(lighting_.model()),
                                             lighting::real_cast<Real>(lighting_.material(stage, face)), surface,
                                             std::span<const lighting::Light<Real>>(lights));
    }

  private:
    using Vec = Vec3<Real>;
    struct Vec4 {
        Vec xyz;
        Real w;
    };
    struct Matrix {
        std::array<std::array<Real, 4>, 4> rows{};

        static Matrix identity() {
            Matrix m;
            for (std::size_t i = 0; i < 4; ++i) m.rows[i][i] = 1;
            return m;
        }
        Vec row(std::size_t i) const { return {rows[i][0], rows[i][1], rows[i][2]}; }
        friend Matrix operator*(const Matrix& a, const Matrix& b) {
            Matrix m;
            for (std::size_t i = 0; i < 4; ++i)
                for (std::size_t j = 0; j < 4; ++j)
                    for (std::size_t k = 0; k < 4; ++k) m.rows[i][j] += a.rows[i][k] * b.rows[k][j];
            return m;
        }
        friend Vec4 operator*(const Matrix& m, const glm::dvec4& v) {
            const auto product = [&](const std::array<Real, 4>& row) {
                return Real(row[0] * v.x + row[1] * v.y + row[2] * v.z + row[3] * v.w);
            };
            return {{product(m.rows[0]), product(m.rows[1]), product(m.rows[2])}, product(m.rows[3])};
        }
    };

    // ---- Matrices (2.11.2) ----

    static Real radians(double angle_deg) { return boost::math::constants::pi<Real>() * angle_deg / 180; }
    static Vec vec(const Command& c, std::size_t first) {
        return {c.number(first), c.number(first + 1), c.number(first + 2)};
    }

    // A right angle's cosine is 0.
    static Matrix rotation(double angle_deg, const Vec& axis) {
        const Vec u = lighting::unit(axis);
        const bool is_right = std::remainder(angle_deg, 90) == 0;
        const auto exact = [&](const Real& x) { return is_right ? Real(round(x)) : x; };
        const Real c = exact(cos(radians(angle_deg))), s = exact(sin(radians(angle_deg)));
        const std::array<Real, 3> a = {u.x, u.y, u.z};
        Matrix m = Matrix::identity();
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j) {
                m.rows[i][j] = (1 - c) * a[i] * a[j];
                m.rows[i][j] += i == j ? c : (j == (i + 1) % 3 ? Real(-s) : s) * a[3 - i - j];
            }
        return m;
    }
    static Matrix translation(const Vec& t) {
        Matrix m = Matrix::identity();
        m.rows[0][3] = t.x, m.rows[1][3] = t.y, m.rows[2][3] = t.z;
        return m;
    }
    static Matrix look_at(const Command& c) {
        const Vec eye = vec(c, 0), forward = lighting::unit(vec(c, 3) - eye);
        const Vec side = lighting::unit(cross(forward, vec(c, 6))), up = cross(side, forward);
        Matrix m = Matrix::identity();
        m.rows[0] = {side.x, side.y, side.z, 0};
        m.rows[1] = {up.x, up.y, up.z, 0};
        m.rows[2] = {-forward.x, -forward.y, -forward.z, 0};
        return m * translation(-eye);
    }

    // What makes eye coordinates in random scenes. The projection changes no light.
    void execute(const Command& c) {
        if (c.id == CommandId::glMatrixMode) is_modelview_ = c.enumerant(0) == kGL_MODELVIEW;
        if (!is_modelview_) return;
        switch (c.id) {
            case CommandId::glTranslatef: return multiply(translation(vec(c, 0)));
            case CommandId::glRotatef: return multiply(rotation(c.number(0), vec(c, 1)));
            case CommandId::gluLookAt: return multiply(look_at(c));
            case CommandId::glScalef: {
                Matrix scale = Matrix::identity();
                for (std::size_t i = 0; i < 3; ++i) scale.rows[i][i] = c.number(i);
                return multiply(scale);
            }
            case CommandId::glMultMatrixf: {
                Matrix by;
                for (std::size_t i = 0; i < 16; ++i) by.rows[i % 4][i / 4] = c.number(i);
                return multiply(by);
            }
            case CommandId::glLightfv: {
                const std::size_t light = c.enumerant(0) - kGL_LIGHT0;
                const auto value = [&](double w) { return glm::dvec4(c.number(2), c.number(3), c.number(4), w); };
                if (c.enumerant(1) == kGL_POSITION) positions_.at(light) = eye_from_object_ * value(c.number(5));
                if (c.enumerant(1) == kGL_SPOT_DIRECTION)
                    spot_directions_.at(light) = (eye_from_object_ * value(0)).xyz;
                return;
            }
            default: return;
        }
    }
    void multiply(const Matrix& by) { eye_from_object_ = eye_from_object_ * by; }

    // ---- Lighting ----

    // n M^-1 (2.11.3). RULING: 0 where the matrix is singular.
    Vec normal_eye(const glm::dvec3& normal_object) const {
        if (is_singular(glm::dmat3(draw_.eye_from_object))) return {};
        const Vec a = eye_from_object_.row(0), b = eye_from_object_.row(1), c = eye_from_object_.row(2);
        const Real determinant = dot(a, cross(b, c));
        const Vec n = vec3_cast<Vec>(normal_object);
        const std::array<Vec, 3> columns = {cross(b, c) / determinant, cross(c, a) / determinant,
                                            cross(a, b) / determinant};
        const Vec normal = {dot(n, columns[0]), dot(n, columns[1]), dot(n, columns[2])};
        if (draw_.lighting.normalize) return lighting::unit(normal);
        if (draw_.lighting.rescale_normal) return normal / length(Vec{columns[0].z, columns[1].z, columns[2].z});
        return normal;
    }

    // The enabled lights. For a vertex whose w is 0, directions and distances differ (DrawLighting::at).
    std::vector<lighting::Light<Real>> lights_for(const Vec4& vertex) const {
        std::vector<lighting::Light<Real>> lights;
        for (std::size_t i = 0; i < kMaxLights; ++i) {
            const LightSource& source = draw_.lighting.lights.at(i);
            if (!source.enabled) continue;
            auto light = lighting::real_cast<Real>(lighting_.lights()[lights.size()]);
            const Vec4& position = positions_.at(i);
            if (light.directional) {
                light.position_eye = lighting::unit(vertex.w == 0 ? position.xyz - vertex.xyz : position.xyz);
                light.half_dir_eye = lighting::unit(light.position_eye + Vec{0, 0, 1});
            } else {
                light.position_eye = position.xyz / position.w;
            }
            if (vertex.w == 0 && (source.linear_attenuation != 0 || source.quadratic_attenuation != 0))
                light.constant_attenuation = light.linear_attenuation = light.quadratic_attenuation = 0;
            light.spot_dir_eye = lighting::unit(spot_directions_.at(i));
            light.cos_cutoff = source.spot_cutoff_deg == 90 ? Real(0) : Real(cos(radians(source.spot_cutoff_deg)));
            lights.push_back(std::move(light));
        }
        return lights;
    }

    const Frame frame_;
    const Draw& draw_;
    const reference::DrawLighting lighting_{draw_, false};
    bool is_modelview_ = true;
    Matrix eye_from_object_ = Matrix::identity();
    std::array<Vec4, kMaxLights> positions_;
    std::array<Vec, kMaxLights> spot_directions_;
};

template <class Real>
std::array<Real, 6> channels(const lighting::Lit<Real>& lit) {
    return {lit.primary.x, lit.primary.y, lit.primary.z, lit.secondary.x, lit.secondary.y, lit.secondary.z};
}

// The largest difference of a channel, relative to the larger of 1 and the sum of the terms' magnitudes.
double error_of(const lighting::Lit<Extended>& lit, const oracle::Colors& right) {
    const std::array<Extended, 6> ours = channels(lit);
    double error = 0;
    for (std::size_t i = 0; i < ours.size(); ++i) {
        const double value = i < 3 ? right.primary.at(i) : right.secondary.at(i - 3);
        const double rest = i < 3 ? right.primary_rest.at(i) : right.secondary_rest.at(i - 3);
        const Extended off = abs(ours.at(i) - value - rest) / std::max(1.0, right.magnitude.at(i % 3));
        error = std::max(error, off.convert_to<double>());
    }
    return error;
}

struct Counts {
    int right = 0, at_borders = 0, of_more_digits = 0;
};

// Random states of one seed: those whose number is a multiple of `step`, which changes the structure often.
Counts judge(std::uint64_t seed, int states, std::uint64_t step) {
    constexpr double kBar = 1e-25, kTie = 1e-40;
    Counts counts;
    for (int i = 0; i < states; ++i) {
        const CommandList scene = fuzz::extreme_scene(seed, static_cast<std::uint64_t>(i) * step);
        std::vector<std::vector<oracle::Vertex>> answers;
        std::optional<Evaluation<Extended>> extended;
        try {
            extended.emplace(scene);
        } catch (const SceneError&) {  // a matrix or a light beyond the largest float
            continue;
        }
        for (const oracle::Border border : {oracle::Border::kExact, oracle::Border::kInside, oracle::Border::kOutside})
            answers.push_back(oracle::light(scene, {.border = border, .width = kTie}));
        for (std::size_t v = 0; v < answers[0].size(); ++v)
            for (const reference::Face face : {reference::Face::kFront, reference::Face::kBack}) {
                const bool back = face == reference::Face::kBack;
                if (back && !extended->draw().lighting.light_model.two_side) continue;
                const Vertex& vertex = extended->draw().vertices.at(v);
                const lighting::Lit<Extended> lit = extended->lit(vertex, face);
                const auto agrees = [&](const std::vector<oracle::Vertex>& answer) {
                    return error_of(lit, back ? answer.at(v).back : answer.at(v).front) <= kBar;
                };
                const oracle::Colors& right = back ? answers[0].at(v).back : answers[0].at(v).front;
                if (!std::ranges::all_of(right.magnitude, [](double x) { return x < 1e300; }) || agrees(answers[0])) {
                    ++counts.right;
                } else if (agrees(answers[1]) || agrees(answers[2])) {
                    ++counts.at_borders;
                } else {
                    // Fifty digits are too few where many more change the result.
                    const auto few = channels(lit);
                    const auto all = channels(Evaluation<Whole>(scene).lit(vertex, face));
                    double change = 0;
                    for (std::size_t c = 0; c < few.size(); ++c)
                        change = std::max(change, Whole(abs(all.at(c) - Whole(few.at(c)))).convert_to<double>());
                    EXPECT_GT(change, kBar) << "state " << i * step << " of seed " << seed << ", vertex " << v << ": "
                                            << few[0].str(20) << " for " << right.primary[0] << "\n"
                                            << print_scene(scene);
                    ++counts.of_more_digits;
                }
            }
    }
    return counts;
}

TEST(ExtendedPrecision, AgreesWithTheOracleInTwentyFiveDigits) {
    const Counts counts = judge(1, rounds(2000), 37);
    const int all = counts.right + counts.at_borders + counts.of_more_digits;
    EXPECT_GT(all, rounds(3000));
    EXPECT_LE(counts.at_borders, all / 100 + 2);
    EXPECT_LE(counts.of_more_digits, all / 200 + 2);
}

}  // namespace
}  // namespace twinlight
