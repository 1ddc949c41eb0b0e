// Blobs: files that `apitrace dump --blobs` writes next to a dump. They hold the memory that the program's pointers
// pointed to.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "scene/command/command.h"

namespace twinlight::trace {

inline constexpr std::size_t kMaxBlobBytes = std::size_t{256} << 20;
// The limit on all blobs in memory at once. Vertex arrays and display lists keep blobs in memory.
inline constexpr std::size_t kMaxHeldBlobBytes = std::size_t{1} << 30;

class BlobFolder {
  public:
    explicit BlobFolder(std::string path, std::size_t most_held = kMaxHeldBlobBytes)
        : path_(std::move(path)), most_held_(most_held) {}

    // The bytes of a file in the folder; `place` is the place in the dump that names it. Throws SceneError if the name
    // leads out of the folder, or if the file is missing or exceeds a limit.
    std::shared_ptr<const Memory> read(const std::string& name, const Place& place) const;

  private:
    std::string path_;
    std::size_t most_held_;
    // Bytes of all blobs in memory. A blob subtracts its size when it is deleted, which may be after this object.
    std::shared_ptr<std::size_t> held_ = std::make_shared<std::size_t>(0);
};

}  // namespace twinlight::trace
