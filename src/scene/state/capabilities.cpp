// glEnable and glDisable: the list of capabilities, and which of them State supports.
#include "scene/state/capabilities.h"

#include <algorithm>

#include "scene/state/state.h"
#include "scene/state/state_variables.h"

namespace twinlight {

// The last column: whether the capability can change a pixel of what Twinlight draws.
std::span<const DriverOnlyCapability> driver_only_capabilities() {
    static constexpr DriverOnlyCapability kRows[] = {
        {kGL_POLYGON_SMOOTH, kGL_POLYGON_BIT, true},
        {kGL_INDEX_LOGIC_OP, kGL_COLOR_BUFFER_BIT, false},
        {kGL_DITHER, kGL_COLOR_BUFFER_BIT, false},
        {kGL_TEXTURE_RECTANGLE, kGL_TEXTURE_BIT, true},
        {kGL_MULTISAMPLE, kGL_MULTISAMPLE_BIT, false},
        {kGL_SAMPLE_ALPHA_TO_COVERAGE, kGL_MULTISAMPLE_BIT, false},
        {kGL_SAMPLE_ALPHA_TO_ONE, kGL_MULTISAMPLE_BIT, false},
        {kGL_SAMPLE_COVERAGE, kGL_MULTISAMPLE_BIT, false},
        {kGL_AUTO_NORMAL, kGL_EVAL_BIT, false},
        // State follows evaluators (evaluators.cpp), which have no effect on other drawing.
        {kGL_MAP1_COLOR_4, kGL_EVAL_BIT, false},
        {kGL_MAP1_INDEX, kGL_EVAL_BIT, false},
        {kGL_MAP1_NORMAL, kGL_EVAL_BIT, false},
        {kGL_MAP1_TEXTURE_COORD_1, kGL_EVAL_BIT, false},
        {kGL_MAP1_TEXTURE_COORD_2, kGL_EVAL_BIT, false},
        {kGL_MAP1_TEXTURE_COORD_3, kGL_EVAL_BIT, false},
        {kGL_MAP1_TEXTURE_COORD_4, kGL_EVAL_BIT, false},
        {kGL_MAP1_VERTEX_3, kGL_EVAL_BIT, false},
        {kGL_MAP1_VERTEX_4, kGL_EVAL_BIT, false},
        {kGL_MAP2_COLOR_4, kGL_EVAL_BIT, false},
        {kGL_MAP2_INDEX, kGL_EVAL_BIT, false},
        {kGL_MAP2_NORMAL, kGL_EVAL_BIT, false},
        {kGL_MAP2_TEXTURE_COORD_1, kGL_EVAL_BIT, false},
        {kGL_MAP2_TEXTURE_COORD_2, kGL_EVAL_BIT, false},
        {kGL_MAP2_TEXTURE_COORD_3, kGL_EVAL_BIT, false},
        {kGL_MAP2_TEXTURE_COORD_4, kGL_EVAL_BIT, false},
        {kGL_MAP2_VERTEX_3, kGL_EVAL_BIT, false},
        {kGL_MAP2_VERTEX_4, kGL_EVAL_BIT, false},
        {kGL_VERTEX_PROGRAM_POINT_SIZE, 0, false},
        {kGL_DEPTH_CLAMP, kGL_TRANSFORM_BIT, true},
    };
    return kRows;
}

const DriverOnlyCapability& driver_only_capability(Enum cap) {
    const auto rows = driver_only_capabilities();
    return *std::find_if(rows.begin(), rows.end(), [cap](const DriverOnlyCapability& row) { return row.cap == cap; });
}

namespace {

// A pointer to the flag of a capability that State supports; null for others.
template <class A>
auto* supported_flag(A& a, Enum cap) {
    using Flag = decltype(&a.lighting.enabled);
    if (cap >= kGL_LIGHT0 && cap < kGL_LIGHT0 + kMaxLights) return &a.lighting.lights[cap - kGL_LIGHT0].enabled;
    if (cap >= kGL_CLIP_PLANE0 && cap < kGL_CLIP_PLANE0 + kMaxClipPlanes)
        return &a.clip_planes[cap - kGL_CLIP_PLANE0].enabled;
    auto& unit = a.units[a.active_unit];
    if (cap >= kGL_TEXTURE_GEN_S && cap <= kGL_TEXTURE_GEN_Q) return &unit.tex_gen[cap - kGL_TEXTURE_GEN_S].enabled;
    switch (cap) {
        case kGL_TEXTURE_1D: return &unit.enabled_1d;
        case kGL_TEXTURE_2D: return &unit.enabled_2d;
        case kGL_TEXTURE_3D: return &unit.enabled_3d;
        case kGL_TEXTURE_CUBE_MAP: return &unit.enabled_cube;
        default: break;
    }
    const StateVariable* const row = find_state_variable(cap);
    return row && row->is_capability() ? const_cast<Flag>(row->flag(a)) : Flag{};  // NOLINT: `a` decides
}

}  // namespace

std::optional<bool> State::capability(Enum cap) const {
    if (const bool* on = supported_flag(a_, cap)) return *on;
    for (const DriverOnlyCapability& row : driver_only_capabilities())
        if (row.cap == cap) return a_.driver_only.contains({cap, row.is_per_unit() ? a_.active_unit : 0});
    return std::nullopt;
}

void State::set_capability(const Command& c, bool enabled) {
    const Enum cap = c.enumerant(0);
    if (bool* on = supported_flag(a_, cap)) {
        *on = enabled;
        // 2.14.3: from glEnable on, the material tracks the current colour.
        if (cap == kGL_COLOR_MATERIAL) track_color();
        return;
    }
    if (!known_capability(c)) return;
    const DriverOnlyCapability& row = driver_only_capability(cap);
    const std::pair key(cap, row.is_per_unit() ? a_.active_unit : 0);
    if (enabled)
        a_.driver_only.emplace(key, c.place);
    else
        a_.driver_only.erase(key);
}

bool State::known_capability(const Command& c) {
    const Enum cap = c.enumerant(0);
    if (capability(cap)) return true;
    constexpr Enum kMostNumbered = 256;
    if (cap >= kGL_LIGHT0 && cap < kGL_LIGHT0 + kMostNumbered) {
        raise(kGL_INVALID_ENUM, c,
              "{} is given GL_LIGHT0 + {}; GL has GL_LIGHT0 to GL_LIGHT7, others need #pragma twinlight light(8, ...)",
              c.name(), cap - kGL_LIGHT0);
        return false;
    }
    raise(kGL_INVALID_ENUM, c,
          "{} is given {}, which is not a capability; expected GL_LIGHTING, GL_LIGHT0, GL_DEPTH_TEST, ...", c.name(),
          enum_name(cap));
    return false;
}

void State::enable(const Command& c) { set_capability(c, true); }
void State::disable(const Command& c) { set_capability(c, false); }

}  // namespace twinlight
