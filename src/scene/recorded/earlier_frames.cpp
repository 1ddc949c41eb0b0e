#include "scene/recorded/earlier_frames.h"

#include <vector>

#include "base/text/translation.h"

namespace twinlight {

void EarlierFrames::take(const FrameItem& item) {
    if (const Clear* clear_item = std::get_if<Clear>(&item)) clear(*clear_item);
    if (const Accumulate* accumulate_item = std::get_if<Accumulate>(&item)) accumulate(*accumulate_item);
    if (const Draw* draw_item = std::get_if<Draw>(&item)) draw(*draw_item);
    if (std::holds_alternative<TakePixels>(item)) shows_color_ |= color_is_old_;
}

void EarlierFrames::clear(const Clear& clear) {
    if (clear.scissor.enabled) return;
    if (clear.color && clear.color_mask == std::array{true, true, true, true}) color_is_old_ = false;
    if (clear.depth) depth_is_old_ = false;
    if (clear.stencil && (~clear.stencil_mask & kMaxStencil) == 0) stencil_is_old_ = false;
    if (clear.accumulation) accumulation_is_old_ = false;
}

void EarlierFrames::accumulate(const Accumulate& accumulate) {
    const bool reads_color = accumulate.op == kGL_ACCUM || accumulate.op == kGL_LOAD;
    shows_color_ |= reads_color && color_is_old_;
    shows_accumulation_ |= accumulate.op != kGL_LOAD && accumulation_is_old_;
    if (accumulate.op == kGL_LOAD && !accumulate.scissor.enabled) accumulation_is_old_ = false;
    const bool writes_all = accumulate.op == kGL_RETURN && !accumulate.scissor.enabled &&
                            accumulate.color_mask == std::array{true, true, true, true};
    if (writes_all) color_is_old_ = false;
}

void EarlierFrames::draw(const Draw& draw) {
    shows_depth_ |= depth_is_old_ && draw.raster.depth_test && draw.raster.depth_func != kGL_ALWAYS;
    shows_stencil_ |= stencil_is_old_ && draw.fragment.stencil;
}

std::string EarlierFrames::words() const {
    std::vector<const char*> buffers;
    if (shows_color_) buffers.push_back(tr("the picture"));
    if (shows_depth_) buffers.push_back(tr("the depth buffer"));
    if (shows_stencil_) buffers.push_back(tr("the stencil buffer"));
    if (shows_accumulation_) buffers.push_back(tr("the accumulation buffer"));
    std::string text;
    for (std::size_t i = 0; i < buffers.size(); ++i) {
        if (i > 0) text += tr(i + 1 == buffers.size() ? " and " : ", ");
        text += buffers[i];
    }
    return text;
}

}  // namespace twinlight
