// --precise against the driver's fixed function on llvmpipe: the colours of vertices in floats, bit by bit, over the fuzzer's
// random states, and whole pictures of built-in scenes.
//
// A state is resolved first: its matrices are loaded and its lights placed as the floats that the Frame's doubles round to.
// For what glRotate and its kin multiply up the driver multiplies in floats, before any lighting is done.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <map>
#include <memory>
#include <optional>

#include "../golden/listed_driver.h"
#include "command/text.h"
#include "context/context.h"
#include "context/gl.h"
#include "effect/plan.h"
#include "fixed/fixed.h"
#include "fuzz/departures.h"
#include "fuzz/fuzz.h"
#include "programmable/mesh.h"
#include "programmable/precise.h"
#include "programmable/program.h"
#include "programmable/programmable.h"
#include "state/state.h"

namespace twinlight {
namespace {

using Id = CommandId;

constexpr int kWindow = 64;
constexpr RenderOptions kPrecise = {.shading = {}, .lecture_variants = false, .budget = 0, .precise = true};

// ---- The state, resolved ----

// The Draw's lighting as commands of floats: three of its vertices as a triangle, so that both faces have colours.
class Resolved {
  public:
    static std::shared_ptr<const CommandList> commands(const Draw& draw) { return Resolved(draw).build(); }

  private:
    explicit Resolved(const Draw& draw) : draw_(draw) {}

    std::shared_ptr<const CommandList> build() {
        const LightingState& lighting = draw_.lighting;
        add(Id::glMatrixMode, {kGL_PROJECTION});
        add(Id::glLoadMatrixf, columns(draw_.clip_from_eye));
        add(Id::glMatrixMode, {kGL_MODELVIEW});
        for (std::size_t i = 0; i < kMaxLights; ++i) light(kGL_LIGHT0 + static_cast<double>(i), lighting.lights[i]);
        add(Id::glLoadMatrixf, columns(draw_.eye_from_object));

        const LightModel& model = lighting.light_model;
        add(Id::glLightModelfv, with({kGL_LIGHT_MODEL_AMBIENT}, model.ambient));
        add(Id::glLightModelf, {kGL_LIGHT_MODEL_LOCAL_VIEWER, model.local_viewer ? 1.0 : 0.0});
        add(Id::glLightModelf, {kGL_LIGHT_MODEL_TWO_SIDE, model.two_side ? 1.0 : 0.0});
        add(Id::glLightModelf, {kGL_LIGHT_MODEL_COLOR_CONTROL, static_cast<double>(model.color_control)});
        if (lighting.normalize) add(Id::glEnable, {kGL_NORMALIZE});
        if (lighting.rescale_normal) add(Id::glEnable, {kGL_RESCALE_NORMAL});
        material({lighting.front, lighting.back}, nullptr);
        const ColorMaterial& tracking = lighting.color_material;
        add(Id::glColorMaterial, {static_cast<double>(tracking.face), static_cast<double>(tracking.mode)});
        if (tracking.enabled) add(Id::glEnable, {kGL_COLOR_MATERIAL});
        add(Id::glEnable, {kGL_LIGHTING});
        add(Id::glFrontFace, {static_cast<double>(draw_.raster.front_face)});
        add(Id::glBegin, {kGL_TRIANGLES});
        for (std::size_t i = 0; i < 3; ++i) vertex(draw_.vertices[draw_.index(i)], i == 0);
        add(Id::glEnd);
        return std::make_shared<const CommandList>("resolved", std::move(commands_));
    }

    void add(Id id, std::vector<double> arguments = {}) {
        const std::vector<Parameter>& parameters = signature(id).parameters;
        if (!parameters.empty() && parameters.back().kind == Kind::kFloat)
            for (double& value : arguments) value = static_cast<double>(static_cast<float>(value));
        commands_.push_back({id, std::move(arguments), {}});
    }
    template <class Vector>
    static std::vector<double> with(std::vector<double> head, const Vector& v) {
        for (int i = 0; i < Vector::length(); ++i) head.push_back(v[i]);
        return head;
    }
    static std::vector<double> columns(const glm::dmat4& m) {
        std::vector<double> values;
        for (int i = 0; i < 4; ++i) values = with(std::move(values), m[i]);
        return values;
    }

