#include "render/programmable/kept/kept_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "render/programmable/draw_values.h"
#include "render/programmable/kept/kept_text.h"
#include "render/programmable/shader_assembly.h"
#include "render/programmable/vertex_attributes.h"
#include "scene/command/names.h"

namespace twinlight::programmable {
namespace {

constexpr int kMostKeptLights = 16;  // MOST_LIGHTS of loader.c; OpenGL promises room for this many uniforms

// ---- Triangles ----

// Core GL has no quadrilaterals and polygons. The last vertex of a triangle gives a flat colour: it is the vertex that
// gives the colour of the quadrilateral or polygon (table 2.12). Smooth quadrilaterals are cut from the first corner
// to the third, as llvmpipe does.
std::pair<Enum, std::vector<std::uint32_t>> core_elements(const Draw& draw, bool flat) {
    const std::size_t count = draw.count();
    std::vector<std::uint32_t> indices;
    const auto add = [&](std::initializer_list<std::size_t> corners) {
        for (const std::size_t corner : corners) indices.push_back(draw.index(corner));
    };
    if (draw.mode == kGL_QUADS) {
        for (std::size_t i = 0; i + 3 < count; i += 4) {
            if (flat)
                add({i, i + 1, i + 3, i + 1, i + 2, i + 3});
            else
                add({i, i + 1, i + 2, i, i + 2, i + 3});
        }
    } else if (draw.mode == kGL_QUAD_STRIP) {
        for (std::size_t i = 0; i + 3 < count; i += 2) add({i, i + 1, i + 3, i + 2, i, i + 3});
    } else if (draw.mode == kGL_POLYGON) {
        for (std::size_t i = 1; i + 1 < count; ++i) add({i, i + 1, 0});
    } else {
        for (std::size_t i = 0; i < count; ++i) indices.push_back(draw.index(i));
        return {draw.mode, indices};
    }
    return {kGL_TRIANGLES, indices};
}

// ---- Kinds ----

struct Kind {
    EffectSet effects;
    Form form;
    friend bool operator==(const Kind&, const Kind&) = default;
};

Kind kind_of(const Draw& draw, const Plan& plan, Glsl version) {
    Kind kind{plan.effects, {}};
    kind.form.position_w = !plan.vertices.w_is_1;
    kind.form.rescale = plan.lighting.rescale_normal && kind.effects.needs_normal() && !kind.effects.normalize &&
                        kind.effects.shading != Shading::kPhong;
    KeptForm kept;
    kept.version = version;
    for (const PlannedLight& light : plan.lights) {
        kept.lights.push_back(light.number);
        kept.light_count = std::max(kept.light_count, light.number + 1);
    }
    for (int i = 0; i < kMaxClipPlanes; ++i)
        if (draw.raster.clip_planes_eye[static_cast<std::size_t>(i)]) kept.clip_planes.push_back(i);
    if (draw.fragment.alpha_test) kept.alpha_func = draw.fragment.alpha_func;
    // OpenGL ES has no 1D textures: they become 2D textures of height 1.
    if (version == Glsl::k300es) kind.effects.texture.one_dimensional = false;
    kind.form.kept = std::move(kept);
    return kind;
}

// ---- C ----

std::string literal(double x) {
    const std::string text = fmt::format("{:.9g}", to_float(x));
    return text.find_first_of(".en") == text.npos ? text : text + "f";
}
template <class Vector>
std::string numbers(const Vector& v) {
    std::string text;
    for (int i = 0; i < Vector::length(); ++i) text += (i == 0 ? "" : ", ") + literal(v[i]);
    return text;
}
template <class Vector>
std::string floats(const Vector& v) {
    return "(float[]){" + numbers(v) + "}";
}
std::string floats(const glm::dmat4& m) {
    return fmt::format("(float[]){{{}, {}, {}, {}}}", numbers(m[0]), numbers(m[1]), numbers(m[2]), numbers(m[3]));
}

std::string material_text(const Material& m) {
    return fmt::format(
        "(struct material){{\n        .emission = {{{}}}, .ambient = {{{}}},\n        .diffuse = {{{}}}, .specular = "
        "{{{}}}, .shininess = {}}}",
        numbers(m.emission), numbers(m.ambient), numbers(m.diffuse), numbers(m.specular), literal(m.shininess));
}

std::string light_text(const LightSource& light) {
    return fmt::format(
        "(struct light){{\n        .ambient = {{{}}}, .diffuse = {{{}}}, .specular = {{{}}},\n        .position = "
        "{{{}}}, .spot_direction = {{{}}},\n        .spot_exponent = {}, .spot_cutoff = {}, .attenuation = {{{}, {}, "
        "{}}}}}",
        numbers(light.ambient), numbers(light.diffuse), numbers(light.specular), numbers(light.position_eye),
        numbers(light.spot_direction_eye), literal(light.spot_exponent), literal(light.spot_cutoff_deg),
        literal(light.constant_attenuation), literal(light.linear_attenuation), literal(light.quadratic_attenuation));
}

// A border's colour as the texels have it (table 3.15).
glm::dvec4 border_of(const Texture& texture) {
    const glm::dvec4& c = texture.border_color;
    switch (texture.levels.front().base_format) {
        case kGL_ALPHA: return {0, 0, 0, c.a};
        case kGL_LUMINANCE: return {c.r, c.r, c.r, 1};
        case kGL_LUMINANCE_ALPHA: return {c.r, c.r, c.r, c.a};
        case kGL_INTENSITY: return {c.r, c.r, c.r, c.r};
        case kGL_RGB: return {c.r, c.g, c.b, 1};
        default: return c;
    }
}

class Writer {
  public:
    Writer(const Frame& frame, const Options& options, Glsl version)
        : frame_(frame), options_(options), version_(version) {
        options_.for_any_pose = true;
    }

