#include "render/programmable/programmable.h"

#include <algorithm>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "render/context/context.h"
#include "render/context/gl.h"
#include "render/programmable/image_rectangle.h"
#include "render/programmable/kept_meshes.h"
#include "render/programmable/kept_programs.h"
#include "render/programmable/numbers/draw_values.h"
#include "render/programmable/numbers/precise.h"
#include "render/programmable/numbers/surface_values.h"
#include "render/programmable/numbers/wide_range.h"
#include "render/programmable/precise_support.h"
#include "render/programmable/uploaded_mesh.h"
#include "render/stages/accumulation_buffer.h"
#include "render/stages/fixed_stages.h"
#include "render/stages/textures.h"
#include "scene/frame/copied_texels.h"

namespace twinlight::programmable {
namespace {

// A Draw after planning, with its vertices in the driver's buffers.
struct PreparedDraw {
    // mesh_of(effects, origin_object) returns the mesh.
    template <class MeshOf>
    PreparedDraw(const Draw& draw, DrawProgram program_of_draw, const MeshOf& mesh_of)
        : program(std::move(program_of_draw)),
          mesh(mesh_of(program.code.effects, program.code.origin_object.value_or(glm::dvec3(0)))),
          raster(draw.raster),
          fragment(draw.fragment),
          texture(draw.texture),
          units(combined_units(draw)) {}
    // One pass of an exact surface.
    PreparedDraw(const SurfaceProgram& surface, const Uniforms& pass, std::shared_ptr<const UploadedMesh> rectangle)
        : program{surface.code, pass},
          mesh(std::move(rectangle)),
          raster(surface.draw.raster),
          fragment(surface.draw.fragment),
          texture(surface.draw.texture) {}

    DrawProgram program;
    std::shared_ptr<const UploadedMesh> mesh;
    // The state that is set in GL.
    RasterState raster;
    FragmentState fragment;
    TextureUnit texture;
    TextureUnits units;  // if the Draw combines textures
};

// A range of a PreparedDraw: others may be drawn between two of them.
struct PreparedRange {
    std::shared_ptr<const PreparedDraw> draw;
    std::size_t range = 0;  // of its mesh
};

using Item = std::variant<Clear, PreparedRange, Accumulate>;

// Plans and uploads a frame's items, one after the other.
class Preparation {
  public:
    // Hands each item to `take`. kept: null if the frame shares no meshes with other frames.
    Preparation(const Frame& frame, const Options& options, KeptMeshes* kept, const std::function<void(Item&&)>& take)
        : take_(take),
          options_(options.precise ? precise_options(options) : options),
          kept_(kept),
          shares_programs_(has_many_draws(frame)),
          drawn_again_(may_place() ? std::optional<DepthRepeats>(frame) : std::nullopt) {
        if (options_.precise) check_has_precise();
        const Draw* last = nullptr;
        for (const auto& item : frame.items) {
            if (const Clear* clear = std::get_if<Clear>(&item)) {
                end_all();
                take_(*clear);
                continue;
            }
            if (const Accumulate* accumulate = std::get_if<Accumulate>(&item)) {
                end_all();
                take_(*accumulate);
                continue;
            }
            if (!std::holds_alternative<Draw>(item)) continue;  // a copy: see drawable()
            const Draw& draw = std::get<Draw>(item);
            if (draw.count() == 0) continue;
            const bool begins_shape = !last || !are_one_shape(*last, draw);
            last = &draw;
            if (options_.shading == Shading::kExact && draw.has_exact_surfaces()) {
                end_all();
                if (begins_shape) add_surfaces(draw);  // the first part draws the whole shape
            } else if (draw.pixels && draw.pixels->has_stencils) {
                end_all();
                add_stencils(draw, frame);
            } else if (draw.shows_only_image() && !options_.precise) {
                end_all();
                add_image(draw);
            } else if (draw.pixels && !lies_inside(*draw.pixels, frame)) {
                end_all();
                add_inside(draw, frame);
            } else {
                if (!continues_run(draw)) end_run();
                run_.push_back(&draw);
                run_vertices_ += std::max(draw.vertices.size(), draw.indices.size());
            }
        }
        end_all();
    }

  private:
    bool continues_run(const Draw& draw) const {
        return !run_.empty() &&
               run_vertices_ + std::max(draw.vertices.size(), draw.indices.size()) <= kMostJoinedVertices &&
               have_one_state(*run_.front(), draw);
    }

