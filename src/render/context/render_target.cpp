// Framebuffer objects (EXT_framebuffer_object; OpenGL 3.0, section 4.4).
#include "render/context/render_target.h"

#include <stdexcept>

#include "base/text/translation.h"
#include "render/context/gl.h"

namespace twinlight {

namespace {

unsigned renderbuffer(GLenum format, int width, int height) {
    GLuint name = 0;
    glGenRenderbuffers(1, &name);
    glBindRenderbuffer(GL_RENDERBUFFER, name);
    glRenderbufferStorage(GL_RENDERBUFFER, format, width, height);
    glBindRenderbuffer(GL_RENDERBUFFER, 0);
    return name;
}

}  // namespace

RenderTarget::RenderTarget(int width, int height, ColorBuffer color_buffer, int samples) {
    const GLenum format = color_buffer == ColorBuffer::kFloat ? GL_RGBA32F : GL_RGBA8;
    GLint own = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &own);
    own_ = static_cast<unsigned>(own);
    depth_ = renderbuffer(GL_DEPTH24_STENCIL8, samples * width, samples * height);
    for (; samples > 0; samples /= 2) {
        Level level{.width = samples * width, .height = samples * height};
        level.color = renderbuffer(format, level.width, level.height);
        glGenFramebuffers(1, &level.framebuffer);
        glBindFramebuffer(GL_FRAMEBUFFER, level.framebuffer);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, level.color);
        if (levels_.empty())
            glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, depth_);
        levels_.push_back(level);
        const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
        glBindFramebuffer(GL_FRAMEBUFFER, own_);
        if (status != GL_FRAMEBUFFER_COMPLETE)
            throw std::runtime_error(tr("the driver cannot draw into {} x {} pixels of {}", level.width, level.height,
                                        tr(color_buffer == ColorBuffer::kFloat ? "floats" : "bytes")));
    }
}

RenderTarget::~RenderTarget() {
    for (const Level& level : levels_) {
        glDeleteFramebuffers(1, &level.framebuffer);
        glDeleteRenderbuffers(1, &level.color);
    }
    glDeleteRenderbuffers(1, &depth_);
}

void RenderTarget::bind() const { glBindFramebuffer(GL_FRAMEBUFFER, levels_.front().framebuffer); }

void RenderTarget::release() const { glBindFramebuffer(GL_FRAMEBUFFER, own_); }

void RenderTarget::resolve() const {
    glDisable(GL_SCISSOR_TEST);
    // A linear filter at the common corner of four texels is their mean.
    for (std::size_t i = 1; i < levels_.size(); ++i) {
        const Level &from = levels_[i - 1], &to = levels_[i];
        glBindFramebuffer(GL_READ_FRAMEBUFFER, from.framebuffer);
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to.framebuffer);
        glBlitFramebuffer(0, 0, from.width, from.height, 0, 0, to.width, to.height, GL_COLOR_BUFFER_BIT, GL_LINEAR);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, own_);
}

Image RenderTarget::read() const {
    const Level& picture = levels_.back();
    glBindFramebuffer(GL_READ_FRAMEBUFFER, picture.framebuffer);
    Image image = read_pixels(picture.width, picture.height);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, own_);
    return image;
}

}  // namespace twinlight
