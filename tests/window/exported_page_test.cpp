// twinlight export --as html, to its end: the page draws with WebGL 2 in a browser without a window what the reference
// draws, and answers keys and the mouse.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <regex>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "../unit/pictures.h"
#include "../unit/run_program.h"
#include "base/image/file.h"
#include "base/text/json.h"
#include "browser.h"
#include "drawn_by_swiftshader.h"

namespace twinlight::exported_page_test {
namespace {

using nlohmann::json;

// Lit and flat quadrilaterals, a spot, rescaled normals, a texture of one dimension, generated texture coordinates, the alpha test, a
// clip plane, points, fog. CAMERA is where a test turns the camera.
constexpr const char* kScene = R"(
glClearColor(0.2, 0.25, 0.35, 1); glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
glMatrixMode(GL_PROJECTION); gluPerspective(40, 4.0 / 3.0, 1, 100);
glMatrixMode(GL_MODELVIEW); CAMERA gluLookAt(0, 2, 9,  0, 0, 0,  0, 1, 0);
glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){2, 3, 4, 1});
glLightfv(GL_LIGHT3, GL_POSITION, (GLfloat[]){-1, 0, 1, 0});
glLightfv(GL_LIGHT3, GL_DIFFUSE, (GLfloat[]){0.3, 0.2, 0.1, 1});
glLightfv(GL_LIGHT3, GL_SPECULAR, (GLfloat[]){0.6, 0.1, 0.6, 1});
glLightfv(GL_LIGHT5, GL_POSITION, (GLfloat[]){-3, 2, 3, 1});
glLightfv(GL_LIGHT5, GL_SPOT_DIRECTION, (GLfloat[]){0.3, -0.5, -1});
glLightf(GL_LIGHT5, GL_SPOT_CUTOFF, 30); glLightf(GL_LIGHT5, GL_SPOT_EXPONENT, 5);
glLightfv(GL_LIGHT5, GL_DIFFUSE, (GLfloat[]){0.1, 0.4, 0.1, 1});
glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glEnable(GL_LIGHT3); glEnable(GL_LIGHT5); glEnable(GL_DEPTH_TEST);
glMaterialfv(GL_FRONT, GL_SPECULAR, (GLfloat[]){0.5, 0.5, 0.5, 1}); glMaterialf(GL_FRONT, GL_SHININESS, 20);
glPushMatrix(); glTranslatef(-2, 0, 0); glScalef(0.5, 0.5, 0.5); glEnable(GL_RESCALE_NORMAL); glutSolidSphere(2, 24, 12);
glDisable(GL_RESCALE_NORMAL); glPopMatrix();
glClipPlane(GL_CLIP_PLANE1, (GLdouble[]){0, -1, 0, 0.4}); glEnable(GL_CLIP_PLANE1);
glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1); glutSolidSphere(0.9, 24, 12); glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 0);
glDisable(GL_CLIP_PLANE1);
glShadeModel(GL_FLAT); glEnable(GL_FOG); glFogf(GL_FOG_DENSITY, 0.05);
glPushMatrix(); glTranslatef(2, 0, 0); glRotatef(30, 1, 1, 0); glutSolidCube(1.1); glPopMatrix();
glDisable(GL_FOG); glShadeModel(GL_SMOOTH); glDisable(GL_LIGHTING);
glTexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE,
    (GLubyte[]){20, 90, 170, 255,  250, 0, 0, 40,  0, 250, 90, 255,  90, 20, 60, 40});
glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
glEnable(GL_TEXTURE_1D); glEnable(GL_ALPHA_TEST); glAlphaFunc(GL_GREATER, 0.5);
glBegin(GL_QUAD_STRIP);
glTexCoord1f(0.1); glVertex3f(-3, -1.5, 0); glTexCoord1f(0.1); glVertex3f(-3, -2, 0);
glTexCoord1f(1.7); glVertex3f(3, -1.5, 0); glTexCoord1f(1.7); glVertex3f(3, -2, 0);
glEnd();
glDisable(GL_ALPHA_TEST);
glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_EYE_LINEAR);
glTexGenfv(GL_S, GL_EYE_PLANE, (GLfloat[]){0.3, 0.25, 0.35, 0.2}); glEnable(GL_TEXTURE_GEN_S);
glPushMatrix(); glTranslatef(0, 1.4, 0); glutSolidCube(0.6); glPopMatrix();
glDisable(GL_TEXTURE_GEN_S); glDisable(GL_TEXTURE_1D);
glPointSize(5); glColor3f(1, 1, 0);
glBegin(GL_POINTS); glVertex3f(-1.03, 1.51, 0); glVertex3f(1.02, 1.52, 0); glEnd();
)";

