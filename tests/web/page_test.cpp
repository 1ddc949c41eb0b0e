// The page in Chromium: what it does, and whether the pictures by its shaders agree with the reference.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <future>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include "../unit/effort.h"
#include "../unit/run_program.h"
#include "../window/browser.h"
#include "app/session/keys.h"
#include "app/session/tutor.h"
#include "app/web/page_scene.h"
#include "base/image/file.h"
#include "base/image/png.h"
#include "base/text/json.h"
#include "judge/check/case.h"
#include "scene/scenes/load.h"

namespace twinlight::web::page_test {

namespace {

using Json = nlohmann::json;

constexpr const char* kPage = "build/web/page";
constexpr const char* kOneFile = "build/web/twinlight.html";

// Pictures that differ with SwiftShader though the page names nothing that they lack.
const std::map<std::string, const char*>& known_differences() {
    static const std::map<std::string, const char*> known = {
        {"nan-vertex", "SwiftShader draws a triangle though a vertex has w = 0; ours becomes (0, 0, 0, 0)"},
        {"nan-vertex-infinite", "the same"},
        {"clipping-near-light-inside",
         "SwiftShader loses the colour of vertices with w = 0 (with w = 1e-6 it does not)"},
        {"point-level-of-detail", "SwiftShader does not add the bias at a point, as Mesa"},
        {"lab 5", "a pixel on the border of the spot's cone, where light begins within the rasteriser's rounding"},
    };
    return known;
}

// Whole pixels or shares of them decide these pictures, so all their pixels agree, also those at edges.
constexpr struct {
    const char *name, *text;
} kEqualScenes[] = {
    {"smooth lines", R"(
glClearColor(0.1, 0.2, 0.4, 1); glClear(GL_COLOR_BUFFER_BIT);
glEnable(GL_LINE_SMOOTH); glEnable(GL_BLEND); glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
glColor4f(1, 0.9, 0.2, 0.8);
glBegin(GL_LINES); glVertex2f(-0.93, -0.87); glVertex2f(-0.21, -0.85); glVertex2f(-0.9, -0.7); glVertex2f(-0.6, 0.9);
glVertex2f(-0.5, -0.7); glVertex2f(-0.5, 0.9); glVertex2f(-0.4, 0.8); glVertex2f(1.4, 0.93); glEnd();
glLineWidth(2.6);
glBegin(GL_LINE_LOOP); glVertex2f(-0.3, -0.6); glVertex2f(0.31, -0.47); glVertex2f(0.07, 0.19); glEnd();
glLineWidth(9); glColor3f(0.3, 1, 0.4);
glBegin(GL_LINE_STRIP); glVertex2f(-0.31, 0.31); glVertex2f(0.37, 0.73); glVertex2f(0.41, 0.33); glEnd();
glLineWidth(0.3); glBegin(GL_LINES); glVertex2f(-0.1, 0.23); glVertex2f(0.3, 0.21); glEnd();
glLineWidth(3); glPolygonMode(GL_FRONT_AND_BACK, GL_LINE); glColor3f(1, 0.4, 0.4); glRectf(0.53, -0.87, 0.91, -0.11);
glMatrixMode(GL_PROJECTION); glLoadIdentity(); gluPerspective(60, 1, 0.1, 100);
glBegin(GL_LINES); glVertex3f(0.9, 0.3, -2); glVertex3f(0.1, 0.2, 1); glEnd();
)"},
    {"smooth points", R"(
glClearColor(0.1, 0.2, 0.4, 1); glClear(GL_COLOR_BUFFER_BIT);
glEnable(GL_POINT_SMOOTH); glEnable(GL_BLEND); glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
glColor4f(1, 0.9, 0.2, 0.8);
glBegin(GL_POINTS); glVertex2f(-0.83, -0.77); glVertex2f(1.02, 0); glEnd();
glPointSize(0.4); glBegin(GL_POINTS); glVertex2f(-0.53, -0.71); glEnd();
glPointSize(5.3); glBegin(GL_POINTS); glVertex2f(-0.13, -0.72); glVertex2f(0.99, -0.7); glEnd();
glPointSize(17); glBegin(GL_POINTS); glVertex2f(0.31, -0.62); glEnd();
glPolygonMode(GL_FRONT_AND_BACK, GL_POINT); glEnable(GL_POLYGON_OFFSET_POINT); glPolygonOffset(0, 1); glPointSize(7);
glRectf(-0.71, 0.11, -0.33, 0.47);
glMatrixMode(GL_PROJECTION); glLoadIdentity(); gluPerspective(60, 1, 0.1, 100);
glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, (GLfloat[]){0, 0, 0.1}); glPointSize(8);
glBegin(GL_POINTS); glVertex3f(0.31, 0.3, -2); glVertex3f(1.33, 1.1, -4); glVertex3f(-0.21, 0.72, -2.5); glEnd();
)"},
    {"sprites from below", R"(
GLubyte texels[] = {250, 30, 50, 255,  20, 200, 90, 255,  10, 60, 240, 255,  240, 230, 20, 255};
glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
glEnable(GL_TEXTURE_2D); glEnable(GL_POINT_SPRITE);
glTexEnvi(GL_POINT_SPRITE, GL_COORD_REPLACE, GL_TRUE);
glPointSize(20); glBegin(GL_POINTS); glVertex2f(-0.5, 0.0078); glEnd();
glPointParameteri(GL_POINT_SPRITE_COORD_ORIGIN, GL_LOWER_LEFT);
glBegin(GL_POINTS); glVertex2f(0.5, 0.0078); glEnd();
)"},
    // Quadrilaterals of both faces, which overlap; then edges of both.
    {"two stencils", R"(
glEnable(GL_STENCIL_TEST); glEnable(GL_BLEND); glBlendFunc(GL_ONE, GL_ONE);
glStencilFuncSeparate(GL_FRONT, GL_LEQUAL, 0, 0xFF); glStencilFuncSeparate(GL_BACK, GL_LEQUAL, 1, 0x03);
glStencilOp(GL_INCR, GL_INCR, GL_INCR); glStencilMaskSeparate(GL_BACK, 0x06);
glBegin(GL_QUADS);
glColor3f(0.25, 0, 0); glVertex2f(-0.875, -0.875); glVertex2f(0.25, -0.875); glVertex2f(0.25, 0.25); glVertex2f(-0.875, 0.25);
glColor3f(0, 0.25, 0); glVertex2f(-0.625, 0.5); glVertex2f(0.75, 0.5); glVertex2f(0.75, -0.625); glVertex2f(-0.625, -0.625);
glColor3f(0, 0, 0.25); glVertex2f(-0.375, -0.75); glVertex2f(0.875, -0.75); glVertex2f(0.875, -0.0625); glVertex2f(-0.375, -0.0625);
glColor3f(0.25, 0.25, 0); glVertex2f(-0.75, 0.875); glVertex2f(0.5625, 0.875); glVertex2f(0.5625, -0.25); glVertex2f(-0.75, -0.25);
glColor3f(0, 0.25, 0.25); glVertex2f(-0.1875, -0.9375); glVertex2f(0.0625, -0.9375); glVertex2f(0.0625, 0.9375); glVertex2f(-0.1875, 0.9375);
glEnd();
glStencilFuncSeparate(GL_BACK, GL_LEQUAL, 2, 0x03);
glPolygonMode(GL_FRONT_AND_BACK, GL_LINE); glBlendFunc(GL_ONE, GL_ZERO); glLineWidth(3); glColor3f(1, 1, 1);
glRectf(-0.6625, -0.6625, 0.5875, 0.5875); glRectf(0.8375, 0.8375, -0.85, -0.85);
)"},
    {"edges of flat polygons", R"(
glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glEnable(GL_COLOR_MATERIAL); glShadeModel(GL_FLAT);
glPolygonMode(GL_FRONT_AND_BACK, GL_LINE); glNormal3f(0, 0, 1); glLineWidth(3);
glBegin(GL_QUADS);
glColor3f(1, 0, 0); glVertex2f(-0.85, -0.85); glColor3f(0, 1, 0); glVertex2f(-0.1625, -0.85);
glColor3f(0, 0, 1); glVertex2f(-0.1625, -0.1625); glColor3f(1, 1, 0); glVertex2f(-0.85, -0.1625);
glEnd();
glLineWidth(1);
glBegin(GL_POLYGON);
glColor3f(1, 0, 0); glVertex2f(0.15, -0.85); glColor3f(0, 1, 0); glVertex2f(0.8375, -0.85);
glColor3f(0, 0, 1); glNormal3f(1, 0, 0.2); glVertex2f(0.8375, -0.1625); glVertex2f(0.15, -0.1625);
glEnd();
glPolygonMode(GL_FRONT_AND_BACK, GL_POINT); glPointSize(7); glNormal3f(0, 0, 1);
glBegin(GL_TRIANGLES);
glColor3f(1, 0, 0); glVertex2f(-0.725, 0.275); glColor3f(0, 1, 0); glVertex2f(0.74375, 0.275); glColor3f(0, 1, 1); glVertex2f(0.025, 0.775);
glEnd();
)"},
    {"constant colour and alpha in blending", R"(
glClearColor(0.2, 0.6, 0.4, 1); glClear(GL_COLOR_BUFFER_BIT);
glEnable(GL_BLEND); glBlendColor(0.8, 0.3, 0.6, 0.4); glColor3f(0.9, 0.5, 0.3);
glBlendFunc(GL_CONSTANT_COLOR, GL_CONSTANT_ALPHA); glRectf(-1, -1, 0, 0);
glBlendFunc(GL_ONE_MINUS_CONSTANT_ALPHA, GL_CONSTANT_COLOR); glRectf(0, -1, 1, 0);
glBlendFunc(GL_ONE_MINUS_CONSTANT_COLOR, GL_ONE_MINUS_CONSTANT_ALPHA); glRectf(-1, 0, 0, 1);
glBlendFuncSeparate(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_COLOR, GL_CONSTANT_COLOR, GL_ONE); glRectf(0, 0, 1, 1);
)"},
    {"wide lines and culling", R"(
glEnable(GL_CULL_FACE); glEnable(GL_POLYGON_OFFSET_FILL); glPolygonOffset(0, 1000000); glEnable(GL_DEPTH_TEST); glLineWidth(5);
glBegin(GL_LINES); glColor3f(1, 0, 0); glVertex2f(-0.5, -0.31); glVertex2f(0.5, -0.31); glVertex2f(0.5, 0.29); glVertex2f(-0.5, 0.29); glEnd();
glCullFace(GL_FRONT); glColor3f(0, 1, 0);
glBegin(GL_LINES); glVertex3f(-0.31, -0.71875, 0.01); glVertex3f(-0.31, 0.71875, 0.01); glVertex3f(0.29, 0.71875, 0.01); glVertex3f(0.29, -0.71875, 0.01); glEnd();
)"},
};

// These agree away from edges.
constexpr struct {
    const char *name, *text;
} kOtherScenes[] = {
    // Quadrilaterals of both faces in turn.
    {"faces and edges in their order", R"(
glPolygonMode(GL_BACK, GL_LINE); glLineWidth(3);
glBegin(GL_QUADS);
glColor3f(1, 0, 0); glVertex2f(-0.85, -0.85); glVertex2f(-0.85, 0.4); glVertex2f(0.4, 0.4); glVertex2f(0.4, -0.85);
glColor3f(0, 1, 0); glVertex2f(-0.5, -0.5); glVertex2f(0.6, -0.5); glVertex2f(0.6, 0.6); glVertex2f(-0.5, 0.6);
glColor3f(0, 0, 1); glVertex2f(-0.2, -0.2); glVertex2f(-0.2, 0.85); glVertex2f(0.85, 0.85); glVertex2f(0.85, -0.2);
glColor3f(1, 1, 0); glVertex2f(0.1, 0.1); glVertex2f(0.7, 0.1); glVertex2f(0.7, 0.7); glVertex2f(0.1, 0.7);
glEnd();
)"},
    // A browser that rounds vertices to 1/16 pixel takes the neighbouring texel at some pixels.
    {"texels", R"(
GLubyte texels[] = {255, 0, 0, 255,  0, 255, 0, 255,  0, 0, 255, 255,  255, 255, 255, 255};
glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST); glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
glEnable(GL_TEXTURE_2D); glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
glBegin(GL_TRIANGLES);
glTexCoord2f(0, 0); glVertex2f(-0.913, -0.877); glTexCoord2f(19, 3); glVertex2f(0.931, -0.719); glTexCoord2f(5, 17); glVertex2f(-0.271, 0.937);
glEnd();
)"},
    // t and its changes do not count.
    {"mipmaps of a 1D texture", R"(
GLubyte texels[] = {255, 0, 0, 255,  0, 255, 0, 255,  0, 0, 255, 255,  255, 255, 255, 255};
glTexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
glTexImage1D(GL_TEXTURE_1D, 1, GL_RGBA, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels + 8);
glTexImage1D(GL_TEXTURE_1D, 2, GL_RGBA, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
glEnable(GL_TEXTURE_1D); glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
glBegin(GL_QUADS);
glTexCoord4f(0, 0, 0, 1); glVertex2f(-0.9, -0.9); glTexCoord4f(3, 0, 0, 1); glVertex2f(0.9, -0.9);
glTexCoord4f(3, 90, 0, 1); glVertex2f(0.9, 0.1); glTexCoord4f(0, 90, 0, 1); glVertex2f(-0.9, 0.1);
glTexCoord4f(0, 0, 0, 1); glVertex2f(-0.9, 0.2); glTexCoord4f(6, 0, 0, 2); glVertex2f(0.9, 0.2);
glTexCoord4f(6, 180, 0, 2); glVertex2f(0.9, 0.9); glTexCoord4f(0, 90, 0, 1); glVertex2f(-0.9, 0.9);
glEnd();
)"},
    {"cube maps of two units", R"(
GLubyte texels[] = {255, 0, 0, 255,  0, 255, 0, 255,  0, 0, 255, 255,  255, 255, 255, 255};
glBindTexture(GL_TEXTURE_CUBE_MAP, 1);
glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
glTexImage2D(GL_TEXTURE_CUBE_MAP_NEGATIVE_X, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_Y, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
glTexImage2D(GL_TEXTURE_CUBE_MAP_NEGATIVE_Y, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_Z, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
glTexImage2D(GL_TEXTURE_CUBE_MAP_NEGATIVE_Z, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE); glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
glEnable(GL_TEXTURE_CUBE_MAP);
glActiveTexture(GL_TEXTURE1);
glBindTexture(GL_TEXTURE_CUBE_MAP, 1);
glEnable(GL_TEXTURE_CUBE_MAP);
glBegin(GL_TRIANGLES); glMultiTexCoord3f(GL_TEXTURE0, -1.7, -1.4, 1); glMultiTexCoord3f(GL_TEXTURE1, 1, 0.2, 0.3); glVertex2f(-0.9, -0.9); glMultiTexCoord3f(GL_TEXTURE0, 1.9, -1.6, 1); glMultiTexCoord3f(GL_TEXTURE1, 1, 2, 0.3); glVertex2f(0.9, -0.9); glMultiTexCoord3f(GL_TEXTURE0, 0.3, 1.8, 1); glVertex2f(0, 0.9); glEnd();
)"},
    // Each face is filtered by itself.
    {"faces of a cube map", R"(
GLubyte texels[] = {255, 0, 0, 255,  0, 255, 0, 255,  0, 0, 255, 255,  255, 255, 255, 255};
for (int i = 0; i < 6; i++) {
    glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + i, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    texels[4 * (i % 4)] = 40 * i; texels[4 * (i % 3) + 1] = 250 - 40 * i;
}
glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE); glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
glEnable(GL_TEXTURE_CUBE_MAP); glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
glBegin(GL_QUADS);
glTexCoord3f(-1.7, -1.4, 1); glVertex2f(-0.9, -0.9); glTexCoord3f(1.9, -1.6, 1); glVertex2f(0.9, -0.9);
glTexCoord3f(1.9, 1.8, 1); glVertex2f(0.9, 0.9); glTexCoord3f(-1.7, 2, 1); glVertex2f(-0.9, 0.9);
glEnd();
)"},
};

Json jobs() {
    Json list = Json::array();
    const auto add = [&](std::string_view name, std::string_view text, const std::string& step, int width, int height) {
        list.push_back({{"name", name}, {"text", text}, {"step", step}, {"width", width}, {"height", height}});
        // The steps of a scene are alike: all of them with both lightings are for ALL_CASES.
        const bool has_both = step.empty() || step == "1" || (step != "case" && tries_all());
        list.back()["shadings"] = has_both ? Json{"scene", "phong"} : Json::array({"scene"});
        if (step == "case") list.back()["step"] = "";
    };
    for (const EmbeddedFile& file : kSceneFiles) {
        const CommandList scene = read_built_in(file);
        if (scene.steps.empty()) add(scene.name, file.text, "", 160, 120);
        for (std::size_t i = 1; i <= scene.steps.size(); ++i) add(scene.name, file.text, std::to_string(i), 160, 120);
    }
    int number = 0;
    for (const EmbeddedFile& file : kCaseFiles)
        if (is_tried(number++))
            add(file.name.substr(0, file.name.rfind('.')), file.text, "case", check::kSide, check::kSide);
    for (const auto& [name, text] : kEqualScenes) add(name, text, "case", check::kSide, check::kSide);
    for (const auto& [name, text] : kOtherScenes) add(name, text, "case", check::kSide, check::kSide);
    return list;
}

// What the reference with this shading has at a pixel, opaque.
Json reference_pixel(PageScene& scene, std::optional<Shading> shading, int x, int y) {
    reference::Options options;
    options.shading = shading;
    const auto row = scene.reference(options, y, y + 1).subspan(static_cast<std::size_t>(4 * x), 3);
    return {row[0], row[1], row[2], 255};
}

// A picture by the page's shaders, and how it compares with the reference.
struct Judged {
    std::string name;
    Json drawn, verdict;
    int largest = 0;  // difference of a channel in 255ths, anywhere
};

// On all processors. drawn: for each job its pictures.
std::vector<Judged> judged(const Json& list, const Json& drawn, int subpixel_bits) {
    const auto judge_job = [&](std::size_t number) {
        const Json& job = list[number];
        std::vector<Judged> result;
        PageScene scene;
        scene.open(job["text"].get<std::string>(), job["name"], job["step"], {job["width"], job["height"]});
        for (const Json& picture : drawn[number]) {
            const std::string step = job["step"];
            result.push_back({job["name"].get<std::string>() + (step.empty() ? "" : " " + step), picture, {}});
            if (picture.contains("error")) continue;
            Look look;
            if (picture["shading"] == "phong") look.shading = Shading::kPhong;
            reference::Options options;
            options.shading = look.shading;
            const int height = scene.scene().frame.height;
            const auto right = scene.reference(options, 0, height);
            const std::string bytes = from_base64(picture["pixels"].get<std::string>());
            const std::vector<std::uint8_t> pixels(bytes.begin(), bytes.end());
            for (std::size_t i = 0; i < right.size(); ++i)
                result.back().largest = std::max(result.back().largest, std::abs(right[i] - pixels.at(i)));
            result.back().verdict =
                Json::parse(scene.judged(look, pixels, scene.reference_floats(0, height), subpixel_bits));
        }
        return result;
    };
    std::atomic<std::size_t> next = 0;
    std::vector<std::future<std::vector<Judged>>> workers;
    for (unsigned i = 0; i < std::max(1U, std::thread::hardware_concurrency()); ++i)
        workers.push_back(std::async(std::launch::async, [&] {
            std::vector<Judged> mine;
            for (std::size_t number; (number = next++) < list.size();)
                for (Judged& one : judge_job(number)) mine.push_back(std::move(one));
            return mine;
        }));
    std::vector<Judged> all;
    for (auto& worker : workers)
        for (Judged& one : worker.get()) all.push_back(std::move(one));
    return all;
}

bool is_built() { return std::filesystem::exists(std::string(kPage) + "/module.wasm"); }
constexpr const char* kNotBuilt =
    "the page is not built: make web (Debian's packages emscripten, node-acorn, libjs-codemirror and esbuild)";

TEST(WebPage, HasMesasPictureOfEachStep) {
    if (!is_built()) GTEST_SKIP() << kNotBuilt;
    const Json listed = Json::parse(run_program("twinlight", {"scenes", "--json"}).out);
    std::vector<std::string> names;
    for (const Json& scene : listed["scenes"]) {
        const std::string name = scene["name"];
        const std::size_t steps = scene["steps"].size();
        if (steps == 0) names.push_back(name);
        for (std::size_t i = 1; i <= steps; ++i) names.push_back(name + "-" + std::to_string(i));
    }
    const std::string folder = std::string(kPage) + "/mesa";
    EXPECT_EQ(Json::parse(read_file(folder + ".json")), Json(names));
    for (const std::string& name : names) EXPECT_TRUE(std::filesystem::exists(folder + "/" + name)) << name;
}

// The bytes of a picture by Mesa's fixed function, as a page has them.
std::vector<std::uint8_t> mesas_pixels(const std::vector<std::string>& scene) {
    const TemporaryFolder drawn;
    std::vector<std::string> given = {"render"};
    given.insert(given.end(), scene.begin(), scene.end());
    given.insert(given.end(), {"--with", "fixed", "-o", drawn / "fixed.png"});
    run_program("twinlight", given);
    return decode_png_pixels(read_file(drawn / "fixed.png"), 640).rgba;
}

// docs/web.md promises these sizes.
TEST(WebPage, IsOneFileOfALimitedSize) {
    if (!is_built()) GTEST_SKIP() << kNotBuilt;
    constexpr std::uintmax_t kMegabyte = 1'000'000;
    EXPECT_LT(std::filesystem::file_size(kOneFile), 9 * kMegabyte);
    const std::string compressed = run_shell("", std::string("gzip -9 -c ") + kOneFile + " | wc -c").out;
    EXPECT_LT(std::stoul(compressed), 3'500'000U);
    EXPECT_GT(std::stoul(compressed), 1'000'000U) << "or the module is not in it";
}

TEST(WebPage, IsPackedForHosts) {
    if (!is_built()) GTEST_SKIP() << kNotBuilt;
    // A zip file ends with the names of its files.
    const std::string one_file = read_file("build/web/twinlight.zip"),
                      folder = read_file("build/web/twinlight-page.zip");
    EXPECT_NE(one_file.rfind("twinlight/twinlight.html"), std::string::npos);
    for (const char* name : {"index.html", "page.js", "module.wasm", "codemirror/copyright", "mesa/terms-3"})
        EXPECT_NE(folder.rfind(std::string("twinlight/") + name), std::string::npos) << name;
    for (const std::string* zip : {&one_file, &folder})
        EXPECT_NE(zip->rfind("twinlight/hosting.html"), std::string::npos);

    // .ci/run publishes into a new folder, as the workflow does.
    const std::string script = "tools/publish-page.sh build/site\n";
    EXPECT_NE(read_file(".github/workflows/page.yml").find("run: " + script), std::string::npos);
    EXPECT_NE(read_file(".ci/run").find(script), std::string::npos);
    const TemporaryFolder used;
    write_file_atomically(used / "file", "mine");
    const ProgramResult refused = run_shell("", "tools/publish-page.sh " + quoted(used.str()));
    EXPECT_EQ(refused.status, 2);
    EXPECT_EQ(refused.err, "publish-page.sh: " + used.str() + " is not empty; give a new folder\n");
    EXPECT_EQ(used.names(), std::vector<std::string>{"file"});
    EXPECT_EQ(run_shell("", "tools/publish-page.sh").status, 2);
}

TEST(WebPage, NamesTheToolThatPackingLacks) {
    if (!is_built()) GTEST_SKIP() << kNotBuilt;
    const TemporaryFolder folder;
    const ProgramResult run =
        run_shell("", "PATH=" + quoted(folder.str()) + " $(command -v node) tools/pack-page.mjs " + kPage + " " +
                          quoted(folder / "page.html"));
    EXPECT_EQ(run.status, 1);
    EXPECT_EQ(run.err, "tools/pack-page.mjs: esbuild is not installed (Debian's package esbuild)\n");
    EXPECT_TRUE(folder.names().empty());
}

// As a user opens it, by a double click.
void works_without_a_server(const std::string& kind, const std::string& program) {
    const ProgramResult run =
        run_shell("", std::string("timeout 200 node tests/web/one_file.mjs ") + kPage + " " + kind + " " + program);
    ASSERT_EQ(run.status, 0) << run.err;
    const Json told = Json::parse(run.out);
    EXPECT_TRUE(told["verdict"].get<std::string>().starts_with("Shaders and reference agree")) << told["verdict"];
    EXPECT_EQ(told["messages"], "");
    const std::string mesa = from_base64(told["mesa"].get<std::string>());
    EXPECT_EQ(std::vector<std::uint8_t>(mesa.begin(), mesa.end()), mesas_pixels({"terms", "--step", "3"}));
    EXPECT_TRUE(told["solved"].get<std::string>().starts_with("Right, because: GL_SHININESS is")) << told["solved"];
    EXPECT_EQ(told["linked"], (Json{"glColor3f(1, 0, 0);\nglRectf(-1, -1, 1, 1);\n", {255, 0, 0, 255}}));
    EXPECT_EQ(told["tutor"], (Json{session::kTutorCalls, true}));
    EXPECT_EQ(told["dropped"][0], (Json{"", {0, 255, 0, 255}})) << "a program";
    PageScene textured;
    textured.keep_file("mine.png", read_file("src/scene/scenes/crate.png"));
    textured.open(told["scene"].get<std::string>(), "mine", "", {640, 480});
    EXPECT_EQ(told["dropped"][1], (Json{"", reference_pixel(textured, {}, 40, 30)})) << "a scene with its picture";
    EXPECT_EQ(told["loads"], Json::array());
    EXPECT_EQ(told["complaints"], Json::array());
    EXPECT_TRUE(told["folder"][0].get<std::string>().find("Open twinlight.html instead") != std::string::npos)
        << told["folder"][0];
    EXPECT_EQ(told["folder"][1], told["folder"][2]) << "the link to the page that works";
    EXPECT_EQ(told["folder"][3], false) << "no empty pictures";
}

TEST(WebPage, WorksAsOneFileInChromium) {
    if (!is_built()) GTEST_SKIP() << kNotBuilt;
    const std::string program = browser();
    if (program.empty()) GTEST_SKIP() << "there is no chromium (apt-get install chromium)";
    works_without_a_server("chromium", program);
}

TEST(WebPage, WorksAsOneFileInFirefox) {
    if (!is_built()) GTEST_SKIP() << kNotBuilt;
    const std::string program = firefox();
    if (program.empty()) GTEST_SKIP() << "there is no firefox (apt-get install firefox-esr)";
    works_without_a_server("firefox", program);
}

TEST(WebPage, ShowsTutors) {
    if (!is_built()) GTEST_SKIP() << kNotBuilt;
    const std::string program = browser();
    if (program.empty()) GTEST_SKIP() << "there is no chromium (apt-get install chromium)";
    const ProgramResult run = run_shell("", "timeout 200 node tests/web/tutor.mjs " + program + " " + kPage);
    ASSERT_EQ(run.status, 0) << run.err;
    const Json told = Json::parse(run.out);
    const auto position = [](const std::string& values) {
        return "glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){" + values + "});";
    };
    ASSERT_EQ(told["calls"].size(), session::kTutorCalls);
    EXPECT_EQ(told["calls"][0], position("-1.8, 2, 2.2, 1"));
    EXPECT_EQ(told["visible"],
              (Json{"scenes", "all-scenes", "undo", "next-tutor", "whole-page", "theme", "world", "shaders"}))
        << "nothing else";
    EXPECT_EQ(told["names"][4], "GL_LIGHT0 GL_AMBIENT red");
    EXPECT_EQ(told["dragged"], position("-1.3, 2, 2.2, 1")) << "by 50 pixels";
    const Json& meanings = told["meanings"];
    EXPECT_TRUE(meanings[0].get<std::string>().starts_with("position, multiplied by")) << meanings;
    EXPECT_EQ(meanings[1], "which light, GL_LIGHT0 to GL_LIGHT7; 2.14.1") << "under the pointer";
    EXPECT_EQ(meanings[2], meanings[0]) << "of the number with the focus";
    EXPECT_EQ(told["key"], position("-1.25, 2, 2.2, 1"));
    EXPECT_EQ(told["typed"], (Json{position("-1.25, 2, 7.5, 1"), "7.5"}));
    EXPECT_EQ(told["undone"], (Json{nullptr, "-1.8"}));
    EXPECT_TRUE(told["light"][0].get<std::string>().starts_with(position("").substr(0, 40))) << told["light"];
    EXPECT_NEAR(told["light"][1][0].get<double>(), 40, 2) << "it follows the mouse";
    EXPECT_NEAR(told["light"][1][1].get<double>(), -20, 2);
    EXPECT_EQ(told["view"], (Json{nullptr, true, true})) << "turns by the mouse and by a key";
    EXPECT_EQ(told["tooWide"], 0);
    EXPECT_EQ(told["swipes"][0], (Json{position("-1.5, 2, 2.2, 1"), 0}));
    EXPECT_EQ(told["swipes"][1][0], nullptr);
    EXPECT_GT(told["swipes"][1][1], 20);
    ASSERT_EQ(told["all"].size(), std::size(session::kTutors));
    for (const Json& tutor : told["all"]) EXPECT_EQ(tutor[1], session::kTutorCalls) << tutor;
    EXPECT_EQ(told["all"].back()[0], "tutor:light") << "the first follows the last";
    EXPECT_EQ(told["whole"][0], (Json{"", "numbers"})) << "the editor";
    EXPECT_TRUE(told["whole"][1].get<std::string>().starts_with("Shaders and reference ")) << told["whole"];
    EXPECT_EQ(told["lesson"], Json::array({"lesson"}));
    EXPECT_EQ(told["complaints"], Json::array());
}

// For tests/web/views.mjs.
void write_pages(const TemporaryFolder& folder) {
    std::filesystem::copy(kPage, folder / "page", std::filesystem::copy_options::recursive);
    write_file_atomically(folder / "package.json", "{}");
    EXPECT_EQ(run_program("twinlight", {"export", "terms", "--as", "html", "-o", folder / "export.html"}).status, 0);
    EXPECT_EQ(run_program("twinlight", {"compare", "lab", "--size", "160x120", "-o", folder / "report"}).status, 0);
}

// Contrast, names of controls, what the keyboard reaches and shows: of the page, an exported page and a report.
TEST(WebPage, IsUsableWithoutAMouse) {
    if (!is_built()) GTEST_SKIP() << kNotBuilt;
    const std::string program = browser();
    if (program.empty()) GTEST_SKIP() << "there is no chromium (apt-get install chromium)";
    const TemporaryFolder folder;
    write_pages(folder);
    const ProgramResult run =
        run_shell("", "timeout 200 node tests/web/usable.mjs " + program + " " + quoted(folder.str()));
    ASSERT_EQ(run.status, 0) << run.err;
    const Json told = Json::parse(run.out);
    EXPECT_EQ(told["faults"], Json::array());
    EXPECT_EQ(told["planted"], (Json{"contrast 2.85", "without a name", "a click without a key", "no focus is seen",
                                     "Tab goes another way"}));
}

// The same and headings, by axe-core.
TEST(WebPage, KeepsNobodyFromUsingIt) {
    if (!is_built()) GTEST_SKIP() << kNotBuilt;
    const std::string program = browser(), axe = "build/npm/node_modules/axe-core/axe.min.js";
    if (program.empty()) GTEST_SKIP() << "there is no chromium (apt-get install chromium)";
    if (!std::filesystem::exists(axe)) GTEST_SKIP() << "axe-core is not installed (make axe, which needs npm)";
    const TemporaryFolder folder;
    write_pages(folder);
    const ProgramResult run =
        run_shell("", "timeout 200 node tests/web/axe.mjs " + program + " " + axe + " " + quoted(folder.str()));
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.out, "[]\n");
}

TEST(WebPage, DrawsEveryScene) {
    if (!is_built()) GTEST_SKIP() << kNotBuilt;
    const std::string program = browser();
    if (program.empty()) GTEST_SKIP() << "there is no chromium (apt-get install chromium)";
    const TemporaryFolder folder;
    Json list = jobs();
    // The page's own judge takes long.
    for (std::size_t i = 0; i < list.size(); ++i) list[i]["judges"] = i % 10 == 0;
    write_file_atomically(folder / "jobs.json", list.dump());
    const ProgramResult run = run_shell(
        "", "timeout 300 node tests/web/page.mjs " + program + " " + kPage + " " + quoted(folder / "jobs.json"));
    ASSERT_EQ(run.status, 0) << run.err;
    const Json told = Json::parse(run.out), page = told["page"];

    EXPECT_EQ(page["verdict"], "Shaders and reference are equal away from edges.");
    EXPECT_EQ(page["tooWide"], (Json{0, 0, 0, 0})) << "at 360 pixels: dark, light, with a slider, with a lesson";
    EXPECT_NE(page["schemes"][0], page["schemes"][1]);
    EXPECT_EQ(page["policy"].get<std::string>().substr(0, 19), "default-src 'none';");
    EXPECT_EQ(page["order"][0], "drawImage") << "the coarse picture comes first";
    const Json tabs = {"scenes", "all-scenes", "steps",       "shading", "view",      "link",       "form",
                       "save",   "theme",      "editor",      "shaders", "reference", "difference", "floats",
                       "mesa",   "INPUT",      "INPUT",       "INPUT",   "SUMMARY",   "x",          "y",
                       "BUTTON", "terms",      "explanation", "SUMMARY", "BODY"};
    EXPECT_EQ(page["narrow"], "slider") << "a phone shows one picture first";
    EXPECT_EQ(page["tabs"], tabs);
    EXPECT_NE(page["explanation"].get<std::string>().find("GL_LIGHT"), std::string::npos) << page["explanation"];
    EXPECT_EQ(page["arrows"], (Json{"n", "V", "L1", "h1"}));
    EXPECT_EQ(page["terms"][0], 3);
    EXPECT_TRUE(page["terms"][1].get<std::string>().starts_with("=\t\tc_pri before the clamp\t")) << page["terms"];
    EXPECT_EQ(page["labels"], (Json{"exponent 0", "exponent 60", "smooth from 7 to 13.1 degrees"}));
    EXPECT_TRUE(page["caption"].get<std::string>().starts_with("Three spotlights on a wall: ")) << page["caption"];
    EXPECT_EQ(page["numbers"][0], "GL_LIGHT0 GL_POSITION x\n1\nGL_LIGHT0 GL_POSITION y\n2\nGL_FRONT GL_SHININESS\n20");
    EXPECT_NE(page["numbers"][1].get<std::string>().find("{-0.5, 2, 3, 1}"), std::string::npos) << page["numbers"];
    EXPECT_NE(page["numbers"][1].get<std::string>().find("GL_SHININESS, 64);  // dull"), std::string::npos);
    EXPECT_EQ(page["gallery"].front(), "Lecture 3: local shading models");
    EXPECT_EQ(page["gallery"].back(), "For tests");
    EXPECT_EQ(page["cards"][0], page["cards"][1]);
    EXPECT_EQ(page["chosen"], (Json{"terms", false}));
    EXPECT_TRUE(page["error"].get<std::string>().starts_with("3:1: error: ")) << page["error"];
    EXPECT_EQ(page["markup"], 0);
    EXPECT_EQ(page["marks"], (Json{Json::array({"mark error"}), "glFoo(<img src=x>);"}));
    EXPECT_EQ(page["corrected"], (Json{255, 0, 0, 255}));
    EXPECT_TRUE(page["differs"].get<std::string>().starts_with(
        "Shaders and reference differ: the largest difference away from edges is 9/255, at pixel 100, 50; 1 of "))
        << page["differs"];
    EXPECT_EQ(page["factor"], Json::parse("[\"(16 times)\", [208, 64, 64, 255], [64, 64, 64, 255]]"));
    EXPECT_EQ(page["warning"].size(), 2u) << page["warning"];
    EXPECT_EQ(page["warningMarks"][0], 2);
    EXPECT_GE(page["warningMarks"][1], 2);
    EXPECT_LT(page["first"], 1000) << "milliseconds until the reference's first picture";

    PageScene sphere;
    const std::string sphere_text = page["keyed"][0];
    sphere.open(sphere_text, "scene", "", {160, 120});
    for (const auto& [name, shading] :
         {std::pair("phong", std::optional(Shading::kPhong)), {"exact", Shading::kExact}, {"scene", std::nullopt}})
        EXPECT_EQ(page["lightings"][name], reference_pixel(sphere, shading, 80, 60)) << name;
    EXPECT_EQ(page["explained"], sphere.explained({}, 75, 50));
    PageScene lab;
    lab.open(read_file("src/scene/scenes/lab.gl"), "scene", "2", {160, 120});
    EXPECT_EQ(page["step"], (Json{"2", reference_pixel(lab, {}, 80, 60)}));
    EXPECT_GT(page["steps"], 3);

    // Each key and move changes the text where it changes the scene.
    EXPECT_EQ(page["light"], (Json{Json::array(), {"glEnable(GL_LIGHT7);"}}));
    EXPECT_TRUE(page["said"].get<std::string>().starts_with("GL_LIGHT7 ")) << page["said"];
    EXPECT_EQ(page["undone"], true);
    Json last;
    for (const char key : std::string("12345678f")) last = Json::parse(sphere.controls().press(key));
    EXPECT_EQ(page["keyed"][1], last["text"]) << "as the keys of the window";
    EXPECT_EQ(page["flat"], (Json{Json::array(), {"glShadeModel(GL_FLAT);"}}));
    for (const char* move : {"arrow", "drag", "wheel"}) {
        const std::string line = page[move][1].empty() ? "" : page[move][1].back();
        EXPECT_TRUE(line.starts_with("gluLookAt(")) << move << ": " << page[move];
    }
    EXPECT_EQ(page["keys"][0], true);
    for (const session::Key& key : session::keys())
        EXPECT_TRUE(key.what.empty() ||
                    (page["keys"][1].get<std::string>().find(key.what) != std::string::npos) == key.in_page)
            << key.what;
    EXPECT_EQ(page["letter"], true) << "a key in the editor is a letter";
    EXPECT_EQ(page["undoneInEditor"], true) << "a drag is one step of undo";
    EXPECT_EQ(page["leaves"], true) << "Tab leaves the editor";
    EXPECT_NEAR(page["clicked"].get<double>(), 80, 2);

    EXPECT_NE(page["dumpErrors"][0].get<std::string>().find("dump.txt: call 39: the blob 'blob_call39.bin' is missing"),
              std::string::npos)
        << page["dumpErrors"];
    EXPECT_NE(page["dumpErrors"][1].get<std::string>().find("this page reads the files that apitrace 5 to 13 records"),
              std::string::npos)
        << page["dumpErrors"];
    EXPECT_TRUE(page["droppedTrace"][0].get<std::string>().starts_with("// frame.trace, frame 0: 64 x 48 pixels."))
        << page["droppedTrace"];
    const Json& mesh = page["droppedMesh"];
    EXPECT_TRUE(mesh[0].get<std::string>().starts_with("// t.obj\n")) << mesh;
    EXPECT_NE(mesh[0].get<std::string>().find("gluLookAt(1, 1, 4.243, 1, 1, 0, 0, 1, 0);"), std::string::npos) << mesh;
    EXPECT_EQ(mesh[1], "");
    EXPECT_GT(mesh[2][0], 100) << "red, of the material file: " << mesh;
    EXPECT_EQ(mesh[2][1], 0);
    EXPECT_EQ(mesh[2], mesh[3]);
    EXPECT_EQ(page["droppedProgram"], (Json{"", 80, {0, 255, 0, 255}}));
    const Json& texture = page["droppedPicture"];
    EXPECT_NE(texture[0].get<std::string>().find("drop it on the page"), std::string::npos) << texture;
    EXPECT_TRUE(texture[1].get<std::string>().starts_with("A scene can use mine.png now.")) << texture;
    EXPECT_EQ(texture[2], "");
    EXPECT_EQ(texture[3], true) << "the text stays";
    EXPECT_NE(texture[4], (Json{255, 255, 255, 255}));
    EXPECT_EQ(texture[4], texture[5]);
    EXPECT_EQ(page["otherMesa"], (Json{"", true})) << "Mesa drew the scene with another texture";
    EXPECT_EQ(page["failedWorker"], "error: a worker of the page failed: no worker");
    const Json& themes = page["themes"];
    EXPECT_EQ(themes[0][1], "Light") << "the system is dark";
    EXPECT_EQ(themes[1][1], "Dark");
    EXPECT_NE(themes[0][0], themes[1][0]);
    EXPECT_EQ(themes[2], themes[1]) << "after loading the page again";
    EXPECT_EQ(themes[3], themes[0]);
    EXPECT_EQ(page["droppedLesson"][0], "Glass");
    EXPECT_TRUE(page["droppedLesson"][1].get<std::string>().starts_with("Not yet. The highlight covers 1 times"))
        << page["droppedLesson"];
    EXPECT_EQ(page["droppedScene"], (Json{"// mine\nglRectf(0, 0, 1, 1);\n", ""})) << "none of the list";
    const std::string dump = page["dump"][0], verdict_on_dump = page["dump"][1];
    EXPECT_TRUE(dump.starts_with("// dump.txt, frame 0: 300 x 300 pixels.")) << dump.substr(0, 200);
    EXPECT_TRUE(verdict_on_dump.starts_with("Shaders and reference ")) << verdict_on_dump;
    EXPECT_EQ(verdict_on_dump.find("differ:"), std::string::npos) << verdict_on_dump;
    EXPECT_EQ(page["dump"][2], 300);
    EXPECT_EQ(page["dumpLink"], "300x300");

    const char* const memory[] = {"error: this scene needs more memory than a page gets",
                                  "2:1: error: this picture needs more than 1 GB",
                                  "error: pictures of 8000 x 8000 need 7.2 GB"};
    for (std::size_t i = 0; i < std::size(memory); ++i)
        EXPECT_TRUE(page["memory"][i].get<std::string>().starts_with(memory[i])) << page["memory"];
    EXPECT_EQ(page["afterMemory"], "Shaders and reference are equal away from edges.") << "the page goes on";

    EXPECT_EQ(page["forms"], (Json{"gl", "c", "glsl", "html", "#shaders", "#reference", "#difference", "#floats"}));
    PageScene scene;
    scene.open(page["files"]["gl"].get<std::string>(), "spotlight", "", {});
    for (const char* form : {"c", "glsl", "html"}) EXPECT_EQ(page["files"][form], scene.exported(form, {})) << form;
    EXPECT_EQ(page["files"]["#reference"], "image/png");

    EXPECT_EQ(page["mesa"]["own"], true) << "hidden for a text of your own";
    for (const char* opened : {"scene", "step"}) {
        const Json& mesa = page["mesa"][opened];
        EXPECT_EQ(mesa[0], false) << opened;
        EXPECT_EQ(mesa[1], mesa[2]) << opened;
    }
    EXPECT_EQ(page["slider"], Json::parse("[[\"reference\", \"inset(0px 0px 0px 30%)\"], [\"mesa\", \"none\"]]"));

    EXPECT_TRUE(page["wrong"].get<std::string>().starts_with("Not yet. The highlight covers 1 times")) << page["wrong"];
    EXPECT_EQ(page["outdated"], "The scene has changed since this check.");
    EXPECT_TRUE(page["solved"].get<std::string>().starts_with("Right, because: ")) << page["solved"];
    EXPECT_TRUE(page["prediction"].get<std::string>().starts_with("A is wrong; B is right.")) << page["prediction"];
    // Colours change by up to 255/255 in 12 pixels; half a step of 1/16 pixel changes them by 0.7/255.
    EXPECT_LT(page["meshes"]["onGrid"][0], 1e-4) << "only ties";
    EXPECT_LE(page["meshes"]["onGrid"][1], 1);
    EXPECT_GT(page["meshes"]["offGrid"][0], 0.01) << page["meshes"];
    EXPECT_EQ(page["afterFailedUpload"], (Json{"no texture", true}));
    EXPECT_EQ(page["leaks"][0], page["leaks"][1]) << "after 20 and 100 edits";

    EXPECT_EQ(page["linked"], (Json{true, ""})) << page["link"];
    EXPECT_EQ(page["complaints"], Json::array());
    for (const Json& url : page["requests"])
        EXPECT_TRUE(url.get<std::string>().starts_with("http://127.0.0.1:") ||
                    url.get<std::string>().starts_with("data:"))
            << url;

    const std::vector<Judged> all = judged(list, told["pictures"], page["subpixelBits"]);
    std::size_t agree = 0, in_browser = 0;
    for (const Judged& picture : all) {
        SCOPED_TRACE(picture.name + ", " + picture.drawn["shading"].get<std::string>());
        EXPECT_EQ(picture.drawn.value("error", ""), "");
        if (picture.drawn.contains("error")) continue;
        // What WebGL lacks is named on the page.
        const bool is_named = !picture.drawn["missing"].empty(), within = picture.verdict["within"];
        EXPECT_TRUE(within || is_named || known_differences().contains(picture.name)) << picture.verdict;
        if (std::ranges::any_of(kEqualScenes, [&](const auto& one) { return one.name == picture.name; })) {
            EXPECT_LE(picture.largest, 1) << "a product of blending, rounded";
            EXPECT_FALSE(is_named);
        }
        const bool is_other =
            std::ranges::any_of(kOtherScenes, [&](const auto& one) { return one.name == picture.name; });
        EXPECT_FALSE(is_other && is_named);
        agree += within ? 1 : 0;
        if (picture.drawn["judged"].is_null()) continue;
        EXPECT_EQ(picture.drawn["judged"], picture.verdict) << "by the page's own judge";
        ++in_browser;
    }
    EXPECT_GT(in_browser, 20u);
    EXPECT_GT(2 * agree, all.size());
}

}  // namespace

}  // namespace twinlight::web::page_test
