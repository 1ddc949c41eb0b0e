#include "render/fixed/freed_views.h"

#include "render/context/driver_name.h"
#include "render/context/gl.h"
#include "render/stages/textures.h"

namespace twinlight::fixed {

namespace {

bool frees_views(KeepsViews::Drawn drawn) {
    const twinlight::Driver driver = current_driver();
    const std::string_view before = drawn == KeepsViews::Drawn::kBitmap ? "26.0" : "";
    return driver.maker() == "Mesa" && Releases{.from = "25.1", .before = before}.contain(driver);
}

bool has_room_for_attributes() {
    GLint depth = 0, most = 0;
    glGetIntegerv(GL_ATTRIB_STACK_DEPTH, &depth);
    glGetIntegerv(GL_MAX_ATTRIB_STACK_DEPTH, &most);
    return depth < most;
}

}  // namespace

KeepsViews::KeepsViews(Drawn drawn) : turns_off_(frees_views(drawn) && has_room_for_attributes()) {
    if (!turns_off_) return;
    if (drawn == Drawn::kBitmap) {
        glPushAttrib(GL_TEXTURE_BIT);  // with all units' targets, and the active unit
        disable_textures();
    } else {
        glPushAttrib(GL_PIXEL_MODE_BIT);
        glPixelTransferi(GL_MAP_COLOR, GL_FALSE);
    }
}

KeepsViews::~KeepsViews() {
    if (turns_off_) glPopAttrib();
}

}  // namespace twinlight::fixed
