#include "judge/fuzz/against_oracle.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <list>
#include <memory>
#include <new>
#include <optional>
#include <span>

#include "base/math/normal_matrix.h"
#include "judge/check/variants.h"
#include "judge/compare/shader_context.h"
#include "judge/compare/vertex_colors.h"
#include "judge/fuzz/random_states.h"
#include "judge/fuzz/shrink.h"
#include "judge/oracle/oracle.h"
#include "render/context/driver_name.h"
#include "render/effect/vertex_facts.h"
#include "render/lighting_of.h"
#include "render/programmable/numbers/wide_range.h"
#include "render/reference/reference.h"
#include "render/reference/vertices/lit_vertices.h"
#include "scene/command/text.h"

namespace twinlight::fuzz {
namespace {

// Scenes with one structure share programs. The structures of the first thousand scenes have few scenes each, later ones many.
std::uint64_t structure_of(std::uint64_t state) {
    return static_cast<std::uint64_t>(std::sqrt(static_cast<double>(state)));
}

// ---- What a number type can do ----

enum class NumberType : std::uint8_t { kDouble, kFloat, kShaderFloat };
struct Limits {
    double bar = 0;
    double cosines = 0;         // comparisons of cosines nearer than this are decided by rounding
    double value_rounding = 0;  // of each stored value
    double most = 0;            // the largest coordinate whose square is such a number
    bool flushes = false;       // denormals may be 0 (2.1.1)
};
Limits limits_of_type(NumberType type) {
    switch (type) {
        case NumberType::kDouble: return {1e-12, 1e-14, 0x1p-53, 1e150, false};
        case NumberType::kFloat: return {3e-5, 1e-6, 0x1p-24, 1e18, true};
        // The shaders take lengths beyond 1e18 apart before they square them.
        case NumberType::kShaderFloat: return {3e-5, 1e-6, 0x1p-24, 1e37, true};
    }
    return {};
}
Limits limits_of(NumberType type, double strictness) {
    Limits limits = limits_of_type(type);
    for (double* limit : {&limits.bar, &limits.cosines, &limits.value_rounding}) *limit /= strictness;
    return limits;
}
constexpr double kOfMatrices = 0x1p-53;  // all renderers multiply matrices in double

// ---- Verdicts ----

struct Verdict {
    std::string name;  // kRight, why the colour misses the bar, or one of the failures
    double error = 0;
    double condition = 0;  // if it is ill-conditioned: see OracleCounts::conditions
};

constexpr const char* kWrong = "wrong";
constexpr const char* kNotFinite = "not finite";
constexpr const char* kWorseThanFixed = "wrong where the fixed function is right";
constexpr const char* kBorder = "a border";
constexpr const char* kDenormals = "denormals";
constexpr const char* kBeyond = "coordinates beyond a float";
constexpr const char* kBeyondPowers = "a power beyond the largest float";
constexpr const char* kNearlyAgree = "a light and a vertex that nearly agree";
constexpr const char* kInterpolated = "a light nearer to a fragment than interpolation is exact";
constexpr const char* kOpposite = "opposite directions to light and viewer";
// 2.1.1 asks for colours up to 1024.
constexpr const char* kBeyondColors = "a colour beyond the largest float";

bool is_failure(std::string_view verdict) {
    return verdict == kWrong || verdict == kNotFinite || verdict == kWorseThanFixed;
}

// A colour of the renderers, and the face that shows it.
struct Shown {
    std::array<double, 3> primary{}, secondary{};
    bool is_clamped_sum = false;  // then `primary` is the sum of both colours, each clamped (2.14.6, 3.9)
};

double relative_error(double a, double b, double magnitude) {
    if (!std::isfinite(a)) return HUGE_VAL;
    return a == b ? 0 : std::abs(a - b) / std::max(1.0, magnitude);
}

double error_of(const Shown& shown, const oracle::Colors& right) {
    double error = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        if (shown.is_clamped_sum) {
            const double sum =
                std::clamp(std::clamp(right.primary[i], 0.0, 1.0) + std::clamp(right.secondary[i], 0.0, 1.0), 0.0, 1.0);
            error = std::max(error, relative_error(shown.primary[i], sum, right.magnitude[i]));
        } else {
            error = std::max({error, relative_error(shown.primary[i], right.primary[i], right.magnitude[i]),
                              relative_error(shown.secondary[i], right.secondary[i], right.magnitude[i])});
        }
    }
    return error;
}

bool is_beyond_colors(const oracle::Colors& colors) {
    return std::ranges::any_of(colors.magnitude, [](double magnitude) { return magnitude > 1e30; });
}

bool is_denormal(double x) { return x != 0 && std::abs(x) < 0x1p-126; }

// Whether the columns of the matrix for normals have sizes so different that one, as floats, is lost beside another.
bool differ_beyond_floats(const glm::dmat4& eye_from_object) {
    const glm::dmat3 normals = normal_matrix(glm::dmat3(eye_from_object));
    double smallest = HUGE_VAL, largest = 0;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) {
            const double size = std::abs(normals[column][row]);
            if (size > 0) smallest = std::min(smallest, size);
            largest = std::max(largest, size);
        }
    return largest > 0 && smallest < 1e-18 * largest;
}

