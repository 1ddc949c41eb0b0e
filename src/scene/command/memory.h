// The bytes that a pointer argument points at, value by value: GL's types as they lie in memory, in this machine's order
// of bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <tuple>

#include "scene/command/command.h"

namespace twinlight {

// The C types of the kinds, in the kinds' order; of a quadric and a word that of their number.
using CTypes =
    std::tuple<std::uint32_t, std::uint32_t, std::uint8_t, std::int8_t, std::int16_t, std::int32_t, std::int32_t,
               std::uint8_t, std::uint16_t, std::uint32_t, float, double, std::int64_t, std::uint32_t, std::uint32_t>;
static_assert(std::tuple_size_v<CTypes> == static_cast<std::size_t>(Kind::kWord) + 1);
template <Kind kind>
using CType = std::tuple_element_t<static_cast<std::size_t>(kind), CTypes>;

std::size_t size_of(Kind kind);           // in bytes
std::string_view c_type_name(Kind kind);  // "GLfloat"
Kind c_type(Kind kind);                   // one kind for those that are the same C type (GLint and GLsizei, ...)
// The kind of GL_BYTE to GL_DOUBLE, the types of arrays, pixels and names; nothing for other names.
std::optional<Kind> kind_of_type(Enum type);
inline bool is_real(Kind kind) { return kind == Kind::kFloat || kind == Kind::kDouble; }

// The values that a kind of whole numbers can have; {0, 0} for real numbers, which have no such range.
struct WholeRange {
    double smallest, largest;
};
WholeRange whole_range(Kind kind);

// The value of `kind` at the start of `bytes`, which holds at least size_of(kind) of them.
double load(std::span<const std::byte> bytes, Kind kind);
// Puts `value`, which the kind can hold, there.
void store(std::span<std::byte> bytes, Kind kind, double value);

}  // namespace twinlight
