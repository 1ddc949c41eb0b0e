// How much memory the pictures of a scene may need. Too much is an error before any is drawn.
#pragma once

#include <cstddef>
#include <cstdint>

#include "scene/frame/picture_memory.h"
#include "scene/state/state.h"

namespace twinlight {

struct MemoryBudget {
    std::size_t bytes = kDefaultMemory;
    // What the command holds for each pixel at one time, measured: see bytes_of_pictures().
    std::size_t bytes_of_pixel = 0;
    // How much of it stays for each further step of a scene.
    std::size_t bytes_of_step_pixel = 0;
    bool has_option = true, has_size = true;  // whether the command has --memory and --size
};

// Throws UsageError, which shows what fits, if pictures of this size need more memory than is allowed. `pictures`: what they need, in
// bytes; `besides`: what is needed whatever their size is.
void check_fits(const MemoryBudget& memory, int width, int height, std::uint64_t pictures, std::uint64_t besides = 0);

}  // namespace twinlight