const oracle::Colors& colors_of(const oracle::Vertex& vertex, bool back) { return back ? vertex.back : vertex.front; }

// A scene, and what the oracle says about it. Evaluations that only some scenes need are made when they are asked for, and kept.
class Judged {
  public:
    // Empty if no renderer shows the vertices, because their coordinates overflow.
    static std::optional<Judged> make(CommandList commands, double strictness) {
        std::string error;
        auto list = std::make_shared<const CommandList>(std::move(commands));
        std::optional<compare::VertexScene> scene = compare::make_vertex_scene(list, error);
        if (!scene) return std::nullopt;
        return Judged(std::move(list), std::move(*scene), strictness);
    }

    const compare::VertexScene& scene() const { return scene_; }
    const Draw& draw() const { return scene_.draw(); }
    const CommandList& commands() const { return *commands_; }
    std::size_t vertex_count() const { return scene_.lit.size(); }

    // `unit_normals`: as lighting per pixel has them.
    const oracle::Colors& right(std::size_t vertex, bool back, bool unit_normals) {
        return colors_of(evaluated({.unit_normals = unit_normals}).at(vertex), back);
    }

    Verdict verdict(const Shown& shown, std::size_t vertex, bool back, NumberType type, bool unit_normals) {
        const Limits limits = limits_of(type, strictness_);
        const oracle::Colors& exact = right(vertex, back, unit_normals);
        const double error = error_of(shown, exact);
        if (error <= limits.bar) return {kRight, error};
        if (is_beyond_colors(exact)) return {kBeyondColors, error};
        if (std::isinf(error)) return {kNotFinite, error};
        for (const oracle::Border border : kBorders) {
            const std::vector<oracle::Vertex>& other = evaluated({border, limits.cosines, 0, 0, 0, unit_normals});
            const oracle::Colors& moved = colors_of(other.at(vertex), back);
            if (error_of(shown, moved) <= limits.bar) return {kBorder, error};
            if (is_beyond_colors(moved)) return {kBeyondColors, error};
            // A light on the horizon may have a half vector or none.
            if (is_lost_with(other.at(vertex).shortest_half_vector, error, limits)) return {kOpposite, error};
            // So may one that the direction to a light so near does not know.
            const double uncertainty = kRoundings * limits.value_rounding / other.at(vertex).closest_light;
            if (other.at(vertex).shortest_half_vector < uncertainty) return {kOpposite, error};
        }
        // Random roundings of some sixteen values add up to a quarter of the worst. Beyond kLost no digit of the colour is known.
        constexpr double kOperations = 4, kLost = 0.01;
        const double enough = std::min(error / kOperations, kLost);
        const auto is_moved_within = [&](std::uint64_t tries) -> std::optional<Verdict> {
            const double moved = moved_by_rounding(vertex, back, limits, unit_normals, enough, tries);
            if (moved < enough) return std::nullopt;
            return Verdict{kIllConditioned, error, moved / (kRoundings * limits.value_rounding)};
        };
        // Most are moved by the first few. A narrow cone with a large exponent needs one direction of many.
        constexpr std::uint64_t kTries = 96, kMostTries = 2048;
        if (const auto moved = is_moved_within(kTries)) return *moved;
        if (const std::string why = reason(vertex, type, unit_normals); !why.empty()) return {why, error};
        return is_moved_within(kMostTries).value_or(Verdict{kWrong, error});
    }

