#include "render/programmable/text/shader_assembly.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <string_view>
#include <vector>

#include "render/programmable/numbers/program_uniforms.h"
#include "render/programmable/numbers/vertex_attributes.h"
#include "render/programmable/text/kept_text.h"
#include "render/programmable/text/lighting_names.h"
#include "render/programmable/text/lighting_text.h"
#include "render/programmable/text/precise_text.h"
#include "render/programmable/text/rectangles_text.h"
#include "render/programmable/text/shader_pieces.h"

namespace twinlight::programmable {
namespace {

enum class Stage { kVertex, kFragment };

// A value that the vertex shader passes to the fragment shader.
struct Varying {
    std::string type, name;
    std::string value;  // in the vertex shader
    std::string comment{};
    bool is_color = false;  // "flat" takes the provoking vertex's value (section 2.14.7, table 2.12)
    bool is_flat = false;   // the same at all vertices
};

class Assembler {
  public:
    Assembler(const EffectSet& effects, const Form& form)
        : effects_(effects),
          form_(form),
          names_(effects, form),
          lighting_(form.precise ? precise_lighting_text(effects, form) : lighting_text(effects, form)) {}

    std::string text(Stage stage) const {
        const bool is_vertex = stage == Stage::kVertex, lights_here = lights_in(stage);
        const Scope scope = scope_of(stage);
        std::string body = !is_vertex && has_ray() ? preprocessed("surface_crossings.glsl", scope) : "";
        if (lights_here) body += lighting_.functions;
        body += preprocessed(is_vertex ? "vertex.glsl" : "fragment.glsl", scope);
        if (is_vertex && position_is_attribute()) body = with_variable(body, "position", "a_position");
        if (form_.kept) body = with_words(body, kept_names());

        std::string uniforms, functions;
        for (const Definition& definition : used_definitions(library(scope.words), body)) {
            if (!definition.is_uniform)
                functions += definition.text + "\n";
            else if (form_.kept)  // a blank line before each struct
                uniforms += (definition.text.starts_with("//") && !uniforms.empty() ? "\n" : "") +
                            with_used_members(definition, body);
            else
                uniforms += definition.text;
        }
        if (lights_here) uniforms += lighting_.uniforms;
        for (int i = 0; !form_.kept && is_vertex != has_ray() && i < effects_.clip_plane_count; ++i)
            uniforms += fmt::format("uniform vec4 {};  // glClipPlane (section 2.12), in object coordinates\n",
                                    clip_plane_name(i));
        if (!uniforms.empty()) uniforms += "\n";
        std::string text = fmt::format("#version {}\n{}\n{}{}{}{}{}", version(), purpose(stage),
                                       is_vertex ? attributes_text(body) : inputs_text(), uniforms,
                                       is_vertex ? outputs_text() : "", functions, body);
        check_uniforms_are_declared(text);
        return text;
    }

  private:
    bool has_ray() const { return form_.surface.kind != SurfaceKind::kNone; }
    bool is_phong() const { return effects_.shading == Shading::kPhong; }
    bool lights_in(Stage stage) const { return effects_.lighting && is_phong() == (stage == Stage::kFragment); }

    // In shaders to keep, positions are GL's.
    bool position_is_attribute() const { return form_.kept && form_.position_w && !form_.flat_edges && !has_ray(); }

    // What follows #version. The precisions of OpenGL ES for floats, integers and most samplers are too low.
    std::string version() const {
        switch (form_.dialect) {
            case Glsl::k130: return lighting_.version;
            case Glsl::k330: return "330 core";
            case Glsl::k300es: break;
        }
        std::set<std::string> types{sampler_of(effects_.texture)};
        for (const UnitEffects& unit : effects_.units) types.insert(sampler_of(unit.texture));
        if (reads_stored_color(form_.logic_op)) types.insert("sampler2D");  // u_framebuffer
        std::string text = "300 es\nprecision highp float;\nprecision highp int;";
        for (const std::string& type : types) text += fmt::format("\nprecision highp {};", type);
        return text;
    }

    const char* purpose(Stage stage) const {
        const bool lights_here = lights_in(stage);
        if (stage == Stage::kFragment) {
            if (has_ray())
                return lights_here ? "// Fragment shader: finds where the pixel's ray meets an exact surface and "
                                     "lights that point (GL 2.1, "
                                     "section 2.14).\n"
                                   : "// Fragment shader: finds where the pixel's ray meets an exact surface and "
                                     "colours that point (GL 2.1, "
                                     "sections 3.8 to 3.10).\n";
            return lights_here ? "// Fragment shader: lights each fragment as section 2.14 of GL 2.1 lights a vertex.\n"
                               : "// Fragment shader: computes the colour from interpolated values (GL 2.1, sections "
                                 "3.8 to 3.10).\n";
        }
        if (has_ray())
            return lights_here
                       ? "// Vertex shader: a rectangle around an exact surface. The whole surface gets one colour, "
                         "computed here (GL 2.1, section 2.14).\n"
                       : "// Vertex shader: a rectangle around an exact surface.\n";
        if (!lights_here)
            return "// Vertex shader: transforms positions to clip coordinates (GL 2.1, section 2.11) and passes "
                   "values to "
                   "the fragment shader.\n";
        return form_.object_space ? "// Vertex shader: transforms positions to clip coordinates (GL 2.1, section 2.11) "
                                    "and lights vertices "
                                    "(section 2.14).\n"
                                    "// The modelview matrix keeps angles, so lighting works in object coordinates.\n"
                                  : "// Vertex shader: transforms positions to clip coordinates (GL 2.1, section 2.11) "
                                    "and lights vertices in "
                                    "eye coordinates\n// (section 2.14).\n";
    }

    // ---- From the vertex to the fragment ----

    std::string attributes_text(const std::string& body) const {
        std::vector<Definition> all;
        int location = 0;
        std::vector<Attribute> taken = attributes(effects_);
        for (const Attribute& attribute : line_attributes(form_)) taken.push_back(attribute);
        for (const Attribute& attribute : taken) {
            const std::string name = form_.kept ? with_words(attribute.name, kept_names()) : attribute.name;
            const bool is_located = form_.dialect != Glsl::k130;
            const std::string layout = is_located ? fmt::format("layout(location = {}) ", location++) : "";
            all.push_back({name, fmt::format("{}in {} {};\n", layout, attribute.type, name)});
        }
        std::string text;
        for (const Definition& definition : used_definitions(all, body)) text += definition.text;
        return text + "\n";
    }

