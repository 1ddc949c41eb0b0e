// Converts a call in a dump to a Command.
#pragma once

#include "scene/command/command.h"
#include "scene/trace/arguments.h"
#include "scene/trace/blobs.h"

namespace twinlight::trace {

// Fills in the arguments of `command`, whose id and place are already set, according to its row in commands.def.
// `result` holds the result of the call, or nothing. Throws SceneError if a value does not fit its parameter.
void convert(const Arguments& arguments, const Arguments& result, const BlobLoader& blobs, Command& command);

}  // namespace twinlight::trace
