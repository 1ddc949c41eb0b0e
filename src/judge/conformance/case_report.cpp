#include "judge/conformance/case_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <utility>

#include "judge/compare/departures.h"
#include "judge/compare/vertex_colors.h"
#include "judge/conformance/c_scene.h"
#include "render/context/driver_name.h"
#include "scene/command/text.h"

namespace twinlight::conformance {

namespace {

using check::Case, check::Expectation, check::Finding, check::Spot;

// Prints the colours of the vertices, unclamped if the driver can: the last one at each place counts.
constexpr const char* kShowVertices = R"c(
/* A vertex: x, y, z, red, green, blue, alpha. */
static void show_vertex(const char* name, const float* at, float x, float y) {
    if (fabsf(at[0] - x) <= 0.5f && fabsf(at[1] - y) <= 0.5f)
        printf("%s: (%.7g, %.7g, %.7g, %.7g)\n", name, at[3], at[4], at[5], at[6]);
}

static void show(void) {
    static float buffer[512];
    int count, i = 0;
    if (glutExtensionSupported("GL_ARB_color_buffer_float")) glClampColorARB(GL_CLAMP_VERTEX_COLOR_ARB, GL_FALSE);
    glFeedbackBuffer(512, GL_3D_COLOR, buffer);
    glRenderMode(GL_FEEDBACK);
    draw_scene();
    count = glRenderMode(GL_RENDER);
    while (i < count) {
        const int token = (int)buffer[i++];
        int vertices = token == GL_POINT_TOKEN ? 1 : 2;
        if (token == GL_POLYGON_TOKEN) vertices = (int)buffer[i++];
        for (; vertices > 0; --vertices, i += 7) {
)c";

constexpr const char* kEndOfVertices = R"c(        }
    }
}
)c";

constexpr const char* kShowPixels = R"c(
static void show_pixel(const char* name, int x, int y) {
    float color[4];
    glReadPixels(x, y, 1, 1, GL_RGBA, GL_FLOAT, color);
    printf("%s: (%.7g, %.7g, %.7g, %.7g)\n", name, color[0], color[1], color[2], color[3]);
}

static void show(void) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    draw_scene();
)c";

constexpr const char* kMain = R"c(
static void display(void) {
    printf("%s, %s\n", (const char*)glGetString(GL_RENDERER), (const char*)glGetString(GL_VERSION));
    glViewport(0, 0, 64, 64);
    while (glGetError() != GL_NO_ERROR) continue;
    show();
    printf("glGetError: 0x%04X\n", glGetError());
    exit(0);
}

int main(int argc, char** argv) {
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_RGBA | GLUT_ALPHA | GLUT_DOUBLE | GLUT_DEPTH | GLUT_STENCIL);
    glutInitWindowSize(64, 64);
    glutCreateWindow(argv[0]);
    glutDisplayFunc(display);
    glutMainLoop();
    return 0;
}
)c";
static_assert(check::kSide == 64 && compare::kVertexWindow == 64, "the programs have a window of this size");

// The places that the program prints, each once: those that the driver gets wrong, but for the error, which it prints in any case.
std::string show_function(const Case& of, const std::vector<Finding>& wrong) {
    std::string text = of.is_of_vertices() ? kShowVertices : kShowPixels;
    std::string error;
    const std::optional<compare::VertexScene> scene =
        of.is_of_vertices() ? compare::make_vertex_scene(of.carried_out(compare::kVertexWindow).scene, error)
                            : std::nullopt;
    for (const Finding& finding : wrong) {
        const Spot& spot = finding.spot;
        if (spot.kind == Spot::Kind::kVertex) {
            const glm::dvec2 place =
                scene->place(static_cast<std::size_t>(spot.vertex)) * static_cast<double>(compare::kVertexWindow);
            text += fmt::format("            show_vertex({}, buffer + i, {:.9g}, {:.9g});\n", c_literal(spot.str()),
                                place.x, place.y);
        } else if (spot.kind == Spot::Kind::kPixel) {
            text +=
                fmt::format("    show_pixel({}, {}, {});\n", c_literal(spot.str()), spot.x, check::kSide - 1 - spot.y);
        }
    }
    return text + (of.is_of_vertices() ? kEndOfVertices : "}\n");
}