std::string scene_with(std::string text, const std::string& camera) {
    return text.replace(text.find("CAMERA"), 6, camera);
}

// Uses the page, then replaces its body with JSON. Pictures are PNGs, which are opaque and so lose nothing.
constexpr const char* kUses = R"js(<script type="module">
const told = {};
const canvas = document.getElementById("picture");
const picture = () => canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
const changed = (a, b) => a.reduce((count, value, i) => count + (value !== b[i]), 0);
const labels = () => [...document.querySelectorAll(".labels span")].map((text) => text.textContent);
const press = (key) => document.dispatchEvent(new KeyboardEvent("keydown", {key, bubbles: true}));
try {
    told.size = [canvas.width, canvas.height];
    const first = picture();
    told.picture = canvas.toDataURL();
    told.labels = [labels()];
    press("1");
    told.without_light = changed(picture(), first);
    told.state = document.getElementById("state").textContent.trim();
    press("1");
    told.with_it_again = changed(picture(), first);
    canvas.dispatchEvent(new PointerEvent("pointermove", {buttons: 1, movementX: 60, movementY: 20}));
    told.turned = changed(picture(), first);
    told.turned_picture = canvas.toDataURL();
    told.labels.push(labels());
    canvas.dispatchEvent(new PointerEvent("pointermove", {buttons: 1, movementX: -60, movementY: -20}));
    told.turned_back = changed(picture(), first);
    told.labels.push(labels());
    const choices = (id) => [...document.getElementById(id).options].map((option) => option.value);
    const choose = (id, value) => {
        document.getElementById(id).value = value;
        document.getElementById(id).dispatchEvent(new Event("input"));
        return canvas.toDataURL();
    };
    told.steps = choices("step");
    told.shadings = choices("shading");
    told.per_pixel_picture = choose("shading", told.shadings.at(-1));
    choose("shading", told.shadings[0]);
    told.last_step_picture = choose("step", told.steps.at(-1));
    choose("step", told.steps[0]);
    told.chosen_back = changed(picture(), first);
    told.lights = [...document.querySelectorAll("#lights button")].map((button) => button.textContent);
    document.querySelector("#lights button")?.click();
    told.light_by_button = changed(picture(), first);
    document.querySelector("#lights button")?.click();
    const [x, y] = [canvas.clientWidth / 2, canvas.clientHeight / 2], box = canvas.getBoundingClientRect();
    canvas.dispatchEvent(new PointerEvent("pointerdown", {buttons: 1}));
    canvas.dispatchEvent(new PointerEvent("pointerup", {clientX: box.left + x, clientY: box.top + y}));
    told.pixel = document.getElementById("state").textContent;
    told.terms = [...document.querySelectorAll("#terms tbody tr")].map(({innerText}) => innerText.trim().split("\t"));
    const key = (key, more = {}) => (canvas.dispatchEvent(new KeyboardEvent("keydown", {key, ...more})), document.getElementById("state").textContent);
    told.by_keyboard = [key("Enter"), key("ArrowRight", {shiftKey: true}), key("ArrowUp", {shiftKey: true, repeat: true}), key("ArrowDown", {shiftKey: true, repeat: true}),
        key("ArrowLeft", {shiftKey: true})].map((text) => text.split(":")[0]);
    told.bars = [...document.querySelectorAll("#terms .bars .red i")].map((term) => parseFloat(term.style.width));
    press("f");
    told.flat = changed(picture(), first);
    press("f");
    told.smooth = changed(picture(), first);
    told.terms_after = document.getElementById("terms").childElementCount;
} catch (error) {
    told.error = String(error.stack);
}
told.failed = document.getElementById("error").textContent;
document.body.replaceChildren("told:" + JSON.stringify(told) + ":told");
</script>)js";

class ExportedPage : public testing::Test {
  protected:
    void SetUp() override {
        program_ = browser();
        if (program_.empty()) GTEST_SKIP() << "there is no chromium (apt-get install chromium)";
        static const bool has_webgl = opened(
            "<!DOCTYPE html><html><body><script>document.body.append('told:' + JSON.stringify({webgl: "
            "!!document.createElement('canvas').getContext('webgl2')}) + ':told')</script></body></html>")["webgl"];
        if (!has_webgl) GTEST_SKIP() << "this chromium has no WebGL 2 without a GPU";
    }

    json opened(const std::string& page) {
        write_file_atomically(folder_ / "page.html", page);
        return json_of_page("timeout 120 " + program_,
                            "--use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader", "page.html", folder_);
    }

