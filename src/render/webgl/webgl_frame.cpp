#include "render/webgl/webgl_frame.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "render/programmable/draw_values.h"
#include "render/programmable/kept/core_elements.h"
#include "render/programmable/kept/kept_code.h"
#include "render/programmable/kept/kept_text.h"
#include "render/programmable/shader_assembly.h"
#include "render/programmable/surface_values.h"
#include "render/programmable/vertex_attributes.h"
#include "render/webgl/kept_values.h"
#include "render/webgl/webgl_lines.h"
#include "render/webgl/webgl_runs.h"
#include "render/webgl/webgl_textures.h"

namespace twinlight::webgl {

namespace {

using programmable::Form, programmable::Uniforms;

// The numbers of one pass over a Draw's primitives, in groups.
using Pass = std::vector<Json>;

Json numbers_in(const Uniforms& uniforms) {
    Json json = Json::object();
    for (std::size_t i = 0; i < uniforms.size(); ++i) json[std::string(uniforms[i].name)] = uniforms[i].values;
    return json;
}

Json box(const Viewport& v) { return {v.x, v.y, v.width, v.height}; }
Json color_of(const glm::dvec4& c) { return {c.r, c.g, c.b, c.a}; }

// WebGL allows no depth range from far to near (its specification, "Viewport Depth Range"). The same depths result from clip coordinates with
// the opposite z.
bool is_reversed(const Draw& draw) { return draw.raster.depth_near > draw.raster.depth_far; }
void reverse(Draw& draw) {
    std::swap(draw.raster.depth_near, draw.raster.depth_far);
    for (int column = 0; column < 4; ++column) draw.clip_from_eye[column].z *= -1;
}

// Whether WebGL's textures of 8 bits hold these texels exactly.
bool are_bytes(const Texture& texture) {
    for (std::size_t face = 0; face < texture.face_count(); ++face)
        for (const TextureImage& image : texture.face(face))
            for (const glm::vec4& texel : image.texels)
                for (int i = 0; i < 4; ++i)
                    if (std::abs(texel[i] * 255 - std::round(texel[i] * 255)) > 1e-3F) return false;
    return true;
}

class Writer {
  public:
    Writer(const Frame& frame, PlanOptions options) : frame_(frame), options_(options) { options_.reasons = false; }

    WebglFrame written() {
        const Draw* last = nullptr;
        for (const auto& item : frame_.items) {
            if (const Clear* clear = std::get_if<Clear>(&item)) {
                add(*clear);
            } else if (const Accumulate* accumulate = std::get_if<Accumulate>(&item)) {
                add(*accumulate);
            } else if (const Draw* draw = std::get_if<Draw>(&item); draw && draw->count() > 0) {
                if (draw->pixels && draw->pixels->has_stencils) {
                    for (const Draw& one : by_stencil_value(*draw)) add_planned(one);
                } else if (options_.shading != Shading::kExact || !draw->has_exact_surfaces()) {
                    add_planned(*draw);
                } else if (!last || !are_one_shape(*last, *draw)) {
                    for (const auto& surface : programmable::surface_programs(*draw, options_))
                        add(surface.draw, surface.code, passes_of(surface.passes));
                }
                last = draw;
            }
        }
        Json missing = Json::array();
        for (const auto& [message, place] : missing_)
            missing.push_back({{"line", place.line}, {"column", place.column}, {"message", message}});
        Json header = {{"width", frame_.width},
                       {"height", frame_.height},
                       {"programs", std::move(programs_)},
                       {"textures", std::move(textures_)},
                       {"uniforms", std::move(uniforms_)},
                       {"items", std::move(items_)},
                       {"missing", std::move(missing)}};
        if (options_.for_any_pose) header["middle"] = {middle_eye_.x, middle_eye_.y, middle_eye_.z};
        return {std::move(header), std::move(words_)};
    }

  private:
    // ---- Words ----

