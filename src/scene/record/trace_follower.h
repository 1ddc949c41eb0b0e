// Reads a .trace while apitrace writes it, to see which frames it has, and copies its beginning. `apitrace trim` would leave
// out the call stacks.
//
// A .trace is "at" and chunks: four bytes with their size, and that many bytes compressed by Snappy. Inside are the calls
// (apitrace's docs/FORMAT.markdown).
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "base/image/descriptor.h"
#include "scene/trace/functions.h"

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
    const std::string& failure() const { return failure_; }

    // Writes the first frames of the file, or all of it if it has no more. Throws FileError.
    void copy_frames(int count, const std::string& to) const;

  private:
    struct Chunk {
        std::uint64_t at = 0;     // its size field, in the file
        std::uint64_t start = 0;  // of its bytes among all uncompressed bytes
    };
    struct Incomplete {};
    struct Unreadable {};

    void read_chunk(std::string_view compressed, std::uint64_t at);
    void read_events();
    void read_header();
    void read_event();
    void read_details();
    void read_value();
    void read_stack_frame();
    std::uint64_t number();
    std::string_view bytes(std::uint64_t count);
    std::string_view text() { return bytes(number()); }
    // Whether this signature or stack frame comes for the first time; its description follows then.
    bool is_new(std::unordered_set<std::uint64_t>& known, std::uint64_t id);

    std::string file_, failure_;
    Descriptor descriptor_;
    std::uint64_t read_ = 0;  // bytes of the file
    std::vector<Chunk> chunks_;
    std::string buffer_;       // uncompressed bytes of events that are not yet read
    std::uint64_t start_ = 0;  // of buffer_ among all uncompressed bytes
    std::size_t position_ = 0;
    bool has_header_ = false;
    std::uint64_t version_ = 0;
    int depth_ = 0;  // of values

    // Signatures by their number. What an incomplete event has made known is taken back.
    std::unordered_map<std::uint64_t, std::string> functions_;
    std::unordered_map<std::uint64_t, std::uint64_t> members_;  // of structures: their number
    std::unordered_set<std::uint64_t> structures_, enums_, bitmasks_, stack_frames_;
    std::vector<std::pair<std::unordered_set<std::uint64_t>*, std::uint64_t>> added_;
    FunctionTable table_;
    std::uint64_t calls_ = 0;
    std::unordered_set<std::uint64_t> swaps_;  // calls that end a frame and have not returned
    bool in_list_ = false;
    int first_drawn_ = -1;
    std::vector<std::uint64_t> frame_ends_;  // among all uncompressed bytes
};

}  // namespace twinlight::trace
