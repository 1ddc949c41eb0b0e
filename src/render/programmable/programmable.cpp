#include "render/programmable/programmable.h"

#include <algorithm>
#include <list>
#include <optional>
#include <utility>
#include <variant>

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

}  // namespace

struct UploadedFrame::Impl {
    // What PlannedDraw says of a Draw besides its plan.
    struct Numbered {
        int number;
        bool begins_shape;
    };

    // kept: null if the frame shares no meshes with other frames. keeps_plans: `plans` has the plan that is best for
    // each Draw by itself.
    Impl(const Frame& frame, Options options, KeptMeshes* kept, bool plans_are_kept)
        : tier(options.tier),
          width(frame.width),
          height(frame.height),
          keeps_plans(plans_are_kept),
          shares_programs(!plans_are_kept && frame.draws().size() >= kManyDraws) {
        if (options.precise) {
            options = precise_options(options);
            check_has_precise();
        }
        const Draw* last = nullptr;
        int number = 0;
        for (const auto& item : frame.items) {
            if (const Clear* clear = std::get_if<Clear>(&item)) {
                end_all(options, kept);
                items.emplace_back(*clear);
                continue;
            }
            if (const Accumulate* accumulate = std::get_if<Accumulate>(&item)) {
                end_all(options, kept);
                items.emplace_back(*accumulate);
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
            } else {
                if (!continues_run(draw)) end_run(options, kept);
                run.push_back(&draw);
                run_numbers.push_back(numbered);
                run_vertices += std::max(draw.vertices.size(), draw.indices.size());
            }
        }
        end_all(options, kept);
        glBindVertexArray(0);
        glBindBuffer(GL_ARRAY_BUFFER, 0);
    }

    bool continues_run(const Draw& draw) const {
        return !run.empty() &&
               run_vertices + std::max(draw.vertices.size(), draw.indices.size()) <= kMostJoinedVertices &&
               have_one_state(*run.front(), draw);
    }

    // Adds the Draws of `run`.
    void end_run(const Options& options, KeptMeshes* kept) {
        if (run.empty()) return;
        const bool is_placed = kept && shares_programs && !options.precise && !options.for_any_pose &&
                               !(options.shading >= Shading::kPhong) && may_be_placed(run);
        if (!placed.empty() && !(is_placed && have_one_state_when_placed(*placed.front(), *run.front())))
            end_placed(options, *kept);
        if (is_placed)
            placed.insert(placed.end(), run.begin(), run.end());
        else if (kept)
            add_as_one(options, *kept);
        else
            add_one_by_one(options);
        run.clear();
        run_numbers.clear();
        run_vertices = 0;
    }

    void end_all(const Options& options, KeptMeshes* kept) {
        end_run(options, kept);
        if (!placed.empty()) end_placed(options, *kept);
    }

    // Adds the Draws of `placed`, without keeping their vertices: most of them move.
    void end_placed(const Options& options, KeptMeshes& kept) {
        const JoinedDraws all = placed_together(placed);
        const Draw* const draw = &all.draw;
        Plan plan = plan_for({&draw, 1}, options, vertex_facts(*draw));
        std::optional<DrawProgram> program;
        if (!has_wide_range(*draw, plan)) program = draw_program(*draw, plan, options.precise);
        if (program && !program->code.form.homogeneous) {
            items.emplace_back(std::in_place_type<PreparedDraw>, *draw, std::move(*program),
                               [&](const EffectSet& effects, const glm::dvec3& origin_object) {
                                   return std::make_shared<const UploadedMesh>(all, effects, origin_object);
                               });
        } else {
            for (const Draw*& one : placed) add_kept({&one, 1}, {}, options, kept);
        }
        placed.clear();
    }

    // Changing the program costs more time than lighting some vertices. So small Draws of a large frame are planned
    // by state only, and those that differ only in where things are get the same program.
    Plan plan_for(DrawRun draws, const Options& options, const VertexFacts& facts) const {
        const Draw& draw = *draws.front();
        constexpr std::size_t kFewVertices = 256;
        const bool may_share =
            shares_programs && count_vertices(draws) <= kFewVertices && !(options.shading >= Shading::kPhong);
        if (!may_share || options.for_any_pose) return plan_effects(draw, options, facts);
        PlanOptions by_state = options;
        by_state.for_any_pose = true;
        return plan_effects(draw, by_state, facts);
    }