    // Empty if the driver does not show the vertex.
    const compare::Color& fixed(std::size_t vertex) {
        if (fixed_.empty()) fixed_ = compare::fixed_colors(scene_);
        return fixed_.at(vertex);
    }

  private:
    static constexpr std::array<oracle::Border, 3> kBorders = {oracle::Border::kExact, oracle::Border::kInside,
                                                               oracle::Border::kOutside};

    Judged(std::shared_ptr<const CommandList> commands, compare::VertexScene scene, double strictness)
        : commands_(std::move(commands)), scene_(std::move(scene)), strictness_(strictness) {}

    const std::vector<oracle::Vertex>& evaluated(oracle::Options options) {
        options.unit_normals = options.unit_normals && !draw().lighting.normalize;  // which has them anyway
        for (const auto& [known, vertices] : evaluations_)
            if (known == options) return vertices;
        evaluations_.push_back({options, oracle::light(*commands_, options)});
        return evaluations_.back().second;
    }

    // Whether a half vector of this length loses as much as the error. Its cosine is off by some roundings over its length, and the
    // power by the exponent times that; a half vector of nearly 0 may point anywhere.
    bool is_lost_with(double half_vector, double error, const Limits& limits) const {
        constexpr double kOperations = 64;
        const LightingState& lighting = draw().lighting;
        const double exponent = std::max({lighting.front.shininess, lighting.back.shininess, 1.0});
        return half_vector < 8 * limits.cosines || error * half_vector < kOperations * limits.value_rounding * exponent;
    }

    static constexpr double kRoundings = 4;  // each value passes through some operations before it is used

    // How far rounding moves the exact result, relative to the larger of 1 and the magnitude. Asks often, because a border may need
    // one sign of many, until the move is `enough`.
    double moved_by_rounding(std::size_t vertex, bool back, const Limits& limits, bool unit_normals, double enough,
                             std::uint64_t tries) {
        const oracle::Colors& exact = right(vertex, back, unit_normals);
        double most = 0;
        for (std::uint64_t seed = 1; seed <= tries; ++seed) {
            const std::vector<oracle::Vertex>& other =
                evaluated({kBorders.at(seed % kBorders.size()), limits.cosines, kRoundings * kOfMatrices,
                           kRoundings * limits.value_rounding, seed, unit_normals});
            const oracle::Colors& moved = colors_of(other.at(vertex), back);
            for (std::size_t i = 0; i < 3; ++i) {
                const double move =
                    std::abs(moved.primary[i] - exact.primary[i]) + std::abs(moved.secondary[i] - exact.secondary[i]);
                most = std::max(most, move / std::max(1.0, exact.magnitude[i]));
            }
            if (most >= enough) return most;
        }
        return most;
    }

