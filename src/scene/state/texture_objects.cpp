// Texture objects, their names and parameters, and the texture environment (3.8.4, 3.8.10, 3.8.12, 3.8.13).
// texture_images.cpp handles their images.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

#include "scene/state/pixel_unpacking.h"
#include "scene/state/state.h"

namespace twinlight {

const std::shared_ptr<Texture>& State::texture_of(const TextureBindings& bindings, Enum target) const {
    const std::uint32_t name = bindings.bound(target);
    if (name != 0) return textures_.named.at(name);
    switch (target) {
        case kGL_TEXTURE_1D: return textures_.default_1d;
        case kGL_TEXTURE_2D: return textures_.default_2d;
        case kGL_TEXTURE_3D: return textures_.default_3d;
        default: return textures_.default_cube;
    }
}

Texture* State::writable_texture(const Command& c, Enum target) {
    if (!known(c, target, kTextureTargets)) return nullptr;
    return writable_texture(c, unit(), target);
}

Texture* State::writable_texture(const Command& c, const TextureBindings& bindings, Enum target) {
    auto& texture =
        const_cast<std::shared_ptr<Texture>&>(texture_of(bindings, target));  // NOLINT: belongs to this State
    if (texture.use_count() > 1) {
        if (!has_room(c, texels_of(*texture) * sizeof(glm::vec4))) return nullptr;
        texture = std::make_shared<Texture>(*texture);
    }
    return texture.get();
}

// 3.8.12. GL allows names that were never generated.
bool is_driver_only_texture(Enum target) { return target == kGL_TEXTURE_RECTANGLE; }

void State::bind_texture(const Command& c) {
    const Enum target = c.enumerant(0);
    const std::uint32_t name = c.enumerant(1);
    const bool driver_only = is_driver_only_texture(target);
    if (!driver_only && !known(c, target, kTextureTargets)) return;
    if (name != 0) {
        std::shared_ptr<Texture>& texture = textures_.named[name];
        if (!texture) texture = std::make_shared<Texture>(Texture{.target = target});
        if (texture->target != target) {
            return raise(kGL_INVALID_OPERATION, c, "texture {} was first bound to {}, so it cannot be bound to {}",
                         name, enum_name(texture->target), enum_name(target));
        }
    }
    if (driver_only) return;
    unit().bound(target) = name;
}

// 3.8.16: the unit that commands on textures and on the texture matrix affect.
void State::active_texture(const Command& c) {
    if (auto error = wrong_texture_unit(c)) return raise(std::move(*error));
    a_.active_unit = c.enumerant(0) - kGL_TEXTURE0;
}

namespace {

// GL 2.1 does not say how a float becomes a level. Mesa rounds a single one, and drops the fraction of one in an array.
int level_number(double value, bool is_array) {
    constexpr double kLargest = std::numeric_limits<int>::max();
    return static_cast<int>(std::clamp(is_array ? value : std::round(value), -kLargest, kLargest));
}

}  // namespace

void State::query_tex_parameter(const Command& c) {
    const Enum target = c.enumerant(0), pname = c.enumerant(1);
    if (is_driver_only_texture(target) || !known(c, target, kTextureTargets)) return;
    if (pname == kGL_TEXTURE_RESIDENT || find_parameter(Owner::kTexture, pname)) return;
    raise(kGL_INVALID_ENUM, c, "{} is given {}; expected GL_TEXTURE_MIN_FILTER, GL_TEXTURE_WRAP_S, ...", c.name(),
          enum_name(pname));
}

// By the target of glTexEnv and glGetTexEnv.
std::optional<Owner> State::environment_owner(const Command& c) {
    switch (c.enumerant(0)) {
        case kGL_TEXTURE_ENV: return Owner::kTexEnv;
        case kGL_TEXTURE_FILTER_CONTROL: return Owner::kTexFilterControl;
        case kGL_POINT_SPRITE: return Owner::kPointSprite;
        default: known(c, c.enumerant(0), {kGL_TEXTURE_ENV, kGL_TEXTURE_FILTER_CONTROL, kGL_POINT_SPRITE});
    }
    return std::nullopt;
}

void State::query_tex_env(const Command& c) {
    const Enum target = c.enumerant(0), pname = c.enumerant(1);
    const std::optional<Owner> owner = environment_owner(c);
    if (owner && !find_parameter(*owner, pname))
        raise(kGL_INVALID_ENUM, c, "{} is given {}; expected {}", c.name(), enum_name(pname),
              target == kGL_TEXTURE_ENV    ? "GL_TEXTURE_ENV_MODE, GL_TEXTURE_ENV_COLOR, GL_COMBINE_RGB, ..."
              : target == kGL_POINT_SPRITE ? "GL_COORD_REPLACE"
                                           : "GL_TEXTURE_LOD_BIAS");
}

void State::tex_parameter(const Command& c) {
    const Enum target = c.enumerant(0), pname = c.enumerant(1);
    if (is_driver_only_texture(target) || !known(c, target, kTextureTargets)) return;
    const auto values = parameter_values(c, Owner::kTexture, pname);
    if (!values) return;
    // Negative numbers are no names; GL_NONE is 0. Fractions: see level_number().
    constexpr double kNoName = 4294967295.0;
    const double number = c.array().empty() ? std::round(values->front()) : std::trunc(values->front());
    const auto name = static_cast<Enum>(number < 0 ? kNoName : std::clamp(number, 0.0, kNoName));
    // Setting the same value does not copy a shared texture.
    const auto assign = [&](auto Texture::*member, const auto& value) {
        if (bound_texture(target).*member == value) return;
        if (Texture* texture = writable_texture(c, target)) texture->*member = value;
    };
    const auto set = [&](Enum Texture::*member, std::initializer_list<Enum> allowed) {
        if (known(c, name, allowed)) assign(member, name);
    };
    const auto set_level = [&](int Texture::*member) {
        const int level = level_number(values->front(), !c.array().empty());
        if (level < 0) return raise(kGL_INVALID_VALUE, c, "{} is {}; it must be 0 or more", enum_name(pname), level);
        assign(member, level);
    };
    const auto wraps = {kGL_CLAMP, kGL_REPEAT, kGL_CLAMP_TO_EDGE, kGL_CLAMP_TO_BORDER, kGL_MIRRORED_REPEAT};
    switch (pname) {
        case kGL_TEXTURE_MIN_FILTER:
            return set(&Texture::min_filter,
                       {kGL_NEAREST, kGL_LINEAR, kGL_NEAREST_MIPMAP_NEAREST, kGL_LINEAR_MIPMAP_NEAREST,
                        kGL_NEAREST_MIPMAP_LINEAR, kGL_LINEAR_MIPMAP_LINEAR});
        case kGL_TEXTURE_MAG_FILTER: return set(&Texture::mag_filter, {kGL_NEAREST, kGL_LINEAR});
        case kGL_TEXTURE_WRAP_S: return set(&Texture::wrap_s, wraps);
        case kGL_TEXTURE_WRAP_T: return set(&Texture::wrap_t, wraps);
        case kGL_TEXTURE_WRAP_R: return set(&Texture::wrap_r, wraps);
        case kGL_TEXTURE_BORDER_COLOR:
            return assign(&Texture::border_color,
                          glm::clamp(glm::dvec4((*values)[0], (*values)[1], (*values)[2], (*values)[3]), 0.0, 1.0));
        case kGL_TEXTURE_PRIORITY: return assign(&Texture::priority, std::clamp(values->front(), 0.0, 1.0));
        case kGL_GENERATE_MIPMAP: return assign(&Texture::generate_mipmap, values->front() != 0);
        case kGL_TEXTURE_LOD_BIAS: return assign(&Texture::lod_bias, values->front());
        case kGL_TEXTURE_MIN_LOD: return assign(&Texture::min_lod, values->front());
        case kGL_TEXTURE_MAX_LOD: return assign(&Texture::max_lod, values->front());
        case kGL_TEXTURE_MAX_ANISOTROPY_EXT:
            return assign(&Texture::max_anisotropy, std::min(values->front(), kMaxAnisotropy));
        case kGL_DEPTH_TEXTURE_MODE:
            if (name == kGL_RED)
                return note_lasting("glTexParameter(GL_DEPTH_TEXTURE_MODE, GL_RED)", c.place);  // GL 3.0
            return set(&Texture::depth_mode, {kGL_LUMINANCE, kGL_INTENSITY, kGL_ALPHA});
        case kGL_TEXTURE_COMPARE_MODE: return set(&Texture::compare_mode, {kGL_NONE, kGL_COMPARE_R_TO_TEXTURE});
        case kGL_TEXTURE_COMPARE_FUNC:
            return set(&Texture::compare_func,
                       {kGL_LEQUAL, kGL_GEQUAL, kGL_LESS, kGL_GREATER, kGL_EQUAL, kGL_NOTEQUAL, kGL_ALWAYS, kGL_NEVER});
        case kGL_TEXTURE_BASE_LEVEL: return set_level(&Texture::base_level);
        case kGL_TEXTURE_MAX_LEVEL: return set_level(&Texture::max_level);
        default: return;
    }
}

void State::tex_env(const Command& c) {
    const Enum pname = c.enumerant(1);
    const std::optional<Owner> owner = environment_owner(c);
    if (!owner) return;
    const auto values = parameter_values(c, *owner, pname);
    if (!values) return;
    switch (pname) {
        case kGL_COORD_REPLACE: {  // 3.3.1: TRUE or FALSE
            const int replaces = static_cast<int>(std::clamp(values->front(), -1.0, 2.0));
            if (replaces != kGL_FALSE && replaces != kGL_TRUE)
                return raise(kGL_INVALID_VALUE, c, "GL_COORD_REPLACE is {}; it must be GL_TRUE or GL_FALSE",
                             values->front());
            unit().coord_replace = replaces == kGL_TRUE;
            break;
        }
        case kGL_TEXTURE_ENV_MODE: {
            const auto mode = static_cast<Enum>(std::clamp(values->front(), 0.0, 4294967295.0));
            if (known(c, mode, {kGL_MODULATE, kGL_DECAL, kGL_REPLACE, kGL_BLEND, kGL_ADD, kGL_COMBINE}))
                unit().env_mode = mode;
            break;
        }
        case kGL_TEXTURE_ENV_COLOR:
            unit().env_color = glm::clamp(glm::dvec4((*values)[0], (*values)[1], (*values)[2], (*values)[3]), 0.0, 1.0);
            break;
        case kGL_TEXTURE_LOD_BIAS: unit().lod_bias = values->front(); break;
        default: set_combine(c, pname, values->front());
    }
}

// The parameters of GL_COMBINE (3.8.13).
void State::set_combine(const Command& c, Enum pname, double value) {
    Combine& combine = unit().combine;
    const auto name = static_cast<Enum>(std::clamp(value, 0.0, 4294967295.0));
    const auto set = [&](Enum& member, std::initializer_list<Enum> allowed) {
        if (known(c, name, allowed)) member = name;
    };
    const auto set_source = [&](Enum& member) {
        if (name >= kGL_TEXTURE0 && name < kGL_TEXTURE0 + kMaxTextureUnits)
            member = name;
        else
            set(member, {kGL_TEXTURE, kGL_CONSTANT, kGL_PRIMARY_COLOR, kGL_PREVIOUS});
    };
    const auto set_scale = [&](int& member) {
        if (value != 1 && value != 2 && value != 4)
            return raise(kGL_INVALID_VALUE, c, "{} is {}; it must be 1, 2 or 4", enum_name(pname), value);
        member = static_cast<int>(value);
    };
    switch (pname) {
        case kGL_COMBINE_RGB:
            return set(combine.rgb, {kGL_REPLACE, kGL_MODULATE, kGL_ADD, kGL_ADD_SIGNED, kGL_INTERPOLATE, kGL_SUBTRACT,
                                     kGL_DOT3_RGB, kGL_DOT3_RGBA});
        case kGL_COMBINE_ALPHA:
            return set(combine.alpha,
                       {kGL_REPLACE, kGL_MODULATE, kGL_ADD, kGL_ADD_SIGNED, kGL_INTERPOLATE, kGL_SUBTRACT});
        case kGL_SRC0_RGB:
        case kGL_SRC1_RGB:
        case kGL_SRC2_RGB: return set_source(combine.rgb_sources[pname - kGL_SRC0_RGB]);
        case kGL_SRC0_ALPHA:
        case kGL_SRC1_ALPHA:
        case kGL_SRC2_ALPHA: return set_source(combine.alpha_sources[pname - kGL_SRC0_ALPHA]);
        case kGL_OPERAND0_RGB:
        case kGL_OPERAND1_RGB:
        case kGL_OPERAND2_RGB:
            return set(combine.rgb_operands[pname - kGL_OPERAND0_RGB],
                       {kGL_SRC_COLOR, kGL_ONE_MINUS_SRC_COLOR, kGL_SRC_ALPHA, kGL_ONE_MINUS_SRC_ALPHA});
        case kGL_OPERAND0_ALPHA:
        case kGL_OPERAND1_ALPHA:
        case kGL_OPERAND2_ALPHA:
            return set(combine.alpha_operands[pname - kGL_OPERAND0_ALPHA], {kGL_SRC_ALPHA, kGL_ONE_MINUS_SRC_ALPHA});
        case kGL_RGB_SCALE: return set_scale(combine.rgb_scale);
        case kGL_ALPHA_SCALE: return set_scale(combine.alpha_scale);
        default: return;
    }
}

// The texture of a Draw: that of the enabled target with more dimensions (3.8.15), if it is complete (3.8.10), with the
// levels in use. A complete texture has its base level and, for a mipmap filter, all levels from there to one texel or
// the last level in use, each half the size of the one before and in one format.
std::shared_ptr<const Texture> State::complete_texture(const TextureBindings& bindings) const {
    if (!bindings.is_enabled()) return nullptr;
    std::shared_ptr<const Texture> texture = texture_of(bindings, bindings.target());
    // Null also if the faces of a cube map differ (3.8.10).
    const auto image = [&](int level) -> const TextureImage* {
        const auto index = static_cast<std::size_t>(level);
        for (std::size_t i = 0; i < texture->face_count(); ++i) {
            const std::vector<TextureImage>& levels = texture->face(i);
            if (index >= levels.size() || levels[index].texels.empty() ||
                levels[index].width != texture->levels[index].width ||
                levels[index].internal_format != texture->levels[index].internal_format)
                return nullptr;
        }
        return &texture->levels[index];
    };
    const TextureImage* base = image(texture->base_level);
    if (!base || texture->base_level > texture->max_level) return nullptr;
    int last = texture->base_level;
    if (texture->min_filter != kGL_NEAREST && texture->min_filter != kGL_LINEAR) {
        TextureImage size{.width = base->width, .height = base->height, .depth = base->depth};
        while (size.is_halved() && last < texture->max_level) {
            size = size.half_size();
            const TextureImage* next = image(++last);
            if (!next || !next->has_size_of(size) || next->internal_format != base->internal_format) return nullptr;
        }
    } else if (texture->base_level == 0) {
        return texture;
    }
    return with_levels(texture, texture->base_level, last);
}

// A copy that has only these levels. It is kept as long as the State or a Draw has the texture, so that Draws share it.
std::shared_ptr<const Texture> State::with_levels(const std::shared_ptr<const Texture>& texture, int first,
                                                  int last) const {
    bool has_more = first > 0;
    for (std::size_t i = 0; i < texture->face_count(); ++i)
        has_more = has_more || static_cast<std::size_t>(last) + 1 < texture->face(i).size();
    if (!has_more) return texture;
    auto& [of, part] = parts_of_textures_[texture.get()];
    if (!part) {
        std::erase_if(parts_of_textures_, [&](const auto& entry) {
            return entry.first != texture.get() && entry.second.first.use_count() == 1;
        });
        Texture levels = *texture;
        for (std::size_t i = 0; i < levels.face_count(); ++i)
            levels.face(i).assign(texture->face(i).begin() + first, texture->face(i).begin() + last + 1);
        levels.base_level = Texture().base_level;
        levels.max_level = Texture().max_level;
        of = texture;
        part = std::make_shared<const Texture>(std::move(levels));
    }
    return part;
}

// ---- Names (3.8.12) ----

bool State::counts(const Command& c, const char* what) {
    if (c.number(0) >= 0) return true;
    raise(kGL_INVALID_VALUE, c, "{} is given {} {}; the number must be 0 or more", c.name(), c.number(0), tr(what));
    return false;
}

void State::gen_textures(const Command& c) {
    if (!counts(c, "textures")) return;
    for (double name : c.array()) textures_.named.try_emplace(static_cast<std::uint32_t>(name), nullptr);
}

// 3.8.12: sets the priority of existing textures; 0 and unused names are ignored.
void State::prioritize_textures(const Command& c) {
    if (!counts(c, "textures")) return;
    const auto names = c.values(1), priorities = c.values(2);
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto found = textures_.named.find(static_cast<std::uint32_t>(names[i]));
        if (names[i] == 0 || found == textures_.named.end() || !found->second) continue;
        std::shared_ptr<Texture>& texture = found->second;
        if (texture.use_count() > 1) texture = std::make_shared<Texture>(*texture);
        texture->priority = std::clamp(priorities[i], 0.0, 1.0);
    }
}

// Deleted textures are unbound; 0 and unused names are ignored.
void State::delete_textures(const Command& c) {
    if (!counts(c, "textures")) return;
    for (double value : c.array()) {
        const auto name = static_cast<std::uint32_t>(value);
        const auto found = textures_.named.find(name);
        if (name == 0 || found == textures_.named.end()) continue;
        if (found->second) textures_.texels -= texels_of(*found->second);
        detach(kGL_TEXTURE, name);
        textures_.named.erase(found);
        for (TextureBindings& unit : a_.units)
            for (const Enum target : kTextureTargets)
                if (unit.bound(target) == name) unit.bound(target) = 0;
    }
}

}  // namespace twinlight