    std::vector<NamedFile> files(const std::string& name) {
        write_items();
        std::vector<NamedFile> files;
        for (std::size_t i = 0; i < kinds_.size(); ++i) {
            const ShaderSource source = assemble(kinds_[i].effects, kinds_[i].form);
            files.push_back({fmt::format("kind{}.vert", i + 1), source.vertex});
            files.push_back({fmt::format("kind{}.frag", i + 1), source.fragment});
        }
        files.push_back({"scene.c", scene_text(name)});
        files.push_back(
            {"scene.bin", std::string(reinterpret_cast<const char*>(words_.data()), 4 * words_.size())});  // NOLINT
        for (const char* file : {"loader.h", "loader.c"}) files.push_back({file, std::string(file_text(file))});
        files.push_back({"README.md", readme(name)});
        return files;
    }

  private:
    // ---- scene.bin ----

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
    static std::vector<std::uint32_t> texels_of(const TextureImage& image) {
        std::vector<std::uint32_t> words;
        for (const glm::vec4& texel : image.texels) {
            std::uint32_t word = 0;
            for (int c = 0; c < 4; ++c)
                word |= static_cast<std::uint32_t>(std::lround(255 * std::clamp(texel[c], 0.0F, 1.0F))) << (8 * c);
            words.push_back(word);
        }
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
            if (const Clear* clear = std::get_if<Clear>(&item))
                write_clear(*clear);
            else if (std::get<Draw>(item).count() > 0)
                write_draw(std::get<Draw>(item));
        }
    }

    void write_scissor(const Scissor& scissor, const std::array<bool, 4>& mask) {
        enable(kGL_SCISSOR_TEST, scissor.enabled);
        const Viewport& box = scissor.box;
        if (scissor.enabled)
            set("scissor", fmt::format("glScissor({}, {}, {}, {});", box.x, box.y, box.width, box.height));
        set("color mask", fmt::format("glColorMask({:d}, {:d}, {:d}, {:d});", mask[0], mask[1], mask[2], mask[3]));
    }

    void write_clear(const Clear& clear) {
        if (!clear.color && !clear.depth) return;
        write_scissor(clear.scissor, clear.color_mask);
        set("depth mask", "glDepthMask(1);");
        set("clear color", fmt::format("glClearColor({});", numbers(clear.clear_color)));
        set("clear depth", fmt::format("glClearDepth({});", clear.clear_depth));
        body_ += fmt::format("    glClear({});\n", !clear.depth   ? "GL_COLOR_BUFFER_BIT"
                                                   : !clear.color ? "GL_DEPTH_BUFFER_BIT"
                                                                  : "GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT");
    }

