// Replaces operator new of the whole program. Without a RefusedMemory, it does what the library's does.
#include "refused_memory.h"

#include <dlfcn.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <limits>
#include <new>

namespace {

std::atomic<bool> counts = false;
std::atomic<long> allocated = 0, first_refused = 0, last_refused = 0;

// Throws if this allocation is refused.
[[gnu::noinline, gnu::cold]] void count_one() {
    const long number = ++allocated;
    if (first_refused <= number && number <= last_refused) throw std::bad_alloc();
}

}  // namespace

namespace twinlight {

RefusedMemory::RefusedMemory(long number, bool and_all_later) {
    allocated = 0;
    first_refused = number == kNone ? std::numeric_limits<long>::max() : number;
    last_refused = number == kNone || and_all_later ? std::numeric_limits<long>::max() : number;
    counts = true;
}
RefusedMemory::~RefusedMemory() { counts = false; }

long RefusedMemory::allocations() const { return allocated; }

}  // namespace twinlight

// The other forms of operator new call these.
#ifndef __SANITIZE_ADDRESS__

[[gnu::noinline]] void* operator new(std::size_t bytes) {
    if (counts.load(std::memory_order_relaxed)) count_one();
    if (void* const memory = std::malloc(bytes > 0 ? bytes : 1)) return memory;
    throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(std::size_t bytes, std::align_val_t alignment) {
    if (counts.load(std::memory_order_relaxed)) count_one();
    const auto unit = static_cast<std::size_t>(alignment);
    if (void* const memory = std::aligned_alloc(unit, (std::max<std::size_t>(bytes, 1) + unit - 1) / unit * unit))
        return memory;
    throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

#elif !defined(__clang__)  // whose sanitizer is a part of the program, not a library behind it

// The address sanitizer's own operator new does the work, so that it still finds memory that is freed in a wrong way.
namespace {
template <class... Arguments>
void* allocated_by_sanitizer(void*& function, const char* name, Arguments... arguments) {
    if (counts.load(std::memory_order_relaxed)) count_one();
    if (!function) function = ::dlsym(RTLD_NEXT, name);
    return reinterpret_cast<void* (*)(Arguments...)>(function)(arguments...);
}
void *new_one, *new_array, *new_one_aligned, *new_array_aligned;
}  // namespace

void* operator new(std::size_t bytes) { return allocated_by_sanitizer(new_one, "_Znwm", bytes); }
void* operator new[](std::size_t bytes) { return allocated_by_sanitizer(new_array, "_Znam", bytes); }
void* operator new(std::size_t bytes, std::align_val_t alignment) {
    return allocated_by_sanitizer(new_one_aligned, "_ZnwmSt11align_val_t", bytes, alignment);
}
void* operator new[](std::size_t bytes, std::align_val_t alignment) {
    return allocated_by_sanitizer(new_array_aligned, "_ZnamSt11align_val_t", bytes, alignment);
}

#endif
