// SCENE as both programs take it on their command lines.
#pragma once

#include <string>

#include "command/command.h"

namespace twinlight {

// A built-in scene's name, a file, or - for standard input. Throws SceneError, and FileError where a file
// cannot be read.
CommandList load_scene(const std::string& scene);

}  // namespace twinlight