    json used(const std::string& scene, const std::vector<std::string>& options = {}) {
        std::vector<std::string> words = {"export", scene, "--as", "html", "-o", folder_ / "export.html"};
        words.insert(words.end(), options.begin(), options.end());
        const ProgramResult exported = run_program("twinlight", words);
        EXPECT_EQ(exported.status, 0) << exported.err;
        page_ = read_file(folder_ / "export.html");
        std::string text = page_;
        const json told = opened(text.insert(text.rfind("</body>"), kUses));
        EXPECT_EQ(told.value("error", ""), "");
        EXPECT_EQ(told["failed"], "");
        return told;
    }

    static Image picture_of(const json& told, const char* name = "picture") {
        return picture_of_url(told[name], told["size"][0], told["size"][1]);
    }

    void expect_close_after_a_turn(const std::string& text, const json& told);
    // The same for the page as it opens, which names nothing that it lacks.
    void expect_close_before_and_after_a_turn(const std::string& text);

    std::string program_, page_;
    TemporaryFolder folder_;
};

// The page turned by half a degree a pixel, first around the vertical axis, around the scene's middle. `text`: with CAMERA.
void ExportedPage::expect_close_after_a_turn(const std::string& text, const json& told) {
    std::smatch middle;
    ASSERT_TRUE(std::regex_search(page_, middle, std::regex("\"middle\": \\[(\\S+),(\\S+),(\\S+)\\]")));
    const auto shift = [&](const char* sign) {
        return fmt::format("glTranslatef({0}({1}), {0}({2}), {0}({3}));", sign, middle.str(1), middle.str(2),
                           middle.str(3));
    };
    const std::string turned = folder_ / "turned.gl";
    write_file_atomically(
        turned, scene_with(text, shift("+") + " glRotatef(10, 1, 0, 0); glRotatef(30, 0, 1, 0); " + shift("-")));
    expect_close(turned, picture_of(told, "turned_picture"), {});
}

