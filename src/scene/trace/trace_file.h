// The file of a .trace: "at" and chunks. A chunk is four bytes with its size, and that many bytes compressed by Snappy
// (google/snappy, format_description.txt). The file may grow while it is read.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace twinlight::trace {

// Removes a number from the front of `bytes`: seven bits a byte, the lowest first. nullopt if its end is missing.
inline std::optional<std::uint64_t> take_number(std::string_view& bytes) {
    std::uint64_t value = 0;
    for (int shift = 0; shift < 64 && !bytes.empty(); shift += 7) {
        const auto byte = static_cast<unsigned char>(bytes[0]);
        bytes.remove_prefix(1);
        value |= std::uint64_t{byte & 0x7FU} << shift;
        if (byte < 0x80) return value;
    }
    return std::nullopt;
}

// A chunk that holds these bytes, uncompressed.
std::string chunk_of(std::string_view bytes);

class TraceFile {
  public:
    // `descriptor` allows random access, and must stay open.
    explicit TraceFile(int descriptor) : descriptor_(descriptor) {}
    // A file in memory, which must stay there.
    explicit TraceFile(std::string_view bytes) : bytes_(bytes) {}

    // Adds the bytes of the next chunk to `to`. Returns false if the file does not have it, or not all of it, or if it is damaged.
    bool read_chunk(std::string& to);
    // If the file ends within a chunk, adds what can be read of that chunk. Returns false if it does not.
    bool read_cut_chunk(std::string& to);

    std::size_t chunks() const { return chunks_.size(); }  // that were read
    // Why no more can be read; "" if the file is in order so far.
    const std::string& failure() const { return failure_; }
    bool is_foreign() const { return is_foreign_; }  // the file is no chunks of Snappy

    // Writes a file with the first `size` bytes, counted as they are uncompressed, or with all. They must have been read. Throws
    // FileError.
    void copy(const std::string& to, std::optional<std::uint64_t> size) const;

  private:
    struct Chunk {
        std::uint64_t at = 0;     // its size field, in the file
        std::uint64_t start = 0;  // of its bytes among all uncompressed bytes
    };

    std::string damaged() const;
    std::string read_at(std::uint64_t at, std::uint64_t size) const;  // less at the end of the file

    int descriptor_ = -1;
    std::string_view bytes_{};          // if there is no descriptor
    std::uint64_t at_ = 0, start_ = 0;  // of the next chunk
    std::vector<Chunk> chunks_;
    std::string failure_;
    bool is_foreign_ = false;
};

}  // namespace twinlight::trace
