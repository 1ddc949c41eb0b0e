// An error as GL raises it (2.5), with the place of the command and a message that says how to fix it.
#pragma once

#include <fmt/core.h>

#include <string>

#include "base/text/translation.h"
#include "scene/command/command.h"

namespace twinlight {

struct GlError {
    Enum code = kGL_NO_ERROR;  // GL_INVALID_ENUM, ...
    Place place;
    std::string message;  // "GL_SPOT_CUTOFF is 120; it must be in [0, 90] or 180"
    // True if GL does not raise this error but leaves the result undefined, for example a read beyond the end of an
    // array. Such a command must not reach a driver.
    bool is_undefined = false;
};

// Makes the error of a command. The message is a format of fmt, and is translated.
template <class... Values>
GlError refused(Enum code, const Command& command, fmt::format_string<Values...> message, Values&&... values) {
    return {code, command.place, vtr(message, fmt::make_format_args(values...))};
}
// The same with is_undefined set.
template <class... Values>
GlError undefined(Enum code, const Command& command, fmt::format_string<Values...> message, Values&&... values) {
    return {code, command.place, vtr(message, fmt::make_format_args(values...)), true};
}

// How signed integers become colours and normals: (2c+1)/(2^b-1) up to GL 4.1, max(c/(2^(b-1)-1), -1) from 4.2 on
// (GL 2.1 table 2.9; GL 4.2 section 2.3.4.1).
enum class SignedRule : std::uint8_t { kGl21, kGl42 };

// A component of a colour or a normal as a real number: integers become [-1,1] or [0,1].
double real_from(double c, Kind kind, SignedRule rule);

}  // namespace twinlight
