// Buffer objects (2.9).

#include <algorithm>

#include "scene/state/arrays.h"

namespace twinlight {

namespace {

constexpr Enum kUsages[] = {kGL_STREAM_DRAW, kGL_STREAM_READ,  kGL_STREAM_COPY,  kGL_STATIC_DRAW, kGL_STATIC_READ,
                            kGL_STATIC_COPY, kGL_DYNAMIC_DRAW, kGL_DYNAMIC_READ, kGL_DYNAMIC_COPY};

// The bytes that a command copies from its memory; nullopt if the memory is too small.
std::optional<std::span<const std::byte>> source(const Command& c, double offset, double size) {
    if (!c.memory || offset < 0 || offset + size > static_cast<double>(c.memory->bytes.size())) return std::nullopt;
    return std::span(c.memory->bytes).subspan(static_cast<std::size_t>(offset), static_cast<std::size_t>(size));
}

GlError wrong_target(const Command& c) {
    return refused(kGL_INVALID_ENUM, c,
                   "{} is given the target {}; expected GL_ARRAY_BUFFER or GL_ELEMENT_ARRAY_BUFFER", c.name(),
                   enum_name(c.enumerant(0)));
}

GlError beyond_memory(const Command& c, double offset, double size) {
    const double available = c.memory ? static_cast<double>(c.memory->bytes.size()) - offset : 0;
    return undefined(kGL_INVALID_OPERATION, c, "{} reads {} bytes, but its array has {}", c.name(), size, available);
}

}  // namespace

const BufferObject* VertexArrays::buffer(std::uint32_t name) const {
    const auto found = buffers_.find(name);
    return found == buffers_.end() ? nullptr : found->second.get();
}

std::uint32_t* VertexArrays::binding(Enum target) {
    switch (target) {
        case kGL_ARRAY_BUFFER: return &client_.array_buffer;
        case kGL_ELEMENT_ARRAY_BUFFER: return &client_.element_buffer;
        case kGL_PIXEL_PACK_BUFFER: return &pixel_pack_;
        case kGL_PIXEL_UNPACK_BUFFER: return &pixel_unpack_;
        default: return nullptr;
    }
}

std::optional<GlError> VertexArrays::generate(const Command& c) {
    if (c.number(0) < 0)
        return refused(kGL_INVALID_VALUE, c, "glGenBuffers is given the count {}; it must be 0 or more", c.number(0));
    for (double name : c.array()) buffers_.try_emplace(static_cast<std::uint32_t>(name), nullptr);
    return std::nullopt;
}

// Deleted buffers are unbound everywhere, also from array pointers. 0 and unused names are ignored.
std::optional<GlError> VertexArrays::remove(const Command& c) {
    if (c.number(0) < 0)
        return refused(kGL_INVALID_VALUE, c, "glDeleteBuffers is given the count {}; it must be 0 or more",
                       c.number(0));
    for (double value : c.array()) {
        const auto name = static_cast<std::uint32_t>(value);
        const auto found = buffers_.find(name);
        if (name == 0 || found == buffers_.end()) continue;
        if (found->second) buffer_bytes_ -= found->second->bytes.size();
        buffers_.erase(found);
        for (std::uint32_t* bound : {&client_.array_buffer, &client_.element_buffer, &pixel_pack_, &pixel_unpack_})
            if (*bound == name) *bound = 0;
        // An array in this buffer has no memory any more.
        const auto leave = [name](ArrayPointer& array) {
            if (array.buffer != name) return;
            array.buffer = 0;
            array.memory.reset();
        };
        for (ArrayPointer* array : {&client_.vertex, &client_.normal, &client_.color, &client_.edge_flag})
            leave(*array);
        for (ArrayPointer& unit : client_.tex_coord) leave(unit);
    }
    return std::nullopt;
}

// GL allows names that were never generated.
std::optional<GlError> VertexArrays::bind(const Command& c) {
    std::uint32_t* bound = binding(c.enumerant(0));
    if (!bound) return wrong_target(c);
    *bound = c.enumerant(1);
    if (*bound == 0) return std::nullopt;
    std::shared_ptr<BufferObject>& buffer = buffers_[*bound];
    if (!buffer) buffer = std::make_shared<BufferObject>();
    return std::nullopt;
}

BufferObject* VertexArrays::bound(const Command& c, Result& error) {
    const std::uint32_t* name = binding(c.enumerant(0));
    if (name && *name != 0) return buffers_.at(*name).get();
    error = !name ? wrong_target(c)
                  : refused(kGL_INVALID_OPERATION, c, "{}: no buffer is bound to {}; call glBindBuffer first", c.name(),
                            enum_name(c.enumerant(0)));
    return nullptr;
}

// glBufferData(target, size, data, usage)
std::optional<GlError> VertexArrays::data(const Command& c) {
    Result error;
    BufferObject* buffer = bound(c, error);
    if (!buffer) return error;
    const double size = c.number(1), offset = c.number(2);
    const Enum usage = c.enumerant(3);
    if (size < 0) return refused(kGL_INVALID_VALUE, c, "the size of glBufferData is {}; it must be 0 or more", size);
    if (std::find(std::begin(kUsages), std::end(kUsages), usage) == std::end(kUsages)) {
        return refused(kGL_INVALID_ENUM, c,
                       "glBufferData is given the usage {}; expected GL_STATIC_DRAW, GL_DYNAMIC_DRAW, "
                       "GL_STREAM_DRAW, ...",
                       enum_name(usage));
    }
    if (size > static_cast<double>(kMaxBufferBytes - (buffer_bytes_ - buffer->bytes.size()))) {
        return undefined(kGL_OUT_OF_MEMORY, c, "all buffer objects together can have at most {} MiB",
                         kMaxBufferBytes >> 20);
    }
    const bool is_null = !c.memory && offset == 0;
    const auto given = source(c, offset, size);
    if (!is_null && !given) return beyond_memory(c, offset, size);
    buffer_bytes_ -= buffer->bytes.size();
    // RULING: without data the buffer is filled with 0; section 2.9 leaves this open.
    buffer->bytes.assign(static_cast<std::size_t>(size), std::byte{0});
    if (given) std::copy(given->begin(), given->end(), buffer->bytes.begin());
    buffer_bytes_ += buffer->bytes.size();
    buffer->usage = usage;
    buffer->mapped = false;
    return std::nullopt;
}

// glBufferSubData(target, offset, size, data)
std::optional<GlError> VertexArrays::sub_data(const Command& c) {
    Result error;
    BufferObject* buffer = bound(c, error);
    if (!buffer) return error;
    const double at = c.number(1), size = c.number(2), offset = c.number(3);
    if (at < 0 || size < 0 || at + size > static_cast<double>(buffer->bytes.size())) {
        return refused(kGL_INVALID_VALUE, c, "glBufferSubData writes {} bytes at offset {}, but the buffer has {}",
                       size, at, buffer->bytes.size());
    }
    if (buffer->mapped)
        return refused(kGL_INVALID_OPERATION, c, "glBufferSubData writes to a mapped buffer; call glUnmapBuffer first");
    if (size == 0) return std::nullopt;
    const auto given = source(c, offset, size);
    if (!given) return beyond_memory(c, offset, size);
    std::copy(given->begin(), given->end(), buffer->bytes.begin() + static_cast<std::ptrdiff_t>(at));
    return std::nullopt;
}

// No command shows what a program writes to mapped memory. In a recording the writes appear as glBufferSubData after
// glUnmapBuffer.
std::optional<GlError> VertexArrays::map(const Command& c) {
    const Enum access = c.enumerant(1);
    if (access != kGL_READ_ONLY && access != kGL_WRITE_ONLY && access != kGL_READ_WRITE) {
        return refused(kGL_INVALID_ENUM, c,
                       "glMapBuffer is given {}; expected GL_READ_ONLY, GL_WRITE_ONLY or GL_READ_WRITE",
                       enum_name(access));
    }
    Result error;
    BufferObject* buffer = bound(c, error);
    if (!buffer) return error;
    if (buffer->mapped)
        return refused(kGL_INVALID_OPERATION, c, "this buffer is already mapped; call glUnmapBuffer first");
    buffer->mapped = true;
    return std::nullopt;
}

std::optional<GlError> VertexArrays::unmap(const Command& c) {
    Result error;
    BufferObject* buffer = bound(c, error);
    if (!buffer) return error;
    if (!buffer->mapped) return refused(kGL_INVALID_OPERATION, c, "glUnmapBuffer without a glMapBuffer");
    buffer->mapped = false;
    return std::nullopt;
}

}  // namespace twinlight
