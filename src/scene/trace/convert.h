// What a dump tells of a call, as a Command.
#pragma once

#include "scene/command/command.h"
#include "scene/trace/arguments.h"
#include "scene/trace/blobs.h"

namespace twinlight::trace {

// Gives `command`, whose id and place are set, its arguments: by the row of commands.def, in the order of the
// parameters. `result` is what the call returned, nothing where it returned nothing. Throws SceneError for values that
// the row cannot hold.
void convert(const Arguments& arguments, const Arguments& result, const BlobFolder& blobs, Command& command);

}  // namespace twinlight::trace
