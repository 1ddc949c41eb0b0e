// Plans a Draw's lights: which are left out because they add nothing or little, and which effects the others need.
#include <fmt/format.h>

#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <numbers>
#include <utility>

#include "base/text/translation.h"
#include "lighting/real.h"
#include "render/effect/plan_parts.h"

namespace twinlight {
namespace {

constexpr double kSumUp = 1 + 1e-12;  // more than the rounding error of a sum of a few thousand numbers

// Adds to the sum: the product times any factor in [0, largest].
void add_term(ColorRange& sum, const ColorRange& product_range, double largest) {
    for (int c = 0; c < 3; ++c) {
        sum.low[c] += product(std::min(product_range.low[c], 0.0), largest);
        sum.high[c] += product(std::max(product_range.high[c], 0.0), largest);
    }
}

// A light with at least one term that is not 0.
struct Candidate {
    PlannedLight planned;
    LightEffects effects{};
    ColorRange range{};  // of what it adds to the visible faces
    std::size_t entry = 0;
};

class LightsPlanner {
  public:
    LightsPlanner(const LightsToPlan& given, Plan& plan)
        : given_(given), plan_(plan), face_count_(plan.effects.two_side ? 2 : 1) {}

    ColorRange run() {
        const LightSources& lights = plan_.lighting.lights;
        plan_.light_bounds.resize(lights.size());
        for (std::size_t i = 0; i < lights.size(); ++i) {
            plan_.light_bounds[i].number = static_cast<int>(i);
            if (lights[i].enabled) ++enabled_;
        }
        for (std::size_t i = 0; i < lights.size(); ++i)
            if (lights[i].enabled) plan_light(i);
        leave_out_the_faint();
        for (const Candidate& candidate : candidates_)
            if (plan_.light_bounds[candidate.entry].in()) take(candidate);
        return sum_;
    }

  private:
    // As a constant, so that the plan keeps sharing its lights with the Draw.
    const LightSource& source(std::size_t i) const { return std::as_const(plan_).lighting.lights[i]; }
    bool is_specular_separate() const {
        return plan_.lighting.light_model.color_control == kGL_SEPARATE_SPECULAR_COLOR;
    }
    bool is_unattenuated() const { return plan_.lighting.light_model.light_ambient == Word::unattenuated; }

    ColorRange product_with(const LightColor& light, const FaceRange& face, ColorRange FaceRange::*material) const {
        return product_of(plan_.lighting.light_model, light, face, material);
    }

    // Whether the light's colour times the material's is not black, on a visible face.
    bool meets(const LightColor& light, ColorRange FaceRange::*material) const {
        for (std::size_t face = 0; face < face_count_; ++face) {
            const ColorRange range = product_with(light, given_.faces[face], material);
            if (range.low != glm::dvec3(0) || range.high != glm::dvec3(0)) return true;
        }
        return false;
    }

    // Plans a light for any pose: its effects follow from its state, the materials and the colours of the vertices.
    void plan_light_for_any_pose(std::size_t number) {
        const LightSource& light = source(number);
        Candidate candidate{.planned = {.number = static_cast<int>(number)}, .entry = number};
        LightEffects& effects = candidate.effects;
        effects.meets_directions = meets_directions(light);
        effects.directional = light.is_directional() && !effects.meets_directions;
        effects.attenuated = light.is_attenuated();
        effects.cone = light.cone();
        if (effects.cone == SpotCone::kGl) effects.spot_exponent = power_of(light.spot_exponent);
        const bool ambient = given_.primary && meets(ambient_of(light), &FaceRange::ambient);
        effects.ambient = ambient && !is_unattenuated();
        effects.diffuse = given_.primary && meets(diffuse_of(light), &FaceRange::diffuse);
        effects.specular =
            (given_.primary || is_specular_separate()) && meets(specular_of(light), &FaceRange::specular);
        plan_.light_bounds[number].bound = glm::dvec3(std::numeric_limits<double>::infinity());
        const bool folded = ambient && is_unattenuated();
        if (folded) plan_.constant_ambient += glm::dvec3(light.ambient);
        decide(candidate, {}, folded, false);
    }

    bool meets_directions(const LightSource& light) const { return given_.has_directions && light.is_directional(); }

    void plan_light(std::size_t number) {
        if (given_.for_any_pose) return plan_light_for_any_pose(number);
        if (!meets_directions(source(number))) return plan_light(number, source(number));
        // Its direction depends on the vertex, like that of a positional light that nothing attenuates.
        LightSource positional = source(number);
        positional.position_eye.w = 1;
        positional.clear_attenuation();
        plan_light(number, positional);
    }

