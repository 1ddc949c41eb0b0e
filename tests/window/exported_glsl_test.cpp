// twinlight export --as glsl -o, to its end: the program is compiled, runs with the real freeglut in a core context
// under Xvfb, and draws what the fixed function draws; also after lights and the camera have moved. A legacy program that is
// ported by the lines of docs/porting.md draws what it drew.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <regex>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "../unit/pictures.h"
#include "../unit/run_program.h"
#include "base/image/difference.h"
#include "base/image/file.h"
#include "judge/compare/allowances.h"
#include "judge/compare/departures.h"
#include "render/reference/reference.h"
#include "scene/recorded/recorded_frame.h"
#include "scene/scenes/load.h"
#include "scene/state/state.h"
#include "xvfb.h"

namespace twinlight::exported_glsl_test {
namespace {

// A scene for tests: every kind of light, two-sided and colour materials, flat quadrilaterals, scaled normals, fog, a
// clip plane, an alpha test, textures of one and two dimensions. CAMERA and SHIFT are replaced.
constexpr const char* kScene = R"(
glClearColor(0.2, 0.25, 0.3, 1);
glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
glMatrixMode(GL_PROJECTION); gluPerspective(40, 4.0 / 3.0, 1, 100);
glMatrixMode(GL_MODELVIEW);
CAMERA
glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){SHIFT, 3, -4, 1});
glLightf(GL_LIGHT0, GL_CONSTANT_ATTENUATION, 0.5); glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 0.05);
glLightfv(GL_LIGHT0, GL_AMBIENT, (GLfloat[]){0.1, 0.1, 0.15, 1});
gluLookAt(0, 3, 11,  0, 0, 0,  0, 1, 0);
glLightfv(GL_LIGHT1, GL_POSITION, (GLfloat[]){-1, 2, 0.83, 0});
glLightfv(GL_LIGHT1, GL_DIFFUSE, (GLfloat[]){0.3, 0.25, 0.2, 1});
glLightfv(GL_LIGHT1, GL_SPECULAR, (GLfloat[]){0.4, 0.4, 0.4, 1});
glLightfv(GL_LIGHT2, GL_POSITION, (GLfloat[]){0, 5, 0, 1});
glLightfv(GL_LIGHT2, GL_SPOT_DIRECTION, (GLfloat[]){0, -1, 0.1});
glLightf(GL_LIGHT2, GL_SPOT_CUTOFF, 50); glLightf(GL_LIGHT2, GL_SPOT_EXPONENT, 3.5);
glLightfv(GL_LIGHT2, GL_DIFFUSE, (GLfloat[]){0.6, 0.5, 0.9, 1});
glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glEnable(GL_LIGHT1); glEnable(GL_LIGHT2);
glEnable(GL_DEPTH_TEST); glEnable(GL_RESCALE_NORMAL);
glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, (GLfloat[]){0.5, 0.5, 0.5, 1});
glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 20);

glPushMatrix(); glTranslatef(-3, 0, 0); glScalef(1.5, 1.5, 1.5); glutSolidSphere(0.8, 24, 12); glPopMatrix();
glDisable(GL_RESCALE_NORMAL); glEnable(GL_NORMALIZE);

// Both sides, cut by a clip plane.
glClipPlane(GL_CLIP_PLANE2, (GLdouble[]){0, -1, 0, 0.5}); glEnable(GL_CLIP_PLANE2);
glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1); glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
glMaterialfv(GL_BACK, GL_DIFFUSE, (GLfloat[]){0.9, 0.3, 0.2, 1});
glutSolidSphere(1.1, 24, 12);
glDisable(GL_CLIP_PLANE2);
glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 0); glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 0);

