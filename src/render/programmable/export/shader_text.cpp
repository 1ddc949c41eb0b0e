#include "render/programmable/export/shader_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "base/text/translation.h"
#include "render/programmable/numbers/precise.h"
#include "render/programmable/numbers/surface_values.h"
#include "render/programmable/text/bake.h"

namespace twinlight::programmable {
namespace {

std::string commented(const std::string& text) {
    std::string result;
    for (std::size_t at = 0, end; at < text.size(); at = end + 1) {
        end = std::min(text.find('\n', at), text.size());
        result += "//   " + text.substr(at, end - at) + "\n";
    }
    return result;
}

// The state of the Draw that shaders do not handle, if it differs from GL's initial state.
std::string fixed_stages_text(const Draw& draw, const Plan& plan) {
    const RasterState& raster = draw.raster;
    const FragmentState& fragment = draw.fragment;
    const PolygonOffset& offset = raster.polygon_offset;
    const std::pair<bool, const char*> rows[] = {
        {raster.depth_near != 0 || raster.depth_far != 1, "the depth range (glDepthRange)"},
        {raster.cull_enabled, "culling (glCullFace)"},
        {draw.draws_borders(), "the polygon mode (glPolygonMode)"},
        {offset.fill || offset.line || offset.point, "the polygon offset (glPolygonOffset)"},
        {raster.line_width != 1, "the line width (glLineWidth)"},
        {raster.point_size != 1 && !raster.point_parameters.attenuates(), "the point size (glPointSize)"},
        {raster.point_sprite, "point sprites (GL_POINT_SPRITE)"},
        {raster.line_smooth || raster.point_smooth, "smooth lines and points (GL_LINE_SMOOTH, GL_POINT_SMOOTH)"},
        {raster.line_stipple.has_value(), "the line stipple (glLineStipple)"},
        {raster.polygon_stipple != nullptr, "the polygon stipple (glPolygonStipple)"},
        {fragment.scissor.enabled, "the scissor (glScissor)"},
        {fragment.alpha_test, "the alpha test (glAlphaFunc; core GL has `discard`)"},
        {raster.depth_test, "the depth test (glDepthFunc)"},
        {fragment.blend, "blending (glBlendFunc, glBlendEquation)"},
        {fragment.logic_op.has_value(), "the logical operation (glLogicOp)"},
        {fragment.color_mask != FragmentState{}.color_mask, "the colour mask (glColorMask)"},
        {plan.effects.has_texture() || !plan.effects.units.empty(),
         "the texture's images, filters and wrapping (glTexParameter)"},
    };
    std::string text;
    for (const auto& [is_set, what] : rows)
        if (is_set) text += fmt::format("//   {}\n", what);
    return text.empty() ? "" : "// State that is set in GL, not in the shaders:\n" + text;
}

// Comments that list the program's effects and what the plan leaves out.
std::string heading(const Plan& plan, const Code& code) {
    std::string text = "// Effects of this draw:\n" + commented(describe(plan.effects));
    for (std::size_t i = 0; i < code.lights.size(); ++i) {
        std::vector<std::string> names;
        for (const std::size_t planned : code.lights[i]) names.push_back(light_name(plan.lights[planned].number));
        text += fmt::format("// light{} is {}.\n", i, fmt::join(names, ", "));
    }
    text += "// Left out, with the reasons:\n";
    for (const std::vector<LeftOut>& list : {plan.left_out, lights_left_out(plan)})
        for (const LeftOut& left_out : list) text += fmt::format("//   {}: {}\n", left_out.what, left_out.why);
    return text;
}

// --precise leaves nothing out.
std::string precise_heading(const LightingState& lighting, const Code& code) {
    std::string text = "// Effects of this draw:\n" + commented(describe(code.effects));
    int count = 0;
    for (std::size_t i = 0; i < lighting.lights.size(); ++i)
        if (lighting.enabled && lighting.lights[i].enabled)
            text += fmt::format("// light{} is {}.\n", count++, light_name(static_cast<int>(i)));
    return text;
}

std::string program_text(const Draw& draw, const Plan& plan, const Code& code, const Uniforms& numbers) {
    std::string text = code.form.precise ? precise_heading(plan.lighting, code) : heading(plan, code);
    text += fixed_stages_text(draw, plan);

    if (const auto& origin = code.origin_object)
        text += fmt::format("// a_position is relative to ({}, {}, {}), subtracted in double precision.\n", origin->x,
                            origin->y, origin->z);
    const ShaderSource source = assemble(code.effects, code.form);
    const auto names = uniform_names(source);
    text += "// Uniform values:\n";
    for (const std::string& name : names)
        if (const auto place = numbers.find(name))
            text += fmt::format("//   {} = {}\n", name, fmt::join(numbers[*place].values, " "));
    text += fmt::format("\n// ---- Vertex shader ----\n\n{}\n// ---- Fragment shader ----\n\n{}", source.vertex,
                        source.fragment);
    return text;
}

}  // namespace

std::string shader_source(const Frame& frame, const Options& asked) {
    const Options options = asked.precise ? precise_options(asked) : asked;
    // A program and its Draws; the first Draw provides the uniform values.
    struct Use {
        EffectSet effects;
        Form form;
        Place place;
        int number;
        std::string text;
        int others = 0;
    };
    std::vector<Use> uses;
    int number = 0;
    const auto add = [&](const Draw& draw, const Plan& plan, const Code& code, const Uniforms& numbers) {
        const auto same = std::ranges::find_if(
            uses, [&](const Use& use) { return use.effects == code.effects && use.form == code.form; });
        if (same != uses.end())
            ++same->others;
        else
            uses.push_back({.effects = code.effects,
                            .form = code.form,
                            .place = draw.place,
                            .number = number,
                            .text = program_text(draw, plan, code, numbers)});
    };
    const Draw* last = nullptr;
    for (const Draw* draw : frame.draws()) {
        ++number;
        if (options.shading != Shading::kExact || !draw->has_exact_surfaces()) {
            const Plan plan = plan_effects(*draw, options);
            const DrawProgram program = draw_program(*draw, plan, options.precise);
            add(*draw, plan, program.code, program.numbers);
        } else if (!last || !are_one_shape(*last, *draw)) {
            for (const SurfaceProgram& surface : surface_programs(*draw, options))
                add(surface.draw, surface.plan, surface.code, surface.passes.front());
        }
        last = draw;
    }
    std::string text;
    for (const Use& use : uses) {
        text += fmt::format("// ==== Draw {}, {}", use.number, use.place.str());
        if (use.others > 0) text += tr("; {} more draws use this program with other values", use.others);
        text += "\n" + use.text + "\n";
    }
    return text;
}

}  // namespace twinlight::programmable
