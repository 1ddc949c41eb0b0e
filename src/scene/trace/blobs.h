// Blobs: files that `apitrace dump --blobs` writes next to a dump. They hold the memory that the program's pointers
// pointed to.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "scene/command/command.h"

namespace twinlight::trace {

inline constexpr std::size_t kMaxBlobBytes = std::size_t{256} << 20;
// The limit on all blobs in memory at once. Vertex arrays and display lists keep blobs in memory.
inline constexpr std::size_t kMaxHeldBlobBytes = std::size_t{1} << 30;

// Who only counts calls needs no blobs. apitrace writes a file for each, so the dump is much faster without them.
enum class Blobs { kAreRead, kAreLeftOut };

// Gives the bytes of a blob; `place` is the place in the dump that names it. Throws SceneError. Null if they are left out.
using BlobLoader = std::function<std::shared_ptr<const Memory>(const std::string& name, const Place& place)>;

// The files in a folder. Refuses a name that leads out of the folder, and a file that is missing or exceeds a limit.
BlobLoader blobs_in_folder(std::string path, std::size_t most_held = kMaxHeldBlobBytes);

// Files in memory, by their names.
using BlobFiles = std::map<std::string, std::shared_ptr<const Memory>>;
BlobLoader blobs_in_memory(BlobFiles files);

}  // namespace twinlight::trace
