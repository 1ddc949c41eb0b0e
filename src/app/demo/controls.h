// Controls: what the user may change in the window, and the one table of keys that does it. Neither GL nor
// GLUT here; window.cpp hands on what GLUT reports.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "app/demo/view.h"
#include "render/path.h"
#include "scene/state/frame.h"

namespace twinlight::demo {

struct Controls {
    View view;
    Path renderer = Path::kFixed;  // or kProgrammable
    bool difference = false;       // the picture is |fixed - programmable|, amplified
    bool keys_shown = false;       // the overlay of all keys
    bool status_shown = true;      // the overlay of one line
    bool save_asked = false;       // the window writes the picture and takes this back
    bool quit_asked = false;
    View initial_view;           // what r goes back to
    bool scene_is_flat = false;  // the scene's own shade model: f starts with the other one
};

// Controls for a scene: its shade model, and its pivot where it has no gluLookAt.
Controls make_controls(const Frame& frame);

// ---- Keys ----

// Characters stand for themselves; keys without one (F1, arrows) have kSpecialKey added to GLUT's number.
inline constexpr int kSpecialKey = 0x100;

struct Key {
    int first, last;                    // the codes it answers to: '1' to '8', or twice the same
    std::string_view label;             // "1 .. 8"
    std::string_view what;              // "GL_LIGHT0 .. GL_LIGHT7 off or on"
    void (*press)(Controls&, int nth);  // nth: how far the code stands from `first`
};

std::span<const Key> keys();
bool press(Controls& controls, int code);  // false for a key that does nothing
std::string keys_help();                   // a line a key

// ---- The mouse, in window coordinates (y down) ----

void drag(Controls& controls, int dx_pixels, int dy_pixels);
void zoom(Controls& controls, int steps);  // of the wheel; positive: nearer

// ---- What is shown ----

// "report - fixed - GL_SMOOTH - GL_LIGHT0,1,7", of the frame as it is drawn. `amplification`: of the difference.
std::string summary(const std::string& scene, const Controls& controls, const Frame& frame, int amplification = 1);

// The largest picture of the proportions wanted that fits the window, in its middle.
Viewport fit(int wanted_width, int wanted_height, int window_width, int window_height);

}  // namespace twinlight::demo
