#include "render/programmable/export/kept_files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "render/programmable/export/c_text.h"
#include "render/programmable/export/core_elements.h"
#include "render/programmable/export/kept_code.h"
#include "render/programmable/export/kind_row.h"
#include "render/programmable/numbers/draw_values.h"
#include "render/programmable/numbers/light_values.h"
#include "render/programmable/numbers/vertex_attributes.h"
#include "render/programmable/text/kept_text.h"
#include "render/programmable/text/shader_assembly.h"
#include "scene/command/names.h"

namespace twinlight::programmable {
namespace {

class Writer {
  public:
    Writer(const Frame& frame, const Options& options, Glsl version)
        : frame_(frame), options_(options), version_(version) {
        options_.for_any_pose = true;
    }

    std::vector<NamedFile> files(const std::string& name) {
        write_items();
        // draw_scene() is called again and again, so it starts with the state of its end: what some draw changes is written for all.
        body_.clear();
        last_.clear();
        eye_from_object_.reset();
        rows_ = std::exchange(kinds_, {});
        middle_ = glm::dvec3(0);
        middle_count_ = 0;
        write_items();
        std::vector<NamedFile> files = shaders();
        files.push_back({"kinds.c", kinds_text(name)});
        for (const char* file : {"gl_state.h", "gl_state.c", "names.sed"})
            files.push_back({file, std::string(file_text(file))});
        files.push_back({"scene.c", scene_text(name)});
        files.push_back({"scene.bin", std::string(data())});
        for (const char* file : {"scene.h", "window.c"}) files.push_back({file, std::string(file_text(file))});
        files.push_back({"README.md", readme(name)});
        return files;
    }

  private:
    std::vector<NamedFile> shaders() const {
        std::vector<NamedFile> files;
        for (std::size_t i = 0; i < kinds_.size(); ++i) {
            const ShaderSource source = assemble(kinds_[i].code.effects, kinds_[i].code.form);
            files.push_back({fmt::format("kind{}.vert", i + 1), source.vertex});
            files.push_back({fmt::format("kind{}.frag", i + 1), source.fragment});
        }
        return files;
    }

    // ---- scene.bin ----

    std::string_view data() const {
        return {reinterpret_cast<const char*>(words_.data()), 4 * words_.size()};  // NOLINT
    }

    // Appends 4-byte words, unless they were appended before; returns their place.
    std::size_t place_of(std::vector<std::uint32_t> words) {
        const auto [at, is_new] = places_.try_emplace(std::move(words), words_.size());
        if (is_new) words_.insert(words_.end(), at->first.begin(), at->first.end());
        return at->second;
    }
    static std::vector<std::uint32_t> words_of(const std::vector<float>& values) {
        std::vector<std::uint32_t> words(values.size());
        if (!values.empty()) std::memcpy(words.data(), values.data(), 4 * values.size());
        return words;
    }
    // 8-bit colours, or depths as whole numbers of 32 bits.
    static std::vector<std::uint32_t> texels_of(const TextureImage& image) {
        const bool are_depths = image.base_format == kGL_DEPTH_COMPONENT;
        std::vector<std::uint32_t> words;
        for (const glm::vec4& texel : image.texels)
            words.push_back(are_depths ? static_cast<std::uint32_t>(std::llround(texel.r * 4294967295.0))
                                       : texel_word(texel));
        return words;
    }

    // ---- draw_scene() ----

    // Writes a statement, unless the last one under this key was the same.
    void set(const std::string& key, const std::string& statement) {
        if (std::exchange(last_[key], statement) != statement) body_ += "    " + statement + "\n";
    }
    void enable(Enum capability, bool enabled) {
        const std::string name = enum_name(capability);
        set(name, fmt::format("{}({});", enabled ? "glEnable" : "glDisable", name));
    }
    // Scenes that never enable these do not mention them.
    void enable_changed(Enum capability, bool enabled) {
        const std::string name = enum_name(capability);
        set_changed(name, !enabled, fmt::format("{}({});", enabled ? "glEnable" : "glDisable", name));
    }
    // A capability that core GL lacks.
    void enable_kept(Enum capability, bool enabled) {
        const std::string name = enum_name(capability);
        set_changed(name, !enabled, fmt::format("{}({});", enabled ? "ffEnable" : "ffDisable", name));
    }
    // The same for a value that is other than GL's initial one in some draw: the first pass finds these.
    void set_changed(const std::string& key, bool is_initial, const std::string& statement) {
        if (!is_initial) changed_.insert(key);
        if (changed_.contains(key)) set(key, statement);
    }

