// The page's keys and mouse, without a browser: the text follows the commands.
#include "app/web/page_controls.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

#include "app/session/tutor.h"
#include "app/web/page_probe.h"
#include "app/web/page_scene.h"
#include "base/text/json.h"
#include "render/reference/reference.h"

namespace twinlight::web::page_controls_test {

namespace {

using Json = nlohmann::json;

std::string text_after(PageScene& scene, const std::string& answer) {
    const Json json = Json::parse(answer);
    EXPECT_EQ(json["known"], true);
    EXPECT_EQ(Json::parse(scene.open(json["text"].get<std::string>(), "scene", "", {64, 64}))["errors"], Json::array());
    return json["text"];
}

constexpr const char* kScene = R"(// A ball.
glEnable(GL_LIGHTING);
    glEnable ( GL_LIGHT0 ) /* on; */ ;  // a lamp: 日
gluLookAt(0, 0, 5,  0, 0, 0,  0, 1, 0);
glutSolidSphere(1, 8, 8);
)";

TEST(WebControls, ChangeOnlyTheirOwnStatements) {
    PageScene scene;
    scene.open(kScene, "scene", "", {64, 64});
    std::string expected = kScene;
    const std::string statement = "glEnable ( GL_LIGHT0 ) /* on; */ ;";
    expected.replace(expected.find(statement), statement.size(), "glDisable(GL_LIGHT0);");
    EXPECT_EQ(text_after(scene, scene.controls().press('1')), expected);
    EXPECT_EQ(text_after(scene, scene.controls().press('z')), kScene);
}

TEST(WebControls, InsertLinesAsTheNextOneIsIndented) {
    PageScene scene;
    scene.open("  glutSolidSphere(1, 8, 8);\n", "scene", "", {64, 64});
    EXPECT_EQ(text_after(scene, scene.controls().press('l')),
              "  glEnable(GL_LIGHTING);\n  glutSolidSphere(1, 8, 8);\n");
}

TEST(WebControls, MoveTheCamera) {
    PageScene scene;
    scene.open(kScene, "scene", "", {64, 64});
    scene.controls().start_drag(false);
    EXPECT_NE(text_after(scene, scene.controls().drag(false, 180, 0)).find("gluLookAt(-5, 0, 0,  0, 0, 0,  0, 1, 0);"),
              std::string::npos);
    EXPECT_NE(text_after(scene, scene.controls().zoom(1)).find("gluLookAt(-4.54545, 0, 0,  0, 0, 0,  0, 1, 0);"),
              std::string::npos);
}

TEST(WebControls, ChangeTheNumbersOfTheLighting) {
    PageScene scene;
    const std::string text =
        "GLfloat place[] = {1, 2, 3, 1};\nglLightfv(GL_LIGHT0, GL_POSITION, place);\n"
        "glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 60);\nglutSolidSphere(1, 8, 8);\n";
    scene.open(text, "scene", "", {64, 64});
    const auto numbers = [&] { return Json::parse(scene.controls().numbers()); };
    const Json before = numbers();
    ASSERT_EQ(before.size(), 3u);
    EXPECT_EQ(before[0]["name"], "GL_LIGHT0 GL_POSITION x");
    EXPECT_EQ(before[1]["value"], 2);
    EXPECT_EQ(before[1]["smallest"], nullptr) << "no limit";
    EXPECT_EQ(before[2]["name"], "GL_LIGHT0 GL_SPOT_CUTOFF");
    EXPECT_EQ(before[2]["largest"], 180);
    // A drag is one step of undo; an illegal angle becomes a legal one.
    const auto set = [&](std::size_t number, double value) {
        const Json found = numbers()[number];
        return scene.controls().set_argument(found["command"], found["argument"], value);
    };
    set(1, 2.25);
    EXPECT_NE(text_after(scene, set(1, 2.5)).find("{1, 2.5, 3, 1}"), std::string::npos);
    EXPECT_NE(text_after(scene, set(2, 88)).find("GL_SPOT_CUTOFF, 88)"), std::string::npos);
    EXPECT_NE(text_after(scene, set(2, 170)).find("GL_SPOT_CUTOFF, 180)"), std::string::npos);
    EXPECT_NE(text_after(scene, scene.controls().press('z')).find("GL_SPOT_CUTOFF, 60)"), std::string::npos);
    EXPECT_EQ(text_after(scene, scene.controls().press('z')), text);
    EXPECT_EQ(Json::parse(scene.controls().set_argument(99, 0, 1))["text"], text);
    EXPECT_EQ(Json::parse(scene.controls().set_argument(1, 99, 1))["text"], text);
    scene.open("glutSolidSphere(1, 8, 8);\n", "scene", "", {64, 64});
    EXPECT_EQ(numbers(), Json::array());
}

TEST(WebControls, ShowTheCallsOfATutor) {
    for (const Json& tutor : Json::parse(page_tutors())) {
        PageScene scene;
        scene.open(tutor["text"].get<std::string>(), "tutor", "", {64, 64});
        const Json calls = Json::parse(scene.controls().calls());
        EXPECT_EQ(calls.size(), session::kTutorCalls) << tutor["name"];
        for (const Json& call : calls) {
            std::string text;
            for (const Json& part : call) text += part["text"].get<std::string>();
            EXPECT_NE(tutor["text"].get<std::string>().find(text), std::string::npos) << text;
        }
    }
    PageScene scene;
    scene.open("glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);\nglNormal3f(0, 0.6, 0.8);\nglRectf(0, 0, 1, 1);\n",
               "scene", "", {64, 64});
    const Json calls = Json::parse(scene.controls().calls()), flag = calls[0][3], normal = calls[1][3];
    EXPECT_FALSE(calls[0][1].contains("number")) << "a name";
    EXPECT_NE(flag["help"].get<std::string>().find("1: highlights use the direction to the eye"), std::string::npos);
    EXPECT_EQ(flag["number"]["name"], "GL_LIGHT_MODEL_LOCAL_VIEWER");
    EXPECT_EQ(flag["number"]["largest"], 1);
    EXPECT_EQ(normal["number"]["name"], "glNormal3f y");
    EXPECT_EQ(normal["text"], "0.6");
}

TEST(WebControls, DragALightInTheSceneFromOutside) {
    PageScene scene;
    const std::string text =
        "glEnable(GL_LIGHTING); glEnable(GL_LIGHT0);\nglMatrixMode(GL_PROJECTION); gluPerspective(40, 1, 1, 10); "
        "glMatrixMode(GL_MODELVIEW);\n"
        "gluLookAt(0, 0, 5, 0, 0, 0, 0, 1, 0);\n"
        "glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){0, 1.5, 1, 1});\nglutSolidSphere(1, 8, 8);\n";
    scene.open(text, "scene", "", {640, 480});
    PageControls& controls = scene.controls();
    const auto place_of_label = [&](std::size_t i, const char* name) {
        const Json label = controls.world().header["labels"][i];
        EXPECT_EQ(label["text"], name);
        return std::pair(label["at"][0].get<double>(), label["at"][1].get<double>());
    };
    const auto before = place_of_label(1, "GL_LIGHT0");
    // Its name is 20 pixels above it.
    controls.press_world(static_cast<int>(before.first), static_cast<int>(before.second) + 20);
    EXPECT_EQ(text_after(scene, controls.drag_world(30, 10)).find("{0, 1.5, 1, 1}"), std::string::npos);
    const auto after = place_of_label(1, "GL_LIGHT0");
    EXPECT_NEAR(after.first - before.first, 30, 1);
    EXPECT_NEAR(after.second - before.second, 10, 1);
    EXPECT_EQ(text_after(scene, controls.press('z')), text);
    // Beside the light, a drag turns the view.
    const auto camera = place_of_label(0, "camera");
    controls.press_world(0, 0);
    EXPECT_EQ(text_after(scene, controls.drag_world(30, 0)), text);
    EXPECT_GT(std::abs(place_of_label(0, "camera").first - camera.first), 5);
}

TEST(WebProbe, HasTheTermsAndTheVectorsOfAPixel) {
    PageScene scene;
    // The middle of the sphere faces the viewer; GL_LIGHT0 shines along z, so the diffuse light of 0.8 is whole.
    scene.open(
        "glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glEnable(GL_DEPTH_TEST);\n"
        "glRectf(-0.9, -0.9, 0.9, 0.9);\n",
        "scene", "", {64, 64});
    const Json here = Json::parse(probed(scene.scene(), {}, 32, 32));
    EXPECT_EQ(here["rows"].size(), 5u) << "emission, ambient, the light, the sum and the clamped sum";
    EXPECT_EQ(here["rows"][2]["what"], "GL_LIGHT0");
    EXPECT_NEAR(here["rows"][2]["color"][0].get<double>(), 0.8, 1e-6) << "d_cm d_cl, rounded to floats";
    EXPECT_EQ(here["rows"][3]["is_result"], true);
    ASSERT_GE(here["arrows"].size(), 3u);
    EXPECT_EQ(here["arrows"][0]["kind"], "normal");
    EXPECT_EQ(here["arrows"][0]["from"], here["arrows"][0]["to"]) << "towards the viewer";
    const Json beside = Json::parse(probed(scene.scene(), {}, 0, 0));
    EXPECT_EQ(beside["rows"], Json::array());
    EXPECT_EQ(beside["arrows"], Json::array());
}

TEST(WebControls, KeepTheStepsOfAScene) {
    PageScene scene;
    const std::string text =
        "#pragma twinlight step(\"A\")\nglEnable(GL_LIGHT1);\n#pragma twinlight step(\"B\")\nglEnable(GL_LIGHT2);\n"
        "#pragma twinlight step()\nglutSolidSphere(1, 8, 8);\n";
    scene.open(text, "scene", "2", {64, 64});
    const Json json = Json::parse(scene.controls().press('3'));
    std::string expected = text;
    expected.replace(expected.find("glEnable(GL_LIGHT2)"), 19, "glDisable(GL_LIGHT2)");
    EXPECT_EQ(json["text"], expected);
    EXPECT_EQ(json["shown"], 2);
}

// One statement, two commands that change in different ways.
TEST(WebControls, WriteTheTextAgainWhereAChangeDoesNotFit) {
    PageScene scene;
    const std::string text =
        "#include <GL/glut.h>\n"
        "void display(void) {\n"
        "    int i;\n"
        "    for (i = 0; i < 2; ++i) glutSolidSphere(1, 4 + 4 * i, 8);  /* two balls */\n"
        "}\n"
        "int main(int argc, char** argv) {\n"
        "    glutInit(&argc, argv);\n"
        "    glutCreateWindow(\"balls\");\n"
        "    glutDisplayFunc(display);\n"
        "    glutMainLoop();\n"
        "}\n";
    scene.open(text, "scene", "", {64, 64});
    const Json json = Json::parse(scene.controls().press('+'));
    EXPECT_EQ(json["text"].get<std::string>().find("two balls"), std::string::npos) << json["text"];
    EXPECT_NE(json["message"].get<std::string>().find("z brings it back"), std::string::npos);
    EXPECT_EQ(Json::parse(scene.controls().press('z'))["text"], text);
}

TEST(WebControls, HaveOnlyThePagesKeys) {
    PageScene scene;
    scene.open(kScene, "scene", "", {64, 64});
    EXPECT_EQ(Json::parse(scene.controls().press('h'))["known"], false);
    EXPECT_EQ(Json::parse(scene.controls().press(']'))["scene"], 1);
    EXPECT_EQ(Json::parse(scene.controls().press('e'))["exports"], true);
    EXPECT_EQ(Json::parse(scene.controls().press('?'))["keys"], true);
}

// The judge compares with the rows that were drawn, so they must be the whole picture's.
TEST(PageScene, DrawsRowsAsTheWholePicture) {
    PageScene scene;
    scene.open(kScene, "scene", "", {64, 64});
    const Image whole = reference::render(scene.scene().frame, {});
    scene.reference({}, 10, 40);
    const auto floats = scene.reference_floats(10, 40);
    ASSERT_EQ(floats.size(), 4u * 64 * 30);
    for (std::size_t i = 0; i < floats.size(); ++i)
        ASSERT_EQ(floats[i], whole.pixels[whole.index(0, 10) + i / 4][i % 4]);
    EXPECT_EQ(scene.coarse_reference({}).size(), 4u * 16 * 16);
}

}  // namespace

}  // namespace twinlight::web::page_controls_test
