// Which picture of a scene is wanted: what every renderer is asked.
#pragma once

#include <cstdint>
#include <optional>

namespace twinlight {

// kPhong: every pixel of the mesh lit. kExact: every pixel of the surface that the mesh stands for; of the mesh where there is none.
enum class Shading : std::uint8_t { kFlat, kGouraud, kPhong, kExact };

// What the shadings are called: by options, in reports, in studies.
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

struct Look {
    std::optional<Shading> shading{};  // nothing: flat or gouraud, as each Draw's glShadeModel says
    bool lecture_variants = true;      // false: GL's own model, the pragmas' variants off
};

}  // namespace twinlight
