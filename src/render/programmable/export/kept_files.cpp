#include "render/programmable/export/kept_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "base/text/translation.h"
#include "render/programmable/export/c_text.h"
#include "render/programmable/export/core_elements.h"
#include "render/programmable/export/kept_code.h"
#include "render/programmable/export/kind_row.h"
#include "render/programmable/export/scene_text.h"
#include "render/programmable/export/state_calls.h"
#include "render/programmable/numbers/draw_values.h"
#include "render/programmable/numbers/vertex_attributes.h"
#include "render/programmable/text/kept_text.h"
#include "render/programmable/text/shader_assembly.h"
#include "scene/command/names.h"

namespace twinlight::programmable {
namespace {

// 8-bit colours, or depths as whole numbers of 32 bits.
std::vector<std::uint32_t> texels_of(const TextureImage& image) {
    const bool are_depths = image.base_format == kGL_DEPTH_COMPONENT;
    std::vector<std::uint32_t> words;
    for (const glm::vec4& texel : image.texels)
        words.push_back(are_depths ? static_cast<std::uint32_t>(std::llround(texel.r * 4294967295.0))
                                   : texel_word(texel));
    return words;
}

// "draw_lamp_mesh" for what a recorded program's function draw_lamp draws.
std::string mesh_of_function(const Place& place) {
    if (!place.calls) return "";
    const std::size_t last = place.calls->rfind('>');
    std::string name;
    for (const char c : last == place.calls->npos ? *place.calls : place.calls->substr(last + 1))
        if (std::isalnum(static_cast<unsigned char>(c)) != 0 || (c != ' ' && !name.empty() && name.back() != '_'))
            name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
    const bool is_name = !name.empty() && std::isalpha(static_cast<unsigned char>(name.front())) != 0;
    return is_name ? name + (name.back() == '_' ? "mesh" : "_mesh") : "";
}

class Writer {
  public:
    Writer(const KeptScene& kept_scene, const Options& options, Glsl version)
        : kept_scene_(kept_scene), options_(options), version_(version) {
        options_.for_any_pose = true;
    }