TEST_F(ExportedPage, DrawsWhatTheReferenceDrawsAndAnswersKeysAndTheMouse) {
    const std::string scene = folder_ / "scene.gl";
    write_file_atomically(scene, scene_with(kScene, ""));
    const json told = used(scene);
    expect_close(scene, picture_of(told), {});
    EXPECT_GT(told["without_light"], 10'000);
    EXPECT_EQ(told["state"], "Off: GL_LIGHT0.");
    EXPECT_EQ(told["with_it_again"], 0);
    EXPECT_GT(told["flat"], 5'000);
    EXPECT_GT(told["smooth"], 0) << "the cube is flat in the scene";
    EXPECT_GT(told["turned"], 10'000);
    EXPECT_EQ(told["turned_back"], 0);
    EXPECT_EQ(page_.find("lacks a part"), std::string::npos);
    expect_close_after_a_turn(kScene, told);
    EXPECT_EQ(told["shadings"], json({"per vertex", "per pixel"}));
    expect_close(scene, picture_of(told, "per_pixel_picture"), Shading::kPhong);
    EXPECT_EQ(told["chosen_back"], 0);
    EXPECT_EQ(told["lights"], json({"GL_LIGHT0", "GL_LIGHT3", "GL_LIGHT5"}));
    EXPECT_EQ(told["light_by_button"], told["without_light"]);
    const Rgba middle = picture_of(told).at(320, 240);
    EXPECT_EQ(told["by_keyboard"],
              (json{"Pixel 320, 240", "Pixel 321, 240", "Pixel 321, 232", "Pixel 321, 240", "Pixel 320, 240"}));
    EXPECT_EQ(told["pixel"], fmt::format("Pixel 320, 240: red {}, green {}, blue {} of 255.", channel_code(middle[0]),
                                         channel_code(middle[1]), channel_code(middle[2])));
}

// All directions are (0, 0, 1), so that the cosines are 1. GL_LIGHT1's attenuation is 1/5, its colours are above 1. Half of each fragment
// is added to half of the background.
TEST_F(ExportedPage, ShowsTheTermsOfAPixel) {
    const std::string scene = folder_ / "scene.gl";
    const std::string text = R"(
glClearColor(0, 0, 0.8, 1); glClear(GL_COLOR_BUFFER_BIT);
glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glEnable(GL_LIGHT1);
glMaterialfv(GL_FRONT, GL_EMISSION, (GLfloat[]){0.2, 0, 0, 1});
glMaterialfv(GL_FRONT, GL_AMBIENT, (GLfloat[]){0, 0.4, 0, 1});
glMaterialfv(GL_FRONT, GL_DIFFUSE, (GLfloat[]){0.2, 0.4, 0.6, 0.5});
glMaterialfv(GL_FRONT, GL_SPECULAR, (GLfloat[]){0, 0, 0.2, 1});
glLightModelfv(GL_LIGHT_MODEL_AMBIENT, (GLfloat[]){1, 1, 1, 1});
glLightfv(GL_LIGHT1, GL_POSITION, (GLfloat[]){0, 0, 100000, 1}); glLightf(GL_LIGHT1, GL_CONSTANT_ATTENUATION, 5);
glLightfv(GL_LIGHT1, GL_DIFFUSE, (GLfloat[]){10, 0, 0, 1});
BLEND
glRectf(-0.9, -0.9, 0.9, 0.9);
)";
    using Row = std::pair<std::string, std::array<double, 3>>;
    const auto expect_rows = [](const json& told, const std::vector<Row>& expected) {
        // GL_LIGHT1 is drawn with a tenth of its colours, in codes of 8 bits.
        constexpr double kCode = 1.0 / 255, kTenth = 10 * kCode / 2 + kCode, kDigits = 0.0005;
        ASSERT_EQ(told["terms"].size(), expected.size()) << told["terms"];
        for (std::size_t i = 0; i < expected.size(); ++i) {
            const json& cells = told["terms"][i];
            const auto& [name, color] = expected[i];
            EXPECT_EQ(cells[cells.size() - 4], name);
            for (std::size_t c = 0; c < 3; ++c)
                EXPECT_NEAR(std::stod(cells[cells.size() - 3 + c].get<std::string>()), color[c],
                            (name == "GL_LIGHT1: diffuse" || name == "sum" ? kTenth : 1.5 * kCode) + kDigits)
                    << cells;
        }
    };
    std::string blended = text, opaque = text;
    write_file_atomically(scene, opaque.replace(opaque.find("BLEND"), 5, ""));
    const json told = used(scene);
    expect_rows(told, {{"ambient light of the scene", {0, 0.4, 0}},
                       {"emission", {0.2, 0, 0}},
                       {"GL_LIGHT0: diffuse", {0.2, 0.4, 0.6}},
                       {"GL_LIGHT0: specular", {0, 0, 0.2}},
                       {"GL_LIGHT1: diffuse", {0.4, 0, 0}},
                       {"sum", {0.8, 0.8, 0.8}},
                       {"the pixel", {0.8, 0.8, 0.8}}});
    EXPECT_EQ(told["bars"].size(), 5U);
    EXPECT_NEAR(told["bars"][1].get<double>(), 20, 1) << "percent";
    EXPECT_EQ(told["terms_after"], 0) << "they were those of another picture";
    write_file_atomically(scene,
                          blended.replace(blended.find("BLEND"), 5,
                                          "glEnable(GL_BLEND); glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);"));
    expect_rows(used(scene), {{"ambient light of the scene", {0, 0.2, 0}},
                              {"emission", {0.1, 0, 0}},
                              {"GL_LIGHT0: diffuse", {0.1, 0.2, 0.3}},
                              {"GL_LIGHT0: specular", {0, 0, 0.1}},
                              {"GL_LIGHT1: diffuse", {0.2, 0, 0}},
                              {"without light fog, texture, background", {0, 0, 0.4}},
                              {"sum", {0.4, 0.4, 0.8}},
                              {"the pixel", {0.4, 0.4, 0.8}}});
    write_file_atomically(scene, "glColor3f(1, 0, 0); glRectf(-1, -1, 1, 1);\n");
    EXPECT_EQ(used(scene)["terms"], json::array()) << "without lighting";
}

TEST_F(ExportedPage, HasAllStepsOfTheSceneAndWhatItShows) {
    const json told = used("terms");
    EXPECT_GE(told["labels"][0].size(), 3U);
    EXPECT_EQ(told["labels"][1], json::array()) << "their places are those of the first view";
    EXPECT_EQ(told["labels"][2], told["labels"][0]);
    EXPECT_EQ(told["steps"], json({"The sum", "Ambient", "Diffuse", "Specular", "All three terms"}));
    EXPECT_EQ(told["chosen_back"], 0);
    expect_close("terms", picture_of(told, "last_step_picture"), {}, "5");
    EXPECT_NE(page_.find("<p>The lighting equation term by term: ambient + diffuse + specular = the whole.</p>"),
              std::string::npos);
    EXPECT_NE(page_.find("<p>Notice that ambient light alone is flat"), std::string::npos);
    EXPECT_EQ(used("terms", {"--step", "5"})["steps"], json({"All three terms"}));
    EXPECT_EQ(used("terms", {"--shading", "phong"})["shadings"], json({""}));
}

TEST_F(ExportedPage, NamesWhatWebglLacks) {
    const std::string scene = folder_ / "scene.gl";
    write_file_atomically(scene,
                          "glEnable(GL_LINE_STIPPLE); glLineStipple(1, 0x00FF);\nglBegin(GL_LINES); glVertex2f(0, 0); "
                          "glVertex2f(1, 0); glEnd();\n");
    used(scene);
    EXPECT_NE(
        page_.find(
            "This picture lacks a part, because WebGL lacks it:</p>\n<ul>\n<li>line 2: after a turn, line stipples "
            "are still those of the first view</li>\n</ul>"),
        std::string::npos);
}

// What the page for browsers can draw as well: polygons as edges, the accumulation buffer, a stencil, a depth range from
// far to near, cube maps.
TEST_F(ExportedPage, DrawsWhatThePageForBrowsersDraws) {
    const std::string scene = folder_ / "scene.gl";
    write_file_atomically(scene, R"(
glPolygonMode(GL_FRONT_AND_BACK, GL_LINE); glRectf(-0.91, -0.87, -0.13, -0.11);
glPolygonMode(GL_FRONT_AND_BACK, GL_FILL); glColor3f(0.9, 0.4, 0.2); glRectf(0.11, -0.87, 0.91, -0.13);
glAccum(GL_LOAD, 0.5); glAccum(GL_RETURN, 1);
glEnable(GL_STENCIL_TEST); glStencilFunc(GL_ALWAYS, 1, 1); glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
glRectf(-0.9, 0.1, -0.5, 0.9);
glStencilFunc(GL_NOTEQUAL, 1, 1); glColor3f(0.2, 0.3, 1); glRectf(-0.7, 0.3, -0.1, 0.7);
glDisable(GL_STENCIL_TEST);
glEnable(GL_DEPTH_TEST); glDepthRange(1, 0); glDepthFunc(GL_GREATER);
glClearDepth(0); glClear(GL_DEPTH_BUFFER_BIT);
glBegin(GL_TRIANGLES);
glVertex3f(-0.9, -0.1, 0.5); glVertex3f(-0.3, -0.1, 0.5); glVertex3f(-0.6, 0.3, -0.5);
glColor3f(0.3, 1, 0.4); glVertex3f(-0.9, 0.1, 0); glVertex3f(-0.3, -0.05, 0); glVertex3f(-0.3, 0.2, 0);
glEnd();
glDepthRange(0, 1); glDepthFunc(GL_LESS); glClearDepth(1); glClear(GL_DEPTH_BUFFER_BIT);
GLubyte texels[] = {250, 30, 50, 255};
GLubyte others[] = {20, 200, 90, 255};
glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
glTexImage2D(GL_TEXTURE_CUBE_MAP_NEGATIVE_X, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, others);
glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_Y, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
glTexImage2D(GL_TEXTURE_CUBE_MAP_NEGATIVE_Y, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, others);
glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_Z, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
glTexImage2D(GL_TEXTURE_CUBE_MAP_NEGATIVE_Z, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, others);
glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_NORMAL_MAP); glEnable(GL_TEXTURE_GEN_S);
glTexGeni(GL_T, GL_TEXTURE_GEN_MODE, GL_NORMAL_MAP); glEnable(GL_TEXTURE_GEN_T);
glTexGeni(GL_R, GL_TEXTURE_GEN_MODE, GL_NORMAL_MAP); glEnable(GL_TEXTURE_GEN_R);
glEnable(GL_TEXTURE_CUBE_MAP);
glTranslatef(0.5, 0.5, 0); glutSolidSphere(0.4, 24, 12);
)");
    expect_close(scene, picture_of(used(scene)), {});
    EXPECT_EQ(page_.find("lacks a part"), std::string::npos);
}

void ExportedPage::expect_close_before_and_after_a_turn(const std::string& text) {
    const std::string scene = folder_ / "scene.gl";
    write_file_atomically(scene, scene_with(text, ""));
    const json told = used(scene);
    expect_close(scene, picture_of(told), {});
    EXPECT_EQ(page_.find("lacks a part"), std::string::npos);
    expect_close_after_a_turn(text, told);
}

// Some lines lead behind the eye, where the sides of their rectangles would cross.
TEST_F(ExportedPage, DrawsWideAndSmoothLinesAndSmoothPointsAfterATurn) {
    const std::string text = R"(
glMatrixMode(GL_PROJECTION); gluPerspective(60, 4.0 / 3.0, 0.1, 100); glMatrixMode(GL_MODELVIEW); CAMERA gluLookAt(0, 0, 2,  0, 0, 0,  0, 1, 0);
glClearColor(0.1, 0.2, 0.3, 1); glClear(GL_COLOR_BUFFER_BIT);
glLineWidth(7); glColor3f(1, 0.8, 0.1);
glBegin(GL_LINES); glVertex3f(-1.1, 0.83, 0); glVertex3f(0.17, 0.21, 0.3); glVertex3f(0.4, -0.7, -1); glVertex3f(0.3, -0.2, 4);
glVertex3f(-5, -0.9, -1); glVertex3f(-0.6, -0.83, 0.4); glEnd();
glClipPlane(GL_CLIP_PLANE0, (GLdouble[]){1, 0, 0, 0.1}); glEnable(GL_CLIP_PLANE0); glColor3f(0.2, 0.9, 0.9);
glBegin(GL_LINE_STRIP); glVertex2f(-0.7, -0.6); glVertex2f(0.31, -0.13); glVertex2f(0.5, 0.43); glEnd();
glDisable(GL_CLIP_PLANE0);
glEnable(GL_BLEND); glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA); glEnable(GL_LINE_SMOOTH); glLineWidth(9.5); glColor3f(1, 0.4, 0.7);
glBegin(GL_LINES); glVertex3f(-0.9, 0.1, 0); glVertex3f(0.8, 0.5, -1); glVertex3f(-0.2, -0.3, -2); glVertex3f(-0.1, 0.2, 3); glEnd();
glEnable(GL_POINT_SMOOTH); glPointSize(21.3);
glBegin(GL_POINTS); glVertex3f(0.7, -0.4, 0.1); glVertex3f(-0.4, -0.4, -0.3); glEnd();
)";
    expect_close_before_and_after_a_turn(text);
}