    void write_items() {
        write_clear({.color = true, .depth = true, .clear_color = glm::dvec4(0), .clear_depth = 1});
        for (const auto& item : frame_.items) {
            const Draw* draw = std::get_if<Draw>(&item);
            if (const Clear* clear = std::get_if<Clear>(&item))
                write_clear(*clear);
            else if (draw && draw->pixels && draw->pixels->has_stencils)
                for (const Draw& one : by_stencil_value(*draw)) write_draw(one);
            else if (draw && draw->count() > 0)
                write_draw(*draw);
        }
    }

    void write_scissor(const Scissor& scissor, const std::array<bool, 4>& mask) {
        enable(kGL_SCISSOR_TEST, scissor.enabled);
        const Rectangle& box = scissor.box;
        if (scissor.enabled)
            set("scissor", fmt::format("glScissor({}, {}, {}, {});", box.x, box.y, box.width, box.height));
        set("color mask", fmt::format("glColorMask({:d}, {:d}, {:d}, {:d});", mask[0], mask[1], mask[2], mask[3]));
    }

    void write_clear(const Clear& clear) {
        if (!clear.color && !clear.depth && !clear.stencil) return;
        write_scissor(clear.scissor, clear.color_mask);
        set("depth mask", "glDepthMask(1);");
        set("clear color", fmt::format("glClearColor({});", c_numbers(clear.clear_color)));
        set("clear depth", fmt::format("glClearDepth({});", clear.clear_depth));
        if (clear.stencil) {
            set("clear stencil", fmt::format("glClearStencil({});", clear.clear_stencil));
            set("GL_FRONT stencil mask", fmt::format("glStencilMaskSeparate(GL_FRONT, {:#x});", clear.stencil_mask));
        }
        std::vector<const char*> buffers;
        if (clear.color) buffers.push_back("GL_COLOR_BUFFER_BIT");
        if (clear.depth) buffers.push_back("GL_DEPTH_BUFFER_BIT");
        if (clear.stencil) buffers.push_back("GL_STENCIL_BUFFER_BIT");
        body_ += fmt::format("    glClear({});\n", fmt::join(buffers, " | "));
    }

    // A kind of state, and its row in kinds.c.
    struct Kind {
        Code code;
        std::string row;
        std::string place;
    };

    // Whether other shaders have the same row: for textures of other formats, which GL's state does not show.
    bool is_one_of_several(const std::string& row, const Code& code) const {
        return std::ranges::any_of(rows_, [&](const Kind& one) {
            return one.row == row && !(one.code.effects == code.effects && one.code.form == code.form);
        });
    }

    void write_draw(const Draw& draw) {
        const Plan plan = plan_effects(draw, options_);
        const Code code = kept_code(draw, plan, version_);
        std::string row = kind_row(draw, plan, code, options_, target_of(draw.texture), false);
        const bool by_number = is_not_gl(plan) || is_one_of_several(row, code);
        if (by_number) row = kind_row(draw, plan, code, options_, target_of(draw.texture), true);
        const auto found = std::ranges::find_if(kinds_, [&](const Kind& one) {
            return one.code.effects == code.effects && one.code.form == code.form && one.row == row;
        });
        kind_ = static_cast<int>(found - kinds_.begin()) + 1;
        if (found == kinds_.end()) kinds_.push_back({code, row, printable(draw.place.str())});

        body_ += fmt::format("\n    // {}\n", printable(draw.place.str()));
        write_raster(draw);
        write_fragment(draw.fragment);
        set_changed("kind", !by_number, fmt::format("ffUseKind({});", by_number ? kind_ : 0));
        write_state(draw, plan, code);

        const auto [mode, indices] = core_elements(draw, code.effects.shading == Shading::kFlat);
        const std::size_t vertex = place_of(words_of(vertex_array(draw, code.effects, {}, glm::dvec3(0))));
        const std::size_t index = place_of(indices);
        body_ += fmt::format("    draw({}, {}, {}, {}, {});\n", primitive_name(mode), layout_of(plan, code.effects),
                             vertex, index, indices.size());
        if (plan.vertices.has_sphere) {
            middle_ += glm::dvec3(draw.eye_from_object * glm::dvec4(plan.vertices.center_object, 1));
            ++middle_count_;
        }
    }

