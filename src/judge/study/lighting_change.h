// Changes of the scene's lighting model (2.14.1), one at a time: simpler or different lighting whose cost a study
// measures.
#pragma once

#include <span>

#include "scene/frame/frame.h"

namespace twinlight::study {

enum class LightingChange : std::uint8_t {
    kWhole,
    kNoSpecular,
    kReflection,  // (r.v)^(s/4) instead of (n.h)^s
    kHalfVector,  // (n.h)^(4s) instead of (r.v)^s
    kDistantViewer,
    kDirectional,  // each light in its direction from the middle of the shape
    kNoAttenuation,
    kNoSpots,
    kRescale,      // GL_RESCALE_NORMAL instead of GL_NORMALIZE
    kNoNormalize,  // normals are not normalised
};

struct LightingChangeRow {
    LightingChange value;
    const char* key;
    const char* words;
    bool (*matters)(const Draw& draw);  // whether the change applies; the Draw is lit
    void (*apply)(Draw& draw);
};
std::span<const LightingChangeRow> lighting_changes();

// Whether the change applies to the scene.
bool matters(const Frame& frame, LightingChange change);
Frame with_lighting_change(const Frame& frame, LightingChange change);

// Gives highlights of the same width with both vectors: r.v is cos(2a) where n.h is cos(a), and for small angles
// cos(2a)^(s/4) equals cos(a)^s up to terms of a^4 (F. Fisher, A. Woo, "R.E versus N.H Specular Highlights", Graphics
// Gems IV, 1994).
inline constexpr double kReflectionExponent = 0.25;

}  // namespace twinlight::study
