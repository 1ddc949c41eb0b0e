// Long tests try a quarter of their cases, and all of them if the environment variable ALL_CASES is set.
#pragma once

#include <algorithm>
#include <cstdlib>

namespace twinlight {

inline bool tries_all() {
    const char* all = std::getenv("ALL_CASES");
    return all != nullptr && *all != '\0';
}

inline int rounds(int n) { return tries_all() ? n : std::max(1, n / 4); }

// How much the rounds must find: n of all, and n / 8 of a quarter, where chance weighs more.
inline int least_found(int n) { return tries_all() ? n : n / 8; }

// Whether to try case i.
inline bool is_tried(int i) { return tries_all() || i % 4 == 0; }

}  // namespace twinlight
