#include "programmable/programmable.h"

#include <list>
#include <type_traits>
#include <variant>

#include "context/context.h"
#include "context/gl.h"
#include "programmable/draw_values.h"
#include "programmable/mesh.h"
#include "programmable/precise.h"
#include "programmable/programs.h"
#include "stages/fixed_stages.h"
#include "stages/textures.h"

namespace twinlight::programmable {
namespace {

// What is left of a Draw once it is planned and its vertices are the driver's.
struct PreparedDraw {
    PreparedDraw(const Draw& draw, const Plan& plan, const RenderOptions& options)
        : code(options.precise ? precise_code(draw, plan) : code_for(draw, plan)),
          numbers(options.precise ? precise_uniforms(draw, plan, code) : uniforms(draw, plan, code)),
          mesh(draw, code.effects, options) {
        stages.raster = draw.raster;
        stages.fragment = draw.fragment;
        stages.texture = draw.texture;
    }

    Code code;
    Uniforms numbers;
    Mesh mesh;
    Draw stages;  // without vertices: what is set as GL's state
};

}  // namespace

struct PreparedFrame::Impl {
    Impl(const Frame& frame, RenderOptions options) : tier(options.tier) {
        if (options.precise) {
            options = precise_options(options);
            check_has_precise();
        }
        for (const auto& item : frame.items) {
            if (const Clear* clear = std::get_if<Clear>(&item)) {
                items.emplace_back(*clear);
            } else if (const Draw& draw = std::get<Draw>(item); draw.count() > 0) {
                items.emplace_back(std::in_place_type<PreparedDraw>, draw, plan_effects(draw, options), options);
            }
        }
        glBindVertexArray(0);
        glBindBuffer(GL_ARRAY_BUFFER, 0);
    }

    Tier tier;
    std::list<std::variant<Clear, PreparedDraw>> items;
};

PreparedFrame::PreparedFrame(const Frame& frame, const RenderOptions& options)
    : impl_(std::make_unique<Impl>(frame, options)) {}
PreparedFrame::~PreparedFrame() = default;

struct Renderer::Impl {
    explicit Impl(std::size_t program_limit) : programs(program_limit) {}

    void draw(const PreparedDraw& what, const FixedStages& stages, Tier tier) {
        stages.set(what.stages);
        if (what.code.effects.has_texture()) textures.bind(what.stages.texture);
        programs.use(what.code.effects, what.code.form, what.numbers, tier);
        what.mesh.draw();
    }

    Programs programs;
    Textures textures{Clamping::kShader};
};

Renderer::Renderer(std::size_t program_limit) : impl_(std::make_unique<Impl>(program_limit)) {}
Renderer::~Renderer() = default;

void Renderer::draw(const PreparedFrame& frame) {
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
}

void Renderer::draw(const Frame& frame, const RenderOptions& options) { draw(PreparedFrame(frame, options)); }

Image Renderer::render(const Frame& frame, const RenderOptions& options) {
    draw(frame, options);
    return read_pixels(frame.width, frame.height);
}

Counters Renderer::counters() const { return impl_->programs.counters(); }

}  // namespace twinlight::programmable
