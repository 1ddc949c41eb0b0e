// Recorded programs: an apitrace .trace, or the text that apitrace dumps of one.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "scene/command/command.h"

namespace twinlight::trace {

// How many bytes at the front of a file are enough to tell what it is.
inline constexpr std::size_t kTellingBytes = 1 << 16;

bool is_trace(std::string_view front);  // apitrace's own file
bool is_dump(std::string_view front);   // what it dumps

// A recording can be gone through any number of times; apitrace runs once, and its dump is kept in a temporary folder
// until the recording goes. All throw SceneError.
std::shared_ptr<const Recording> open_trace(const std::string& path);
// Its blobs lie beside it.
std::shared_ptr<const Recording> open_dump(const std::string& path);
// Of either kind: `front` has been read from it already. A dump's blobs lie in the working folder.
std::shared_ptr<const Recording> open_standard_input(std::string_view front);

}  // namespace twinlight::trace
