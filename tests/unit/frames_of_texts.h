// A recorded program whose frames are given as the texts of scenes.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "one_pixel.h"

namespace twinlight {

// Each frame ends with a swap of buffers.
class FramesOfTexts final : public Recording {
  public:
    explicit FramesOfTexts(const std::vector<std::string>& frames) : Recording("frames") {
        for (const std::string& frame : frames) lists_.push_back(list_of(frame));
    }
    void for_each(const std::function<bool(const Step&)>& visit) const override {
        static const Command kNone{CommandId::glFlush, {}, {}};
        for (const auto& list : lists_) {
            for (const Command& command : list->commands)
                if (!visit({.command = command})) return;
            if (!visit({.kind = Step::Kind::kFrameEnd, .command = kNone})) return;
        }
    }

  private:
    std::vector<std::shared_ptr<const CommandList>> lists_;
};

}  // namespace twinlight
