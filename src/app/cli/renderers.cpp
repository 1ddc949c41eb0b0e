#include "app/cli/renderers.h"

#include "render/fixed/fixed.h"
#include "render/fixed/queries.h"

namespace twinlight::cli {

RendererSet::RendererSet(int width, int height) : context_(make_offscreen_context(width, height)) {
    functions_.fixed = fixed::render;
    functions_.programmable = [this](const Frame& frame, const programmable::Options& options) {
        return programmable_.render(frame, options);
    };
    functions_.reference = [this](const Frame& frame, const reference::Options& options) {
        return pictures_of(frame).render(options);
    };
    functions_.allowed_difference = [this](const Frame& frame, const reference::Options& options) {
        return pictures_of(frame).allowed_difference(options);
    };
    functions_.answers = fixed::answers;
}

reference::Pictures& RendererSet::pictures_of(const Frame& frame) {
    if (!pictures_ || &pictures_->frame() != &frame) pictures_.emplace(frame);
    return *pictures_;
}

}  // namespace twinlight::cli
