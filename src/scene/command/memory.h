// Reads and writes single values in memory: GL's types in the byte order of this machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <tuple>

#include "scene/command/command.h"

namespace twinlight {

// The C type of each kind, in the order of Kind. For quadrics and words it is the type of their number.
using CTypes =
    std::tuple<std::uint32_t, std::uint32_t, std::uint8_t, std::int8_t, std::int16_t, std::int32_t, std::int32_t,
               std::uint8_t, std::uint16_t, std::uint32_t, float, double, std::int64_t, std::uint32_t, std::uint32_t>;
static_assert(std::tuple_size_v<CTypes> == static_cast<std::size_t>(Kind::kWord) + 1);
template <Kind kind>
using CType = std::tuple_element_t<static_cast<std::size_t>(kind), CTypes>;

std::size_t size_of(Kind kind);           // in bytes
std::string_view c_type_name(Kind kind);  // "GLfloat"
Kind c_type(Kind kind);                   // the same kind for all names of one C type (GLint and GLsizei, ...)
// The kind of GL_BYTE to GL_DOUBLE, the types of arrays, pixels and names; nullopt for other values.
std::optional<Kind> kind_of_type(Enum type);
inline bool is_real(Kind kind) { return kind == Kind::kFloat || kind == Kind::kDouble; }

// The range of a kind of whole numbers; {0, 0} for real numbers.
struct WholeRange {
    double smallest, largest;
};
WholeRange whole_range(Kind kind);

// Reads a value from the start of `bytes`, which must have at least size_of(kind) bytes.
double load(std::span<const std::byte> bytes, Kind kind);
// Writes `value`, which must fit the kind, to the start of `bytes`.
void store(std::span<std::byte> bytes, Kind kind, double value);

}  // namespace twinlight
