// --precise against the driver's fixed function on llvmpipe: vertices in floats, bit by bit, over the fuzzer's random
// states, and whole pictures of built-in scenes.
//
// States are resolved first (resolved_state.h), because the driver multiplies glRotate and similar matrices in floats,
// before any lighting.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <memory>
#include <optional>

#include "judge/compare/departures.h"
#include "judge/fuzz/fuzzer.h"
#include "render/context/context.h"
#include "render/context/driver_name.h"
#include "render/context/gl.h"
#include "render/effect/plan.h"
#include "render/fixed/fixed.h"
#include "render/fixed/replay.h"
#include "render/programmable/numbers/precise.h"
#include "render/programmable/precise_support.h"
#include "render/programmable/programmable.h"
#include "render/programmable/shader_program.h"
#include "render/programmable/uploaded_mesh.h"
#include "resolved_state.h"
#include "scene/command/text.h"
#include "scene/scenes/load.h"
#include "scene/state/state.h"

namespace twinlight::precise_matches_fixed_test {
namespace {

using Id = CommandId;

constexpr int kWindow = 64;
constexpr programmable::Options kPrecise = {
    {{.shading = {}, .lecture_variants = false}, 0}, programmable::Tier::kUniform, true};

using Floats = std::array<float, 4>;
constexpr Floats kNothing{};

// The result for a vertex before the clamp. The fixed function also returns the back colour, where it has one.
struct LitVertex {
    Floats position = kNothing;  // shaders: clip coordinates; fixed function: window coordinates
    Floats front = kNothing, front_secondary = kNothing, back = kNothing;
};
using Triangle = std::array<LitVertex, 3>;

glm::vec2 ndc(const Floats& clip) { return glm::vec2(clip[0], clip[1]) / clip[3]; }

// 2.11.1, in the driver's order: its own y points down. All factors but 1/w are powers of two.
Floats window(const Floats& clip) {
    const float per_w = 1 / clip[3];
    constexpr float kHalf = kWindow / 2.0F;
    const float x = clip[0] * per_w * kHalf + kHalf, y_down = clip[1] * per_w * -kHalf + kHalf;
    return {x, kWindow - y_down, clip[2] * per_w * 0.5F + 0.5F, 0};
}

// ---- The fixed function ----

using Change = std::function<void(Command&)>;

// Executes the commands; `change` may change each of them first.
void execute(const CommandList& scene, const Change& change, const std::function<void()>& begin) {
    fixed::Driver driver(kWindow, kWindow);
    begin();
    for (Command command : scene.commands) {
        change(command);
        driver.execute(command);
    }
}

// Feedback returns only the visible face (5.3). `other_face` swaps front and back, to get the other one.
void ask_feedback(Triangle& triangle, const CommandList& scene, const Triangle& shaders, bool other_face) {
    std::array<GLfloat, 64> buffer{};
    glFeedbackBuffer(static_cast<GLsizei>(buffer.size()), GL_3D_COLOR, buffer.data());
    Enum front_face = kGL_CCW;
    const auto turn = [&](Command& command) {
        if (command.id != Id::glFrontFace) return;
        front_face = (command.enumerant(0) == kGL_CCW) != other_face ? kGL_CCW : kGL_CW;
        command.arguments[0] = front_face;
    };
    glClampColor(GL_CLAMP_VERTEX_COLOR, GL_FALSE);
    execute(scene, turn, [] { glRenderMode(GL_FEEDBACK); });
    const GLint written = glRenderMode(GL_RENDER);
    glClampColor(GL_CLAMP_VERTEX_COLOR, GL_TRUE);
    constexpr std::size_t kPerVertex = 7, kTriangle = 2 + 3 * kPerVertex;  // token, count; x, y, z, r, g, b, a
    ASSERT_EQ(written, static_cast<GLint>(kTriangle)) << "the triangle is not all in view";
    const glm::vec2 a = ndc(shaders[1].position) - ndc(shaders[0].position);
    const glm::vec2 b = ndc(shaders[2].position) - ndc(shaders[0].position);
    const bool is_front = (a.x * b.y - a.y * b.x > 0) == (front_face == kGL_CCW);
    for (std::size_t i = 2; i < kTriangle; i += kPerVertex) {
        for (std::size_t v = 0; v < 3; ++v) {
            const Floats expected = window(shaders[v].position);
            if (std::hypot(expected[0] - buffer[i], expected[1] - buffer[i + 1]) > 0.5F) continue;
            triangle[v].position = {buffer[i], buffer[i + 1], buffer[i + 2], 0};
            (is_front ? triangle[v].front : triangle[v].back) =
                Floats{buffer[i + 3], buffer[i + 4], buffer[i + 5], buffer[i + 6]};
        }
    }
}

// Feedback does not return the secondary colour. A fragment shader after the fixed function does, for points next to
// each other.
class SecondaryColors {
  public:
    SecondaryColors() {
        const GLuint shader = glCreateShader(GL_FRAGMENT_SHADER);
        const char* text = "#version 120\nvoid main() { gl_FragColor = vec4(gl_SecondaryColor.rgb, 1.0); }\n";
        glShaderSource(shader, 1, &text, nullptr);
        glCompileShader(shader);
        program_ = glCreateProgram();
        glAttachShader(program_, shader);
        glLinkProgram(program_);
        glDeleteShader(shader);
    }

