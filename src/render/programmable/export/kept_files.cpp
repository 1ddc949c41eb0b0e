#include "render/programmable/export/kept_files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "render/programmable/export/c_text.h"
#include "render/programmable/export/core_elements.h"
#include "render/programmable/export/kept_code.h"
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
        std::vector<NamedFile> files = shaders();
        files.push_back({"scene.c", scene_text(name)});
        files.push_back({"scene.bin", std::string(data())});
        for (const char* file : {"loader.h", "loader.c"}) files.push_back({file, std::string(file_text(file))});
        files.push_back({"README.md", readme(name)});
        return files;
    }

  private:
    std::vector<NamedFile> shaders() const {
        std::vector<NamedFile> files;
        for (std::size_t i = 0; i < kinds_.size(); ++i) {
            const ShaderSource source = assemble(kinds_[i].effects, kinds_[i].form);
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
    // A uniform of the kind in use.
    void uniform(const std::string& key, const std::string& statement) {
        set(fmt::format("kind {} {}", kind_, key), statement);
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

    void write_draw(const Draw& draw) {
        const Plan plan = plan_effects(draw, options_);
        const Code kind = kept_code(draw, plan, version_);
        const auto found = std::ranges::find_if(
            kinds_, [&](const Code& one) { return one.effects == kind.effects && one.form == kind.form; });
        kind_ = static_cast<int>(found - kinds_.begin()) + 1;
        if (found == kinds_.end()) kinds_.push_back(kind);

        body_ += fmt::format("\n    // {}\n", printable(draw.place.str()));
        write_raster(draw);
        write_fragment(draw.fragment);
        set("kind", fmt::format("use_kind({});", kind_));
        write_uniforms(draw, plan, kind);

        const auto [mode, indices] = core_elements(draw, kind.effects.shading == Shading::kFlat);
        const std::size_t vertex = place_of(words_of(vertex_array(draw, kind.effects, {}, glm::dvec3(0))));
        const std::size_t index = place_of(indices);
        body_ += fmt::format("    draw({}, {}, {}, {});\n", primitive_name(mode), vertex, index, indices.size());
        if (plan.vertices.has_sphere) {
            middle_ += glm::dvec3(draw.eye_from_object * glm::dvec4(plan.vertices.center_object, 1));
            ++middle_count_;
        }
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
        uses_smooth_lines_ |= raster.line_smooth;
        if (uses_smooth_lines_) enable(kGL_LINE_SMOOTH, raster.line_smooth);
        uses_logic_op_ |= draw.fragment.logic_op.has_value();
        if (uses_logic_op_) enable(kGL_COLOR_LOGIC_OP, draw.fragment.logic_op.has_value());
        if (draw.fragment.logic_op) set("logic op", fmt::format("glLogicOp({});", enum_name(*draw.fragment.logic_op)));
        if (draw.draws_points()) set("point size", fmt::format("glPointSize({});", c_number(point_size(draw))));
        // The program has one clip distance for each enabled plane, without gaps.
        const int planes = raster.clip_plane_count();
        for (int i = 0; i < kMaxClipPlanes; ++i) {
            const std::string name = fmt::format("GL_CLIP_DISTANCE{}", i);
            set(name, fmt::format("{}({});", i < planes ? "glEnable" : "glDisable", name));
        }
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
    // Scenes without a stencil test do not mention it.
    void write_stencil(const std::optional<StencilTest>& stencil) {
        uses_stencil_ |= stencil.has_value();
        if (uses_stencil_) enable(kGL_STENCIL_TEST, stencil.has_value());
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

    void write_uniforms(const Draw& draw, const Plan& plan, const Code& kind) {
        const EffectSet& effects = kind.effects;
        uniform("matrices", fmt::format("matrices({},\n        {});", c_floats(draw.eye_from_object),
                                        c_floats(draw.clip_from_eye)));
        if (effects.lighting) {
            uniform("ambient", fmt::format("light_model_ambient({});", c_floats(glm::dvec4(plan.constant_ambient, 1))));
            uniform("front", fmt::format("front_material({});", c_material(plan.lighting.front)));
            if (effects.two_side) uniform("back", fmt::format("back_material({});", c_material(plan.lighting.back)));
            for (const int number : kind.form.kept->lights) write_light(plan, number);
        }
        for (const int number : kind.form.kept->clip_planes)
            uniform(fmt::format("plane {}", number),
                    fmt::format("clip_plane({}, {});", number,
                                c_floats(*draw.raster.clip_planes_eye[static_cast<std::size_t>(number)])));
        if (draw.fragment.alpha_test)
            uniform("alpha", fmt::format("number(\"AlphaRef\", {});", c_number(draw.fragment.alpha_ref)));
        if (kind.form.sizes_points)
            uniform("point size",
                    fmt::format("number(\"PointSize\", {});", c_number(std::max(std::round(point_size(draw)), 1.0))));
        if (effects.has_fog()) {
            const Fog& fog = draw.fog;
            uniform("fog", fmt::format("fog({}, {}, {}, {});", c_floats(fog.color), c_number(fog.density),
                                       c_number(fog.start), c_number(fog.end)));
        }
        if (effects.has_texture()) write_texture(draw.texture, effects);
    }

    void write_light(const Plan& plan, int number) {
        const LightSource& light = plan.lighting.lights[static_cast<std::size_t>(number)];
        uniform(fmt::format("light {}", number), fmt::format("light({}, {});", number, c_light(light)));
        if (!light.smooth_cone) return;
        const SmoothConeValues cone = smooth_cone_values(light);
        for (const auto& [what, value] :
             {std::pair(LightValue::kCosOuter, cone.cos_outer), {LightValue::kConeSlope, cone.slope}}) {
            const std::string name = kept_cone_name(number, what);
            uniform(name, fmt::format("number(\"{}\", {});", name, c_number(value)));
        }
    }

    void write_texture(const TextureUnit& unit, const EffectSet& effects) {
        auto found = std::ranges::find(textures_, unit.texture);
        if (found == textures_.end()) found = textures_.insert(found, unit.texture);
        set("texture", fmt::format("use_texture({}, {}, {});", enum_name(target_of(*unit.texture)),
                                   found - textures_.begin() + 1, c_number(unit.lod_bias)));
        if (effects.texture.matrix)
            uniform("texture matrix", fmt::format("texture_matrix({});", c_floats(unit.texture_matrix)));
        write_generated(unit, effects.texture);
        uniform("texture color", fmt::format("texture_env_color({});", c_floats(unit.env_color)));
    }
    void write_generated(const TextureUnit& unit, const TextureEffects& effects) {
        for (const GeneratedCoordinate& one : unit.generated) {
            if (effects.generated[static_cast<std::size_t>(one.coordinate)] != Generated::kLinear) continue;
            const bool is_eye = one.mode == kGL_EYE_LINEAR;
            const std::string name = fmt::format("{}Plane{}[0]", is_eye ? "Eye" : "Object", "STRQ"[one.coordinate]);
            uniform(name, fmt::format("{}_plane(\"{}\", {});", is_eye ? "eye" : "object", name, c_floats(one.plane)));
        }
    }
    Enum target_of(const Texture& texture) const {
        return version_ == Glsl::k300es && texture.is_flat() ? Enum{kGL_TEXTURE_2D} : texture.target;
    }

    // ---- The files ----

    glm::dvec3 middle() const { return middle_count_ == 0 ? glm::dvec3(0) : middle_ / middle_count_; }

    // The statements of load_scene().
    std::string load_text() {
        std::string load;
        for (std::size_t i = 0; i < kinds_.size(); ++i) {
            std::vector<std::string> list;
            for (const Attribute& attribute : attributes(kinds_[i].effects))
                list.push_back(fmt::format("{{\"{}\", {}}}", with_words(attribute.name, kept_names()), attribute.size));
            load += fmt::format("    load_kind({}, {}, (struct attribute[]){{{}}});\n", i + 1, list.size(),
                                fmt::join(list, ", "));
        }
        for (std::size_t i = 0; i < textures_.size(); ++i) load += texture_text(i + 1, *textures_[i]);
        return load;
    }

    std::string scene_text(const std::string& name) {
        const std::string load = load_text();
        const char* const gl = version_ == Glsl::k130 ? "3, 0" : version_ == Glsl::k330 ? "3, 3" : "4, 3";
        return fmt::format(
            "// {}: its state and its draws, as calls of loader.c and GL. Vertices, indices and texels are in "
            "scene.bin.\n"
            "#include \"loader.h\"\n\n"
            "const int scene_width = {}, scene_height = {};\n"
            "const int scene_gl_version[2] = {{{}}}, scene_has_core_profile = {:d};\n"
            "const int scene_kind_count = {}, scene_texture_count = {};\n"
            "const float scene_middle[3] = {{{}}};\n\n"
            "void load_scene(void) {{\n{}}}\n\n"
            "void draw_scene(void) {{\n{}}}\n",
            printable(name), frame_.width, frame_.height, gl, version_ != Glsl::k130, kinds_.size(), textures_.size(),
            c_numbers(middle()), load, body_);
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
            "    cc -std=c99 loader.c scene.c -o scene -lglut -lGL -lm && ./scene     # drag to turn, 1 to 8 switch "
            "lights\n\n"
            "- `kindN.vert`, `kindN.frag`: GLSL {}, a pair for each kind of material and set of lights. They stay "
            "right "
            "when objects, lights and the camera move.\n"
            "- Uniforms and attributes are GL's state with the names of GLSL 1.20's `gl_` variables, without that "
            "prefix: `LightSource[0].position` is in eye coordinates, as glLight stored it.\n"
            "- `scene.c`: the values, one call for each glLight, glMaterial and so on. `loader.c`: these calls, and "
            "the window. `scene.bin`: vertices, indices, texels.\n"
            "- Another light set, a texture, fog or a term that is 0 now needs another kind: change the scene and "
            "export it again.\n"
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
    std::vector<Code> kinds_;
    std::vector<std::shared_ptr<const Texture>> textures_;
    std::vector<std::uint32_t> words_;                          // scene.bin
    std::map<std::vector<std::uint32_t>, std::size_t> places_;  // of what is in words_
    std::map<std::string, std::string> last_;
    std::string body_;  // of draw_scene()
    int kind_ = 0;      // of the Draw being written
    bool uses_stencil_ = false, uses_smooth_lines_ = false, uses_logic_op_ = false;
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