    // The name of an array in scene.c that says where the attributes lie in a vertex.
    std::string layout_of(const Plan& plan, const EffectSet& effects) {
        std::string text;
        for (const Attribute& attribute : attributes(effects)) {
            int floats = attribute.size;
            if (attribute.name == "a_normal" || (attribute.name == "a_position" && plan.vertices.w_is_1) ||
                (attribute.name == "a_tex_coord" && plan.vertices.q_is_1))
                floats = 3;
            text +=
                fmt::format("{{\"{}\", {}, {}}}, ", with_words(attribute.name, kept_names()), floats, attribute.size);
        }
        auto found = std::ranges::find(layouts_, text);
        if (found == layouts_.end()) found = layouts_.insert(found, text);
        return fmt::format("layout{}", found - layouts_.begin() + 1);
    }

    void write_raster(const Draw& draw) {
        const RasterState& raster = draw.raster;
        const Rectangle& v = raster.viewport;
        set("viewport", fmt::format("glViewport({}, {}, {}, {});", v.x, v.y, v.width, v.height));
        set("depth range", fmt::format("glDepthRange({}, {});", raster.depth_near, raster.depth_far));
        set("front face", fmt::format("glFrontFace({});", enum_name(raster.front_face)));
        enable(kGL_CULL_FACE, raster.cull_enabled);
        if (raster.cull_enabled) set("cull face", fmt::format("glCullFace({});", enum_name(raster.cull_face)));
        const PolygonOffset& offset = raster.polygon_offset;
        enable(kGL_POLYGON_OFFSET_FILL, offset.fill);
        set("offset", fmt::format("glPolygonOffset({}, {});", c_number(offset.factor), c_number(offset.units)));
        if (draw.draws_lines()) set("line width", fmt::format("glLineWidth({});", c_number(raster.line_width)));
        // Core GL has one mode for both faces: that of the face that is not culled.
        const bool hides_front = raster.cull_enabled && raster.cull_face == kGL_FRONT;
        set("polygon mode", fmt::format("glPolygonMode(GL_FRONT_AND_BACK, {});",
                                        enum_name(hides_front ? raster.polygon_mode_back : raster.polygon_mode_front)));
        enable(kGL_POLYGON_OFFSET_POINT, raster.polygon_offset.point);
        enable(kGL_POLYGON_OFFSET_LINE, raster.polygon_offset.line);
        enable_changed(kGL_LINE_SMOOTH, raster.line_smooth);
        enable_changed(kGL_COLOR_LOGIC_OP, draw.fragment.logic_op.has_value());
        if (draw.fragment.logic_op) set("logic op", fmt::format("glLogicOp({});", enum_name(*draw.fragment.logic_op)));
        if (draw.draws_points()) set("point size", fmt::format("ffPointSize({});", c_number(point_size(draw))));
        enable(kGL_DEPTH_TEST, raster.depth_test);
        set("depth func", fmt::format("glDepthFunc({});", enum_name(raster.depth_func)));
        set("depth mask", fmt::format("glDepthMask({:d});", raster.depth_mask));
    }

