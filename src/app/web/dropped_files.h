// Files that are dropped on the page. A recorded program becomes a scene's text: a .trace of apitrace, or its dump with the blobs
// beside it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "scene/trace/blobs.h"

namespace twinlight::web {

// Whether a file of this name and with this front is a .trace or a dump.
bool is_recording(std::string_view front, const std::string& name);

class DroppedFiles {
  public:
    void add(const std::string& name, std::span<const std::uint8_t> bytes);
    // Returns JSON: {"text", "width", "height"}: a scene's text, which draws the frame that `twinlight compare` shows, and the size
    // of its picture. Comments at its start say what was lost. Forgets all files. Throws SceneError.
    std::string scene_of_recording(const std::string& name);

  private:
    trace::BlobFiles files_;
};

}  // namespace twinlight::web
