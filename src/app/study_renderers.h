// The renderers of a study.
#pragma once

#include <map>
#include <memory>
#include <utility>

#include "judge/study/study.h"
#include "render/context/context.h"
#include "render/context/render_target.h"
#include "render/programmable/programmable.h"

namespace twinlight {

class StudyRenderers {
  public:
    // For pictures of this size. Throws std::runtime_error with the driver's reason if there is no context.
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

}  // namespace twinlight
