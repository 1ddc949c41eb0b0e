// What the shadings are called: by options, in reports, in studies.
#pragma once

#include "scene/state/frame.h"

namespace twinlight {

struct ShadingName {
    Shading value;
    const char* key;
    const char* words;
};
inline constexpr ShadingName kShadings[] = {
    {Shading::kFlat, "flat", "flat"},
    {Shading::kGouraud, "gouraud", "gouraud"},
    {Shading::kPhong, "phong", "phong"},
    {Shading::kExact, "exact", "exact"},
};

inline const char* name_of(Shading shading) {
    for (const ShadingName& name : kShadings)
        if (name.value == shading) return name.key;
    return "";
}

}  // namespace twinlight
