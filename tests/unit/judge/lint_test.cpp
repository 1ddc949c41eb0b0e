// The linter: each rule finds its mistake and nothing else, the corrected scene has none and another picture, and scenes that
// are right have no warnings.
#include "judge/lint/lint.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "../run_program.h"
#include "base/image/file.h"
#include "base/image/png.h"
#include "base/text/json.h"
#include "judge/lint/tried.h"
#include "judge/lint/watch.h"
#include "lint_warnings.h"
#include "render/reference/reference.h"
#include "scene/command/text.h"
#include "scene/recorded/recorded_frame.h"
#include "scene/scenes/load.h"
#include "scene/state/state.h"

namespace twinlight::lint_test {
namespace {

TEST(Lint, WarnsOfEachMistakeByItsOwnRuleOnly) {
    for (const lint::Rule& rule : lint::rules())
        EXPECT_EQ(names(warnings_of(lint::wrong_scene(rule))), std::set<std::string>{std::string(rule.name)})
            << rule.name << ":\n"
            << lint::wrong_scene(rule);
}

TEST(Lint, HasNoWarningsOfMendedScenes) {
    for (const lint::Rule& rule : lint::rules())
        EXPECT_EQ(names(warnings_of(lint::corrected_scene(rule))), std::set<std::string>{}) << rule.name;
}

TEST(Lint, CorrectedScenesHaveAnotherPicture) {
    for (const lint::Rule& rule : lint::rules()) {
        const Image wrong = reference::render(lint::shown_frame(scene_of(lint::wrong_scene(rule))), {});
        const Image corrected = reference::render(lint::shown_frame(scene_of(lint::corrected_scene(rule))), {});
        std::size_t differing = 0;
        for (std::size_t i = 0; i < wrong.pixels.size(); ++i) {
            float difference = 0;
            for (int c = 0; c < 3; ++c)
                difference = std::max(difference, std::abs(wrong.pixels[i][c] - corrected.pixels[i][c]));
            differing += difference > 10.0F / 255;  // what a reader of docs/lint.md can see
        }
        EXPECT_GT(differing, 100u) << rule.name;
    }
}

TEST(Lint, FixesScenesByItsEdits) {
    std::size_t corrected = 0;
    for (const lint::Rule& rule : lint::rules()) {
        const std::string text = lint::wrong_scene(rule);
        const std::vector<lint::Warning> warnings = warnings_of(text);
        if (warnings.empty() || warnings[0].edits.empty()) continue;
        ++corrected;
        EXPECT_EQ(names(warnings_of(lint::corrected(text, warnings[0]))), std::set<std::string>{})
            << rule.name << ":\n"
            << lint::corrected(text, warnings[0]);
    }
    EXPECT_GE(corrected, 25u);
}

TEST(Lint, NamesEachRuleOnce) {
    std::set<std::string_view> names;
    for (const lint::Rule& rule : lint::rules()) {
        EXPECT_TRUE(names.insert(rule.name).second) << rule.name;
        for (const std::string_view text : {rule.what, rule.why, rule.fix}) EXPECT_NE(text, "") << rule.name;
    }
    EXPECT_EQ(lint::find_rule("no-such-rule"), nullptr);
    ASSERT_NE(lint::find_rule("light-black"), nullptr);
    EXPECT_EQ(lint::find_rule("light-black")->name, "light-black");
}

TEST(Lint, PageAndPicturesMatchTheTable) {
    EXPECT_EQ(read_file("docs/lint.md"), lint::markdown()) << "build/twinlight lint --rules -o docs writes it again";
    std::set<std::string> expected;
    for (const lint::Rule& rule : lint::rules()) {
        for (const bool is_right : {false, true}) {
            const std::string text = is_right ? lint::corrected_scene(rule) : lint::wrong_scene(rule);
            const std::string file = std::string(rule.name) + (is_right ? "-right.png" : "-wrong.png");
            expected.insert(file);
            const auto pixels = [](const std::string& png) { return decode_png_pixels(png, 2000); };
            const Image shown = reference::render(lint::shown_frame(scene_of(text)), {});
            EXPECT_TRUE(pixels(read_file("docs/lint/" + file)) == pixels(encode_png(shown)))
                << file << ": build/twinlight lint --rules -o docs writes it again";
        }
    }
    for (const auto& entry : std::filesystem::directory_iterator("docs/lint"))
        EXPECT_TRUE(expected.contains(entry.path().filename())) << entry.path() << " belongs to no rule";
}

// ---- No false alarms ----

// tests/unit/judge/lint_expected.txt: "FILE RULE reason". The reason says why the warning is right.
std::map<std::string, std::set<std::string>> expected_warnings() {
    std::map<std::string, std::set<std::string>> expected;
    std::istringstream lines(read_file("tests/unit/judge/lint_expected.txt"));
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || line[0] == '#') continue;
        std::istringstream words(line);
        std::string file, rule, reason;
        words >> file >> rule >> reason;
        EXPECT_NE(lint::find_rule(rule), nullptr) << line;
        EXPECT_NE(reason, "") << line;
        EXPECT_TRUE(expected[file].insert(rule).second) << line << " is there twice";
    }
    return expected;
}

