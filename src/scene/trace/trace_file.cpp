#include "scene/trace/trace_file.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>

#include "base/image/file.h"
#include "base/text/translation.h"

namespace twinlight::trace {

namespace {

constexpr std::size_t kSizeBytes = 4, kSignatureBytes = 2, kMostChunk = 64u << 20;
constexpr std::uint64_t kMostTimes = 64;  // as long; three bytes can stand for 64

std::uint64_t little_endian(std::string_view bytes) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i)
        value |= std::uint64_t{static_cast<unsigned char>(bytes[i])} << (8 * i);
    return value;
}

// Writes the uncompressed bytes to `out` and moves that on. Returns whether they fill the space up to `end`.
bool uncompress(std::string_view in, char*& out, const char* end) {
    const char* const first = out;
    while (!in.empty()) {
        const auto tag = static_cast<unsigned char>(in[0]);
        in.remove_prefix(1);
        const auto room = static_cast<std::size_t>(end - out);
        if ((tag & 3) == 0) {  // a literal
            std::size_t length = tag >> 2;
            if (length >= 60) {
                const std::size_t more = length - 59;
                if (in.size() < more) return false;
                length = little_endian(in.substr(0, more));
                in.remove_prefix(more);
            }
            const bool is_whole = ++length <= in.size() && length <= room;
            length = std::min({length, in.size(), room});
            std::memcpy(out, in.data(), length);
            out += length;
            if (!is_whole) return false;
            in.remove_prefix(length);
            continue;
        }
        const std::size_t more = (tag & 3) == 3 ? 4 : tag & 3;
        if (in.size() < more) return false;
        std::size_t offset = little_endian(in.substr(0, more)), length = (tag >> 2) + 1U;
        if ((tag & 3) == 1) {
            offset |= std::size_t{tag & 0xE0U} << 3;
            length = ((tag >> 2) & 7U) + 4;
        }
        in.remove_prefix(more);
        if (offset == 0 || offset > static_cast<std::size_t>(out - first) || length > room) return false;
        if (offset >= length) {
            std::memcpy(out, out - offset, length);
            out += length;
        } else {  // a pattern that repeats
            for (; length > 0; --length, ++out) *out = *(out - offset);
        }
    }
    return out == end;
}

bool uncompress(std::string_view in, std::string& to) {
    const auto size = take_number(in);
    if (!size || *size > kMostChunk || *size > kMostTimes * in.size()) return false;
    const std::size_t start = to.size();
    to.resize(start + *size);
    char* out = to.data() + start;
    const bool is_whole = uncompress(in, out, to.data() + to.size());
    to.resize(static_cast<std::size_t>(out - to.data()));
    return is_whole;
}

}  // namespace

std::string chunk_of(std::string_view bytes) {
    std::string chunk;
    for (std::size_t size = bytes.size(); true; size >>= 7) {
        chunk += static_cast<char>((size & 0x7F) | (size > 0x7F ? 0x80 : 0));
        if (size <= 0x7F) break;
    }
    constexpr std::size_t kLongest = 1 << 16;
    while (!bytes.empty()) {
        const std::string_view piece = bytes.substr(0, kLongest);
        const std::size_t length = piece.size() - 1;
        chunk += {static_cast<char>(61 << 2), static_cast<char>(length & 0xFF), static_cast<char>(length >> 8)};
        chunk += piece;
        bytes.remove_prefix(piece.size());
    }
    std::string size(kSizeBytes, '\0');
    for (std::size_t i = 0; i < kSizeBytes; ++i) size[i] = static_cast<char>((chunk.size() >> (8 * i)) & 0xFF);
    return size + chunk;
}

std::string TraceFile::read_at(std::uint64_t at, std::uint64_t size) const {
    if (descriptor_ < 0) return std::string(bytes_.substr(std::min<std::uint64_t>(at, bytes_.size()), size));
    struct stat status {};
    if (::fstat(descriptor_, &status) != 0) return {};
    const auto end = static_cast<std::uint64_t>(status.st_size);
    size = std::min(size, end - std::min(end, at));
    std::string bytes(size, '\0');
    const ssize_t count = ::pread(descriptor_, bytes.data(), size, static_cast<off_t>(at));
    bytes.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    return bytes;
}

std::string TraceFile::damaged() const { return tr("the file is damaged at byte {}", at_); }

bool TraceFile::read_chunk(std::string& to) {
    if (!failure_.empty()) return false;
    if (at_ == 0) {
        const std::string signature = read_at(0, kSignatureBytes);
        if (signature.size() < kSignatureBytes) return false;
        is_foreign_ = signature != "at";
        if (is_foreign_) failure_ = tr("this is not the format of apitrace 5 to 13");
        at_ = kSignatureBytes;
        return read_chunk(to);
    }
    const std::string size = read_at(at_, kSizeBytes);
    if (size.size() < kSizeBytes) return false;
    const std::uint64_t length = little_endian(size);
    if (length > kMostChunk) {
        failure_ = damaged();
        return false;
    }
    const std::string compressed = read_at(at_ + kSizeBytes, length);
    if (compressed.size() < length) return false;  // apitrace is writing it
    chunks_.push_back({at_, start_});
    const std::size_t before = to.size();
    if (!uncompress(compressed, to)) failure_ = damaged();
    start_ += to.size() - before;
    at_ += kSizeBytes + length;
    return true;
}

bool TraceFile::read_cut_chunk(std::string& to) {
    if (!failure_.empty() || at_ == 0) return false;
    const std::string size = read_at(at_, kSizeBytes);
    if (size.empty()) return false;
    uncompress(read_at(at_ + kSizeBytes, little_endian(size)), to);
    return true;
}

void TraceFile::copy(const std::string& to, std::optional<std::uint64_t> size) const {
    std::ofstream out(to, std::ios::binary | std::ios::trunc);
    const auto copy_bytes = [&](std::uint64_t from, std::uint64_t end) {
        constexpr std::uint64_t kBlock = 1 << 20;
        while (from < end) {
            const std::string block = read_at(from, std::min(kBlock, end - from));
            if (block.empty()) return;
            out << block;
            from += block.size();
        }
    };
    if (!size || chunks_.empty()) {
        copy_bytes(0, std::numeric_limits<std::uint64_t>::max());
    } else {
        // The last one that starts before the end.
        const auto last = std::prev(
            std::find_if(chunks_.begin() + 1, chunks_.end(), [&](const Chunk& chunk) { return chunk.start >= *size; }));
        copy_bytes(0, last->at);
        std::string kept;
        uncompress(read_at(last->at + kSizeBytes, little_endian(read_at(last->at, kSizeBytes))), kept);
        kept.resize(*size - last->start);
        out << chunk_of(kept);
    }
    out.close();
    if (!out) throw FileError(tr("{}: cannot be written", to));
}

}  // namespace twinlight::trace
