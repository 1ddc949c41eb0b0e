// The GLUT window with its ImGui panels: passes GLUT's events on, draws frames, carries out what the session requests.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/session/session.h"
#include "judge/lesson/lesson.h"
#include "scene/command/command.h"

namespace twinlight::demo {

struct WindowOptions {
    std::optional<WindowSize> size{};  // of the window; empty: as it was last, or what fits the screen
    session::View view = session::View::kSlider;
    std::optional<session::Panel> panel{};  // empty: the last one
    std::optional<session::Probe> probe{};
    std::string tutor;                                       // a tutor's name: opened instead of the scene
    std::optional<lesson::Lesson> lesson{};                  // opened instead of the scene
    lesson::Language language = lesson::Language::kEnglish;  // of the tab Lesson
    std::optional<double> scale{};      // of letters and lines; empty: from the screen's dots per inch
    std::optional<std::string> file{};  // the scene's file, which is read again when it is saved
    std::vector<int> keys;              // their codes; pressed before the first frame, or one by one if they are timed
    std::string screenshot;             // the file that the key p and --quit-after write
    int quit_after = 0;                 // frames; 0: until the user quits
    // A JSON file for the milliseconds of all frames, and from each key to its answer:
    // {"frame_ms": [...], "pane_ms": [[...], ...], "keys": [{"key": "f", "answer_ms": 31.5, "picture_ms": 31.5}, ...]}
    std::string times;
};

// Shows the scene until the user quits, and returns the exit status. Throws SceneError for a scene with a GL error. If GLUT
// cannot start (no display, or no GLX), prints one line on stderr and exits with 2.
int show(const std::shared_ptr<const CommandList>& scene, const WindowOptions& options);

}  // namespace twinlight::demo
