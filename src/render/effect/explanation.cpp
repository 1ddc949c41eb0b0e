#include "render/effect/explanation.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/common.hpp>
#include <map>

#include "base/text/input_text.h"
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

// Merges the parts of a shape that have the same facts.
std::vector<ExplainedDraw> explain_shapes(std::vector<PlannedDraw> plans) {
    std::vector<ExplainedDraw> draws;
    std::map<std::string, std::size_t> of_shape;  // by facts
    int last = 0;
    for (PlannedDraw& planned : plans) {
        if (planned.begins_shape && planned.number != last) of_shape.clear();
        last = planned.number;
        const auto [known, is_new] = of_shape.try_emplace(facts_of(planned.plan), draws.size());
        if (is_new)
            draws.push_back({.numbers = {}, .place = planned.place, .plan = std::move(planned.plan)});
        else
            widen(draws[known->second].plan, planned.plan);
        std::vector<int>& numbers = draws[known->second].numbers;
        if (numbers.empty() || numbers.back() != planned.number) numbers.push_back(planned.number);
    }
    return draws;
}

std::vector<PlannedDraw> plan_frame(const Frame& frame, const PlanOptions& options) {
    std::vector<PlannedDraw> plans;
    const Draw* last = nullptr;
    int number = 0;
    for (const Draw* draw : frame.draws()) {
        ++number;
        const bool begins_shape = !last || !are_one_shape(*last, *draw);
        last = draw;
        const auto add = [&](Plan plan) { plans.push_back({number, draw->place, begins_shape, std::move(plan)}); };
        if (options.shading != Shading::kExact || !draw->has_exact_surfaces()) {
            add(plan_effects(*draw, options));
        } else if (begins_shape) {
            for (const SurfaceDraw& surface : surface_draws(*draw))
                add(plan_effects(surface.draw, options, surface.facts));
        }
    }
    return plans;
}

}  // namespace

std::vector<ExplainedDraw> explain_draws(std::vector<PlannedDraw> plans) {
    std::vector<ExplainedDraw> draws;
    std::map<std::string, std::size_t> by_text;
    for (ExplainedDraw& shape : explain_shapes(std::move(plans))) {
        const auto [known, is_new] = by_text.try_emplace(text_of(shape.plan), draws.size());
        if (is_new) {
            draws.push_back(std::move(shape));
        } else {
            std::vector<int>& numbers = draws[known->second].numbers;
            numbers.insert(numbers.end(), shape.numbers.begin(), shape.numbers.end());
        }
    }
    return draws;
}

std::vector<ExplainedDraw> explain_draws(const Frame& frame, const PlanOptions& options) {
    return explain_draws(plan_frame(frame, options));
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
            rows.back().names = light_name(first) + " to " + light_name(light.number);
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
        rows.push_back({lights.names, lights.in ? words.of_lights.at(in++) + ": " + lights.why : lights.why, lights.in,
                        lights.is_off});
    for (const LeftOut& left_out : plan.left_out) rows.push_back({left_out.what, left_out.why, false, left_out.is_off});
    return rows;
}

std::string name_of(const ExplainedDraw& draw) {
    const std::string first = fmt::format("draw {}, {}", draw.numbers.front(), draw.place.str());
    return draw.numbers.size() == 1 ? first : fmt::format("{} draws, the first {}", draw.numbers.size(), first);
}

std::string in_codes(double error) { return error == 0 ? "0" : fmt::format("{:.3g}/255", 255 * error); }

}  // namespace twinlight
