#include "render/context/driver_name.h"

#include <fmt/format.h>

#include "render/context/context.h"
#include "render/context/gl.h"

namespace twinlight {

std::string driver_name() {
    const auto text = [](GLenum name) {
        const GLubyte* value = glGetString(name);
        return std::string(value ? reinterpret_cast<const char*>(value) : "?");
    };
    return fmt::format("{}, {}, {}", text(GL_RENDERER), text(GL_VERSION), context_provider());
}

Driver current_driver() { return parse_driver_name(driver_name()); }

}  // namespace twinlight
