// What a study draws with, and on which machine.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "judge/study/spectral.h"
#include "judge/study/study.h"
#include "render/context/context.h"
#include "render/context/render_target.h"
#include "render/programmable/programmable.h"

namespace twinlight::cli {

class StudyRenderers {
  public:
    // For pictures of that size. Throws std::runtime_error that says what the driver refused.
    StudyRenderers(int width, int height);

    // Valid as long as the set lives.
    study::ChoiceRenderers functions();

  private:
    study::Prepared prepare(const Frame& frame, const study::Choice& choice);
    const RenderTarget& target_of(const study::Choice& choice);

    int width_, height_;
    std::unique_ptr<OffscreenContext> context_;
    programmable::Renderer shaders_;  // this and the next die before the context
    std::map<std::pair<study::Target, int>, RenderTarget> targets_;
};

// Where the scene has `#pragma twinlight spectrum(n)`: what its samples cost and how far off they are. Draws into the current
// context. `quick`: three rounds of times instead of nine.
std::optional<study::SpectralStudy> study_samples(const Frame& frame, bool quick);

// The machine that the program runs on.
study::Machine this_machine();

}  // namespace twinlight::cli
