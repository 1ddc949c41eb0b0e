#include "render/programmable/programmable.h"

#include <list>
#include <variant>

#include "render/context/context.h"
#include "render/context/gl.h"
#include "render/programmable/draw_values.h"
#include "render/programmable/kept_meshes.h"
#include "render/programmable/kept_programs.h"
#include "render/programmable/precise/precise.h"
#include "render/programmable/surface_values.h"
#include "render/programmable/uploaded_mesh.h"
#include "render/stages/fixed_stages.h"
#include "render/stages/textures.h"

namespace twinlight::programmable {
namespace {

// A Draw after planning, with its vertices in the driver's buffers.
struct PreparedDraw {
    // mesh_of(effects, origin_object) returns the mesh.
    template <class MeshOf>
    PreparedDraw(const Draw& draw, const Plan& plan, const Options& options, const MeshOf& mesh_of)
        : program(draw_program(draw, plan, options.precise)),
          mesh(mesh_of(program.code.effects, program.code.origin_object.value_or(glm::dvec3(0)))) {
        keep_state(draw);
    }
    // One pass of an exact surface.
    PreparedDraw(const SurfaceProgram& surface, const Uniforms& pass, std::shared_ptr<const UploadedMesh> rectangle)
        : program{surface.code, pass}, mesh(std::move(rectangle)) {
        keep_state(surface.draw);
    }

    void keep_state(const Draw& draw) {
        stages.raster = draw.raster;
        stages.fragment = draw.fragment;
        stages.texture = draw.texture;
    }

    DrawProgram program;
    std::shared_ptr<const UploadedMesh> mesh;
    Draw stages;  // without vertices: the state that is set in GL
};

}  // namespace

struct UploadedFrame::Impl {
    // kept: null if the frame shares no meshes with other frames.
    Impl(const Frame& frame, Options options, KeptMeshes* kept) : tier(options.tier) {
        if (options.precise) {
            options = precise_options(options);
            check_has_precise();
        }
        const Draw* last = nullptr;
        int number = 0;
        for (const auto& item : frame.items) {
            if (const Clear* clear = std::get_if<Clear>(&item)) {
                items.emplace_back(*clear);
                continue;
            }
            const Draw& draw = std::get<Draw>(item);
            ++number;
            if (draw.count() == 0) continue;
            const PlannedDraw place{number, draw.place, !last || !are_one_shape(*last, draw), {}};
            if (options.shading != Shading::kExact || !draw.has_exact_surfaces())
                add_mesh(draw, options, kept, place);
            else if (place.begins_shape)  // drawing the first part draws the whole shape
                add_surfaces(draw, options, place);
            last = &draw;
        }
        glBindVertexArray(0);
        glBindBuffer(GL_ARRAY_BUFFER, 0);
    }

    void add_mesh(const Draw& draw, const Options& options, KeptMeshes* kept, PlannedDraw planned) {
        const auto known = kept ? kept->known(draw) : nullptr;
        planned.plan = known ? plan_effects(draw, options, known->facts) : plan_effects(draw, options);
        items.emplace_back(
            PreparedDraw(draw, planned.plan, options, [&](const EffectSet& effects, const glm::dvec3& origin_object) {
                return known ? kept->mesh(*known, draw, effects, origin_object)
                             : std::make_shared<const UploadedMesh>(draw, effects, options.patches, origin_object);
            }));
        plans.push_back(std::move(planned));
    }

    void add_surfaces(const Draw& draw, const Options& options, const PlannedDraw& planned) {
        for (SurfaceProgram& surface : surface_programs(draw, options)) {
            const auto rectangle =
                std::make_shared<const UploadedMesh>(surface.draw, surface.code.effects, false, glm::dvec3(0));
            for (const Uniforms& pass : surface.passes) items.emplace_back(PreparedDraw(surface, pass, rectangle));
            plans.push_back(planned);
            plans.back().plan = std::move(surface.plan);
        }
    }

    Tier tier;
    std::vector<PlannedDraw> plans;
    std::list<std::variant<Clear, PreparedDraw>> items;
};

UploadedFrame::UploadedFrame(const Frame& frame, const Options& options)
    : impl_(std::make_unique<Impl>(frame, options, nullptr)) {}
UploadedFrame::UploadedFrame(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
UploadedFrame::~UploadedFrame() = default;

struct Renderer::Impl {
    explicit Impl(const KeptLimits& limits) : programs(limits.programs), meshes(limits.mesh_bytes) {}

    void draw(const PreparedDraw& prepared, const FixedStages& stages, Tier tier) {
        stages.set(prepared.stages);
        const Code& code = prepared.program.code;
        if (code.effects.has_texture()) textures.bind(prepared.stages.texture);
        programs.use(code.effects, code.form, prepared.program.numbers, tier);
        prepared.mesh->draw();
    }

    KeptPrograms programs;
    KeptMeshes meshes;
    Textures textures{Clamping::kShader};
};

Renderer::Renderer(const KeptLimits& limits) : impl_(std::make_unique<Impl>(limits)) {}
Renderer::~Renderer() = default;

void Renderer::draw(const UploadedFrame& frame) {
    const FixedStages stages;
    stages.clear({.color = true, .depth = true, .clear_color = glm::dvec4(0), .clear_depth = 1});
    for (const auto& item : frame.impl_->items) {
        if (const Clear* clear = std::get_if<Clear>(&item))
            stages.clear(*clear);
        else
            impl_->draw(std::get<PreparedDraw>(item), stages, frame.impl_->tier);
    }
    impl_->textures.drop_unused();
    impl_->programs.end_frame();
    impl_->meshes.end_frame();
}

void Renderer::draw(const Frame& frame, const Options& options) { draw(prepare_once(frame, options)); }

Picture Renderer::render(const Frame& frame, const Options& options) {
    const UploadedFrame prepared = prepare_once(frame, options);
    draw(prepared);
    return {read_pixels(frame.width, frame.height), std::move(prepared.impl_->plans)};
}

UploadedFrame Renderer::prepare_once(const Frame& frame, Options options) {
    options.patches = false;
    KeptMeshes* kept = options.tier == Tier::kAuto ? &impl_->meshes : nullptr;
    return UploadedFrame(std::make_unique<UploadedFrame::Impl>(frame, options, kept));
}

Counters Renderer::counters() const {
    Counters counters = impl_->programs.counters();
    counters.textures = impl_->textures.upload_count();
    counters.meshes = impl_->meshes.counters();
    return counters;
}

}  // namespace twinlight::programmable
