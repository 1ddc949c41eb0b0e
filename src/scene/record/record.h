// Runs programs, and records their GL calls with apitrace.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace twinlight::trace {

// The interface between GL and windows that a program uses.
enum class WindowSystem : std::uint8_t { kGlx, kEgl };

// The absolute path of a program that is given as a shell would take it, or by the name of a file. Throws SceneError.
std::string find_program(const std::string& name);

// The window system of a program, from the libraries that it names; GLX unless it names only EGL.
WindowSystem window_system_of(const std::string& program);

// Whether the program names EGL, so that it may use EGL although it names GLX too.
bool names_egl(const std::string& program);

struct Recorded {
    std::string output;   // what the program printed, without apitrace's messages; its end, if it is long
    std::string ended{};  // how it ended itself: "ended after 0.1 s by signal 11, at lamp.c:3"; "" if it was stopped
    bool has_failed = false;       // ended by a signal or with a status other than 0
    bool has_calls = true;         // whether apitrace recorded any
    bool has_drawn = true;         // called a function that draws; true if that is not known
    bool has_own_display = false;  // ran in Xvfb
    WindowSystem window_system{};
    std::string not_cut{};  // why the recording has all frames; "" if it was cut to RecordOptions::frames
};

struct RecordOptions {
    std::vector<std::string> command;             // the program, as find_program() gives it, and its arguments
    std::string trace;                            // the file to write
    double seconds = 3;                           // at most
    int frames = 100;                             // ends after so many, but not before one that draws
    std::vector<std::string> keys{};              // keys_of(); `frames` counts from the last one on
    std::optional<WindowSystem> window_system{};  // by default, window_system_of()
    std::function<bool()> stop_early = [] { return false; };
};

// Runs a program under apitrace, with the rights of this process, in the display DISPLAY or else in a new Xvfb. Ends it
// after the time or the frames. If no call was recorded, the file is not written. Throws SceneError if apitrace or Xvfb is
// missing.
Recorded record(const RecordOptions& options);

struct BusiestFrame {
    int number = 0;                    // counted from 0
    int frames = 0;                    // of the recording
    bool has_setup = false;            // calls such as glClear, glMatrixMode and glEnable
    bool has_swaps = false;            // if false, the program never swaps buffers, and `number` is 0
    std::vector<std::string> notes{};  // Recording::notes()
};
// The first frame with at least nine tenths of the largest number of vertices of a frame. nullopt if nothing is
// drawn. Throws SceneError if the trace cannot be read.
std::optional<BusiestFrame> busiest_frame(const std::string& trace);

}  // namespace twinlight::trace