    void write_fragment(const FragmentState& fragment) {
        write_scissor(fragment.scissor, fragment.color_mask);
        write_stencil(fragment.stencil);
        enable(kGL_BLEND, fragment.blend);
        if (!fragment.blend) return;
        set("blend func",
            fmt::format("glBlendFuncSeparate({}, {}, {}, {});", factor(fragment.blend_src), factor(fragment.blend_dst),
                        factor(fragment.blend_src_alpha), factor(fragment.blend_dst_alpha)));
        set("blend equation", fmt::format("glBlendEquationSeparate({}, {});", enum_name(fragment.blend_equation),
                                          enum_name(fragment.blend_equation_alpha)));
        set("blend color", fmt::format("glBlendColor({});", c_numbers(fragment.blend_color)));
    }
    void write_stencil(const std::optional<StencilTest>& stencil) {
        enable_changed(kGL_STENCIL_TEST, stencil.has_value());
        if (!stencil) return;
        for (const auto& [name, face] : {std::pair("GL_FRONT", &stencil->front), {"GL_BACK", &stencil->back}}) {
            set(fmt::format("{} stencil func", name),
                fmt::format("glStencilFuncSeparate({}, {}, {}, {:#x});", name, enum_name(face->func),
                            std::clamp(face->ref, 0, kMaxStencil), face->mask));
            set(fmt::format("{} stencil op", name),
                fmt::format("glStencilOpSeparate({}, {}, {}, {});", name, factor(face->fail), factor(face->depth_fail),
                            factor(face->depth_pass)));
            set(fmt::format("{} stencil mask", name),
                fmt::format("glStencilMaskSeparate({}, {:#x});", name, face->write_mask));
        }
    }
    static std::string factor(Enum value) {
        return value == kGL_ZERO ? "GL_ZERO" : value == kGL_ONE ? "GL_ONE" : enum_name(value);
    }

    // ---- State that core GL lacks ----

    static Enum gen_of(int coordinate) { return kGL_TEXTURE_GEN_S + static_cast<Enum>(coordinate); }
    static bool is_clipped(const Draw& draw, int plane) {
        return draw.raster.clip_planes_eye[static_cast<std::size_t>(plane)].has_value();
    }

    void write_state(const Draw& draw, const Plan& plan, const Code& code) {
        const EffectSet& effects = code.effects;
        enable_kept(kGL_LIGHTING, effects.lighting);
        if (effects.lighting) write_lighting(plan, effects);
        if (effects.takes_normal()) {
            enable_kept(kGL_NORMALIZE, draw.lighting.normalize);
            enable_kept(kGL_RESCALE_NORMAL, draw.lighting.rescale_normal);
        }
        // What the loader sees of flat shading; a point has one vertex.
        const bool flat = effects.shading == Shading::kFlat;
        if (draw.mode != kGL_POINTS)
            set_changed("shade model", !flat, fmt::format("ffShadeModel({});", flat ? "GL_FLAT" : "GL_SMOOTH"));
        enable_kept(kGL_ALPHA_TEST, draw.fragment.alpha_test);
        if (draw.fragment.alpha_test)
            set("alpha", fmt::format("ffAlphaFunc({}, {});", enum_name(draw.fragment.alpha_func),
                                     c_number(draw.fragment.alpha_ref)));
        enable_kept(kGL_FOG, effects.has_fog());
        if (effects.has_fog()) write_fog(draw.fog);
        write_texture(draw.texture, effects);
        for (int i = 0; i < kMaxClipPlanes; ++i)
            enable_kept(kGL_CLIP_PLANE0 + static_cast<Enum>(i), is_clipped(draw, i));
        write_matrices(draw, plan, code);
    }

    void write_fog(const Fog& fog) {
        set("fog mode", fmt::format("ffFogi(GL_FOG_MODE, {});", enum_name(fog.mode)));
        set("fog color", fmt::format("ffFogfv(GL_FOG_COLOR, {});", c_floats(fog.color)));
        if (fog.mode == kGL_LINEAR) {
            set("fog start", fmt::format("ffFogf(GL_FOG_START, {});", c_number(fog.start)));
            set("fog end", fmt::format("ffFogf(GL_FOG_END, {});", c_number(fog.end)));
        } else {
            set("fog density", fmt::format("ffFogf(GL_FOG_DENSITY, {});", c_number(fog.density)));
        }
    }

