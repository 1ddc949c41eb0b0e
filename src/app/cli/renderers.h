// The three renderers, with the context that two of them draw in.
#pragma once

#include <memory>
#include <optional>

#include "judge/compare/comparison.h"
#include "render/context/context.h"
#include "render/programmable/programmable.h"
#include "render/reference/pictures.h"

namespace twinlight::cli {

class RendererSet {
  public:
    // For pictures of this size. Throws std::runtime_error with the driver's reason if there is no context.
    RendererSet(int width, int height);

    // Valid as long as the set lives. A frame must not change between two calls.
    const compare::Renderers& functions() const { return functions_; }

  private:
    reference::Pictures& pictures_of(const Frame& frame);

    std::unique_ptr<OffscreenContext> context_;
    programmable::Renderer programmable_;          // dies before the context
    std::optional<reference::Pictures> pictures_;  // of the frame that was drawn last
    compare::Renderers functions_;
};

}  // namespace twinlight::cli