    // For an exact surface only values that are the same on the whole rectangle, or that no point of the ray gives.
    std::vector<Varying> varyings() const {
        std::vector<Varying> list;
        if (is_phong() && effects_.lighting) {
            if (effects_.needs_position_eye() && !has_ray()) {
                if (form_.wide_range)
                    list.push_back({"vec4", "v_position_object", lighting_.vertex_position});
                else if (effects_.vertex_w)
                    list.push_back({"vec4", "v_position_eye", lighting_.vertex_position});
                else
                    list.push_back({"vec3", "v_position_eye", fmt::format("({}).xyz", lighting_.vertex_position)});
            }
            if (effects_.needs_normal() && !has_ray())
                list.push_back({"vec3", "v_normal_eye", lighting_.vertex_normal});
            if (effects_.needs_color()) list.push_back({"vec4", "v_color", "a_color"});
            for (const VertexProperty& property : vertex_properties(effects_))
                list.push_back({property.type(), "v_" + property.name, "a_" + property.name});
        } else {
            const char* unlit = effects_.clamp ? "clamp(a_color, 0.0, 1.0)" : "a_color";
            for (const std::string face : {"front", "back"}) {
                if (face == "back" && !effects_.two_side) continue;
                const auto add = [&](const char* type, const char* name, bool is_needed) {
                    if (is_needed)
                        list.push_back({.type = type,
                                        .name = fmt::format("v_{}_{}", face, name),
                                        .value = effects_.lighting ? lit_value(face, name) : unlit,
                                        .is_color = true});
                };
                add("vec4", "primary", effects_.needs_primary());
                add("vec3", "secondary", effects_.separate_specular);
            }
            if (effects_.secondary_color)
                list.push_back({.type = "vec3",
                                .name = "v_front_secondary",
                                .value = "clamp(a_secondary_color, 0.0, 1.0)",
                                .is_color = true});
        }
        if (effects_.has_texture() && !effects_.texture.sprite && !form_.surface.tex_coord)
            list.push_back(tex_coord_varying(effects_.texture, ""));
        for (const UnitEffects& unit : effects_.units)
            if (!unit.texture.sprite) list.push_back(tex_coord_varying(unit.texture, std::to_string(unit.number)));
        if (effects_.fog_coords)
            list.push_back({"float", "v_fog_coord", "a_fog_coord"});
        else if (effects_.has_fog() && !has_ray())
            list.push_back({effects_.vertex_w ? "vec2" : "float", "v_eye_z", eye_z("position"),
                            effects_.vertex_w ? "  // z and w" : ""});
        for (int i = 0; discards_clipped() && i < effects_.clip_plane_count; ++i)
            list.push_back({"float", fmt::format("v_clip_distance{}", i), clip_distance(i)});
        if (form_.rectangles == Rectangles::kLines)
            list.push_back(
                {.type = "vec4", .name = "v_line_ends_window", .value = "line_ends_window", .is_flat = true});
        if (form_.needs_point_window())
            list.push_back({.type = "vec2", .name = "v_point_window", .value = "point_window", .is_flat = true});
        if (form_.smooth && effects_.attenuated_points)
            list.push_back({.type = "float", .name = "v_point_size", .value = attenuated_size(), .is_flat = true});
        if (form_.line_stipple)
            list.push_back({.type = "vec3", .name = "v_line_count", .value = "a_line_count", .is_flat = true});
        return list;
    }
    std::string declared(const char* direction) const {
        const char* interpolation = effects_.shading == Shading::kFlat ? "flat " : "";
        std::string text;
        for (const Varying& varying : varyings())
            text += fmt::format("{}{} {} {};{}\n",
                                varying.is_flat    ? "flat "
                                : varying.is_color ? interpolation
                                                   : "",
                                direction, varying.type, varying.name, varying.comment);
        return text;
    }
    std::string outputs_text() const {
        std::string text = declared("out");
        if (effects_.clip_plane_count > 0 && !has_ray() && !discards_clipped())
            text += fmt::format("out float gl_ClipDistance[{}];\n", effects_.clip_plane_count);
        return text + (text.empty() ? "" : "\n") +
               "invariant gl_Position;  // another program with the same positions gets the same depths\n\n";
    }
    std::string inputs_text() const {
        const std::string text = declared("in");
        return text + (text.empty() ? "" : "\n") + "out vec4 fragment_color;\n\n";
    }
    std::string outputs() const {
        std::string text;
        for (const Varying& varying : varyings()) text += fmt::format("    {} = {};\n", varying.name, varying.value);
        return text;
    }

    // OpenGL ES has no clip planes: the fragment shader discards what they clip.
    bool discards_clipped() const { return form_.dialect == Glsl::k300es && !has_ray(); }
    // Negative where the plane clips (section 2.12).
    std::string clip_distance(int i) const {
        if (form_.kept)
            return fmt::format("dot(ClipPlane[{}], ModelViewMatrix * position)",
                               form_.kept->clip_planes.at(static_cast<std::size_t>(i)));
        return fmt::format("dot({}, position)", clip_plane_name(i));
    }

    // The eye coordinate z of an object position, and w if it may differ from 1.
    std::string eye_z(const char* position) const {
        if (form_.kept) return fmt::format("(ModelViewMatrix * {}).{}", position, effects_.vertex_w ? "zw" : "z");
        const std::string z = fmt::format("dot(u_eye_z_from_object, {})", position);
        return effects_.vertex_w ? fmt::format("vec2({}, dot(u_eye_w_from_object, {}))", z, position) : z;
    }

    // ---- Lighting, in main() ----

    std::string divided(const std::string& position) const {
        if (effects_.vertex_w) return fmt::format("divided_by_w({})", position);
        return position.ends_with(')') ? position + ".xyz" : fmt::format("({}).xyz", position);
    }

