// Whether a driver can draw with --precise (numbers/precise.h).
#pragma once

namespace twinlight::programmable {

// Whether the current context's GLSL has `precise`. check_has_precise() throws std::runtime_error if it does not.
bool has_precise();
void check_has_precise();

}  // namespace twinlight::programmable