    void write_draw(const Draw& draw) {
        const Plan plan = plan_effects(draw, options_);
        const Kind kind = kind_of(draw, plan, version_);
        const auto found = std::ranges::find(kinds_, kind);
        kind_ = static_cast<int>(found - kinds_.begin()) + 1;
        if (found == kinds_.end()) kinds_.push_back(kind);

        body_ += fmt::format("\n    // {}\n", draw.place.str());
        write_raster(draw);
        write_fragment(draw.fragment);
        set("kind", fmt::format("use_kind({});", kind_));
        write_uniforms(draw, plan, kind);

        const bool flat = kind.effects.shading == Shading::kFlat;
        const auto [mode, indices] = core_elements(draw, flat);
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
        const Viewport& v = raster.viewport;
        set("viewport", fmt::format("glViewport({}, {}, {}, {});", v.x, v.y, v.width, v.height));
        set("depth range", fmt::format("glDepthRange({}, {});", raster.depth_near, raster.depth_far));
        set("front face", fmt::format("glFrontFace({});", enum_name(raster.front_face)));
        enable(kGL_CULL_FACE, raster.cull_enabled);
        if (raster.cull_enabled) set("cull face", fmt::format("glCullFace({});", enum_name(raster.cull_face)));
        // Core GL has one mode for both faces: that of the face that is not culled.
        const bool hides_front = raster.cull_enabled && raster.cull_face == kGL_FRONT;
        set("polygon mode", fmt::format("glPolygonMode(GL_FRONT_AND_BACK, {});",
                                        enum_name(hides_front ? raster.polygon_mode_back : raster.polygon_mode_front)));
        const PolygonOffset& offset = raster.polygon_offset;
        enable(kGL_POLYGON_OFFSET_POINT, offset.point);
        enable(kGL_POLYGON_OFFSET_LINE, offset.line);
        enable(kGL_POLYGON_OFFSET_FILL, offset.fill);
        set("offset", fmt::format("glPolygonOffset({}, {});", literal(offset.factor), literal(offset.units)));
        if (draw.draws_lines()) set("line width", fmt::format("glLineWidth({});", literal(raster.line_width)));
        if (draw.draws_points()) set("point size", fmt::format("glPointSize({});", literal(raster.point_size)));
        // The program has one clip distance for each enabled plane, without gaps.
        const auto planes = std::ranges::count_if(raster.clip_planes_eye, [](const auto& p) { return p.has_value(); });
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
        enable(kGL_BLEND, fragment.blend);
        if (!fragment.blend) return;
        set("blend func",
            fmt::format("glBlendFuncSeparate({}, {}, {}, {});", factor(fragment.blend_src), factor(fragment.blend_dst),
                        factor(fragment.blend_src_alpha), factor(fragment.blend_dst_alpha)));
        set("blend equation", fmt::format("glBlendEquationSeparate({}, {});", enum_name(fragment.blend_equation),
                                          enum_name(fragment.blend_equation_alpha)));
        set("blend color", fmt::format("glBlendColor({});", numbers(fragment.blend_color)));
    }
    static std::string factor(Enum value) {
        return value == kGL_ZERO ? "GL_ZERO" : value == kGL_ONE ? "GL_ONE" : enum_name(value);
    }

    void write_uniforms(const Draw& draw, const Plan& plan, const Kind& kind) {
        const EffectSet& effects = kind.effects;
        uniform("matrices",
                fmt::format("matrices({},\n        {});", floats(draw.eye_from_object), floats(draw.clip_from_eye)));
        if (effects.lighting) {
            uniform("ambient", fmt::format("light_model_ambient({});", floats(glm::dvec4(plan.constant_ambient, 1))));
            uniform("front", fmt::format("front_material({});", material_text(plan.lighting.front)));
            if (effects.two_side) uniform("back", fmt::format("back_material({});", material_text(plan.lighting.back)));
            for (const int number : kind.form.kept->lights) write_light(plan, number);
        }
        for (const int number : kind.form.kept->clip_planes)
            uniform(fmt::format("plane {}", number),
                    fmt::format("clip_plane({}, {});", number,
                                floats(*draw.raster.clip_planes_eye[static_cast<std::size_t>(number)])));
        if (draw.fragment.alpha_test)
            uniform("alpha", fmt::format("number(\"AlphaRef\", {});", literal(draw.fragment.alpha_ref)));
        if (effects.has_fog()) {
            const Fog& fog = draw.fog;
            uniform("fog", fmt::format("fog({}, {}, {}, {});", floats(fog.color), literal(fog.density),
                                       literal(fog.start), literal(fog.end)));
        }
        if (effects.has_texture()) write_texture(draw.texture, effects);
    }

    void write_light(const Plan& plan, int number) {
        const LightSource& light = plan.lighting.lights[static_cast<std::size_t>(number)];
        uniform(fmt::format("light {}", number), fmt::format("light({}, {});", number, light_text(light)));
        if (!light.smooth_cone) return;
        const SmoothConeValues cone = smooth_cone_values(light);
        for (const auto& [what, value] : {std::pair("cos_outer", cone.cos_outer), {"cone_slope", cone.slope}}) {
            const std::string name = fmt::format("u_light{}_{}", number, what);
            uniform(name, fmt::format("number(\"{}\", {});", name, literal(value)));
        }
    }

