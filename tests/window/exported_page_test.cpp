// twinlight export --as html, to its end: the page draws with WebGL 2 in a browser without a window what the reference
// draws, and answers keys and the mouse.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "../unit/pictures.h"
#include "../unit/run_program.h"
#include "base/image/difference.h"
#include "base/image/file.h"
#include "browser.h"
#include "judge/compare/allowances.h"
#include "render/reference/reference.h"
#include "scene/scenes/load.h"
#include "scene/state/state.h"

namespace twinlight {
namespace {

using nlohmann::json;

// Lit and flat quadrilaterals, a texture of one dimension, the alpha test, a clip plane, points, fog.
constexpr const char* kScene = R"(
glClearColor(0.2, 0.25, 0.35, 1); glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
glMatrixMode(GL_PROJECTION); gluPerspective(40, 4.0 / 3.0, 1, 100);
glMatrixMode(GL_MODELVIEW); gluLookAt(0, 2, 9,  0, 0, 0,  0, 1, 0);
glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){2, 3, 4, 1});
glLightfv(GL_LIGHT3, GL_POSITION, (GLfloat[]){-1, 0, 1, 0});
glLightfv(GL_LIGHT3, GL_DIFFUSE, (GLfloat[]){0.3, 0.2, 0.1, 1});
glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glEnable(GL_LIGHT3); glEnable(GL_DEPTH_TEST);
glMaterialfv(GL_FRONT, GL_SPECULAR, (GLfloat[]){0.5, 0.5, 0.5, 1}); glMaterialf(GL_FRONT, GL_SHININESS, 20);
glPushMatrix(); glTranslatef(-2, 0, 0); glutSolidSphere(1, 24, 12); glPopMatrix();
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
glDisable(GL_TEXTURE_1D); glDisable(GL_ALPHA_TEST);
glPointSize(5); glColor3f(1, 1, 0);
glBegin(GL_POINTS); glVertex3f(-1.03, 1.51, 0); glVertex3f(1.02, 1.52, 0); glEnd();
)";

// Uses the page, then replaces its body with JSON. Pictures are strings of pixels, rows from the bottom.
constexpr const char* kUses = R"js(<script>
const told = {};
const hex = (bytes) => Array.from(bytes, (b) => b.toString(16).padStart(2, "0")).join("");
const picture = () => {
    const pixels = new Uint8Array(4 * canvas.width * canvas.height);
    gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    return pixels;
};
const changed = (a, b) => a.reduce((count, value, i) => count + (value !== b[i]), 0);
const press = (key) => document.dispatchEvent(new KeyboardEvent("keydown", {key, bubbles: true}));
try {
    told.size = [canvas.width, canvas.height];
    const first = picture();
    told.picture = hex(first);
    press("1");
    told.without_light = changed(picture(), first);
    told.state = document.getElementById("state").textContent.trim();
    press("1");
    told.with_it_again = changed(picture(), first);
    press("f");
    told.flat = changed(picture(), first);
    press("f");
    told.smooth = changed(picture(), first);
    canvas.dispatchEvent(new PointerEvent("pointermove", {buttons: 1, movementX: 60, movementY: 0}));
    told.turned = changed(picture(), first);
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
        const json told = opened(
            "<!DOCTYPE html><html><body><script>document.body.append('told:' + JSON.stringify({webgl: "
            "!!document.createElement('canvas').getContext('webgl2')}) + ':told')</script></body></html>");
        if (!told["webgl"]) GTEST_SKIP() << "this chromium has no WebGL 2 without a GPU";
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

    static Image picture_of(const json& told) {
        Image image(told["size"][0], told["size"][1], {0, 0, 0, 1});
        const auto pixels = told["picture"].get<std::string>();
        const auto width = static_cast<std::size_t>(image.width), height = static_cast<std::size_t>(image.height);
        for (std::size_t y = 0; y < height; ++y)
            for (std::size_t x = 0; x < width; ++x)
                for (std::size_t c = 0; c < 3; ++c)
                    image.pixels[(height - 1 - y) * width + x][c] =
                        static_cast<float>(std::stoi(pixels.substr(8 * (y * width + x) + 2 * c, 2), nullptr, 16)) / 255;
        return image;
    }

    std::string program_, page_;
    TemporaryFolder folder_;
};

// The browser draws with another driver (SwiftShader), which interpolates with other arithmetic than the reference: away
// from edges a channel may round to the neighbouring code, as anywhere, but in more pixels than on llvmpipe: up to 0.8 %
// in these scenes.
void expect_close(const std::string& scene, const Image& picture, std::optional<Shading> shading) {
    const Frame frame = make_frame(*load_commands(scene), {});
    const reference::Options options{{.shading = shading}};
    AllowedDifference allowed = reference::allowed_difference(frame, options);
    const Image exact = reference::render(frame, options);
    compare::allow_ties(allowed, exact);
    Image opaque = quantised(exact);
    for (Rgba& pixel : opaque.pixels) pixel[3] = 1;
    const ImageDifference found = difference(picture, opaque, allowed);
    const RegionDifference& interior = found.beyond_allowed;
    constexpr double kRoundingOf8Bits = 1.001 / 255, kShare = 0.01;
    EXPECT_LE(interior.max, kRoundingOf8Bits) << "at " << interior.worst_x << "," << interior.worst_y;
    EXPECT_LE(interior.differing_share(), kShare);
}

TEST_F(ExportedPage, DrawsWhatTheReferenceDrawsAndAnswersKeysAndTheMouse) {
    const std::string scene = folder_ / "scene.gl";
    write_file_atomically(scene, kScene);
    const json told = used(scene);
    expect_close(scene, picture_of(told), {});
    EXPECT_GT(told["without_light"], 10'000);
    EXPECT_EQ(told["state"], "Off: GL_LIGHT0.");
    EXPECT_EQ(told["with_it_again"], 0);
    EXPECT_GT(told["flat"], 5'000);
    EXPECT_GT(told["smooth"], 0) << "the cube is flat in the scene";
    EXPECT_GT(told["turned"], 10'000);
    EXPECT_NE(page_.find("this scene does not use: GL_TEXTURE_LOD_BIAS, a depth range"), std::string::npos);
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

TEST_F(ExportedPage, DrawsBuiltInScenes) {
    expect_close("report", picture_of(used("report", {"--shading", "phong"})), Shading::kPhong);
    expect_close("lab", picture_of(used("lab")), {});
    used("legacy");
    EXPECT_NE(page_.find("and this scene uses: line width, polygon mode."), std::string::npos);
}

}  // namespace
}  // namespace twinlight
