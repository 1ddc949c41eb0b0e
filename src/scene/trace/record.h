// Compiles and runs programs, and records their GL calls with apitrace.
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

// Whether this is a file of C or C++ source, by its extension.
bool is_source(const std::string& file);

// Compiles a source file that uses freeglut and GLU into the program `program`. The compiler's messages go to standard
// error. Throws SceneError if there is no compiler, or if it fails.
void compile_source(const std::string& source, const std::string& program);

// The absolute path of a program that is given as a shell would take it, or by the name of a file. Throws SceneError.
std::string find_program(const std::string& name);

// The window system of a program, from the libraries that it names; GLX unless it names only EGL.
WindowSystem window_system_of(const std::string& program);

// Whether the program names EGL, so that it may use EGL although it names GLX too.
bool names_egl(const std::string& program);

struct Recorded {
    std::string output;            // what the program printed, without apitrace's messages; its end, if it is long
    bool ended_itself = false;     // before the time was over
    bool has_own_display = false;  // ran in Xvfb
    WindowSystem window_system{};
    std::string not_trimmed{};  // why the recording has all frames; "" if it was cut to RecordOptions::frames
};

struct RecordOptions {
    std::vector<std::string> command;  // the program, as find_program() gives it, and its arguments
    std::string trace;                 // the file to write
    double seconds = 3;
    int frames = 100;                             // of the recording
    std::optional<WindowSystem> window_system{};  // by default, window_system_of()
    std::function<bool()> stop_early = [] { return false; };
};

// Runs a program under apitrace, with the rights of this process, in the display DISPLAY or else in a new Xvfb. Ends it
// after the time. Throws SceneError if apitrace or Xvfb is missing, or if nothing was recorded.
Recorded record(const RecordOptions& options);

struct BusiestFrame {
    int number = 0;                    // counted from 0
    int frames = 0;                    // of the recording
    bool has_swaps = false;            // if false, the program never swaps buffers, and `number` is 0
    std::vector<std::string> notes{};  // Recording::notes()
};
// The first frame with at least nine tenths of the largest number of vertices of a frame. nullopt if nothing is
// drawn. Throws SceneError if the trace cannot be read.
std::optional<BusiestFrame> busiest_frame(const std::string& trace);

}  // namespace twinlight::trace