    // Appends words, unless they are there already; returns their place.
    template <class Word>
    Json place_of(const std::vector<Word>& words) {
        static_assert(sizeof(Word) == 4);
        const auto bytes = [&](const void* at) {
            return std::string_view(static_cast<const char*>(at), 4 * words.size());
        };
        const std::size_t hash = std::hash<std::string_view>()(bytes(words.data()));
        for (auto [at, end] = places_.equal_range(hash); at != end; ++at) {
            const auto [first, count] = at->second;
            if (count == words.size() && bytes(words_.data() + first) == bytes(words.data())) return {first, count};
        }
        const std::size_t first = words_.size();
        for (const Word word : words) words_.push_back(std::bit_cast<std::uint32_t>(word));
        places_.emplace(hash, std::pair(first, words.size()));
        return {first, words.size()};
    }

    void miss(const Draw& draw, const char* what) { missing_.try_emplace(what, draw.place); }

    // ---- Programs ----

    std::size_t program_of(const EffectSet& effects, const Form& form) {
        const auto found = std::ranges::find_if(
            kinds_, [&](const auto& kind) { return kind.first == effects && kind.second == form; });
        if (found != kinds_.end()) return static_cast<std::size_t>(found - kinds_.begin());
        kinds_.emplace_back(effects, form);
        const programmable::ShaderSource source = programmable::assemble(effects, form);
        Json sizes = Json::array();
        for (const programmable::Attribute& attribute : programmable::attributes(effects))
            sizes.push_back(attribute.size);
        for (const programmable::Attribute& attribute : programmable::line_attributes(form))
            sizes.push_back(attribute.size);
        programs_.push_back({{"vertex", source.vertex}, {"fragment", source.fragment}, {"attributes", sizes}});
        return kinds_.size() - 1;
    }

    // ---- Uniforms ----

    std::size_t number_of(const Json& uniforms) {
        const auto [at, is_new] = uniform_numbers_.try_emplace(dumped(uniforms), uniforms_.size());
        if (is_new) uniforms_.push_back(uniforms);
        return at->second;
    }
    static std::vector<Pass> passes_of(const std::vector<Uniforms>& passes) {
        std::vector<Pass> result;
        result.reserve(passes.size());
        for (const Uniforms& pass : passes) result.push_back({numbers_in(pass)});
        return result;
    }

    // ---- Textures ----

    std::size_t texture_of(const std::shared_ptr<const Texture>& texture) {
        const auto [at, is_new] = texture_numbers_.try_emplace(texture.get(), textures_.size());
        if (is_new) textures_.push_back(json_of(has_rim(*texture) ? with_rim(*texture) : *texture));
        return at->second;
    }
    Json json_of(const Texture& texture) {
        const bool compares = texture.compares(), are_8_bits = are_bytes(texture);
        const char* const format = compares ? "depth" : are_8_bits ? "rgba8" : "rgba32f";
        Json images = Json::array();
        for (std::size_t face = 0; face < texture.face_count(); ++face)
            for (std::size_t level = 0; level < texture.face(face).size(); ++level) {
                const TextureImage& image = texture.face(face)[level];
                if (image.texels.empty()) continue;
                images.push_back({face, level, image.width, image.height, image.depth, words_.size()});
                for (const glm::vec4& texel : image.texels) append_texel(texel, compares, are_8_bits);
            }
        const auto wrap = [&](Enum mode) -> Enum {
            return mode == kGL_CLAMP || mode == kGL_CLAMP_TO_BORDER ? Enum{kGL_CLAMP_TO_EDGE} : mode;
        };
        Json parameters = {{kGL_TEXTURE_MIN_FILTER, texture.min_filter},
                           {kGL_TEXTURE_MAG_FILTER, texture.mag_filter},
                           {kGL_TEXTURE_WRAP_S, wrap(texture.wrap_s)},
                           {kGL_TEXTURE_WRAP_T, texture.is_flat() ? Enum{kGL_CLAMP_TO_EDGE} : wrap(texture.wrap_t)},
                           {kGL_TEXTURE_WRAP_R, wrap(texture.wrap_r)},
                           {kGL_TEXTURE_MAX_LEVEL, texture.levels.size() - 1},
                           {kGL_TEXTURE_MIN_LOD, texture.min_lod},
                           {kGL_TEXTURE_MAX_LOD, texture.max_lod}};
        if (compares) {
            parameters.push_back({kGL_TEXTURE_COMPARE_MODE, texture.compare_mode});
            parameters.push_back({kGL_TEXTURE_COMPARE_FUNC, texture.compare_func});
        }
        return {{"target", texture.is_flat() ? Enum{kGL_TEXTURE_2D} : texture.target},
                {"format", format},
                {"images", images},
                {"levels", texture.levels.size()},
                {"anisotropy", texture.max_anisotropy},
                {"parameters", parameters}};
    }
    void append_texel(const glm::vec4& texel, bool compares, bool are_8_bits) {
        if (compares) {
            words_.push_back(static_cast<std::uint32_t>(std::llround(texel.r * 4294967295.0)));
        } else if (are_8_bits) {
            words_.push_back(programmable::texel_word(texel));
        } else {
            for (int i = 0; i < 4; ++i) words_.push_back(std::bit_cast<std::uint32_t>(texel[i]));
        }
    }