    void write_lighting(const Plan& plan, const EffectSet& effects) {
        const LightingState& state = plan.lighting;
        const LightModel& model = state.light_model;
        const bool tracks = effects.needs_color();
        const auto write_model = [this](const char* parameter, bool is_initial, const std::string& value) {
            set_changed(parameter, is_initial, fmt::format("ffLightModeli({}, {});", parameter, value));
        };
        set("ambient",
            fmt::format("ffLightModelfv(GL_LIGHT_MODEL_AMBIENT, {});", c_floats(glm::dvec4(plan.constant_ambient, 1))));
        write_model("GL_LIGHT_MODEL_TWO_SIDE", !model.two_side, fmt::format("{:d}", model.two_side));
        write_model("GL_LIGHT_MODEL_LOCAL_VIEWER", !model.local_viewer, fmt::format("{:d}", model.local_viewer));
        write_model("GL_LIGHT_MODEL_COLOR_CONTROL", model.color_control == kGL_SINGLE_COLOR,
                    enum_name(model.color_control));
        if (tracks)
            set("color material", fmt::format("ffColorMaterial({}, {});", enum_name(state.color_material.face),
                                              enum_name(state.color_material.mode)));
        enable_kept(kGL_COLOR_MATERIAL, tracks);
        write_material("GL_FRONT", state.front);
        if (effects.two_side) write_material("GL_BACK", state.back);
        // glColor changes these.
        if (tracks) std::erase_if(last_, [](const auto& one) { return one.first.starts_with("material "); });
    }
    void write_material(const std::string& face, const Material& material) {
        const auto write = [&](const char* property, const glm::dvec4& value) {
            set("material " + face + property,
                fmt::format("ffMaterialfv({}, {}, {});", face, property, c_floats(value)));
        };
        write("GL_EMISSION", material.emission);
        write("GL_AMBIENT", material.ambient);
        write("GL_DIFFUSE", material.diffuse);
        write("GL_SPECULAR", material.specular);
        set("material " + face, fmt::format("ffMaterialf({}, GL_SHININESS, {});", face, c_number(material.shininess)));
    }

    // The modelview matrix, after what it transforms from eye coordinates: lights and planes.
    void write_matrices(const Draw& draw, const Plan& plan, const Code& code) {
        write_matrix("GL_PROJECTION", draw.clip_from_eye);
        if (draw.texture.texture) write_matrix("GL_TEXTURE", draw.texture.texture_matrix);
        const std::string before = std::exchange(body_, "");
        if (code.effects.lighting)
            for (int i = 0; i < kMostKeptLights; ++i) write_light(plan, i, *code.form.kept);
        for (const int number : code.form.kept->clip_planes)
            set(fmt::format("plane {}", number),
                fmt::format("ffClipPlane(GL_CLIP_PLANE{}, (double[]){{{}}});", number,
                            c_numbers(*draw.raster.clip_planes_eye[static_cast<std::size_t>(number)])));
        for (const GeneratedCoordinate& one : draw.texture.generated)
            if (one.mode == kGL_EYE_LINEAR) write_plane(one, "GL_EYE_PLANE");
        const std::string in_eye = std::exchange(body_, before);
        if (in_eye.empty() && eye_from_object_ == draw.eye_from_object) return;
        eye_from_object_ = draw.eye_from_object;
        body_ += fmt::format("    camera();\n{}    ffMultMatrixf({});\n", in_eye, c_floats(draw.eye_from_object));
    }
    // The current matrix is GL_MODELVIEW before and after.
    void write_matrix(const std::string& mode, const glm::dmat4& matrix) {
        set_changed(mode, matrix == glm::dmat4(1),
                    fmt::format("ffMatrixMode({});\n    ffLoadMatrixf({});\n    ffMatrixMode(GL_MODELVIEW);", mode,
                                c_floats(matrix)));
    }