std::string program(const Case& of, const std::vector<Finding>& wrong) {
    const CommandList scene = c_scene(*of.scene);
    return "#define GL_GLEXT_PROTOTYPES\n#include <GL/freeglut.h>\n#include <math.h>\n#include <stdio.h>\n#include "
           "<stdlib.h>\n\n" +
           print_c_function(scene, "draw_scene") + show_function(of, wrong) + kMain;
}

// "A vertex ..." of "a vertex ...": a name such as "glColor(...)" or a symbol ("z = -0.5") stays as it is.
std::string capitalised(std::string text) {
    const std::string first = text.substr(0, text.find(' '));
    const bool is_word =
        std::ranges::all_of(first, [](unsigned char c) { return std::islower(c) || c == ',' || c == ':' || c == '-'; });
    if (is_word && (first.size() > 1 || first == "a"))
        text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    return text;
}

// A sentence, whether or not the text ends with a full stop.
std::string sentence(const std::string& text) { return capitalised(text) + (text.ends_with('.') ? "" : "."); }

// What the driver's fixed function gives at the places where it is wrong.
std::vector<Finding> wrong_findings(const check::Result& result) {
    std::vector<Finding> wrong;
    if (!result.error.empty()) return wrong;
    for (const Finding& finding : result.findings)
        if (finding.path == Path::kFixed &&
            (finding.outcome == check::Outcome::kKnownBug || finding.outcome == check::Outcome::kNewBug))
            wrong.push_back(finding);
    return wrong;
}

// A case with a bug: `name` is that of the listed bug, or empty.
struct Shown {
    const Case* of;
    std::vector<Finding> wrong;
    std::string name;
    std::vector<std::string> others{};  // cases with the same bug
};

std::string report_text(const std::string& driver, const Shown& shown) {
    const Case& of = *shown.of;
    std::string text = fmt::format("# {}\n\nDriver: {}\\\nSpecification: OpenGL 2.1, section {}\n",
                                   capitalised(of.what), driver, of.text);
    if (!shown.name.empty()) text.insert(text.size() - 1, fmt::format("\\\nKnown as: {}", shown.name));
    text += "\n| place | the driver gives | right |\n|---|---|---|\n";
    for (const Finding& finding : shown.wrong)
        text += fmt::format("| {} | {} | {} |\n", finding.spot.str(), check::text_of(finding.value),
                            check::text_of(finding.expected));
    text +=
        fmt::format("\n**Why it is hard.** {}\n\n**Why this is right.** {}\n", sentence(of.why), sentence(of.derived));
    if (const compare::Departure* bug = compare::find_departure(shown.name); bug && !bug->where.empty())
        text += fmt::format("\n**Where.** {}.\n", bug->where);
    if (!shown.others.empty()) text += fmt::format("\n**Other cases.** {}.\n", fmt::join(shown.others, ", "));
    return text + fmt::format(
                      "\n**Program.** `cc -std=c99 {0}.c -o {0} -lglut -lGL -lm && ./{0}` prints what the driver "
                      "gives:\n\n```c\n{1}```\n",
                      of.name, program(of, shown.wrong));
}

}  // namespace

std::vector<NamedFile> case_reports(const std::string& driver, std::span<const Case> cases,
                                    std::span<const check::Result> results) {
    std::vector<Shown> bugs;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        Shown shown{&cases[i], wrong_findings(results[i]), ""};
        if (shown.wrong.empty()) continue;
        shown.name = shown.wrong.front().name;
        const auto same = shown.name.empty() ? bugs.end() : std::ranges::find(bugs, shown.name, &Shown::name);
        if (same == bugs.end()) {
            bugs.push_back(std::move(shown));
            continue;
        }
        const auto length = [](const Shown& one) { return one.of->scene->commands.size(); };
        if (length(shown) < length(*same)) {
            shown.others = std::move(same->others);
            std::swap(*same, shown);
        }
        same->others.push_back(shown.of->name);
    }
    std::vector<NamedFile> reports;
    for (Shown& bug : bugs) {
        std::ranges::sort(bug.others);
        reports.push_back({bug.of->name + ".md", report_text(driver, bug)});
    }
    return reports;
}

}  // namespace twinlight::conformance
