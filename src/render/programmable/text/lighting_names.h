// LightingNames: the names of the values in the GLSL that lights a vertex or a fragment. Naming a uniform declares it.
//
// Only the uniforms of light_values.h have names here, because no Draw gives a value for others. Lights are light0, light1, ... Their
// uniforms are u_light0_position_eye, u_light0_attenuation, u_light0_front_diffuse and so on; those of faces are u_front_base,
// u_back_base and so on. In shaders to keep they are GL's: LightSource[0].diffuse, FrontMaterial.ambient.
#pragma once

#include <fmt/format.h>

#include <set>
#include <string>
#include <vector>

#include "render/effect/effect_set.h"
#include "render/programmable/numbers/form.h"
#include "render/programmable/numbers/light_values.h"

namespace twinlight::programmable {

// Whether one function lights either face: in phong shading, where the fragment knows its face.
bool shares_faces(const EffectSet& effects);

class LightingNames {
  public:
    LightingNames(const EffectSet& effects, const Form& form) : effects_(effects), form_(form) {}

    // "front" and "back", or "shown" if shares_faces().
    std::vector<std::string> faces() const;
    std::string is_front() const { return form_.surface.kind == SurfaceKind::kNone ? "gl_FrontFacing" : "is_front"; }
    std::string space() const { return form_.object_space ? "object" : "eye"; }

    // The position and normal of the vertex, or of the fragment's point in a fragment shader.
    std::string position() const { return "surface." + position_field(); }
    // In a wide range a homogeneous position of object coordinates, times u_object_scale. With Form::homogeneous, of eye coordinates.
    std::string position_field() const { return "position_" + (form_.wide_range ? "object" : space()); }
    // The vertex before the division by w, in eye coordinates.
    std::string homogeneous() const { return form_.homogeneous ? position() : "surface.homogeneous_eye"; }
    bool has_homogeneous() const {
        return !position_is_homogeneous() && effects_.any_light(&LightEffects::meets_directions);
    }
    bool position_is_homogeneous() const { return form_.wide_range || form_.homogeneous; }
    std::string normal() const { return "surface.normal_" + space(); }

    // A value of the i-th light, which values_of_light() must contain: u_light0_attenuation, or u_light0_attenuation[i] in a loop.
    std::string light(std::size_t i, LightValue value);
    // The first line of the light's block: a loop if it represents many lights.
    std::string light_block(std::size_t i);
    // light_color * material_color, or the uniform that has their product. The colour must be in values_of_light(), too.
    std::string product(std::size_t i, const std::string& face, LightValue color, PerVertexColor per_vertex);
    // The same for the g-th group of three spectral samples.
    std::string sample_product(std::size_t i, const std::string& face, LightValue light_color);

    std::string scene_color(const std::string& face, const FaceEffects& varying);  // e_cm + a_cm a_cs
    std::string alpha(const std::string& face, const FaceEffects& varying);
    std::string shininess(const std::string& face, const FaceEffects& varying);

    std::string model(ModelValue value);  // not in shaders to keep

    const std::string& declarations() const { return declarations_; }

    // struct Surface and struct Lit.
    std::string structs() const;
    // The constructor call Surface(...): position, the same before the division by w, normal and the other fields, of a
    // vertex (prefix "a_") or fragment ("v_").
    std::string surface(const std::string& position, const std::string& homogeneous, const std::string& normal,
                        const std::string& prefix) const;
    bool has_surface() const;

  private:
    std::string uniform(std::string_view type, const std::string& name, std::string_view comment,
                        const std::string& array = "");
    std::string kept_light(std::size_t i, LightValue value);
    LightUniform listed(std::size_t i, LightValue value) const;
    std::string light_uniform(std::size_t i, const LightUniform& uniform, const std::string& face = "");
    template <class Name>
    std::string of_face(const std::string& face, const Name& name);
    std::string per_vertex_color(const std::string& face, const std::string& property, PerVertexColor per_vertex);
    std::string material(const std::string& face, FaceValue value);

    const EffectSet& effects_;
    const Form& form_;
    std::set<std::string> declared_;
    std::string declarations_;
};

// Shared by the two writers of lighting text: lighting_text.cpp and precise_text.cpp.
class LightingWriter {
  public:
    LightingWriter(const EffectSet& effects, const Form& form)
        : effects_(effects), form_(form), names_(effects, form) {}

  protected:
    template <class... Values>
    void add(fmt::format_string<Values...> text, Values&&... values) {
        text_ += fmt::format(text, std::forward<Values>(values)...);
    }

    const EffectSet& effects_;
    const Form& form_;
    LightingNames names_;
    std::string text_;
};

}  // namespace twinlight::programmable