    std::vector<NamedFile> files() {
        kept_scene_.for_each_frame([this](const Frame& frame, int number) { add(frame, number); });
        std::vector<NamedFile> files = shaders();
        files.push_back({"kinds.c", kinds_text()});
        for (const char* file : {"gl_state.h", "gl_state.c", "names.sed"})
            files.push_back({file, std::string(file_text(file))});
        files.push_back({"scene.c", scene_text()});
        files.push_back({"scene.bin", std::string(data_.bytes())});
        for (const char* file : {"scene.h", "window.c"}) files.push_back({file, std::string(file_text(file))});
        files.push_back({"README.md", readme(kept_scene_.name)});
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

    // ---- Frames ----

    void add(const Frame& frame, int number) {
        if (const std::string why = why_not_in_files(frame); !why.empty()) throw std::runtime_error(why);
        const bool is_first = !scene_;
        if (is_first) {
            width_ = frame.width;
            height_ = frame.height;
            scene_.emplace(data_);
        }
        scene_->begin_frame(number);
        texture_numbers_.clear();
        const Clear* clears = frame.items.empty() ? nullptr : std::get_if<Clear>(&frame.items.front());
        if (!clears || !clears->hides_picture()) scene_->clear({.color = true, .depth = true, .clear_depth = 1});
        for (const auto& item : frame.items) {
            const Draw* draw = std::get_if<Draw>(&item);
            if (const Clear* clear = std::get_if<Clear>(&item))
                scene_->clear(*clear);
            else if (draw && draw->pixels && draw->pixels->has_stencils)
                for (const Draw& one : by_stencil_value(*draw)) add_draw(one);
            else if (draw && draw->count() > 0)
                add_draw(*draw);
        }
        if (is_first && middle_count_ > 0) middle_ /= middle_count_;
        has_middle_ = true;
    }

    void add_draw(const Draw& draw) {
        const Plan plan = plan_effects(draw, options_);
        const Code code = kept_code(draw, plan, version_);
        SceneMesh mesh;
        std::tie(mesh.mode, mesh.indices) =
            separate_elements(core_elements(draw, code.effects.shading == Shading::kFlat));
        if (mesh.indices.empty()) return;
        const int kind = number_of_kind(draw, plan, code);
        const std::size_t texture = draw.texture.texture ? number_of_texture(draw.texture.texture) : 0;
        mesh.layout = layout_of(plan, code.effects);
        mesh.vertices = vertex_array(draw, code.effects, {}, glm::dvec3(0));
        mesh.vertex_count = draw.vertices.size();
        std::string name = kept_scene_.name_of_shape ? kept_scene_.name_of_shape(draw.place) : "";
        if (name.empty()) name = mesh_of_function(draw.place);
        scene_->draw(draw, settings_of(draw, plan, code, kind, texture, version_), unknown_after(plan, code), kind,
                     std::move(mesh), name);
        if (has_middle_ || !plan.vertices.has_sphere) return;
        middle_ += glm::dvec3(draw.eye_from_object * glm::dvec4(plan.vertices.center_object, 1));
        ++middle_count_;
    }

    // A kind of state, and its row in kinds.c: if only ffUseKind() chooses it, the other one.
    struct Kind {
        Code code;
        bool is_not_gl = false;
        std::string row, row_by_number;
        std::string place;
    };
    int number_of_kind(const Draw& draw, const Plan& plan, const Code& code) {
        const auto row = [&](bool by_number) {
            return kind_row(draw, plan, code, options_, target_of(draw.texture, version_), by_number);
        };
        Kind kind{code, is_not_gl(plan), row(false), row(true), printable(draw.place.str())};
        const auto found = std::ranges::find_if(kinds_, [&](const Kind& one) {
            return one.code.effects == code.effects && one.code.form == code.form && one.row == kind.row &&
                   one.is_not_gl == kind.is_not_gl;
        });
        const int number = static_cast<int>(found - kinds_.begin()) + 1;
        if (found == kinds_.end()) kinds_.push_back(std::move(kind));
        return number;
    }
    // Or others have the same row: for textures of other formats, which GL's state does not show.
    std::vector<bool> kinds_by_number() const {
        std::vector<bool> result;
        for (const Kind& kind : kinds_)
            result.push_back(kind.is_not_gl || std::ranges::count(kinds_, kind.row, &Kind::row) > 1);
        return result;
    }

    // The members of an array in scene.c that says where the attributes lie in a vertex.
    static std::string layout_of(const Plan& plan, const EffectSet& effects) {
        std::string text;
        for (const Attribute& attribute : attributes(effects)) {
            int floats = attribute.size;
            if (attribute.name == "a_normal" || (attribute.name == "a_position" && plan.vertices.w_is_1) ||
                (attribute.name == "a_tex_coord" && plan.vertices.q_is_1))
                floats = 3;
            text +=
                fmt::format("{{\"{}\", {}, {}}}, ", with_words(attribute.name, kept_names()), floats, attribute.size);
        }
        return text;
    }

    // ---- Textures ----

    // Other frames have equal textures in other memory.
    std::size_t number_of_texture(const std::shared_ptr<const Texture>& texture) {
        std::size_t& number = texture_numbers_[texture];
        if (number == 0) {
            const std::string text = texture_text(*texture);
            const auto found = std::ranges::find(textures_, text);
            number = static_cast<std::size_t>(found - textures_.begin()) + 1;
            if (found == textures_.end()) textures_.push_back(text);
        }
        return number;
    }

    // The statements of load_scene() that load it under the number that stands for '@'.
    std::string texture_text(const Texture& texture) {
        // If the shader clamps, a linear filter must see half of the border.
        const Enum clamped = texture.filters_linearly() ? kGL_CLAMP_TO_BORDER : kGL_CLAMP_TO_EDGE;
        const auto wrap = [&](Enum mode) { return enum_name(mode == kGL_CLAMP ? clamped : mode); };
        std::string levels;
        std::size_t count = 0;
        constexpr std::size_t kMostLevels = 16;
        for (const TextureImage& level : texture.levels) {
            if (level.texels.empty() || count == kMostLevels) break;
            levels += fmt::format("{}{{{}, {}, {}, {}}}", count++ == 0 ? "" : ", ", level.width, level.height,
                                  level.depth, data_.place_of(texels_of(level)).first);
        }
        std::string load = fmt::format(
            "    load_texture(@, (struct texture){{\n        .target = {}, .min_filter = {}, .mag_filter = {}, "
            ".wrap_s = {}, .wrap_t = {}, .wrap_r = {},\n        .border_color = {{{}}}, .level_count = {}, .levels = "
            "{{{}}}",
            enum_name(target_of(texture, version_)), enum_name(texture.min_filter), enum_name(texture.mag_filter),
            wrap(texture.wrap_s), wrap(texture.wrap_t), wrap(texture.wrap_r), c_numbers(texture.border_texel()), count,
            levels);
        if (texture.has_depths()) load += ",\n        .has_depths = 1";
        if (texture.compares()) load += fmt::format(", .compare_func = {}", enum_name(texture.compare_func));
        load += "});\n";
        const auto limit = [&](const char* parameter, double lod, double initial) {
            if (lod != initial)
                load += fmt::format("    glTexParameterf({}, {}, {});\n", enum_name(target_of(texture, version_)),
                                    parameter, c_number(lod));
        };
        limit("GL_TEXTURE_MIN_LOD", texture.min_lod, Texture().min_lod);
        limit("GL_TEXTURE_MAX_LOD", texture.max_lod, Texture().max_lod);
        return load;
    }

    // ---- The files ----

    std::string kinds_text() const {
        const std::vector<bool> by_number = kinds_by_number();
        std::string rows;
        for (std::size_t i = 0; i < kinds_.size(); ++i)
            rows += fmt::format("    // kind{}.vert, kind{}.frag\n    {{\"{}\",\n     {}}},\n", i + 1, i + 1,
                                with_escapes(kinds_[i].place), by_number[i] ? kinds_[i].row_by_number : kinds_[i].row);
        if (rows.empty()) rows = "    {\"\", 0, 0, {0}, 0, GL_ALWAYS, 0, 0, 0, {0, 0, 0, 0}, {NULL}},\n";
        return fmt::format(
            "// {}: which state each pair of shaders can draw. gl_state.h explains the members.\n"
            "#include \"gl_state.h\"\n\n#include <stddef.h>\n\n"
            "const struct ff_kind ff_kinds[] = {{\n{}}};\nconst int ff_kind_count = {};\n",
            printable(kept_scene_.name), rows, kinds_.size());
    }

    std::string scene_text() {
        const char* const gl = version_ == Glsl::k130 ? "3, 0" : version_ == Glsl::k330 ? "3, 3" : "4, 3";
        scene_->finish(kinds_by_number());
        const SceneParts parts = scene_parts(*scene_, data_);
        std::string load;
        for (std::size_t i = 0; i < textures_.size(); ++i) {
            std::string text = textures_[i];
            for (std::size_t at = 0; (at = text.find('@')) != text.npos;) text.replace(at, 1, std::to_string(i + 1));
            load += text;
        }
        const auto block = [](const std::string& part) { return part.empty() ? "" : part + "\n"; };
        return fmt::format(
            "// {}: what it draws, as calls of gl_state.c and GL. Vertices, indices and texels are in scene.bin.\n"
            "#include \"gl_state.h\"\n#include \"scene.h\"\n\n#include <stddef.h>\n\n"
            "const int scene_width = {}, scene_height = {};\n"
            "const int scene_gl_version[2] = {{{}}}, scene_has_core_profile = {:d};\n"
            "const int scene_texture_count = {};\n"
            "const float scene_middle[3] = {{{}}};\n\n"
            "{}{}"
            "// Once, before the first frame: textures, and the state that never changes.\n"
            "void load_scene(void) {{\n{}}}\n\n"
            "{}{}"
            "const struct frame scene_frames[] = {{\n{}}};\n"
            "const int scene_frame_count = sizeof scene_frames / sizeof *scene_frames;\n",
            printable(kept_scene_.name), width_, height_, gl, version_ != Glsl::k130, textures_.size(),
            c_numbers(middle_), block(parts.layouts), block(parts.meshes), load + parts.load, parts.lists,
            block(parts.frames), parts.table);
    }
    static std::string with_escapes(std::string text) {
        for (std::size_t at = 0; (at = text.find('"', at)) != text.npos; at += 2) text.insert(at, 1, '\\');
        return text;
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
            "- `scene.c`, `scene.bin`, `scene.h`, `window.c`: what is drawn with them, in a window.\n"
            "- What core GL lacks: edge flags, polygon modes that differ between faces, and wireframes of "
            "quadrilaterals without their diagonal.\n",
            printable(name), kept_version_name(version_));
    }
    static const char* kept_version_name(Glsl version) {
        return version == Glsl::k130 ? "1.30" : version == Glsl::k330 ? "3.30 core" : "ES 3.00";
    }

