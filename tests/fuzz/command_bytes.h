// Commands as bytes, for fuzzers: any bytes are commands, each with as many arguments as its row of the table asks for, and
// a change of a byte changes one value. Counts and sizes are mostly small, so that a state is made in a millisecond; names
// are of enums.def, half of the floats' bits are no numbers that a person would write.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "scene/command/command.h"

namespace twinlight {

std::vector<Command> commands_from(std::span<const std::uint8_t> bytes);

// Bytes that come to these commands, for seeds; what the bytes cannot say becomes the nearest that they can.
std::string bytes_from(std::span<const Command> commands);

}  // namespace twinlight
