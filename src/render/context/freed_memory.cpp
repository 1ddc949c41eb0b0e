#include "render/context/context.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace twinlight {

void keep_freed_memory() {
#ifdef __GLIBC__
    constexpr int kMegabyte = 1 << 20;
    mallopt(M_MMAP_THRESHOLD, 4 * kMegabyte);  // larger ones still go back at once
    mallopt(M_TRIM_THRESHOLD, 64 * kMegabyte);
#endif
}

}  // namespace twinlight