// Colours with each vertex, separate highlights.
glEnable(GL_COLOR_MATERIAL); glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
glBegin(GL_TRIANGLES);
glNormal3f(0, 0.3, 1); glColor3f(1, 0, 0); glVertex3f(2, -1, 0);
glColor3f(0, 1, 0); glVertex3f(4, -1, 0);
glColor3f(0, 0, 1); glVertex3f(3, 1, 0);
glEnd();
glColor3f(0.7, 0.7, 0.5);
glDisable(GL_COLOR_MATERIAL);
glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SINGLE_COLOR);

// Flat quadrilaterals in fog.
glEnable(GL_FOG); glFogi(GL_FOG_MODE, GL_EXP2); glFogf(GL_FOG_DENSITY, 0.05);
glFogfv(GL_FOG_COLOR, (GLfloat[]){0.2, 0.25, 0.3, 1});
glShadeModel(GL_FLAT);
glPushMatrix(); glTranslatef(-2, -1.5, 1); glRotatef(20, 1, 1, 0); glutSolidCube(0.9); glPopMatrix();
glShadeModel(GL_SMOOTH); glDisable(GL_FOG);

// A texture with holes.
glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE,
    (GLubyte[]){255, 0, 0, 255,  0, 255, 0, 60,  0, 0, 255, 60,  255, 255, 0, 255});
glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
glEnable(GL_TEXTURE_2D); glEnable(GL_ALPHA_TEST); glAlphaFunc(GL_GREATER, 0.5);
glBegin(GL_TRIANGLES);
glNormal3f(0, 0, 1);
glTexCoord2f(0, 0); glVertex3f(0, -2.5, 2);
glTexCoord2f(3, 0); glVertex3f(3, -2.5, 2);
glTexCoord2f(0, 3); glVertex3f(0, -1, 2);
glEnd();
glDisable(GL_ALPHA_TEST); glDisable(GL_TEXTURE_2D);

// A texture of one dimension, without lighting, blended.
glTexImage1D(GL_TEXTURE_1D, 0, GL_LUMINANCE, 4, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, (GLubyte[]){20, 90, 170, 250});
glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
glEnable(GL_TEXTURE_1D); glDisable(GL_LIGHTING);
glEnable(GL_BLEND); glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA); glColor4f(1, 0.8, 0.6, 0.75);
glBegin(GL_TRIANGLE_STRIP);
glTexCoord1f(0.1); glVertex3f(-4, 1.5, 0);
glTexCoord1f(1.7); glVertex3f(4, 1.5, 0);
glTexCoord1f(0.1); glVertex3f(-4, 2, 0);
glTexCoord1f(1.7); glVertex3f(4, 2, 0);
glEnd();
)";

// f_i jumps where n.VP is 0, so rounding would decide there whether a vertex has a highlight. In this scene no vertex
// is such.
void expect_no_light_at_horizon(const Frame& frame) {
    const auto rule =
        std::ranges::find(compare::departures(), "light at the horizon of a vertex", &compare::Departure::name);
    ASSERT_NE(rule, compare::departures().end());
    for (const Draw* draw : frame.draws())
        for (const Vertex& vertex : draw->vertices) ASSERT_FALSE(rule->vertex_rule(*draw, vertex)) << draw->place.str();
}

std::string scene_with(const std::string& camera, const std::string& shift) {
    std::string text = kScene;
    text.replace(text.find("CAMERA"), 6, camera);
    return text.replace(text.find("SHIFT"), 5, shift);
}

Image picture_of(const std::string& ppm) {
    int width = 0, height = 0, most = 0;
    char p = 0, six = 0;
    std::istringstream head(ppm);
    head >> p >> six >> width >> height >> most;
    Image image(width, height, {0, 0, 0, 1});
    const std::size_t first = static_cast<std::size_t>(head.tellg()) + 1;
    if (ppm.size() != first + image.pixels.size() * 3) throw std::runtime_error("not a picture");
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            image.pixels[i][c] = static_cast<float>(static_cast<unsigned char>(ppm[first + 3 * i + c])) / 255;
    return image;
}

