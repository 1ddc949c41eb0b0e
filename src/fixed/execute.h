// One command to the driver.
#pragma once

#include "command/command.h"

namespace twinlight::fixed {

// Calls the function of the command's name with the command's arguments, as they are. Pragmas that GL has no command for
// do nothing, but shape(...) draws. The names of objects are the driver's own, and what the command reads must be there:
// Driver sees to both.
void execute(const Command& command);

}  // namespace twinlight::fixed
