#include "scene/record/trace_follower.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>

#include "base/image/file.h"

namespace twinlight::trace {

namespace {

constexpr std::size_t kSizeBytes = 4, kSignatureBytes = 2, kMostChunk = 64u << 20;

std::uint64_t little_endian(std::string_view bytes) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i)
        value |= std::uint64_t{static_cast<unsigned char>(bytes[i])} << (8 * i);
    return value;
}

// Seven bits a byte, the lowest first.
std::optional<std::uint64_t> take_number(std::string_view& bytes) {
    std::uint64_t value = 0;
    for (int shift = 0; shift < 64 && !bytes.empty(); shift += 7) {
        const auto byte = static_cast<unsigned char>(bytes[0]);
        bytes.remove_prefix(1);
        value |= std::uint64_t{byte & 0x7FU} << shift;
        if (byte < 0x80) return value;
    }
    return std::nullopt;
}

// google/snappy, format_description.txt. Returns false for other bytes.
bool uncompress(std::string_view in, std::string& to) {
    const std::size_t start = to.size();
    const auto size = take_number(in);
    if (!size || *size > kMostChunk) return false;
    to.reserve(start + *size);
    while (!in.empty()) {
        const auto tag = static_cast<unsigned char>(in[0]);
        in.remove_prefix(1);
        if ((tag & 3) == 0) {  // a literal
            std::size_t length = tag >> 2;
            if (length >= 60) {
                const std::size_t more = length - 59;
                if (in.size() < more) return false;
                length = little_endian(in.substr(0, more));
                in.remove_prefix(more);
            }
            if (++length > in.size()) return false;
            to.append(in.substr(0, length));
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
        if (offset == 0 || offset > to.size() - start || to.size() - start + length > *size) return false;
        for (std::size_t i = 0; i < length; ++i) to += to[to.size() - offset];
    }
    return to.size() - start == *size;
}

// A chunk of literals only.
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

std::string read_at(const Descriptor& file, std::uint64_t at, std::size_t size) {
    std::string bytes(size, '\0');
    const ssize_t count = ::pread(file.get(), bytes.data(), size, static_cast<off_t>(at));
    bytes.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    return bytes;
}

}  // namespace

void TraceFollower::read_on(int most_chunks) {
    if (!descriptor_.valid()) descriptor_ = Descriptor(::open(file_.c_str(), O_RDONLY | O_CLOEXEC));
    if (!descriptor_.valid() || !failure_.empty()) return;
    if (read_ == 0) {
        const std::string signature = read_at(descriptor_, 0, kSignatureBytes);
        if (signature.size() < kSignatureBytes) return;
        if (signature != "at") failure_ = "not the format of apitrace 5 to 13";
        read_ = kSignatureBytes;
    }
    for (int i = 0; i < most_chunks && failure_.empty(); ++i) {
        const std::string size = read_at(descriptor_, read_, kSizeBytes);
        if (size.size() < kSizeBytes) return;
        const std::uint64_t length = little_endian(size);
        if (length > kMostChunk) {
            failure_ = "a chunk is damaged";
            return;
        }
        const std::string chunk = read_at(descriptor_, read_ + kSizeBytes, length);
        if (chunk.size() < length) return;  // apitrace is writing it
        read_chunk(chunk, read_);
        read_ += kSizeBytes + length;
    }
}

void TraceFollower::read_chunk(std::string_view compressed, std::uint64_t at) {
    chunks_.push_back({at, start_ + buffer_.size()});
    if (!uncompress(compressed, buffer_)) {
        failure_ = "a chunk is damaged";
        return;
    }
    read_events();
    buffer_.erase(0, position_);
    start_ += position_;
    position_ = 0;
}

void TraceFollower::read_events() {
    while (position_ < buffer_.size()) {
        const std::size_t event = position_;
        added_.clear();
        try {
            has_header_ ? read_event() : read_header();
        } catch (const Incomplete&) {
            position_ = event;
            for (const auto& [known, number] : added_) known->erase(number);
            return;
        } catch (const Unreadable&) {
            failure_ = "not a format that this version can read";
            return;
        }
    }
}

std::uint64_t TraceFollower::number() {
    std::string_view rest = std::string_view(buffer_).substr(position_);
    const auto value = take_number(rest);
    if (!value) throw Incomplete();
    position_ = buffer_.size() - rest.size();
    return *value;
}

std::string_view TraceFollower::bytes(std::uint64_t count) {
    if (count > buffer_.size() - position_) throw Incomplete();
    const std::string_view found = std::string_view(buffer_).substr(position_, count);
    position_ += count;
    return found;
}

bool TraceFollower::is_new(std::unordered_set<std::uint64_t>& known, std::uint64_t id) {
    if (!known.insert(id).second) return false;
    added_.emplace_back(&known, id);
    return true;
}

void TraceFollower::read_header() {
    version_ = number();
    constexpr std::uint64_t kFirst = 4, kWithProperties = 6;
    if (version_ < kFirst || version_ > kWithProperties) throw Unreadable();
    if (version_ == kWithProperties) {
        number();
        while (!text().empty()) text();
    }
    has_header_ = true;
}

