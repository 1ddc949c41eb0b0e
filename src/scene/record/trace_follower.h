// Reads a .trace while apitrace writes it, to see which frames it has, and copies its beginning. `apitrace trim` would leave
// out the call stacks.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/image/descriptor.h"
#include "scene/trace/trace_reader.h"

namespace twinlight::trace {

class TraceFollower {
  public:
    explicit TraceFollower(std::string file) : file_(std::move(file)) {}

    // Reads what the file has got since, but no more chunks than these: a program may write faster than this reads.
    void read_on(int most_chunks = std::numeric_limits<int>::max());

    int frames() const { return static_cast<int>(frame_ends_.size()); }  // that have ended
    bool has_drawn() const { return first_drawn_ >= 0; }
    int first_drawn() const { return first_drawn_; }  // the first frame that calls a function that draws; -1 for none
    // Why the file cannot be read; "" if it can.
    std::string failure() const { return reader_ ? reader_->failure() : ""; }

    // Writes the first frames of the file, or all of it if it has no more. Throws FileError.
    void copy_frames(int count, const std::string& to) const;

  private:
    std::string file_;
    Descriptor descriptor_;
    std::optional<TraceFile> chunks_;
    std::optional<TraceReader> reader_;
    bool in_list_ = false;
    int first_drawn_ = -1;
    std::vector<std::uint64_t> frame_ends_;  // among all uncompressed bytes
};

}  // namespace twinlight::trace
