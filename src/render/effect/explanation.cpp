#include "render/effect/explanation.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/common.hpp>
#include <map>

#include "base/text/input_text.h"
#include "base/text/translation.h"
#include "render/effect/surface_draw.h"

namespace twinlight {
namespace {

// The decisions of a plan, without its numbers.
std::string facts_of(const Plan& plan) {
    std::string text = describe(plan.effects);
    for (const LightBound& light : plan.light_bounds) text += fmt::format("{} ", static_cast<int>(light.fate));
    for (const LeftOut& left_out : plan.left_out) text += left_out.what + "\n" + left_out.why + "\n";
    return text;
}

// The whole explanation of a plan.
std::string text_of(const Plan& plan) {
    std::string text = facts_of(plan) + fmt::format("{:g}\n", plan.error_bound);
    for (const LightBound& light : plan.light_bounds) text += reason(light) + "\n";
    return text;
}

// Makes the plan's numbers hold for both plans.
void widen(Plan& plan, const Plan& other) {
    plan.error_bound = std::max(plan.error_bound, other.error_bound);
    for (std::size_t i = 0; i < plan.light_bounds.size(); ++i) {
        LightBound& light = plan.light_bounds[i];
        light.bound = glm::max(light.bound, other.light_bounds[i].bound);
        light.deg = std::min(light.deg, other.light_bounds[i].deg);
    }
}

// Takes the plans of a frame one after the other, and keeps only those that say something new: a frame may have 10,000 Draws.
class Explanation {
  public:
    void begin_shape() { end_shape(); }
    // Merges the parts of a shape that have the same facts.
    void add(int number, const Draw& draw, Plan plan) {
        const auto [known, is_new] = by_facts_.try_emplace(facts_of(plan), shape_.size());
        if (is_new)
            shape_.push_back({.numbers = {}, .place = draw.place, .plan = std::move(plan)});
        else
            widen(shape_[known->second].plan, plan);
        std::vector<int>& numbers = shape_[known->second].numbers;
        if (numbers.empty() || numbers.back() != number) numbers.push_back(number);
    }
    std::vector<ExplainedDraw> end() && {
        end_shape();
        return std::move(draws_);
    }

  private:
    void end_shape() {
        for (ExplainedDraw& part : shape_) {
            const auto [known, is_new] = by_text_.try_emplace(text_of(part.plan), draws_.size());
            if (is_new) {
                draws_.push_back(std::move(part));
            } else {
                std::vector<int>& numbers = draws_[known->second].numbers;
                numbers.insert(numbers.end(), part.numbers.begin(), part.numbers.end());
            }
        }
        shape_.clear();
        by_facts_.clear();
    }

    std::vector<ExplainedDraw> shape_, draws_;
    std::map<std::string, std::size_t> by_facts_, by_text_;  // indices of shape_ and of draws_
};

}  // namespace

std::vector<ExplainedDraw> explain_draws(const Frame& frame, const PlanOptions& options) {
    Explanation explanation;
    const Draw* last = nullptr;
    int number = 0;
    for (const Draw* draw : frame.draws()) {
        ++number;
        const bool begins_shape = !last || !are_one_shape(*last, *draw);
        last = draw;
        if (begins_shape) explanation.begin_shape();
        if (options.shading != Shading::kExact || !draw->has_exact_surfaces()) {
            explanation.add(number, *draw, plan_effects(*draw, options));
        } else if (begins_shape) {
            for (const SurfaceDraw& surface : surface_draws(*draw))
                explanation.add(number, *draw, plan_effects(surface.draw, options, surface.facts));
        }
    }
    return std::move(explanation).end();
}

double error_bound(const std::vector<ExplainedDraw>& draws) {
    double largest = 0;
    for (const ExplainedDraw& draw : draws) largest = std::max(largest, draw.plan.error_bound);
    return largest;
}

std::vector<ExplainedLights> explain_lights(const Plan& plan) {
    std::vector<ExplainedLights> rows;
    int first = 0;
    for (const LightBound& light : plan.light_bounds) {
        const std::string why = reason(light);
        if (!light.in() && !rows.empty() && rows.back().why == why) {
            rows.back().names = tr("{} to {}", light_name(first), light_name(light.number));
            continue;
        }
        first = light.number;
        rows.push_back({.names = light_name(first),
                        .in = light.in(),
                        .is_off = light.fate == LightFate::kDisabled,
                        .why = why,
                        .largest = light.largest()});
    }
    return rows;
}

EffectWords effect_words(const Plan& plan) {
    EffectWords words;
    InputText lines(describe(plan.effects));
    for (std::string line; std::getline(lines, line);) {
        const std::size_t colon = line.find(": ");
        if (line.starts_with("light ") && colon != line.npos)
            words.of_lights.push_back(line.substr(colon + 2));
        else
            words.of_draw.push_back(line);
    }
    return words;
}

std::vector<ExplainedEffect> explain_effects(const Plan& plan) {
    std::vector<ExplainedEffect> rows;
    const EffectWords words = effect_words(plan);
    std::size_t in = 0;
    for (const ExplainedLights& lights : explain_lights(plan))
        rows.push_back({lights.names, lights.in ? tr("{}: {}", words.of_lights.at(in++), lights.why) : lights.why,
                        lights.in, lights.is_off});
    for (const LeftOut& left_out : plan.left_out) rows.push_back({left_out.what, left_out.why, false, left_out.is_off});
    return rows;
}

std::string name_of(const ExplainedDraw& draw) {
    const std::string first = fmt::format("draw {}, {}", draw.numbers.front(), draw.place.str());
    return draw.numbers.size() == 1 ? first : fmt::format("{} draws, the first {}", draw.numbers.size(), first);
}

std::string in_codes(double error) { return error == 0 ? "0" : fmt::format("{:.3g}/255", 255 * error); }

}  // namespace twinlight
