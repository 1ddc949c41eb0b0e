#include "render/programmable/programmable.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "render/context/context.h"
#include "render/context/gl.h"
#include "render/programmable/draw_values.h"
#include "render/programmable/kept_meshes.h"
#include "render/programmable/kept_programs.h"
#include "render/programmable/precise/precise.h"
#include "render/programmable/surface_values.h"
#include "render/programmable/uploaded_mesh.h"
#include "render/programmable/wide_range.h"
#include "render/stages/accumulation_buffer.h"
#include "render/stages/fixed_stages.h"
#include "render/stages/textures.h"
#include "scene/state/copied_texels.h"

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

using Item = std::variant<Clear, PreparedDraw, Accumulate>;

// Plans and uploads a frame's items, one after the other.
class Preparation {
  public:
    // Hands each item to `take`. kept: null if the frame shares no meshes with other frames. plans: gets the plan that
    // is best for each Draw by itself; null if nobody needs these.
    Preparation(const Frame& frame, Options options, KeptMeshes* kept, std::vector<PlannedDraw>* plans,
                const std::function<void(Item&&)>& take)
        : take_(take), plans_(plans), shares_programs_(!plans && has_many_draws(frame)) {
        if (options.precise) {
            options = precise_options(options);
            check_has_precise();
        }
        const Draw* last = nullptr;
        int number = 0;
        for (const auto& item : frame.items) {
            if (const Clear* clear = std::get_if<Clear>(&item)) {
                end_all(options, kept);
                take_(*clear);
                continue;
            }
            if (const Accumulate* accumulate = std::get_if<Accumulate>(&item)) {
                end_all(options, kept);
                take_(*accumulate);
                continue;
            }
            if (!std::holds_alternative<Draw>(item)) continue;  // a copy: see drawable()
            const Draw& draw = std::get<Draw>(item);
            ++number;
            if (draw.count() == 0) continue;
            const Numbered numbered{number, !last || !are_one_shape(*last, draw)};
            last = &draw;
            if (options.shading == Shading::kExact && draw.has_exact_surfaces()) {
                end_all(options, kept);
                if (numbered.begins_shape)
                    add_surfaces(draw, options, numbered);  // the first part draws the whole shape
            } else if (draw.pixels && draw.pixels->has_stencils) {
                end_all(options, kept);
                add_stencils(draw, options, kept, numbered);
            } else {
                if (!continues_run(draw)) end_run(options, kept);
                run_.push_back(&draw);
                run_numbers_.push_back(numbered);
                run_vertices_ += std::max(draw.vertices.size(), draw.indices.size());
            }
        }
        end_all(options, kept);
    }

  private:
    // What PlannedDraw says of a Draw besides its plan.
    struct Numbered {
        int number;
        bool begins_shape;
    };

    bool continues_run(const Draw& draw) const {
        return !run_.empty() &&
               run_vertices_ + std::max(draw.vertices.size(), draw.indices.size()) <= kMostJoinedVertices &&
               have_one_state(*run_.front(), draw);
    }

    // Adds the Draws of `run_`.
    void end_run(const Options& options, KeptMeshes* kept) {
        if (run_.empty()) return;
        const bool is_placed = kept && shares_programs_ && !options.precise && !options.for_any_pose &&
                               !(options.shading >= Shading::kPhong) && may_be_placed(run_);
        if (!placed_.empty() && !(is_placed && have_one_state_when_placed(*placed_.front(), *run_.front())))
            end_placed(options, *kept);
        if (is_placed)
            placed_.insert(placed_.end(), run_.begin(), run_.end());
        else if (kept)
            add_as_one(options, *kept);
        else
            add_one_by_one(options);
        run_.clear();
        run_numbers_.clear();
        run_vertices_ = 0;
    }

    void end_all(const Options& options, KeptMeshes* kept) {
        end_run(options, kept);
        if (!placed_.empty()) end_placed(options, *kept);
    }

