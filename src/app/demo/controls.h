// Controls: the settings that the user can change in the window, and the table of keys that change them. Uses neither GL nor
// GLUT; window.cpp passes on the events from GLUT.
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
    bool save_requested = false;   // the window writes the picture and clears this
    bool quit_requested = false;
    View initial_view;           // the key r returns to it
    bool scene_is_flat = false;  // the scene's own shade model; the key f first switches to the other one
};

// Controls for a scene: with its shade model, and a pivot for a scene without gluLookAt.
Controls make_controls(const Frame& frame);

// ---- Keys ----

// A key's code is its character; keys without one (F1, arrows) have GLUT's number plus kSpecialKey.
inline constexpr int kSpecialKey = 0x100;

struct Key {
    int first, last;                    // its codes: '1' to '8', or the same code twice
    std::string_view label;             // "1 .. 8"
    std::string_view what;              // "switch GL_LIGHT0 .. GL_LIGHT7 off or on"
    void (*press)(Controls&, int nth);  // nth: the code minus `first`
};

std::span<const Key> keys();
bool press(Controls& controls, int code);  // false for a key without a function
std::string keys_help();                   // one line for each key

// ---- The mouse, in window coordinates (y down) ----

void drag(Controls& controls, int dx_pixels, int dy_pixels);
void zoom(Controls& controls, int steps);  // steps of the wheel; positive is nearer

// ---- What is shown ----

// "report - fixed - GL_SMOOTH - GL_LIGHT0,1,7", for the frame as it is drawn. `amplification` is that of the difference picture.
std::string summary(const std::string& scene, const Controls& controls, const Frame& frame, int amplification = 1);

// The largest picture with the wanted proportions that fits the window, centred.
Viewport fit(int wanted_width, int wanted_height, int window_width, int window_height);

}  // namespace twinlight::demo
