#include "render/fixed/fixed.h"

#include <array>
#include <stdexcept>

#include "render/context/context.h"
#include "render/context/gl.h"

namespace twinlight::fixed {

namespace {

// Clears the window to black, depth 1 and stencil 0, whatever the state is, and restores the state. `accumulation`: also that
// buffer, if the context has one.
void clear_to_black(std::uint32_t window, bool accumulation) {
    GLint list = 0, mask = GL_TRUE, stencil = 0, stencil_mask = 0;
    glGetIntegerv(GL_LIST_INDEX, &list);
    if (list != 0) return;  // a list is being compiled and would record the clear
    const std::uint32_t framebuffer = draw_framebuffer();
    if (framebuffer != window) glBindFramebuffer(GL_DRAW_FRAMEBUFFER, window);
    std::array<GLfloat, 4> color{}, accumulated{};
    std::array<GLboolean, 4> color_mask{};
    GLdouble depth = 1;
    glGetFloatv(GL_COLOR_CLEAR_VALUE, color.data());
    glGetBooleanv(GL_COLOR_WRITEMASK, color_mask.data());
    glGetDoublev(GL_DEPTH_CLEAR_VALUE, &depth);
    glGetIntegerv(GL_DEPTH_WRITEMASK, &mask);
    glGetIntegerv(GL_STENCIL_CLEAR_VALUE, &stencil);
    glGetIntegerv(GL_STENCIL_WRITEMASK, &stencil_mask);
    glGetFloatv(GL_ACCUM_CLEAR_VALUE, accumulated.data());
    const bool scissor = glIsEnabled(GL_SCISSOR_TEST) == GL_TRUE;

    glDisable(GL_SCISSOR_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    glClearColor(0, 0, 0, 0);
    glClearDepth(1);
    glClearStencil(0);
    glStencilMaskSeparate(GL_FRONT, ~0U);
    glClearAccum(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT |
            (accumulation ? GL_ACCUM_BUFFER_BIT : 0U));

    if (scissor) glEnable(GL_SCISSOR_TEST);
    glColorMask(color_mask[0], color_mask[1], color_mask[2], color_mask[3]);
    glDepthMask(static_cast<GLboolean>(mask));
    glClearColor(color[0], color[1], color[2], color[3]);
    glClearDepth(depth);
    glClearStencil(stencil);
    glStencilMaskSeparate(GL_FRONT, static_cast<GLuint>(stencil_mask));
    glClearAccum(accumulated[0], accumulated[1], accumulated[2], accumulated[3]);
    if (framebuffer != window) glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
}

}  // namespace

void draw(const Scene& scene, const Options& options) {
    check_shading(options.shading);
    Driver driver(scene.frame.width, scene.frame.height);
    driver.make_empty_lists(scene.frame.lists_called_before_made);
    const bool accumulation = accumulates(scene.frame);
    const std::uint32_t window = driver.name_of(ObjectType::kFramebuffer, 0);
    clear_to_black(window, accumulation);
    if (options.shading) glShadeModel(*options.shading == Shading::kFlat ? GL_FLAT : GL_SMOOTH);
    scene.recording->for_each([&](const Step& step) {
        switch (step.kind) {
            case Step::Kind::kCommand:
                if (!options.shading || step.command.id != CommandId::glShadeModel) driver.execute(step.command);
                break;
            case Step::Kind::kFrameEnd:
                clear_to_black(window, accumulation);
                driver.drop_accumulated();
                break;
            case Step::Kind::kOutside:
            case Step::Kind::kElsewhere:
            case Step::Kind::kCutOff: break;
        }
        return true;
    });
    glFinish();
}

void check_shading(const std::optional<Shading>& shading) {
    if (shading == Shading::kPhong)
        throw std::invalid_argument("the fixed function has no phong shading; use --with shaders or reference");
    if (shading == Shading::kExact)
        throw std::invalid_argument("the fixed function cannot draw exact surfaces; use --with shaders or reference");
}

Image render(const Scene& scene, const Options& options) {
    draw(scene, options);
    return read_pixels(scene.frame.width, scene.frame.height);
}

}  // namespace twinlight::fixed
