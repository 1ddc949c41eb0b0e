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

// Counts the bytes of all blobs in memory. A blob subtracts its size when it is deleted, which may be after this object.
class BlobBudget {
  public:
    explicit BlobBudget(std::size_t most = kMaxHeldBlobBytes) : most_(most) {}

    std::size_t held() const { return *held_; }
    std::size_t most() const { return most_; }
    bool allows(std::size_t size) const { return size <= kMaxBlobBytes && size <= most_ - *held_; }
    std::shared_ptr<Memory> allocate(std::size_t size) const;  // a size that it allows

  private:
    std::size_t most_;
    std::shared_ptr<std::size_t> held_ = std::make_shared<std::size_t>(0);
};

// Who only counts calls needs no blobs. Reading is faster without them.
enum class Blobs { kAreRead, kAreLeftOut };

// Gives the bytes of a blob; `place` is the place in the dump that names it. Throws SceneError. Null if they are left out.
using BlobLoader = std::function<std::shared_ptr<const Memory>(const std::string& name, const Place& place)>;

// The files in a folder. Refuses a name that leads out of the folder, and a file that is missing or exceeds a limit.
BlobLoader blobs_in_folder(std::string path, std::size_t most_held = kMaxHeldBlobBytes);

// For a reader that has read all blobs but those that are too large: refuses them.
std::shared_ptr<const Memory> blobs_too_large(const std::string& name, const Place& place);

// Files in memory, by their names.
using BlobFiles = std::map<std::string, std::shared_ptr<const Memory>>;
BlobLoader blobs_in_memory(BlobFiles files);

}  // namespace twinlight::trace