TEST_F(ExportedPage, DrawsStipplesAndTheLodBias) {
    const std::string scene = folder_ / "scene.gl";
    std::string text = R"(
glMatrixMode(GL_PROJECTION); gluPerspective(60, 4.0 / 3.0, 0.1, 100); glMatrixMode(GL_MODELVIEW); glTranslatef(0, 0, -2);
glEnable(GL_LINE_STIPPLE); glLineStipple(3, 0x3F35); glLineWidth(4); glColor3f(0.2, 0.9, 0.9);
glBegin(GL_LINE_STRIP); glVertex2f(-1.2, -0.9); glVertex2f(-0.51, -0.13); glVertex2f(0.1, -0.93); glEnd();
glDisable(GL_LINE_STIPPLE);
GLubyte stipple[] = {STIPPLE};
glPolygonStipple(stipple); glEnable(GL_POLYGON_STIPPLE); glColor3f(0.9, 0.3, 0.7); glRectf(-1.13, 0.11, -0.52, 0.59);
glDisable(GL_POLYGON_STIPPLE); glColor3f(1, 1, 1);
GLubyte texels[] = {250, 30, 250, 30,  30, 250, 30, 250,  250, 30, 250, 30,  30, 250, 30, 250};
glTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE, 4, 4, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, texels);
glTexImage2D(GL_TEXTURE_2D, 1, GL_LUMINANCE, 2, 2, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, texels);
glTexImage2D(GL_TEXTURE_2D, 2, GL_LUMINANCE, 1, 1, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, texels);
glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, 6.2);
glEnable(GL_TEXTURE_2D);
glBegin(GL_QUADS);
glTexCoord2f(0, 0); glVertex2f(0.61, 0.1); glTexCoord2f(1, 0); glVertex2f(1.19, 0.1);
glTexCoord2f(1, 1); glVertex2f(1.19, 0.8); glTexCoord2f(0, 1); glVertex2f(0.61, 0.8);
glEnd();
)";
    std::string stipple;
    for (int i = 0; i < 128; ++i) stipple += i % 3 == 0 ? "0x0F, " : "0xCC, ";
    write_file_atomically(scene, text.replace(text.find("STIPPLE}"), 7, stipple));
    const json told = used(scene);
    expect_close(scene, picture_of(told), {});
    EXPECT_GT(told["turned"], 10'000);
    EXPECT_EQ(told["turned_back"], 0);
    EXPECT_NE(page_.find("<li>line 4: after a turn, line stipples are still those of the first view</li>"),
              std::string::npos);
}

