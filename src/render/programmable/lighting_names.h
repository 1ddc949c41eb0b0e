// LightingNames: what the GLSL that lights a vertex or a fragment calls its values. A uniform is declared where it is first named.
#pragma once

#include <fmt/format.h>

#include <set>
#include <string>
#include <vector>

#include "render/effect/effect_set.h"
#include "render/programmable/form.h"

namespace twinlight::programmable {

// A colour of the material that each vertex brings: glColor's (2.14.3) or its own (glMaterial between glBegin and glEnd, 2.14.2).
struct BroughtColor {
    bool tracks = false, varies = false;
    explicit operator bool() const { return tracks || varies; }
};
inline BroughtColor emission_of(const FaceEffects& face) { return {face.tracks_emission, face.varies_emission}; }
inline BroughtColor ambient_of(const FaceEffects& face) { return {face.tracks_ambient, face.varies_ambient}; }
inline BroughtColor diffuse_of(const FaceEffects& face) { return {face.tracks_diffuse, face.varies_diffuse}; }
inline BroughtColor specular_of(const FaceEffects& face) { return {face.tracks_specular, face.varies_specular}; }

// One text lights the face that shows: of a fragment that is known.
bool shares_faces(const EffectSet& effects);

class LightingNames {
  public:
    LightingNames(const EffectSet& effects, const Form& form) : effects_(effects), form_(form) {}

    // Faces are "front", "back", or "shown" where shares_faces().
    std::vector<std::string> faces() const;
    std::string is_front() const { return form_.surface.kind == SurfaceKind::kNone ? "gl_FrontFacing" : "is_front"; }
    std::string space() const { return form_.object_space ? "object" : "eye"; }

    // The vertex in the vertex shader, the fragment's point in the fragment shader.
    std::string position() const { return "surface.position_" + space(); }
    std::string normal() const { return "surface.normal_" + space(); }

    // Of the i-th light: what = "attenuation" gives u_light0_attenuation, or u_light0_attenuation[i] where it stands for many.
    std::string light(std::size_t i, const std::string& type, const std::string& what, const std::string& comment);
    // The head of the light's block: a loop where it stands for many.
    std::string light_block(std::size_t i);
    // light_color * material_color, or what the processor made of it.
    std::string product(std::size_t i, const std::string& face, const std::string& term, BroughtColor brought);
    // The same of the g-th three samples of the spectrum.
    std::string sample_product(std::size_t i, const std::string& face, const std::string& term);

    std::string scene_color(const std::string& face, const FaceEffects& varying);  // e_cm + a_cm a_cs
    std::string alpha(const std::string& face, const FaceEffects& varying);
    std::string shininess(const std::string& face, const FaceEffects& varying);

    std::string uniform(const std::string& type, const std::string& name, const std::string& comment,
                        const std::string& array = "");
    const std::string& declarations() const { return declarations_; }

    // struct Surface and struct Lit.
    std::string structs() const;
    // Surface(...): its position and normal, and of the vertex (prefix "a_") or fragment ("v_") what else it has.
    std::string surface(const std::string& position, const std::string& normal, const std::string& prefix) const;
    bool has_surface() const;

  private:
    template <class Name>
    std::string of_face(const std::string& face, const Name& name);
    std::string brought_color(const std::string& face, const std::string& property, BroughtColor brought);
    std::string product_type() const { return effects_.spectral_products ? "mat3" : "vec3"; }
    int loop_length(std::size_t i) const;

    const EffectSet& effects_;
    const Form& form_;
    std::set<std::string> declared_;
    std::string declarations_;
};

// What the two that write the text of lights share: lighting_text.cpp and precise/precise_text.cpp.
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