    void ask(Triangle& triangle, const CommandList& scene, const Draw& draw) const {
        constexpr double kReach = 16;  // in eye coordinates: w stays 1, and nothing is interpolated
        bool is_projection = false;
        const auto change = [&](Command& command) {
            if (command.id == Id::glMatrixMode) is_projection = command.enumerant(0) == kGL_PROJECTION;
            if (command.id == Id::glLoadMatrixf && is_projection)
                command.arguments = {1 / kReach, 0, 0, 0, 0, 1 / kReach, 0, 0, 0, 0, 1 / kReach, 0, 0, 0, 0, 1};
            if (command.id == Id::glBegin) command.arguments[0] = kGL_POINTS;
        };
        execute(scene, change, [&] {
            glClear(GL_COLOR_BUFFER_BIT);
            glUseProgram(program_);
            for (const GLenum of : {GL_CLAMP_VERTEX_COLOR, GL_CLAMP_FRAGMENT_COLOR, GL_CLAMP_READ_COLOR})
                glClampColor(of, GL_FALSE);
        });
        const Image image = read_pixels(kWindow, kWindow);
        glUseProgram(0);
        glClampColor(GL_CLAMP_VERTEX_COLOR, GL_TRUE);
        for (const GLenum of : {GL_CLAMP_FRAGMENT_COLOR, GL_CLAMP_READ_COLOR}) glClampColor(of, GL_FIXED_ONLY);
        for (std::size_t v = 0; v < 3; ++v) {
            const glm::dvec4 at = draw.eye_from_object * draw.vertices[v].position_object / kReach * 0.5 + 0.5;
            // A point on the border of two pixels may be in either.
            for (const int x : {static_cast<int>(at.x * kWindow - 0.01), static_cast<int>(at.x * kWindow + 0.01)}) {
                for (const int y : {static_cast<int>(at.y * kWindow - 0.01), static_cast<int>(at.y * kWindow + 0.01)}) {
                    const Rgba& pixel = image.at(x, kWindow - 1 - y);
                    if (pixel[3] == 1) triangle[v].front_secondary = {pixel[0], pixel[1], pixel[2], 0};
                }
            }
        }
    }

  private:
    GLuint program_ = 0;  // deleted with its context
};

// ---- Shaders ----

// The outputs of the vertex program, read by transform feedback.
class VertexPrograms {
  public:
    Triangle lit(Draw draw, const programmable::Options& options) {
        const Plan plan = plan_effects(draw, options);
        using namespace programmable;
        Code code = options.precise ? precise_code(draw, plan) : code_for(draw, plan);
        code.effects.clamp = false;
        const Uniforms numbers = options.precise ? precise_uniforms(draw, plan, code) : uniforms(draw, plan, code);
        std::vector<std::pair<const char*, Floats LitVertex::*>> outputs = {{"gl_Position", &LitVertex::position},
                                                                            {"v_front_primary", &LitVertex::front}};
        if (code.effects.two_side) outputs.emplace_back("v_back_primary", &LitVertex::back);
        if (code.effects.separate_specular) outputs.emplace_back("v_front_secondary", &LitVertex::front_secondary);

        auto& program = programs_[{code.effects, code.form}];
        if (!program) {
            program = std::make_unique<ShaderProgram>(assemble(code.effects, code.form), code.effects);
            program->make_current();
            link_with(outputs);
        }
        program->use(numbers);
        draw.mode = kGL_POINTS;
        return captured(UploadedMesh(draw, code.effects, false, code.origin_object.value_or(glm::dvec3(0))), outputs);
    }

  private:
    using Outputs = std::vector<std::pair<const char*, Floats LitVertex::*>>;

