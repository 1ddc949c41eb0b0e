#include "scene/command/memory.h"

#include <array>
#include <cstring>
#include <limits>
#include <tuple>
#include <type_traits>
#include <utility>

namespace twinlight {

namespace {

// Calls `use` with a value of the kind's C type.
template <std::size_t i = 0, class Use>
constexpr auto with_type(Kind kind, Use use) {
    if constexpr (i + 1 < std::tuple_size_v<CTypes>) {
        if (kind != static_cast<Kind>(i)) return with_type<i + 1>(kind, use);
    }
    return use(std::tuple_element_t<i, CTypes>{});
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
        case Kind::kWord: break;  // words occur only in pragmas, never in arrays
    }
    return "";
}

Kind c_type(Kind kind) {
    if (kind == Kind::kSizei) return Kind::kInt;
    if (kind == Kind::kEnum || kind == Kind::kBitfield) return Kind::kUint;
    if (kind == Kind::kBoolean) return Kind::kUbyte;
    return kind;
}

std::optional<Kind> kind_of_type(Enum type) {
    switch (type) {
        case kGL_BYTE: return Kind::kByte;
        case kGL_UNSIGNED_BYTE: return Kind::kUbyte;
        case kGL_SHORT: return Kind::kShort;
        case kGL_UNSIGNED_SHORT: return Kind::kUshort;
        case kGL_INT: return Kind::kInt;
        case kGL_UNSIGNED_INT: return Kind::kUint;
        case kGL_FLOAT: return Kind::kFloat;
        case kGL_DOUBLE: return Kind::kDouble;
        default: return std::nullopt;
    }
}

namespace {

constexpr WholeRange range_of(Kind kind) {
    if (kind == Kind::kSizeiptr) return {-0x1p53, 0x1p53};  // doubles hold these whole numbers exactly
    return with_type(kind, []<class T>(T) -> WholeRange {
        if constexpr (!std::is_integral_v<T>) return {0, 0};
        return {static_cast<double>(std::numeric_limits<T>::min()), static_cast<double>(std::numeric_limits<T>::max())};
    });
}

template <std::size_t... i>
constexpr std::array<WholeRange, sizeof...(i)> ranges(std::index_sequence<i...> /*kinds*/) {
    return {range_of(static_cast<Kind>(i))...};
}

// Indexed by kind. A table, because reading a recording looks up the range of every whole number.
constexpr auto kRanges = ranges(std::make_index_sequence<std::tuple_size_v<CTypes>>());

}  // namespace

WholeRange whole_range(Kind kind) { return kRanges.at(static_cast<std::size_t>(kind)); }

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
