#include "render/reference/textures/comparison.h"

namespace twinlight::reference {

namespace {

// Two depths closer than this may be stored as the same number in a 24-bit buffer, since each is rounded.
constexpr double kDepthQuantum = 2 * kDepthStep;

}  // namespace

bool compares(Enum func, double incoming, double stored) {
    switch (func) {
        case kGL_NEVER: return false;
        case kGL_LESS: return incoming < stored;
        case kGL_EQUAL: return incoming == stored;
        case kGL_LEQUAL: return incoming <= stored;
        case kGL_GREATER: return incoming > stored;
        case kGL_NOTEQUAL: return incoming != stored;
        case kGL_GEQUAL: return incoming >= stored;
    }
    return true;  // GL_ALWAYS
}

Outcome depth_outcome(Enum depth_func, const Interval& difference) {
    if (depth_func == kGL_ALWAYS || depth_func == kGL_NEVER) return outcome_of(depth_func == kGL_ALWAYS);
    const bool nearer = difference.high<-kDepthQuantum, farther = difference.low> kDepthQuantum;
    if (!nearer && !farther) return Outcome::kOpen;
    // Equality is impossible here, so one comparison decides.
    return outcome_of(compares(depth_func, nearer ? -1 : 1, 0));
}

}  // namespace twinlight::reference