    // The statements that call light_front() or light_back() with a Surface.
    std::string lit_vertex() const {
        const std::string position = names_.position_is_homogeneous() ? lighting_.vertex_position
                                     : form_.object_space             ? "position.xyz"
                                                                      : divided(lighting_.vertex_position);
        const std::string surface = names_.surface(position, lighting_.vertex_position, lighting_.vertex_normal, "a_");
        const char* argument = names_.has_surface() ? "surface" : "";
        std::string text;
        if (names_.has_surface()) text += fmt::format("    Surface surface = {};\n", surface);
        if (passes_one_lit_color()) return text;
        text += fmt::format("    Lit front = light_front({});\n", argument);
        if (!effects_.two_side) return text;
        text +=
            "    // The back face has its own material and the opposite normal. The fragment shader picks the visible "
            "face.\n";
        if (effects_.needs_normal()) text += fmt::format("    {0} = -{0};\n", names_.normal());
        return text + fmt::format("    Lit back = light_back({});\n", argument);
    }
    // Then the vertex shader calls light_front() where it passes the colour on.
    bool passes_one_lit_color() const {
        return !effects_.two_side && !form_.flat_edges && effects_.needs_primary() != effects_.separate_specular;
    }
    std::string lit_value(const std::string& face, const char* name) const {
        if (!passes_one_lit_color()) return fmt::format("{}.{}", face, name);
        return fmt::format("light_front({}).{}", names_.has_surface() ? "surface" : "", name);
    }
    std::string lit_fragment() const {
        std::string position = form_.wide_range    ? "v_position_object"
                               : form_.homogeneous ? "v_position_eye"
                               : effects_.vertex_w ? "divided_by_w(v_position_eye)"
                                                   : "v_position_eye";
        std::string normal = "v_normal_eye";
        if (has_ray()) {
            position = form_.object_space ? "position_object" : divided("u_eye_from_object * place");
            normal = form_.surface.inside ? "-outward" : "outward";
            if (!form_.object_space) normal = "u_eye_from_object_normal * " + normal;
        }
        const char* argument = names_.has_surface() ? "surface" : "";
        const std::string is_front = names_.is_front();
        std::string text;
        if (names_.has_surface())
            text += fmt::format(
                "    Surface surface = {};\n",
                names_.surface(position, has_ray() ? "u_eye_from_object * place" : "v_position_eye",
                               fmt::format("{}({})", form_.wide_normals ? "unit_of_any" : "unit", normal), "v_"));
        const std::string turn = fmt::format("{0} = -{0};\n", names_.normal());
        if (!effects_.two_side) {
            text += fmt::format("    Lit lit = light_front({});\n", argument);
        } else if (shares_faces(effects_)) {
            if (effects_.needs_normal()) text += fmt::format("    if (!{}) {}", is_front, turn);
            text += fmt::format("    Lit lit = light_shown({});\n", argument);
        } else {
            text += fmt::format("    Lit lit;\n    if ({}) {{\n        lit = light_front({});\n    }} else {{\n",
                                is_front, argument);
            if (effects_.needs_normal()) text += "        " + turn;
            text += fmt::format("        lit = light_back({});\n    }}\n", argument);
        }
        return text;
    }
    std::string lit(Stage stage) const {
        if (stage == Stage::kVertex) return lights_in(stage) ? lit_vertex() : "";
        std::string text = lights_in(stage) ? lit_fragment() : "";
        // GL_COMBINE may use it often.
        if (!effects_.units.empty()) text += fmt::format("    vec4 primary = {};\n", lit_color(stage, "primary"));
        return text;
    }
    // In the fragment shader: the primary or secondary colour of the visible face.
    std::string lit_color(Stage stage, const char* name) const {
        if (lights_in(stage)) return fmt::format("lit.{}", name);
        if (!effects_.two_side) return fmt::format("v_front_{}", name);
        return fmt::format("{1} ? v_front_{0} : v_back_{0}", name, names_.is_front());
    }
    // Whether the first colour is the fragment's colour.
    bool has_one_step() const {
        return environment().empty() && !effects_.separate_specular && !effects_.secondary_color &&
               !effects_.has_fog() && !effects_.srgb_coded && !form_.smooth && form_.alpha_func == kGL_ALWAYS &&
               form_.logic_op == kGL_COPY && !form_.scales_source;
    }

    // ---- Textures and fog ----

    // `suffix`: "" for the only texture; for a Draw that combines textures, the unit's number.
    static std::string tex_coord_type(const TextureEffects& texture) {
        const int parts = (texture.needs_r() ? 3 : texture.one_dimensional ? 1 : 2) + (texture.q ? 1 : 0);
        return parts == 1 ? "float" : fmt::format("vec{}", parts);
    }
    static Varying tex_coord_varying(const TextureEffects& texture, const std::string& suffix) {
        const std::string tex_coord = (texture.generates() ? "tex_coord" : "a_tex_coord") + suffix;
        return {tex_coord_type(texture), "v_tex_coord" + suffix,
                fmt::format("{}.{}",
                            texture.matrix ? fmt::format("(u_texture_matrix{} * {})", suffix, tex_coord) : tex_coord,
                            std::string(texture.needs_r()         ? "stp"
                                        : texture.one_dimensional ? "s"
                                                                  : "st") +
                                (texture.q ? "q" : ""))};
    }