    void light(double l, const LightSource& light) {
        add(Id::glLightfv, with({l, kGL_AMBIENT}, light.ambient));
        add(Id::glLightfv, with({l, kGL_DIFFUSE}, light.diffuse));
        add(Id::glLightfv, with({l, kGL_SPECULAR}, light.specular));
        add(Id::glLightfv, with({l, kGL_POSITION}, light.position_eye));
        add(Id::glLightfv, with({l, kGL_SPOT_DIRECTION}, light.spot_direction_eye));
        add(Id::glLightf, {l, kGL_SPOT_EXPONENT, light.spot_exponent});
        add(Id::glLightf, {l, kGL_SPOT_CUTOFF, light.spot_cutoff_deg});
        add(Id::glLightf, {l, kGL_CONSTANT_ATTENUATION, light.constant_attenuation});
        add(Id::glLightf, {l, kGL_LINEAR_ATTENUATION, light.linear_attenuation});
        add(Id::glLightf, {l, kGL_QUADRATIC_ATTENUATION, light.quadratic_attenuation});
        if (light.enabled) add(Id::glEnable, {l});
    }

    // What differs from the materials before; all where there are none.
    void material(const Materials& now, const Materials* before) {
        const auto color = [&](Enum pname, glm::dvec4 Material::*of) {
            if (before && now.front.*of == before->front.*of && now.back.*of == before->back.*of) return;
            add(Id::glMaterialfv, with({kGL_FRONT, static_cast<double>(pname)}, now.front.*of));
            add(Id::glMaterialfv, with({kGL_BACK, static_cast<double>(pname)}, now.back.*of));
        };
        color(kGL_AMBIENT, &Material::ambient);
        color(kGL_DIFFUSE, &Material::diffuse);
        color(kGL_SPECULAR, &Material::specular);
        color(kGL_EMISSION, &Material::emission);
        if (before && now.front.shininess == before->front.shininess && now.back.shininess == before->back.shininess)
            return;
        add(Id::glMaterialf, {kGL_FRONT, kGL_SHININESS, now.front.shininess});
        add(Id::glMaterialf, {kGL_BACK, kGL_SHININESS, now.back.shininess});
    }

    void vertex(const Vertex& v, bool is_first) {
        // What any vertex has of its own every vertex has.
        if (!draw_.materials.empty()) {
            const Materials& now = draw_.materials[v.material];
            for (const Materials& other : draw_.materials)
                if (is_first) material(now, &other);
            if (!is_first) material(now, before_);
            before_ = &now;
        }
        add(Id::glColor4f, with({}, v.color));
        add(Id::glNormal3f, with({}, v.normal_object));
        add(Id::glVertex4f, with({}, v.position_object));
    }

