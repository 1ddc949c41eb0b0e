#include "render/programmable/assembly.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "render/programmable/attributes.h"
#include "render/programmable/shader_files.h"

namespace twinlight::programmable {
namespace {

enum class Stage { kVertex, kFragment };

// The switches of #if, and the words that a piece leaves open.
using Words = std::vector<std::pair<std::string, std::string>>;

struct Scope {
    std::map<std::string, bool, std::less<>> switches;
    Words words;
    // Of a light that stands for many: what its uniforms begin with, and the length of their arrays.
    std::string looped_prefix{};
    int loop_length = 0;
};

// ---- From the effects to switches and words ----

// What the vertex brings: its colour, or its own material's.
bool varies_emission(const FaceEffects& face) { return face.tracks_emission || face.varies_emission; }
bool varies_ambient(const FaceEffects& face) { return face.tracks_ambient || face.varies_ambient; }
bool varies_diffuse(const FaceEffects& face) { return face.tracks_diffuse || face.varies_diffuse; }
bool varies_specular(const FaceEffects& face) { return face.tracks_specular || face.varies_specular; }

// What stands behind the primary colour.
void add_fragment_effects(Scope& scope, const EffectSet& effects, const Form& form, Stage stage) {
    const bool ray = form.surface.kind != SurfaceKind::kNone, ray_tex_coord = form.surface.tex_coord;
    const bool here = !ray || stage == Stage::kFragment;  // where the fragment's point is known
    using Environment = TextureEnvironment;
    const TextureEffects& texture = effects.texture;
    const auto is = [&](Environment environment) { return texture.environment == environment; };
    scope.switches.insert({
        {"EFFECT_PRIMARY", effects.needs_primary()},
        {"EFFECT_TEXTURE", effects.has_texture() && (here || !ray_tex_coord)},
        {"EFFECT_TEXTURE_MATRIX", texture.matrix && (here || !ray_tex_coord)},
        {"EFFECT_TEXTURE_Q", texture.q},
        {"EFFECT_TEXTURE_CLAMP_S", texture.clamp_s},
        {"EFFECT_TEXTURE_CLAMP_T", texture.clamp_t},
        {"EFFECT_TEXTURE_CLAMP", texture.clamp_s || texture.clamp_t},
        {"EFFECT_TEXTURE_GRADIENTS", texture.gradients},
        {"EFFECT_TEXEL_COLOR", texture.has_color()},
        {"EFFECT_TEXEL_ALPHA", texture.has_alpha()},
        {"EFFECT_TEXEL_INTENSITY", texture.texels == Texels::kIntensity},
        {"EFFECT_MODULATE", is(Environment::kModulate)},
        {"EFFECT_DECAL", is(Environment::kDecal)},
        {"EFFECT_REPLACE", is(Environment::kReplace)},
        {"EFFECT_BLEND", is(Environment::kBlend)},
        {"EFFECT_ADD", is(Environment::kAdd)},
        {"EFFECT_FOG", effects.has_fog() && here},
        {"EFFECT_FOG_LINEAR", effects.fog == FogEffect::kLinear},
        {"EFFECT_FOG_EXP", effects.fog == FogEffect::kExp},
        {"EFFECT_FOG_W", effects.has_fog() && effects.vertex_w && here},
        {"EFFECT_CLIP_PLANES", effects.clip_plane_count > 0 && !ray},
        {"EFFECT_SRGB_CODED", effects.srgb_coded},
    });
    const bool one = texture.one_dimensional, q = texture.q;
    const Words words = {
        {"SAMPLER", one ? "sampler1D" : "sampler2D"},
        {"TEX_COORD_TYPE", one ? (q ? "vec2" : "float") : (q ? "vec3" : "vec2")},
        {"TEX_COORD_PARTS", std::string(one ? "s" : "st") + (q ? "q" : "")},
        {"DIVIDED_TYPE", one ? "float" : "vec2"},
        {"DIVIDED_PARTS", one ? "s" : "st"},
        {"DIVIDED_TEX_COORD", ray_tex_coord ? (one ? "tex_place.s" : "tex_place.st")
                              : one         ? (q ? "v_tex_coord.s / v_tex_coord.t" : "v_tex_coord")
                                            : (q ? "v_tex_coord.st / v_tex_coord.p" : "v_tex_coord")},
        {"TEX_COORD_S", one ? "tex_coord" : "tex_coord.s"},
        {"TEXTURE_LOOKUP", q ? "textureProj" : "texture"},
        {"CLIP_PLANE_COUNT", std::to_string(effects.clip_plane_count)},
    };
    scope.words.insert(scope.words.end(), words.begin(), words.end());
}

// An exact surface's rays (form.h).
void add_rays(Scope& scope, const EffectSet& effects, const SurfaceForm& surface) {
    const auto is = [&](SurfaceKind kind) { return surface.kind == kind; };
    const bool ray = !is(SurfaceKind::kNone), steps = surface.offset || surface.tex_coord;
    scope.switches.insert({
        {"EFFECT_RAY", ray},
        {"EFFECT_RAY_SPHERE", is(SurfaceKind::kSphere)},
        {"EFFECT_RAY_FRUSTUM", is(SurfaceKind::kFrustum)},
        {"EFFECT_RAY_DISK", is(SurfaceKind::kDisk)},
        {"EFFECT_RAY_TORUS", is(SurfaceKind::kTorus)},
        {"EFFECT_RAY_SECTOR", surface.sector},
        {"EFFECT_RAY_INSIDE", surface.inside},
        {"EFFECT_RAY_TEX_COORD", surface.tex_coord},
        {"EFFECT_RAY_NEAR_FAR", surface.near_far},
        {"EFFECT_RAY_CULL", surface.culls},
        {"EFFECT_RAY_DEPTH", surface.depth},
        {"EFFECT_RAY_OFFSET", surface.offset},
        {"EFFECT_RAY_NEAREST", surface.nearest},
        {"EFFECT_RAY_STEPS", steps},
        {"EFFECT_RAY_NORMAL",
         (effects.needs_normal() && effects.shading == Shading::kPhong) || effects.two_side || steps},
    });
    // What a fragment is given: by the rasteriser between vertices, or by its ray.
    scope.words.emplace_back("GIVEN_", ray ? "" : "v_");
    if (ray) scope.words.emplace_back("gl_FrontFacing", "is_front");
}

// One text for the face that shows: of a fragment that is known.
bool shares_faces(const EffectSet& effects) {
    return effects.two_side && effects.shading == Shading::kPhong && effects.front == effects.back;
}

// What holds for the whole program.
Scope scope_of_stage(const EffectSet& effects, const Form& form, Stage stage) {
    const bool phong = effects.shading == Shading::kPhong;
    const bool lights_here = effects.lighting && phong == (stage == Stage::kFragment);
    const bool shininess = effects.shininess != Power::kOne;
    const bool reflection = effects.highlight == Highlight::kReflection;
    const bool specular = effects.any_light(&LightEffects::specular);

    bool positional = false, whole_power = shininess, real_power = effects.shininess == Power::kReal;
    for (const LightEffects& light : effects.lights) {
        positional |= !light.directional;
        whole_power |= light.spot_exponent != Power::kOne;
        real_power |= light.spot_exponent == Power::kReal;
    }
    const bool half_sum = specular && shininess && !reflection && (positional || effects.local_viewer);
    const bool normalizes_here = stage == Stage::kVertex ? effects.normalize : phong && effects.needs_normal();
    const bool makes_unit = !form.precise && (normalizes_here || (lights_here && effects.local_viewer));
    const bool properties = effects.front.varies() || effects.back.varies();
    const bool surface = effects.needs_position_eye() || effects.needs_normal() || effects.needs_color() || properties;

    // The vertex shader of a ray's rectangle has nothing to hand over.
    const bool given_here = lights_here || form.surface.kind == SurfaceKind::kNone;

    Scope scope;
    scope.switches = {
        {"EFFECT_LIGHTING", effects.lighting},
        {"EFFECT_PHONG", phong},
        {"EFFECT_FLAT", effects.shading == Shading::kFlat},
        {"EFFECT_CLAMP", effects.clamp},
        {"EFFECT_TWO_SIDE", effects.two_side},
        {"EFFECT_LOCAL_VIEWER", effects.local_viewer},
        {"EFFECT_VERTEX_W", effects.vertex_w && effects.needs_position_eye() && given_here},
        {"EFFECT_NORMALIZE", effects.normalize},
        {"EFFECT_SEPARATE_SPECULAR", effects.separate_specular},
        {"EFFECT_REFLECTION", reflection},
        {"EFFECT_SHININESS", shininess},
        {"EFFECT_POSITION_EYE", effects.needs_position_eye() && given_here},
        {"EFFECT_NORMAL", effects.needs_normal() && given_here},
        {"EFFECT_COLOR", effects.needs_color()},
        {"EFFECT_SURFACE", surface},
        {"EFFECT_VARIES_AMBIENT", varies_ambient(effects.front) || varies_ambient(effects.back)},
        {"EFFECT_VERTEX_PROPERTIES", properties},
        {"EFFECT_PRECISE", form.precise},
        {"EFFECT_RESCALE", form.rescale},
        {"EFFECT_UNIT", makes_unit || (lights_here && effects.vertex_w)},
        {"EFFECT_VPE_DIR", specular && shininess && (reflection || positional)},
        {"EFFECT_HIGHLIGHT_BOUND", shininess && !effects.normalize && !phong},
        {"EFFECT_SHOWN_FACE", shares_faces(effects)},
        {"EFFECT_OBJECT_SPACE", form.object_space},
        {"EFFECT_SAMPLED", effects.spectral_groups > 0},
        {"EFFECT_AMBIENT", effects.any_light(&LightEffects::ambient)},
        {"EFFECT_DIFFUSE", effects.any_light(&LightEffects::diffuse)},
        {"EFFECT_SPECULAR", specular},
        {"EFFECT_HALF_SUM", half_sum},
        {"EFFECT_POWER_WHOLE", whole_power && !form.precise},
        {"EFFECT_POWER_REAL", real_power},
    };
    scope.words = {
        {"INTERPOLATION", effects.shading == Shading::kFlat ? "flat" : "smooth"},
        {"SPACE", form.object_space ? "object" : "eye"},
        {"GROUPS", std::to_string(effects.spectral_groups)},
        {"SPECULAR_SAMPLES", effects.separate_specular ? "secondary_samples" : "samples"},
        {"PRODUCT_TYPE", effects.spectral_products ? "mat3" : "vec3"},
        {"POSITION", form.position_w ? "a_position" : "vec4(a_position.xyz, 1.0)"},
        {"SURFACE_PARAMETER", surface ? "Surface surface" : ""},
        {"SURFACE", surface ? "surface" : ""},
        {"VERSION", form.precise ? "400" : "130"},  // `precise` is of 4.00
        {"SPECULAR_SUM", form.precise                ? (effects.separate_specular ? "secondary" : "primary")
                         : effects.separate_specular ? "lit.secondary"
                                                     : "lit.primary.rgb"},
        {"POWER_OF_ROOT", effects.shininess == Power::kReal ? "real_power_of_root" : "whole_power_of_root"},
        {"POWER", effects.shininess == Power::kReal ? "real_power" : "whole_power"},
    };
    add_fragment_effects(scope, effects, form, stage);
    add_rays(scope, effects, form.surface);
    return scope;
}

Scope scope_of_face(Scope scope, const FaceEffects& face, const std::string& name) {
    const bool is_shown = name == "shown";
    scope.switches["EFFECT_FACE_VARIES_EMISSION"] = varies_emission(face);
    scope.switches["EFFECT_FACE_VARIES_AMBIENT"] = varies_ambient(face);
    scope.switches["EFFECT_FACE_VARIES_DIFFUSE"] = varies_diffuse(face);
    scope.switches["EFFECT_FACE_VARIES_SPECULAR"] = varies_specular(face);
    scope.switches["EFFECT_FACE_VARIES_SHININESS"] = face.varies_shininess;
    const auto of_face = [&](const char* before, const char* property_name) {
        return is_shown ? fmt::format("(gl_FrontFacing ? {0}front_{1} : {0}back_{1})", before, property_name)
                        : fmt::format("{}{}_{}", before, name, property_name);
    };
    const auto property = [&](bool tracks, const char* property_name) {
        return tracks ? "surface.color" : of_face("surface.", property_name);
    };
    scope.words.insert(scope.words.begin(),
                       {{"VERTEX_EMISSION", property(face.tracks_emission, "emission")},
                        {"VERTEX_AMBIENT", property(face.tracks_ambient, "ambient")},
                        {"VERTEX_DIFFUSE", property(face.tracks_diffuse, "diffuse")},
                        {"VERTEX_SPECULAR", property(face.tracks_specular, "specular")},
                        {"SHININESS_OF_FACE", of_face(face.varies_shininess ? "surface." : "u_", "shininess")},
                        {"BASE_OF_FACE", of_face("u_", "base")},
                        {"AMBIENT_SAMPLES_OF_FACE", of_face("u_", "ambient_samples[g]")},
                        {"DIFFUSE_SAMPLES_OF_FACE", of_face("u_", "diffuse_samples[g]")},
                        {"SPECULAR_SAMPLES_OF_FACE", of_face("u_", "specular_samples[g]")},
                        {"ALPHA_OF_FACE", of_face("u_", "alpha")}});
    scope.words.emplace_back("FACE", name);  // after SURFACE
    return scope;
}

Scope scope_of_light(Scope scope, const EffectSet& effects, const Form& form, std::size_t number) {
    const LightEffects& light = effects.lights[number];
    const bool shininess = effects.shininess != Power::kOne;
    const bool reflection = effects.highlight == Highlight::kReflection;
    const bool cone = light.spot || light.smooth_cone;
    const bool highlight = light.specular && shininess && !reflection;
    const bool half_sum = highlight && (!light.directional || effects.local_viewer);
    const bool n_dot_vp = light.diffuse || (light.specular && !reflection);
    scope.switches.insert({
        {"EFFECT_LIGHT_DIRECTIONAL", light.directional},
        {"EFFECT_LIGHT_ATTENUATED", light.attenuated},
        {"EFFECT_LIGHT_SPOT", light.spot},
        {"EFFECT_LIGHT_SPOT_EXPONENT", light.spot_exponent != Power::kOne},
        {"EFFECT_LIGHT_SMOOTH_CONE", light.smooth_cone},
        {"EFFECT_LIGHT_CONE", cone},
        {"EFFECT_LIGHT_REACH", light.attenuated || cone},
        {"EFFECT_LIGHT_AMBIENT", light.ambient},
        {"EFFECT_LIGHT_DIFFUSE", light.diffuse},
        {"EFFECT_LIGHT_SPECULAR", light.specular},
        {"EFFECT_LIGHT_N_DOT_VP", n_dot_vp},
        {"EFFECT_LIGHT_VP_DIR", cone || n_dot_vp || (light.specular && shininess)},
        {"EFFECT_LIGHT_HALF_DIR", highlight && !half_sum},
        {"EFFECT_LIGHT_HALF_SUM", half_sum},
        {"EFFECT_LIGHT_LOOP", number >= effects.lights.size() - form.loops.size()},
    });
    const std::size_t written_out = effects.lights.size() - form.loops.size();
    if (number >= written_out) {
        scope.looped_prefix = fmt::format("u_light{}_", number);
        scope.loop_length = form.loops[number - written_out];
    }
    const auto chosen = [&](const char* property) {
        return fmt::format("(gl_FrontFacing ? u_light{0}_front_{1} : u_light{0}_back_{1})", number, property);
    };
    const bool is_shown = scope.words.back() == std::pair<std::string, std::string>("FACE", "shown");
    const bool reach = light.attenuated || cone;
    scope.words.insert(
        scope.words.begin(),
        {{"FOR_EACH_OF_LIGHTi",
          scope.loop_length == 0 ? "" : fmt::format("for (int i = 0; i < int(u_count_of_light{}); ++i) ", number)},
         {"LIGHTi", fmt::format("light{}", number)},
         {"TIMES_ATTENUATION_DIVISOR", light.attenuated ? " * attenuation_divisor" : ""},
         {"TIMES_HALF_SUM_SQUARED", half_sum ? " * half_sum_squared" : ""},
         {"VP_DIR", light.directional ? "vp_dir" : "(vp * per_distance)"},
         {"REACH_TIMES ", reach ? "reach * " : ""},
         {"SPOT_POWER", light.spot_exponent == Power::kReal ? "real_power" : "whole_power"}});
    if (is_shown)
        scope.words.insert(scope.words.begin(), {{"u_LIGHTi_FACE_ambient", chosen("ambient")},
                                                 {"u_LIGHTi_FACE_diffuse", chosen("diffuse")},
                                                 {"u_LIGHTi_FACE_specular", chosen("specular")}});
    return scope;
}

// ---- Carrying out the directives ----

std::string_view trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t");
    if (first == text.npos) return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::vector<std::string_view> split(std::string_view text, std::string_view separator) {
    std::vector<std::string_view> parts;
    for (std::size_t end; (end = text.find(separator)) != text.npos; text.remove_prefix(end + separator.size()))
        parts.push_back(text.substr(0, end));
    if (!text.empty()) parts.push_back(text);
    return parts;
}

// "A && !B || C" over the scope's switches.
bool holds(std::string_view condition, const Scope& scope) {
    const auto term = [&](std::string_view text) {
        text = trimmed(text);
        const bool negated = text.starts_with('!');
        const auto found = scope.switches.find(text.substr(negated));
        if (found == scope.switches.end())
            throw std::logic_error(fmt::format("a shader piece asks for an unknown effect: {}", text));
        return found->second != negated;
    };
    return std::ranges::any_of(split(condition, "||"), [&](std::string_view product) {
        return std::ranges::all_of(split(product, "&&"), term);
    });
}

std::string with_words(std::string_view line, const Words& words) {
    std::string result(line);
    for (const auto& [word, meaning] : words)
        for (std::size_t at = 0; (at = result.find(word, at)) != result.npos; at += meaning.size())
            result.replace(at, word.size(), meaning);
    return result;
}

std::string_view piece(std::string_view name) {
    for (const EmbeddedFile& file : kShaderFiles)
        if (file.name == name) return file.text;
    throw std::logic_error(fmt::format("there is no shader piece {}", name));
}

// "u_light3_position" becomes u_light3_position[64] in its declaration, u_light3_position[i] elsewhere.
std::string with_elements(std::string line, const std::string& prefix, int length) {
    const std::string element = line.starts_with("uniform ") ? fmt::format("[{}]", length) : "[i]";
    for (std::size_t at = 0; (at = line.find(prefix, at)) != line.npos; at += element.size()) {
        at = line.find_first_not_of("abcdefghijklmnopqrstuvwxyz_0123456789", at);
        line.insert(std::min(at, line.size()), element);
    }
    return line;
}

class Assembler {
  public:
    Assembler(const EffectSet& effects, const Form& form) : effects_(effects), form_(form) {}

