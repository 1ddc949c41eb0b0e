// twinlight export --as wgsl and vulkan, to their end: compilers accept the shaders of every built-in scene, and the page for WebGPU draws what
// the reference draws.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "../unit/effort.h"
#include "../unit/run_program.h"
#include "base/image/file.h"
#include "base/image/named_file.h"
#include "base/text/json.h"
#include "browser.h"
#include "drawn_by_swiftshader.h"
#include "render/reference/copied_pixels.h"
#include "render/webgpu/ported_files.h"
#include "scene/scenes/load.h"
#include "scene/state/state.h"

namespace twinlight::ported_shaders_test {
namespace {

using webgpu::Target;

// Lit and flat quadrilaterals, two sides, spots, rescaled normals, a texture of one dimension, generated texture coordinates, the alpha test,
// a cube map, a clip plane, blending, a scissor around a glClear, fog, separate specular colours.
constexpr const char* kScene = R"(
glClearColor(0.2, 0.25, 0.35, 1); glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
glEnable(GL_SCISSOR_TEST); glScissor(400, 20, 200, 100); glClearColor(0.4, 0.2, 0.1, 1); glClear(GL_COLOR_BUFFER_BIT);
glDisable(GL_SCISSOR_TEST);
glMatrixMode(GL_PROJECTION); gluPerspective(40, 4.0 / 3.0, 1, 100);
glMatrixMode(GL_MODELVIEW); gluLookAt(0, 2, 9,  0, 0, 0,  0, 1, 0);
glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){2, 3, 4, 1});
glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 0.05);
glLightfv(GL_LIGHT3, GL_POSITION, (GLfloat[]){-1, 0, 1, 0});
glLightfv(GL_LIGHT3, GL_DIFFUSE, (GLfloat[]){0.3, 0.2, 0.1, 1});
glLightfv(GL_LIGHT3, GL_SPECULAR, (GLfloat[]){0.6, 0.1, 0.6, 1});
glLightfv(GL_LIGHT5, GL_POSITION, (GLfloat[]){-3, 2, 3, 1});
glLightfv(GL_LIGHT5, GL_SPOT_DIRECTION, (GLfloat[]){0.3, -0.5, -1});
glLightf(GL_LIGHT5, GL_SPOT_CUTOFF, 30); glLightf(GL_LIGHT5, GL_SPOT_EXPONENT, 5);
glLightfv(GL_LIGHT5, GL_DIFFUSE, (GLfloat[]){0.1, 0.4, 0.1, 1});
glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glEnable(GL_LIGHT3); glEnable(GL_LIGHT5); glEnable(GL_DEPTH_TEST);
glMaterialfv(GL_FRONT, GL_SPECULAR, (GLfloat[]){0.5, 0.5, 0.5, 1}); glMaterialf(GL_FRONT, GL_SHININESS, 20.5);
glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
glPushMatrix(); glTranslatef(-2, 0, 0); glScalef(0.5, 0.5, 0.5); glEnable(GL_RESCALE_NORMAL); glutSolidSphere(2, 24, 12);
glDisable(GL_RESCALE_NORMAL); glPopMatrix();
glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 0); glMaterialf(GL_FRONT, GL_SHININESS, 20);
glClipPlane(GL_CLIP_PLANE1, (GLdouble[]){0, -1, 0, 0.4}); glEnable(GL_CLIP_PLANE1);
glMaterialfv(GL_BACK, GL_DIFFUSE, (GLfloat[]){0.9, 0.4, 0.1, 1});
glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1); glutSolidSphere(0.9, 24, 12); glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 0);
glDisable(GL_CLIP_PLANE1);
glShadeModel(GL_FLAT); glEnable(GL_FOG); glFogf(GL_FOG_DENSITY, 0.05);
glPushMatrix(); glTranslatef(2, 0, 0); glRotatef(30, 1, 1, 0); glutSolidCube(1.1); glPopMatrix();
glDisable(GL_FOG); glShadeModel(GL_SMOOTH);
glTexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE,
    (GLubyte[]){20, 90, 170, 255,  250, 0, 0, 40,  0, 250, 90, 255,  90, 20, 60, 40});
glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_EYE_LINEAR);
glTexGenfv(GL_S, GL_EYE_PLANE, (GLfloat[]){0.3, 0.25, 0.35, 0.2});
glEnable(GL_TEXTURE_1D); glEnable(GL_TEXTURE_GEN_S);
glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
glPushMatrix(); glTranslatef(0, 1.6, 0); glutSolidSphere(0.5, 24, 12); glPopMatrix();
glDisable(GL_TEXTURE_GEN_S); glDisable(GL_LIGHTING);
glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
glEnable(GL_ALPHA_TEST); glAlphaFunc(GL_GREATER, 0.5);
glBegin(GL_QUAD_STRIP);
glTexCoord1f(0.1); glVertex3f(-3, -1.5, 0); glTexCoord1f(0.1); glVertex3f(-3, -2, 0);
glTexCoord1f(1.7); glVertex3f(3, -1.5, 0); glTexCoord1f(1.7); glVertex3f(3, -2, 0);
glEnd();
glDisable(GL_ALPHA_TEST); glDisable(GL_TEXTURE_1D);
glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE,
    (GLubyte[]){0, 90, 170, 255,  250, 0, 0, 255,  0, 250, 0, 255,  90, 20, 60, 255});
glTexImage2D(GL_TEXTURE_CUBE_MAP_NEGATIVE_X, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE,
    (GLubyte[]){40, 90, 170, 255,  250, 40, 0, 255,  0, 250, 40, 255,  90, 20, 60, 255});
glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_Y, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE,
    (GLubyte[]){80, 90, 170, 255,  250, 80, 0, 255,  0, 250, 80, 255,  90, 20, 60, 255});
glTexImage2D(GL_TEXTURE_CUBE_MAP_NEGATIVE_Y, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE,
    (GLubyte[]){120, 90, 170, 255,  250, 120, 0, 255,  0, 250, 120, 255,  90, 20, 60, 255});
glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_Z, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE,
    (GLubyte[]){160, 90, 170, 255,  250, 160, 0, 255,  0, 250, 160, 255,  90, 20, 60, 255});
glTexImage2D(GL_TEXTURE_CUBE_MAP_NEGATIVE_Z, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE,
    (GLubyte[]){200, 90, 170, 255,  250, 200, 0, 255,  0, 250, 200, 255,  90, 20, 60, 255});
glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR); glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE); glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
glEnable(GL_TEXTURE_CUBE_MAP);
glBegin(GL_TRIANGLES); glTexCoord3f(1, -0.9, -0.8); glVertex3f(-3, 1.1, 0); glTexCoord3f(1, 0.8, -0.7); glVertex3f(-1.4, 1.2, 0);
glTexCoord3f(1, 0.1, 0.9); glVertex3f(-2.1, 2.4, 0); glTexCoord3f(0.8, -0.7, -1); glVertex3f(1.1, 1.4, 0);
glTexCoord3f(-0.9, 0.1, -1); glVertex3f(2.7, 1.5, 0); glTexCoord3f(0.3, 0.8, -1); glVertex3f(1.6, 2.6, 0); glEnd();
glDisable(GL_TEXTURE_CUBE_MAP);
glEnable(GL_BLEND); glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA); glColor4f(1, 1, 0, 0.4);
glBegin(GL_TRIANGLE_FAN); glVertex3f(0.4, -0.9, 1); glVertex3f(2.6, -0.9, 1); glVertex3f(2.1, 1.1, 1); glVertex3f(0.6, 0.9, 1); glEnd();
)";

// Built-in scenes that the API cannot draw: part of the reason.
std::map<std::string, const char*> refused_by(Target target) {
    std::map<std::string, const char*> refused = {{"commands", "glPolygonMode"}, {"spectral", "spectra"}};
    if (target == Target::kWgsl) refused["shadow-map"] = "a depth texture";
    return refused;
}

std::vector<NamedFile> files_of(const std::string& scene, Target target) {
    const Frame frame = make_frame(*load_commands(scene), {});
    return webgpu::ported_files(*reference::drawable(frame, {}), {}, target, scene);
}

