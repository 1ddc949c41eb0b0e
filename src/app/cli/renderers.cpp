#include "app/cli/renderers.h"

#include "render/fixed/fixed.h"
#include "render/fixed/queries.h"
#include "render/reference/reference.h"

namespace twinlight::cli {

RendererSet::RendererSet(int width, int height) : context_(make_offscreen_context(width, height)) {
    functions_.fixed = fixed::render;
    functions_.programmable = [this](const Frame& frame, const programmable::Options& options) {
        return programmable_.render(frame, options);
    };
    functions_.reference = reference::render;
    functions_.allowed_difference = reference::allowed_difference;
    functions_.answers = fixed::answers;
}

}  // namespace twinlight::cli