class ExportedGlsl : public testing::Test {
  protected:
    void SetUp() override {
        if (run_shell("", "command -v " + compiler_).status != 0) GTEST_SKIP() << "there is no C compiler";
        if (!server_.running()) GTEST_SKIP() << server_.reason();
    }

    // Exports and compiles the scene; returns the folder of the program.
    std::string compiled(const std::string& scene, const std::vector<std::string>& options) {
        const std::string folder = folder_ / ("export" + std::to_string(++count_));
        std::vector<std::string> words = {"export", scene, "--as", "glsl", "-o", folder};
        words.insert(words.end(), options.begin(), options.end());
        const ProgramResult exported = run_program("twinlight", words);
        EXPECT_EQ(exported.status, 0) << exported.err;
        EXPECT_EQ(exported.out + exported.err, "");
        const ProgramResult built = run_shell("", "cd " + quoted(folder) + " && " + compiler_ +
                                                      " -std=c99 -Wall -Wextra -Werror *.c -o scene -lglut -lGL -lm");
        EXPECT_EQ(built.status, 0) << built.err;
        return folder;
    }

    Image drawn(const std::string& folder, const std::string& arguments = "") {
        const ProgramResult result = run_shell("", "cd " + quoted(folder) + " && DISPLAY=" + server_.display() +
                                                       " LIBGL_ALWAYS_SOFTWARE=1 ./scene -o picture.ppm " + arguments);
        EXPECT_EQ(result.status, 0) << result.err;
        EXPECT_EQ(result.err, "");
        return picture_of(read_file(folder + "/picture.ppm"));
    }

    // Shaders follow the scene's variants.
    Image rendered(const std::string& scene, const std::vector<std::string>& options) {
        std::vector<std::string> words = {"render", scene, "-o", folder_ / "render.png"};
        if (std::ranges::find(options, "fixed") == options.end()) words.emplace_back("--variants");
        words.insert(words.end(), options.begin(), options.end());
        const ProgramResult result = run_program("twinlight", words);
        EXPECT_EQ(result.status, 0) << result.err;
        return read_png(folder_ / "render.png");
    }

    // The bar of docs/architecture.md, "The judge": in the interior 1/255, in few pixels; filters, blending and ties in
    // rounding have their allowed difference. Edges: two programs round positions differently, which moves a border
    // across few centres of pixels.
    static void expect_close(const std::string& scene, const Image& picture, const Image& expected,
                             std::optional<Shading> shading = {}) {
        expect_close(make_frame(*load_commands(scene), {}), picture, expected, shading);
    }
    static void expect_close(const Frame& frame, const Image& picture, const Image& expected,
                             std::optional<Shading> shading = {}) {
        const reference::Options options{{.shading = shading}};
        AllowedDifference allowed = reference::allowed_difference(frame, options);
        compare::allow_ties(allowed, reference::render(frame, options));
        const ImageDifference found = difference(picture, expected, allowed);
        constexpr double kRoundingOf8Bits = 1.001 / 255, kShare = 0.001, kEdgeShare = 0.02;
        const RegionDifference& interior = found.beyond_allowed;
        EXPECT_LE(interior.max, kRoundingOf8Bits) << "at " << interior.worst_x << "," << interior.worst_y;
        EXPECT_LE(interior.differing_share(), kShare);
        EXPECT_LE(share_of_moved_edges(picture, expected, allowed.edge), kEdgeShare);
    }

    // The share of edge pixels that differ by more than filters do: llvmpipe rounds each mean to 8 bits, and a lookup between two
    // levels of a texture takes three means in a row.
    static double share_of_moved_edges(const Image& picture, const Image& expected, const PixelMask& edge) {
        constexpr double kRoundingOfFilters = 3.001 / 255;
        double edges = 0, moved = 0;
        for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
            if (!edge[i]) continue;
            ++edges;
            for (std::size_t c = 0; c < 3; ++c) {
                if (std::abs(picture.pixels[i][c] - expected.pixels[i][c]) <= kRoundingOfFilters) continue;
                ++moved;
                break;
            }
        }
        return edges == 0 ? 0 : moved / edges;
    }

    const std::string compiler_ = "${CC:-gcc}";
    Xvfb server_;
    TemporaryFolder folder_;
    int count_ = 0;
};

