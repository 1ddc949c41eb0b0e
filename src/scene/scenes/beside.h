// The files that a scene names, beside it in its folder.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace twinlight {

// The path of a file in this folder, with links followed. Refuses names that contain a folder, and links to other folders:
// throws std::runtime_error with the reason. `what` is "picture" or "mesh", `example` a name.
std::filesystem::path file_beside(const std::filesystem::path& folder, const std::string& name, std::string_view what,
                                  std::string_view example);

// Returns the bytes of the file with this name, or nullopt if there is no such file.
using FileFinder = std::function<std::optional<std::string_view>(std::string_view name)>;
// The text of a file of kSceneAssets; nullopt if there is none of this name.
std::optional<std::string_view> built_in_file(std::string_view name);

// The file beside the scene, or else that of a built-in scene, so that an exported scene can be read anywhere. Throws
// std::runtime_error if there is neither, or if the file has more than `most` bytes.
std::string read_beside(const std::filesystem::path& folder, const std::string& name, std::string_view what,
                        std::string_view example, std::size_t most);

}  // namespace twinlight