// GL_CLAMP_TO_BORDER and GL_CLAMP, which blends half of the border in; in two, one and three dimensions, with different filters, and
// with a texture coordinate q.
TEST_F(ExportedPage, DrawsBorderColoursOfTextures) {
    const std::string scene = folder_ / "scene.gl";
    write_file_atomically(scene, R"(
glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
GLubyte texels[] = {250, 30, 50, 70, 90, 210, 130, 150, 10, 60, 100, 200};
GLfloat border[] = {0.2, 0.9, 0.4, 1};
glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 2, 2, 0, GL_RGB, GL_UNSIGNED_BYTE, texels);
glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, border);
glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP);
glEnable(GL_TEXTURE_2D);
glBegin(GL_QUADS);
glTexCoord2f(-0.7, -0.6); glVertex2f(-0.9, -0.9); glTexCoord2f(1.8, -0.6); glVertex2f(-0.1, -0.9);
glTexCoord2f(1.8, 1.7); glVertex2f(-0.1, -0.1); glTexCoord2f(-0.7, 1.7); glVertex2f(-0.9, -0.1);
glEnd();
glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
glBegin(GL_QUADS);
glTexCoord4f(-0.73, -1.31, 0, 1); glVertex2f(0.1, -0.9); glTexCoord4f(3.7, -2.5, 0, 2); glVertex2f(0.9, -0.9);
glTexCoord4f(3.7, 1.01, 0, 2); glVertex2f(0.9, -0.1); glTexCoord4f(-0.73, 2.2, 0, 1); glVertex2f(0.1, -0.1);
glEnd();
glDisable(GL_TEXTURE_2D);
glTexImage1D(GL_TEXTURE_1D, 0, GL_RGB, 4, 0, GL_RGB, GL_UNSIGNED_BYTE, texels);
glTexParameterfv(GL_TEXTURE_1D, GL_TEXTURE_BORDER_COLOR, border);
glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_WRAP_S, GL_CLAMP);
glEnable(GL_TEXTURE_1D);
glBegin(GL_QUADS);
glTexCoord1f(-0.4); glVertex2f(-0.9, 0.1); glTexCoord1f(1.5); glVertex2f(-0.1, 0.1);
glTexCoord1f(1.5); glVertex2f(-0.1, 0.9); glTexCoord1f(-0.4); glVertex2f(-0.9, 0.9);
glEnd();
glDisable(GL_TEXTURE_1D);
glTexImage3D(GL_TEXTURE_3D, 0, GL_LUMINANCE, 2, 2, 3, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, texels);
glTexParameterfv(GL_TEXTURE_3D, GL_TEXTURE_BORDER_COLOR, border);
glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_WRAP_R, GL_CLAMP_TO_BORDER);
glEnable(GL_TEXTURE_3D);
glBegin(GL_QUADS);
glTexCoord3f(0, 0, -0.4); glVertex2f(0.1, 0.1); glTexCoord3f(1, 0, 1.3); glVertex2f(0.9, 0.1);
glTexCoord3f(1, 2, 1.3); glVertex2f(0.9, 0.9); glTexCoord3f(0, 2, -0.4); glVertex2f(0.1, 0.9);
glEnd();
)");
    expect_close(scene, picture_of(used(scene)), {});
    EXPECT_EQ(page_.find("lacks a part"), std::string::npos);
}

