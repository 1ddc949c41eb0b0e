#include "app/session/keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <utility>

#include "app/session/camera.h"
#include "app/session/edits.h"
#include "app/session/world.h"
#include "base/text/translation.h"

namespace twinlight::session {
namespace {

constexpr double kOrbitDegreesPerPixel = 0.5, kLookDegreesPerPixel = 0.15;
constexpr double kDegreesPerArrow = 5;
constexpr double kStep = 0.05;  // of the distance to the pivot, for W, A, S and D
constexpr double kCameraZoomPerStep = 1.1;
constexpr double kDegreesPerSecond = 30;

void move_camera(Session& session, const DragStart& start, const CameraMove& move, const char* what) {
    edit(session, with_camera_moved(*start.commands, move, start.pivot_eye), tr(what), "camera");
}

void walk(Session& session, double forward, double right) {
    CameraMove move;
    move.forward = forward * kStep;
    move.right = right * kStep;
    move_camera(session, start_drag(session), move, "move the camera");
}

// The scene as the edit leaves it, for the message about what a key did.
const Frame& frame_now(Session& session) {
    refresh(session, session.width, session.height);
    return session.scene.frame;
}

void press_light(Session& session, int light) {
    edit(session, toggle_light(commands(session), light), tr("switch {}", light_name(light)));
    say(session, what_light_shows(frame_now(session), light));
}

void press_capability(Session& session, Enum cap, const char* name) {
    edit(session, toggle_capability(commands(session), cap), tr("switch {}", name));
    say(session, what_capability_shows(commands(session), frame_now(session), cap));
}

void press_light_model(Session& session, Enum pname, const char* name) {
    edit(session, toggle_light_model(commands(session), pname), tr("switch {}", name));
    say(session, what_light_model_shows(frame_now(session), pname));
}

void press_shade_model(Session& session, int) {
    edit(session, toggle_shade_model(commands(session)), tr("switch {}", "glShadeModel"));
    say(session, tr(is_flat(frame_now(session)) ? "glShadeModel(GL_FLAT): each primitive has the colour of one vertex"
                                                : "glShadeModel(GL_SMOOTH): colours are interpolated"));
}

void next_renderer(Session& session, int) {
    if (session.active == kDifferencePane) session.active = 0;
    Pane& pane = session.panes[session.active];
    pane.renderer = static_cast<Path>((static_cast<std::size_t>(pane.renderer) + 1) % kPaths);
    say(session, title_of(session, pane));
}

void next_view(Session& session, int) {
    // The tutor is the last, and has a key of its own.
    constexpr std::size_t kCount = std::size(kViews) - 1;
    static_assert(kViews[kCount].value == View::kTutor);
    const auto here = std::ranges::find(kViews, session.view, &ViewName::value);
    session.view = here == std::end(kViews) - 1
                       ? kViews[0].value
                       : kViews[static_cast<std::size_t>(here - std::begin(kViews) + 1) % kCount].value;
}

void next_shading(Session& session, int) {
    if (session.active == kDifferencePane) session.active = session.difference.a;
    Pane& pane = session.panes[session.active];
    if (is_flat(session.scene.frame)) {
        say(session, tr("glShadeModel(GL_FLAT) makes every picture flat; f switches it"));
        return;
    }
    const int first = static_cast<int>(pane.shading.value_or(Shading::kGouraud));
    // The fixed function has the first two only.
    const int count = pane.renderer == Path::kFixed ? 2 : 4;
    pane.shading = static_cast<Shading>((first + 1) % count);
    say(session, title_of(session, pane));
}

void next_wireframe(Session& session, int) {
    Wireframe& wireframe = session.overlays.wireframe;
    wireframe = static_cast<Wireframe>((static_cast<int>(wireframe) + 1) % 3);
}

void tessellate(Session& session, int steps) {
    const std::string before = tessellation(commands(session));
    edit(session, change_tessellation(commands(session), steps), tr(steps > 0 ? "finer meshes" : "coarser meshes"),
         "tessellation");
    const std::string now = tessellation(commands(session));
    say(session, now.empty()     ? tr("no shape of this scene has slices and stacks")
                 : now == before ? tr("slices and stacks stay at {}", now)
                                 : tr("slices and stacks: {}", now));
}

void reset(Session& session, int) {
    edit(session, *session.opened, tr("reset"));
    session.animating = false;
    say(session, tr("the scene is as it was opened; z brings the changes back"));
}

void undo(Session& session, int) {
    const std::string what = session.history.undo();
    session.opened = session.opened_steps.at(commands(session).step);
    say(session, what.empty() ? tr("nothing to undo") : tr("undone: {}", what));
}

void redo(Session& session, int) {
    const std::string what = session.history.redo();
    session.opened = session.opened_steps.at(commands(session).step);
    say(session, what.empty() ? tr("nothing to redo") : tr("done again: {}", what));
}

template <Dialog dialog>
void opens(Session& session, int) {
    session.dialog = dialog;
}

void escape(Session& session, int) {
    if (session.dialog != Dialog::kNone)
        session.dialog = Dialog::kNone;
    else if (session.keys_shown)
        session.keys_shown = false;
    else
        request_end(session);
}

// GLUT's numbers (freeglut_std.h; src/app/demo/window_events.cpp checks them).
constexpr int kF1 = kSpecialKey + 1, kF11 = kSpecialKey + 11, kLeft = kSpecialKey + 100;

constexpr Key kKeys[] = {
    {'1', '8', "1 .. 8", "GL_LIGHT0 .. GL_LIGHT7 on or off", press_light, Menu::kLighting},
    {'f', 'f', "f", "GL_FLAT or GL_SMOOTH", press_shade_model, Menu::kLighting},
    {'\t', '\t', "Tab", "next renderer: fixed function, shaders, reference", next_renderer, Menu::kView, false},
    {kShiftTab, kShiftTab, "Shift+Tab", "next view: slider, grid, single, world", next_view, Menu::kView, false},
    {'g', 'g', "g", "shading: flat, Gouraud, Phong, exact surfaces", next_shading, Menu::kView, false},
    {'u', 'u', "u", "the tutor: six calls, the world and the picture; the next tutor",
     [](Session& s, int) { s.tutor_requested = true; }, Menu::kView, false},
    {'w', 'w', "w a s d", "move the camera", [](Session& s, int) { walk(s, 1, 0); }},
    {'a', 'a', "", "", [](Session& s, int) { walk(s, 0, -1); }},
    {'s', 's', "", "", [](Session& s, int) { walk(s, -1, 0); }},
    {'d', 'd', "", "", [](Session& s, int) { walk(s, 0, 1); }},
    {kLeft, kLeft + 3, "drag, arrows",
     "orbit (with Shift: also under the floor); right button: look around; wheel: zoom",
     [](Session& s, int nth) {
         constexpr std::array<std::array<int, 2>, 4> kDirections = {{{-1, 0}, {0, -1}, {1, 0}, {0, 1}}};
         const auto [x, y] = kDirections[static_cast<std::size_t>(nth)];
         constexpr double kPixels = kDegreesPerArrow / kOrbitDegreesPerPixel;
         orbit(s, start_drag(s), static_cast<int>(x * kPixels), static_cast<int>(y * kPixels));
     }},
    {'+', '+', "+ -", "finer or coarser meshes", [](Session& s, int) { tessellate(s, 1); }, Menu::kView},
    {'=', '=', "", "", [](Session& s, int) { tessellate(s, 1); }},
    {'-', '-', "", "", [](Session& s, int) { tessellate(s, -1); }},
    {'m', 'm', "m", "wireframe: over the surface, only lines, off", next_wireframe, Menu::kView, false},
    {'n', 'n', "n", "normals", [](Session& s, int) { s.overlays.normals = !s.overlays.normals; }, Menu::kView, false},
    {'l', 'l', "l", "GL_LIGHTING on or off", [](Session& s, int) { press_capability(s, kGL_LIGHTING, "GL_LIGHTING"); },
     Menu::kLighting},
    {'v', 'v', "v", "local viewer: the eye's own direction at each vertex",
     [](Session& s, int) { press_light_model(s, kGL_LIGHT_MODEL_LOCAL_VIEWER, "GL_LIGHT_MODEL_LOCAL_VIEWER"); },
     Menu::kLighting},
    {'t', 't', "t", "two-sided lighting",
     [](Session& s, int) { press_light_model(s, kGL_LIGHT_MODEL_TWO_SIDE, "GL_LIGHT_MODEL_TWO_SIDE"); },
     Menu::kLighting},
    {'x', 'x', "x", "GL_NORMALIZE on or off",
     [](Session& s, int) { press_capability(s, kGL_NORMALIZE, "GL_NORMALIZE"); }, Menu::kLighting},
    {' ', ' ', "Space", "animate the selected light, or the camera",
     [](Session& s, int) { s.animating = !s.animating; }, Menu::kView, false},
    {'[', '[', "[ ]", "the scene before or after this one", [](Session& s, int) { s.scene_requested = -1; },
     Menu::kScene},
    {']', ']', "", "", [](Session& s, int) { s.scene_requested = 1; }},
    {',', ',', ", .", "the step before or after this one, in a scene with steps",
     [](Session& s, int) { s.step_requested = -1; }, Menu::kScene},
    {'.', '.', "", "", [](Session& s, int) { s.step_requested = 1; }},
    {'r', 'r', "r", "reset the scene to its file", reset, Menu::kTop},
    {'z', 'z', "z", "undo", undo, Menu::kTop},
    {'y', 'y', "y", "redo", redo, Menu::kTop},
    {kCtrl + 'z', kCtrl + 'z', "Ctrl+Z, Ctrl+Y", "undo, redo", undo, Menu::kNone, false},
    {kCtrl + 'y', kCtrl + 'y', "", "", redo, Menu::kNone, false},
    {kCtrlShift + 'z', kCtrlShift + 'z', "", "", redo, Menu::kNone, false},
    {kCtrl + 'c', kCtrl + 'c', "Ctrl+C, Ctrl+V", "copy the selected call; insert the copied calls after it",
     [](Session& s, int) { s.copy_requested = true; }, Menu::kNone, false},
    {kCtrl + 'v', kCtrl + 'v', "", "", [](Session& s, int) { s.paste_requested = true; }, Menu::kNone, false},
    {kCtrl + 'f', kCtrl + 'f', "Ctrl+F", "find a call", opens<Dialog::kFind>, Menu::kTop, false},
    {kCtrl + 'o', kCtrl + 'o', "Ctrl+O", "open a scene", opens<Dialog::kOpen>, Menu::kScene, false},
    {kCtrl + 's', kCtrl + 's', "Ctrl+S", "save to the opened file", [](Session& s, int) { s.save_requested = true; },
     Menu::kScene, false},
    {kCtrlShift + 's', kCtrlShift + 's', "Ctrl+Shift+S", "save to another file", opens<Dialog::kSaveAs>, Menu::kScene,
     false},
    {'e', 'e', "e", "export the scene as a C program", [](Session& s, int) { s.export_requested = true; },
     Menu::kScene},
    {'p', 'p', "p", "save a picture of the window", [](Session& s, int) { s.screenshot_requested = true; },
     Menu::kWindow, false},
    {'h', 'h', "h", "hide or show the panel", [](Session& s, int) { s.panel_shown = !s.panel_shown; }, Menu::kWindow,
     false},
    {kF11, kF11, "F11", "full screen", [](Session& s, int) { s.full_screen_requested = true; }, Menu::kWindow, false},
    {kCtrl + '+', kCtrl + '+', "Ctrl and + - 0", "larger or smaller letters, or their original size",
     [](Session& s, int) { s.letters_requested = 1; }, Menu::kNone, false},
    {kCtrl + '=', kCtrl + '=', "", "", [](Session& s, int) { s.letters_requested = 1; }, Menu::kNone, false},
    {kCtrl + '-', kCtrl + '-', "", "", [](Session& s, int) { s.letters_requested = -1; }, Menu::kNone, false},
    {kCtrl + '0', kCtrl + '0', "", "", [](Session& s, int) { s.letters_requested = 0; }, Menu::kNone, false},
    {kF1, kF1, "F1, ?", "show or hide these keys", [](Session& s, int) { s.keys_shown = !s.keys_shown; },
     Menu::kWindow},
    {'?', '?', "", "", [](Session& s, int) { s.keys_shown = !s.keys_shown; }},
    {kEscape, kEscape, "Esc", "close what is on top; with nothing open, end the program", escape, Menu::kWindow, false},
};

}  // namespace

std::span<const Key> keys() { return kKeys; }

bool press(Session& session, int code) {
    if (code >= 'A' && code <= 'Z') code += 'a' - 'A';  // with Caps Lock
    for (const Key& key : keys()) {
        if (key.first <= code && code <= key.last) {
            key.press(session, code - key.first);
            return true;
        }
    }
    return false;
}

std::string name_of_key(int code) {
    if (code == kShiftTab) return "Shift+Tab";
    for (const auto& [modifiers, name] : {std::pair{kCtrlShift, "Ctrl+Shift+"}, {kCtrl, "Ctrl+"}})
        if (code > modifiers) return name + std::string(1, static_cast<char>(std::toupper(code - modifiers)));
    constexpr std::array<const char*, 4> kArrows = {"Left", "Up", "Right", "Down"};
    if (code >= kLeft && code < kLeft + 4) return kArrows[static_cast<std::size_t>(code - kLeft)];
    if (code >= kF1) return fmt::format("F{}", code - kSpecialKey);
    if (code == '\t') return "Tab";
    if (code == ' ') return "Space";
    if (code == kEscape) return "Esc";
    return {static_cast<char>(code)};
}

std::optional<int> find_key(const std::string& name) {
    for (const Key& key : keys())
        for (int code = key.first; code <= key.last; ++code)
            if (name_of_key(code) == name) return code;
    return {};
}

std::string keys_help() {
    std::size_t widest = 0;
    for (const Key& key : keys()) widest = std::max(widest, key.label.size());
    std::string help;
    for (const Key& key : keys())
        if (!key.label.empty()) help += fmt::format("{:{}}  {}\n", key.label, widest, key.what);
    return help;
}

DragStart start_drag(const Session& session) { return {session.history.now(), middle_of(session.scene.frame), false}; }

void orbit(Session& session, const DragStart& start, int dx, int dy) {
    CameraMove move;
    move.yaw_deg = kOrbitDegreesPerPixel * dx;
    move.pitch_deg = kOrbitDegreesPerPixel * dy;
    move.may_go_under = start.may_go_under;
    move_camera(session, start, move, "turn the camera");
}

void look(Session& session, const DragStart& start, int dx, int dy) {
    CameraMove move;
    move.look_yaw_deg = kLookDegreesPerPixel * dx;
    move.look_pitch_deg = -kLookDegreesPerPixel * dy;
    move_camera(session, start, move, "look around");
}

void zoom(Session& session, int steps) {
    CameraMove move;
    move.zoom = std::pow(kCameraZoomPerStep, steps);
    move_camera(session, start_drag(session), move, "zoom");
}

void animate(Session& session, double seconds) {
    auto& animation = session.animation;
    if (!animation || animation->last != session.history.now()) {
        refresh(session, session.width, session.height);
        animation = {session.history.now(), session.history.now(), session.scene.frame, 0};
    }
    animation->seconds += seconds;
    const double degrees = kDegreesPerSecond * animation->seconds;
    if (session.selected_light) {
        const World world = world_of(*animation->from, animation->frame);
        const auto light = std::ranges::find(world.lights, *session.selected_light, &LightMarker::number);
        if (light != world.lights.end()) {
            const auto index = static_cast<std::size_t>(light - world.lights.begin());
            edit(session, with_light_turned(*animation->from, animation->frame, world, index, degrees),
                 tr("animate {}", light_name(*session.selected_light)), "animation");
        }
    } else {
        CameraMove move;
        move.yaw_deg = degrees;
        edit(session, with_camera_moved(*animation->from, move, middle_of(animation->frame)), tr("animate the camera"),
             "animation");
    }
    animation->last = session.history.now();
}

}  // namespace twinlight::session
