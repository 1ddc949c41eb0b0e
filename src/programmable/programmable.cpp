#include "programmable/programmable.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <type_traits>
#include <utility>
#include <vector>

#include "context/context.h"
#include "context/gl.h"
#include "programmable/program.h"

namespace twinlight::programmable {
namespace {

// The rasteriser's state and the clear values, put back at the end of the scope; no program, no arrays, no
// buffers left.
class StateGuard {
  public:
    StateGuard() {
        glPushAttrib(GL_VIEWPORT_BIT | GL_DEPTH_BUFFER_BIT | GL_POLYGON_BIT | GL_COLOR_BUFFER_BIT | GL_ENABLE_BIT);
    }
    ~StateGuard() {
        glUseProgram(0);
        glBindVertexArray(0);
        glBindBuffer(GL_ARRAY_BUFFER, 0);
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
        glPopAttrib();
    }
    StateGuard(const StateGuard&) = delete;
    StateGuard& operator=(const StateGuard&) = delete;
};

void set_enabled(GLenum capability, bool enabled) { (enabled ? glEnable : glDisable)(capability); }

void set_raster(const RasterState& raster) {
    const Viewport& v = raster.viewport;
    glViewport(v.x, v.y, v.width, v.height);
    glFrontFace(raster.front_face);
    set_enabled(GL_CULL_FACE, raster.cull_enabled);
    glCullFace(raster.cull_face);
    glPolygonMode(GL_FRONT, raster.polygon_mode_front);
    glPolygonMode(GL_BACK, raster.polygon_mode_back);
    set_enabled(GL_DEPTH_TEST, raster.depth_test);
    glDepthFunc(raster.depth_func);
    glDepthMask(raster.depth_mask);
}

void clear(const Clear& what) {
    const glm::vec4 color(what.clear_color);
    glClearColor(color.r, color.g, color.b, color.a);
    glClearDepth(what.clear_depth);
    glDepthMask(GL_TRUE);
    glClear((what.color ? GL_COLOR_BUFFER_BIT : 0u) | (what.depth ? GL_DEPTH_BUFFER_BIT : 0u));
}

// Everything else that a scene's commands leave in the context and that would change a picture.
void set_defaults() {
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    for (GLenum capability : {GL_BLEND, GL_ALPHA_TEST, GL_STENCIL_TEST, GL_SCISSOR_TEST, GL_COLOR_LOGIC_OP})
        glDisable(capability);
}

}  // namespace

struct Renderer::Impl {
    Impl() {
        glGenVertexArrays(1, &vertex_array);
        glGenBuffers(1, &vertices);
        glGenBuffers(1, &indices);
    }
    ~Impl() {
        glDeleteBuffers(1, &indices);
        glDeleteBuffers(1, &vertices);
        glDeleteVertexArrays(1, &vertex_array);
    }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    void draw(const Draw& draw, const RenderOptions& options) {
        if (draw.count() == 0) return;
        const Plan plan = plan_effects(draw, options);
        const Program& program = programs.try_emplace(plan.effects, plan.effects).first->second;
        set_raster(draw.raster);
        program.use(uniforms(draw, plan));
        upload(programmable::vertex_array(draw, plan.effects));
        const auto count = static_cast<GLsizei>(draw.count());
        if (draw.indices.empty()) {
            glDrawArrays(draw.mode, 0, count);
        } else {
            glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices);
            glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(draw.indices.size() * sizeof draw.indices[0]),
                         draw.indices.data(), GL_STREAM_DRAW);
            glDrawElements(draw.mode, count, GL_UNSIGNED_INT, nullptr);
        }
    }

    void upload(const VertexArray& array) const {
        glBindBuffer(GL_ARRAY_BUFFER, vertices);
        glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(array.values.size() * sizeof(float)), array.values.data(),
                     GL_STREAM_DRAW);
        const auto attribute = [&](Attribute index, int size, int offset) {
            if (offset < 0) return glDisableVertexAttribArray(index);
            glEnableVertexAttribArray(index);
            glVertexAttribPointer(
                index, size, GL_FLOAT, GL_FALSE,
                static_cast<GLsizei>(static_cast<std::size_t>(array.floats_per_vertex) * sizeof(float)),
                reinterpret_cast<const void*>(static_cast<std::uintptr_t>(offset) *
                                              sizeof(float)));  // NOLINT: GL's offset
        };
        attribute(kPosition, 4, 0);
        attribute(kNormal, 3, array.normal_offset);
        attribute(kColor, 4, array.color_offset);
    }

    std::map<EffectSet, Program> programs;
    GLuint vertex_array = 0;
    GLuint vertices = 0;
    GLuint indices = 0;
};

Renderer::Renderer() : impl_(std::make_unique<Impl>()) {}
Renderer::~Renderer() = default;

void Renderer::draw(const Frame& frame, const RenderOptions& options) {
    const StateGuard guard;
    set_defaults();
    clear({.color = true, .depth = true, .clear_color = glm::dvec4(0), .clear_depth = 1});
    glBindVertexArray(impl_->vertex_array);
    for (const auto& item : frame.items)
        std::visit(
            [&](const auto& what) {
                if constexpr (std::is_same_v<std::decay_t<decltype(what)>, Clear>)
                    clear(what);
                else
                    impl_->draw(what, options);
            },
            item);
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

std::string program_text(const Draw& draw, const Plan& plan) {
    std::string text = "// What lights this Draw:\n" + commented(describe(plan.effects));
    for (std::size_t i = 0; i < plan.lights.size(); ++i)
        text += fmt::format("// light{} is GL_LIGHT{}.\n", i, plan.lights[i].number);
    text += "// What is left out:\n";
    for (const LeftOut& left_out : plan.left_out) text += fmt::format("//   {}: {}\n", left_out.what, left_out.why);

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