void TraceFollower::read_event() {
    const std::uint64_t event = number();
    if (event > 1) throw Unreadable();
    if (event == 1) {  // a call has returned
        const std::uint64_t call = number();
        read_details();
        if (swaps_.erase(call) > 0) frame_ends_.push_back(start_ + position_);
        return;
    }
    number();  // the thread
    const std::uint64_t signature = number();
    std::string name;
    if (const auto found = functions_.find(signature); found != functions_.end()) {
        name = found->second;
    } else {
        name = text();
        for (std::uint64_t left = number(); left > 0; --left) text();
    }
    read_details();
    functions_.try_emplace(signature, name);
    const Function& function = table_.find(name);
    if (function.role == Role::kFrameEnd) swaps_.insert(calls_);
    if (name == "glNewList" || name == "glEndList") in_list_ = name == "glNewList";
    if ((function.draws || function.is_vertex) && !in_list_ && !has_drawn()) first_drawn_ = frames();
    ++calls_;
}

void TraceFollower::read_details() {
    enum Detail : std::uint64_t { kEnd, kArgument, kResult, kThread, kStack, kFlags };
    while (true) {
        switch (number()) {
            case kEnd: return;
            case kArgument:
                number();
                read_value();
                break;
            case kResult: read_value(); break;
            case kThread:
            case kFlags: number(); break;
            case kStack:
                for (std::uint64_t left = number(); left > 0; --left) read_stack_frame();
                break;
            default: throw Unreadable();
        }
    }
}

void TraceFollower::read_stack_frame() {
    enum Detail : std::uint64_t { kEnd, kModule, kFunction, kFile, kLine, kOffset };
    if (!is_new(stack_frames_, number())) return;
    while (true) {
        switch (number()) {
            case kEnd: return;
            case kModule:
            case kFunction:
            case kFile: text(); break;
            case kLine:
            case kOffset: number(); break;
            default: throw Unreadable();
        }
    }
}

void TraceFollower::read_value() {
    enum Type : std::uint64_t {
        kNull,
        kFalse,
        kTrue,
        kNegative,
        kPositive,
        kFloat,
        kDouble,
        kString,
        kBlob,
        kEnum,
        kBitmask,
        kArray,
        kStructure,
        kPointer,
        kTwoForms,
        kWideString
    };
    constexpr int kDeepest = 64;
    if (++depth_ > kDeepest) throw Unreadable();
    const auto leave = [](int* depth) { --*depth; };
    const std::unique_ptr<int, decltype(leave)> end(&depth_, leave);
    switch (number()) {
        case kNull:
        case kFalse:
        case kTrue: return;
        case kNegative:
        case kPositive:
        case kPointer: number(); return;
        case kFloat: bytes(sizeof(float)); return;
        case kDouble: bytes(sizeof(double)); return;
        case kString:
        case kBlob: text(); return;
        case kEnum:
            if (is_new(enums_, number()))
                for (std::uint64_t left = number(); left > 0; --left) {
                    text();
                    read_value();
                }
            return read_value();
        case kBitmask:
            if (is_new(bitmasks_, number()))
                for (std::uint64_t left = number(); left > 0; --left) {
                    text();
                    number();
                }
            number();
            return;
        case kArray:
            for (std::uint64_t left = number(); left > 0; --left) read_value();
            return;
        case kStructure: {
            const std::uint64_t id = number();
            if (is_new(structures_, id)) {
                text();
                members_[id] = number();
                for (std::uint64_t left = members_[id]; left > 0; --left) text();
            }
            for (std::uint64_t left = members_[id]; left > 0; --left) read_value();
            return;
        }
        case kTwoForms: read_value(); return read_value();
        case kWideString:
            for (std::uint64_t left = number(); left > 0; --left) number();
            return;
        default: throw Unreadable();
    }
}

void TraceFollower::copy_frames(int count, const std::string& to) const {
    std::ofstream out(to, std::ios::binary | std::ios::trunc);
    const auto copy = [&](std::uint64_t from, std::uint64_t end) {
        constexpr std::uint64_t kBlock = 1 << 20;
        while (from < end) {
            const std::string block = read_at(descriptor_, from, std::min(kBlock, end - from));
            if (block.empty()) return;
            out << block;
            from += block.size();
        }
    };
    if (count >= frames() || !failure_.empty()) {
        copy(0, std::numeric_limits<std::uint64_t>::max());
    } else {
        const std::uint64_t end = frame_ends_[static_cast<std::size_t>(count) - 1];
        const auto last = std::prev(std::ranges::upper_bound(chunks_, end, std::ranges::less_equal(), &Chunk::start));
        copy(0, last->at);
        const std::uint64_t size = little_endian(read_at(descriptor_, last->at, kSizeBytes));
        std::string kept;
        uncompress(read_at(descriptor_, last->at + kSizeBytes, size), kept);
        kept.resize(end - last->start);
        out << chunk_of(kept);
    }
    out.close();
    if (!out) throw FileError(to + ": cannot be written");
}

}  // namespace twinlight::trace
