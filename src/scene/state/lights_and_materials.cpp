// glLight, glMaterial, glLightModel, glColorMaterial, glShadeModel, their queries, and the lecture's variants
// (2.14.2, 2.14.3, 2.14.7).
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <span>
#include <type_traits>
#include <utility>

#include "base/text/translation.h"
#include "scene/command/lexer.h"
#include "scene/frame/parameter_rows.h"
#include "scene/state/state.h"

namespace twinlight {

namespace {

glm::dvec4 vec4(const std::vector<double>& v) { return {v[0], v[1], v[2], v[3]}; }

// The reflectance that a pname names; null for other properties.
const Spectrum** reflectance_of(Material& material, Enum pname) {
    switch (pname) {
        case kGL_AMBIENT: return &material.reflectances.ambient;
        case kGL_DIFFUSE: return &material.reflectances.diffuse;
        case kGL_SPECULAR: return &material.reflectances.specular;
        default: return nullptr;
    }
}

// Sets a property and the reflectance it was computed from (null if it was given as numbers).
void set_property(Material& material, const ParameterRow<Material>& property, std::span<const double> values,
                  const Spectrum* reflectance = nullptr) {
    set_parameter(material, property, values);
    if (const Spectrum** of = reflectance_of(material, property.pname)) *of = reflectance;
}

// The properties that a pname or a mode of glColorMaterial includes.
std::vector<Enum> properties(Enum pname) {
    if (pname == kGL_AMBIENT_AND_DIFFUSE) return {kGL_AMBIENT, kGL_DIFFUSE};
    return {pname};
}

bool covers(Enum face, Enum one_face) { return face == one_face || face == kGL_FRONT_AND_BACK; }

bool tracks(const ColorMaterial& color_material, Enum one_face, Enum property) {
    const std::vector<Enum> tracked = properties(color_material.mode);
    return color_material.enabled && covers(color_material.face, one_face) &&
           std::find(tracked.begin(), tracked.end(), property) != tracked.end();
}

}  // namespace

LightSource* State::light_source(const Command& c, Enum light) {
    if (light >= kGL_LIGHT0 && light < kGL_LIGHT0 + kMaxLights) return &a_.lighting.lights[light - kGL_LIGHT0];
    raise(kGL_INVALID_ENUM, c, "{} is given {}; expected a light, GL_LIGHT0 to GL_LIGHT7", c.name(), enum_name(light));
    return nullptr;
}

// 2.14.2: checks the pname, the number of values and their range, and converts integer colours (table 2.9).
std::optional<std::vector<double>> State::parameter_values(const Command& c, Owner owner, Enum pname) {
    const ParameterInfo* info = find_parameter(owner, pname);
    const Parameter& last = c.sig().parameters.back();
    const bool is_vector = last.extent != Extent::kValue;
    if (!info) {
        std::vector<std::string> names;
        for (const ParameterInfo& row : parameter_infos())
            if (row.owner == owner) names.push_back(enum_name(row.pname));
        raise(kGL_INVALID_ENUM, c, "{} is given {}; expected {}", c.name(), enum_name(pname), fmt::join(names, ", "));
        return std::nullopt;
    }
    if (!is_vector && info->count > 1) {
        raise(kGL_INVALID_ENUM, c, "{} sets a single value, but {} has {}; use {}v", c.name(), enum_name(pname),
              info->count, c.name());
        return std::nullopt;
    }
    const std::size_t first = c.sig().parameters.size() - 1;
    std::vector<double> values(c.arguments.begin() + static_cast<std::ptrdiff_t>(first), c.arguments.end());
    values.resize(static_cast<std::size_t>(info->count), 0.0);
    if (info->meaning == Meaning::kColor)
        for (double& v : values) v = to_real(v, last.kind);
    if (owner == Owner::kPixelStore) values[0] = std::round(values[0]);  // 3.6.1
    const bool is_cutoff = pname == kGL_SPOT_CUTOFF;
    const double value = values[0];
    const bool in_range =
        value >= info->smallest && value <= info->largest && !(is_cutoff && value > 90 && value != 180);
    if (info->meaning == Meaning::kScalar && !in_range) {
        const std::string range = is_cutoff                   ? tr("in [0, 90] or 180")
                                  : std::isinf(info->largest) ? tr("0 or more")
                                                              : tr("in [{}, {}]", info->smallest, info->largest);
        const bool may_be_of_obj = pname == kGL_SHININESS && value > info->largest;
        raise(kGL_INVALID_VALUE, c, "{} is {}; it must be {}{}", enum_name(pname), value, range,
              may_be_of_obj ? tr("; for a larger Ns of an OBJ file, use 128") : "");
        return std::nullopt;
    }
    return values;
}

void State::light(const Command& c) {
    LightSource* source = light_source(c, c.enumerant(0));
    if (!source) return;
    const Enum pname = c.enumerant(1);
    if (const auto values = parameter_values(c, Owner::kLight, pname)) set_light(c, *source, pname, *values);
}

void State::set_light(const Command& c, LightSource& source, Enum pname, const std::vector<double>& values) {
    // 2.14.1: positions are transformed by the current modelview matrix, directions by its upper left 3x3.
    if (pname == kGL_POSITION) {
        TypedLight typed = typed_lights_[source.typed];
        typed.position = {vec4(values), c.place, modelview()};
        if (note_typed(c, source, typed)) source.position_eye = modelview() * typed.position.value;
    } else if (pname == kGL_SPOT_DIRECTION) {
        TypedLight typed = typed_lights_[source.typed];
        typed.spot_direction = {{values[0], values[1], values[2]}, c.place, modelview()};
        if (note_typed(c, source, typed))
            source.spot_direction_eye = glm::dmat3(modelview()) * typed.spot_direction.value;
    } else {
        set_parameter(source, *find_parameter_row<LightSource>(pname), values);
    }
    if (pname == kGL_DIFFUSE) source.diffuse_illuminant = {};
    if (pname == kGL_SPECULAR) source.specular_illuminant = {};
}

bool State::note_typed(const Command& c, LightSource& source, const TypedLight& typed) {
    if (typed == typed_lights_[source.typed]) return true;
    if (!has_room(c, sizeof typed)) return false;
    source.typed = static_cast<std::uint32_t>(typed_lights_.size());
    typed_lights_.push_back(typed);
    return true;
}

void State::drop_typed_lights() {
    if (typed_lights_.size() == 1) return;  // the first stands for no light
    std::vector<TypedLight> kept{{}};
    const auto keep = [&](LightSources& lights) {
        for (std::size_t i = 0; i < lights.size(); ++i) {
            const std::uint32_t typed = std::as_const(lights)[i].typed;
            if (typed == 0) continue;
            kept.push_back(typed_lights_[typed]);
            lights[i].typed = static_cast<std::uint32_t>(kept.size() - 1);
        }
    };
    const auto keep_all = [&](Attributes& attributes) {
        keep(attributes.lighting.lights);
        RasterVertex raster = *attributes.raster_position.vertex;
        if (!raster.lighting.enabled) return;
        keep(raster.lighting.lights);
        attributes.raster_position.vertex = std::make_shared<const RasterVertex>(std::move(raster));
    };
    keep_all(a_);
    for (SavedAttributes& saved : attribute_stack_) keep_all(saved.attributes);
    typed_lights_ = std::move(kept);
}

void State::material(const Command& c) { set_material(c, nullptr); }

void State::set_material(const Command& c, const Spectrum* reflectance) {
    const Enum face = c.enumerant(0), pname = c.enumerant(1);
    if (!known(c, face, {kGL_FRONT, kGL_BACK, kGL_FRONT_AND_BACK})) return;
    const auto values = parameter_values(c, Owner::kMaterial, pname);
    if (!values) return;
    for (Enum one_face : {kGL_FRONT, kGL_BACK}) {
        if (!covers(face, one_face)) continue;
        Material& material = one_face == kGL_FRONT ? a_.lighting.front : a_.lighting.back;
        if (pname == kGL_COLOR_INDEXES) material.color_indexes = {(*values)[0], (*values)[1], (*values)[2]};
        for (Enum property : properties(pname)) {
            // 2.14.3: glMaterial does not change a property that tracks the current colour.
            const ParameterRow<Material>* const row = find_parameter_row<Material>(property);
            if (row && !tracks(a_.lighting.color_material, one_face, property))
                set_property(material, *row, *values, reflectance);
        }
    }
    if (!open_) return;
    // 2.14.2: allowed between Begin and End. Before the first vertex it sets the Draw's material, later that of the
    // next vertices.
    if (open_->vertices.empty()) {
        open_->lighting = a_.lighting;
        return;
    }
    // Shaders support one reflectance for a whole Draw, but a colour for each vertex.
    const auto has_reflectance = [](const Material& m) {
        return m.reflectances.ambient || m.reflectances.diffuse || m.reflectances.specular;
    };
    if (a_.lighting.light_model.spectrum &&
        (has_reflectance(open_->lighting.front) || has_reflectance(open_->lighting.back)))
        note_unsupported("glMaterial between glBegin and glEnd for a material with a reflectance", c.place,
                         MissingFrom::kShaders);
    std::vector<Materials>& materials = open_->materials;
    if (materials.empty()) materials.push_back({open_->lighting.front, open_->lighting.back});
    const Materials now{a_.lighting.front, a_.lighting.back};
    if (open_->vertices.back().material + 1 == materials.size()) {
        if (!has_room(c, sizeof(Materials))) return;
        materials.push_back(now);
    } else {
        materials.back() = now;  // no vertex used the last one
    }
    a_.current.material = static_cast<std::uint32_t>(materials.size() - 1);
}

void State::light_model(const Command& c) {
    const Enum pname = c.enumerant(0);
    const auto values = parameter_values(c, Owner::kLightModel, pname);
    if (!values) return;
    if (pname == kGL_LIGHT_MODEL_COLOR_CONTROL &&
        !known(c, static_cast<Enum>(std::clamp(values->front(), 0.0, 4294967295.0)),
               {kGL_SINGLE_COLOR, kGL_SEPARATE_SPECULAR_COLOR}))
        return;
    set_parameter(a_.lighting.light_model, *find_parameter_row<LightModel>(pname), *values);
}

void State::shade_model(const Command& c) {
    if (known(c, c.enumerant(0), {kGL_FLAT, kGL_SMOOTH})) a_.lighting.shade_model = c.enumerant(0);
}

// ---- Colour material (2.14.3) ----

void State::color_material(const Command& c) {
    if (!known(c, c.enumerant(0), {kGL_FRONT, kGL_BACK, kGL_FRONT_AND_BACK})) return;
    if (!known(c, c.enumerant(1), {kGL_EMISSION, kGL_AMBIENT, kGL_DIFFUSE, kGL_SPECULAR, kGL_AMBIENT_AND_DIFFUSE}))
        return;
    a_.lighting.color_material.face = c.enumerant(0);
    a_.lighting.color_material.mode = c.enumerant(1);
    track_color();
}

void State::track_color() {
    if (!a_.lighting.color_material.enabled) return;
    for (Enum one_face : {kGL_FRONT, kGL_BACK}) {
        Material& material = one_face == kGL_FRONT ? a_.lighting.front : a_.lighting.back;
        for (Enum property : properties(a_.lighting.color_material.mode))
            if (covers(a_.lighting.color_material.face, one_face))
                set_property(material, *find_parameter_row<Material>(property), std::span(&a_.current.color[0], 4));
    }
}

// ---- Queries (6.1.3) ----

std::vector<double> State::get_light(Enum light, Enum pname) const {
    if (light < kGL_LIGHT0 || light >= kGL_LIGHT0 + kMaxLights) return {};
    const ParameterRow<LightSource>* const row = find_parameter_row<LightSource>(pname);
    return row ? values_of(a_.lighting.lights[light - kGL_LIGHT0], *row) : std::vector<double>{};
}

std::vector<double> State::get_material(Enum face, Enum pname) const {
    if (face != kGL_FRONT && face != kGL_BACK) return {};
    const Material& material = face == kGL_FRONT ? a_.lighting.front : a_.lighting.back;
    if (pname == kGL_COLOR_INDEXES)
        return {material.color_indexes.x, material.color_indexes.y, material.color_indexes.z};
    const ParameterRow<Material>* const row = find_parameter_row<Material>(pname);
    return row ? values_of(material, *row) : std::vector<double>{};
}

void State::get_light(const Command& c) {
    const auto self = static_cast<const State*>(this);
    if (!light_source(c, c.enumerant(0))) return;
    if (self->get_light(c.enumerant(0), c.enumerant(1)).empty())
        raise(kGL_INVALID_ENUM, c, "{} is given {}, which is not a parameter of lights", c.name(),
              enum_name(c.enumerant(1)));
}

void State::get_material(const Command& c) {
    const auto self = static_cast<const State*>(this);
    if (!known(c, c.enumerant(0), {kGL_FRONT, kGL_BACK})) return;
    if (self->get_material(c.enumerant(0), c.enumerant(1)).empty()) {
        raise(kGL_INVALID_ENUM, c, "{} is given {}, which is not a parameter of materials", c.name(),
              enum_name(c.enumerant(1)));
    }
}

// ---- The lecture's variants (pragmas) ----

void State::specular_model(const Command& c) {
    if (c.word(0) == Word::half_vector || c.word(0) == Word::reflection)
        a_.lighting.light_model.specular = c.word(0);
    else
        raise(kGL_INVALID_ENUM, c, "specular({}) is unknown; expected half_vector or reflection", word_name(c.word(0)));
}

void State::ambient_model(const Command& c) {
    if (c.word(0) == Word::attenuated || c.word(0) == Word::unattenuated)
        a_.lighting.light_model.light_ambient = c.word(0);
    else
        raise(kGL_INVALID_ENUM, c, "ambient({}) is unknown; expected attenuated or unattenuated", word_name(c.word(0)));
}

void State::spot_cone(const Command& c) {
    LightSource* source = light_source(c, c.enumerant(0));
    if (!source) return;
    for (double degrees : {c.number(1), c.number(2)})
        if (degrees < 0 || degrees > 180)
            return raise(kGL_INVALID_VALUE, c, "the cone's half angle is {} degrees; it must be in [0, 180]", degrees);
    source->smooth_cone = LightSource::SmoothCone{c.number(1), c.number(2)};
}

// A light that GL lacks. Its first use creates and enables it.
void State::extra_light(const Command& c) {
    const double number = c.number(0);
    if (!(number >= kMaxLights && number < kMaxExtraLights)) {
        return raise(kGL_INVALID_ENUM, c,
                     "light({}): the number must be from {} to {}; use glLight for GL_LIGHT0 to GL_LIGHT7", number,
                     kMaxLights, kMaxExtraLights - 1);
    }
    const Enum pname = c.enumerant(1);
    const ParameterInfo* info = find_parameter(Owner::kLight, pname);
    if (info && c.arguments.size() != 2 + static_cast<std::size_t>(info->count)) {
        return raise(kGL_INVALID_VALUE, c, "{} needs {}, not {}", enum_name(pname),
                     values_text(static_cast<std::size_t>(info->count)), c.arguments.size() - 2);
    }
    const auto values = parameter_values(c, Owner::kLight, pname);
    if (!values) return;
    LightSources& lights = a_.lighting.lights;
    const auto i = static_cast<std::size_t>(number);
    if (i >= lights.size()) lights.resize(i + 1);
    lights[i].enabled = true;
    set_light(c, lights[i], pname, *values);
}

}  // namespace twinlight
