// The bytes that a pointer argument points at, value by value: GL's types as they lie in memory, in this machine's order
// of bytes.
#pragma once

#include <cstddef>
#include <span>

#include "scene/command/command.h"

namespace twinlight {

std::size_t size_of(Kind kind);           // in bytes; of a quadric and a word those of their number
std::string_view c_type_name(Kind kind);  // "GLfloat"
Kind c_type(Kind kind);                   // one kind for those that are the same C type (GLint and GLsizei, ...)
inline bool is_real(Kind kind) { return kind == Kind::kFloat || kind == Kind::kDouble; }

// The value of `kind` at the start of `bytes`, which holds at least size_of(kind) of them.
double load(std::span<const std::byte> bytes, Kind kind);
// Puts `value`, which the kind can hold, there.
void store(std::span<std::byte> bytes, Kind kind, double value);

}  // namespace twinlight