    // Adds the Draws of `run_`.
    void end_run() {
        if (run_.empty()) return;
        const bool is_placed = may_place() && may_be_placed(run_) && !drawn_again_->contains_any_of(run_);
        if (!is_placed) end_placed();
        if (is_placed)
            place_run();
        else
            add(run_);
        run_.clear();
        run_vertices_ = 0;
    }

    void end_all() {
        end_run();
        end_placed();
    }

    bool may_place() const {
        return shares_programs_ && options_.tier != Tier::kBaked && !options_.precise && !options_.for_any_pose &&
               !(options_.shading >= Shading::kPhong);
    }

    void place_run() {
        const auto has_its_state = [&](const std::vector<const Draw*>& placed) {
            return have_one_state_when_placed(*placed.front(), *run_.front());
        };
        auto placed = std::ranges::find_if(placed_, has_its_state);
        if (placed == placed_.end()) {
            constexpr std::size_t kMostStates = 8;  // each Draw is compared with all of them
            if (placed_.size() == kMostStates) end_placed();
            placed = placed_.emplace(placed_.end());
        }
        placed->insert(placed->end(), run_.begin(), run_.end());
        const auto state = static_cast<std::size_t>(placed - placed_.begin());
        if (placed_order_.empty() || placed_order_.back().state != state) placed_order_.push_back({state, 0});
        placed_order_.back().count += run_.size();
    }

    // Adds the Draws of `placed_`, without keeping their vertices: most of them move.
    void end_placed() {
        std::vector<JoinedDraws> joined;
        joined.reserve(placed_.size());
        for (const auto& draws : placed_) joined.push_back(placed_together(draws));
        std::vector<std::size_t> drawn(placed_.size());
        for (const auto& [state, count] : placed_order_) {
            joined[state].parts[drawn[state]].begins_range = true;
            drawn[state] += count;
        }
        std::vector<std::shared_ptr<const PreparedDraw>> prepared;
        prepared.reserve(placed_.size());
        for (const JoinedDraws& all : joined) prepared.push_back(prepared_together(all));
        drawn.assign(placed_.size(), 0);
        std::vector<std::size_t> ranges(placed_.size());
        for (const auto& [state, count] : placed_order_) {
            if (prepared[state]) {
                take_(PreparedRange{prepared[state], ranges[state]++});
            } else {
                add_placed(DrawRun(placed_[state]).subspan(drawn[state], count));
            }
            drawn[state] += count;
        }
        placed_.clear();
        placed_order_.clear();
    }

    void add_placed(DrawRun draws) {
        if (add_joined(placed_together(draws))) return;
        for (std::size_t i = 0; i < draws.size(); ++i) add(draws.subspan(i, 1));
    }

    // With one plan for all. Null if numbers are too large or small for that (wide_range.h).
    std::shared_ptr<const PreparedDraw> prepared_together(const JoinedDraws& all) const {
        const Draw* const draw = &all.draw;
        const Plan plan = plan_for({&draw, 1}, vertex_facts(*draw));
        if (has_wide_range(*draw, plan)) return nullptr;
        DrawProgram program = program_of(*draw, plan);
        if (program.code.form.homogeneous) return nullptr;
        const auto mesh_of = [&](const EffectSet& effects, const glm::dvec3& origin_object) {
            return std::make_shared<const UploadedMesh>(all, effects, origin_object);
        };
        return std::make_shared<const PreparedDraw>(*draw, std::move(program), mesh_of);
    }

    // Adds nothing and returns false where prepared_together() returns null.
    bool add_joined(const JoinedDraws& all) {
        std::shared_ptr<const PreparedDraw> prepared = prepared_together(all);
        if (!prepared) return false;
        take_(PreparedRange{std::move(prepared)});
        return true;
    }

    template <class... Arguments>
    void take(Arguments&&... arguments) {
        take_(PreparedRange{std::make_shared<const PreparedDraw>(std::forward<Arguments>(arguments)...)});
    }

    // What was planned for a Draw, and for others of its state.
    struct Planned {
        const Draw* draw;
        Plan plan;
        DrawProgram program;
    };

