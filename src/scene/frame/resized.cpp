#include "scene/frame/resized.h"

#include <cmath>
#include <variant>

namespace twinlight {

Frame resized(Frame frame, int width, int height) {
    const double across = static_cast<double>(width) / frame.width, up = static_cast<double>(height) / frame.height;
    const auto scale = [](int& start, int& length, double factor) {
        const int first = static_cast<int>(std::lround(start * factor));
        length = static_cast<int>(std::lround((start + length) * factor)) - first;
        start = first;
    };
    const auto scale_box = [&](Rectangle& box) {
        scale(box.x, box.width, across);
        scale(box.y, box.height, up);
    };
    const auto scale_item = [&](FrameItem& item) {
        if (Draw* draw = std::get_if<Draw>(&item)) {
            if (!draw->pixels) scale_box(draw->raster.viewport);
            draw->change_source(scale_box);
            scale_box(draw->fragment.scissor.box);
        } else if (Clear* clear = std::get_if<Clear>(&item)) {
            scale_box(clear->scissor.box);
        } else if (Accumulate* accumulate = std::get_if<Accumulate>(&item)) {
            scale_box(accumulate->scissor.box);
        } else {
            scale_box(std::get<TakePixels>(item).from);
        }
    };
    for (FrameItem& item : frame.items) scale_item(item);
    for (auto& picture : frame.earlier) {
        FrameItems items = *picture;
        for (FrameItem& item : items) scale_item(item);
        picture = std::make_shared<const FrameItems>(std::move(items));
    }
    frame.width = width;
    frame.height = height;
    return frame;
}

}  // namespace twinlight