TEST_F(ExportedGlsl, DrawsWhatTheFixedFunctionDrawsInEveryVersion) {
    const std::string scene = folder_ / "all.gl";
    write_file_atomically(scene, scene_with("", "2"));
    const Image fixed = rendered(scene, {"--with", "fixed"});
    for (const char* version : {"330", "130", "300es"}) {
        SCOPED_TRACE(version);
        expect_close(scene, drawn(compiled(scene, {"--glsl", version})), fixed);
    }
}

// The lecture's variants, phong shading and what a driver is known to draw wrong: compared with the reference.
TEST_F(ExportedGlsl, DrawsWhatTheReferenceDraws) {
    const auto check = [&](const char* scene, std::optional<Shading> shading) {
        SCOPED_TRACE(scene);
        std::vector<std::string> options;
        if (shading) options = {"--shading", name_of(*shading)};
        const Image picture = drawn(compiled(scene, options));
        options.insert(options.end(), {"--with", "reference"});
        expect_close(scene, picture, rendered(scene, options), shading);
    };
    check("report", {});
    check("report", Shading::kPhong);
    check("lab", {});
    check("lab", Shading::kPhong);
    check("commands", {});
}

// The depths that the scene copies are in scene.bin.
TEST_F(ExportedGlsl, DrawsTexturesOfDepths) {
    const std::string scene = folder_ / "shadows.gl";
    write_file_atomically(scene,
                          run_program("twinlight", {"export", "shadow-map", "--step", "2", "--as", "scene"}).out);
    const Image expected = rendered(scene, {"--with", "reference"});
    for (const char* version : {"330", "130", "300es"}) {
        SCOPED_TRACE(version);
        expect_close(scene, drawn(compiled(scene, {"--glsl", version})), expected);
    }
}

// Lists that are called at several places, call each other, set state and matrices, and place a light.
TEST_F(ExportedGlsl, DrawsDisplayLists) {
    const std::string scene = folder_ / "lists.gl";
    write_file_atomically(scene, R"(
glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
glMatrixMode(GL_PROJECTION); gluPerspective(40, 4.0 / 3.0, 1, 100); glMatrixMode(GL_MODELVIEW);
gluLookAt(0, 3, 11,  0, 0, 0,  0, 1, 0);
glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glEnable(GL_DEPTH_TEST); glEnable(GL_NORMALIZE);
glNewList(1, GL_COMPILE);
glMaterialfv(GL_FRONT, GL_DIFFUSE, (GLfloat[]){0.8, 0.3, 0.2, 1}); glutSolidSphere(0.5, 16, 8);
glPushMatrix(); glTranslatef(0, 0.7, 0); glRotatef(30, 0, 0, 1); glScalef(1, 0.5, 1);
glMaterialfv(GL_FRONT, GL_DIFFUSE, (GLfloat[]){0.2, 0.5, 0.3, 1}); glutSolidCube(0.8); glPopMatrix();
glEndList();
glNewList(2, GL_COMPILE);
glPushMatrix(); glTranslatef(-0.6, 0, 0); glCallList(1); glTranslatef(1.2, 0, 0.3); glScalef(1, 1.4, 1);
glShadeModel(GL_FLAT); glCallList(1); glShadeModel(GL_SMOOTH); glPopMatrix();
glEndList();
glNewList(3, GL_COMPILE);
glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){-1, 0, 1, 0}); glutSolidSphere(0.4, 12, 8);
glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){1, 0, 1, 0}); glTranslatef(0, 1, 0); glutSolidSphere(0.4, 12, 8);
glEndList();
glPushMatrix(); glTranslatef(-2.5, 0, 0); glCallList(2); glPopMatrix();
glPushMatrix(); glTranslatef(0, -1.2, 0); glRotatef(50, 0, 1, 0); glCallList(2); glPopMatrix();
glPushMatrix(); glTranslatef(0, 1.5, 0); glScalef(0, 0, 0); glCallList(1); glPopMatrix();
// The shadow on a plane: its matrix has no inverse.
glDisable(GL_LIGHTING); glColor3f(0.3, 0.3, 0.3);
glPushMatrix(); glTranslatef(-2.5, -2, 0);
glMultMatrixf((GLfloat[]){1.7, 0, 0, 0,  -0.3, 0, -0.7, 0,  0, 0, 1.7, 0,  0, 0, 0, 1.7}); glCallList(2); glPopMatrix();
glEnable(GL_LIGHTING);
glTranslatef(2.8, 0, 0); glCallList(3);
)");
    const std::string folder = compiled(scene, {});
    expect_close(scene, drawn(folder), rendered(scene, {"--with", "fixed"}));
    const std::string text = read_file(folder + "/scene.c");
    for (const char* function : {"void list1(void)", "void list2(void)"})
        EXPECT_NE(text.find(function), text.npos) << function << " in\n" << text;
    EXPECT_EQ(text.find("void list3"), text.npos) << "its light needs the camera's matrix\n" << text;
}

