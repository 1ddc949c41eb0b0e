// How much of a long test runs: all of it in CI (where CI is set in the environment), a quarter elsewhere.
#pragma once

#include <algorithm>
#include <cstdlib>

namespace twinlight {

inline bool runs_whole() {
    const char* ci = std::getenv("CI");
    return ci != nullptr && *ci != '\0';
}

inline int rounds(int n) { return runs_whole() ? n : std::max(1, n / 4); }

// How much random rounds must find: of fewer rounds half as much, since chance weighs more there.
inline int least_found(int n) { return runs_whole() ? n : n / 8; }

// Whether row i of a table is tried.
inline bool is_tried(int i) { return runs_whole() || i % 4 == 0; }

}  // namespace twinlight
