#include "render/context/context.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace twinlight {

void keep_freed_memory() {
#ifdef __GLIBC__
    constexpr int kMegabyte = 1 << 20;
    mallopt(M_MMAP_THRESHOLD, 32 * kMegabyte);  // the most that glibc takes: pictures of 1920 x 1080 have 33
    mallopt(M_TRIM_THRESHOLD, 256 * kMegabyte);
#endif
}

}  // namespace twinlight
