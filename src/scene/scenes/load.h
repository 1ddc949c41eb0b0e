// Loads the SCENE that both programs take on the command line.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/image/embedded.h"
#include "scene/command/command.h"
#include "scene/command/text.h"

namespace twinlight {

// The built-in scenes, NAME.gl.
extern const std::vector<EmbeddedFile> kSceneFiles;
// A built-in scene's name.
inline std::string built_in_name(const EmbeddedFile& file) {
    return std::string(file.name.substr(0, file.name.rfind(".gl")));
}
// Null if there is none of this name.
const EmbeddedFile* find_built_in(std::string_view name);
// The pictures and meshes that they load.
extern const std::vector<EmbeddedFile> kSceneAssets;

// Reads a file of kSceneFiles. The scene's name is the file's, without .gl.
CommandList read_built_in(const EmbeddedFile& file, const ReadOptions& options = {});

// `scene` is the name of a built-in scene, a file, or - for standard input. The content decides how it is read: a scene
// in C gives a CommandList; an apitrace .trace or the text of its dump gives a recording that is read each time it is
// visited. A whole C program runs with `window` instead of its own size. `step` is ReadOptions::step. `context` is the GL
// context of a recorded program that is followed (trace/trace.h). `fits` is ReadOptions::fits. Throws SceneError, and FileError if a file cannot be
// read.
std::shared_ptr<const Recording> load_recording(const std::string& scene,
                                                std::optional<WindowSize> window = std::nullopt,
                                                const std::string& step = {}, std::optional<int> context = std::nullopt,
                                                std::function<bool(Enum mode, std::size_t vertices)> fits = {});
// The same, but refuses recorded programs.
std::shared_ptr<const CommandList> load_commands(const std::string& scene, const std::string& step = {});
// Reads a text as if the file had it: its pictures, meshes and headers are those beside the file. Without a file (empty), they are
// the built-in ones. Throws SceneError.
CommandList read_text_of(const std::string& file, const std::string& name, const std::string& text,
                         const std::string& step = {});
// Another step of a scene that was loaded under this name. Standard input is not read again.
std::shared_ptr<const CommandList> load_step(const std::string& scene, const CommandList& loaded,
                                             const std::string& step);

}  // namespace twinlight