    // Why floats or doubles cannot give the answer, seen from the state; empty if they can.
    // `per_pixel`: coordinates were interpolated, so that not even equal ones agree.
    std::string reason(std::size_t vertex, NumberType type, bool per_pixel) {
        const Limits limits = limits_of(type, strictness_);
        const oracle::Vertex& exact = evaluated({}).at(vertex);
        // A light so near that their places are equal in doubles.
        bool cancels = exact.closest_light < 0x1p-45;
        bool beyond = false, wide = false, interpolated = false;
        bool denormal = exact.of_denormal_powers > limits.bar / 10;
        const auto look_at = [&](const auto& v, double w) {
            for (int i = 0; i < 3; ++i) {
                const double x = v[static_cast<std::size_t>(i)];
                beyond |= !(std::abs(w == 0 ? x : x / w) < limits.most);
                denormal |= is_denormal(x) || (w != 0 && is_denormal(x / w));
            }
            denormal |= is_denormal(w);
        };
        const auto look_at_normal = [&](const glm::dvec3& n) {
            for (int i = 0; i < 3; ++i) denormal |= is_denormal(n[i]);
        };
        look_at(exact.position_eye, exact.position_eye[3]);
        look_at(exact.position_eye, 1);  // before the division
        const glm::dvec4& object = draw().vertices.at(vertex).position_object;
        look_at(std::array{object.x, object.y, object.z}, 1);
        look_at(std::array{object.x, object.y, object.z}, object.w);
        denormal |= is_denormal(object.w);
        look_at_normal(draw().vertices.at(vertex).normal_object);
        const glm::dmat3 normals = normal_matrix(glm::dmat3(draw().eye_from_object));
        look_at_normal(normals * draw().vertices.at(vertex).normal_object);
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 3; ++row) {
                const double element = draw().eye_from_object[column][row];
                beyond |= !(std::abs(element) < limits.most);
                denormal |= is_denormal(element);
            }
        // Shaders scale positions so that their largest coordinate is about 1.
        denormal |= object.w != 0 &&
                    std::abs(object.w) < 1e-37 * std::max({std::abs(object.x), std::abs(object.y), std::abs(object.z)});
        for (const LightSource& light : draw().lighting.lights) {
            if (!light.enabled) continue;
            const glm::dvec4& p = light.position_eye;
            look_at(std::array{p.x, p.y, p.z}, p.w);
            for (const double k : {light.constant_attenuation, light.linear_attenuation, light.quadratic_attenuation})
                denormal |= is_denormal(k);
            // A vertex and a light that are directions differ as two places do; other directions stand for themselves.
            const bool directions = p.w == 0;
            if (directions && exact.position_eye[3] != 0) continue;
            const double vertex_w = directions ? 1 : exact.position_eye[3], light_w = directions ? 1 : p.w;
            double distance = 0, size = 0;
            for (std::size_t i = 0; i < 3; ++i) {
                const double v = exact.position_eye[i] / vertex_w, l = p[static_cast<int>(i)] / light_w;
                distance = std::max(distance, std::abs(v - l));
                denormal |= is_denormal(v - l);
                size = std::max({size, std::abs(v), std::abs(l)});
            }
            interpolated |= per_pixel && distance < 0x1p-18 * size;
            if (directions) continue;
            denormal |= is_denormal(lighting::attenuation_denominator(lighting_of(light), distance));
            // The reference in floats starts from eye coordinates; all others take the difference in doubles, or of object coordinates.
            cancels |= distance > 0 && distance < (type == NumberType::kFloat ? 0x1p-16 : 0x1p-45) * size;
            wide |= !(distance > 0x1p-8 * size) || !(size < 1e9) || !(size > 1e-9);
        }
        const LightingState& lighting = draw().lighting;
        double normal = glm::length(normals * draw().vertices.at(vertex).normal_object);
        if (lighting.rescale_normal && !lighting.normalize) normal /= glm::length(normals[2]);
        const double shininess = std::max(lighting.front.shininess, lighting.back.shininess);
        const double largest_power = limits.flushes ? 1e30 : 1e300;
        if (!lighting.normalize && !per_pixel && std::pow(normal, shininess) > largest_power) return kBeyondPowers;
        if (type == NumberType::kFloat && exact.position_eye[3] == 0) return "a vertex in a direction";
        if (interpolated) return kInterpolated;
        if (cancels) return kNearlyAgree;
        if (beyond) return kBeyond;
        if (limits.flushes && denormal) return kDenormals;
        if (type == NumberType::kShaderFloat && differ_beyond_floats(draw().eye_from_object))
            return "a matrix whose columns differ beyond a float";
        if (type == NumberType::kShaderFloat && wide && is_singular(glm::dmat3(draw().eye_from_object)))
            return "a wide range under a flattening matrix";
        return "";
    }

    std::shared_ptr<const CommandList> commands_;
    compare::VertexScene scene_;
    double strictness_;
    std::list<std::pair<oracle::Options, std::vector<oracle::Vertex>>> evaluations_;
    std::vector<compare::Color> fixed_;
};