    // Adds the Draws of `placed_`, without keeping their vertices: most of them move.
    void end_placed(const Options& options, KeptMeshes& kept) {
        const JoinedDraws all = placed_together(placed_);
        const Draw* const draw = &all.draw;
        Plan plan = plan_for({&draw, 1}, options, vertex_facts(*draw));
        std::optional<DrawProgram> program;
        if (!has_wide_range(*draw, plan)) program = draw_program(*draw, plan, options.precise);
        if (program && !program->code.form.homogeneous) {
            take_(PreparedDraw(*draw, std::move(*program),
                               [&](const EffectSet& effects, const glm::dvec3& origin_object) {
                                   return std::make_shared<const UploadedMesh>(all, effects, origin_object);
                               }));
        } else {
            for (const Draw*& one : placed_) add_kept({&one, 1}, {}, options, kept);
        }
        placed_.clear();
    }

    // Changing the program costs more time than lighting some vertices. So small Draws of a large frame are planned
    // by state only, and those that differ only in where things are get the same program.
    Plan plan_for(DrawRun draws, const Options& options, const VertexFacts& facts) const {
        const Draw& draw = *draws.front();
        constexpr std::size_t kFewVertices = 1024;
        const bool may_share =
            shares_programs_ && count_vertices(draws) <= kFewVertices && !(options.shading >= Shading::kPhong);
        if (!may_share || options.for_any_pose) return plan_effects(draw, options, facts);
        PlanOptions by_state = options;
        by_state.for_any_pose = true;
        return plan_effects(draw, by_state, facts);
    }

    // With one plan for all, unless numbers are too large or small for that (wide_range.h).
    void add_as_one(const Options& options, KeptMeshes& kept) {
        if (add_kept(run_, run_numbers_.front(), options, kept)) return;
        for (std::size_t i = 0; i < run_.size(); ++i)
            add_kept(DrawRun(run_).subspan(i, 1), run_numbers_[i], options, kept);
    }

    bool add_kept(DrawRun draws, const Numbered& numbered, const Options& options, KeptMeshes& kept) {
        const Draw& draw = *draws.front();
        const auto known = kept.known(draws);
        Plan plan = plan_for(draws, options, known->facts);
        if (draws.size() > 1 && has_wide_range(draws, plan)) return false;
        DrawProgram program = draw_program(draw, plan, options.precise);
        if (draws.size() > 1 && program.code.form.homogeneous) return false;
        take_(PreparedDraw(draw, std::move(program), [&](const EffectSet& effects, const glm::dvec3& origin_object) {
            return kept.mesh(*known, draws, effects, origin_object);
        }));
        keep(std::move(plan), draw, numbered);
        return true;
    }

    // With a plan for each. Those that have the same program and numbers are still uploaded and drawn as one, which
    // changes no bit of the picture.
    void add_one_by_one(const Options& options) {
        std::optional<DrawProgram> program;
        std::size_t first = 0;
        for (std::size_t i = 0; i < run_.size(); ++i) {
            Plan plan = plan_for(DrawRun(run_).subspan(i, 1), options, vertex_facts(*run_[i]));
            DrawProgram next = draw_program(*run_[i], plan, options.precise);
            keep(std::move(plan), *run_[i], run_numbers_[i]);
            if (program && !are_one_program(*program, next)) {
                add_with_program(DrawRun(run_).subspan(first, i - first), std::move(*program), options);
                first = i;
            }
            program = std::move(next);
        }
        add_with_program(DrawRun(run_).subspan(first), std::move(*program), options);
    }

    static bool are_one_program(const DrawProgram& a, const DrawProgram& b) {
        return a.code.effects == b.code.effects && a.code.form == b.code.form &&
               a.code.origin_object == b.code.origin_object && a.numbers == b.numbers;
    }

    void add_with_program(DrawRun draws, DrawProgram program, const Options& options) {
        const Draw& draw = *draws.front();
        take_(PreparedDraw(draw, std::move(program), [&](const EffectSet& effects, const glm::dvec3& origin_object) {
            return draws.size() > 1
                       ? std::make_shared<const UploadedMesh>(joined(draws), effects, origin_object)
                       : std::make_shared<const UploadedMesh>(draw, effects, options.patches, origin_object);
        }));
    }

