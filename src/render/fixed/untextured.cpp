#include "render/fixed/untextured.h"

#include "render/context/driver_name.h"
#include "render/context/gl.h"

namespace twinlight::fixed {

namespace {

bool frees_textures_of_bitmaps() {
    const twinlight::Driver driver = current_driver();
    return driver.maker() == "Mesa" && Releases{.from = "25.1", .before = "26.0"}.contain(driver);
}

bool has_room_for_attributes() {
    GLint depth = 0, most = 0;
    glGetIntegerv(GL_ATTRIB_STACK_DEPTH, &depth);
    glGetIntegerv(GL_MAX_ATTRIB_STACK_DEPTH, &most);
    return depth < most;
}

}  // namespace

UntexturedBitmap::UntexturedBitmap() : turns_off_(frees_textures_of_bitmaps() && has_room_for_attributes()) {
    if (!turns_off_) return;
    GLint units = 0;
    glGetIntegerv(GL_MAX_TEXTURE_UNITS, &units);
    glPushAttrib(GL_ENABLE_BIT | GL_TEXTURE_BIT);  // the second one for the active unit
    for (GLint unit = 0; unit < units; ++unit) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        for (const GLenum target : {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP})
            glDisable(target);
    }
}

UntexturedBitmap::~UntexturedBitmap() {
    if (turns_off_) glPopAttrib();
}

}  // namespace twinlight::fixed
