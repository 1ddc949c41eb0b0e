// twinlight export --as html: one page that draws a scene with WebGL 2, and loads nothing else. Its shaders stay right when the camera
// turns and lights are switched (programmable/export/); gl.js draws, as on the page for browsers, and viewer.js turns the camera.
#pragma once

#include <string>
#include <vector>

#include "base/image/embedded.h"
#include "render/look.h"
#include "scene/frame/frame.h"

namespace twinlight {

extern const std::vector<EmbeddedFile> kWebglFiles;  // exported_page.html, its styles and scripts

namespace webgl {

struct PageText {
    std::string name;         // the scene's
    std::string shows = {};   // what it shows, a sentence
    std::string notice = {};  // and what to notice
};
// A step of the scene, or all of a scene without steps.
struct PageStep {
    const Frame* frame = nullptr;
    std::string title = {};
};

// If `look` has no shading, the page draws the scene's own and per pixel. Steps that programmable::why_not_kept() refuses are left out.
// Throws std::runtime_error if it has a reason for all.
std::string exported_page(const std::vector<PageStep>& steps, const Look& look, const PageText& text);

}  // namespace webgl
}  // namespace twinlight
