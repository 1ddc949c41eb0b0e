#include "scene/command/memory.h"

#include <cstdint>
#include <cstring>

namespace twinlight {

namespace {

// Calls `use` with a value of the kind's C type.
template <class Use>
auto with_type(Kind kind, Use use) {
    switch (kind) {
        case Kind::kByte: return use(std::int8_t{});
        case Kind::kBoolean:
        case Kind::kUbyte: return use(std::uint8_t{});
        case Kind::kShort: return use(std::int16_t{});
        case Kind::kUshort: return use(std::uint16_t{});
        case Kind::kInt:
        case Kind::kSizei: return use(std::int32_t{});
        case Kind::kEnum:
        case Kind::kBitfield:
        case Kind::kWord:
        case Kind::kQuadric:
        case Kind::kUint: return use(std::uint32_t{});
        case Kind::kSizeiptr: return use(std::int64_t{});
        case Kind::kFloat: return use(float{});
        case Kind::kDouble: break;
    }
    return use(double{});
}

}  // namespace

std::size_t size_of(Kind kind) {
    return with_type(kind, [](auto value) { return sizeof value; });
}

std::string_view c_type_name(Kind kind) {
    switch (kind) {
        case Kind::kEnum: return "GLenum";
        case Kind::kBitfield: return "GLbitfield";
        case Kind::kBoolean: return "GLboolean";
        case Kind::kByte: return "GLbyte";
        case Kind::kShort: return "GLshort";
        case Kind::kInt: return "GLint";
        case Kind::kSizei: return "GLsizei";
        case Kind::kUbyte: return "GLubyte";
        case Kind::kUshort: return "GLushort";
        case Kind::kUint: return "GLuint";
        case Kind::kFloat: return "GLfloat";
        case Kind::kDouble: return "GLdouble";
        case Kind::kSizeiptr: return "GLsizeiptr";
        case Kind::kQuadric: return "GLUquadric*";
        case Kind::kWord: break;  // words stand in pragmas only, never in arrays
    }
    return "";
}

Kind c_type(Kind kind) {
    if (kind == Kind::kSizei) return Kind::kInt;
    if (kind == Kind::kEnum || kind == Kind::kBitfield) return Kind::kUint;
    if (kind == Kind::kBoolean) return Kind::kUbyte;
    return kind;
}

double load(std::span<const std::byte> bytes, Kind kind) {
    return with_type(kind, [&](auto value) {
        std::memcpy(&value, bytes.data(), sizeof value);
        return static_cast<double>(value);
    });
}

void store(std::span<std::byte> bytes, Kind kind, double value) {
    with_type(kind, [&](auto typed) {
        typed = static_cast<decltype(typed)>(value);
        std::memcpy(bytes.data(), &typed, sizeof typed);
    });
}

}  // namespace twinlight
