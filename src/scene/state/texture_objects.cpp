// Texture objects, their names and parameters, and the texture environment (3.8.4, 3.8.10, 3.8.12, 3.8.13).
// texture_images.cpp handles their images.
#include <fmt/format.h>

#include <algorithm>
#include <glm/common.hpp>

#include "scene/state/pixel_unpacking.h"
#include "scene/state/state.h"

namespace twinlight {

const std::shared_ptr<Texture>& State::texture_of(const TextureBindings& bindings, Enum target) const {
    const std::uint32_t name = target == kGL_TEXTURE_1D ? bindings.bound_1d : bindings.bound_2d;
    if (name == 0) return target == kGL_TEXTURE_1D ? textures_.default_1d : textures_.default_2d;
    return textures_.named.at(name);
}

Texture* State::writable_texture(const Command& c, Enum target) {
    if (!known(c, target, {kGL_TEXTURE_1D, kGL_TEXTURE_2D})) return nullptr;
    auto& texture = const_cast<std::shared_ptr<Texture>&>(texture_of(unit(), target));  // NOLINT: belongs to this State
    if (texture.use_count() > 1) {
        if (!has_room(c, texels_of(*texture) * sizeof(glm::vec4))) return nullptr;
        texture = std::make_shared<Texture>(*texture);
    }
    return texture.get();
}

// 3.8.12. GL allows names that were never generated.
bool is_driver_only_texture(Enum target) {
    return target == kGL_TEXTURE_3D || target == kGL_TEXTURE_CUBE_MAP || target == kGL_TEXTURE_RECTANGLE;
}

void State::bind_texture(const Command& c) {
    const Enum target = c.enumerant(0);
    const std::uint32_t name = c.enumerant(1);
    const bool driver_only = is_driver_only_texture(target);
    if (!driver_only && !known(c, target, {kGL_TEXTURE_1D, kGL_TEXTURE_2D})) return;
    if (name != 0) {
        std::shared_ptr<Texture>& texture = textures_.named[name];
        if (!texture) texture = std::make_shared<Texture>(Texture{.target = target});
        if (texture->target != target) {
            return raise(kGL_INVALID_OPERATION, c, "texture {} was first bound to {}, so it cannot be bound to {}",
                         name, enum_name(texture->target), enum_name(target));
        }
    }
    if (driver_only) return;
    (target == kGL_TEXTURE_1D ? unit().bound_1d : unit().bound_2d) = name;
}

// 3.8.16: the unit that commands on textures and on the texture matrix affect.
void State::active_texture(const Command& c) {
    if (auto error = wrong_texture_unit(c)) return raise(std::move(*error));
    a_.active_unit = c.enumerant(0) - kGL_TEXTURE0;
}

namespace {

// Parameters that only the driver supports: of later versions and of other kinds of textures.
struct DriverOnlyParameter {
    Enum pname;
    std::optional<double> initial;  // nullopt: it only modifies another parameter, and alone changes no pixel
};
constexpr DriverOnlyParameter kDriverOnlyParameters[] = {
    {kGL_TEXTURE_BASE_LEVEL, 0},
    {kGL_TEXTURE_MAX_LEVEL, 1000},
    {kGL_TEXTURE_MIN_LOD, -1000},
    {kGL_TEXTURE_MAX_LOD, 1000},
    {kGL_TEXTURE_LOD_BIAS, 0},
    {kGL_TEXTURE_MAX_ANISOTROPY_EXT, 1},
    {kGL_TEXTURE_COMPARE_MODE, kGL_NONE},
    {kGL_TEXTURE_COMPARE_FUNC, std::nullopt},
    {kGL_DEPTH_TEXTURE_MODE, std::nullopt},
};

const DriverOnlyParameter* driver_only_parameter(Enum pname) {
    const auto* row = std::find_if(std::begin(kDriverOnlyParameters), std::end(kDriverOnlyParameters),
                                   [pname](const DriverOnlyParameter& r) { return r.pname == pname; });
    return row == std::end(kDriverOnlyParameters) ? nullptr : row;
}

}  // namespace

void State::query_tex_parameter(const Command& c) {
    const Enum target = c.enumerant(0), pname = c.enumerant(1);
    if (is_driver_only_texture(target) || !known(c, target, {kGL_TEXTURE_1D, kGL_TEXTURE_2D})) return;
    if (pname == kGL_TEXTURE_RESIDENT || driver_only_parameter(pname) || find_parameter(Owner::kTexture, pname)) return;
    raise(kGL_INVALID_ENUM, c, "{} is given {}; expected GL_TEXTURE_MIN_FILTER, GL_TEXTURE_WRAP_S, ...", c.name(),
          enum_name(pname));
}

void State::query_tex_env(const Command& c) {
    const Enum target = c.enumerant(0), pname = c.enumerant(1);
    if (!known(c, target, {kGL_TEXTURE_ENV, kGL_TEXTURE_FILTER_CONTROL})) return;
    if (target == kGL_TEXTURE_ENV)
        known(c, pname, {kGL_TEXTURE_ENV_MODE, kGL_TEXTURE_ENV_COLOR});
    else
        known(c, pname, {kGL_TEXTURE_LOD_BIAS});
}

void State::tex_parameter(const Command& c) {
    const Enum target = c.enumerant(0), pname = c.enumerant(1);
    if (is_driver_only_texture(target) || !known(c, target, {kGL_TEXTURE_1D, kGL_TEXTURE_2D})) return;
    if (const DriverOnlyParameter* row = driver_only_parameter(pname)) {
        const bool changes = row->initial && c.arguments.size() > 2 && c.number(2) != *row->initial;
        if (changes) note_lasting(fmt::format("glTexParameter({})", enum_name(pname)), c.place);
        return;
    }
    const auto values = parameter_values(c, Owner::kTexture, pname);
    if (!values) return;
    const auto name = static_cast<Enum>(std::clamp(values->front(), 0.0, 4294967295.0));
    // Setting the same value does not copy a shared texture.
    const auto assign = [&](auto Texture::*member, const auto& value) {
        if (bound_texture(target).*member == value) return;
        if (Texture* texture = writable_texture(c, target)) texture->*member = value;
    };
    const auto set = [&](Enum Texture::*member, std::initializer_list<Enum> allowed) {
        if (known(c, name, allowed)) assign(member, name);
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
        case kGL_TEXTURE_WRAP_R: known(c, name, wraps); return;  // not used in one and two dimensions
        case kGL_TEXTURE_BORDER_COLOR:
            return assign(&Texture::border_color,
                          glm::clamp(glm::dvec4((*values)[0], (*values)[1], (*values)[2], (*values)[3]), 0.0, 1.0));
        case kGL_TEXTURE_PRIORITY: return assign(&Texture::priority, std::clamp(values->front(), 0.0, 1.0));
        case kGL_GENERATE_MIPMAP: return assign(&Texture::generate_mipmap, values->front() != 0);
        default: return;
    }
}

void State::tex_env(const Command& c) {
    const Enum target = c.enumerant(0), pname = c.enumerant(1);
    if (!known(c, target, {kGL_TEXTURE_ENV, kGL_TEXTURE_FILTER_CONTROL})) return;
    const Owner owner = target == kGL_TEXTURE_ENV ? Owner::kTexEnv : Owner::kTexFilterControl;
    const auto values = parameter_values(c, owner, pname);
    if (!values) return;
    switch (pname) {
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
        default: break;
    }
}

// The texture of a Draw: that of the enabled target with more dimensions (3.8.15), if it is complete (3.8.10). A
// complete texture has its base level and, for a mipmap filter, all levels down to 1 x 1, each half the size of the
// last and in one format.
std::shared_ptr<const Texture> State::complete_texture(const TextureBindings& bindings) const {
    if (!bindings.enabled_1d && !bindings.enabled_2d) return nullptr;
    std::shared_ptr<const Texture> texture =
        texture_of(bindings, bindings.enabled_2d ? kGL_TEXTURE_2D : kGL_TEXTURE_1D);
    if (texture->levels.empty() || texture->levels[0].texels.empty()) return nullptr;
    if (texture->min_filter == kGL_NEAREST || texture->min_filter == kGL_LINEAR) return texture;
    int width = texture->levels[0].width, height = texture->levels[0].height;
    for (std::size_t level = 1; width > 1 || height > 1; ++level) {
        width = std::max(1, width / 2);
        height = std::max(1, height / 2);
        if (level >= texture->levels.size()) return nullptr;
        const TextureImage& image = texture->levels[level];
        const bool fits = image.width == width && image.height == height && !image.texels.empty() &&
                          image.internal_format == texture->levels[0].internal_format;
        if (!fits) return nullptr;
    }
    return texture;
}

// ---- Names (3.8.12) ----

bool State::counts(const Command& c, const char* what) {
    if (c.number(0) >= 0) return true;
    raise(kGL_INVALID_VALUE, c, "{} is given {} {}; the number must be 0 or more", c.name(), c.number(0), what);
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
        textures_.named.erase(found);
        for (TextureBindings& unit : a_.units) {
            if (unit.bound_1d == name) unit.bound_1d = 0;
            if (unit.bound_2d == name) unit.bound_2d = 0;
        }
    }
}

}  // namespace twinlight