    // With one plan for all, unless numbers are too large or small for that (wide_range.h).
    void add_as_one(const Options& options, KeptMeshes& kept) {
        if (add_kept(run, run_numbers.front(), options, kept)) return;
        for (std::size_t i = 0; i < run.size(); ++i)
            add_kept(DrawRun(run).subspan(i, 1), run_numbers[i], options, kept);
    }

    bool add_kept(DrawRun draws, const Numbered& numbered, const Options& options, KeptMeshes& kept) {
        const Draw& draw = *draws.front();
        const auto known = kept.known(draws);
        Plan plan = plan_for(draws, options, known->facts);
        if (draws.size() > 1 && has_wide_range(draws, plan)) return false;
        DrawProgram program = draw_program(draw, plan, options.precise);
        if (draws.size() > 1 && program.code.form.homogeneous) return false;
        items.emplace_back(std::in_place_type<PreparedDraw>, draw, std::move(program),
                           [&](const EffectSet& effects, const glm::dvec3& origin_object) {
                               return kept.mesh(*known, draws, effects, origin_object);
                           });
        keep(std::move(plan), draw, numbered);
        return true;
    }

    // With a plan for each. Those that have the same program and numbers are still uploaded and drawn as one, which
    // changes no bit of the picture.
    void add_one_by_one(const Options& options) {
        std::optional<DrawProgram> program;
        std::size_t first = 0;
        for (std::size_t i = 0; i < run.size(); ++i) {
            Plan plan = plan_for(DrawRun(run).subspan(i, 1), options, vertex_facts(*run[i]));
            DrawProgram next = draw_program(*run[i], plan, options.precise);
            keep(std::move(plan), *run[i], run_numbers[i]);
            if (program && !are_one_program(*program, next)) {
                add_with_program(DrawRun(run).subspan(first, i - first), std::move(*program), options);
                first = i;
            }
            program = std::move(next);
        }
        add_with_program(DrawRun(run).subspan(first), std::move(*program), options);
    }

    static bool are_one_program(const DrawProgram& a, const DrawProgram& b) {
        return a.code.effects == b.code.effects && a.code.form == b.code.form &&
               a.code.origin_object == b.code.origin_object && a.numbers == b.numbers;
    }

    void add_with_program(DrawRun draws, DrawProgram program, const Options& options) {
        const Draw& draw = *draws.front();
        items.emplace_back(std::in_place_type<PreparedDraw>, draw, std::move(program),
                           [&](const EffectSet& effects, const glm::dvec3& origin_object) {
                               return draws.size() > 1
                                          ? std::make_shared<const UploadedMesh>(joined(draws), effects, origin_object)
                                          : std::make_shared<const UploadedMesh>(draw, effects, options.patches,
                                                                                 origin_object);
                           });
    }

    void add_surfaces(const Draw& draw, const Options& options, const Numbered& numbered) {
        for (SurfaceProgram& surface : surface_programs(draw, options)) {
            const auto rectangle =
                std::make_shared<const UploadedMesh>(surface.draw, surface.code.effects, false, glm::dvec3(0));
            for (const Uniforms& pass : surface.passes) items.emplace_back(PreparedDraw(surface, pass, rectangle));
            keep(std::move(surface.plan), draw, numbered);
        }
    }

    void keep(Plan plan, const Draw& draw, const Numbered& numbered) {
        if (keeps_plans) plans.push_back({numbered.number, draw.place, numbered.begins_shape, std::move(plan)});
    }

    static std::size_t count_vertices(DrawRun draws) {
        std::size_t count = 0;
        for (const Draw* draw : draws) count += draw->vertices.size();
        return count;
    }

    static constexpr std::size_t kManyDraws = 40;

    Tier tier;
    int width, height;
    bool keeps_plans, shares_programs;
    std::vector<PlannedDraw> plans;
    std::list<std::variant<Clear, PreparedDraw, Accumulate>> items;