TEST_F(ExportedGlsl, DrawsRecordings) {
    for (const char* name : {"cage", "circuit", "glxgears", "hilbert", "menger", "stonerview"}) {
        SCOPED_TRACE(name);
        const std::string recording = fmt::format("tests/traces/{}/dump.txt", name);
        const Frame frame = make_recorded_frame(load_recording(recording), {}).scene.frame;
        expect_close(frame, drawn(compiled(recording, {})), rendered(recording, {"--with", "fixed"}));
    }
}

// Each frame is the picture of its own export.
TEST_F(ExportedGlsl, PlaysTheFramesOfARecording) {
    for (const auto& [name, last] : {std::pair("dangerball", 2), {"cubestorm", 2}, {"lattice", 4}}) {
        const std::string recording = fmt::format("tests/traces/{}/dump.txt", name);
        const std::string folder = compiled(recording, {"--frames", fmt::format("{}-{}", last - 1, last)});
        const std::string number = std::to_string(last);
        const Image expected = drawn(compiled(recording, {"--frame", number}));
        const Image picture = drawn(folder, "--frame " + number);
        EXPECT_EQ(difference(picture, expected, PixelMask(picture.pixels.size())).interior.differing, 0U) << name;
        const Image first = drawn(folder);
        EXPECT_EQ(difference(first, drawn(folder, fmt::format("--frame {}", last - 1)), PixelMask(first.pixels.size()))
                      .interior.differing,
                  0U);
        EXPECT_NE(read_file(folder + "/scene.c").find(fmt::format("    {{{}, draw_", last - 1)), std::string::npos);
    }
}

