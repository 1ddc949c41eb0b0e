// glPushAttrib and glPopAttrib (6.1.14). Tables 6.5 to 6.35 list the state that each bit saves.

#include <algorithm>
#include <iterator>
#include <variant>

#include "scene/frame/parameter_rows.h"
#include "scene/state/capabilities.h"
#include "scene/state/state.h"
#include "scene/state/state_variables.h"

namespace twinlight {

namespace {

// The parameters of a texture, without its images.
void copy_parameters(Texture& to, const Texture& from) {
    for (const ParameterRow<Texture>& row : kTextureParameters)
        std::visit([&](auto member) { to.*member = from.*member; }, row.member);
}
bool have_equal_parameters(const Texture& a, const Texture& b) {
    return std::ranges::all_of(kTextureParameters, [&](const auto& row) { return has_equal(a, b, row); });
}

// What belongs to one of several lights, clip planes and texture units.
void restore_enables(Attributes& now, const Attributes& saved) {
    for (std::size_t i = 0; i < kMaxLights; ++i) now.lighting.lights[i].enabled = saved.lighting.lights[i].enabled;
    for (std::size_t i = 0; i < saved.clip_planes.size(); ++i)
        now.clip_planes[i].enabled = saved.clip_planes[i].enabled;
    for (std::size_t i = 0; i < saved.units.size(); ++i) {
        now.units[i].enabled_1d = saved.units[i].enabled_1d;
        now.units[i].enabled_2d = saved.units[i].enabled_2d;
        now.units[i].enabled_3d = saved.units[i].enabled_3d;
        now.units[i].enabled_cube = saved.units[i].enabled_cube;
        for (std::size_t n = 0; n < saved.units[i].tex_gen.size(); ++n)
            now.units[i].tex_gen[n].enabled = saved.units[i].tex_gen[n].enabled;
    }
}

void restore_units(Attributes& now, const Attributes& saved) {
    std::array<bool, kMaxTextureUnits> coord_replace{};  // belongs to GL_POINT_BIT
    for (std::size_t i = 0; i < now.units.size(); ++i) coord_replace[i] = now.units[i].coord_replace;
    now.units = saved.units;
    for (std::size_t i = 0; i < now.units.size(); ++i) now.units[i].coord_replace = coord_replace[i];
    now.active_unit = saved.active_unit;
}

void restore(Attributes& now, const Attributes& saved, Enum mask) {
    const auto bit = [mask](Enum one) { return (mask & one) != 0; };
    for (const StateVariable& variable : state_variables())
        if (bit(variable.groups)) variable.copy(now, saved);
    if (bit(kGL_POINT_BIT))
        for (std::size_t i = 0; i < now.units.size(); ++i) now.units[i].coord_replace = saved.units[i].coord_replace;
    if (bit(kGL_LIGHTING_BIT)) {
        now.lighting.lights = saved.lighting.lights;
        now.lighting.light_model = saved.lighting.light_model;
        now.lighting.front = saved.lighting.front;
        now.lighting.back = saved.lighting.back;
    }
    if (bit(kGL_TRANSFORM_BIT)) now.clip_planes = saved.clip_planes;
    if (bit(kGL_ENABLE_BIT)) restore_enables(now, saved);
    if (bit(kGL_HINT_BIT)) now.hints = saved.hints;
    if (bit(kGL_TEXTURE_BIT)) restore_units(now, saved);
    for (const DriverOnlyCapability& row : driver_only_capabilities()) {
        if (!bit(row.group) && !bit(kGL_ENABLE_BIT)) continue;
        const auto is_of_row = [&row](const auto& on) { return on.first.first == row.cap; };
        std::erase_if(now.driver_only, is_of_row);
        std::copy_if(saved.driver_only.begin(), saved.driver_only.end(),
                     std::inserter(now.driver_only, now.driver_only.end()), is_of_row);
    }
}

}  // namespace

void State::push_attrib(const Command& c) {
    if (attribute_stack_.size() >= kAttributeStackDepth) {
        return raise(kGL_STACK_OVERFLOW, c, "the attribute stack is full ({} levels); a glPopAttrib is missing",
                     kAttributeStackDepth);
    }
    SavedAttributes saved{a_, c.enumerant(0), {}, c.place};
    if (saved.mask & kGL_TEXTURE_BIT)  // 6.1.14: of the textures that are bound in any unit
        for (const TextureBindings& one : a_.units)
            for (const Enum target : kTextureTargets) {
                const auto [at, is_new] = saved.textures.try_emplace({target, one.bound(target)});
                if (is_new) copy_parameters(at->second, *texture_of(one, target));
            }
    attribute_stack_.push_back(std::move(saved));
}

void State::pop_attrib(const Command& c) {
    if (attribute_stack_.empty()) return raise(kGL_STACK_UNDERFLOW, c, "glPopAttrib without a glPushAttrib");
    const SavedAttributes saved = std::move(attribute_stack_.back());
    attribute_stack_.pop_back();
    restore(a_, saved.attributes, saved.mask);
    if ((saved.mask & kGL_TEXTURE_BIT) == 0) return;
    // A texture that was deleted in between is no longer bound (3.8.12), even if a new one has its name.
    const auto keep = [this](std::uint32_t& bound, Enum target) {
        const auto found = textures_.named.find(bound);
        if (found == textures_.named.end() || !found->second || found->second->target != target) bound = 0;
    };
    for (TextureBindings& one : a_.units)
        for (const Enum target : kTextureTargets) keep(one.bound(target), target);
    for (const TextureBindings& one : a_.units)
        for (const Enum target : kTextureTargets) {
            const auto found = saved.textures.find({target, one.bound(target)});
            if (found == saved.textures.end() ||
                have_equal_parameters(*texture_of(one, target), found->second))  // avoids a copy
                continue;
            if (Texture* texture = writable_texture(c, one, target)) copy_parameters(*texture, found->second);
        }
}

}  // namespace twinlight