    // In the vertex shader's main(): the vec4 tex_coord (section 2.11.4), or tex_coord0, tex_coord1, ...
    std::string generated() const {
        if (effects_.units.empty()) return generated(effects_.texture, 0);
        std::string text;
        for (const UnitEffects& unit : effects_.units) {
            const std::string name = fmt::format("tex_coord{}", unit.number);
            std::string block = generated(unit.texture, unit.number);
            if (block.empty()) continue;
            // The names besides that of the coordinates are the same for each unit.
            Words names = {{"tex_coord", name}, {"a_tex_coord", "a_" + name}};
            for (const char coordinate : {'s', 't', 'r', 'q'})
                for (const char* space : {"object", "eye"}) {
                    const std::string plane = fmt::format("u_plane_{}_{}", coordinate, space);
                    names[plane] = fmt::format("{}{}", plane, unit.number);
                }
            block = with_words(block, names);
            const std::size_t declared = block.find("    vec4 " + name), end = block.find('\n', declared) + 1;
            text += block.substr(0, end) + "    {\n" + indented(block.substr(end)) + "    }\n";
        }
        return text;
    }
    static std::string indented(std::string_view lines) {
        std::string text;
        for (const char c : lines) {
            if (text.empty() || text.back() == '\n') text += "    ";
            text += c;
        }
        return text;
    }
    std::string generated(const TextureEffects& texture, std::size_t unit) const {
        if (!texture.generates()) return "";
        const auto is_eye_plane = [&](std::size_t i) {  // otherwise planes are in object coordinates
            return form_.kept && form_.kept->eye_planes.at(unit)[i] && texture.generated[i] == Generated::kLinear;
        };
        std::string text = fmt::format("    // glTexGen (section 2.11.4)\n    vec4 tex_coord = {};\n",
                                       !texture.generates_all() ? "a_tex_coord" : "vec4(0.0, 0.0, 0.0, 1.0)");
        if (texture.generates_from_direction() || is_eye_plane(0) || is_eye_plane(1) || is_eye_plane(2) ||
            is_eye_plane(3))
            text += "    vec4 position_eye = u_generated_eye_from_object * position;\n";
        if (texture.generated_normal != GeneratedNormal::kUnused) {
            std::string normal = "u_generated_normal_from_object * a_normal";
            if (texture.generated_normal == GeneratedNormal::kUnit)
                normal = fmt::format("unit_of_any({})", normal);
            else if (form_.kept && form_.kept->rescales_generated)
                normal = fmt::format("u_normal_scale * ({})", normal);
            text += fmt::format("    vec3 normal_eye = {};\n", normal);
        }
        if (texture.generates_from_direction())
            text += fmt::format("    vec3 reflected = reflect(unit_of_any({}), normal_eye);\n",
                                texture.generated_w ? "position_eye.w < 0.0 ? -position_eye.xyz : position_eye.xyz"
                                                    : "position_eye.xyz");
        for (std::size_t i = 0; i < texture.generated.size(); ++i) {
            const char component = "xyzw"[i];
            const auto add = [&](const std::string& value) {
                text += fmt::format("    tex_coord.{} = {};\n", "stpq"[i], value);
            };
            switch (texture.generated[i]) {
                case Generated::kNot: break;
                case Generated::kLinear:
                    add(fmt::format(fmt::runtime(is_eye_plane(i) ? "dot(u_plane_{}_eye, position_eye)"
                                                                 : "dot(u_plane_{}_object, position)"),
                                    "strq"[i]));
                    break;
                case Generated::kSphereMap: add(fmt::format("sphere_map(reflected).{}", component)); break;
                case Generated::kReflectionMap: add(fmt::format("reflected.{}", component)); break;
                case Generated::kNormalMap: add(fmt::format("normal_eye.{}", component)); break;
            }
        }
        return text;
    }

    // Section 3.8.13, tables 3.22 and 3.23. `texel` and `constant` (GL_TEXTURE_ENV_COLOR): their names.
    static std::string environment_statements(const TextureEffects& texture, const std::string& texel,
                                              const std::string& constant) {
        const bool rgb = texture.has_color(), alpha = texture.has_alpha();
        std::string text;
        const auto add = [&](bool has, fmt::format_string<const std::string&, const std::string&> statement) {
            if (has) text += fmt::format("    {}\n", fmt::format(statement, texel, constant));
        };
        // GL_BLEND and GL_ADD treat the alpha of GL_INTENSITY like a colour, and multiply by any other alpha.
        const bool intensity = texture.texels == Texels::kIntensity;
        switch (texture.environment) {
            case TextureEnvironment::kNone:
            case TextureEnvironment::kCombine: break;
            case TextureEnvironment::kReplace:
                add(rgb, "color.rgb = {0}.rgb;");
                add(alpha, "color.a = {0}.a;");
                break;
            case TextureEnvironment::kModulate:
                add(rgb, "color.rgb *= {0}.rgb;");
                add(alpha, "color.a *= {0}.a;");
                break;
            case TextureEnvironment::kDecal: add(true, "color.rgb = mix(color.rgb, {0}.rgb, {0}.a);"); break;
            case TextureEnvironment::kBlend:
                add(rgb, "color.rgb = mix(color.rgb, {1}.rgb, {0}.rgb);");
                add(intensity, "color.a = mix(color.a, {1}.a, {0}.a);");
                add(alpha && !intensity, "color.a *= {0}.a;");
                break;
            case TextureEnvironment::kAdd:
                add(rgb, "color.rgb = min(color.rgb + {0}.rgb, 1.0);");
                add(intensity, "color.a = min(color.a + {0}.a, 1.0);");
                add(alpha && !intensity, "color.a *= {0}.a;");
                break;
        }
        return text;
    }
    // The colour with which a fragment begins: the primary colour, or with the texture where one product or the texel is the whole
    // texture environment.
    std::string first_color(Stage stage) const {
        if (!effects_.units.empty()) return "primary";
        if (!effects_.needs_primary()) return "texel";
        const std::string primary = lit_color(stage, "primary");
        if (!is_product(effects_.texture)) return primary;
        return (primary.find(' ') != primary.npos ? "(" + primary + ")" : primary) + " * texel";
    }
    static bool is_product(const TextureEffects& texture) {
        return texture.environment == TextureEnvironment::kModulate && texture.has_color() && texture.has_alpha();
    }
    // What follows.
    std::string environment() const {
        if (!effects_.units.empty()) return texture_environments();
        if (!effects_.needs_primary() || is_product(effects_.texture)) return "";
        return environment_statements(effects_.texture, "texel", "u_texture_env_color");
    }
    std::string comment_of_environment() const {
        const auto comment = [&](const char* mode) {
            return fmt::format("  // {}{} (section 3.8.13)", environment().empty() ? "" : "then ", mode);
        };
        switch (effects_.texture.environment) {
            case TextureEnvironment::kNone:
            case TextureEnvironment::kCombine: break;
            case TextureEnvironment::kModulate: return comment("GL_MODULATE");
            case TextureEnvironment::kReplace: return comment("GL_REPLACE");
            case TextureEnvironment::kDecal: return comment("GL_DECAL");
            case TextureEnvironment::kBlend: return comment("GL_BLEND");
            case TextureEnvironment::kAdd: return comment("GL_ADD");
        }
        return "";
    }

