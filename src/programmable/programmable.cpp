#include "programmable/programmable.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <type_traits>
#include <utility>
#include <vector>

#include "context/context.h"
#include "context/gl.h"
#include "programmable/attributes.h"
#include "stages/fixed_stages.h"
#include "programmable/program.h"
#include "stages/textures.h"

namespace twinlight::programmable {
namespace {

// 2.6.2: edge flags count where polygons are drawn as their edges or corners, and only of these.
bool needs_edge_flags(const Draw& draw) {
    const RasterState& raster = draw.raster;
    const bool has_edges = draw.mode == kGL_TRIANGLES || draw.mode == kGL_QUADS || draw.mode == kGL_POLYGON;
    const bool filled = raster.polygon_mode_front == kGL_FILL && raster.polygon_mode_back == kGL_FILL;
    return has_edges && !filled && !std::ranges::all_of(draw.vertices, &Vertex::edge_flag);
}

const void* buffer_offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }  // NOLINT: GL's offset

template <class Value>
void fill_buffer(GLenum target, GLuint buffer, const std::vector<Value>& values) {
    glBindBuffer(target, buffer);
    glBufferData(target, static_cast<GLsizeiptr>(values.size() * sizeof(Value)), values.data(), GL_STREAM_DRAW);
}

}  // namespace

struct Renderer::Impl {
    Impl() {
        glGenVertexArrays(1, &vertex_array);
        for (GLuint* buffer : {&vertices, &edge_flags, &indices}) glGenBuffers(1, buffer);
    }
    ~Impl() {
        for (GLuint* buffer : {&vertices, &edge_flags, &indices}) glDeleteBuffers(1, buffer);
        glDeleteVertexArrays(1, &vertex_array);
    }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    void draw(const Draw& draw, const RenderOptions& options, const FixedStages& stages) {
        if (draw.count() == 0) return;
        const Plan plan = plan_effects(draw, options);
        const Program& program = programs.try_emplace(plan.effects, plan.effects).first->second;
        stages.set(draw);
        if (plan.effects.has_texture()) textures.bind(draw.texture);
        program.use(uniforms(draw, plan));
        set_vertices(draw, plan.effects);
        set_edge_flags(draw);
        const auto count = static_cast<GLsizei>(draw.count());
        if (draw.indices.empty()) {
            glDrawArrays(draw.mode, 0, count);
        } else {
            fill_buffer(GL_ELEMENT_ARRAY_BUFFER, indices, draw.indices);
            glDrawElements(draw.mode, count, GL_UNSIGNED_INT, nullptr);
        }
    }

    void set_vertices(const Draw& draw, const EffectSet& effects) {
        fill_buffer(GL_ARRAY_BUFFER, vertices, programmable::vertex_array(draw, effects));
        const std::vector<Attribute> list = attributes(effects);
        std::size_t floats = 0;
        for (const Attribute& attribute : list) floats += static_cast<std::size_t>(attribute.size);
        const auto stride = static_cast<GLsizei>(floats * sizeof(float));
        std::size_t offset = 0;
        GLuint index = 0;
        for (const Attribute& attribute : list) {
            glEnableVertexAttribArray(index);
            glVertexAttribPointer(index++, attribute.size, GL_FLOAT, GL_FALSE, stride, buffer_offset(offset));
            offset += static_cast<std::size_t>(attribute.size) * sizeof(float);
        }
        for (GLuint other = index; other < enabled_attributes; ++other) glDisableVertexAttribArray(other);
        enabled_attributes = index;
    }

    // They pass every program by: GL has no attribute of shaders for them.
    void set_edge_flags(const Draw& draw) const {
        if (!needs_edge_flags(draw)) return glDisableClientState(GL_EDGE_FLAG_ARRAY);
        std::vector<GLboolean> flags;
        for (const Vertex& vertex : draw.vertices) flags.push_back(vertex.edge_flag);
        fill_buffer(GL_ARRAY_BUFFER, edge_flags, flags);
        glEnableClientState(GL_EDGE_FLAG_ARRAY);
        glEdgeFlagPointer(0, nullptr);
    }

    std::map<EffectSet, Program> programs;
    Textures textures{Clamping::kShader};
    GLuint enabled_attributes = 0;
    GLuint vertex_array = 0;
    GLuint vertices = 0;
    GLuint edge_flags = 0;
    GLuint indices = 0;
};

Renderer::Renderer() : impl_(std::make_unique<Impl>()) {}
Renderer::~Renderer() = default;

