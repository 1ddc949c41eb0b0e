// One picture of a recorded program, with all state that its earlier pictures left behind.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scene/state/state.h"

namespace twinlight {

struct FrameChoice {
    std::optional<int> number;  // from 0; nothing: the first frame that draws
    // Of the picture; nothing: what the viewports up to the frame's end reach.
    std::optional<int> width{}, height{};
    SignedRule signed_rule = SignedRule::kGl21;
    // Called now and then: how many frames have gone by, and how many commands.
    std::function<void(int frames, std::size_t commands)> progress{};
};

struct RecordedFrame {
    Scene scene;  // its recording goes up to the frame's end, and is named "program.trace, frame 0"
    int number = 0;
    // What GL refused on the way there. A real program goes on after an error, and so does the driver.
    std::size_t error_count = 0;
    std::optional<GlError> first_error;
    std::vector<std::string> notes;  // what the recording says of itself: that it breaks off
};

// A frame ends where the program swaps buffers, and what it leaves in them is undefined: the next one begins black. A
// program that never swaps has one buffer: there glFlush or glFinish, after something was drawn, ends a frame, and the
// next one draws over it. What comes after the last end is a frame too, if it draws.
// Throws SceneError where the recording cannot be read, has fewer frames, or draws nothing in this one.
RecordedFrame make_recorded_frame(const std::shared_ptr<const Recording>& recording, const FrameChoice& choice);

}  // namespace twinlight