    void miss_of_texture(const Draw& draw, const TextureUnit& unit) {
        if (lacks_border(*unit.texture))
            miss(draw, "the border colour of cube maps and textures with mipmaps is replaced by their last texels");
    }

    // ---- Items ----

    static void add_scissor(Json& item, const Scissor& scissor, const std::array<bool, 4>& mask) {
        if (scissor.enabled) item["scissor"] = box(scissor.box);
        item["colorMask"] = mask;
    }

    void add(const Clear& clear) {
        Json item = {{"clear", true}};
        add_scissor(item, clear.scissor, clear.color_mask);
        if (clear.color) item["color"] = color_of(clear.clear_color);
        if (clear.depth) item["depth"] = clear.clear_depth;
        if (clear.stencil) item["stencil"] = {clear.clear_stencil, clear.stencil_mask};
        if (clear.accumulation) item["accumulation"] = color_of(clear.clear_accumulation);
        items_.push_back(std::move(item));
    }

    void add(const Accumulate& accumulate) {
        Json item = {{"accumulate", accumulate.op}, {"value", accumulate.value}};
        add_scissor(item, accumulate.scissor, accumulate.color_mask);
        items_.push_back(std::move(item));
    }

    void add_planned(const Draw& draw) {
        const Plan plan = plan_effects(draw, options_);
        if (options_.for_any_pose) {
            const programmable::Code code = programmable::kept_code(draw, plan, programmable::Glsl::k300es);
            add(draw, code, {kept_values(draw, plan, code)});
            add_to_middle(draw, plan);
            return;
        }
        programmable::DrawProgram program = programmable::draw_program(draw, plan, false);
        add(draw, program.code, passes_of({program.numbers}));
    }

    // The camera turns around the middle of the Draws' middles.
    void add_to_middle(const Draw& draw, const Plan& plan) {
        if (!plan.vertices.has_sphere) return;
        const glm::dvec3 middle_eye(draw.eye_from_object * glm::dvec4(plan.vertices.center_object, 1));
        middle_eye_ += (middle_eye - middle_eye_) / ++middles_;
    }

    void add(const Draw& draw, programmable::Code code, const std::vector<Pass>& passes) {
        programmable::set_dialect(code, draw, programmable::Glsl::k300es);
        const EffectSet& effects = code.effects;
        Form form = code.form;
        draw.for_each_unit([&](std::size_t, const TextureUnit& unit) {
            form.lod_bias |= unit.lod_bias != 0;
            form.texture_rims |= has_rim(*unit.texture);
        });
        form.logic_op = draw.fragment.logic_op.value_or(kGL_COPY);
        Json item = Json::object();
        const auto name_of = [&](const std::string& name) { return name_in(form, name); };
        Json own = Json::object();
        if (form.alpha_func != kGL_ALWAYS) own[name_of("u_alpha_ref")] = {static_cast<float>(draw.fragment.alpha_ref)};
        if (form.sizes_points)
            own[name_of("u_point_size")] = {std::max(1.0, std::round(programmable::point_size(draw)))};
        const RasterState& raster = draw.raster;
        if (draw.draws_lines()) own[name_of("u_line_width")] = {std::max(1.0, std::floor(raster.line_width + 0.5))};
        if (raster.line_stipple) {
            own[name_of("u_line_stipple_factor")] = {raster.line_stipple->factor};
            own[name_of("u_line_stipple_pattern")] = {raster.line_stipple->pattern};
        }
        if (raster.polygon_stipple) own[name_of("u_polygon_stipple")] = *raster.polygon_stipple;
        draw.for_each_unit([&](std::size_t number, const TextureUnit& unit) {
            const std::string suffix = effects.has_texture() ? "" : std::to_string(number);
            if (form.lod_bias) own[name_of("u_texture_lod_bias") + suffix] = {unit.lod_bias};
            if (!form.texture_rims) return;
            const glm::dvec3 inside = part_inside(*unit.texture);
            own[name_of("u_texture_inside") + suffix] = {inside.s, inside.t, inside.p};
        });
        for (const Pass& pass : passes) {
            Json numbers = Json::array();
            for (const Json& group : pass) numbers.push_back(number_of(group));
            if (!own.empty()) numbers.push_back(number_of(own));
            item["passes"].push_back(std::move(numbers));
        }
        item["textures"] = Json::array();
        if (effects.has_texture()) {
            item["textures"].push_back({0, name_of("u_texture"), texture_of(draw.texture.texture)});
            miss_of_texture(draw, draw.texture);
        }
        for (const UnitEffects& unit : effects.units)
            draw.for_each_unit([&](std::size_t number, const TextureUnit& state) {
                if (number != unit.number) return;
                item["textures"].push_back(
                    {number, name_of("u_texture" + std::to_string(number)), texture_of(state.texture)});
                miss_of_texture(draw, state);
            });
        add_raster(item, draw);
        add_fragment(item, draw);
        add_parts(item, draw, effects, form, code.origin_object.value_or(glm::dvec3(0)));
    }