    bool plans_by_state(DrawRun draws) const {
        constexpr std::size_t kFewVertices = 1024;
        return shares_programs_ && count_vertices(draws) <= kFewVertices && !(options_.shading >= Shading::kPhong);
    }

    // Changing the program costs more time than lighting some vertices. So small Draws of a large frame are planned
    // by state only, and those that differ only in where things are get the same program.
    Plan plan_for(DrawRun draws, const VertexFacts& facts, const Planned* like = nullptr) const {
        if (like) {
            Plan plan = like->plan;
            plan.vertices = facts;
            return plan;
        }
        const Draw& draw = *draws.front();
        if (!plans_by_state(draws)) return plan_effects(draw, options_, facts);
        PlanOptions by_state = options_;
        by_state.for_any_pose = true;
        return plan_effects(draw, by_state, facts);
    }

    DrawProgram program_of(const Draw& draw, const Plan& plan, const Planned* like = nullptr) const {
        return draw_program(draw, plan, options_.precise, like ? &like->program : nullptr);
    }

    // Only of the frame's own Draws: by_stencil_value() and add_inside() make others, which are gone before the next ones.
    bool may_share_plan(DrawRun draws) const {
        const Draw& draw = *draws.front();
        return plans_by_state(draws) && !options_.precise && keeps_w(draw.eye_from_object) && !draw.pixels;
    }

    // Null if none of the last few Draws has the same plan.
    const Planned* like(DrawRun draws, const VertexFacts& facts) const {
        const Draw& draw = *draws.front();
        if (!may_share_plan(draws)) return nullptr;
        const auto found = std::ranges::find_if(planned_, [&](const Planned& planned) {
            return have_one_plan_by_state(planned.plan.vertices, facts) && have_one_state_anywhere(*planned.draw, draw);
        });
        return found == planned_.end() ? nullptr : &*found;
    }

    void note_planned(DrawRun draws, const Plan& plan, const DrawProgram& program) {
        if (!may_share_plan(draws)) return;
        constexpr std::size_t kFew = 4;
        if (planned_.size() == kFew) planned_.pop_back();
        planned_.push_front({draws.front(), plan, program});
    }

    // draws: with one state.
    void add(DrawRun draws) {
        if (!kept_) {
            constexpr std::size_t kManyVertices = 128;  // looking for fewer takes longer than to send them again
            if (draws.size() == 1 && draws.front()->vertices.size() >= kManyVertices && !options_.patches)
                return static_cast<void>(add_kept(draws, meshes_of_frame_));
            const bool may_join = draws.size() > 1 && shares_programs_ && options_.tier != Tier::kBaked;
            if (may_join && !options_.precise && add_joined(joined(draws))) return;
            return add_one_by_one(draws);
        }
        if (add_kept(draws, *kept_)) return;
        for (std::size_t i = 0; i < draws.size(); ++i) add_kept(draws.subspan(i, 1), *kept_);
    }

    // As add_joined(), but also of one Draw.
    bool add_kept(DrawRun draws, KeptMeshes& meshes) {
        const Draw& draw = *draws.front();
        const auto known = meshes.known(draws);
        const Planned* const planned = like(draws, known->facts);
        const Plan plan = plan_for(draws, known->facts, planned);
        if (draws.size() > 1 && has_wide_range(draws, plan)) return false;
        DrawProgram program = program_of(draw, plan, planned);
        if (draws.size() > 1 && program.code.form.homogeneous) return false;
        if (!planned) note_planned(draws, plan, program);
        take(draw, std::move(program), [&](const EffectSet& effects, const glm::dvec3& origin_object) {
            return meshes.mesh(*known, draws, effects, origin_object);
        });
        return true;
    }

    // With a plan for each. Those that have the same program and numbers are still uploaded and drawn as one, which
    // changes no bit of the picture.
    void add_one_by_one(DrawRun draws) {
        std::optional<DrawProgram> program;
        std::size_t first = 0;
        for (std::size_t i = 0; i < draws.size(); ++i) {
            DrawProgram next = program_of(*draws[i], plan_for(draws.subspan(i, 1), vertex_facts(*draws[i])));
            if (program && !are_one_program(*program, next)) {
                add_with_program(draws.subspan(first, i - first), std::move(*program));
                first = i;
            }
            program = std::move(next);
        }
        add_with_program(draws.subspan(first), std::move(*program));
    }

