#include "fixed/fixed.h"

#include <stdexcept>

#include "context/context.h"
#include "context/gl.h"

namespace twinlight::fixed {

void draw(const Frame& frame, const RenderOptions& options) {
    if (options.shading == Shading::kPhong) {
        throw std::invalid_argument("the fixed function has no phong shading; use --with programmable or reference");
    }
    Driver driver(frame.width, frame.height);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    if (options.shading) glShadeModel(*options.shading == Shading::kFlat ? GL_FLAT : GL_SMOOTH);
    for (const Command& command : frame.commands->commands) {
        if (options.shading && command.id == CommandId::glShadeModel) continue;
        driver.execute(command);
    }
    glFinish();
}

Image render(const Frame& frame, const RenderOptions& options) {
    draw(frame, options);
    return read_pixels(frame.width, frame.height);
}

}  // namespace twinlight::fixed