    // The texels of a Draw that combines textures. GL_COMBINE of one unit may read the texel of another, so all lookups
    // come first.
    std::string texture_lookups() const {
        std::string text;
        for (const UnitEffects& unit : effects_.units) {
            const TextureEffects& texture = unit.texture;
            Scope scope;
            scope.switches = texture_switches(texture);
            scope.switches.insert({{"EFFECT_RAY_TEX_COORD", false}});
            scope.words = texture_words(texture, false);
            Words names;
            for (const char* name :
                 {"texel", "depth", "tex_coord", "v_tex_coord", "per_x", "per_y", "texture_end", "u_texture",
                  "u_texture_lod_bias", "u_texture_inside", "sizes", "largest", "within_face"})
                names[name] = fmt::format("{}{}", name, unit.number);
            text += with_words(preprocessed("texture.glsl", scope), names);
        }
        return text;
    }
    std::string texture_environments() const {
        std::string text;
        for (const UnitEffects& unit : effects_.units) {
            const std::string texel = fmt::format("texel{}", unit.number),
                              constant = fmt::format("u_texture_env_color{}", unit.number);
            const std::string statements = unit.texture.environment == TextureEnvironment::kCombine
                                               ? combine_statement(unit, constant)
                                               : environment_statements(unit.texture, texel, constant);
            if (!statements.empty())
                text += fmt::format("    // Texture unit {} (section 3.8.13)\n{}", unit.number, statements);
        }
        return text;
    }

    // Section 3.8.13, tables 3.24 and 3.25.
    std::string combine_statement(const UnitEffects& unit, const std::string& constant) const {
        const Combine& combine = unit.combine;
        const auto source = [&](Enum name) -> std::string {
            switch (name) {
                case kGL_CONSTANT: return constant;
                case kGL_PRIMARY_COLOR: return "primary";
                case kGL_PREVIOUS: return "color";
                default: break;
            }
            const std::size_t number = name == kGL_TEXTURE ? unit.number : name - kGL_TEXTURE0;
            const bool has_texel =
                std::ranges::find(effects_.units, number, &UnitEffects::number) != effects_.units.end();
            return has_texel ? fmt::format("texel{}", number) : "vec4(0.0)";
        };
        const auto argument = [&](Enum name, Enum operand, bool is_rgb) {
            const bool of_alpha = operand == kGL_SRC_ALPHA || operand == kGL_ONE_MINUS_SRC_ALPHA;
            std::string text = source(name) + (of_alpha ? ".a" : ".rgb");
            if (of_alpha && is_rgb) text = fmt::format("vec3({})", text);
            const bool is_rest = operand == kGL_ONE_MINUS_SRC_COLOR || operand == kGL_ONE_MINUS_SRC_ALPHA;
            return is_rest ? fmt::format("(1.0 - {})", text) : text;
        };
        const auto value = [&](Enum function, const auto& sources, const auto& operands, bool is_rgb) -> std::string {
            const auto arg = [&](std::size_t i) { return argument(sources[i], operands[i], is_rgb); };
            switch (function) {
                case kGL_REPLACE: return arg(0);
                case kGL_ADD: return fmt::format("{} + {}", arg(0), arg(1));
                case kGL_ADD_SIGNED: return fmt::format("{} + {} - 0.5", arg(0), arg(1));
                case kGL_INTERPOLATE: return fmt::format("mix({1}, {0}, {2})", arg(0), arg(1), arg(2));
                case kGL_SUBTRACT: return fmt::format("{} - {}", arg(0), arg(1));
                case kGL_DOT3_RGB:
                case kGL_DOT3_RGBA: return fmt::format("4.0 * dot({} - 0.5, {} - 0.5)", arg(0), arg(1));
                default: return fmt::format("{} * {}", arg(0), arg(1));  // GL_MODULATE
            }
        };
        const auto scaled = [](int scale, const std::string& text) {
            return scale == 1 ? text : fmt::format("{}.0 * ({})", scale, text);
        };
        const bool is_dot = combine.rgb == kGL_DOT3_RGB || combine.rgb == kGL_DOT3_RGBA;
        const std::string rgb = value(combine.rgb, combine.rgb_sources, combine.rgb_operands, true);
        const std::string alpha =
            combine.gives_alpha() ? rgb : value(combine.alpha, combine.alpha_sources, combine.alpha_operands, false);
        const std::string scaled_rgb = scaled(combine.rgb_scale, rgb);
        return fmt::format("    color = clamp(vec4({}, {}), 0.0, 1.0);\n",
                           is_dot ? fmt::format("vec3({})", scaled_rgb) : scaled_rgb,
                           scaled(combine.alpha_scale, alpha));
    }

    std::string fog_factor() const {
        const std::string z = has_ray() ? eye_z("place") : "v_eye_z";
        // The distance from the plane z = 0 of eye coordinates, after division by w.
        std::string fog_distance = fmt::format("abs({})", z);
        if (effects_.vertex_w)
            fog_distance = has_ray() ? "abs(dot(u_eye_z_from_object, place) / dot(u_eye_w_from_object, place))"
                                     : "abs(v_eye_z.x / v_eye_z.y)";
        if (effects_.fog_coords) fog_distance = "v_fog_coord";
        switch (effects_.fog) {
            case FogEffect::kNone: break;
            case FogEffect::kLinear: return fmt::format("fog_linear({}, u_fog_end, u_fog_scale)", fog_distance);
            case FogEffect::kExp:
                // A distance is not negative, so only a fog coordinate needs the clamp to [0, 1].
                if (effects_.fog_coords) return fmt::format("min(fog_exp({}, u_fog_density), 1.0)", fog_distance);
                return fmt::format("fog_exp({}, u_fog_density)", fog_distance);
            case FogEffect::kExp2: return fmt::format("fog_exp2({}, u_fog_density)", fog_distance);
        }
        return "";
    }

