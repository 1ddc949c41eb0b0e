// Types whose components share a byte, a short or an int (table 3.8).
#pragma once

#include <array>

#include "scene/command/names.h"

namespace twinlight {

// The components of a packed type: their bits, and whether the first one is in the lowest bits (_REV).
struct Packed {
    Enum type;
    int bytes;
    std::array<int, 4> bits;  // 0: no such component
    bool reversed;
};

inline constexpr Packed kPacked[] = {
    {kGL_UNSIGNED_BYTE_3_3_2, 1, {3, 3, 2, 0}, false},
    {kGL_UNSIGNED_BYTE_2_3_3_REV, 1, {3, 3, 2, 0}, true},
    {kGL_UNSIGNED_SHORT_5_6_5, 2, {5, 6, 5, 0}, false},
    {kGL_UNSIGNED_SHORT_5_6_5_REV, 2, {5, 6, 5, 0}, true},
    {kGL_UNSIGNED_SHORT_4_4_4_4, 2, {4, 4, 4, 4}, false},
    {kGL_UNSIGNED_SHORT_4_4_4_4_REV, 2, {4, 4, 4, 4}, true},
    {kGL_UNSIGNED_SHORT_5_5_5_1, 2, {5, 5, 5, 1}, false},
    {kGL_UNSIGNED_SHORT_1_5_5_5_REV, 2, {5, 5, 5, 1}, true},
    {kGL_UNSIGNED_INT_8_8_8_8, 4, {8, 8, 8, 8}, false},
    {kGL_UNSIGNED_INT_8_8_8_8_REV, 4, {8, 8, 8, 8}, true},
    {kGL_UNSIGNED_INT_10_10_10_2, 4, {10, 10, 10, 2}, false},
    {kGL_UNSIGNED_INT_2_10_10_10_REV, 4, {10, 10, 10, 2}, true},
};

// Null for a type that is not packed.
inline const Packed* find_packed(Enum type) {
    for (const Packed& row : kPacked)
        if (row.type == type) return &row;
    return nullptr;
}

}  // namespace twinlight
