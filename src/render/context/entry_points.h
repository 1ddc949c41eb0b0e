// GL's functions in a program that loads GL while it runs: the program has a function of each name, which calls that of the library.
// The linker exports them, so that GLU's calls come here, too, whichever GL was loaded. entry_points.awk writes them from GL's headers.
#pragma once

#include <cstddef>

namespace twinlight {

struct EntryPoint {
    const char* name;
    void* address;  // nullptr: the library has no such function, or none is loaded yet
};
extern EntryPoint entry_points[];
extern const std::size_t kEntryPoints;

// What a call of a function ends in that the library lacks: throws std::runtime_error.
[[noreturn]] void throw_missing_function(const EntryPoint& function);

}  // namespace twinlight