Scene load(const std::string& file) {
    const std::shared_ptr<const Recording> recording = load_recording(file);
    if (const CommandList* list = recording->command_list()) return {recording, make_frame(*list, {})};
    return make_recorded_frame(recording, {}).scene;
}

std::vector<std::string> files_in(const std::string& folder, const std::string& ending) {
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.path().string().ends_with(ending)) files.push_back(entry.path().string());
    std::ranges::sort(files);
    return files;
}

TEST(Lint, WarnsOfKnownScenesOnlyWhereThatIsRight) {
    auto expected = expected_warnings();
    std::vector<std::string> files = files_in("src/scene/scenes", ".gl");
    for (const std::string& file : files_in("golden/hard", ".gl")) files.push_back(file);
    for (const std::string& file : files_in("tests/homework", ".c")) files.push_back(file);
    for (const std::string& file : files_in("tests/traces", "dump.txt")) files.push_back(file);
    EXPECT_GT(files.size(), 250u);
    for (const std::string& file : files) {
        Scene scene;
        try {
            scene = load(file);
        } catch (const SceneError&) {
            continue;  // a hard case that expects an error
        }
        EXPECT_EQ(names(lint::lint(scene)), expected[file]) << file;
        expected.erase(file);
    }
    for (const auto& [file, rules] : expected) EXPECT_TRUE(rules.empty()) << file << " was not read";
}

// Warnings that are right: a fix that is offered makes the scene's text clean of its mistake, and adds no other.
TEST(Lint, FixesOfKnownScenesCorrectTheirTexts) {
    int corrected = 0;
    for (const auto& [file, rules] : expected_warnings()) {
        if (!file.ends_with(".gl")) continue;
        const Scene scene = load(file);
        std::vector<lint::Warning> warnings = lint::lint(scene);
        lint::try_fixes(scene, lint::later_scenes(scene), warnings);
        for (const lint::Warning& warning : warnings) {
            if (warning.edits.empty() || warning.count > 1) continue;
            ++corrected;
            const std::string text = lint::corrected(read_file(file), warning);
            const auto list = std::make_shared<CommandList>(read_scene(text, file, file));
            std::set<std::string> left = names(lint::lint(Scene{list, make_frame(*list, {})}));
            EXPECT_FALSE(left.contains(std::string(warning.rule->name))) << file << ":\n" << text;
            for (const lint::Warning& known : warnings) left.erase(std::string(known.rule->name));
            EXPECT_EQ(left, std::set<std::string>{}) << file << ", " << warning.rule->name << ":\n" << text;
        }
    }
    EXPECT_GE(corrected, 5);
}

// ---- What silences, joins and prints ----

const std::string kBlack = lint::wrong_scene(*lint::find_rule("light-black"));

TEST(Lint, CommentsSilenceARule) {
    EXPECT_EQ(names(warnings_of("// twinlight: allow(light-black)\n" + kBlack)).size(), 0u);
    EXPECT_EQ(names(warnings_of("// twinlight: allow(color-255, light-black)\n" + kBlack)).size(), 0u);
    EXPECT_EQ(names(warnings_of("// twinlight: allow(color-255)\n" + kBlack)).size(), 1u);
    const std::string call = "glEnable(GL_LIGHT1);";
    std::string at_end = kBlack;
    at_end.replace(at_end.find(call), call.size(), call + "  // twinlight: allow(light-black)");
    EXPECT_EQ(names(warnings_of(at_end)).size(), 0u);
    std::string elsewhere = kBlack;
    elsewhere.replace(elsewhere.find("glutSolid"), 0, "glFlush();  // twinlight: allow(light-black)\n");
    EXPECT_EQ(names(warnings_of(elsewhere)).size(), 1u);
}

