#include "reference/fog.h"

#include <cmath>

namespace twinlight::reference {

double fog_factor(const Fog& fog, double distance) {
    const double thickness = fog.density * distance;
    switch (fog.mode) {
        case kGL_LINEAR:
            if (fog.end == fog.start) return distance < fog.end ? 1 : 0;
            return clamp01((fog.end - distance) / (fog.end - fog.start));
        case kGL_EXP2: return clamp01(std::exp(-thickness * thickness));
    }
    return clamp01(std::exp(-thickness));  // GL_EXP
}

}  // namespace twinlight::reference
