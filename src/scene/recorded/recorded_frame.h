// One picture of a recorded program. It depends on the state that the earlier pictures left.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/state/state.h"

namespace twinlight {

struct FrameChoice {
    std::optional<int> number;  // counts from 0; nullopt: the first frame that draws something
    bool may_be_empty = false;  // whether that frame may draw nothing
    // The picture's size in pixels; nullopt: large enough for all viewports up to the end of the frame.
    std::optional<int> width{}, height{};
    SignedRule signed_rule = SignedRule::kGl21;
    std::size_t memory = kDefaultMemory;  // see StateOptions
    // Called now and then with the number of frames and commands so far.
    std::function<void(int frames, std::size_t commands)> progress{};
};

struct RecordedFrame {
    Scene scene;  // its recording ends with the frame; its name is "program.trace, frame 0"
    int number = 0;
    // The GL errors up to there. A real program continues after an error, and so does the driver.
    std::size_t error_count = 0;
    std::optional<GlError> first_error;
    std::vector<std::string> notes;  // for example that the recording ends abruptly
};

// A frame ends where the program swaps buffers. The next frame starts black, unless it shows what earlier frames left
// (earlier_frames.h): then these are drawn first, up to 50, and a note says so. If a program never swaps, it has one buffer: a frame
// ends at glFlush or glFinish after something was drawn, and the next frame draws over it. The commands after the last end are a frame too if they draw something.
// Throws SceneError if the recording cannot be read, has too few frames, or this frame draws nothing.
RecordedFrame make_recorded_frame(const std::shared_ptr<const Recording>& recording, const FrameChoice& choice);

// The frame that comes so many frames after that of a scene, in a picture of the same size. One of these functions made the scene.
// Throws SceneError as make_recorded_frame() does.
RecordedFrame later_frame(const Scene& scene, int frames);
// The frames after that of a scene, which one of these functions made: the next one, and the last of the next 50. Fewer where the
// recording ends, or they draw nothing.
std::vector<RecordedFrame> later_frames(const Scene& scene);

// The frame that `choice` chooses. If it chooses none, and the first frame that draws is almost of one colour, as at the
// start of a fade-in, a later frame that is not. `contrast` gives the color_contrast() of a picture, or nullopt if it is
// not known.
RecordedFrame frame_to_see(const std::shared_ptr<const Recording>& recording, const FrameChoice& choice,
                           const std::function<std::optional<float>(const Scene&)>& contrast);

// What people should know about the program's GL errors; empty if there are none.
std::string note_of_errors(const RecordedFrame& recorded);

// All commands up to the frame, to be printed, with the size of its picture as the window's. A command with a GL error has no
// effect, so it is left out; a scene's text may have none. Throws SceneError if they are too many.
CommandList commands_to_print(const Scene& scene);
// The text of a scene that draws this frame: a comment, a note for each thing that it lacks of the recording, and the commands. Throws
// SceneError if they are too many.
std::string printed_frame(const RecordedFrame& recorded, std::string_view comment);

}  // namespace twinlight