TEST(Lint, CountsRepeatedWarnings) {
    std::string text = lint::wrong_scene(*lint::find_rule("scale-without-normalize"));
    for (int i = 0; i < 3; ++i) text += "glutSolidSphere(0.5, 40, 20);\n";
    const std::vector<lint::Warning> warnings = warnings_of(text);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_GE(warnings[0].count, 4);
    EXPECT_NE(lint::headline(warnings[0]).find("times; this is the first"), std::string::npos);
}

TEST(Lint, SeesCommandsOfDisplayListsWhereTheyAreExecuted) {
    const std::string list =
        "GLuint list = glGenLists(1);\nglNewList(list, GL_COMPILE);\nglutSolidSphere(0.5, 40, 20);\nglEndList();\n";
    const std::string lit = "glClear(GL_COLOR_BUFFER_BIT);\nglEnable(GL_LIGHTING);\nglEnable(GL_LIGHT0);\n";
    EXPECT_EQ(names(warnings_of(list + lit + "glCallList(list);\n")), std::set<std::string>{});
    EXPECT_EQ(names(warnings_of(list + lit + "glScalef(0.5, 0.5, 0.5);\nglCallList(list);\n")),
              std::set<std::string>{"scale-without-normalize"});
}

TEST(Lint, ComparesTheAspectWithAViewportThatTheTextSets) {
    const std::string squeezed = lint::wrong_scene(*lint::find_rule("aspect-of-viewport"));
    const std::set<std::string> none, aspect{"aspect-of-viewport"};
    EXPECT_EQ(lint::headline(warnings_of(squeezed)[0]),
              "scene.gl:6:1: warning: the picture is squeezed: the aspect of gluPerspective is 1, but the viewport has "
              "160 x 120 pixels, which is 1.333 [aspect-of-viewport]");
    EXPECT_EQ(names(warnings_of(changed(squeezed, "glViewport(0, 0, width, height);", ""))), none);
    EXPECT_EQ(names(warnings_of(changed(squeezed, "width / height", "1.3"))), none);  // right to two digits
    EXPECT_EQ(names(warnings_of(changed(squeezed, "width / height", "1.29"))), aspect);
    // Another matrix makes up for it.
    EXPECT_EQ(
        names(warnings_of(changed(squeezed, "glutSolid", "glScalef(0.75, 1, 1); glEnable(GL_NORMALIZE); glutSolid"))),
        none);
    EXPECT_EQ(names(warnings_of(changed(squeezed, "gluPerspective", "glScalef(0.75, 1, 1); gluPerspective"))), none);
}

TEST(Lint, ComparesTheAspectWithTheWindowOfAProgram) {
    const std::string program =
        "#include <GL/glut.h>\nvoid display(void) { glutSolidSphere(1, 20, 20); }\nint main(int argc, char **argv) {\n"
        "glutInit(&argc, argv); glutInitWindowSize(WINDOW); glutCreateWindow(\"w\"); glMatrixMode(GL_PROJECTION);\n"
        "gluPerspective(45, 1, 1, 100); glMatrixMode(GL_MODELVIEW); glTranslatef(0, 0, -5); glutDisplayFunc(display); "
        "glutMainLoop(); return 0; }";
    const auto warnings = [&](const std::string& window) {
        const auto list =
            std::make_shared<CommandList>(read_scene(changed(program, "WINDOW", window), "scene.c", "scene.c"));
        return names(lint::lint(make_scene(list, {.width = list->window->width, .height = list->window->height})));
    };
    EXPECT_EQ(warnings("400, 300"), std::set<std::string>{"aspect-of-viewport"});
    EXPECT_EQ(warnings("300, 300"), std::set<std::string>{});
}

