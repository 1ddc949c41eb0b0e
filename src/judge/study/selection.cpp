// Selects the choices of a study: every renderer with every shading and mesh, and then, at a medium mesh, one change at
// a time.
#include <algorithm>

#include "judge/study/choice.h"

namespace twinlight::study {

namespace {

constexpr int kQuickSlices[] = {8, 16, 32, 64};
constexpr int kFullSlices[] = {6, 8, 12, 16, 24, 32, 48, 64, 96, 128};
constexpr int kMiddleSlices = 32;
constexpr int kMostSamples = 4;  // samples of a choice along a pixel's side

class Choices {
  public:
    void add(Choice choice) {
        if (std::ranges::find(all_, choice) == all_.end()) all_.push_back(choice);
    }
    // The same choice with each number of slices.
    void add(Choice choice, const std::vector<int>& slices) {
        for (const int n : slices) {
            choice.slices = n;
            add(choice);
        }
    }
    std::vector<Choice> take() { return std::move(all_); }

  private:
    std::vector<Choice> all_;
};

}  // namespace

std::vector<Choice> select_choices(const Frame& frame, bool has_slices, Extent extent, int coverage) {
    using enum Method;
    const bool is_full = extent == Extent::kFull;
    std::vector<int> all_slices = {0}, some_slices = {0};
    if (has_slices && is_full) {
        all_slices.assign(std::begin(kFullSlices), std::end(kFullSlices));
        some_slices = {kMiddleSlices, all_slices.back()};
    } else if (has_slices) {
        all_slices.assign(std::begin(kQuickSlices), std::end(kQuickSlices));
        some_slices = {kMiddleSlices};
    }
    const int middle = has_slices ? kMiddleSlices : 0;

    Choices result;
    for (const Shading shading : {Shading::kFlat, Shading::kGouraud})
        for (const Method method : {kFixed, kUniforms, kConstants})
            result.add({.method = method, .shading = shading}, all_slices);
    for (const Method method : {kUniforms, kConstants, kReference})
        result.add({.method = method, .shading = Shading::kPhong}, all_slices);
    result.add({.method = kReference, .shading = Shading::kExact});
    const bool has_surfaces = std::ranges::any_of(frame.draws(), &Draw::has_exact_surfaces);
    if (has_surfaces)
        for (const Method method : {kUniforms, kConstants}) result.add({.method = method, .shading = Shading::kExact});

    if (std::ranges::any_of(frame.draws(), [](const Draw* draw) { return draw->lighting.enabled; }))
        result.add({.method = kPrecise}, is_full ? all_slices : some_slices);
    for (const LightingChangeRow& change : lighting_changes()) {
        if (change.value == LightingChange::kWhole || !matters(frame, change.value)) continue;
        for (const Shading shading : {Shading::kGouraud, Shading::kPhong})
            result.add({.method = kUniforms, .shading = shading, .slices = middle, .lighting_change = change.value});
    }
    for (const fixed::Sending sending :
         {fixed::Sending::kClientArrays, fixed::Sending::kImmediate, fixed::Sending::kDisplayList})
        result.add({.method = kFixed, .sending = sending}, some_slices);
    result.add({.method = kFixed, .target = Target::kFloats}, some_slices);
    for (const Shading shading : {Shading::kGouraud, Shading::kPhong})
        result.add({.method = kUniforms, .shading = shading, .target = Target::kFloats}, some_slices);
    if (has_surfaces) result.add({.method = kUniforms, .shading = Shading::kExact, .target = Target::kFloats});
    for (int samples = 2; samples <= std::min(coverage, kMostSamples); samples *= 2) {
        result.add({.method = kFixed, .samples = samples}, is_full ? all_slices : some_slices);
        result.add({.method = kUniforms, .shading = Shading::kPhong, .samples = samples},
                   is_full ? all_slices : some_slices);
        for (const Method method : {kUniforms, kReference})
            if (has_surfaces || method == kReference)
                result.add({.method = method, .shading = Shading::kExact, .samples = samples});
    }
    for (const Number number : {Number::kFloat, Number::kLongDouble})
        result.add({.method = kReference, .shading = Shading::kExact, .number = number});
    if (matters(frame, LightingChange::kNoSpecular))
        for (const Powers powers : {Powers::kSquaring, Powers::kTable})
            result.add({.method = kReference, .shading = Shading::kExact, .powers = powers});
    for (const double budget : {0.0, 4.0 / 255, 16.0 / 255})
        result.add({.method = kUniforms, .shading = Shading::kPhong, .slices = middle, .budget = budget});
    return result.take();
}

}  // namespace twinlight::study