// The camera turns around the scene's middle, and GL_LIGHT0 moves in the coordinates of the scene's own camera, far
// enough that it shines on other faces and from behind.
TEST_F(ExportedGlsl, StaysRightWhenLightsAndTheCameraMove) {
    const std::string scene = folder_ / "still.gl", moved = folder_ / "moved.gl";
    write_file_atomically(scene, scene_with("", "2"));
    const std::string folder = compiled(scene, {});
    std::smatch middle;
    const std::string text = read_file(folder + "/scene.c");
    ASSERT_TRUE(std::regex_search(text, middle, std::regex("scene_middle\\[3\\] = \\{(\\S+), (\\S+), (\\S+)\\}")));
    const auto at = [&](int i) { return std::stod(middle[static_cast<std::size_t>(i)]); };
    const Image still = drawn(folder);
    for (const int turn_deg : {40, 130, 150, 250}) {
        SCOPED_TRACE(turn_deg);
        std::ostringstream camera;
        camera.precision(9);
        camera << "glTranslatef(" << at(1) << ", " << at(2) << ", " << at(3) << "); glRotatef(" << turn_deg
               << ", 0, 1, 0); glTranslatef(" << -at(1) << ", " << -at(2) << ", " << -at(3) << ");";
        write_file_atomically(moved, scene_with(camera.str(), "-6"));
        expect_no_light_at_horizon(make_frame(*load_commands(moved), {}));
        const Image picture = drawn(folder, "--turn " + std::to_string(turn_deg) + " --light 0 -8 0 0");
        expect_close(moved, picture, rendered(moved, {"--with", "fixed"}));
        EXPECT_GT(difference(picture, still, PixelMask(still.pixels.size())).interior.differing, 10'000U);
    }
}

// ---- A porter's program ----

// The code blocks of docs/porting.md, without their indentation.
std::vector<std::string> blocks_of_the_docs() {
    std::vector<std::string> blocks;
    std::istringstream page(read_file("docs/porting.md"));
    bool inside = false;
    std::string blank;
    for (std::string line; std::getline(page, line);) {
        if (line.starts_with("    ")) {
            if (!inside) blocks.emplace_back();
            blocks.back() += (inside ? blank : "") + line.substr(4) + "\n";
            inside = true;
            blank.clear();
        } else if (line.empty()) {
            blank += "\n";
        } else {
            inside = false;
            blank.clear();
        }
    }
    return blocks;
}

class PortedProgram : public ExportedGlsl {
  protected:
    void SetUp() override {
        if (run_shell("", "command -v " + compiler_).status != 0) GTEST_SKIP() << "there is no C compiler";
    }
    void run(const std::string& line) {
        const ProgramResult result = run_shell("", "cd " + quoted(folder_.str()) + " && " + line);
        EXPECT_EQ(result.status, 0) << line << "\n" << result.err;
        EXPECT_EQ(result.err, "") << line;
    }
    const std::string twinlight_ = quoted(std::filesystem::absolute(build_folder() + "/twinlight"));
    // Compiles `program` with the exported files, and with EGL in place of a window. Returns what it wrote to stderr.
    std::string drawn_by(const std::string& program) {
        run(
            fmt::format("{} -std=c99 -Wall -Wextra -Wpedantic -Werror {} shaders/gl_state.c shaders/kinds.c {} -o "
                        "ported -lEGL -lGL -lm",
                        compiler_, program, quoted(std::filesystem::absolute("tests/window/glut_on_egl.c"))));
        const ProgramResult result =
            run_shell("", "cd " + quoted(folder_.str()) + " && LIBGL_ALWAYS_SOFTWARE=1 ./ported");
        EXPECT_EQ(result.status, 0) << result.err;
        return result.err;
    }
};

TEST_F(PortedProgram, DrawsThePictureOfBefore) {
    const std::vector<std::string> blocks = blocks_of_the_docs();
    const auto block = [&](const char* start) {
        const auto found =
            std::ranges::find_if(blocks, [&](const std::string& text) { return text.starts_with(start); });
        EXPECT_NE(found, blocks.end()) << start;
        return found == blocks.end() ? std::string() : *found;
    };
    const std::string before = folder_ / "before.c", lamp = folder_ / "lamp.c";
    write_file_atomically(before, block("// lamp.c"));
    write_file_atomically(lamp, block("// lamp.c"));
    run(std::regex_replace(block("build/twinlight export lamp.c"), std::regex("^build/twinlight"), twinlight_));
    run(block("sed "));

    // The lines at the top, before glutCreateWindow, and after it.
    const std::vector<std::string> added = [&] {
        std::vector<std::string> parts(1);
        std::istringstream lines(block("#include \"shaders/gl_state.h\""));
        for (std::string line; std::getline(lines, line);)
            if (line.empty())
                parts.emplace_back();
            else
                parts.back() += line + "\n";
        return parts;
    }();
    ASSERT_EQ(added.size(), 3U);
    std::string text = added[0] + read_file(lamp);
    const std::size_t window = text.rfind('\n', text.find("glutCreateWindow")) + 1;
    text.insert(text.find('\n', window) + 1, added[2]);
    text.insert(window, added[1]);
    write_file_atomically(lamp, text);

    EXPECT_NE(block("cc lamp.c shaders/gl_state.c shaders/kinds.c"), "");
    EXPECT_EQ(drawn_by("lamp.c"), "");
    const std::string scene = folder_ / "before.gl";
    write_file_atomically(scene, run_program("twinlight", {"export", before, "--as", "scene"}).out);
    expect_close(scene, picture_of(read_file(folder_ / "picture.ppm")), rendered(before, {"--with", "fixed"}));
}

// Each function of gl_state.h that GL or GLU has is renamed.
TEST_F(PortedProgram, HasARenameForEachFunction) {
    const std::string header = read_file("src/render/programmable/export/gl_state.h");
    const std::string of_gl = header.substr(0, header.find("---- Not in GL ----"));
    const std::regex name(R"((?:void|GLboolean|#define) ff(\w+))");
    std::string calls, renamed;
    for (auto it = std::sregex_iterator(of_gl.begin(), of_gl.end(), name); it != std::sregex_iterator(); ++it) {
        const std::string function = it->str(1);
        const bool is_of_glu = function == "Perspective" || function == "LookAt" || function == "Ortho2D";
        calls += (is_of_glu ? "glu" : "gl") + function + "();\n";
        renamed += "ff" + function + "();\n";
    }
    EXPECT_GT(std::ranges::count(calls, '\n'), 80);
    const std::string kept = "glEndList();\nglBindTexture();\nglutInit();\nglLightness();\nmy_glEnd();\n";
    write_file_atomically(folder_ / "calls.c", calls + kept);
    const std::string script = std::filesystem::absolute("src/render/programmable/export/names.sed");
    run("sed -E -i -f " + quoted(script) + " calls.c");
    EXPECT_EQ(read_file(folder_ / "calls.c"), renamed + kept);
}

TEST_F(PortedProgram, CompilesAsCPlusPlusAndWithoutTheOldNames) {
    run_program("twinlight", {"export", "report", "--as", "glsl", "-o", folder_ / "shaders"});
    run("g++ -Wall -Wextra -Wpedantic -Wshadow -Werror -fsyntax-only -x c++ shaders/gl_state.c shaders/kinds.c");
    run(compiler_ +
        " -std=c99 -Wall -Wextra -Wpedantic -Werror -DGL_GLEXT_PROTOTYPES -DGL_STATE_HEADER='<GL/glcorearb.h>' "
        "-fsyntax-only shaders/gl_state.c shaders/kinds.c");
}

// One light, positional and without a highlight. Each change after it needs shaders that were not exported.
TEST_F(PortedProgram, SaysWhatItsShadersCannotDraw) {
    write_file_atomically(folder_ / "plain.gl",
                          "glMaterialf(GL_FRONT, GL_SHININESS, 0);\n"
                          "glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glEnable(GL_NORMALIZE);\n"
                          "glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){1, 2, 3, 1});\n"
                          "glBegin(GL_TRIANGLES); glNormal3f(0, 0, 1);\n"
                          "glVertex3f(0, 0, 0); glVertex3f(1, 0, 0); glVertex3f(0, 1, 0); glEnd();\n");
    run(twinlight_ + " export plain.gl --as glsl -o shaders");

    struct Change {
        const char* change;
        const char* says;
        const char* back;
    };
    const std::vector<Change> changes = {
        {"ffEnable(GL_LIGHT1); ffLightfv(GL_LIGHT1, GL_DIFFUSE, white);", "GL_LIGHT1 shines", "ffDisable(GL_LIGHT1);"},
        {"ffDisable(GL_LIGHTING);", "GL_LIGHTING is off", "ffEnable(GL_LIGHTING);"},
        {"ffLightfv(GL_LIGHT0, GL_POSITION, toward);", "GL_LIGHT0 is directional",
         "ffLightfv(GL_LIGHT0, GL_POSITION, here);"},
        {"ffLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 1);", "GL_LIGHT0 has an attenuation",
         "ffLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 0);"},
        {"w = 2;", "a vertex's w is not 1", "w = 1;"},
        {"ffLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 30);", "GL_LIGHT0 is a spotlight",
         "ffLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 180);"},
        {"ffMaterialfv(GL_FRONT, GL_SPECULAR, white);", "a colour of GL_LIGHT0 times the material's is no longer black",
         "ffMaterialfv(GL_FRONT, GL_SPECULAR, black);"},
        {"ffLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);", "GL_LIGHT_MODEL_TWO_SIDE is on",
         "ffLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 0);"},
        {"ffDisable(GL_NORMALIZE);", "GL_NORMALIZE is off", "ffEnable(GL_NORMALIZE);"},
        {"ffShadeModel(GL_FLAT);", "glShadeModel is GL_FLAT", "ffShadeModel(GL_SMOOTH);"},
        {"ffEnable(GL_FOG);", "fog of this mode is on", "ffDisable(GL_FOG);"},
        {"ffEnable(GL_ALPHA_TEST); ffAlphaFunc(GL_GREATER, 0.5f);", "the alpha test has another function",
         "ffDisable(GL_ALPHA_TEST);"},
        {"ffEnable(GL_CLIP_PLANE2);", "GL_CLIP_PLANE2 is on", "ffDisable(GL_CLIP_PLANE2);"},
        {"ffEnable(GL_TEXTURE_2D);", "a texture of this target is on", "ffDisable(GL_TEXTURE_2D);"},
        {"ffEnable(GL_COLOR_MATERIAL); color = 1;",
         "glColorMaterial takes other colours of the material from the vertices",
         "ffDisable(GL_COLOR_MATERIAL); color = 0;"}};
    std::string body, expected;
    for (int round = 0; round < 2; ++round)
        for (const auto& [change, says, back] : changes)
            body += fmt::format("    {}\n    draw();\n    {}\n", change, back);
    for (const Change& change : changes)
        expected += fmt::format(
            "gl_state: {}: no exported shaders do that, so GL_TRIANGLES draws with kind1, of plain.gl:4:1; let the "
            "program draw it so in the frame that you export\n",
            change.says);
    write_file_atomically(folder_ / "changes.c", R"(#include <GL/freeglut.h>
#include "shaders/gl_state.h"
static int color;
static float w = 1;
static void draw(void) {
    ffBegin(GL_TRIANGLES);
    ffNormal3f(0, 0, 1);
    ffColor3f(1, 1, 1);
    ffVertex3f(0, 0, 0);
    if (color) ffColor3f(1, 0, 0);
    ffVertex4f(1, 0, 0, w);
    ffVertex3f(0, 1, 0);
    ffEnd();
}
static void display(void) {
    const GLfloat white[4] = {1, 1, 1, 1}, black[4] = {0, 0, 0, 1}, toward[4] = {1, 2, 3, 0},
                  here[4] = {1, 2, 3, 1};
    ffEnable(GL_LIGHTING);
    ffEnable(GL_LIGHT0);
    ffEnable(GL_NORMALIZE);
    ffLightfv(GL_LIGHT0, GL_POSITION, here);
    draw();  // says nothing
)" + body + R"(}
int main(int argc, char** argv) {
    glutInit(&argc, argv);
    glutInitContextVersion(3, 3);
    glutInitContextProfile(GLUT_CORE_PROFILE);
    glutCreateWindow("changes");
    if (!ffInit("shaders")) return 1;
    glutDisplayFunc(display);
    glutMainLoop();
}
)");
    EXPECT_EQ(drawn_by("changes.c"), expected);
}

}  // namespace
}  // namespace twinlight::exported_glsl_test