    // Sections 3.4.2 and 3.5.2.
    std::string stipples() const {
        std::string text = line_text(form_);
        if (form_.polygon_stipple)
            text +=
                "    // glPolygonStipple (section 3.5.2): a bit for each pixel of 32 rows.\n"
                "    uvec2 pixel = uvec2(gl_FragCoord.xy) % 32u;\n"
                "    if ((u_polygon_stipple[pixel.y] >> pixel.x & 1u) == 0u) discard;\n";
        return text;
    }

    // Section 4.1.10.
    std::string logic_op() const {
        const auto result = [&]() -> const char* {
            switch (form_.logic_op) {
                case kGL_CLEAR: return "uvec4(0u)";
                case kGL_AND: return "source & stored";
                case kGL_AND_REVERSE: return "source & ~stored";
                case kGL_AND_INVERTED: return "~source & stored";
                case kGL_NOOP: return "stored";
                case kGL_XOR: return "source ^ stored";
                case kGL_OR: return "source | stored";
                case kGL_NOR: return "~(source | stored)";
                case kGL_EQUIV: return "~(source ^ stored)";
                case kGL_INVERT: return "~stored";
                case kGL_OR_REVERSE: return "source | ~stored";
                case kGL_COPY_INVERTED: return "~source";
                case kGL_OR_INVERTED: return "~source | stored";
                case kGL_NAND: return "~(source & stored)";
                case kGL_SET: return "~uvec4(0u)";
                default: return nullptr;  // GL_COPY
            }
        }();
        if (result == nullptr) return "";
        const std::string_view words = result;
        std::string text =
            "    // glLogicOp (section 4.1.10) combines the bits of the colour and of the picture before it.\n";
        if (words.find("source") != std::string_view::npos)
            text += "    uvec4 source = uvec4(floor(255.0 * clamp(color, 0.0, 1.0) + 0.5));\n";
        if (reads_stored_color(form_.logic_op))
            text +=
                "    uvec4 stored = uvec4(floor(255.0 * texelFetch(u_framebuffer, ivec2(gl_FragCoord.xy), 0) + "
                "0.5));\n";
        return text + fmt::format("    color = vec4(({}) & 255u) / 255.0;\n", result);
    }

    // Section 4.1.4.
    std::string alpha_test() const {
        const auto passes = [&]() -> const char* {
            switch (form_.alpha_func) {
                case kGL_LESS: return "<";
                case kGL_EQUAL: return "==";
                case kGL_LEQUAL: return "<=";
                case kGL_GREATER: return ">";
                case kGL_NOTEQUAL: return "!=";
                case kGL_GEQUAL: return ">=";
                default: return "";
            }
        }();
        if (form_.alpha_func == kGL_ALWAYS) return "";
        if (form_.alpha_func == kGL_NEVER) return "    discard;  // GL_NEVER (section 4.1.4)\n";
        return fmt::format("    if (!(color.a {} u_alpha_ref)) discard;  // the alpha test (section 4.1.4)\n", passes);
    }

    // Section 3.3.
    std::string point_size() const {
        return size_statement() +
               (form_.clips_points
                    ? "    // A point whose vertex is outside of the view volume goes whole (section 2.12).\n"
                      "    if (any(greaterThan(abs(gl_Position.xyz), vec3(gl_Position.w)))) gl_Position = vec4(2.0, "
                      "2.0, 2.0, 1.0);\n"
                    : "");
    }
    std::string size_statement() const {
        if (!form_.sizes_points && !effects_.attenuated_points) return "";
        if (form_.smooth)
            return fmt::format("    gl_PointSize = {} + 2.0;  // with the pixels that are covered in part\n",
                               size_of_smooth_point());
        if (form_.sizes_points) return "    gl_PointSize = u_point_size;  // glPointSize (section 3.3)\n";
        return fmt::format("    gl_PointSize = {};\n", attenuated_size());
    }
    std::string size_of_smooth_point() const { return effects_.attenuated_points ? "v_point_size" : "u_point_size"; }
    std::string attenuated_size() const {
        const std::string eye = "u_point_eye_from_object * position";
        const std::string place =
            effects_.vertex_w ? fmt::format("divided_by_w({})", eye) : fmt::format("({}).xyz", eye);
        return fmt::format("attenuated_size(length({}), u_point_attenuation, u_point_sizes)", place);
    }

    // ---- The files' switches and words ----

