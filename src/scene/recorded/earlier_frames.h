// What a frame shows of the frames before it. After a swap of buffers the picture is undefined by OpenGL; the depth, stencil and
// accumulation buffers stay (GLX 1.4, section 3.3.10). Windows that copy their back buffer keep the picture, too.
#pragma once

#include <string>

#include "scene/frame/frame.h"

namespace twinlight {

// The buffers that a frame has not cleared when it shows or reads them. In order: take() for each item, then end().
class EarlierFrames {
  public:
    void take(const FrameItem& item);
    // The frame ends here, and its picture is shown.
    void end() { shows_color_ |= color_is_old_; }

    bool show() const { return shows_color_ || shows_depth_ || shows_stencil_ || shows_accumulation_; }
    // "the picture and the depth buffer"
    std::string words() const;

  private:
    void clear(const Clear& clear);
    void accumulate(const Accumulate& accumulate);
    void draw(const Draw& draw);

    bool color_is_old_ = true, depth_is_old_ = true, stencil_is_old_ = true, accumulation_is_old_ = true;
    bool shows_color_ = false, shows_depth_ = false, shows_stencil_ = false, shows_accumulation_ = false;
};

}  // namespace twinlight
