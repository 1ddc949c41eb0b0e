#include "app/demo/controls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace twinlight::demo {
namespace {

constexpr double kDegreesPerPixel = 0.5;  // a drag across 640 pixels turns the scene 320 degrees
constexpr double kDegreesPerArrow = 5;
constexpr double kZoomPerStep = 1.1;
constexpr double kMostZoom = 20;
constexpr char kEscape = 27;

void turn(Controls& controls, double yaw_deg, double pitch_deg) {
    View& view = controls.view;
    view.yaw_deg = std::remainder(view.yaw_deg + yaw_deg, 360);
    view.pitch_deg = std::remainder(view.pitch_deg + pitch_deg, 360);
}

void toggle_shade_model(Controls& controls) {
    const bool flat = controls.view.shade_model ? *controls.view.shade_model == kGL_FLAT : controls.scene_is_flat;
    controls.view.shade_model = flat ? kGL_SMOOTH : kGL_FLAT;
}

void toggle_renderer(Controls& controls) {
    controls.renderer = controls.renderer == Path::kFixed ? Path::kProgrammable : Path::kFixed;
    controls.difference = false;  // the key shows a renderer
}

void toggle_keys(Controls& controls, int) { controls.keys_shown = !controls.keys_shown; }
void quit(Controls& controls, int) { controls.quit_requested = true; }

// GLUT's numbers (freeglut_std.h; window.cpp checks them).
constexpr int kF1 = kSpecialKey + 1, kLeft = kSpecialKey + 100, kUp = kSpecialKey + 101;

// Rows without a label are other keys for the row above.
constexpr Key kKeys[] = {
    {'\t', '\t', "Tab", "switch between fixed function and shaders", [](Controls& c, int) { toggle_renderer(c); }},
    {'d', 'd', "d", "show their difference, amplified", [](Controls& c, int) { c.difference = !c.difference; }},
    {'f', 'f', "f", "switch between GL_FLAT and GL_SMOOTH", [](Controls& c, int) { toggle_shade_model(c); }},
    {'1', '8', "1 .. 8", "switch GL_LIGHT0 .. GL_LIGHT7 off or on",
     [](Controls& c, int nth) {
         bool& inverted = c.view.light_inverted[static_cast<std::size_t>(nth)];
         inverted = !inverted;
     }},
    {'m', 'm', "m", "switch wireframe on or off", [](Controls& c, int) { c.view.wireframe = !c.view.wireframe; }},
    {kLeft, kUp + 2, "drag, arrows", "orbit around the middle of the scene",
     [](Controls& c, int nth) {
         constexpr std::array<std::array<int, 2>, 4> kSteps = {{{-1, 0}, {0, -1}, {1, 0}, {0, 1}}};
         const auto [x, y] = kSteps[static_cast<std::size_t>(nth)];
         turn(c, x * kDegreesPerArrow, y * kDegreesPerArrow);
     }},
    {'+', '+', "wheel, + -", "nearer, farther", [](Controls& c, int) { zoom(c, 1); }},
    {'=', '=', "", "", [](Controls& c, int) { zoom(c, 1); }},
    {'-', '-', "", "", [](Controls& c, int) { zoom(c, -1); }},
    {'r', 'r', "r", "reset the view to the scene's own", [](Controls& c, int) { c.view = c.initial_view; }},
    {'s', 's', "s", "save the picture", [](Controls& c, int) { c.save_requested = true; }},
    {'h', 'h', "h", "hide or show the status line", [](Controls& c, int) { c.status_shown = !c.status_shown; }},
    {kF1, kF1, "F1, ?", "show or hide these keys", toggle_keys},
    {'?', '?', "", "", toggle_keys},
    {kEscape, kEscape, "Esc, q", "quit", quit},
    {'q', 'q', "", "", quit},
};

// Whether the shown renderer cannot draw some command.
bool is_partial(const Controls& controls, const Frame& frame) {
    const Path shown = controls.difference ? Path::kProgrammable : controls.renderer;
    return std::ranges::any_of(frame.unsupported, [&](const Unsupported& item) { return lacks(shown, item); });
}

}  // namespace

Controls make_controls(const Frame& frame) {
    Controls controls;
    controls.initial_view.pivot_eye = middle_of(frame);
    controls.view = controls.initial_view;
    const auto all = frame.draws();
    controls.scene_is_flat =
        std::all_of(all.begin(), all.end(), [](const Draw* draw) { return draw->lighting.shade_model == kGL_FLAT; });
    return controls;
}

std::span<const Key> keys() { return kKeys; }

bool press(Controls& controls, int code) {
    for (const Key& key : keys()) {
        if (key.first <= code && code <= key.last) {
            key.press(controls, code - key.first);
            return true;
        }
    }
    return false;
}

std::string keys_help() {
    std::size_t widest = 0;
    for (const Key& key : keys()) widest = std::max(widest, key.label.size());
    std::string help;
    for (const Key& key : keys()) {
        if (key.label.empty()) continue;
        help += std::string(key.label) + std::string(widest + 2 - key.label.size(), ' ') + std::string(key.what) + "\n";
    }
    return help;
}

void drag(Controls& controls, int dx_pixels, int dy_pixels) {
    turn(controls, kDegreesPerPixel * dx_pixels, kDegreesPerPixel * dy_pixels);
}

void zoom(Controls& controls, int steps) {
    // In whole steps from 1, so that a step back gives the same picture.
    const double step = std::round(std::log(controls.view.zoom) / std::log(kZoomPerStep)) + steps;
    controls.view.zoom = std::clamp(std::pow(kZoomPerStep, step), 1 / kMostZoom, kMostZoom);
}

std::string summary(const std::string& scene, const Controls& controls, const Frame& frame, int amplification) {
    std::set<std::string> shade_models;
    std::set<std::size_t> lights_on;
    for (const Draw* draw : frame.draws()) {
        shade_models.insert(draw->lighting.shade_model == kGL_FLAT ? "GL_FLAT" : "GL_SMOOTH");
        for (std::size_t i = 0; i < kMaxLights; ++i) {
            if (draw->lighting.enabled && draw->lighting.lights[i].enabled) lights_on.insert(i);
        }
    }

    std::string text = scene + " - ";
    if (controls.difference) {
        text += "|fixed - programmable| times " + std::to_string(amplification);
    } else {
        text += name_of(controls.renderer);
    }
    if (is_partial(controls, frame)) text += " (partial)";
    text += " -";
    for (const std::string& name : shade_models) text += " " + name;
    if (controls.view.wireframe) text += " wireframe";
    text += lights_on.empty() ? " - no light" : " - GL_LIGHT";
    for (const std::size_t light : lights_on) {
        text += (light == *lights_on.begin() ? "" : ",") + std::to_string(light);
    }
    return text;
}

Viewport fit(int wanted_width, int wanted_height, int window_width, int window_height) {
    const double scale =
        std::min(static_cast<double>(window_width) / wanted_width, static_cast<double>(window_height) / wanted_height);
    const int width = std::clamp(static_cast<int>(std::lround(scale * wanted_width)), 1, std::max(window_width, 1));
    const int height = std::clamp(static_cast<int>(std::lround(scale * wanted_height)), 1, std::max(window_height, 1));
    return {(window_width - width) / 2, (window_height - height) / 2, width, height};
}

}  // namespace twinlight::demo