// ---- The renderers ----

constexpr const char* kReference = "reference, ";
constexpr const char* kShaders = "shaders, ";

// A colour that misses the bar without a name.
struct Miss {
    std::string who, verdict, what;
    double error = 0;
};

template <class Color>
std::string in_words(const Color& c) {
    return fmt::format("({:.9g}, {:.9g}, {:.9g})", c[0], c[1], c[2]);
}

std::array<double, 3> rgb_of(const glm::dvec4& c) { return {c.r, c.g, c.b}; }

class OracleRun {
  public:
    OracleRun(const OracleOptions& options, const OracleProgress& progress) : options_(options), progress_(progress) {}

    OracleSummary run() {
        const std::uint64_t end = options_.first + options_.count;
        renew_context();
        for (std::uint64_t state = options_.first; state < end && !stops();) {
            if (summary_.states / kStatesPerContext != batch_states_ / kStatesPerContext) renew_context();
            batch_states_ = summary_.states;
            const std::uint64_t begin = state;
            while (state < end && state - begin < kMostInBatch && structure_of(state) == structure_of(begin)) ++state;
            compare_batch(begin, state);
            show(state - options_.first);
        }
        summary_.broken_off = stops();
        return std::move(summary_);
    }

  private:
    static constexpr std::uint64_t kMostInBatch = 256, kStatesPerContext = 4096;

    bool stops() const { return progress_.stop() || summary_.failures.size() >= options_.most_failures; }
    void show(std::uint64_t done, const char* doing = nullptr) {
        if (progress_.show) progress_.show(done, summary_, doing);
    }

    // A context keeps all its programs, so it is replaced from time to time.
    void renew_context() {
        context_.emplace(compare::kShaderPicture, compare::kShaderPicture, ColorBuffer::kFloat);
        context_->make_current();
        if (options_.shaders) shader_variants_ = check::shader_variants();
        summary_.driver = driver_name();
    }

    bool is_baked(const check::ShaderVariant& variant) const {
        return variant.options.tier == programmable::Tier::kBaked;
    }

    void compare_batch(std::uint64_t begin, std::uint64_t end) {
        std::vector<std::uint64_t> numbers;
        std::vector<Judged> scenes;
        for (std::uint64_t state = begin; state < end; ++state) {
            ++summary_.states;
            std::optional<Judged> scene = Judged::make(extreme_scene(options_.seed, state), options_.strictness);
            if (!scene) {
                ++summary_.out_of_view;
                continue;
            }
            numbers.push_back(state);
            scenes.push_back(std::move(*scene));
        }
        std::vector<std::vector<Miss>> misses(scenes.size());
        for (std::size_t i = 0; i < scenes.size(); ++i)
            for (const check::ReferenceVariant& variant : reference_variants_)
                judge_reference(scenes[i], variant, misses[i]);
        for (const check::ShaderVariant& variant : shader_variants_) {
            std::vector<std::size_t> drawn;
            for (std::size_t i = 0; i < scenes.size(); ++i)
                if (!is_baked(variant) || numbers[i] % options_.baked_every == 0) drawn.push_back(i);
            judge_shaders(scenes, drawn, variant, misses);
        }
        for (std::size_t i = 0; i < scenes.size() && !stops(); ++i)
            if (!misses[i].empty()) fail(numbers[i], scenes[i], misses[i].front());
    }

    void note(const std::string& who, const Verdict& verdict, const Shown& shown, const oracle::Colors& right,
              std::vector<Miss>& misses) {
        constexpr double kInfinite = 1e99;
        OracleCounts& counts = summary_.counts[who];
        const auto& [name, error, condition] = verdict;
        if (!is_shrinking_) {
            ++counts.verdicts[name];
            if (name == kRight) counts.worst_right = std::max(counts.worst_right, error);
            if (condition > 0)
                ++counts.conditions[static_cast<int>(std::floor(std::log10(std::min(condition, kInfinite))))];
        }
        if (!is_failure(name)) return;
        std::string both = in_words(right.primary);
        if (right.secondary != std::array<double, 3>{}) both += " + " + in_words(right.secondary);
        misses.push_back(
            {who, name,
             fmt::format("{} is {}: {} for {}, off by {:.1e}", who, name, in_words(shown.primary), both, error),
             error});
    }

