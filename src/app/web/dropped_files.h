// Files that are dropped on the page. A dump of a recorded program becomes a scene's text, with the blobs beside it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "scene/trace/blobs.h"

namespace twinlight::web {

// Whether a file with this front is a dump; its name is for the message. Throws SceneError for a binary .trace.
bool is_dump(std::string_view front, const std::string& name);

class DroppedFiles {
  public:
    void add(const std::string& name, std::span<const std::uint8_t> bytes);
    // Returns JSON: {"text", "width", "height"}: a scene's text, which draws the frame that `twinlight compare` shows, and the size
    // of its picture. Comments at its start say what was lost. Forgets all files. Throws SceneError.
    std::string scene_of_dump(const std::string& name);

  private:
    trace::BlobFiles files_;
};

}  // namespace twinlight::web
