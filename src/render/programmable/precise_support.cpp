#include "render/programmable/precise_support.h"

#include <fmt/format.h>

#include <charconv>
#include <cstring>
#include <stdexcept>

#include "render/context/gl.h"

namespace twinlight::programmable {

namespace {

// "4.50" of "4.50 (Compatibility Profile)".
double glsl_version() {
    const auto* text = reinterpret_cast<const char*>(glGetString(GL_SHADING_LANGUAGE_VERSION));  // NOLINT
    double version = 0;
    if (text) std::from_chars(text, text + std::strlen(text), version);
    return version;
}

}  // namespace

bool has_precise() { return glsl_version() >= 4.0; }

void check_has_precise() {
    if (!has_precise())
        throw std::runtime_error(
            fmt::format("--precise needs GLSL 4.00 (for `precise`); this driver has {:.2f}", glsl_version()));
}

}  // namespace twinlight::programmable