    const Draw& draw_;
    const Materials* before_ = nullptr;
    std::vector<Command> commands_;
};

// ---- What is compared ----

using Floats = std::array<float, 4>;

struct LitVertex {
    std::optional<Floats> window, front, back;
};
using Triangle = std::array<LitVertex, 3>;

glm::vec2 place(const Floats& clip) { return glm::vec2(clip[0], clip[1]) / clip[3]; }

// Feedback returns the face that shows (5.3): the commands, and again with the other winding as the front.
void ask_fixed(Triangle& triangle, const CommandList& scene, const std::array<Floats, 3>& clip, bool two_side) {
    for (const bool other : {false, true}) {
        if (other && !two_side) continue;
        std::array<GLfloat, 64> buffer{};
        glFeedbackBuffer(static_cast<GLsizei>(buffer.size()), GL_3D_COLOR, buffer.data());
        fixed::Driver driver(kWindow, kWindow);
        glClampColor(GL_CLAMP_VERTEX_COLOR, GL_FALSE);
        glRenderMode(GL_FEEDBACK);
        Enum front_face = kGL_CCW;
        for (Command command : scene.commands) {
            if (command.id == Id::glFrontFace) {
                front_face = (command.enumerant(0) == kGL_CCW) != other ? kGL_CCW : kGL_CW;
                command.arguments[0] = front_face;
            }
            driver.execute(command);
        }
        const GLint written = glRenderMode(GL_RENDER);
        glClampColor(GL_CLAMP_VERTEX_COLOR, GL_TRUE);
        constexpr GLint kTriangle = 2 + 3 * 7;  // token, count, and x, y, z, r, g, b, a of each
        if (written != kTriangle) continue;
        const glm::vec2 a = place(clip[1]) - place(clip[0]), b = place(clip[2]) - place(clip[0]);
        const bool is_front = (a.x * b.y - a.y * b.x > 0) == (front_face == kGL_CCW);
        for (std::size_t i = 2; i < kTriangle; i += 7) {
            for (std::size_t v = 0; v < 3; ++v) {
                const glm::vec2 expected = (place(clip[v]) * 0.5F + 0.5F) * static_cast<float>(kWindow);
                if (glm::length(expected - glm::vec2(buffer[i], buffer[i + 1])) > 0.5F) continue;
                triangle[v].window = {buffer[i], buffer[i + 1], buffer[i + 2], 1};
                (is_front || !two_side ? triangle[v].front : triangle[v].back) = {buffer[i + 3], buffer[i + 4],
                                                                                  buffer[i + 5], buffer[i + 6]};
            }
        }
    }
}

// The outputs of the precise vertex program, by transform feedback, before the clamp.
class PreciseVertices {
  public:
    struct Captured {
        std::array<Floats, 3> clip{}, front{}, back{};
    };

    Captured capture(Draw draw) {
        const Plan plan = plan_effects(draw, kPrecise);
        programmable::Code code = programmable::precise_code(draw, plan);
        code.effects.clamp = false;
        const programmable::Uniforms numbers = programmable::precise_uniforms(draw, plan, code);
        auto& program = programs_[{code.effects, code.form}];
        if (!program) {
            program =
                std::make_unique<programmable::Program>(programmable::assemble(code.effects, code.form), code.effects);
            program->use(numbers);
            GLint name = 0;
            glGetIntegerv(GL_CURRENT_PROGRAM, &name);
            const char* outputs[] = {"gl_Position", "v_front_primary", "v_back_primary"};
            glTransformFeedbackVaryings(static_cast<GLuint>(name), code.effects.two_side ? 3 : 2, outputs,
                                        GL_INTERLEAVED_ATTRIBS);
            glLinkProgram(static_cast<GLuint>(name));
        }
        program->use(numbers);
        draw.mode = kGL_POINTS;
        const programmable::Mesh mesh(draw, code.effects, kPrecise);

        const std::size_t per_vertex = code.effects.two_side ? 3 : 2;
        std::vector<Floats> values(3 * per_vertex);
        GLuint buffer = 0;
        glGenBuffers(1, &buffer);
        glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
        const auto size = static_cast<GLsizeiptr>(values.size() * sizeof(Floats));
        glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, size, nullptr, GL_STREAM_READ);
        glEnable(GL_RASTERIZER_DISCARD);
        glBeginTransformFeedback(GL_POINTS);
        mesh.draw();
        glEndTransformFeedback();
        glDisable(GL_RASTERIZER_DISCARD);
        glGetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0, size, values.data());
        glDeleteBuffers(1, &buffer);
        glBindVertexArray(0);
        glUseProgram(0);

