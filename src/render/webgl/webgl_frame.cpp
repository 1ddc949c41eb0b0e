#include "render/webgl/webgl_frame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "render/programmable/export/core_elements.h"
#include "render/programmable/export/kept_code.h"
#include "render/programmable/numbers/draw_values.h"
#include "render/programmable/numbers/program_uniforms.h"
#include "render/programmable/numbers/surface_values.h"
#include "render/programmable/numbers/vertex_attributes.h"
#include "render/programmable/text/kept_text.h"
#include "render/programmable/text/shader_assembly.h"
#include "render/reference/geometry/piece.h"
#include "render/webgl/kept_values.h"
#include "render/webgl/webgl_fragments.h"
#include "render/webgl/webgl_lines.h"
#include "render/webgl/webgl_runs.h"
#include "render/webgl/webgl_textures.h"
#include "render/webgl/webgl_vertices.h"

namespace twinlight::webgl {

namespace {

using programmable::EsTextureValue, programmable::EsValue;
using programmable::Form, programmable::Uniforms;

// The numbers of one pass over a Draw's primitives, in groups.
using Pass = std::vector<Json>;

Json numbers_in(const Uniforms& uniforms) {
    Json json = Json::object();
    for (std::size_t i = 0; i < uniforms.size(); ++i) json[std::string(uniforms[i].name)] = uniforms[i].values;
    return json;
}

Json box(const Rectangle& v) { return {v.x, v.y, v.width, v.height}; }
Json color_of(const glm::dvec4& c) { return {c.r, c.g, c.b, c.a}; }

// WebGL allows no depth range from far to near (its specification, "Viewport Depth Range"). The same depths result from clip coordinates with
// the opposite z.
bool is_reversed(const Draw& draw) { return draw.raster.depth_near > draw.raster.depth_far; }
void reverse(Draw& draw) {
    std::swap(draw.raster.depth_near, draw.raster.depth_far);
    for (int column = 0; column < 4; ++column) draw.clip_from_eye[column].z *= -1;
}

// ---- The values of what OpenGL ES lacks ----

Json value_of(EsValue value, const Draw& draw) {
    const RasterState& raster = draw.raster;
    // Sizes of smooth points, of sprites, and smooth lines' widths need not be whole.
    const auto size_of = [](double size, bool is_any) { return is_any ? size : reference::whole_pixels(size); };
    switch (value) {
        case EsValue::kPointSize:
            return {size_of(programmable::point_size(draw), raster.point_smooth || draw.draws_sprites())};
        case EsValue::kViewport: return box(raster.viewport);
        case EsValue::kLineWidth: return {size_of(raster.line_width, raster.line_smooth)};
        case EsValue::kLineStippleFactor: return {raster.line_stipple->factor};
        case EsValue::kLineStipplePattern: return {raster.line_stipple->pattern};
        case EsValue::kPolygonStipple: return *raster.polygon_stipple;
        case EsValue::kBlendSource: {
            const glm::dvec3 factor = constant_factor(draw.fragment);
            return {factor.r, factor.g, factor.b};
        }
        case EsValue::kAlphaRef: return {static_cast<float>(draw.fragment.alpha_ref)};
        case EsValue::kFramebuffer: break;  // the page copies it
    }
    return {};
}

Json value_of(EsTextureValue value, const TextureUnit& unit) {
    switch (value) {
        case EsTextureValue::kLodBias: return {unit.lod_bias};
        case EsTextureValue::kInside: {
            const glm::dvec3 inside = part_inside(*unit.texture);
            return {inside.s, inside.t, inside.p};
        }
    }
    return {};
}

class Writer {
  public:
    Writer(const Frame& frame, PlanOptions options, programmable::ExportWords& words, bool keeps_shading)
        : frame_(frame), options_(options), may_become_flat_(options.for_any_pose && !keeps_shading), words_(words) {
        options_.reasons = false;
    }

    Json header() {
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
        for (const auto& [text, place] : frame_.labels)
            header["labels"].push_back(
                {{"text", text}, {"at", {place.x * frame_.width, (1 - place.y) * frame_.height}}});
        if (options_.for_any_pose) header["middle"] = {middle_eye_.x, middle_eye_.y, middle_eye_.z};
        return header;
    }

