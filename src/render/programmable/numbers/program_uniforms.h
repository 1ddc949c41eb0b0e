// The uniforms of a program, except those of lights and materials (light_values.h), in one list (uniforms.def). The text declares
// those that the list has, and a Draw gives a value for each of these and for no other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "render/effect/effect_set.h"
#include "render/programmable/numbers/form.h"
#include "render/programmable/numbers/value_set.h"

namespace twinlight::programmable {

enum class DrawValue : std::uint8_t {
#define DRAW_VALUE(value, ...) value,
#include "render/programmable/numbers/uniforms.def"
};
enum class TextureValue : std::uint8_t {
#define TEXTURE_VALUE(value, ...) value,
#include "render/programmable/numbers/uniforms.def"
};
enum class SurfaceValue : std::uint8_t {
#define SURFACE_VALUE(value, ...) value,
#include "render/programmable/numbers/uniforms.def"
};
enum class EsValue : std::uint8_t {
#define ES_VALUE(value, ...) value,
#include "render/programmable/numbers/uniforms.def"
};
enum class EsTextureValue : std::uint8_t {
#define ES_TEXTURE_VALUE(value, ...) value,
#include "render/programmable/numbers/uniforms.def"
};

// ---- The declarations ----

inline constexpr Declaration kDrawValues[] = {
#define DRAW_VALUE(value, ...) {__VA_ARGS__},
#include "render/programmable/numbers/uniforms.def"
};
inline constexpr Declaration kTextureValues[] = {
#define TEXTURE_VALUE(value, ...) {__VA_ARGS__},
#include "render/programmable/numbers/uniforms.def"
};
inline constexpr Declaration kSurfaceValues[] = {
#define SURFACE_VALUE(value, ...) {__VA_ARGS__},
#include "render/programmable/numbers/uniforms.def"
};
inline constexpr Declaration kEsValues[] = {
#define ES_VALUE(value, ...) {__VA_ARGS__},
#include "render/programmable/numbers/uniforms.def"
};
inline constexpr Declaration kEsTextureValues[] = {
#define ES_TEXTURE_VALUE(value, ...) {__VA_ARGS__},
#include "render/programmable/numbers/uniforms.def"
};
inline constexpr const Declaration& declaration_of(DrawValue value) {
    return kDrawValues[static_cast<std::size_t>(value)];
}
inline constexpr const Declaration& declaration_of(TextureValue value) {
    return kTextureValues[static_cast<std::size_t>(value)];
}
inline constexpr const Declaration& declaration_of(SurfaceValue value) {
    return kSurfaceValues[static_cast<std::size_t>(value)];
}
inline constexpr const Declaration& declaration_of(EsValue value) { return kEsValues[static_cast<std::size_t>(value)]; }
inline constexpr const Declaration& declaration_of(EsTextureValue value) {
    return kEsTextureValues[static_cast<std::size_t>(value)];
}

// Visits the values of all enums in the order of their declarations.
template <class Visit>
void for_each_uniform(const Visit& visit) {
#define DRAW_VALUE(value, ...) visit(DrawValue::value);
#define TEXTURE_VALUE(value, ...) visit(TextureValue::value);
#define SURFACE_VALUE(value, ...) visit(SurfaceValue::value);
#define ES_VALUE(value, ...) visit(EsValue::value);
#define ES_TEXTURE_VALUE(value, ...) visit(EsTextureValue::value);
#include "render/programmable/numbers/uniforms.def"
}

// `suffix`: what the names of a texture's uniforms end in, "" or the unit's number.
template <class Value>
std::string name_of(Value value, std::string_view suffix = {}) {
    return std::string(declaration_of(value).name).append(suffix);
}
// Programs need one for each of EffectSet::clip_plane_count.
std::string clip_plane_name(int i);

// ---- The lists ----

ValueSet<DrawValue> values_of_draw(const EffectSet& effects, const Form& form);
ValueSet<TextureValue> values_of_texture(const TextureEffects& texture, const Form& form, std::size_t unit);
ValueSet<SurfaceValue> values_of_surface(const SurfaceForm& surface);
ValueSet<EsValue> es_values(const Form& form);
ValueSet<EsTextureValue> es_values_of_texture(const Form& form);

// All of these for at most one texture.
struct UniformList {
    ValueSet<DrawValue> draw{};
    ValueSet<TextureValue> texture{};
    ValueSet<SurfaceValue> surface{};
    ValueSet<EsValue> es{};
    ValueSet<EsTextureValue> es_texture{};

    bool contains(DrawValue value) const { return draw.contains(value); }
    bool contains(TextureValue value) const { return texture.contains(value); }
    bool contains(SurfaceValue value) const { return surface.contains(value); }
    bool contains(EsValue value) const { return es.contains(value); }
    bool contains(EsTextureValue value) const { return es_texture.contains(value); }
};
// If a Draw combines textures, each unit has a list of its own.
UniformList uniform_list(const EffectSet& effects, const Form& form);
UniformList uniform_list(const UnitEffects& unit, const Form& form);

}  // namespace twinlight::programmable