    void write_light(const Plan& plan, int number, const KeptForm& kept) {
        const std::string name = number < 8 ? fmt::format("GL_LIGHT{}", number) : fmt::format("GL_LIGHT0 + {}", number);
        const bool is_on = std::ranges::find(kept.lights, number) != kept.lights.end();
        set_changed(name, !is_on, fmt::format("switch_light({}, {:d});", name, is_on));
        if (!is_on) return;
        const LightSource& light = plan.lighting.lights[static_cast<std::size_t>(number)];
        const auto write = [&](const char* parameter, const glm::dvec4& value) {
            set(name + parameter, fmt::format("ffLightfv({}, {}, {});", name, parameter, c_floats(value)));
        };
        const auto write_one = [&](const char* parameter, double value, double initial) {
            set_changed(name + parameter, value == initial,
                        fmt::format("ffLightf({}, {}, {});", name, parameter, c_number(value)));
        };
        write("GL_AMBIENT", light.ambient);
        write("GL_DIFFUSE", light.diffuse);
        write("GL_SPECULAR", light.specular);
        set(name + " position", fmt::format("place_light({}, {});", name, c_numbers(light.position_eye)));
        if (light.is_spot())
            set(name + " direction", fmt::format("ffLightfv({}, GL_SPOT_DIRECTION, (float[]){{{}}});", name,
                                                 c_numbers(light.spot_direction_eye)));
        write_one("GL_SPOT_CUTOFF", light.spot_cutoff_deg, 180);
        write_one("GL_SPOT_EXPONENT", light.spot_exponent, 0);
        write_one("GL_CONSTANT_ATTENUATION", light.constant_attenuation, 1);
        write_one("GL_LINEAR_ATTENUATION", light.linear_attenuation, 0);
        write_one("GL_QUADRATIC_ATTENUATION", light.quadratic_attenuation, 0);
        if (!light.smooth_cone) return;
        const SmoothConeValues cone = smooth_cone_values(light);
        for (const auto& [what, value] :
             {std::pair(LightValue::kCosOuter, cone.cos_outer), {LightValue::kConeSlope, cone.slope}}) {
            const std::string uniform = kept_cone_name(number, what);
            set(fmt::format("kind {} {}", kind_, uniform),
                fmt::format("set_uniform({}, \"{}\", {});", kind_, uniform, c_number(value)));
        }
    }

    void write_texture(const TextureUnit& unit, const EffectSet& effects) {
        for (const Enum target : {kGL_TEXTURE_1D, kGL_TEXTURE_2D, kGL_TEXTURE_3D})
            enable_kept(target, target_of(unit) == target);
        if (!unit.texture) return;
        auto found = std::ranges::find(textures_, unit.texture);
        if (found == textures_.end()) found = textures_.insert(found, unit.texture);
        set("texture", fmt::format("use_texture({}, {}, {});", enum_name(target_of(*unit.texture)),
                                   found - textures_.begin() + 1, c_number(unit.lod_bias)));
        set_changed("environment", unit.env_mode == kGL_MODULATE,
                    fmt::format("ffTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, {});", enum_name(unit.env_mode)));
        if (effects.texture.environment == TextureEnvironment::kBlend)
            set("environment color",
                fmt::format("ffTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, {});", c_floats(unit.env_color)));
        for (int i = 0; i < 4; ++i)
            enable_kept(gen_of(i),
                        std::ranges::find(unit.generated, i, &GeneratedCoordinate::coordinate) != unit.generated.end());
        for (const GeneratedCoordinate& one : unit.generated) {
            const std::string name = coordinate_name(one);
            set(name, fmt::format("ffTexGeni({}, GL_TEXTURE_GEN_MODE, {});", name, enum_name(one.mode)));
            if (one.mode == kGL_OBJECT_LINEAR) write_plane(one, "GL_OBJECT_PLANE");
        }
    }
    static std::string coordinate_name(const GeneratedCoordinate& one) {
        return fmt::format("GL_{}", "STRQ"[one.coordinate]);
    }
    void write_plane(const GeneratedCoordinate& one, const char* parameter) {
        const std::string name = coordinate_name(one);
        set(name + parameter, fmt::format("ffTexGenfv({}, {}, {});", name, parameter, c_floats(one.plane)));
    }

    Enum target_of(const TextureUnit& unit) const { return unit.texture ? target_of(*unit.texture) : 0; }
    Enum target_of(const Texture& texture) const {
        return version_ == Glsl::k300es && texture.is_flat() ? Enum{kGL_TEXTURE_2D} : texture.target;
    }

    // ---- The files ----

    glm::dvec3 middle() const { return middle_count_ == 0 ? glm::dvec3(0) : middle_ / middle_count_; }

    // The statements of load_scene().
    std::string load_text() {
        std::string load;
        for (std::size_t i = 0; i < textures_.size(); ++i) load += texture_text(i + 1, *textures_[i]);
        return load;
    }