    void plan_light(std::size_t number, const LightSource& light) {
        Candidate candidate{.planned = {.number = static_cast<int>(number)}, .entry = number};
        LightEffects& effects = candidate.effects;
        effects.meets_directions = meets_directions(source(number));
        double& constant_reach = candidate.planned.constant_reach;
        effects.directional = light.is_directional();
        if (effects.directional) {
            constant_reach = directional_spot(light);
        } else {
            effects.attenuated = light.linear_attenuation != 0 || light.quadratic_attenuation != 0;
            if (!effects.attenuated)
                constant_reach = lighting::inverse_or_zero(light.constant_attenuation, lighting::Ruling::kAttenuation);
            effects.cone = light.cone();
            if (effects.cone == SpotCone::kGl) effects.spot_exponent = power_of(light.spot_exponent);
        }
        const bool reaches = constant_reach > 0;
        const bool ambient = given_.primary && meets(ambient_of(light), &FaceRange::ambient);
        effects.diffuse = given_.primary && reaches && meets(diffuse_of(light), &FaceRange::diffuse);
        effects.specular =
            (given_.primary || is_specular_separate()) && reaches && meets(specular_of(light), &FaceRange::specular);

        // The cheap bound first: a light fainter than its share of the budget is out, whatever the angles are.
        const double share = plan_.budget / static_cast<double>(enabled_) / kSumUp;
        LightFactors factors;
        bool within_share = false;
        const auto find_range = [&] {
            effects.ambient = reaches && ambient && !is_constant(effects);
            candidate.range = range_of(light, effects, factors);
            LightBound& entry = plan_.light_bounds[number];
            // If terms have different signs, the larger one counts, unless they go to different colours.
            const glm::dvec3 &low = candidate.range.low, &high = candidate.range.high;
            entry.bound = kSumUp * (is_specular_separate() ? high - low : glm::max(high, -low));
            return entry.largest();
        };
        const bool any = effects.diffuse || effects.specular || (ambient && reaches && !is_constant(effects));
        if (any) {
            factors = quick_factors(given_.bounds, light);
            within_share = find_range() <= share;
            if (!within_share) {
                factors = light_factors(given_.bounds, light, given_.faces, static_cast<int>(face_count_));
                // A cone that contains the whole Draw and does not fall off has no effect.
                if (effects.cone == SpotCone::kGl && effects.spot_exponent == Power::kZero && factors.cone_holds_all)
                    effects.cone = SpotCone::kNone;
                find_range();
            }
        }
        // An ambient term that nothing weakens is added to the scene's ambient light.
        const bool folded = ambient && (is_unattenuated() || (reaches && is_constant(effects)));
        if (folded) plan_.constant_ambient += (is_unattenuated() ? 1 : constant_reach) * glm::dvec3(light.ambient);
        decide(candidate, factors, folded, within_share);
    }

    bool is_constant(const LightEffects& effects) const {
        return is_unattenuated() || !(effects.attenuated || effects.cone != SpotCone::kNone);
    }

    void decide(const Candidate& candidate, const LightFactors& factors, bool folded, bool within_share) {
        LightBound& entry = plan_.light_bounds[candidate.entry];
        const LightEffects& effects = candidate.effects;
        const LightSource& light = source(candidate.entry);
        constexpr double kDegPerRad = 180 / std::numbers::pi;
        if (!effects.ambient && !effects.diffuse && !effects.specular) {
            const bool reaches = candidate.planned.constant_reach > 0;
            entry.fate = folded                   ? LightFate::kAmbientOnly
                         : !given_.primary        ? LightFate::kReplaced
                         : reaches                ? LightFate::kBlack
                         : light.is_directional() ? LightFate::kOutsideCone
                                                  : LightFate::kNoReach;
        } else if (entry.largest() == 0 && factors.cone_misses_by > 0) {
            entry.fate = LightFate::kConeMisses;
            entry.deg = factors.cone_misses_by * kDegPerRad;
        } else if (entry.largest() == 0 && factors.behind_by > 0) {
            entry.fate = LightFate::kBehind;
            entry.deg = factors.behind_by * kDegPerRad;
        } else if (within_share) {
            entry.fate = LightFate::kFaint;
            faint_ += entry.bound;
        } else {
            entry.fate = LightFate::kIn;
            candidates_.push_back(candidate);
        }
    }

    // What the light adds to the visible faces.
    ColorRange range_of(const LightSource& light, const LightEffects& effects, const LightFactors& factors) const {
        ColorRange whole;
        for (std::size_t face = 0; face < face_count_; ++face) {
            const FaceRange& materials = given_.faces[face];
            ColorRange sum;
            const double reach = factors.reach;
            if (effects.ambient) add_term(sum, product_with(ambient_of(light), materials, &FaceRange::ambient), reach);
            if (effects.diffuse)
                add_term(sum, product_with(diffuse_of(light), materials, &FaceRange::diffuse),
                         product(reach, factors.n_dot_vp[face]));
            if (effects.specular)
                add_term(sum, product_with(specular_of(light), materials, &FaceRange::specular),
                         product(reach, factors.highlight[face]));
            whole = {glm::min(whole.low, sum.low), glm::max(whole.high, sum.high)};
        }
        return whole;
    }

