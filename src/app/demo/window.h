// The GLUT window: passes GLUT's events to Controls, draws the scene, writes pictures.
#pragma once

#include <memory>
#include <string>

#include "app/demo/controls.h"
#include "scene/command/command.h"

namespace twinlight::demo {

struct WindowOptions {
    int width = 640;  // of the picture; a window with other proportions adds black bars
    int height = 480;
    Path renderer = Path::kFixed;
    std::string keys;        // pressed before the first frame
    std::string screenshot;  // the file that the key s writes
    int quit_after = 0;      // frames; the picture is then written if `screenshot` is given. 0: until the user quits
};

// Shows the scene until the user quits, and returns the exit status. Throws SceneError for a scene with a GL error. If GLUT
// cannot start (no display, or no GLX), prints one line on stderr and exits with 2.
int show(const std::shared_ptr<const CommandList>& scene, const WindowOptions& options);

}  // namespace twinlight::demo