    std::string kinds_text(const std::string& name) const {
        std::string rows;
        for (std::size_t i = 0; i < kinds_.size(); ++i)
            rows += fmt::format("    // kind{}.vert, kind{}.frag\n    {{\"{}\",\n     {}}},\n", i + 1, i + 1,
                                with_escapes(kinds_[i].place), kinds_[i].row);
        if (rows.empty()) rows = "    {\"\", 0, 0, {0}, 0, GL_ALWAYS, 0, 0, 0, {0, 0, 0, 0}, {NULL}},\n";
        return fmt::format(
            "// {}: which state each pair of shaders can draw. gl_state.h explains the members.\n"
            "#include \"gl_state.h\"\n\n#include <stddef.h>\n\n"
            "const struct ff_kind ff_kinds[] = {{\n{}}};\nconst int ff_kind_count = {};\n",
            printable(name), rows, kinds_.size());
    }

    std::string scene_text(const std::string& name) {
        const std::string load = load_text();
        const char* const gl = version_ == Glsl::k130 ? "3, 0" : version_ == Glsl::k330 ? "3, 3" : "4, 3";
        std::string layouts;
        for (std::size_t i = 0; i < layouts_.size(); ++i)
            layouts +=
                fmt::format("static const struct attribute layout{}[] = {{{}{{NULL, 0, 0}}}};\n", i + 1, layouts_[i]);
        return fmt::format(
            "// {}: its state and its draws, as calls of gl_state.c and GL. Vertices, indices and texels are in "
            "scene.bin.\n"
            "#include \"gl_state.h\"\n#include \"scene.h\"\n\n#include <stddef.h>\n\n"
            "const int scene_width = {}, scene_height = {};\n"
            "const int scene_gl_version[2] = {{{}}}, scene_has_core_profile = {:d};\n"
            "const int scene_texture_count = {};\n"
            "const float scene_middle[3] = {{{}}};\n\n"
            "{}\n"
            "void load_scene(void) {{\n{}}}\n\n"
            "void draw_scene(void) {{\n{}}}\n",
            printable(name), frame_.width, frame_.height, gl, version_ != Glsl::k130, textures_.size(),
            c_numbers(middle()), layouts, load, body_);
    }
    static std::string with_escapes(std::string text) {
        for (std::size_t at = 0; (at = text.find('"', at)) != text.npos; at += 2) text.insert(at, 1, '\\');
        return text;
    }

    std::string texture_text(std::size_t number, const Texture& texture) {
        // If the shader clamps, a linear filter must see half of the border.
        const Enum clamped = texture.filters_linearly() ? kGL_CLAMP_TO_BORDER : kGL_CLAMP_TO_EDGE;
        const auto wrap = [&](Enum mode) { return enum_name(mode == kGL_CLAMP ? clamped : mode); };
        std::string levels;
        std::size_t count = 0;
        constexpr std::size_t kMostLevels = 16;
        for (const TextureImage& level : texture.levels) {
            if (level.texels.empty() || count == kMostLevels) break;
            levels += fmt::format("{}{{{}, {}, {}, {}}}", count++ == 0 ? "" : ", ", level.width, level.height,
                                  level.depth, place_of(texels_of(level)));
        }
        std::string load = fmt::format(
            "    load_texture({}, (struct texture){{\n        .target = {}, .min_filter = {}, .mag_filter = {}, "
            ".wrap_s = "
            "{}, .wrap_t = {}, .wrap_r = {},\n        .border_color = {{{}}}, .level_count = {}, .levels = {{{}}}",
            number, enum_name(target_of(texture)), enum_name(texture.min_filter), enum_name(texture.mag_filter),
            wrap(texture.wrap_s), wrap(texture.wrap_t), wrap(texture.wrap_r), c_numbers(texture.border_texel()), count,
            levels);
        if (texture.has_depths()) load += ",\n        .has_depths = 1";
        if (texture.compares()) load += fmt::format(", .compare_func = {}", enum_name(texture.compare_func));
        load += "});\n";
        const auto limit = [&](const char* parameter, double lod, double initial) {
            if (lod != initial)
                load += fmt::format("    glTexParameterf({}, {}, {});\n", enum_name(target_of(texture)), parameter,
                                    c_number(lod));
        };
        limit("GL_TEXTURE_MIN_LOD", texture.min_lod, Texture().min_lod);
        limit("GL_TEXTURE_MAX_LOD", texture.max_lod, Texture().max_lod);
        return load;
    }

