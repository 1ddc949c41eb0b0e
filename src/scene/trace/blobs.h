// The files that apitrace dump --blobs writes beside a dump: what the program's pointers pointed at.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "scene/command/command.h"

namespace twinlight::trace {

inline constexpr std::size_t kMaxBlobBytes = std::size_t{256} << 20;
// Of all that are held at once: by the pointers of vertex arrays, by display lists.
inline constexpr std::size_t kMaxHeldBlobBytes = std::size_t{1} << 30;

class BlobFolder {
  public:
    explicit BlobFolder(std::string path, std::size_t most_held = kMaxHeldBlobBytes)
        : path_(std::move(path)), most_held_(most_held) {}

    // The bytes of a file right in the folder; `place` is where the dump names it. Throws SceneError for a name that
    // leads out of the folder, and for a file that is not there or too large, by itself or beside those that are in use.
    std::shared_ptr<const Memory> read(const std::string& name, const Place& place) const;

  private:
    std::string path_;
    std::size_t most_held_;
    // In bytes. A blob that goes takes its own away again, be it after the folder.
    std::shared_ptr<std::size_t> held_ = std::make_shared<std::size_t>(0);
};

}  // namespace twinlight::trace
