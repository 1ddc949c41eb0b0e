// Refuses one allocation of the program: that of this number, counted over all threads from the start of its life.
#pragma once

#include <cstddef>

namespace twinlight {

class RefusedMemory {
  public:
    static constexpr long kNone = -1;  // only counts

    // `and_all_later`: all of them from this one on.
    explicit RefusedMemory(long number, bool and_all_later = false);
    ~RefusedMemory();
    RefusedMemory(const RefusedMemory&) = delete;
    RefusedMemory& operator=(const RefusedMemory&) = delete;

    long allocations() const;  // so far, with operator new
};

}  // namespace twinlight
