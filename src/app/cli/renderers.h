// The three renderers, with the context that two of them draw in.
#pragma once

#include <memory>

#include "judge/compare/comparison.h"
#include "render/context/context.h"
#include "render/programmable/programmable.h"

namespace twinlight::cli {

class RendererSet {
  public:
    // For pictures of this size. Throws std::runtime_error with the driver's reason if there is no context.
    RendererSet(int width, int height);

    // Valid as long as the set lives.
    const compare::Renderers& functions() const { return functions_; }

  private:
    std::unique_ptr<OffscreenContext> context_;
    programmable::Renderer programmable_;  // dies before the context
    compare::Renderers functions_;
};

}  // namespace twinlight::cli