    // Leaves out more lights, the faintest first, while the sum of their bounds stays within the budget.
    void leave_out_the_faint() {
        std::vector<std::pair<double, std::size_t>> order;
        for (const Candidate& candidate : candidates_) {
            const double largest = plan_.light_bounds[candidate.entry].largest();
            if (largest <= plan_.budget) order.emplace_back(largest, candidate.entry);
        }
        std::sort(order.begin(), order.end());
        const auto error = [](const glm::dvec3& sum) { return kSumUp * std::max({sum.r, sum.g, sum.b}); };
        for (const auto& [largest, number] : order) {
            LightBound& entry = plan_.light_bounds[number];
            if (error(faint_ + entry.bound) > plan_.budget) break;
            faint_ += entry.bound;
            entry.fate = LightFate::kFaint;
        }
        plan_.error_bound = error(faint_);
    }

    void take(const Candidate& candidate) {
        if (plan_.has_reasons) note_what_it_lacks(candidate);
        plan_.lights.push_back(candidate.planned);
        plan_.effects.lights.push_back(candidate.effects);
        sum_ = {sum_.low + candidate.range.low, sum_.high + candidate.range.high};
    }

    // Why parts of a light that is in are left out.
    void note_what_it_lacks(const Candidate& candidate) {
        const LightSource& light = source(candidate.entry);
        const LightEffects& effects = candidate.effects;
        const auto note = [&](const char* what, std::string_view why, bool is_off = false) {
            plan_.leave_out(tr("{}'s {}", light_name(candidate.planned.number), tr(what)), why, is_off);
        };
        const double reach = candidate.planned.constant_reach;
        if (effects.directional || effects.meets_directions)
            note("attenuation", "the light is directional (its position has w = 0)", light.has_initial_attenuation());
        else if (!effects.attenuated)
            note("attenuation",
                 tr("its factors are {}, 0, 0, so it is {:.6g} at every vertex", light.constant_attenuation, reach),
                 light.has_initial_attenuation());
        if (!light.is_spot())
            note("cone", "GL_SPOT_CUTOFF is 180", true);
        else if (effects.directional)
            note("cone", tr("the light is directional, so its spot factor is {:.6g} everywhere", reach));
        else if (effects.cone == SpotCone::kNone)
            note("cone", "the whole draw is inside it, and GL_SPOT_EXPONENT is 0");
        if (effects.cone == SpotCone::kGl && effects.spot_exponent == Power::kZero)
            note("fall-off inside the cone", "GL_SPOT_EXPONENT is 0");
        if (!effects.ambient && meets(ambient_of(light), &FaceRange::ambient))
            note("ambient term", "it is the same at every vertex, so it is part of the scene's ambient light");
        else if (!effects.ambient)
            note("ambient term", "the light's ambient colour times the material's is 0");
        if (!effects.diffuse) note("diffuse term", "the light's diffuse colour times the material's is 0");
        if (!effects.specular) note("specular term", "the light's specular colour times the material's is 0");
    }

    const LightsToPlan& given_;
    Plan& plan_;
    const std::size_t face_count_;
    int enabled_ = 0;
    std::vector<Candidate> candidates_;
    glm::dvec3 faint_{0};  // the sum of the bounds of the faint lights
    ColorRange sum_;       // of what the kept lights add
};

}  // namespace

ColorRange plan_lights(const LightsToPlan& lights, Plan& plan) { return LightsPlanner(lights, plan).run(); }

std::vector<LeftOut> lights_left_out(const Plan& plan) {
    std::vector<LeftOut> left_out;
    for (const LightBound& light : plan.light_bounds)
        if (!light.in()) left_out.push_back({light_name(light.number), reason(light)});
    return left_out;
}

std::string reason(const LightBound& light) {
    const double largest = 255 * light.largest();
    const std::string amount = std::isfinite(largest) ? tr("at most {:.3g}/255", largest) : tr("an unknown amount");
    switch (light.fate) {
        case LightFate::kIn: return tr("it adds {} to a channel", amount);
        case LightFate::kDisabled: return tr("it is not enabled");
        case LightFate::kBlack: return tr("its colours times the material's are 0");
        case LightFate::kReplaced: return tr("the texture replaces the colours it would add");
        case LightFate::kAmbientOnly:
            return tr(
                "it has only an ambient term, the same at every vertex, which is part of the scene's ambient light");
        case LightFate::kOutsideCone: return tr("it is directional, and its direction is outside its cone");
        case LightFate::kNoReach: return tr("its attenuation factors are 0, 0, 0, so it adds nothing");
        case LightFate::kConeMisses:
            return tr("its cone misses the draw's bounding sphere by {:.3g} degrees", light.deg);
        case LightFate::kBehind: return tr("every normal faces away from it, by at least {:.3g} degrees", light.deg);
        case LightFate::kFaint: return tr("it would add {} to a channel", amount);
    }
    return "";
}

}  // namespace twinlight
