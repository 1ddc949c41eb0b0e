// The GLUT window: hands what GLUT reports to Controls, draws the scene as they say, writes pictures.
#pragma once

#include <memory>
#include <string>

#include "app/demo/controls.h"
#include "scene/command/command.h"

namespace twinlight::demo {

struct WindowOptions {
    int width = 640;  // of the picture; a window of other proportions shows it with bars
    int height = 480;
    Path renderer = Path::kFixed;
    std::string keys;        // pressed before the first frame
    std::string screenshot;  // the file that s writes
    int quit_after = 0;      // frames, then the picture is written if `screenshot` is given; 0: the user quits
};

// Shows the scene until the user quits; answers the exit status. Throws SceneError for a scene with a GL
// error. Where GLUT cannot start, for want of a display or of GLX, one line goes to stderr and the program
// exits with 2.
int show(const std::shared_ptr<const CommandList>& scene, const WindowOptions& options);

}  // namespace twinlight::demo
