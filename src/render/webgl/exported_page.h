// twinlight export --as html: one page that draws a scene with WebGL 2, and loads nothing else. Its shaders stay right when the camera
// turns and lights are switched (programmable/export/); gl.js draws, as on the page for browsers, and viewer.js turns the camera.
#pragma once

#include <string>
#include <vector>

#include "base/image/embedded.h"
#include "render/look.h"
#include "scene/frame/frame.h"

namespace twinlight {

extern const std::vector<EmbeddedFile> kWebglFiles;  // exported_page.html, gl.js, viewer.js

namespace webgl {

// `name` is the scene's. Throws std::runtime_error if programmable::why_not_kept() has a reason.
std::string exported_page(const Frame& frame, const Look& look, const std::string& name);

}  // namespace webgl
}  // namespace twinlight