void Renderer::draw(const Frame& frame, const RenderOptions& options) {
    const FixedStages stages;
    stages.clear({.color = true, .depth = true, .clear_color = glm::dvec4(0), .clear_depth = 1});
    glBindVertexArray(impl_->vertex_array);
    for (const auto& item : frame.items)
        std::visit(
            [&](const auto& what) {
                if constexpr (std::is_same_v<std::decay_t<decltype(what)>, Clear>)
                    stages.clear(what);
                else
                    impl_->draw(what, options, stages);
            },
            item);
    impl_->textures.drop_unused();
}

Image Renderer::render(const Frame& frame, const RenderOptions& options) {
    draw(frame, options);
    return read_pixels(frame.width, frame.height);
}

// ---- The text, without a context ----

namespace {

std::string commented(const std::string& text) {
    std::string result;
    for (std::size_t at = 0, end; at < text.size(); at = end + 1) {
        end = std::min(text.find('\n', at), text.size());
        result += "//   " + text.substr(at, end - at) + "\n";
    }
    return result;
}

// What of the Draw no shader does, as far as it is not GL's initial state.
std::string fixed_stages_text(const Draw& draw, const Plan& plan) {
    const RasterState& raster = draw.raster;
    const FragmentState& fragment = draw.fragment;
    const PolygonOffset& offset = raster.polygon_offset;
    const std::pair<bool, const char*> rows[] = {
        {raster.depth_near != 0 || raster.depth_far != 1, "the depth range (glDepthRange)"},
        {raster.cull_enabled, "culling (glCullFace)"},
        {raster.polygon_mode_front != kGL_FILL || raster.polygon_mode_back != kGL_FILL,
         "the polygon mode (glPolygonMode)"},
        {offset.fill || offset.line || offset.point, "the polygon offset (glPolygonOffset)"},
        {raster.line_width != 1, "the line width (glLineWidth)"},
        {raster.point_size != 1, "the point size (glPointSize)"},
        {fragment.scissor.enabled, "the scissor (glScissor)"},
        {fragment.alpha_test, "the alpha test (glAlphaFunc; core GL has `discard`)"},
        {raster.depth_test, "the depth test (glDepthFunc)"},
        {fragment.blend, "blending (glBlendFunc, glBlendEquation)"},
        {fragment.color_mask != FragmentState{}.color_mask, "the colour mask (glColorMask)"},
        {plan.effects.has_texture(), "the texture's images, filters and wrapping (glTexParameter)"},
    };
    std::string text;
    for (const auto& [is_set, what] : rows)
        if (is_set) text += fmt::format("//   {}\n", what);
    return text.empty() ? "" : "// What stays GL's state:\n" + text;
}

std::string program_text(const Draw& draw, const Plan& plan) {
    std::string text = "// What lights this Draw:\n" + commented(describe(plan.effects));
    for (std::size_t i = 0; i < plan.lights.size(); ++i)
        text += fmt::format("// light{} is {}.\n", i, light_name(plan.lights[i].number));
    text += "// What is left out:\n";
    for (const std::vector<LeftOut>& list : {plan.left_out, lights_left_out(plan)})
        for (const LeftOut& left_out : list) text += fmt::format("//   {}: {}\n", left_out.what, left_out.why);

    text += fixed_stages_text(draw, plan);

    const ShaderSource source = assemble(plan.effects);
    text += "// The uniforms' values:\n";
    for (const auto& [name, values] : uniforms(draw, plan))
        if (source.vertex.find(name + ";") != source.vertex.npos ||
            source.fragment.find(name + ";") != source.fragment.npos)
            text += fmt::format("//   {} = {}\n", name, fmt::join(values, " "));
    text += fmt::format("\n// ---- Vertex shader ----\n\n{}\n// ---- Fragment shader ----\n\n{}", source.vertex,
                        source.fragment);
    return text;
}

}  // namespace

std::string shader_source(const Frame& frame, const RenderOptions& options) {
    // The Draws of each program; the first of them gives the values.
    struct Use {
        const Draw* first;
        int number;
        int others = 0;
        Plan plan;
    };
    std::vector<Use> uses;
    int number = 0;
    for (const auto& item : frame.items) {
        const Draw* draw = std::get_if<Draw>(&item);
        if (!draw) continue;
        ++number;
        Plan plan = plan_effects(*draw, options);
        const auto same = std::ranges::find_if(uses, [&](const Use& use) { return use.plan.effects == plan.effects; });
        if (same != uses.end())
            ++same->others;
        else
            uses.push_back({.first = draw, .number = number, .plan = std::move(plan)});
    }
    std::string text;
    for (const Use& use : uses) {
        text += fmt::format("// ==== Draw {}, {}", use.number, use.first->place.str());
        if (use.others > 0) text += fmt::format("; {} more with other values", use.others);
        text += "\n" + program_text(*use.first, use.plan) + "\n";
    }
    return text;
}

}  // namespace twinlight::programmable
