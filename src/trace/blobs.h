// The files that apitrace dump --blobs writes beside a dump: what the program's pointers pointed at.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "command/command.h"

namespace twinlight::trace {

inline constexpr std::size_t kMaxBlobBytes = std::size_t{256} << 20;

class BlobFolder {
  public:
    explicit BlobFolder(std::string path) : path_(std::move(path)) {}

    // The bytes of a file right in the folder; `place` is where the dump names it. Throws SceneError for a name that
    // leads out of the folder, and for a file that is not there or too large.
    std::shared_ptr<const Memory> read(const std::string& name, const Place& place) const;

  private:
    std::string path_;
};

}  // namespace twinlight::trace
