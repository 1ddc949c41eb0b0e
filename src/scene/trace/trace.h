// Opens recorded programs: apitrace's .trace files, or the text output of `apitrace dump`.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "scene/command/command.h"
#include "scene/trace/blobs.h"

namespace twinlight::trace {

// The first bytes of a file that is_trace() and is_dump() need.
inline constexpr std::size_t kFrontBytes = 1 << 16;

bool is_trace(std::string_view front);  // the front of a .trace
// The same of a file. The newest format of apitrace has no signature, so the name decides what the front leaves open.
bool is_trace(std::string_view front, const std::filesystem::path& path);
bool is_dump(std::string_view front);  // the front of the output of `apitrace dump`

// A recording can be visited any number of times. A .trace of a version that TraceCalls lacks is read by `apitrace dump`, which runs
// only once; its dump stays in a temporary file as long as the recording exists. Only one GL context is visited: `context`, counted from 0 in the order in which they became
// current, or the one that draws most. All of them throw SceneError.
std::shared_ptr<const Recording> open_trace(const std::string& path, std::optional<int> context = std::nullopt,
                                            Blobs blobs = Blobs::kAreRead);
// The blobs must be in the folder of the dump.
std::shared_ptr<const Recording> open_dump(const std::string& path, std::optional<int> context = std::nullopt);
// A dump in memory, which must exist as long as the recording. The busiest context is visited.
std::shared_ptr<const Recording> read_dump(std::string_view text, const std::string& name, BlobFiles blobs);
// The same of a .trace. Null if TraceCalls lacks its version.
std::shared_ptr<const Recording> read_trace(std::string_view bytes, const std::string& name);
// Reads either kind from standard input, of which `front` has already been read. A dump's blobs must be in the working
// folder.
std::shared_ptr<const Recording> open_standard_input(std::string_view front, std::optional<int> context = std::nullopt);

}  // namespace twinlight::trace