    std::string text(std::string_view name, Stage stage) {
        add(name, scope_of_stage(effects_, form_, stage));
        return std::move(text_);
    }

  private:
    struct Branch {
        bool taken = false;  // this branch's lines are passed on
        bool done = false;   // a branch of this #if has been taken
    };

    void add(std::string_view name, const Scope& scope) {
        std::vector<Branch> branches;
        const auto passes = [&] { return std::ranges::all_of(branches, &Branch::taken); };
        for (std::string_view line : split(piece(name), "\n")) {
            const std::string_view rest =
                line.starts_with('#') ? trimmed(line.substr(std::min(line.find(' '), line.size()))) : "";
            if (line.starts_with("#if ")) {
                const bool taken = passes() && holds(rest, scope);
                branches.push_back({taken, taken});
            } else if (line.starts_with("#elif ")) {
                Branch& branch = branches.back();
                branch.taken = !branch.done && outer_passes(branches) && holds(rest, scope);
                branch.done |= branch.taken;
            } else if (line.starts_with("#else")) {
                branches.back().taken = !branches.back().done;
            } else if (line.starts_with("#endif")) {
                branches.pop_back();
            } else if (passes()) {
                add_line(line, rest, scope);
            }
        }
        if (!branches.empty()) throw std::logic_error(fmt::format("{}: an #if has no #endif", name));
    }