    void judge_reference(Judged& scene, const check::ReferenceVariant& variant, std::vector<Miss>& misses) {
        const NumberType type =
            variant.options.arithmetic.number == Number::kFloat ? NumberType::kFloat : NumberType::kDouble;
        reference::Options options = variant.options;
        options.lecture_variants = false;
        const std::vector<reference::LitVertex> lit = reference::light_vertices(scene.draw(), options, false);
        for (std::size_t vertex = 0; vertex < lit.size(); ++vertex) {
            for (const bool back : {false, true}) {
                if (back && !scene.draw().lighting.light_model.two_side) continue;
                const reference::LitVertex& v = lit[vertex];
                const Shown shown{rgb_of(back ? v.back_primary : v.front_primary),
                                  rgb_of(back ? v.back_secondary : v.front_secondary)};
                const Verdict verdict = scene.verdict(shown, vertex, back, type, false);
                note(kReference + variant.name, verdict, shown, scene.right(vertex, back, false), misses);
            }
        }
    }

    // `drawn`: indices into `scenes`.
    void judge_shaders(std::vector<Judged>& scenes, std::span<const std::size_t> drawn,
                       const check::ShaderVariant& variant, std::vector<std::vector<Miss>>& misses) {
        if (drawn.empty()) return;
        std::vector<std::optional<compare::VertexScene>> vertex_scenes;
        for (const std::size_t i : drawn) vertex_scenes.push_back(scenes[i].scene());
        // Some drivers are wrong about the faces of polygons drawn as points, so they draw points, which show the front.
        const bool knows_faces = compare::knows_faces_of_corners();
        for (std::optional<compare::VertexScene>& scene : vertex_scenes)
            if (!knows_faces) std::get<Draw>(scene->scene.frame.items.back()).mode = kGL_POINTS;
        programmable::Options options = variant.options;
        options.lecture_variants = false;
        options.reasons = false;
        const bool unit_normals = options.shading == Shading::kPhong;
        const std::vector<std::vector<compare::Color>> colors =
            compare::shader_colors(vertex_scenes, context_->shaders(), options);
        for (std::size_t d = 0; d < drawn.size(); ++d) {
            Judged& scene = scenes[drawn[d]];
            const bool back = knows_faces && scene.scene().shows_back();
            for (std::size_t vertex = 0; vertex < scene.vertex_count(); ++vertex) {
                const compare::Color& color = colors[d].at(vertex);
                // Flat shading shows the colour of the last vertex everywhere (2.14.7).
                const bool flat = options.shading == Shading::kFlat && knows_faces;
                if (!color || (flat && vertex + 1 < scene.vertex_count())) continue;
                const Shown shown{rgb_of(*color), {}, true};
                Verdict verdict = scene.verdict(shown, vertex, back, NumberType::kShaderFloat, unit_normals);
                if (knows_faces && is_worse_than_fixed(scene, vertex, back, unit_normals, verdict.name))
                    verdict.name = kWorseThanFixed;
                note(kShaders + variant.name, verdict, shown, scene.right(vertex, back, unit_normals),
                     misses[drawn[d]]);
            }
        }
    }

    // Whether the driver's fixed function is right where shaders miss the bar. Where rounding decides, either may be lucky.
    bool is_worse_than_fixed(Judged& scene, std::size_t vertex, bool back, bool unit_normals,
                             const std::string& verdict) {
        for (const char* decided_by_rounding : {kBorder, kOpposite, kIllConditioned, kBeyondColors, kDenormals, kBeyond,
                                                kInterpolated, kNearlyAgree, kBeyondPowers})
            if (verdict == decided_by_rounding) return false;
        if (verdict == kRight || is_failure(verdict)) return false;
        if (unit_normals && !scene.draw().lighting.normalize) return false;  // another equation
        if (scene.draw().lighting.light_model.color_control != kGL_SINGLE_COLOR)
            return false;  // feedback has no secondary
        const compare::Color& fixed = scene.fixed(vertex);
        if (!fixed) return false;
        Shown shown{rgb_of(glm::clamp(*fixed, 0.0, 1.0)), {}, true};
        for (std::size_t i = 0; i < 3; ++i)
            if (std::isnan((*fixed)[static_cast<int>(i)])) return false;
        return error_of(shown, scene.right(vertex, back, unit_normals)) <= limits_of(NumberType::kShaderFloat, 1).bar;
    }

