// What of the lighting is done in another way than the scene says (2.14.1), one thing at a time.
#pragma once

#include <span>

#include "scene/state/frame.h"

namespace twinlight::study {

enum class LightingChange : std::uint8_t {
    kWhole,
    kNoSpecular,
    kReflection,  // (r.v)^(s/4) in the place of (n.h)^s
    kHalfVector,  // (n.h)^(4s) in the place of (r.v)^s
    kDistantViewer,
    kDirectional,  // lights in the direction in which the middle of the shape sees them
    kNoAttenuation,
    kNoSpots,
    kRescale,      // GL_RESCALE_NORMAL in the place of GL_NORMALIZE
    kNoNormalize,  // normals as they come
};

struct LightingChangeRow {
    LightingChange value;
    const char* key;
    const char* words;
    bool (*matters)(const Draw& draw);  // of a Draw that is lit
    void (*apply)(Draw& draw);
};
std::span<const LightingChangeRow> lighting_changes();

// Whether the scene has what is changed.
bool matters(const Frame& frame, LightingChange change);
Frame with_lighting_change(const Frame& frame, LightingChange change);

// Highlights of the same width by either vector: r.v is cos(2a) where n.h is cos(a), and for small angles
// cos(2a)^(s/4) is cos(a)^s but for terms of a^4 (F. Fisher, A. Woo, "R.E versus N.H Specular Highlights", Graphics Gems IV, 1994).
inline constexpr double kReflectionExponent = 0.25;

}  // namespace twinlight::study
