// Keys: the one table of the window's keys. The help, the menu, --help and the page's keys are made from it.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "app/session/session.h"

namespace twinlight::session {

// A key's code is its character; keys without one (F1, arrows) have GLUT's number plus kSpecialKey. Shift+Tab is kShiftTab.
inline constexpr int kSpecialKey = 0x100;
inline constexpr int kShiftTab = 0x1000;
inline constexpr int kEscape = 27;
// With the key Ctrl: the small letter or the character plus kCtrl; with Shift as well, plus kCtrlShift.
inline constexpr int kCtrl = 0x2000, kCtrlShift = 0x6000;

// Where the window's menu has a key: at its top, or in one of the menus within.
enum class Menu : std::uint8_t { kNone, kTop, kLighting, kView, kScene, kWindow };

struct Key {
    int first, last;                   // its codes: '1' to '8', or the same code twice
    std::string_view label;            // "1 .. 8"; empty: another key for the row above
    std::string_view what;             // "light GL_LIGHT0 .. GL_LIGHT7: on or off"
    void (*press)(Session&, int nth);  // nth: the code minus `first`
    Menu menu = Menu::kNone;
    bool in_page = true;  // the page for browsers has it (app/web)
};

std::span<const Key> keys();
bool press(Session& session, int code);  // false for a key without a function
// "f", "Tab", "Ctrl+O": the name of a key in the table.
std::string name_of_key(int code);
std::optional<int> find_key(const std::string& name);
std::string keys_help();  // one line for each key

// ---- The mouse over a picture, in pixels (y down) ----

// The scene where a drag starts. Each move is from there, so that rounding does not add up.
struct DragStart {
    std::shared_ptr<const CommandList> commands;
    glm::dvec3 pivot_eye;
    bool may_go_under = false;  // the floor; with the key Shift
};
DragStart start_drag(const Session& session);

void orbit(Session& session, const DragStart& start, int dx, int dy);
void look(Session& session, const DragStart& start, int dx, int dy);
void zoom(Session& session, int steps);  // of the wheel; positive is nearer
// Moves what is animated by this many seconds: the selected light around the scene's middle, or else the camera.
void animate(Session& session, double seconds);

}  // namespace twinlight::session