    void write_texture(const TextureUnit& unit, const EffectSet& effects) {
        auto found = std::ranges::find(textures_, unit.texture);
        if (found == textures_.end()) found = textures_.insert(found, unit.texture);
        set("texture", fmt::format("use_texture({}, {}, {});", enum_name(target_of(*unit.texture)),
                                   found - textures_.begin() + 1, literal(unit.lod_bias)));
        if (effects.texture.matrix)
            uniform("texture matrix", fmt::format("texture_matrix({});", floats(unit.texture_matrix)));
        uniform("texture color", fmt::format("texture_env_color({});", floats(unit.env_color)));
    }
    Enum target_of(const Texture& texture) const {
        return version_ == Glsl::k300es ? Enum{kGL_TEXTURE_2D} : texture.target;
    }

    // ---- The files ----

    std::string scene_text(const std::string& name) {
        std::string load;
        for (std::size_t i = 0; i < kinds_.size(); ++i) {
            std::vector<std::string> list;
            for (const Attribute& attribute : attributes(kinds_[i].effects))
                list.push_back(fmt::format("{{\"{}\", {}}}", with_words(attribute.name, kept_names()), attribute.size));
            load += fmt::format("    load_kind({}, {}, (struct attribute[]){{{}}});\n", i + 1, list.size(),
                                fmt::join(list, ", "));
        }
        for (std::size_t i = 0; i < textures_.size(); ++i) load += texture_text(i + 1, *textures_[i]);
        const glm::dvec3 middle = middle_count_ == 0 ? glm::dvec3(0) : middle_ / middle_count_;
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
            name, frame_.width, frame_.height, gl, version_ != Glsl::k130, kinds_.size(), textures_.size(),
            numbers(middle), load, body_);
    }

    std::string texture_text(std::size_t number, const Texture& texture) {
        const Enum clamped = texture.filters_linearly() ? kGL_CLAMP_TO_BORDER : kGL_CLAMP_TO_EDGE;
        const auto wrap = [&](Enum mode) { return enum_name(mode == kGL_CLAMP ? clamped : mode); };
        std::string levels;
        std::size_t count = 0;
        constexpr std::size_t kMostLevels = 16;
        for (const TextureImage& level : texture.levels) {
            if (level.texels.empty() || count == kMostLevels) break;
            levels += fmt::format("{}{{{}, {}, {}}}", count++ == 0 ? "" : ", ", level.width, level.height,
                                  place_of(texels_of(level)));
        }
        return fmt::format(
            "    load_texture({}, (struct texture){{\n        .target = {}, .min_filter = {}, .mag_filter = {}, "
            ".wrap_s = {}, .wrap_t = {},\n        .border_color = {{{}}}, .level_count = {}, .levels = {{{}}}}});\n",
            number, enum_name(target_of(texture)), enum_name(texture.min_filter), enum_name(texture.mag_filter),
            wrap(texture.wrap_s), wrap(texture.wrap_t), numbers(border_of(texture)), count, levels);
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
            name, kept_version_name(version_));
    }
    static const char* kept_version_name(Glsl version) {
        return version == Glsl::k130 ? "1.30" : version == Glsl::k330 ? "3.30 core" : "ES 3.00";
    }

    const Frame& frame_;
    Options options_;
    const Glsl version_;
    std::vector<Kind> kinds_;
    std::vector<std::shared_ptr<const Texture>> textures_;
    std::vector<std::uint32_t> words_;                          // scene.bin
    std::map<std::vector<std::uint32_t>, std::size_t> places_;  // of what is in words_
    std::map<std::string, std::string> last_;
    std::string body_;  // of draw_scene()
    int kind_ = 0;      // of the Draw being written
    glm::dvec3 middle_{0};
    double middle_count_ = 0;
};

}  // namespace

std::string why_not_kept(const Frame& frame) {
    for (const Draw* draw : frame.draws()) {
        if (!draw->lighting.enabled) continue;
        if (draw->lighting.light_model.spectrum) return "it multiplies colours as spectra (#pragma twinlight spectrum)";
        for (std::size_t i = kMostKeptLights; i < draw->lighting.lights.size(); ++i)
            if (draw->lighting.lights[i].enabled)
                return fmt::format("it uses {}, and they have at most {} lights", light_name(static_cast<int>(i)),
                                   kMostKeptLights);
    }
    return "";
}

std::vector<NamedFile> kept_files(const Frame& frame, const Options& options, Glsl version, const std::string& name) {
    if (const std::string why = why_not_kept(frame); !why.empty()) throw std::runtime_error(why);
    return Writer(frame, options, version).files(name);
}

}  // namespace twinlight::programmable