    static bool outer_passes(const std::vector<Branch>& branches) {
        return std::all_of(branches.begin(), branches.end() - 1, [](const Branch& b) { return b.taken; });
    }

    void add_line(std::string_view line, std::string_view argument, const Scope& scope) {
        const std::string_view repeated = line.substr(std::min(line.find(' '), line.size() - 1) + 1);
        const std::string_view name = argument.size() > 2 ? argument.substr(1, argument.size() - 2) : "";
        if (line.starts_with("#include ")) {
            add(name, scope);
        } else if (line.starts_with("#for_each_light ")) {
            for (std::size_t i = 0; i < effects_.lights.size(); ++i)
                add(name, scope_of_light(scope, effects_, form_, i));
        } else if (line.starts_with("#for_each_property ")) {
            for (const VertexProperty& property : vertex_properties(effects_))
                add_text(repeated,
                         {{"PROPERTY_TYPE", property.size == 1 ? "float" : fmt::format("vec{}", property.size)},
                          {"PROPERTY", property.name}});
        } else if (line.starts_with("#for_each_clip_plane ")) {
            for (int i = 0; i < effects_.clip_plane_count; ++i)
                add_text(with_words(repeated, {{"CLIP_PLANE_NUMBER", std::to_string(i)}}), scope.words);
        } else if (line.starts_with("#for_each_face ")) {
            add(name, scope_of_face(scope, effects_.front, "front"));
            if (effects_.two_side) add(name, scope_of_face(scope, effects_.back, "back"));
        } else if (line.starts_with("#for_each_lit_face ")) {
            const bool shares = shares_faces(effects_);
            add(name, scope_of_face(scope, effects_.front, shares ? "shown" : "front"));
            if (effects_.two_side && !shares) add(name, scope_of_face(scope, effects_.back, "back"));
        } else if (!line.empty() || (!text_.ends_with("\n\n") && !text_.empty())) {  // no two empty lines
            std::string text = with_words(line, scope.words);
            if (scope.loop_length > 0) text = with_elements(std::move(text), scope.looped_prefix, scope.loop_length);
            text_ += text + "\n";
        }
    }

    void add_text(std::string_view line, const Words& words) { text_ += with_words(line, words) + "\n"; }

    const EffectSet& effects_;
    const Form& form_;
    std::string text_;
};

}  // namespace

ShaderSource assemble(const EffectSet& effects, const Form& form) {
    return {Assembler(effects, form).text("vertex.glsl", Stage::kVertex),
            Assembler(effects, form).text("fragment.glsl", Stage::kFragment)};
}

}  // namespace twinlight::programmable