// Colours of 8 bits, so that no rounding changes a bit. Primitives overlap others, also of their own draw.
TEST_F(ExportedPage, DrawsLogicOps) {
    const std::string scene = folder_ / "scene.gl";
    write_file_atomically(scene, R"(
glClearColor(0.2, 0.4, 0.6, 1); glClear(GL_COLOR_BUFFER_BIT); glShadeModel(GL_FLAT);
glEnable(GL_BLEND); glBlendFunc(GL_ONE, GL_ONE);
glEnable(GL_COLOR_LOGIC_OP); glLogicOp(GL_XOR);
glBegin(GL_QUADS);
glColor3ub(250, 30, 90); glVertex2f(-0.91, -0.87); glVertex2f(-0.31, -0.87); glVertex2f(-0.31, -0.13); glVertex2f(-0.91, -0.13);
glColor3ub(7, 201, 100); glVertex2f(-0.71, -0.67); glVertex2f(-0.11, -0.67); glVertex2f(-0.11, 0.07); glVertex2f(-0.71, 0.07);
glEnd();
glLogicOp(GL_INVERT);
glBegin(GL_TRIANGLE_FAN);
glVertex2f(0.51, -0.51); glVertex2f(0.91, -0.51); glVertex2f(0.51, -0.11); glVertex2f(0.11, -0.51); glVertex2f(0.51, -0.91); glVertex2f(0.89, -0.41);
glVertex2f(0.31, 0.01);
glEnd();
glLogicOp(GL_AND_REVERSE); glLineWidth(5); glColor3ub(240, 170, 85);
glBegin(GL_LINE_STRIP); glVertex2f(-0.93, 0.17); glVertex2f(-0.13, 0.83); glVertex2f(-0.17, 0.31); glVertex2f(-0.91, 0.71); glEnd();
glLogicOp(GL_OR); glColorMask(1, 0, 1, 1); glPointSize(31);
glBegin(GL_POINTS); glVertex2f(0.31, 0.51); glVertex2f(0.35, 0.57); glEnd();
glColorMask(1, 1, 1, 1); glLogicOp(GL_COPY_INVERTED); glRectf(0.61, 0.21, 0.87, 0.83);
)");
    expect_close(scene, picture_of(used(scene)), {});
    EXPECT_EQ(page_.find("glLogicOp is"), std::string::npos);
}

TEST_F(ExportedPage, DrawsTexturesOfDepths) {
    const std::string scene = folder_ / "scene.gl";
    write_file_atomically(scene,
                          run_program("twinlight", {"export", "shadow-map", "--step", "2", "--as", "scene"}).out);
    expect_close(scene, picture_of(used(scene)), {});
}