TEST(Lint, KnowsWhichTexturesAreIncomplete) {
    const std::string incomplete = lint::wrong_scene(*lint::find_rule("texture-incomplete"));
    const std::set<std::string> none;
    EXPECT_EQ(names(warnings_of(changed(incomplete, "glEnable(GL_TEXTURE_2D);", ""))), none);
    EXPECT_EQ(names(warnings_of(changed(incomplete, "glTexImage2D(",
                                        "glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE); glTexImage2D("))),
              none);
    EXPECT_EQ(names(warnings_of(changed(incomplete, "glEnable(GL_TEXTURE_2D);",
                                        "glBindTexture(GL_TEXTURE_2D, 1); glEnable(GL_TEXTURE_2D);"))),
              none);  // no image: a texture that is not there yet
}

const std::set<std::string> kNone;

// A quadrilateral at the pole of a computed ball: two of its corners are 1e-17 apart. GL draws its other triangle, and the normal is right.
TEST(Lint, SliversHaveNoDirection) {
    const std::string ball =
        std::string(lint::view_lines()) + std::string(lint::light_lines()) +
        "glRotatef(-90, 1, 0, 0); glNormal3f(-0.0076249177, 0.08715334, 0.9961657);\n"
        "glBegin(GL_QUADS); glVertex3f(-1.13856045e-08, 0.26047227, 1.4772116);\n"
        "glVertex3f(-0.045230538, 0.25651512, 1.4772116); glVertex3f(-1.5949326e-17, 9.045312e-17, 1.5);\n"
        "glVertex3f(-4.014826e-24, 9.184851e-17, 1.5); glEnd();";
    EXPECT_EQ(names(warnings_of(ball)), kNone);
    // A small triangle has one, wherever it is.
    EXPECT_EQ(names(warnings_of(std::string(lint::view_lines()) + std::string(lint::light_lines()) +
                                "glNormal3f(0, 1, 0); glScalef(1e5, 1e5, 1e5); glEnable(GL_NORMALIZE);"
                                "glBegin(GL_TRIANGLES); glVertex3f(0, 0, 0); glVertex3f(1e-5, 0, 0);"
                                "glVertex3f(0, 1e-5, 0); glEnd();")),
              std::set<std::string>{"normal-stale"});
}

// 2.14.3: glMaterial sets the faces that do not follow glColor, if they count.
TEST(Lint, OverriddenIsAMaterialWhoseFacesAllFollowTheColor) {
    const auto with = [](const std::string& face, const std::string& tracked, bool two_sided) {
        return names(warnings_of(std::string(lint::view_lines()) + std::string(lint::light_lines()) +
                                 (two_sided ? "glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);" : "") + "glColorMaterial(" +
                                 tracked + ", GL_AMBIENT_AND_DIFFUSE); glEnable(GL_COLOR_MATERIAL);\nglMaterialfv(" +
                                 face + ", GL_DIFFUSE, (GLfloat[]){0, 1, 0, 1}); glutSolidSphere(1, 40, 20);"));
    };
    const std::set<std::string> overridden{"material-overridden"};
    EXPECT_EQ(with("GL_FRONT_AND_BACK", "GL_BACK", false), kNone);
    EXPECT_EQ(with("GL_FRONT_AND_BACK", "GL_FRONT", true), kNone);
    EXPECT_EQ(with("GL_FRONT_AND_BACK", "GL_FRONT", false), overridden);  // the back's does not count
    EXPECT_EQ(with("GL_FRONT_AND_BACK", "GL_FRONT_AND_BACK", true), overridden);
    EXPECT_EQ(with("GL_FRONT", "GL_FRONT", true), overridden);
    // Each of two.
    EXPECT_EQ(
        warnings_of(std::string(lint::view_lines()) + std::string(lint::light_lines()) +
                    "glEnable(GL_COLOR_MATERIAL);\nglMaterialfv(GL_FRONT, GL_AMBIENT, (GLfloat[]){0.7, 0, 0, 1});\n"
                    "glMaterialfv(GL_FRONT, GL_DIFFUSE, (GLfloat[]){0, 1, 0, 1}); glutSolidSphere(1, 40, 20);")
            .size(),
        2u);
}