    void add_surfaces(const Draw& draw, const Options& options, const Numbered& numbered) {
        for (SurfaceProgram& surface : surface_programs(draw, options)) {
            const auto rectangle =
                std::make_shared<const UploadedMesh>(surface.draw, surface.code.effects, false, glm::dvec3(0));
            for (const Uniforms& pass : surface.passes) take_(PreparedDraw(surface, pass, rectangle));
            keep(std::move(surface.plan), draw, numbered);
        }
    }

    void add_stencils(const Draw& draw, const Options& options, KeptMeshes* kept, Numbered numbered) {
        for (const Draw& one : by_stencil_value(draw)) {
            run_.push_back(&one);
            run_numbers_.push_back(numbered);
            run_vertices_ += one.vertices.size();
            end_all(options, kept);
            numbered.begins_shape = false;
        }
    }

    void keep(Plan plan, const Draw& draw, const Numbered& numbered) {
        if (plans_) plans_->push_back({numbered.number, draw.place, numbered.begins_shape, std::move(plan)});
    }

    static std::size_t count_vertices(DrawRun draws) {
        std::size_t count = 0;
        for (const Draw* draw : draws) count += draw->vertices.size();
        return count;
    }

    static bool has_many_draws(const Frame& frame) {
        constexpr int kManyDraws = 40;
        int count = 0;
        return std::ranges::any_of(frame.items, [&](const FrameItem& item) {
            return std::holds_alternative<Draw>(item) && ++count == kManyDraws;
        });
    }

    const std::function<void(Item&&)>& take_;
    std::vector<PlannedDraw>* const plans_;
    const bool shares_programs_;

    // Draws that will be drawn as one.
    std::vector<const Draw*> run_;  // have_one_state()
    std::vector<Numbered> run_numbers_;
    std::size_t run_vertices_ = 0;
    std::vector<const Draw*> placed_;  // small Draws after each other that will be placed and drawn as one
};

// Copies pixels (3.8.2) of pictures that the renderer draws.
DrawableFrame drawable(const Frame& frame, Renderer& renderer, const Options& options) {
    return {frame, [&](const Frame& picture, CopiedBuffer buffer) {
                const auto draw = [&] { renderer.draw(picture, options); };
                return CopySource{.picture = drawn_to_copy(picture, buffer, draw)};
            }};
}

}  // namespace

struct UploadedFrame::Impl {
    Impl(const Frame& frame, const Options& options) : tier(options.tier), width(frame.width), height(frame.height) {
        Preparation(frame, options, nullptr, nullptr, [this](Item&& item) { items.push_back(std::move(item)); });
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
        if (const auto* prepared = std::get_if<PreparedDraw>(&item)) return draw(*prepared);
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
    void draw(const PreparedDraw& prepared) {
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
        prepared.mesh->draw();
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

void Renderer::draw(const Frame& frame, const Options& options) {
    Options quick = options;
    quick.reasons = false;
    draw_once(frame, quick, nullptr);
}

Picture Renderer::render(const Frame& frame, const Options& options) {
    Picture picture;
    draw_once(frame, options, &picture.plans);
    picture.image = read_pixels(frame.width, frame.height);
    return picture;
}

// Each item is drawn as soon as it is prepared, so that a large frame needs no memory for all of them.
void Renderer::draw_once(const Frame& frame, Options options, std::vector<PlannedDraw>* plans) {
    options.patches = false;
    const DrawableFrame whole = drawable(frame, *this, options);
    Drawing drawing(*impl_, options.tier, frame.width, frame.height);
    Preparation(*whole, options, options.tier == Tier::kAuto ? &impl_->meshes : nullptr, plans,
                [&](Item&& item) { drawing.draw(item); });
    drawing.end();
}

Counters Renderer::counters() const {
    Counters counters = impl_->programs.counters();
    counters.textures = impl_->textures.upload_count();
    counters.meshes = impl_->meshes.counters();
    return counters;
}

}  // namespace twinlight::programmable