    const KeptScene& kept_scene_;
    Options options_;
    const Glsl version_;
    int width_ = 0, height_ = 0;
    std::vector<Kind> kinds_;
    ExportWords data_;
    std::optional<SceneSteps> scene_;                                        // from the first frame on
    std::vector<std::string> textures_;                                      // texture_text()
    std::map<std::shared_ptr<const Texture>, std::size_t> texture_numbers_;  // of the frame being added
    glm::dvec3 middle_{0};  // of the first frame's draws, in eye coordinates
    double middle_count_ = 0;
    bool has_middle_ = false;
};

}  // namespace

std::string why_not_in_files(const Frame& frame) {
    if (std::string why = why_not_kept(frame); !why.empty()) return why;
    if (frame.copies_pixels) return tr("it copies pixels of its picture (glCopyPixels)");
    if (accumulates(frame)) return tr("it uses the accumulation buffer (glAccum), which core GL lacks");
    for (const Draw* draw : frame.draws()) {
        if (!draw->further_units.empty()) return tr("it uses more than one texture unit (glActiveTexture)");
        if (draw->combines_textures()) return tr("it combines textures with GL_COMBINE (glTexEnv)");
        if (draw->raster.point_parameters.depends_on_distance())
            return tr("its points become smaller with the distance (glPointParameter)");
        if (draw->texture.texture && draw->texture.texture->is_cube()) return tr("it uses a cube map");
        if (draw->column(VertexAttribute::kSecondaryColor))
            return tr("it adds secondary colours without lighting (glSecondaryColor)");
        if (draw->column(VertexAttribute::kFogCoord)) return tr("it uses fog coordinates (glFogCoord)");
        if (draw->raster.line_stipple) return tr("it uses a line stipple, which core GL lacks");
        if (draw->raster.polygon_stipple) return tr("it uses a polygon stipple, which core GL lacks");
        if (draw->raster.point_sprite) return tr("it uses point sprites (GL_POINT_SPRITE)");
        if (draw->raster.point_smooth) return tr("it uses smooth points, which core GL lacks");
    }
    return "";
}

std::vector<NamedFile> kept_files(const KeptScene& scene, const Options& options, Glsl version) {
    return Writer(scene, options, version).files();
}

std::vector<NamedFile> kept_files(const Frame& frame, const Options& options, Glsl version, const std::string& name) {
    return kept_files({.name = name, .for_each_frame = [&](const auto& visit) { visit(frame, 0); }}, options, version);
}

}  // namespace twinlight::programmable
