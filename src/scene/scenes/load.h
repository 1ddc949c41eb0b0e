// SCENE as both programs take it on their command lines.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/image/file.h"
#include "scene/command/command.h"

namespace twinlight {

// The built-in scenes, NAME.gl.
extern const std::vector<EmbeddedFile> kSceneFiles;

// A built-in scene's name, a file, or - for standard input; what it holds tells what it is. Throws SceneError, and
// FileError where a file cannot be read.
//
// A scene in C is a CommandList; an apitrace .trace, or the text of its dump, is read as it is gone through.
std::shared_ptr<const Recording> load_recording(const std::string& scene);
// The same; refuses recorded programs.
std::shared_ptr<const CommandList> load_commands(const std::string& scene);

}  // namespace twinlight