    std::string readme(const std::string& name) const {
        return fmt::format(
            "# Shaders of {}\n\n"
            "    cc -std=c99 *.c -o scene -lglut -lGL -lm && ./scene     # drag to turn, 1 to 8 switch lights\n\n"
            "- `kindN.vert`, `kindN.frag`: GLSL {}, a pair for each kind of material and set of lights. They stay "
            "right "
            "when objects, lights and the camera move.\n"
            "- Uniforms and attributes are GL's state with the names of GLSL 1.20's `gl_` variables, without that "
            "prefix: `LightSource[0].position` is in eye coordinates, as glLight stored it.\n"
            "- `gl_state.h`, `gl_state.c`, `kinds.c`: for your program, with the shaders: glLight, glMaterial, the "
            "matrix "
            "stack and draws, with `ff` in place of `gl`. A line on stderr says when no shaders fit the state; then "
            "export it again.\n"
            "- `scene.c`, `scene.bin`, `scene.h`, `window.c`: this picture drawn with them, in a window.\n"
            "- What core GL lacks: edge flags, polygon modes that differ between faces, and wireframes of "
            "quadrilaterals without their diagonal.\n",
            printable(name), kept_version_name(version_));
    }
    static const char* kept_version_name(Glsl version) {
        return version == Glsl::k130 ? "1.30" : version == Glsl::k330 ? "3.30 core" : "ES 3.00";
    }

    const Frame& frame_;
    Options options_;
    const Glsl version_;
    std::vector<Kind> kinds_, rows_;  // rows_: the kinds of the first pass
    std::vector<std::string> layouts_;
    std::set<std::string> changed_;  // keys of set_changed()
    std::vector<std::shared_ptr<const Texture>> textures_;
    std::vector<std::uint32_t> words_;                          // scene.bin
    std::map<std::vector<std::uint32_t>, std::size_t> places_;  // of what is in words_
    std::map<std::string, std::string> last_;
    std::string body_;                           // of draw_scene()
    int kind_ = 0;                               // of the Draw being written
    std::optional<glm::dmat4> eye_from_object_;  // of the last draw
    glm::dvec3 middle_{0};
    double middle_count_ = 0;
};

}  // namespace

std::string why_not_in_files(const Frame& frame) {
    if (std::string why = why_not_kept(frame); !why.empty()) return why;
    if (frame.copies_pixels) return "it copies pixels of its picture (glCopyPixels)";
    if (accumulates(frame)) return "it uses the accumulation buffer (glAccum), which core GL lacks";
    for (const Draw* draw : frame.draws()) {
        if (!draw->further_units.empty()) return "it uses more than one texture unit (glActiveTexture)";
        if (draw->combines_textures()) return "it combines textures with GL_COMBINE (glTexEnv)";
        if (draw->raster.point_parameters.depends_on_distance())
            return "its points become smaller with the distance (glPointParameter)";
        if (draw->texture.texture && draw->texture.texture->is_cube()) return "it uses a cube map";
        if (draw->column(VertexAttribute::kSecondaryColor))
            return "it adds secondary colours without lighting (glSecondaryColor)";
        if (draw->column(VertexAttribute::kFogCoord)) return "it uses fog coordinates (glFogCoord)";
        if (draw->raster.line_stipple) return "it uses a line stipple, which core GL lacks";
        if (draw->raster.polygon_stipple) return "it uses a polygon stipple, which core GL lacks";
        if (draw->raster.point_sprite) return "it uses point sprites (GL_POINT_SPRITE)";
        if (draw->raster.point_smooth) return "it uses smooth points, which core GL lacks";
    }
    return "";
}

std::vector<NamedFile> kept_files(const Frame& frame, const Options& options, Glsl version, const std::string& name) {
    if (const std::string why = why_not_in_files(frame); !why.empty()) throw std::runtime_error(why);
    return Writer(frame, options, version).files(name);
}

}  // namespace twinlight::programmable