TEST_F(ExportedPage, DrawsTexturesOfThreeDimensions) {
    const std::string scene = folder_ / "scene.gl";
    write_file_atomically(scene, R"(
glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
GLubyte texels[] = {250, 30, 50, 70, 90, 210, 130, 150, 10, 60, 100, 200};
glTexImage3D(GL_TEXTURE_3D, 0, GL_LUMINANCE, 2, 2, 3, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, texels);
glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_WRAP_R, GL_MIRRORED_REPEAT);
glTexGeni(GL_R, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
glTexGenfv(GL_R, GL_OBJECT_PLANE, (GLfloat[]){1, 2, 0, 0.3});
glEnable(GL_TEXTURE_GEN_R);
glEnable(GL_TEXTURE_3D);
glBegin(GL_QUADS);
glTexCoord2f(0, 0); glVertex2f(-0.9, -0.8);
glTexCoord2f(2, 0); glVertex2f(0.8, -0.9);
glTexCoord2f(2, 3); glVertex2f(0.9, 0.8);
glTexCoord2f(0, 3); glVertex2f(-0.8, 0.9);
glEnd();
)");
    expect_close(scene, picture_of(used(scene)), {});
}

// Two units, one of them with GL_COMBINE and coordinates from a plane in eye coordinates, and points that shrink with the distance.
TEST_F(ExportedPage, DrawsTextureUnitsAndPointsByDistance) {
    const std::string text = R"(
glMatrixMode(GL_PROJECTION); gluPerspective(40, 4.0 / 3.0, 1, 100);
glMatrixMode(GL_MODELVIEW); CAMERA gluLookAt(0, 2, 9,  0, 0, 0,  0, 1, 0);
GLubyte texels[] = {250, 30, 50, 255,  90, 210, 130, 150,  10, 60, 100, 200,  240, 230, 20, 90};
glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
glEnable(GL_TEXTURE_2D);
glActiveTexture(GL_TEXTURE1);
glTexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_EYE_LINEAR); glEnable(GL_TEXTURE_GEN_S);
glTexGenfv(GL_S, GL_EYE_PLANE, (GLfloat[]){0.3, 0.25, 0.35, 0.2});
glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_INTERPOLATE);
glTexEnvi(GL_TEXTURE_ENV, GL_SRC2_RGB, GL_CONSTANT);
glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, (GLfloat[]){0.4, 0.5, 0.6, 0.7});
glEnable(GL_TEXTURE_1D); glEnable(GL_DEPTH_TEST);
glBegin(GL_QUADS);
glMultiTexCoord2f(GL_TEXTURE0, 0, 0); glVertex3f(-2, -1, 0.5); glMultiTexCoord2f(GL_TEXTURE0, 3, 0); glVertex3f(2, -1, -0.5);
glMultiTexCoord2f(GL_TEXTURE0, 3, 2); glVertex3f(2, 1, -0.5); glMultiTexCoord2f(GL_TEXTURE0, 0, 2); glVertex3f(-2, 1, 0.5);
glEnd();
glDisable(GL_TEXTURE_1D); glActiveTexture(GL_TEXTURE0); glDisable(GL_TEXTURE_2D);
glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, (GLfloat[]){0.1, 0, 0.01}); glPointSize(20); glColor3f(1, 1, 0);
glBegin(GL_POINTS); glVertex3f(-1.03, 1.51, 2); glVertex3f(1.02, 1.52, 0); glVertex3f(2.13, 1.53, -3); glEnd();
)";
    expect_close_before_and_after_a_turn(text);
}

TEST_F(ExportedPage, DrawsCopiedPixelsOfTheFirstView) {
    const std::string scene = folder_ / "scene.gl";
    write_file_atomically(scene, R"(
glColor3ub(250, 30, 50); glRectf(-0.9, -0.9, -0.5, -0.4); glColor3ub(20, 130, 250); glRectf(-0.7, -0.7, -0.3, -0.3);
glWindowPos2i(330, 250);
glCopyPixels(20, 30, 220, 200, GL_COLOR);
)");
    expect_close(scene, picture_of(used(scene)), {});
    EXPECT_NE(page_.find("<li>line 4: after a turn, the pixels of glCopyPixels are still those of the first view</li>"),
              std::string::npos);
}

TEST_F(ExportedPage, DrawsBuiltInScenes) {
    expect_close("report", picture_of(used("report", {"--shading", "phong"})), Shading::kPhong);
    expect_close("lab", picture_of(used("lab")), {});
    used("legacy");
}

}  // namespace
}  // namespace twinlight::exported_page_test
