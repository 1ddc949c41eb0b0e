#include "app/session/sides.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/text/translation.h"
#include "scene/frame/lecture_variants.h"

namespace twinlight::session {
namespace {

// The pane that a switch changes, or kPanes if no pane can change.
std::size_t switched_pane(const Session& session) {
    for (const std::size_t pane : {session.slider.b, session.slider.a})
        if (session.panes[pane].renderer != Path::kFixed) return pane;
    return kPanes;
}

std::size_t other_pane(const Session& session) {
    return switched_pane(session) == session.slider.b ? session.slider.a : session.slider.b;
}

Shading shown_shading(const Session& session, std::size_t pane) {
    if (is_flat(session.scene.frame)) return Shading::kFlat;
    return shading_of(session, session.panes[pane]).value_or(Shading::kGouraud);
}

bool shows_variants(const Session& session, std::size_t pane) {
    return session.panes[pane].renderer != Path::kFixed && look_of(session, session.panes[pane]).lecture_variants;
}

const char* place_of_lighting(Shading shading) {
    switch (shading) {
        case Shading::kFlat: return tr("at one vertex of each face");
        case Shading::kGouraud: return tr("at vertices");
        case Shading::kPhong: return tr("at pixels");
        case Shading::kExact: return tr("at pixels of the exact surface");
    }
    return "";
}

// The variants that the frame uses.
std::vector<std::string> variants_of(const Frame& frame) {
    std::vector<std::string> names;
    const std::vector<const Draw*> draws = frame.draws();
    const auto add = [&](const char* name, const auto& uses) {
        if (std::ranges::any_of(draws, [&](const Draw* draw) { return uses(*draw); })) names.emplace_back(tr(name));
    };
    const LightModel gl;
    add("reflected ray", [&](const Draw& draw) { return draw.lighting.light_model.specular != gl.specular; });
    add("ambient not attenuated",
        [&](const Draw& draw) { return draw.lighting.light_model.light_ambient != gl.light_ambient; });
    add("spectra", [](const Draw& draw) { return draw.lighting.light_model.spectrum != nullptr; });
    add("sRGB", [](const Draw& draw) { return draw.fragment.srgb_coded; });
    add("more lights", [](const Draw& draw) { return draw.lighting.lights.size() > kMaxLights; });
    add("smooth cones", [](const Draw& draw) {
        return std::ranges::any_of(draw.lighting.lights,
                                   [](const LightSource& l) { return l.smooth_cone.has_value(); });
    });
    return names;
}

}  // namespace

std::size_t side_row_count(const Session& session) {
    if (switched_pane(session) == kPanes) return 0;
    return has_variants(session.scene.frame) ? 2 : 1;
}

std::vector<SideRow> side_rows(const Session& session) {
    if (switched_pane(session) == kPanes) return {};
    const Shading left = shown_shading(session, session.slider.a), right = shown_shading(session, session.slider.b);
    SideRow shading{SideRow::Kind::kShading, left != right};
    const char *const at_left = place_of_lighting(left), *const at_right = place_of_lighting(right);
    if (shading.differs) {
        shading.text = tr("Where light is computed: {} | {}", at_left, at_right);
        shading.short_text = tr("Light: {} | {}", at_left, at_right);
    } else {
        shading.text = tr("Where light is computed: {} on both sides", at_left);
        shading.short_text = tr("Light: {} on both sides", at_left);
    }
    std::vector<SideRow> rows = {shading};
    if (has_variants(session.scene.frame)) {
        SideRow variants{SideRow::Kind::kVariants,
                         shows_variants(session, session.slider.a) != shows_variants(session, session.slider.b)};
        const std::string names = fmt::format("{}", fmt::join(variants_of(session.scene.frame), tr(", ")));
        variants.text = tr("The lecture's variants: {}", names);
        variants.short_text = tr("Variants: {}", names);
        rows.push_back(variants);
    }
    return rows;
}

void switch_side(Session& session, const SideRow& row) {
    const std::size_t changed = switched_pane(session);
    if (changed == kPanes) return;
    Pane& pane = session.panes[changed];
    const std::size_t other = other_pane(session);
    if (row.kind == SideRow::Kind::kShading) {
        // The variants stay as they are.
        pane.lecture_variants = look_of(session, pane).lecture_variants;
        const std::optional<Shading> same = shading_of(session, session.panes[other]);
        pane.shading = row.differs ? same : lights_every_pixel(same) ? std::nullopt : std::optional(Shading::kPhong);
        if (is_flat(session.scene.frame))
            say(session, tr("glShadeModel(GL_FLAT) makes every picture flat; f switches it"));
    } else {
        pane.lecture_variants = row.differs == shows_variants(session, other);
    }
}

}  // namespace twinlight::session