    // The current program, linked again.
    static void link_with(const Outputs& outputs) {
        GLint name = 0;
        glGetIntegerv(GL_CURRENT_PROGRAM, &name);
        std::vector<const char*> names;
        for (const auto& [output, member] : outputs) names.push_back(output);
        glTransformFeedbackVaryings(static_cast<GLuint>(name), static_cast<GLsizei>(names.size()), names.data(),
                                    GL_INTERLEAVED_ATTRIBS);
        glLinkProgram(static_cast<GLuint>(name));
    }

    static Triangle captured(const programmable::UploadedMesh& mesh, const Outputs& outputs) {
        std::vector<float> values(3 * outputs.size() * 4);
        GLuint buffer = 0;
        glGenBuffers(1, &buffer);
        glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
        const auto size = static_cast<GLsizeiptr>(values.size() * sizeof(float));
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

        Triangle triangle;
        auto next = values.begin();
        for (LitVertex& vertex : triangle) {
            for (const auto& [name, member] : outputs) {
                const int count = member == &LitVertex::front_secondary ? 3 : 4;
                std::copy_n(next, count, (vertex.*member).begin());
                next += count;
            }
        }
        return triangle;
    }

    std::map<std::pair<EffectSet, programmable::Form>, std::unique_ptr<programmable::ShaderProgram>> programs_;
};

// ---- The comparison ----

struct Counts {
    long floats = 0, differing = 0;
    double largest = 0;  // difference, relative to the larger of 1 and the value
};
struct Found {
    int states = 0, in_object_space = 0;
    Counts colors, positions;
    Counts of_the_ordinary_program;             // its colours
    std::map<std::string_view, long> left_out;  // vertices
};

bool same(float a, float b) { return a == b || std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b); }

// Infinite where one of two different floats is not finite.
double relative_difference(float a, float b) {
    const double difference = std::abs(static_cast<double>(a) - b) / std::max(1.0, std::abs(static_cast<double>(a)));
    return std::isfinite(difference) ? difference : HUGE_VAL;
}

// Reports the first few differences, but not those of the control, which must differ.
void compare(Counts& counts, const Floats& fixed, const Floats& shaders, const std::string& where, bool tells = true) {
    for (std::size_t c = 0; c < 4; ++c) {
        ++counts.floats;
        if (same(fixed[c], shaders[c])) continue;
        counts.largest = std::max(counts.largest, relative_difference(fixed[c], shaders[c]));
        if (++counts.differing <= 5 && tells)
            ADD_FAILURE() << fmt::format("{}, component {}: {:.9g} of the fixed function, {:.9g}", where, c, fixed[c],
                                         shaders[c]);
    }
}

class Comparison {
  public:
    Found found;
    bool is_exact = true;  // reports differences

    void compare_state(std::uint64_t state, ModelviewKind kind) {
        const auto scene = std::make_shared<const CommandList>(fuzz::random_scene({{.seed = 77}}, state));
        const StateOptions size{.width = kWindow, .height = kWindow};
        const Draw drawn = std::get<Draw>(make_frame(*scene, size).items.back());
        if (drawn.vertices.size() < 3) return;
        fuzz::Random random(state);
        const auto commands = resolved(with_modelview(drawn, modelview_of(kind, drawn, random)));
        const Frame frame = make_frame(*commands, size);
        const Draw& draw = std::get<Draw>(frame.items.back());
        const bool two_side = draw.lighting.light_model.two_side;
        const bool separate = draw.lighting.light_model.color_control != kGL_SINGLE_COLOR;

        const Triangle precise = programs_.lit(draw, kPrecise);
        Triangle fixed;
        ask_feedback(fixed, *commands, precise, false);
        if (two_side) ask_feedback(fixed, *commands, precise, true);
        if (separate) secondary_colors_.ask(fixed, *commands, draw);
        ++found.states;
        found.in_object_space += programmable::precise_code(draw, plan_effects(draw, kPrecise)).form.object_space;

        const bool is_control = found.states % kControlEvery == 1;
        const Triangle ordinary =
            is_control ? programs_.lit(draw, {{{.shading = {}, .lecture_variants = false}, 0}}) : Triangle{};
        // States that rounding decides are included: equal floats decide equally.
        const compare::DeparturesOfScene departures(
            *commands, current_driver(), {"light at the horizon of a vertex", "vertex near the edge of a spot's cone"});
        for (std::size_t v = 0; v < 3; ++v) {
            const std::string where = fmt::format("state {} under {}, vertex {}", state, name_of(kind), v);
            compare(found.positions, fixed[v].position, window(precise[v].position), where + ", position", is_exact);
            if (const compare::Departure* departure = departures.at(draw, draw.vertices[v])) {
                ++found.left_out[departure->name];
                continue;
            }
            const bool is_shown = two_side || fixed[v].front != kNothing;
            compare(found.colors, is_shown ? fixed[v].front : fixed[v].back, precise[v].front, where + ", front",
                    is_exact);
            if (two_side) compare(found.colors, fixed[v].back, precise[v].back, where + ", back", is_exact);
            if (separate)
                compare(found.colors, fixed[v].front_secondary, precise[v].front_secondary, where + ", secondary",
                        is_exact);
            if (is_control)
                compare(found.of_the_ordinary_program, is_shown ? fixed[v].front : fixed[v].back, ordinary[v].front, "",
                        false);
        }
        if (is_exact && found.colors.differing + found.positions.differing > 0)
            fmt::print("{}\n", print_scene(*commands));
    }