TEST(Lint, FlattenedObjectsNeedNoNormalize) {
    const std::string shadow = lint::wrong_scene(*lint::find_rule("lit-shadow"));
    EXPECT_EQ(warnings_of(shadow).size(), 1u);
    EXPECT_EQ(names(warnings_of(changed(shadow, "glutSolidSphere(0.7, 40, 20);", "glEnable(GL_NORMALIZE);"))),
              std::set<std::string>{"lit-shadow"});
    // On the plane y = 0: the linear part of the matrix has no inverse either.
    EXPECT_EQ(names(warnings_of(changed(shadow, "-1, -2, -1, 2}", "0, 0, 0, 2}"))),
              std::set<std::string>{"lit-shadow"});
    // Thin objects are not flat.
    EXPECT_EQ(names(warnings_of(std::string(lint::view_lines()) + std::string(lint::light_lines()) +
                                "glEnable(GL_NORMALIZE); glScalef(1, 1e-4, 1); glutSolidSphere(1, 40, 20);")),
              kNone);
}

TEST(Lint, EmissionStaysOnlyWhereItIsNotTakenBack) {
    const std::string sun = lint::wrong_scene(*lint::find_rule("emission-stays"));
    EXPECT_EQ(names(warnings_of(changed(sun, "{1, 0.8, 0.2, 1}", "{0.1, 0.1, 0.1, 1}"))), kNone);  // of all objects
    EXPECT_EQ(names(warnings_of(changed(sun, "glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE",
                                        "glMaterialfv(GL_FRONT, GL_EMISSION, (GLfloat[]){0, 0, 0.2, 1});"
                                        "glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE"))),
              kNone);
    EXPECT_EQ(names(warnings_of(
                  changed(sun, "glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, (GLfloat[]){0.2, 0.4, 0.9, 1});", ""))),
              kNone);
}

// 2.8: an array counts only while it is enabled.
TEST(Lint, FindsNormalArraysThatAreOffOrEmpty) {
    const std::string off = lint::wrong_scene(*lint::find_rule("normal-array-off"));
    EXPECT_EQ(names(warnings_of(changed(off, "glNormalPointer(GL_FLOAT, 0, up);", "glNormal3f(0, 1, 0);"))), kNone);
    const std::string zeros = changed(lint::corrected_scene(*lint::find_rule("normal-array-off")),
                                      "0, 1, 0,  0, 1, 0,  0, 1, 0,  0, 1, 0", "0, 0, 0,  0, 0, 0,  0, 0, 0,  0, 0, 0");
    EXPECT_EQ(names(warnings_of(zeros)), std::set<std::string>{"normal-zero"});
}

// Two places of one message: the lengths differ by less than is printed.
TEST(Lint, PrintsAMessageOnce) {
    const std::vector<lint::Warning> warnings =
        warnings_of(std::string(lint::view_lines()) + std::string(lint::light_lines()) +
                    "glBegin(GL_TRIANGLES); glNormal3f(0, 0, 0.6499); glVertex3f(-1, -1, 0); glVertex3f(0, -1, 0);"
                    "glVertex3f(0, 1, 0); glEnd();\nglBegin(GL_TRIANGLES); glNormal3f(0, 0, 0.6501);"
                    "glVertex3f(0, -1, 0); glVertex3f(1, -1, 0); glVertex3f(0, 1, 0); glEnd();");
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_EQ(warnings[0].count, 2);
}

TEST(Lint, FindsNearPlanesOfBothCommands) {
    const auto with = [](const std::string& call) {
        return names(warnings_of("glClear(GL_DEPTH_BUFFER_BIT); glMatrixMode(GL_PROJECTION); " + call +
                                 " glMatrixMode(GL_MODELVIEW); glTranslatef(0, 0, -5); glutWireCube(1);"));
    };
    EXPECT_EQ(with("glFrustum(-1e-4, 1e-4, -1e-4, 1e-4, 1e-4, 1000);"), std::set<std::string>{"near-plane"});
    EXPECT_EQ(with("glFrustum(-1, 1, -1, 1, 1, 1000);"), std::set<std::string>{});
    EXPECT_EQ(with("gluPerspective(45, 4.0 / 3.0, 1e-4, 1000);"), std::set<std::string>{"near-plane"});
}

TEST(Lint, FindsAHighlightEverywhereOnlyWhereALocalViewerChangesIt) {
    const std::string everywhere = lint::wrong_scene(*lint::find_rule("highlight-everywhere"));
    const std::set<std::string> none;
    EXPECT_EQ(names(warnings_of(changed(everywhere, "{0, 2, -6, 0}", "{0, 2, -3, 1}"))), none);  // positional
    EXPECT_EQ(names(warnings_of(changed(everywhere, "SHININESS, 100", "SHININESS, 1"))), none);  // no bright place
    EXPECT_EQ(names(warnings_of(changed(everywhere, "gluDisk(floor, 0, 3, 60, 60)", "glutSolidSphere(1.5, 40, 20)"))),
              none);
}

