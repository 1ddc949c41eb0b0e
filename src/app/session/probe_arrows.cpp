#include "app/session/probe_arrows.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "judge/explain/derivation.h"

namespace twinlight::session {
namespace {

glm::dvec3 glm_of(const Vec3<double>& v) { return {v.x, v.y, v.z}; }

}  // namespace

std::optional<glm::dvec2> ProbeArrows::place_of(const glm::dvec3& point_eye) const {
    const glm::dvec4 clip = clip_from_eye * glm::dvec4(point_eye, 1);
    if (!(clip.w > 0)) return {};
    const glm::dvec2 ndc = glm::dvec2(clip) / clip.w;
    return glm::dvec2(viewport.x + (ndc.x + 1) / 2 * viewport.width,
                      height - viewport.y - (ndc.y + 1) / 2 * viewport.height);
}

ProbeArrows arrows_of(const explain::Derivation& at, std::optional<int> light, int revision) {
    const Draw& draw = at.draw;
    ProbeArrows result;
    result.revision = revision;
    result.place_eye = glm_of(at.point.surface.position_eye);
    result.clip_from_eye = draw.clip_from_eye;
    result.viewport = draw.raster.viewport;
    result.height = at.frame.height;
    const auto add = [&](ProbeArrow::Kind kind, std::string name, const Vec3<double>& v) {
        if (const double length = glm::length(glm_of(v)); length > 0)
            result.arrows.push_back({kind, std::move(name), glm_of(v) / length});
    };
    add(ProbeArrow::Kind::kNormal, "n", at.point.surface.normal_eye);
    add(ProbeArrow::Kind::kViewer, "V", at.point.vpe_dir);
    const bool has_highlights = light || at.lights.size() == 1;
    for (std::size_t i = 0; i < at.lights.size() && i < at.point.geometry.size(); ++i) {
        if (light && at.lights[i] != *light) continue;
        const lighting::LightGeometry<double>& geometry = at.point.geometry[i];
        add(ProbeArrow::Kind::kLight, fmt::format("L{}", at.lights[i]), geometry.vp_dir);
        if (has_highlights)
            add(ProbeArrow::Kind::kHighlight, fmt::format("{}{}", at.has_reflection() ? 'r' : 'h', at.lights[i]),
                geometry.half_dir);
    }
    // How many pixels one unit across or up is.
    const auto here = result.place_of(result.place_eye);
    double pixels = 0;
    for (const glm::dvec3& step : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0)})
        if (const auto there = result.place_of(result.place_eye + step); here && there)
            pixels = std::max(pixels, glm::distance(*here, *there));
    if (pixels > 0) result.length = kArrowPixels / pixels;
    return result;
}

}  // namespace twinlight::session