    // While the frame is prepared: Draws that will be drawn as one.
    std::vector<const Draw*> run;  // have_one_state()
    std::vector<Numbered> run_numbers;
    std::size_t run_vertices = 0;
    std::vector<const Draw*> placed;  // small Draws after each other that will be placed and drawn as one
};

namespace {

// Copies pixels (3.8.2) of pictures that the renderer draws into the current colour buffer.
DrawableFrame drawable(const Frame& frame, Renderer& renderer, const Options& options) {
    return {frame, [&](const Frame& picture) {
                renderer.draw(picture, options);
                return CopySource{.picture = read_pixels(picture.width, picture.height)};
            }};
}

}  // namespace

UploadedFrame::UploadedFrame(const Frame& frame, const Options& options) {
    if (!frame.copies_pixels) {
        impl_ = std::make_unique<Impl>(frame, options, nullptr, false);
        return;
    }
    Renderer renderer;
    impl_ = std::make_unique<Impl>(*drawable(frame, renderer, options), options, nullptr, false);
}
UploadedFrame::UploadedFrame(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
UploadedFrame::~UploadedFrame() = default;

struct Renderer::Impl {
    explicit Impl(const KeptLimits& limits) : programs(limits.programs), meshes(limits.mesh_bytes) {}

    // `last`: the Draw that was drawn just before; null after another item.
    void draw(const PreparedDraw& prepared, const PreparedDraw* last, Tier tier) {
        if (!last || last->raster != prepared.raster || last->fragment != prepared.fragment)
            FixedStages::set(prepared.raster, prepared.fragment);
        const Code& code = prepared.program.code;
        if (code.effects.has_texture()) textures.bind(prepared.texture);
        if (!prepared.units.empty()) textures.bind_units(prepared.units);
        programs.use(code.effects, code.form, prepared.program.numbers, tier);
        prepared.mesh->draw();
        if (!prepared.units.empty()) Textures::release_units(prepared.units);
    }

    KeptPrograms programs;
    KeptMeshes meshes;
    Textures textures{Clamping::kShader};
};

Renderer::Renderer(const KeptLimits& limits) : impl_(std::make_unique<Impl>(limits)) {}
Renderer::~Renderer() = default;

void Renderer::draw(const UploadedFrame& frame) {
    const FixedStages stages;
    stages.clear_all();
    AccumulationBuffer accumulation(frame.impl_->width, frame.impl_->height);
    const PreparedDraw* last = nullptr;
    for (const auto& item : frame.impl_->items) {
        const auto* prepared = std::get_if<PreparedDraw>(&item);
        if (prepared) {
            impl_->draw(*prepared, last, frame.impl_->tier);
        } else if (const Clear* clear = std::get_if<Clear>(&item)) {
            stages.clear(*clear);
            accumulation.clear(*clear);
        } else {
            accumulation.apply(std::get<Accumulate>(item));
        }
        last = prepared;
    }
    impl_->textures.drop_unused();
    impl_->programs.end_frame();
    impl_->meshes.end_frame();
}

void Renderer::draw(const Frame& frame, const Options& options) {
    Options quick = options;
    quick.reasons = false;
    draw(prepare_once(frame, quick, false));
}

Picture Renderer::render(const Frame& frame, const Options& options) {
    const UploadedFrame prepared = prepare_once(frame, options, true);
    draw(prepared);
    return {read_pixels(frame.width, frame.height), std::move(prepared.impl_->plans)};
}

UploadedFrame Renderer::prepare_once(const Frame& frame, Options options, bool keeps_plans) {
    options.patches = false;
    const DrawableFrame whole = drawable(frame, *this, options);
    KeptMeshes* kept = options.tier == Tier::kAuto ? &impl_->meshes : nullptr;
    return UploadedFrame(std::make_unique<UploadedFrame::Impl>(*whole, options, kept, keeps_plans));
}

Counters Renderer::counters() const {
    Counters counters = impl_->programs.counters();
    counters.textures = impl_->textures.upload_count();
    counters.meshes = impl_->meshes.counters();
    return counters;
}

}  // namespace twinlight::programmable
