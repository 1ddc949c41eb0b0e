#include "app/cli/reproducer.h"

#include <fmt/format.h>

#include <optional>

#include "judge/compare/vertex_colors.h"
#include "render/context/driver_name.h"
#include "scene/command/text.h"
#include "scene/shape/written_out.h"

namespace twinlight::cli {

namespace {

using namespace check;

// The same comparison as in judge/check/suite.cpp, in C. Colours of vertices come from feedback, unclamped if the driver can.
constexpr const char* kCheckColor = R"c(
static int wrong_answers = 0;

static int agree(float value, float right) { return fabs(value - right) <= kTolerance * fmax(1, fabs(right)); }

/* Each channel may equal `right` or `other`: they differ where the formula jumps and rounding decides. */
static void check_color(const char* place, const float* right, const float* other, const float* value) {
    int differs = value == 0, i;
    for (i = 0; i < 4 && !differs; ++i) differs = !agree(value[i], right[i]) && !agree(value[i], other[i]);
    printf("%s: expected (%.7g, %.7g, %.7g, %.7g)", place, right[0], right[1], right[2], right[3]);
    if (value) printf(", the driver gives (%.7g, %.7g, %.7g, %.7g)", value[0], value[1], value[2], value[3]);
    else printf(", the driver draws nothing");
    printf("%s\n", differs ? ": WRONG" : "");
    wrong_answers += differs;
}
)c";

constexpr const char* kShowVertices = R"c(
/* The colour of the last vertex at this place in the window; 0 if there is none. */
static const float* vertex_at(const float* buffer, int count, float x, float y) {
    const float* found = 0;
    int i = 0;
    while (i < count) {
        const int token = (int)buffer[i++];
        int vertices = token == GL_POINT_TOKEN ? 1 : 2;
        if (token == GL_POLYGON_TOKEN) vertices = (int)buffer[i++];
        for (; vertices > 0; --vertices, i += 7)  /* GL_3D_COLOR */
            if (fabs(buffer[i] - x) <= 0.5 && fabs(buffer[i + 1] - y) <= 0.5) found = buffer + i + 3;
    }
    return found;
}

static void show(void) {
    typedef void (*ClampColor)(GLenum, GLenum);
    static float buffer[512];
    int count, i;
    glFeedbackBuffer(512, GL_3D_COLOR, buffer);
    if (glutExtensionSupported("GL_ARB_color_buffer_float"))
        ((ClampColor)glutGetProcAddress("glClampColorARB"))(GL_CLAMP_VERTEX_COLOR, GL_FALSE);
    else printf("the driver clamps the colours of vertices, so values outside [0, 1] are wrong here\n");
    glRenderMode(GL_FEEDBACK);
    draw_scene();
    count = glRenderMode(GL_RENDER);
    for (i = 0; i < (int)(sizeof kExpected / sizeof kExpected[0]); ++i)
        check_color(kExpected[i].place, kExpected[i].color, kExpected[i].other,
                    vertex_at(buffer, count, kExpected[i].x, kExpected[i].y));
}
)c";

constexpr const char* kShowPixels = R"c(
static void show(void) {
    int i;
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    draw_scene();
    for (i = 0; i < (int)(sizeof kExpected / sizeof kExpected[0]); ++i) {
        float color[4];
        glReadPixels((int)kExpected[i].x, (int)kExpected[i].y, 1, 1, GL_RGBA, GL_FLOAT, color);
        color[3] = kExpected[i].color[3];  /* a window need not have alpha */
        check_color(kExpected[i].place, kExpected[i].color, kExpected[i].other, color);
    }
}
)c";

constexpr const char* kShowNothing = R"c(
static void show(void) { draw_scene(); }
)c";

constexpr const char* kCheckError = R"c(
static void check_error(GLenum error) {{
    printf("glGetError: expected 0x%04X ({0}), the driver gives 0x%04X%s\n", {0}, error,
           error == {0} ? "" : ": WRONG");
    wrong_answers += error != {0};
}}
)c";

constexpr const char* kMain = R"c(
static void display(void) {{
    printf("%s, %s\n%s\n", glGetString(GL_RENDERER), glGetString(GL_VERSION), kText);
    glViewport(0, 0, {0}, {0});  /* a window manager may make the window larger */
    while (glGetError() != GL_NO_ERROR) {{}}  /* errors from opening the window */
    show();
    check_error(glGetError());
    printf(wrong_answers ? "The driver violates the specification.\n" : "The driver follows the specification.\n");
    fflush(stdout);
    exit(wrong_answers ? 1 : 0);
}}

