#include "fixed/fixed.h"

#include <stdexcept>

#include "context/context.h"
#include "context/gl.h"

namespace twinlight::fixed {

namespace {

void reset_matrices() {
    struct Stack {
        GLenum mode, depth;
    };
    for (const Stack& stack :
         {Stack{GL_TEXTURE, GL_TEXTURE_STACK_DEPTH}, Stack{GL_PROJECTION, GL_PROJECTION_STACK_DEPTH},
          Stack{GL_MODELVIEW, GL_MODELVIEW_STACK_DEPTH}}) {
        glMatrixMode(stack.mode);
        GLint depth = 1;
        glGetIntegerv(stack.depth, &depth);
        for (; depth > 1; --depth) glPopMatrix();
        glLoadIdentity();
    }
}

}  // namespace

InitialState::InitialState(int width, int height) {
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    reset_matrices();
    glViewport(0, 0, width, height);
}

InitialState::~InitialState() {
    reset_matrices();
    glPopAttrib();
}

void draw(const Frame& frame, const RenderOptions& options) {
    if (options.shading == Shading::kPhong) {
        throw std::invalid_argument("the fixed function has no phong shading; use --with programmable or reference");
    }
    const InitialState initial(frame.width, frame.height);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    if (options.shading) glShadeModel(*options.shading == Shading::kFlat ? GL_FLAT : GL_SMOOTH);
    Executor executor;
    for (const Command& command : frame.commands->commands) {
        if (options.shading && command.id == CommandId::glShadeModel) continue;
        executor.execute(command);
    }
    glFinish();
}

Image render(const Frame& frame, const RenderOptions& options) {
    draw(frame, options);
    return read_pixels(frame.width, frame.height);
}

}  // namespace twinlight::fixed
