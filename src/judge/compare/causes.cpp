#include "judge/compare/causes.h"

#include <algorithm>
#include <memory>

#include "judge/compare/missing.h"
#include "judge/compare/rewrites.h"

namespace twinlight::compare {

namespace {

// The picture that the recording ends with.
Frame last_frame(const Recording& recording, const StateOptions& options) {
    State state(options);
    recording.for_each([&](const Step& step) {
        if (step.kind == Step::Kind::kFrameEnd) state.drop_picture();
        if (step.kind == Step::Kind::kCommand) state.apply(step.command);
        return true;
    });
    return state.take_frame();
}

// The scene as it is drawn without some bugs.
class WithoutBugs {
  public:
    WithoutBugs(const Scene& scene, const Trial& trial)
        : scene_(scene), trial_(trial), options_{.width = scene.frame.width, .height = scene.frame.height} {}

    Image picture(const std::vector<const Departure*>& bugs) const {
        return trial_.draw_fixed(with_commands(scene_, rewritten_for(bugs)));
    }
    bool is_right(const std::vector<const Departure*>& bugs) const {
        return trial_.is_right(picture(bugs)) && trial_.is_same(last_frame(*rewritten_for(bugs), options_));
    }
    // Whether the picture is the same without the bug, wherever it is wrong.
    bool is_as_wrong(const Departure& departure) const {
        const PixelMask changed = changed_pixels(trial_.fixed, picture({&departure}));
        for (std::size_t i = 0; i < changed.size(); ++i)
            if (changed[i] && trial_.differing[i]) return false;
        return true;
    }

  private:
    std::shared_ptr<const Recording> rewritten_for(const std::vector<const Departure*>& bugs) const {
        std::shared_ptr<const Recording> result = scene_.recording;
        for (const Departure* bug : bugs) result = rewritten(result, *bug->rewrite, options_);
        return result;
    }

    const Scene& scene_;
    const Trial& trial_;
    StateOptions options_;
};

}  // namespace

bool Causes::is_innocent(const Departure& departure) const {
    return std::ranges::find(innocent, &departure) != innocent.end();
}

Causes find_causes(const Scene& scene, const std::vector<const Departure*>& known, const Trial& trial) {
    const WithoutBugs without(scene, trial);
    Causes causes;
    std::vector<const Departure*> suspects = known;
    std::erase_if(suspects, [](const Departure* departure) { return departure->rewrite == nullptr; });
    const auto innocent = std::stable_partition(suspects.begin(), suspects.end(), [&](const Departure* suspect) {
        return !suspect->rewrite->is_whole || !without.is_as_wrong(*suspect);
    });
    causes.innocent.assign(innocent, suspects.end());
    suspects.erase(innocent, suspects.end());
    for (const Departure* suspect : suspects) {
        if (!without.is_right({suspect})) continue;
        causes.proved = {suspect};
        return causes;
    }
    if (suspects.size() < 2 || !without.is_right(suspects)) return causes;
    causes.proved = suspects;
    for (const Departure* suspect : suspects) {
        std::vector<const Departure*> others = causes.proved;
        std::erase(others, suspect);
        if (without.is_right(others)) causes.proved = others;
    }
    return causes;
}

}  // namespace twinlight::compare