        Captured captured;
        for (std::size_t v = 0; v < 3; ++v) {
            captured.clip[v] = values[v * per_vertex];
            captured.front[v] = values[v * per_vertex + 1];
            captured.back[v] = values[v * per_vertex + per_vertex - 1];
        }
        return captured;
    }

  private:
    std::map<std::pair<EffectSet, programmable::Form>, std::unique_ptr<programmable::Program>> programs_;
};

struct Counts {
    int states = 0;
    long floats = 0, differing = 0;
    std::map<std::string_view, long> left_out;  // vertices
};

// 0 and -0 are equal.
bool same(float a, float b) { return a == b || std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b); }

void compare(Counts& counts, const std::optional<Floats>& fixed, const Floats& precise, const std::string& where) {
    ASSERT_TRUE(fixed) << where << ": the fixed function shows no such vertex";
    for (std::size_t c = 0; c < 4; ++c) {
        ++counts.floats;
        if (same((*fixed)[c], precise[c])) continue;
        if (++counts.differing <= 10)
            ADD_FAILURE() << fmt::format("{}, channel {}: {:.9g} of the fixed function, {:.9g}", where, c, (*fixed)[c],
                                         precise[c]);
    }
}

void compare_state(Counts& counts, PreciseVertices& precise, std::uint64_t state) {
    const auto scene = std::make_shared<const CommandList>(fuzz::random_scene({.seed = 77}, state));
    const StateOptions size{.width = kWindow, .height = kWindow};
    const Draw drawn = std::get<Draw>(make_frame(scene, size).items.back());
    if (drawn.vertices.size() < 3) return;
    const auto resolved = Resolved::commands(drawn);
    const Frame frame = make_frame(resolved, size);
    const Draw& draw = std::get<Draw>(frame.items.back());
    const fuzz::LeftOut left_out(*resolved, {});
    const auto captured = precise.capture(draw);
    Triangle triangle;
    const bool two_side = draw.lighting.light_model.two_side;
    ask_fixed(triangle, *resolved, captured.clip, two_side);
    ++counts.states;
    for (std::size_t v = 0; v < 3; ++v) {
        if (const fuzz::Departure* departure = left_out.at(draw, draw.vertices[v])) {
            ++counts.left_out[departure->name];
            continue;
        }
        const std::string where = fmt::format("state {} vertex {}", state, v);
        compare(counts, triangle[v].front, captured.front[v], where + ", front");
        if (two_side) compare(counts, triangle[v].back, captured.back[v], where + ", back");
    }
    if (testing::Test::HasFailure() && counts.differing <= 1) fmt::print("{}\n", print_scene(*resolved));
}

TEST(Precise, GivesTheFixedFunctionsFloatsOverRandomStates) {
    const auto context = make_offscreen_context(kWindow, kWindow);
    if (!is_listed_driver()) GTEST_SKIP() << "the order of operations is llvmpipe's: " << driver_name();
    const char* more = std::getenv("TWINLIGHT_PRECISE_STATES");
    const int states = more ? std::atoi(more) : 2000;
    constexpr std::uint64_t kOfAStructure = 50;
    Counts counts;
    PreciseVertices precise;
    for (int i = 0; i < states && counts.differing < 10; ++i) {
        const auto n = static_cast<std::uint64_t>(i);
        const std::uint64_t state = n / kOfAStructure * fuzz::kStatesPerStructure + n % kOfAStructure;
        if (!fuzz::is_picture(state)) compare_state(counts, precise, state);
        if (testing::Test::HasFatalFailure()) return;
    }
    fmt::print("{} states, {} floats of colours, {} differing; vertices left out:\n", counts.states, counts.floats,
               counts.differing);
    for (const auto& [name, count] : counts.left_out) fmt::print("  {} {}\n", count, name);
    EXPECT_EQ(counts.differing, 0);
    EXPECT_GT(counts.floats, 8L * counts.states);
}

}  // namespace
}  // namespace twinlight