  private:
    static constexpr int kControlEvery = 16;
    VertexPrograms programs_;
    SecondaryColors secondary_colors_;
};

// --precise follows Mesa 22.3. Later releases add some products in another order: the last places of few colours differ.
bool has_the_order_of_operations(const Driver& driver) { return driver.has_version("Mesa 22.3"); }
constexpr double kLastPlaces = 5e-7;  // four of them; Mesa 25.1 to 26.1: 1.4e-7
// A highlight's exponent enlarges these: up to 2.7e-5. One pixel differs by more, on Mesa 26.1 in legacy.gl (562, 83): at the tip of a
// teapot's lid, where facets without a normal meet brighter ones.
constexpr double kOfPixels = 1e-4;
constexpr std::size_t kPixelsBeyond = 1;

TEST(Precise, GivesTheFixedFunctionsFloatsOverRandomStates) {
    const auto context = make_offscreen_context(kWindow, kWindow, ColorBuffer::kFloat);
    if (current_driver().name != "llvmpipe") GTEST_SKIP() << "--precise is made for llvmpipe: " << driver_name();
    const char* more = std::getenv("TWINLIGHT_PRECISE_STATES");
    const int states = more ? std::atoi(more) : 1200;
    constexpr std::uint64_t kOfAStructure = 40;  // making a program takes the driver as long as many states
    Comparison comparison;
    const Found& found = comparison.found;
    comparison.is_exact = has_the_order_of_operations(current_driver());
    const auto goes_on = [&] {
        return !comparison.is_exact || found.colors.differing + found.positions.differing == 0;
    };
    for (int i = 0; i < states && goes_on(); ++i) {
        const auto n = static_cast<std::uint64_t>(i);
        const std::uint64_t state = n / kOfAStructure * fuzz::kStatesPerStructure + n % kOfAStructure;
        if (!fuzz::is_picture(state)) comparison.compare_state(state, static_cast<ModelviewKind>(n % kModelviewKinds));
        if (testing::Test::HasFatalFailure()) return;
    }
    fmt::print("{} states, {} of them lit in object coordinates\n", found.states, found.in_object_space);
    const auto print = [](const Counts& counts, const char* words) {
        fmt::print("{} floats of {}, {} differing, by {:.2g} at most\n", counts.floats, words, counts.differing,
                   counts.largest);
    };
    print(found.colors, "colours");
    print(found.positions, "positions in the window");
    fmt::print("of the program without --precise {} of {} floats differ\n", found.of_the_ordinary_program.differing,
               found.of_the_ordinary_program.floats);
    for (const auto& [name, count] : found.left_out) fmt::print("  left out: {} vertices, {}\n", count, name);
    if (comparison.is_exact)
        EXPECT_EQ(found.colors.differing + found.positions.differing, 0);
    else
        EXPECT_LE(found.colors.largest, kLastPlaces);
    EXPECT_GT(found.colors.floats, 8L * found.states);
    EXPECT_GT(found.in_object_space, 0);
    EXPECT_GT(found.of_the_ordinary_program.differing, 0);  // otherwise the test does not compare bits
}

// Whether the texture has a framebuffer object's picture.
bool shows_object(const Texture& texture) {
    const std::vector<ImagePart>& parts = texture.levels.front().parts;
    return std::ranges::any_of(parts, [](const ImagePart& part) { return part.copied && part.copied->drawn; });
}

// These scenes also show sums in fragments, whose order the compiler chooses. The share of two levels of a texture is one. A texture
// of copied depths is left out too: it shows their last digit, which a few depths of shaders do not share. So is the picture of
// a framebuffer object: a few of its pixels differ.
bool sums_in_fragments(const Draw& draw) {
    const auto& texture = draw.texture.texture;
    return draw.fog.enabled ||
           (texture && (draw.texture.env_mode == kGL_BLEND || texture->min_filter == kGL_LINEAR_MIPMAP_LINEAR ||
                        texture->has_depths() || shows_object(*texture)));
}

// The fixed function gets the Frame's state and loads its matrices.
TEST(Precise, DrawsBuiltInScenesInTheFixedFunctionsFloats) {
    constexpr int kWidth = 640, kHeight = 480;
    const auto context = make_offscreen_context(kWidth, kHeight, ColorBuffer::kFloat);
    if (current_driver().name != "llvmpipe") GTEST_SKIP() << "--precise is made for llvmpipe: " << driver_name();
    const bool is_exact = has_the_order_of_operations(current_driver());
    programmable::Renderer renderer;
    std::size_t compared = 0;  // Draws and Clears
    for (const EmbeddedFile& file : kSceneFiles) {
        const std::string name(file.name);
        const auto scene = std::make_shared<const CommandList>(read_built_in(file));
        Frame frame = make_frame(*scene, {.width = kWidth, .height = kHeight});
        const std::size_t left_out = std::erase_if(frame.items, [](const auto& item) {
            const Draw* draw = std::get_if<Draw>(&item);
            return draw && sums_in_fragments(*draw);
        });
        fixed::Replay(frame, {}).draw();
        const Image of_fixed = read_pixels(kWidth, kHeight);
        const Image precise = renderer.render(frame, kPrecise);
        std::size_t differing = 0, beyond = 0, worst = 0;
        double largest = 0;
        for (std::size_t i = 0; i < precise.pixels.size(); ++i) {
            differing += of_fixed.pixels[i] != precise.pixels[i];
            double of_pixel = 0;
            for (std::size_t c = 0; c < 4; ++c)
                of_pixel = std::max(of_pixel, relative_difference(of_fixed.pixels[i][c], precise.pixels[i][c]));
            if (of_pixel > largest) worst = i;
            largest = std::max(largest, of_pixel);
            beyond += of_pixel > kOfPixels;
        }
        fmt::print("{}: {} of {} pixels differ in floats, by {:.2g} at most (at {},{}); {} of {} Draws left out\n",
                   name, differing, precise.pixels.size(), largest, worst % kWidth, worst / kWidth, left_out,
                   frame.items.size() + left_out);
        if (is_exact)
            EXPECT_EQ(differing, 0U);
        else
            EXPECT_LE(beyond, kPixelsBeyond);
        compared += frame.items.size();
    }
    EXPECT_GT(compared, 5000U);
}

TEST(Precise, IsOfVerticesAndOfUniforms) {
    const auto context = make_offscreen_context(1, 1);
    const auto scene = std::make_shared<const CommandList>(
        read_scene("glBegin(GL_POINTS); glVertex3f(0, 0, 0); glEnd();", "scene.gl", "scene"));
    const Frame frame = make_frame(*scene, {.width = 1, .height = 1});
    programmable::Options phong = kPrecise, baked = kPrecise;
    phong.shading = Shading::kPhong;
    baked.tier = programmable::Tier::kBaked;
    EXPECT_THROW(programmable::UploadedFrame(frame, phong), std::invalid_argument);
    EXPECT_THROW(programmable::UploadedFrame(frame, baked), std::invalid_argument);
}

// Where the fixed function gives NaN (2.1.1 allows it), --precise uses the ordinary program.
TEST(Precise, HasAnAnswerWhereALightIsAtTheVertex) {
    const auto context = make_offscreen_context(1, 1, ColorBuffer::kFloat);
    if (!programmable::has_precise()) GTEST_SKIP() << "GLSL 4.00 is asked for: " << driver_name();
    const auto scene = std::make_shared<const CommandList>(read_scene(R"(
glEnable(GL_LIGHTING); glEnable(GL_LIGHT0);
glLightfv(GL_LIGHT0, GL_AMBIENT, (GLfloat[]){1, 1, 1, 1});
glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){0, 0, 0, 1});
glLightf(GL_LIGHT0, GL_CONSTANT_ATTENUATION, 2);
glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 1);
glBegin(GL_POINTS); glVertex3f(0, 0, 0); glEnd();)",
                                                                      "scene.gl", "scene"));
    programmable::Renderer renderer;
    const Image image = renderer.render(make_frame(*scene, {.width = 1, .height = 1}), kPrecise);
    EXPECT_FLOAT_EQ(image.at(0, 0)[0], 0.2F * 0.2F + 0.2F / 2);  // the ambient light of the scene, and of the light
}

}  // namespace
}  // namespace twinlight::precise_matches_fixed_test