    std::map<std::string, bool, std::less<>> texture_switches(const TextureEffects& texture) const {
        return {{"EFFECT_TEXTURE_MATRIX", texture.matrix},
                {"EFFECT_TEXTURE_Q", texture.q},
                {"EFFECT_TEXTURE_CLAMP_S", texture.clamp_s},
                {"EFFECT_TEXTURE_CLAMP_T", texture.clamp_t},
                {"EFFECT_TEXTURE_CLAMP_R", texture.clamp_r},
                {"EFFECT_TEXTURE_CLAMP", texture.clamps()},
                {"EFFECT_TEXTURE_GRADIENTS", texture.gradients},
                // Browsers may keep depths as floats, and then do not clamp.
                {"EFFECT_TEXTURE_CLAMP_DEPTH", form_.dialect == Glsl::k300es && texture.compares},
                {"EFFECT_TEXTURE_DEPTHS", texture.depth_mode != 0},
                {"EFFECT_TEXTURE_LOD_BIAS", form_.lod_bias},
                {"EFFECT_TEXTURE_RIM", form_.texture_rims && !texture.cube},
                {"EFFECT_TEXTURE_FACES", form_.texture_rims && texture.cube}};
    }
    // OpenGL ES has no 1D textures. 2D textures of height 1 take their place.
    bool is_widened(const TextureEffects& texture) const {
        return texture.one_dimensional && form_.dialect == Glsl::k300es;
    }
    std::string sampler_of(const TextureEffects& texture) const {
        if (texture.cube) return "samplerCube";
        return std::string(is_widened(texture)         ? "sampler2D"
                           : texture.one_dimensional   ? "sampler1D"
                           : texture.three_dimensional ? "sampler3D"
                                                       : "sampler2D") +
               (texture.compares ? "Shadow" : "");
    }
    // of_ray: the coordinates are those of an exact surface's point.
    Words texture_words(const TextureEffects& texture, bool of_ray) const {
        // Samplers of shadows take s, t and r in one dimension too.
        const bool q = texture.q, compares = texture.compares;
        const bool one = texture.one_dimensional && !(compares && is_widened(texture));
        const bool three = texture.three_dimensional, has_r = texture.needs_r(), one_number = one && !has_r;
        const std::string place =
            form_.sprites_rise ? "vec2(gl_PointCoord.s, 1.0 - gl_PointCoord.t)" : "gl_PointCoord";  // section 3.3.1
        // For a widened texture t is constant. If it varied, it would change the scale factor, and so the mipmap level.
        const bool widens = one && is_widened(texture);
        const auto widened = [&](std::string_view s, std::string_view t) {
            return widens ? fmt::format("vec2({}, {})", s, t) : std::string(s);
        };
        const std::string sprite = has_r ? fmt::format("vec3({}, 0.0)", place) : one ? "gl_PointCoord.s" : place;
        const std::string divided = texture.sprite ? sprite
                                    : of_ray       ? (one ? "tex_place.s" : "tex_place.st")
                                    : has_r        ? (q ? "v_tex_coord.stp / v_tex_coord.q" : "v_tex_coord")
                                    : one          ? (q ? "v_tex_coord.s / v_tex_coord.t" : "v_tex_coord")
                                                   : (q ? "v_tex_coord.st / v_tex_coord.p" : "v_tex_coord");
        const std::string parts = one ? "s" : "st", inside = "u_texture_inside." + parts;
        const std::string bias = form_.lod_bias ? ", u_texture_lod_bias" : "";
        const auto gradients = [&](const std::string& x, const std::string& y) {
            return fmt::format("{}, {}, {}", widened("tex_coord", "0.5"), widened(x, "0.0"), widened(y, "0.0"));
        };
        return {{"TEX_COORD", texture.sprite ? sprite : "v_tex_coord"},
                {"SAMPLER", sampler_of(texture)},
                {"DIVIDED_TYPE", one_number ? "float"
                                 : has_r    ? "vec3"
                                            : "vec2"},
                {"DIVIDED_TEX_COORD", divided},
                {"GRADIENT_TYPE", one     ? "float"
                                  : three ? "vec3"
                                          : "vec2"},
                {"TEX_COORD_PLACE", !compares ? "tex_coord"
                                    : one     ? "tex_coord.s"
                                              : "tex_coord.st"},
                {"TEXTURE_INSIDE", has_r ? "u_texture_inside" : inside},
                {"INSIDE_PLACE", three ? "u_texture_inside" : inside},
                {"TEX_COORD_S", one_number ? "tex_coord" : "tex_coord.s"},
                {"TEXTURE_LOOKUP", q && !widens ? "textureProj" : "texture"},
                {"CLAMPED_ARGUMENTS", widened("tex_coord", "0.5") + bias},
                {"LOOKUP_ARGUMENTS", (widens           ? widened(divided, "0.5")
                                      : texture.sprite ? sprite
                                                       : "v_tex_coord") +
                                         bias},
                {"GRADIENT_ARGUMENTS", gradients("per_x", "per_y")},
                {"RAY_ARGUMENTS", gradients("tex_per_x." + parts, "tex_per_y." + parts)},
                {"LOOKED_UP", texture.depth_mode != 0 ? "float depth" : "vec4 texel"},
                {"LOOKED_UP_PART", texture.depth_mode != 0 && !compares ? ".r" : ""},
                {"DEPTH_TEXEL", texture.depth_mode == kGL_ALPHA       ? "vec4(vec3(0.0), depth)"
                                : texture.depth_mode == kGL_INTENSITY ? "vec4(depth)"
                                                                      : "vec4(vec3(depth), 1.0)"}};
    }