    // The same renderer's misses in another scene.
    std::vector<Miss> misses_of(const CommandList& commands, const std::string& who) {
        std::optional<Judged> made;
        try {
            made = Judged::make(commands, options_.strictness);
        } catch (const std::bad_alloc&) {
            throw;
        } catch (const std::exception&) {
            return {};
        }
        if (!made) return {};
        std::vector<Judged> scenes;
        scenes.push_back(std::move(*made));
        std::vector<std::vector<Miss>> misses(1);
        const std::size_t first = 0;
        for (const check::ReferenceVariant& variant : reference_variants_)
            if (who == kReference + variant.name) judge_reference(scenes.front(), variant, misses.front());
        for (const check::ShaderVariant& variant : shader_variants_)
            if (who == kShaders + variant.name) judge_shaders(scenes, {&first, 1}, variant, misses);
        return misses.front();
    }

    void fail(std::uint64_t state, const Judged& scene, const Miss& miss) {
        OracleFailure failure;
        failure.state = state;
        failure.who = miss.who;
        failure.what = miss.what;
        failure.driver = summary_.driver;
        failure.commands_before = scene.commands().commands.size();
        failure.scene = scene.commands();
        if (options_.shrinks_after(summary_.failures.size())) {
            show(state - options_.first, "shrinking");
            is_shrinking_ = true;
            constexpr double kAlike = 8;  // a difference of a very different size has another cause
            const auto first_of = [&](const CommandList& commands) -> std::optional<Miss> {
                for (Miss& again : misses_of(commands, miss.who))
                    if (again.verdict == miss.verdict && !(again.error > kAlike * miss.error) &&
                        !(miss.error > kAlike * again.error))
                        return std::move(again);
                return std::nullopt;
            };
            failure.scene = shrink(
                scene.commands(), [&](const CommandList& smaller) { return first_of(smaller).has_value(); }, 1000);
            if (const std::optional<Miss> smallest = first_of(failure.scene)) failure.what = smallest->what;
            is_shrinking_ = false;
        }
        if (progress_.found) progress_.found(failure);
        summary_.failures.push_back(std::move(failure));
    }

    const OracleOptions& options_;
    const OracleProgress& progress_;
    std::optional<compare::ShaderContext> context_;
    const std::vector<check::ReferenceVariant> reference_variants_ =
        options_.reference ? check::reference_variants() : std::vector<check::ReferenceVariant>();
    std::vector<check::ShaderVariant> shader_variants_;
    OracleSummary summary_;
    std::uint64_t batch_states_ = 0;
    bool is_shrinking_ = false;  // then nothing is counted
};

}  // namespace

CommandList extreme_scene(std::uint64_t seed, std::uint64_t state) {
    CommandList scene = extreme_state({Random(seed * 0xD1342543DE82EF95ULL + structure_of(state)).next(),
                                       Random(~seed * 0xD1342543DE82EF95ULL + state).next()});
    scene.name = fmt::format("oracle-{}-{}", seed, state);
    return scene;
}

std::string failure_text(const OracleFailure& failure, std::uint64_t seed) {
    return fmt::format("// twinlight fuzz --against oracle --seed {} --first {} --count 1\n// {}\n// on {}\n", seed,
                       failure.state, failure.what, failure.driver) +
           print_scene(failure.scene);
}

long OracleCounts::compared() const {
    long all = 0;
    for (const auto& [verdict, count] : verdicts) all += count;
    return all;
}

OracleSummary run_against_oracle(const OracleOptions& options, const OracleProgress& progress) {
    return OracleRun(options, progress).run();
}

}  // namespace twinlight::fuzz
