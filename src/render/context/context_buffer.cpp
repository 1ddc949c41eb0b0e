#include "render/context/context_buffer.h"

#include <stdexcept>
#include <string>

#include "base/text/input_text.h"
#include "base/text/translation.h"
#include "render/context/clamped_colors.h"
#include "render/context/driver_name.h"
#include "render/context/gl.h"

namespace twinlight {

namespace {

void attach(GLenum attachment, GLenum format, GLuint buffer, int width, int height) {
    glBindRenderbuffer(GL_RENDERBUFFER, buffer);
    glRenderbufferStorage(GL_RENDERBUFFER, format, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer);
}

// In Mesa a window's first row in memory is the top one, a framebuffer object's is the bottom one. Upside down,
// borders and positions would round to the other side. Other drivers have no such switch.
void flip_rows_like_a_window() {
    if (has_word(reinterpret_cast<const char*>(glGetString(GL_EXTENSIONS)), "GL_MESA_framebuffer_flip_y"))
        glFramebufferParameteri(GL_FRAMEBUFFER, GL_FRAMEBUFFER_FLIP_Y_MESA, GL_TRUE);
}

}  // namespace

ContextBuffer::ContextBuffer(int width, int height, ColorBuffer color_buffer) {
    glGenRenderbuffers(2, buffers_.data());
    glGenFramebuffers(1, &framebuffer_);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    attach(GL_COLOR_ATTACHMENT0, color_buffer == ColorBuffer::kFloat ? GL_RGBA32F : GL_RGBA8, buffers_[0], width,
           height);
    attach(GL_DEPTH_STENCIL_ATTACHMENT, GL_DEPTH24_STENCIL8, buffers_[1], width, height);
    flip_rows_like_a_window();
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE) return;
    const std::string driver = driver_name();
    release();
    throw std::runtime_error(
        tr("{} cannot draw into a buffer of {} x {} pixels; try a smaller one", driver, width, height));
}

ContextBuffer::~ContextBuffer() { release(); }

void ContextBuffer::release() {
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteRenderbuffers(2, buffers_.data());
}

bool has_word(const char* words, std::string_view word) {
    InputText stream(words ? words : "");
    for (std::string each; stream >> each;)
        if (each == word) return true;
    return false;
}

void prepare_context(int width, int height) {
    clamp_colors();
    glViewport(0, 0, width, height);
    glScissor(0, 0, width, height);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

}  // namespace twinlight