    static bool are_one_program(const DrawProgram& a, const DrawProgram& b) {
        return a.code.effects == b.code.effects && a.code.form == b.code.form &&
               a.code.origin_object == b.code.origin_object && a.numbers == b.numbers;
    }

    void add_with_program(DrawRun draws, DrawProgram program) {
        const Draw& draw = *draws.front();
        take(draw, std::move(program), [&](const EffectSet& effects, const glm::dvec3& origin_object) {
            return draws.size() > 1
                       ? std::make_shared<const UploadedMesh>(joined(draws), effects, origin_object)
                       : std::make_shared<const UploadedMesh>(draw, effects, options_.patches, origin_object);
        });
    }

    void add_surfaces(const Draw& draw) {
        for (const SurfaceProgram& surface : surface_programs(draw, options_)) {
            const auto rectangle =
                std::make_shared<const UploadedMesh>(surface.draw, surface.code.effects, false, glm::dvec3(0));
            for (const Uniforms& pass : surface.passes) take(surface, pass, rectangle);
        }
    }

    void add_stencils(const Draw& draw, const Frame& frame) {
        for (const Draw& one : by_stencil_value(draw)) add_inside(one, frame);
    }

    static bool lies_inside(const glm::ivec2& place, const Frame& frame) {
        return Rectangle{0, 0, frame.width, frame.height}.contains(place.x, place.y);
    }
    static bool lies_inside(const WindowPixels& pixels, const Frame& frame) {
        return std::ranges::all_of(pixels.places, [&](const glm::ivec2& place) { return lies_inside(place, frame); });
    }
    // Adds the pixels that lie in the window: softpipe draws points right above it in its highest row.
    void add_inside(const Draw& draw, const Frame& frame) {
        Draw inside = draw;
        std::vector<std::uint32_t> numbers;
        for (std::size_t i = 0; i < draw.pixels->places.size(); ++i)
            if (lies_inside(draw.pixels->places[i], frame)) numbers.push_back(static_cast<std::uint32_t>(i));
        if (numbers.empty()) return;
        inside.indices = std::move(numbers);
        const Draw* const only = &inside;
        add({&only, 1});
    }

    void add_image(const Draw& draw) {
        const Draw rectangle = as_textured_rectangle(draw);
        const Plan plan = plan_effects(rectangle, options_, vertex_facts(rectangle));
        take(rectangle, program_of(rectangle, plan), [&](const EffectSet& effects, const glm::dvec3& origin_object) {
            return std::make_shared<const UploadedMesh>(rectangle, effects, false, origin_object);
        });
    }

    static bool has_many_draws(const Frame& frame) {
        constexpr int kManyDraws = 40;
        int count = 0;
        return std::ranges::any_of(frame.items, [&](const FrameItem& item) {
            return std::holds_alternative<Draw>(item) && ++count == kManyDraws;
        });
    }

    const std::function<void(Item&&)>& take_;
    const Options options_;
    KeptMeshes* const kept_;
    const bool shares_programs_;
    const std::optional<DepthRepeats> drawn_again_;  // if Draws may be placed

    KeptMeshes meshes_of_frame_{std::size_t{64} << 20};  // the same display list may be called many times
    std::deque<Planned> planned_;                        // by state, of a few Draws of the frame
    // Draws that will be drawn as one.
    std::vector<const Draw*> run_;  // have_one_state()
    std::size_t run_vertices_ = 0;
    // Small Draws after each other that will be placed. Those of one state are planned and uploaded together, also where others lie
    // between them.
    struct PlacedRun {
        std::size_t state, count;  // in placed_, of its next Draws
    };
    std::vector<std::vector<const Draw*>> placed_;
    std::vector<PlacedRun> placed_order_;
};

// Copies pixels (3.8.2) of pictures that the renderer draws.
DrawableFrame drawable(const Frame& frame, Renderer& renderer, const Options& options) {
    return {frame, [&](const Frame& picture, CopiedBuffer buffer, const Rectangle& area) {
                return drawn_to_copy(picture, buffer, area, [&] { renderer.draw(picture, options); });
            }};
}

}  // namespace

struct UploadedFrame::Impl {
    Impl(const Frame& frame, const Options& options) : tier(options.tier), width(frame.width), height(frame.height) {
        Preparation(frame, options, nullptr, [this](Item&& item) { items.push_back(std::move(item)); });
        glBindVertexArray(0);
        glBindBuffer(GL_ARRAY_BUFFER, 0);
    }