// ---- Whole programs ----

// A program with these global variables and functions, whose display function and main have these statements.
std::string program(const std::string& globals, const std::string& display, const std::string& init) {
    return "#include <GL/glut.h>\n" + globals + "\nvoid display(void) {\n" + display +
           "\n}\nint main(int argc, char **argv) {\nglutInit(&argc, argv); glutInitWindowSize(160, 120); "
           "glutCreateWindow(\"w\");\n" +
           init + "\nglutDisplayFunc(display); glutMainLoop(); return 0; }\n";
}

const std::string kLit = "glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); ";
const std::string kClears = "glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT); ";

TEST(Lint, CallsThatOnlyAKeyMakesAreNotMissing) {
    struct Row {
        const char *rule, *init, *display, *key;
    };
    const std::string ball = "glutSolidSphere(0.5, 20, 20);";
    for (const Row& row : {
             Row{"lighting-off", "glEnable(GL_LIGHT0);", "", "glEnable(GL_LIGHTING);"},
             Row{"light-never-enabled", "glLightf(GL_LIGHT1, GL_CONSTANT_ATTENUATION, 2);", "", "glEnable(GL_LIGHT1);"},
             Row{"light-never-enabled", "glLightf(GL_LIGHT1, GL_CONSTANT_ATTENUATION, 2);", "",
                 "glEnable(GL_LIGHT0 + key - '0');"},
             Row{"color-ignored", "", "glColor3f(1, 0, 0);", "if (key == 'c') glEnable(GL_COLOR_MATERIAL);"},
             Row{"shininess-without-specular", "glMaterialf(GL_FRONT, GL_SHININESS, 20);", "",
                 "GLfloat s[] = {1, 1, 1, 1}; glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, s);"},
             Row{"back-material-one-sided", "GLfloat d[] = {1, 0, 0, 1}; glMaterialfv(GL_BACK, GL_DIFFUSE, d);", "",
                 "glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);"},
             Row{"spot-without-cutoff", "glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, 3);", "",
                 "glLightf (GL_LIGHT0,\n GL_SPOT_CUTOFF, 30);"},
         }) {
        const bool is_lit = std::string(row.rule) != "lighting-off";
        const auto text = [&](const std::string& key) {
            return program("void keys(unsigned char key, int x, int y) { " + key + " }", kClears + row.display + ball,
                           (is_lit ? kLit : "") + row.init + " glutKeyboardFunc(keys);");
        };
        const std::set<std::string> none, one{row.rule};
        EXPECT_EQ(names(warnings_of(text(""))), one) << row.rule;
        EXPECT_EQ(names(warnings_of(text(row.key))), none) << row.rule << ": " << row.key;
        // In a comment, in a text, or for something else, it is no call.
        EXPECT_EQ(names(warnings_of(text("/* " + std::string(row.key) + " */ puts(\"glEnable(GL_LIGHT1)\");"))), one);
        EXPECT_EQ(names(warnings_of(text("glEnable(GL_FOG); glShadeModel(GL_FLAT);"))), one) << row.rule;
    }
}

TEST(Lint, FindsWhatTheFirstPictureLeavesBehind) {
    const std::string moves = "double x = -1; void idle(void) { x += 1; }", idle = "glutIdleFunc(idle); ";
    const std::string depth = "glEnable(GL_DEPTH_TEST); ";
    const std::string ball = "glLoadIdentity(); glTranslated(x, 0, 0); glutSolidSphere(0.4, 20, 20);";
    const auto found = [&](const std::string& display, const std::string& init) {
        return names(warnings_of(program(moves, display, kLit + init)));
    };
    const std::set<std::string> none, colors{"colors-not-cleared"}, depths{"depth-not-cleared"};
    EXPECT_EQ(found(kClears + ball, depth + idle), none);
    EXPECT_EQ(found(ball, idle), colors);
    EXPECT_EQ(found("glClear(GL_DEPTH_BUFFER_BIT);" + ball, depth + idle), colors);
    EXPECT_EQ(found(ball, depth + idle), colors);
    // Without motion the second picture is the first, unless the background has a colour.
    EXPECT_EQ(found(ball, ""), none);
    EXPECT_EQ(found(ball, "glClearColor(1, 1, 1, 1);"), colors);
    EXPECT_EQ(found("glClear(GL_COLOR_BUFFER_BIT);" + ball, depth), depths);
    EXPECT_EQ(found("glClear(GL_COLOR_BUFFER_BIT);" + ball, ""), none);  // no depth test
    // A background that covers everything replaces glClear.
    EXPECT_EQ(found("glDisable(GL_LIGHTING); glLoadIdentity(); glColor3f(0, 0, 1); glRectf(-1, -1, 1, 1); "
                    "glEnable(GL_LIGHTING);" +
                        ball,
                    idle),
              none);
    // A function that draws each picture by itself has no second one that the reader can follow.
    EXPECT_EQ(names(warnings_of("glEnable(GL_DEPTH_TEST); glutSolidSphere(0.4, 20, 20);")), none);
}