// The kinds of shaders of all built-in scenes, each once: a text for WebGPU, two for Vulkan.
std::set<std::vector<std::string>> all_kinds(Target target) {
    const std::size_t stages = target == Target::kWgsl ? 1 : 2;
    const std::map<std::string, const char*> refused = refused_by(target);
    std::set<std::vector<std::string>> kinds;
    for (const EmbeddedFile& file : kSceneFiles) {
        const std::string scene = built_in_name(file);
        const auto found = refused.find(scene);
        try {
            const std::vector<NamedFile> files = files_of(scene, target);
            for (std::size_t i = 0; files[i].name.starts_with("kind"); i += stages) {
                std::vector<std::string> kind;
                for (std::size_t stage = 0; stage < stages; ++stage) kind.push_back(files[i + stage].bytes);
                kinds.insert(kind);
            }
            EXPECT_EQ(found, refused.end()) << scene << " is drawn now";
        } catch (const std::runtime_error& error) {
            const std::string why = error.what(), expected = found == refused.end() ? "no reason" : found->second;
            EXPECT_NE(why.find(expected), std::string::npos) << scene << ": " << why;
        }
    }
    return kinds;
}

// It also links both stages: locations and blocks must agree.
TEST(PortedShaders, AreAcceptedByGlslang) {
    if (first_installed({"glslangValidator"}).empty())
        GTEST_SKIP() << "there is no glslangValidator (apt-get install glslang-tools)";
    const TemporaryFolder folder;
    const std::set<std::vector<std::string>> kinds = all_kinds(Target::kVulkan);
    EXPECT_GT(kinds.size(), 30U);
    std::vector<NamedFile> files;
    int number = 0;
    for (const std::vector<std::string>& kind : kinds) {
        if (!is_tried(number++)) continue;
        const std::string name = fmt::format("{}", number);
        files.push_back({name + ".vert", kind[0]});
        files.push_back({name + ".frag", kind[1]});
    }
    write_folder_atomically(folder / "shaders", files);
    const ProgramResult result = run_shell("", "cd " + quoted(folder / "shaders") +
                                                   " && ls *.vert | cut -d. -f1 | xargs -P \"$(nproc)\" -I K sh -c "
                                                   "'glslangValidator -V K.vert K.frag -o K.spv "
                                                   ">K.log || cat K.log >&2'");
    EXPECT_EQ(result.err, "");
}

TEST(PortedPage, DrawsWithWebGpuWhatTheReferenceDraws) {
    const std::string program = browser();
    if (program.empty()) GTEST_SKIP() << "there is no chromium (apt-get install chromium)";
    if (first_installed({"node"}).empty()) GTEST_SKIP() << "there is no node (apt-get install nodejs)";
    const TemporaryFolder folder;
    const std::string own = folder / "own.gl";
    write_file_atomically(own, kScene);
    struct Picture {
        std::string folder, scene;
        std::optional<Shading> shading{};
    };
    const Picture pictures[] = {{"own", own},
                                {"phong", own, Shading::kPhong},
                                {"lab", "lab"},
                                {"buffers", "buffers"},
                                {"solid", "solid-texture"}};
    for (const Picture& one : pictures) {
        std::vector<std::string> words = {"export", one.scene, "--as", "wgsl", "-o", folder / one.folder};
        if (one.shading) words.insert(words.end(), {"--shading", "phong"});
        const ProgramResult exported = run_program("twinlight", words);
        ASSERT_EQ(exported.status, 0) << exported.err;
    }
    nlohmann::json texts = nlohmann::json::array();
    for (const std::vector<std::string>& kind : all_kinds(Target::kWgsl)) texts.push_back(kind[0]);
    write_file_atomically(folder / "texts.json", texts.dump());

    const ProgramResult result =
        run_shell("", "timeout 120 node tests/web/webgpu.mjs " + quoted(folder.str()) + " " + program);
    ASSERT_EQ(result.status, 0) << result.err;
    const nlohmann::json told = nlohmann::json::parse(result.out);
    EXPECT_EQ(told.value("error", ""), "");
    if (told.contains("missing")) GTEST_SKIP() << told["missing"];
    EXPECT_EQ(told["refused"], nlohmann::json::array());
    for (const Picture& one : pictures) {
        SCOPED_TRACE(one.folder);
        const std::string url = told["pictures"][one.folder];
        ASSERT_TRUE(url.starts_with("data:image/png")) << url;
        expect_close(one.scene, picture_of_url(url, 640, 480), one.shading);
    }
}

}  // namespace
}  // namespace twinlight::ported_shaders_test