  private:
    void miss(const Draw& draw, const std::string& what) { missing_.try_emplace(what, draw.place); }

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
        if (is_new) textures_.push_back(texture_json(*texture, words_));
        return at->second;
    }
    void miss_of_texture(const Draw& draw, const TextureUnit& unit) {
        if (lacks_border(*unit.texture))
            miss(draw, "the border colour of cube maps and textures with mipmaps is replaced by their last texels");
        else if (lacks_faces(*unit.texture))
            miss(draw, "cube maps are filtered across the borders of their faces");
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
            form.texture_rims |= has_rim(*unit.texture) || stays_on_faces(*unit.texture);
        });
        form.logic_op = draw.fragment.logic_op.value_or(kGL_COPY);
        form.scales_source = mixes_constants(draw.fragment);
        Json item = Json::object();
        for (const Pass& pass : passes) {
            Json numbers = Json::array();
            for (const Json& group : pass) numbers.push_back(number_of(group));
            item["passes"].push_back(std::move(numbers));
        }
        item["textures"] = Json::array();
        for_each_texture(draw, effects, [&](std::size_t number, const TextureUnit& unit, const std::string& suffix) {
            item["textures"].push_back(
                {number, name_in(form, programmable::TextureValue::kSampler, suffix), texture_of(unit.texture)});
            miss_of_texture(draw, unit);
        });
        add_raster(item, draw);
        add_fragment(item, draw);
        add_parts(item, draw, effects, form, code.origin_object.value_or(glm::dvec3(0)));
    }

    // Visits the textures that the program reads: visit(number, unit, what their names end in).
    template <class Visit>
    static void for_each_texture(const Draw& draw, const EffectSet& effects, const Visit& visit) {
        if (effects.has_texture()) visit(0, draw.texture, "");
        for (const UnitEffects& unit : effects.units)
            draw.for_each_unit([&](std::size_t number, const TextureUnit& state) {
                if (number == unit.number) visit(number, state, std::to_string(number));
            });
    }

    template <class Value>
    static std::string name_in(const Form& form, Value value, const std::string& suffix = "") {
        const std::string name = programmable::name_of(value, suffix);
        return form.kept ? programmable::with_words(name, programmable::kept_names()) : name;
    }

    // What the program of a part needs in addition to the numbers of the passes.
    static Json own_numbers(const Draw& draw, const EffectSet& effects, const Form& form) {
        Json own = Json::object();
        programmable::es_values(form).for_each([&](EsValue value) {
            if (value != EsValue::kFramebuffer) own[name_in(form, value)] = value_of(value, draw);
        });
        for_each_texture(draw, effects, [&](std::size_t, const TextureUnit& unit, const std::string& suffix) {
            programmable::es_values_of_texture(form).for_each(
                [&](EsTextureValue value) { own[name_in(form, value, suffix)] = value_of(value, unit); });
        });
        return own;
    }

    void miss_of_turned(const Draw& draw, const Part& part) {
        if (!options_.for_any_pose) return;
        const RasterState& raster = draw.raster;
        const bool shows_sides =
            raster.cull_enabled || raster.polygon_mode_front != raster.polygon_mode_back || part.has_rectangles();
        if (draw.draws_borders() && shows_sides)
            miss(draw, "after a turn, edges, corners and their culling are still those of the first view");
        if (part.counts) miss(draw, "after a turn, line stipples are still those of the first view");
    }

    // An item for each part.
    void add_parts(const Json& state, const Draw& draw, const EffectSet& effects, const Form& form,
                   const glm::dvec3& origin_object) {
        const bool is_flat = effects.shading == Shading::kFlat;
        const PartOptions options = {.flat = is_flat || may_become_flat_,
                                     .flat_edges = is_flat,
                                     .two_side = effects.two_side || has_two_stencils(draw),
                                     .for_any_pose = options_.for_any_pose};
        if (draw.draws_borders() && is_flat && effects.generated_normal() != GeneratedNormal::kUnused)
            miss(draw, "edges of flat polygons have texture coordinates from other normals");
        const bool has_colors = effects.lighting || std::ranges::any_of(draw.vertices, [&](const Vertex& vertex) {
                                    return vertex.color != draw.vertices.front().color;
                                });
        if (draw.draws_borders() && may_become_flat_ && has_colors)
            miss(draw, "after the key f, edges of polygons have the colours of other vertices");
        std::optional<Json> whole;  // the place of the Draw's vertices
        const Parts made = parts_of(draw, options);
        if (made.lacks_clipped) miss(draw, "edges and corners that clipping adds to polygons are missing, as in Mesa");
        if (made.loses_order) miss(draw, "faces, edges and corners of one glBegin are not drawn in their order");
        for (const Part& part : made.parts) {
            miss_of_turned(draw, part);
            Form form_of_part = form;
            form_of_part.rectangles = part.rectangles;
            form_of_part.smooth = part.is_smooth;
            form_of_part.flat_edges = !part.colors_from.empty();
            form_of_part.line_stipple = part.counts;
            form_of_part.clips_points = part.mode == kGL_POINTS && !draw.pixels;
            form_of_part.polygon_stipple =
                draw.raster.polygon_stipple && draws_polygons(part.mode) && !part.has_rectangles();
            Json item = state;
            item["program"] = program_of(effects, form_of_part);
            if (const Json own = own_numbers(draw, effects, form_of_part); !own.empty()) {
                const std::size_t number = number_of(own);
                for (Json& pass : item["passes"]) pass.push_back(number);
            }
            if (part.has_rectangles()) {
                // Lines and points are not culled, and polygons' offsets are in their corners.
                item.erase("cull");
                item.erase("offset");
            }
            if (part.has_vertices()) {
                item["vertices"] = words_.place_of(vertex_values(part, draw, effects, origin_object));
            } else {
                if (!whole) whole = words_.place_of(programmable::vertex_array(draw, effects, {}, origin_object));
                item["vertices"] = *whole;
            }
            add_elements(item, part, draw, form);
            items_.push_back(std::move(item));
        }
    }

    void add_elements(Json& item, const Part& part, const Draw& draw, const Form& form) {
        const bool reads_picture = programmable::reads_stored_color(form.logic_op);
        const bool has_sides = draws_polygons(part.mode) && needs_each_side(draw);
        if (!reads_picture && !has_sides) {
            const Json place = words_.place_of(part.indices);
            item["parts"] = {{part.mode, place[0], place[1]}};
            return;
        }
        const Part list = listed(part);
        const Runs runs = runs_of(list, draw, options_.for_any_pose);
        if (!runs.is_exact) {
            const std::string when = options_.for_any_pose ? "after a turn, " : "";
            if (reads_picture) miss(draw, when + "glLogicOp is wrong where primitives of one draw overlap");
            if (has_sides) miss(draw, when + "the back's stencil test is wrong where primitives of one draw overlap");
        }
        const std::size_t first = words_.place_of(list.indices).first;
        std::size_t begin = 0;
        item["parts"] = Json::array();
        for (const std::size_t end : runs.ends) {
            item["parts"].push_back({list.mode, first + begin, end - begin});
            begin = end;
        }
        if (reads_picture) item["framebuffer"] = name_in(form, EsValue::kFramebuffer);
        item["sides"] = has_sides;
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
    }

    void add_fragment(Json& item, const Draw& draw) {
        const FragmentState& fragment = draw.fragment;
        add_scissor(item, fragment.scissor, fragment.color_mask);
        if (fragment.stencil) item["stencil"] = stencil_json(draw);
        if (fragment.blend && !fragment.logic_op) item["blend"] = blend_json(fragment);
    }

    const Frame& frame_;
    PlanOptions options_;
    const bool may_become_flat_;
    programmable::ExportWords& words_;
    std::vector<std::pair<EffectSet, Form>> kinds_;
    Json programs_ = Json::array(), textures_ = Json::array(), uniforms_ = Json::array(), items_ = Json::array();
    std::map<std::string, std::size_t> uniform_numbers_;  // by their text
    std::map<const Texture*, std::size_t> texture_numbers_;
    std::map<std::string, Place> missing_;  // the first place of each
    glm::dvec3 middle_eye_{0};
    double middles_ = 0;
};

}  // namespace

Json webgl_header(const Frame& frame, const PlanOptions& options, programmable::ExportWords& words,
                  bool keeps_shading) {
    if (std::ranges::none_of(frame.draws(), [](const Draw* draw) { return is_reversed(*draw); }))
        return Writer(frame, options, words, keeps_shading).header();
    Frame forward = frame;
    for (Draw* draw : forward.editable_draws())
        if (is_reversed(*draw)) reverse(*draw);
    return Writer(forward, options, words, keeps_shading).header();
}

WebglFrame webgl_frame(const Frame& frame, const PlanOptions& options) {
    programmable::ExportWords words;
    Json header = webgl_header(frame, options, words);
    return {std::move(header), std::move(words.all)};
}

}  // namespace twinlight::webgl