    Scope scope_of(Stage stage) const {
        const SurfaceForm& surface = form_.surface;
        const TextureEffects& texture = effects_.texture;
        const auto is = [&](SurfaceKind kind) { return surface.kind == kind; };
        const bool steps = surface.offset || surface.tex_coord;
        std::string clip_distances, within_clip_planes, clip_discards;
        std::vector<std::string> distances;
        for (int i = 0; i < effects_.clip_plane_count; ++i) {
            distances.push_back(clip_distance(i));
            clip_distances += fmt::format("    gl_ClipDistance[{}] = {};{}\n", i, clip_distance(i),
                                          i == 0 ? "  // clipped where negative (section 2.12)" : "");
            clip_discards += fmt::format("    if (v_clip_distance{} < 0.0) discard;{}\n", i,
                                         i == 0 ? "  // a clip plane (section 2.12)" : "");
            within_clip_planes += fmt::format("    is_seen = is_seen && dot({}, place) >= 0.0;\n", clip_plane_name(i));
        }
        Scope scope{
            .switches = {{"EFFECT_TEXTURE", effects_.has_texture()},
                         {"EFFECT_SEPARATE_SPECULAR", effects_.separate_specular || effects_.secondary_color},
                         {"EFFECT_FOG", effects_.has_fog()},
                         {"EFFECT_SRGB_CODED", effects_.srgb_coded},
                         {"EFFECT_ONE_STEP", has_one_step()},
                         {"EFFECT_POSITION_IS_ATTRIBUTE", position_is_attribute()},
                         {"EFFECT_TWO_SIDE", effects_.two_side},
                         {"EFFECT_FLAT_EDGES", form_.flat_edges},
                         {"EFFECT_RAY", has_ray()},
                         {"EFFECT_RAY_SPHERE", is(SurfaceKind::kSphere)},
                         {"EFFECT_RAY_FRUSTUM", is(SurfaceKind::kFrustum)},
                         {"EFFECT_RAY_DISK", is(SurfaceKind::kDisk)},
                         {"EFFECT_RAY_TORUS", is(SurfaceKind::kTorus)},
                         {"EFFECT_RAY_SECTOR", surface.sector},
                         {"EFFECT_RAY_TEX_COORD", surface.tex_coord},
                         {"EFFECT_RAY_NEAR_FAR", surface.near_far},
                         {"EFFECT_RAY_CULL", surface.culls},
                         {"EFFECT_RAY_DEPTH", surface.depth},
                         {"EFFECT_RAY_OFFSET", surface.offset},
                         {"EFFECT_RAY_NEAREST", surface.nearest},
                         {"EFFECT_RAY_STEPS", steps},
                         {"EFFECT_RAY_NORMAL", (effects_.needs_normal() && is_phong()) || effects_.two_side || steps}},
            .inserts = {{"clip_position", effects_.at_pixels ? "    gl_Position = vec4(a_pixel_ndc, 1.0);  // sections "
                                                               "3.6.4 and 3.7\n"
                                                             : lighting_.clip_position},
                        {"lit", lit(stage)},
                        {"generated", has_ray() ? "" : generated()},
                        {"outputs", outputs()},
                        {"point_size", point_size()},
                        {"clip_distances", has_ray() || discards_clipped() ? "" : clip_distances},
                        {"clip_discards", discards_clipped() ? clip_discards : ""},
                        {"corner", corner_text(form_, lighting_.clip_position, distances)},
                        {"stipples", stipples()},
                        {"coverage", coverage_text(form_, size_of_smooth_point())},
                        {"alpha_test", alpha_test()},
                        {"logic_op", logic_op()},
                        {"blend_source", form_.scales_source ? "    color.rgb = clamp(color.rgb, 0.0, 1.0) * "
                                                               "u_blend_source;  // glBlendColor (section 4.1.8)\n"
                                                             : ""},
                        {"within_clip_planes", within_clip_planes},
                        {"texture_environment", environment()},
                        {"texture_lookups", texture_lookups()}},
            .words = {{"POSITION", form_.position_w ? "a_position" : "vec4(a_position.xyz, 1.0)"},
                      {"FIRST_COLOR", first_color(stage)},
                      {"ENVIRONMENT", comment_of_environment()},
                      {"SECONDARY", effects_.two_side ? fmt::format("({})", lit_color(stage, "secondary"))
                                                      : lit_color(stage, "secondary")},
                      {"NEAR_VERTEX", form_.position_w ? "vec4" : "vec3"},
                      {"FOG_FACTOR", fog_factor()},
                      {"LIGHT_COUNT", form_.kept ? fmt::format("{}", form_.kept->light_count) : ""},
                      {"LIGHT_NAMES", light_names()}}};
        scope.switches.merge(texture_switches(texture));
        scope.words.merge(texture_words(texture, surface.tex_coord));
        return scope;
    }

    // In the comment of LightSource.
    const char* light_names() const {
        const int count = form_.kept ? form_.kept->light_count : 0;
        return count == 1 ? "GL_LIGHT0" : count == 2 ? "GL_LIGHT0, GL_LIGHT1" : "GL_LIGHT0, GL_LIGHT1, ...";
    }

    // "uniform vec4 u_fog_color;  // ...", with the comment above it.
    Definition definition(const Declaration& one, const std::string& suffix, const Words& words) const {
        std::string text;
        for (std::string_view rest = one.above; !rest.empty();) {
            const std::size_t end = std::min(rest.find('\n'), rest.size());
            text += fmt::format("// {}\n", rest.substr(0, end));
            rest.remove_prefix(std::min(end + 1, rest.size()));
        }
        text += fmt::format("uniform {} {}{}{};{}{}\n", with_words(one.type, words), one.name, suffix, one.array,
                            one.comment.empty() ? "" : "  // ", one.comment);
        std::string name = std::string(one.name) + suffix;
        if (!form_.kept) return {std::move(name), std::move(text), true};
        return {with_words(name, kept_names()), with_words(text, kept_names()), true};
    }

    // The uniforms that the program may use.
    std::vector<Definition> uniforms(const Words& words) const {
        std::vector<Definition> result;
        const auto add = [&](const UniformList& list, const std::string& suffix, const Words& words_of_list) {
            for_each_uniform([&](auto value) {
                if (list.contains(value)) result.push_back(definition(declaration_of(value), suffix, words_of_list));
            });
        };
        if (form_.kept)
            result = definitions("kept_uniforms.glsl", words);
        else
            add(uniform_list(effects_, form_), "", words);
        // There, Texture0 is the name of an only texture.
        if (form_.kept && !effects_.units.empty())
            std::erase_if(result, [](const Definition& one) { return one.name == "Texture0"; });
        for (const UnitEffects& unit : effects_.units)
            add(uniform_list(unit, form_), std::to_string(unit.number), texture_words(unit.texture, false));
        return result;
    }

    // Those, and the functions for each kind of exponent in the effects.
    std::vector<Definition> library(const Words& words) const {
        bool has_whole = effects_.shininess == Power::kWhole, has_real = effects_.shininess == Power::kReal;
        for (const LightEffects& light : effects_.lights)
            if (light.cone == SpotCone::kGl) (light.spot_exponent == Power::kReal ? has_real : has_whole) = true;
        std::vector<Definition> library = uniforms(words);
        std::set<std::string> names;
        std::vector<const char*> files = lighting_.libraries;
        files.push_back("rectangles.glsl");
        for (const char* file : files) {
            const std::vector<Definition> whole = definitions(file, {{"EXPONENT", "int"}, {"POWER", "whole_power"}});
            const std::vector<Definition> real = definitions(file, {{"EXPONENT", "float"}, {"POWER", "real_power"}});
            for (std::size_t i = 0; i < whole.size(); ++i) {
                if (!names.insert(whole[i].name).second) continue;
                const bool is_one = whole[i].text == real[i].text;
                if (is_one || has_whole) library.push_back(whole[i]);
                if (!is_one && has_real) library.push_back(real[i]);
            }
        }
        return library;
    }

    const EffectSet& effects_;
    const Form& form_;
    LightingNames names_;
    LightingText lighting_;
};

}  // namespace

ShaderSource assemble(const EffectSet& effects, const Form& form) {
    const Assembler assembler(effects, form);
    return {assembler.text(Stage::kVertex), assembler.text(Stage::kFragment)};
}

}  // namespace twinlight::programmable