    static std::string name_in(const Form& form, const std::string& name) {
        return form.kept ? programmable::with_words(name, programmable::kept_names()) : name;
    }

    void miss_of_turned(const Draw& draw, const Part& part) {
        const RasterState& raster = draw.raster;
        const bool shows_sides =
            draw.draws_borders() && (raster.cull_enabled || raster.polygon_mode_front != raster.polygon_mode_back);
        if (options_.for_any_pose && (shows_sides || part.is_widened()))
            miss(draw, "after a turn, wide lines, line stipples, edges and culling are still those of the first view");
    }

    // An item for each part.
    void add_parts(const Json& state, const Draw& draw, const EffectSet& effects, const Form& form,
                   const glm::dvec3& origin_object) {
        // A viewer of any pose may switch to flat shading.
        const bool is_flat = effects.shading == Shading::kFlat || options_.for_any_pose;
        if (draw.draws_borders() && effects.shading == Shading::kFlat)
            miss(draw, "edges of flat polygons have the colours of their own ends");
        std::optional<Json> whole;  // the place of the Draw's vertices
        for (const Part& part : parts_of(draw, is_flat, effects.two_side)) {
            miss_of_turned(draw, part);
            Form form_of_part = form;
            form_of_part.widened = part.is_widened();
            form_of_part.line_stipple = part.counts;
            form_of_part.line_ends = part.shows_ends;
            form_of_part.polygon_stipple =
                draw.raster.polygon_stipple && draws_polygons(part.mode) && !part.is_widened();
            Json item = state;
            item["program"] = program_of(effects, form_of_part);
            if (part.is_widened()) {
                item["vertices"] =
                    place_of(interleaved(programmable::vertex_array(draw, effects, part.vertices, origin_object),
                                         part.line_attributes, part.vertices.size()));
            } else {
                if (!whole) whole = place_of(programmable::vertex_array(draw, effects, {}, origin_object));
                item["vertices"] = *whole;
            }
            add_elements(item, part, draw, form);
            items_.push_back(std::move(item));
        }
    }

    void add_elements(Json& item, const Part& part, const Draw& draw, const Form& form) {
        if (!programmable::reads_stored_color(form.logic_op)) {
            const Json place = place_of(part.indices);
            item["parts"] = {{part.mode, place[0], place[1]}};
            return;
        }
        const Part list = listed(part);
        const Runs runs = runs_of(list, draw, options_.for_any_pose);
        if (!runs.is_exact)
            miss(draw, options_.for_any_pose ? "after a turn, glLogicOp is wrong where primitives of one draw overlap"
                                             : "glLogicOp is wrong where primitives of one draw overlap");
        const std::size_t first = place_of(list.indices)[0];
        std::size_t begin = 0;
        item["parts"] = Json::array();
        for (const std::size_t end : runs.ends) {
            item["parts"].push_back({list.mode, first + begin, end - begin});
            begin = end;
        }
        item["framebuffer"] = name_in(form, "u_framebuffer");
    }