    Tier tier;
    int width, height;
    std::vector<Item> items;
};

UploadedFrame::UploadedFrame(const Frame& frame, const Options& options) {
    if (!frame.copies_pixels) {
        impl_ = std::make_unique<Impl>(frame, options);
        return;
    }
    Renderer renderer;
    impl_ = std::make_unique<Impl>(*drawable(frame, renderer, options), options);
}
UploadedFrame::~UploadedFrame() = default;

struct Renderer::Impl {
    explicit Impl(const KeptLimits& limits) : programs(limits.programs), meshes(limits.mesh_bytes) {}

    KeptPrograms programs;
    KeptMeshes meshes;
    Textures textures{Clamping::kShader};
};

// Draws the items of a frame into the current colour buffer.
class Renderer::Drawing {
  public:
    Drawing(Renderer::Impl& renderer, Tier tier, int width, int height)
        : renderer_(renderer), tier_(tier), accumulation_(width, height) {
        stages_.clear_all();
    }

    void draw(const Item& item) {
        if (const auto* prepared = std::get_if<PreparedRange>(&item)) return draw(*prepared->draw, prepared->range);
        if (const auto* clear = std::get_if<Clear>(&item)) {
            stages_.clear(*clear);
            accumulation_.clear(*clear);
        } else {
            accumulation_.apply(std::get<Accumulate>(item));
        }
        raster_.reset();
        fragment_.reset();
    }
    void end() {
        renderer_.textures.drop_unused();
        renderer_.programs.end_frame();
        renderer_.meshes.end_frame();
    }

  private:
    void draw(const PreparedDraw& prepared, std::size_t range) {
        if (raster_ != prepared.raster) {
            FixedStages::set(prepared.raster, raster_ ? &*raster_ : nullptr);
            raster_ = prepared.raster;
        }
        if (fragment_ != prepared.fragment) {
            FixedStages::set(prepared.fragment, fragment_ ? &*fragment_ : nullptr);
            fragment_ = prepared.fragment;
        }
        const Code& code = prepared.program.code;
        if (code.effects.has_texture()) renderer_.textures.bind(prepared.texture);
        if (!prepared.units.empty()) renderer_.textures.bind_units(prepared.units);
        renderer_.programs.use(code.effects, code.form, prepared.program.numbers, tier_);
        prepared.mesh->draw(range);
        if (!prepared.units.empty()) Textures::release_units(prepared.units);
    }

    Renderer::Impl& renderer_;
    const Tier tier_;
    const FixedStages stages_;
    AccumulationBuffer accumulation_;
    // In GL; nothing: another state.
    std::optional<RasterState> raster_;
    std::optional<FragmentState> fragment_;
};

Renderer::Renderer(const KeptLimits& limits) : impl_(std::make_unique<Impl>(limits)) {}
Renderer::~Renderer() = default;

void Renderer::draw(const UploadedFrame& frame) {
    Drawing drawing(*impl_, frame.impl_->tier, frame.impl_->width, frame.impl_->height);
    for (const Item& item : frame.impl_->items) drawing.draw(item);
    drawing.end();
}

// Each item is drawn as soon as it is prepared, so that a large frame needs no memory for all of them.
void Renderer::draw(const Frame& frame, const Options& options) {
    Options quick = options;
    quick.reasons = false;
    quick.patches = false;
    const DrawableFrame whole = drawable(frame, *this, quick);
    Drawing drawing(*impl_, quick.tier, frame.width, frame.height);
    Preparation(*whole, quick, quick.tier == Tier::kAuto ? &impl_->meshes : nullptr,
                [&](Item&& item) { drawing.draw(item); });
    drawing.end();
}

Image Renderer::render(const Frame& frame, const Options& options) {
    draw(frame, options);
    return read_pixels(frame.width, frame.height);
}

void Renderer::allow_baking(bool is_allowed) { impl_->programs.allow_baking(is_allowed); }

bool Renderer::wants_to_bake() const { return impl_->programs.wants_to_bake(); }

Counters Renderer::counters() const {
    Counters counters = impl_->programs.counters();
    counters.textures = impl_->textures.upload_count();
    counters.meshes = impl_->meshes.counters();
    return counters;
}

}  // namespace twinlight::programmable
