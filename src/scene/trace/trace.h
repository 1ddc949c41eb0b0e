// Opens recorded programs: apitrace's .trace files, or the text output of `apitrace dump`.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "scene/command/command.h"

namespace twinlight::trace {

// The first bytes of a file that is_trace() and is_dump() need.
inline constexpr std::size_t kFrontBytes = 1 << 16;

bool is_trace(std::string_view front);  // the front of a .trace
bool is_dump(std::string_view front);   // the front of the output of `apitrace dump`

// A recording can be visited any number of times. apitrace runs only once; its dump stays in a temporary file as long
// as the recording exists. Only one GL context is visited: `context`, counted from 0 in the order in which they became
// current, or the one that draws most. All three throw SceneError.
std::shared_ptr<const Recording> open_trace(const std::string& path, std::optional<int> context = std::nullopt);
// The blobs must be in the folder of the dump.
std::shared_ptr<const Recording> open_dump(const std::string& path, std::optional<int> context = std::nullopt);
// Reads either kind from standard input, of which `front` has already been read. A dump's blobs must be in the working
// folder.
std::shared_ptr<const Recording> open_standard_input(std::string_view front, std::optional<int> context = std::nullopt);

}  // namespace twinlight::trace