int main(int argc, char** argv) {{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_RGBA | GLUT_DOUBLE | GLUT_DEPTH | GLUT_STENCIL);
    glutInitWindowSize({0}, {0});
    glutCreateWindow(argv[0]);
    glutDisplayFunc(display);
    glutMainLoop();
    return 0;
}}
)c";

// As a string literal in C.
std::string c_literal(const std::string& text) {
    std::string literal = "\"";
    for (const char c : text) literal += c == '"' || c == '\\' ? std::string{'\\', c} : std::string{c};
    return literal + "\"";
}

std::string c_array(const Seen& color) {
    const glm::dvec4& c = std::get<glm::dvec4>(color);
    return fmt::format("{{{:.9g}, {:.9g}, {:.9g}, {:.9g}}}", c.r, c.g, c.b, c.a);
}

// The expected place in a window of kSide by kSide pixels; the origin is the lower left corner.
glm::dvec2 window_place(const Case& of, const Spot& spot) {
    if (spot.kind == Spot::Kind::kPixel) return {spot.x, kSide - 1 - spot.y};
    std::string error;
    const std::optional<compare::VertexScene> scene =
        compare::make_vertex_scene(of.carried_out(compare::kVertexWindow).scene, error);
    const glm::dvec4& clip = scene.value().lit.at(static_cast<std::size_t>(spot.vertex)).position_clip;
    return (glm::dvec2(clip) / clip.w * 0.5 + 0.5) * static_cast<double>(kSide);
}

std::string how_to_run(const std::string& driver, const std::string& name) {
    if (parse_driver_name(driver).name != "softpipe") return "";
    return fmt::format(
        "// Run it with: GALLIUM_DRIVER=softpipe DRAW_USE_LLVM=0 ./{}\n"
        "// (In Mesa 22.3, softpipe crashes or hangs in GL_FEEDBACK mode if it uses LLVM for vertices.)\n",
        name);
}

}  // namespace

std::string reproducer(const std::string& driver, const Case& of, const Result& result) {
    std::string found;
    for (const Finding& finding : result.findings)
        if (finding.path == Path::kFixed && finding.outcome != Outcome::kOurChoice)
            found += "// " + finding_text(of, finding) + "\n";
    if (found.empty() || !result.error.empty()) return "";
    std::string text = fmt::format(
        "// {}\n// {}\n// OpenGL 2.1, section {}\n// {}\n{}"
        "// Build it with: cc -std=c99 {}.c -lglut -lGLU -lGL -lm\n{}"
        "// It prints the expected and the actual values; the exit status is 1 if they differ.\n"
        "#define GL_GLEXT_PROTOTYPES\n#include <GL/freeglut.h>\n#include <math.h>\n#include <stdio.h>\n"
        "#include <stdlib.h>\n\n",
        of.what, of.why, of.text, driver, found, of.name, how_to_run(driver, of.name));
    text += print_c_function(with_pragmas_written_out(*of.scene));
    text += fmt::format("\nstatic const char* kText = {};\n", c_literal("OpenGL 2.1, section " + of.text));
    std::string colors, error = "GL_NO_ERROR";
    for (const Expectation& expected : of.expectations) {
        if (expected.spot.shading) continue;  // the fixed function has no such shading
        if (expected.spot.kind == Spot::Kind::kError) {
            error = text_of(expected.value);
            continue;
        }
        const glm::dvec2 place = window_place(of, expected.spot);
        colors += fmt::format("    {{{}, {:.9g}, {:.9g}, {}, {}}},\n", c_literal(expected.spot.str()), place.x, place.y,
                              c_array(expected.value), c_array(expected.other));
    }
    if (colors.empty()) {
        text += "\nstatic int wrong_answers = 0;\n";
    } else {
        const double tolerance = of.tolerance.value_or(kTolerance);
        const std::string causes =
            of.tolerance ? of.tolerance_causes : "for float arithmetic; relative to the larger of 1 and the value";
        text += fmt::format(
            "static const double kTolerance = {};  /* {} */\n"
            "static const struct {{ const char* place; float x, y; float color[4], other[4]; }} kExpected[] = "
            "{{\n{}}};\n{}",
            of.is_of_vertices() ? fmt::format("{:g}", tolerance) : fmt::format("{:g} + 0.5 / 255", tolerance),
            of.is_of_vertices() ? causes : causes + "; plus half of 1/255 for the window", colors, kCheckColor);
    }
    text += fmt::format(kCheckError, error);
    text += colors.empty() ? kShowNothing : of.is_of_vertices() ? kShowVertices : kShowPixels;
    return text + fmt::format(kMain, kSide);
}

}  // namespace twinlight::cli
