#include "scene/state/gl_error.h"

#include <algorithm>
#include <cmath>

namespace twinlight {

// GL 2.1, table 2.9.
double real_from(double c, Kind kind, SignedRule rule) {
    const auto from_signed = [&](int bits) {
        const double largest = std::exp2(bits - 1) - 1;
        return rule == SignedRule::kGl21 ? (2 * c + 1) / (std::exp2(bits) - 1) : std::max(c / largest, -1.0);
    };
    switch (kind) {
        case Kind::kByte: return from_signed(8);
        case Kind::kShort: return from_signed(16);
        case Kind::kInt:
        case Kind::kSizei: return from_signed(32);
        case Kind::kUbyte:
        case Kind::kBoolean: return c / 255;
        case Kind::kUshort: return c / 65535;
        case Kind::kUint:
        case Kind::kEnum:
        case Kind::kBitfield:
        case Kind::kSizeiptr:
        case Kind::kQuadric:
        case Kind::kWord: return c / 4294967295.0;
        case Kind::kFloat:
        case Kind::kDouble: return c;
    }
    return c;
}

}  // namespace twinlight