TEST(Lint, FindsScaledExponentsOfObjFiles) {
    const std::set<std::string> none, scaled{"shininess-scaled"};
    const auto found = [&](const std::string& material) {
        return names(warnings_of(kClears + kLit +
                                 "GLfloat Ns = 96; glMaterialfv(GL_FRONT, GL_SPECULAR, (GLfloat[]){1, 1, 1, 1});\n" +
                                 material + "\nglutSolidSphere(0.5, 20, 20);"));
    };
    for (const char* value : {"Ns * 0.128", "0.128f * Ns", ".128 * Ns", "Ns / 1000 * 128", "(Ns / 1000.0f) * 128.0f",
                              "Ns * 128 / 1000", "128.0 * Ns / 1000.0", "128 * (Ns / 1000)"})
        EXPECT_EQ(found("glMaterialf(GL_FRONT, GL_SHININESS, " + std::string(value) + ");"), scaled) << value;
    EXPECT_EQ(found("GLfloat shininess = Ns * 0.128; glMaterialf(GL_FRONT, GL_SHININESS, shininess);"), scaled);
    // A table of materials in parts of 128, a number that only looks alike, a scale of something else.
    for (const char* value : {"0.25 * 128", "Ns", "Ns * 0.1285", "10.128 * 2", "Ns / 10000 * 128"})
        EXPECT_FALSE(
            found("glMaterialf(GL_FRONT, GL_SHININESS, " + std::string(value) + ");").contains("shininess-scaled"))
            << value;
    EXPECT_EQ(found("glTranslatef(0.128 * 2, 0, 0); glMaterialf(GL_FRONT, GL_SHININESS, Ns);"), none);
    EXPECT_EQ(found("glMaterialf(GL_FRONT, GL_SHININESS, Ns);  // not Ns * 0.128"), none);
    const std::vector<lint::Warning> warnings =
        warnings_of(kClears + kLit +
                    "glMaterialfv(GL_FRONT, GL_SPECULAR, (GLfloat[]){1, 1, 1, 1});\n"
                    "glMaterialf(GL_FRONT, GL_SHININESS, 0.128 * 1000);\nglutSolidSphere(0.5, 20, 20);");
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_EQ(warnings[0].edits[0].insert, "glMaterialf(GL_FRONT, GL_SHININESS, 128);");  // not 1000
}

TEST(Lint, FindsMaterialsWithoutLighting) {
    const std::string red = "glMaterialfv(GL_FRONT, GL_DIFFUSE, (GLfloat[]){1, 0, 0, 1}); ",
                      ball = "glutSolidSphere(0.5, 20, 20); ";
    const std::set<std::string> off{"lighting-off"};
    EXPECT_EQ(names(warnings_of(kClears + red + ball)), off);
    EXPECT_EQ(names(warnings_of(kClears + ball + red)), off);
    EXPECT_EQ(names(warnings_of(kClears + kLit + ball + "glDisable(GL_LIGHTING); " + red)),
              std::set<std::string>{"set-after-drawing"});
}