    // Of each of `count` vertices the values of `a`, then those of `b`.
    static std::vector<float> interleaved(const std::vector<float>& a, const std::vector<float>& b, std::size_t count) {
        const std::size_t of_a = a.size() / count, of_b = b.size() / count;
        std::vector<float> values;
        values.reserve(a.size() + b.size());
        for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t j = 0; j < of_a; ++j) values.push_back(a[i * of_a + j]);
            for (std::size_t j = 0; j < of_b; ++j) values.push_back(b[i * of_b + j]);
        }
        return values;
    }

    void add_raster(Json& item, const Draw& draw) {
        const RasterState& raster = draw.raster;
        item["viewport"] = box(raster.viewport);
        item["depthRange"] = {raster.depth_near, raster.depth_far};
        item["frontFace"] = raster.front_face;
        // Of edges and corners, the culled ones are not there.
        if (raster.cull_enabled && !draw.draws_borders()) item["cull"] = raster.cull_face;
        if (raster.polygon_offset.fill) item["offset"] = {raster.polygon_offset.factor, raster.polygon_offset.units};
        if (raster.depth_test) item["depthFunc"] = raster.depth_func;
        item["depthMask"] = raster.depth_mask;
        if ((draw.draws_lines() && raster.line_smooth) || (draw.draws_points() && raster.point_smooth))
            miss(draw, "GL_LINE_SMOOTH and GL_POINT_SMOOTH are left out");
        if (draw.draws_sprites() && raster.point_parameters.sprite_coord_origin == kGL_LOWER_LEFT)
            miss(draw, "point sprites begin at the upper left, not at the lower left");
    }

    void add_fragment(Json& item, const Draw& draw) {
        const FragmentState& fragment = draw.fragment;
        add_scissor(item, fragment.scissor, fragment.color_mask);
        if (fragment.stencil) {
            const StencilFace &front = fragment.stencil->front, &back = fragment.stencil->back;
            item["stencil"] = Json::array();
            for (const StencilFace* face : {&front, &back})
                item["stencil"].push_back({face->func, std::clamp(face->ref, 0, kMaxStencil), face->mask & kMaxStencil,
                                           face->fail, face->depth_fail, face->depth_pass,
                                           face->write_mask & kMaxStencil});
            // WebGL 2 specification, section 4.1.
            const auto differ = [&](auto member) { return front.*member != back.*member; };
            if (differ(&StencilFace::ref) || differ(&StencilFace::mask) || differ(&StencilFace::write_mask))
                miss(draw, "the back's stencil reference and masks are the front's");
        }
        if (!fragment.blend || fragment.logic_op) return;
        item["blend"] = {
            {"factors", {fragment.blend_src, fragment.blend_dst, fragment.blend_src_alpha, fragment.blend_dst_alpha}},
            {"equations", {fragment.blend_equation, fragment.blend_equation_alpha}},
            {"color", color_of(fragment.blend_color)}};
    }

    const Frame& frame_;
    PlanOptions options_;
    std::vector<std::uint32_t> words_;
    std::unordered_multimap<std::size_t, std::pair<std::size_t, std::size_t>>
        places_;  // in words_, by the hash of what is there
    std::vector<std::pair<EffectSet, Form>> kinds_;
    Json programs_ = Json::array(), textures_ = Json::array(), uniforms_ = Json::array(), items_ = Json::array();
    std::map<std::string, std::size_t> uniform_numbers_;  // by their text
    std::map<const Texture*, std::size_t> texture_numbers_;
    std::map<std::string, Place> missing_;  // the first place of each
    glm::dvec3 middle_eye_{0};
    double middles_ = 0;
};

}  // namespace

WebglFrame webgl_frame(const Frame& frame, const PlanOptions& options) {
    if (std::ranges::none_of(frame.draws(), [](const Draw* draw) { return is_reversed(*draw); }))
        return Writer(frame, options).written();
    Frame forward = frame;
    for (Draw* draw : forward.editable_draws())
        if (is_reversed(*draw)) reverse(*draw);
    return Writer(forward, options).written();
}

}  // namespace twinlight::webgl
