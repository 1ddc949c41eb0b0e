// Look: the options that every renderer takes.
#pragma once

#include <cstdint>
#include <optional>

namespace twinlight {

// kPhong lights every pixel of the mesh. kExact lights every pixel of the exact surface that the mesh approximates, or
// of the mesh where there is no exact surface.
enum class Shading : std::uint8_t { kFlat, kGouraud, kPhong, kExact };

// The names of the shadings in options, reports and studies.
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

inline bool lights_every_pixel(std::optional<Shading> shading) {
    return shading == Shading::kPhong || shading == Shading::kExact;
}

struct Look {
    std::optional<Shading> shading{};  // empty: flat or gouraud, by each Draw's glShadeModel
    bool lecture_variants = true;      // false: GL's own model; ignores the pragmas' variants

    friend bool operator==(const Look&, const Look&) = default;
};

// A picture that lights vertices follows GL's own model, so that all renderers can draw it. One that lights every pixel, which GL
// lacks, follows the scene's variants. `variants`: also the first.
inline Look look_of(std::optional<Shading> shading, bool variants) {
    return {.shading = shading, .lecture_variants = variants || lights_every_pixel(shading)};
}

}  // namespace twinlight