TEST(Lint, PrintsLikeACompiler) {
    const std::vector<lint::Warning> warnings = warnings_of(kBlack);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_EQ(warnings[0].place.str(), "scene.gl:11:1");
    const std::string text = lint::full_text(warnings[0], kBlack);
    EXPECT_EQ(text.rfind("scene.gl:11:1: warning: GL_LIGHT1 is on but black: only GL_LIGHT0 starts with a colour "
                         "[light-black]\nglEnable(GL_LIGHT1);\n^\n  why: Table 2.10",
                         0),
              0u)
        << text;
    EXPECT_NE(text.find("  fix: glLightfv(GL_LIGHT1, GL_DIFFUSE, (GLfloat[]){1, 1, 1, 1});\n"), std::string::npos);
}

// ---- The command ----

TEST(LintCommand, ExitStatusAndJson) {
    const TemporaryFolder folder;
    const std::string wrong = folder / "wrong.gl", right = folder / "right.gl";
    write_file_atomically(wrong, kBlack);
    write_file_atomically(right, lint::corrected_scene(*lint::find_rule("light-black")));
    const ProgramResult none = run_program("twinlight", {"lint", right});
    EXPECT_EQ(none.status, 0);
    EXPECT_EQ(none.out + none.err, "");
    const ProgramResult one = run_program("twinlight", {"lint", wrong});
    EXPECT_EQ(one.status, 1);
    EXPECT_NE(one.out.find(":11:1: warning: "), std::string::npos);
    const ProgramResult json = run_program("twinlight", {"lint", wrong, "--json"});
    EXPECT_EQ(json.status, 1);
    const auto parsed = nlohmann::json::parse(json.out);
    EXPECT_EQ(parsed["scene"], "wrong.gl");
    ASSERT_EQ(parsed["warnings"].size(), 1u);
    EXPECT_EQ(parsed["warnings"][0]["name"], "light-black");
    EXPECT_EQ(parsed["warnings"][0]["line"], 11);
    EXPECT_EQ(parsed["warnings"][0]["column"], 1);
    for (const char* key : {"message", "why", "fix"}) EXPECT_NE(parsed["warnings"][0][key], "") << key;
    EXPECT_EQ(run_program("twinlight", {"lint", folder / "missing.gl"}).status, 2);
    EXPECT_EQ(run_program("twinlight", {"lint"}).status, 2);
}

TEST(LintCommand, WritesTheMendedScene) {
    const TemporaryFolder folder;
    const std::string wrong = folder / "wrong.gl", right = folder / "right.gl";
    write_file_atomically(wrong, kBlack);
    EXPECT_EQ(run_program("twinlight", {"lint", wrong, "--fix", "light-black", "-o", right}).status, 0);
    EXPECT_EQ(run_program("twinlight", {"lint", right}).status, 0);
    const ProgramResult other = run_program("twinlight", {"lint", wrong, "--fix", "color-255", "-o", right});
    EXPECT_EQ(other.status, 2);
    EXPECT_NE(other.err.find("this scene has no warning 'color-255'"), std::string::npos) << other.err;
    const ProgramResult misspelt = run_program("twinlight", {"lint", wrong, "--fix", "light-blak", "-o", right});
    EXPECT_EQ(misspelt.status, 2);
    EXPECT_NE(misspelt.err.find("did you mean 'light-black'?"), std::string::npos) << misspelt.err;
    EXPECT_EQ(run_program("twinlight", {"lint", wrong, "--fix", "light-black"}).status, 2);
}

TEST(LintCommand, RenderAndComparePrintTheSameWarnings) {
    const TemporaryFolder folder;
    const std::string wrong = folder / "wrong.gl", report = folder / "report";
    write_file_atomically(wrong, kBlack);
    const ProgramResult render = run_program(
        "twinlight", {"render", wrong, "--with", "reference", "--size", "40x30", "-o", folder / "picture.png"});
    EXPECT_EQ(render.status, 0);
    EXPECT_NE(render.err.find("[light-black]\n"), std::string::npos) << render.err;
    EXPECT_NE(render.err.find("'twinlight lint "), std::string::npos) << render.err;
    const ProgramResult compare = run_program("twinlight", {"compare", wrong, "--size", "40x30", "-o", report});
    EXPECT_EQ(compare.err, render.err);
    EXPECT_NE(read_file(report + "/index.html").find("Possible mistakes in the scene"), std::string::npos);
    const auto json = nlohmann::json::parse(read_file(report + "/comparison.json"));
    ASSERT_EQ(json["warnings"].size(), 1u);
}

}  // namespace
}  // namespace twinlight::lint_test
