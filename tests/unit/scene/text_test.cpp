// Reading scenes: the meaning of C statements, and error messages.
#include "scene/command/text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <span>

#include "scene/command/memory.h"

namespace twinlight::text_test {

namespace {

std::vector<Command> read(std::string_view text) { return read_scene(text, "scene.gl", "scene").commands; }

std::string error_of(std::string_view text) {
    try {
        read(text);
    } catch (const SceneError& error) {
        return error.what();
    }
    return "no error";
}

// The arguments of the only command.
std::vector<double> arguments_of(std::string_view text) {
    const std::vector<Command> commands = read(text);
    EXPECT_EQ(commands.size(), 1u) << text;
    return commands.empty() ? std::vector<double>{} : commands.front().arguments;
}

using Values = std::vector<double>;

TEST(Reading, EvaluatesExpressionsWithCsTypes) {
    EXPECT_EQ(arguments_of("glScaled(4/3, 4.0/3, 7-2*3);"), (Values{1, 4.0 / 3, 1}));
    EXPECT_EQ(arguments_of("glScaled(-7/2, -(1+2)*3, +5);"), (Values{-3, -9, 5}));
    EXPECT_EQ(arguments_of("glScaled(0.1f, 0.1, 1/3.0f);"),
              (Values{static_cast<double>(0.1f), 0.1, static_cast<double>(1 / 3.0f)}));
    EXPECT_EQ(arguments_of("glScaled(0x10, 010, 10L);"), (Values{16, 8, 10}));
    EXPECT_EQ(arguments_of("glScaled(.5, 5., 1e-3);"), (Values{0.5, 5, 0.001}));
    EXPECT_EQ(arguments_of("glRotated(180/M_PI, 1, 0, 0);"), (Values{180 / 3.14159265358979323846, 1, 0, 0}));
}

TEST(Reading, RoundsToTheTypeOfTheParameter) {
    EXPECT_EQ(arguments_of("glScalef(0.1, 0.09, 1e-40);"),
              (Values{static_cast<double>(0.1f), static_cast<double>(0.09f), static_cast<double>(1e-40f)}));
}

TEST(Reading, JoinsBits) {
    EXPECT_EQ(arguments_of("glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);"), (Values{0x4100}));
}

TEST(Reading, CountsLights) { EXPECT_EQ(arguments_of("glEnable(GL_LIGHT0 + 3);"), (Values{0x4003})); }

TEST(Reading, TakesDeclaredScalarsAndArrays) {
    const char* text =
        "const GLfloat half = 0.5, key[] = {1, 2*half, 3, 1};\n"
        "static int n = 64;\n"
        "glLightfv(GL_LIGHT0, GL_POSITION, key);\n"
        "glutSolidSphere(key[1], n, n/2);\n";
    const std::vector<Command> commands = read(text);
    ASSERT_EQ(commands.size(), 2u);
    EXPECT_EQ(commands[0].arguments, (Values{0x4000, 0x1203, 1, 1, 3, 1}));
    EXPECT_EQ(commands[1].arguments, (Values{1, 64, 32}));
}

TEST(Reading, FillsAShortArrayWithZerosAsCDoes) {
    EXPECT_EQ(arguments_of("GLfloat v[4] = {1}; glColor4fv(v);"), (Values{1, 0, 0, 0}));
}

TEST(Reading, TakesPartsOfArrays) {
    EXPECT_EQ(arguments_of("GLdouble v[] = {1,2,3,4,5,6}; glVertex3dv(v + 3);"), (Values{4, 5, 6}));
    EXPECT_EQ(arguments_of("GLdouble v[] = {1,2,3,4,5,6}; glVertex3dv(&v[1]);"), (Values{2, 3, 4}));
}

TEST(Reading, TakesCompoundLiterals) {
    EXPECT_EQ(arguments_of("glMaterialfv(GL_FRONT, GL_DIFFUSE, (GLfloat[]){1, 0.5, 0.25, 1});"),
              (Values{0x0404, 0x1201, 1, 0.5, 0.25, 1}));
    EXPECT_EQ(arguments_of("glNormal3bv((const GLbyte[3]){0, 0, 127});"), (Values{0, 0, 127}));
}

TEST(Reading, TakesRowsOfArraysOfArrays) {
    const std::string rows = "GLfloat v[][3] = {{1, 2, 3}, {4, 5}, 6, 7, 8}; ";
    EXPECT_EQ(arguments_of(rows + "glVertex3fv(v[0]);"), (Values{1, 2, 3}));
    EXPECT_EQ(arguments_of(rows + "glVertex3fv(v[1]);"), (Values{4, 5, 0}));  // C fills the rest of a row with 0
    EXPECT_EQ(arguments_of(rows + "glVertex3fv(v[2]);"), (Values{6, 7, 8}));  // rows need no braces
    EXPECT_EQ(arguments_of(rows + "glVertex3fv(&v[1][0]);"), (Values{4, 5, 0}));
    EXPECT_EQ(arguments_of(rows + "glVertex3fv(v[0] + 3);"), (Values{4, 5, 0}));
    EXPECT_EQ(arguments_of(rows + "glVertex3f(v[2][1], sizeof(v), sizeof v[0]);"), (Values{7, 36, 12}));
    EXPECT_EQ(arguments_of(rows + "glVertex3fv((GLfloat*)(v + 2));"), (Values{6, 7, 8}));
    EXPECT_EQ(arguments_of("GLfloat m[4][4] = {{1}, {0, 1}, {0, 0, 1}, {0, 0, 0, 1}}; glLoadMatrixf(m[0]);"),
              (Values{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}));
}

TEST(Reading, TakesArraysOfAFixedLengthAnywhere) {
    EXPECT_EQ(arguments_of("GLfloat a[] = {1, 2}, b[] = {3, 4, 5}; glRectfv(a, b + 1);"), (Values{1, 2, 4, 5}));
}

TEST(Reading, KnowsTheSizesOfTypes) {
    EXPECT_EQ(
        arguments_of("glVertex4i(sizeof(float), sizeof(GLdouble[3]), sizeof(const void*), sizeof(unsigned char));"),
        (Values{4, 24, 8, 1}));
    EXPECT_EQ(arguments_of("GLushort v[6]; glVertex2i(sizeof v / sizeof(v[0]), sizeof(GLsizeiptr));"), (Values{6, 8}));
}

TEST(Reading, CastsNumbersAsCDoes) {
    EXPECT_EQ(arguments_of("glScaled((int)2.75, (GLfloat)0.1, (float)1 / 2);"),
              (Values{2, static_cast<double>(0.1f), 0.5}));
}

// ---- Pointers ----

// The command, and the memory that its pointer points to as values of `kind`.
struct Pointed {
    Command command;
    Values values;
};

Pointed pointed(const std::string& declarations, const std::string& pointer, Kind kind) {
    const Command command =
        read(declarations + " glTexImage1D(GL_TEXTURE_1D, 0, 3, 4, 0, GL_RGB, GL_UNSIGNED_BYTE, " + pointer + ");")
            .back();
    Values values;
    if (command.memory) {
        const std::span<const std::byte> bytes = command.memory->bytes;
        for (auto at = static_cast<std::size_t>(command.arguments.back()); at < bytes.size(); at += size_of(kind)) {
            values.push_back(load(bytes.subspan(at), kind));
        }
    }
    return {command, values};
}

TEST(Pointers, LeadIntoDeclaredArrays) {
    const std::string v = "static const GLushort v[] = {1, 2, 3, 4};";
    for (const char* pointer : {"v + 1", "&v[1]", "1 + v", "(const char*)v + 2", "(GLvoid *)(v + 1)", "v + 3 - 2"}) {
        const Pointed found = pointed(v, pointer, Kind::kUshort);
        EXPECT_EQ(found.command.arguments.back(), 2) << pointer;
        EXPECT_EQ(found.values, (Values{2, 3, 4})) << pointer;
        EXPECT_EQ(found.command.memory->kind, Kind::kUshort);
    }
    EXPECT_EQ(pointed("GLfloat f = 0.5;", "&f", Kind::kFloat).values, (Values{0.5}));
    EXPECT_EQ(pointed("", "(GLubyte[3]){7, 8}", Kind::kUbyte).values, (Values{7, 8, 0}));
    EXPECT_EQ(pointed("GLubyte image[2][2][3] = {{{1, 2, 3}, {4}}, {{5}}};", "image[1]", Kind::kUbyte).values,
              (Values{5, 0, 0, 0, 0, 0}));
    EXPECT_EQ(pointed("static GLbyte zeros[2];", "zeros", Kind::kByte).values, (Values{0, 0}));
}

TEST(Pointers, ShareTheArrayTheyLeadInto) {
    const std::vector<Command> commands = read(
        "GLubyte v[12] = {1}; glTexImage1D(GL_TEXTURE_1D, 0, 3, 4, 0, GL_RGB, GL_UNSIGNED_BYTE, v);"
        "glTexSubImage1D(GL_TEXTURE_1D, 0, 0, 1, GL_RGB, GL_UNSIGNED_BYTE, v + 3);");
    EXPECT_EQ(commands[0].memory, commands[1].memory);
}

TEST(Pointers, AreOffsetsWithoutAnArray) {
    for (const auto& [pointer, offset] : {std::pair{"NULL", 0.0},
                                          {"0", 0.0},
                                          {"(void*)12", 12.0},
                                          {"(GLvoid *)(4 * sizeof(float))", 16.0},
                                          {"(char*)NULL + 12", 12.0},
                                          {"(GLubyte *) NULL + (3 * 8)", 24.0},
                                          {"(GLfloat*)0 + 3", 12.0}}) {
        const Pointed found = pointed("", pointer, Kind::kUbyte);
        EXPECT_EQ(found.command.memory, nullptr) << pointer;
        EXPECT_EQ(found.command.arguments.back(), offset) << pointer;
    }
}

// ---- The names of objects ----

TEST(ObjectNames, AreTheLowestThatWereNeverGiven) {
    const std::vector<Command> commands = read(
        "GLuint t, more[2]; glBindTexture(GL_TEXTURE_2D, 2); glGenTextures(1, &t); glGenTextures(2, more);"
        "glDeleteTextures(1, &t); glGenTextures(1, (GLuint[]){0}); glGenTextures(1, (GLuint[]){9});"
        "glBindTexture(GL_TEXTURE_2D, more[1]);");
    EXPECT_EQ(commands[1].arguments, (Values{1, 1}));
    EXPECT_EQ(commands[2].arguments, (Values{2, 3, 4}));
    EXPECT_EQ(commands[3].arguments, (Values{1, 1}));
    EXPECT_EQ(commands[4].arguments, (Values{1, 5}));
    EXPECT_EQ(commands[5].arguments, (Values{1, 9}));  // a literal gives the names
    EXPECT_EQ(commands[6].arguments, (Values{kGL_TEXTURE_2D, 4}));
}

TEST(Reading, RemembersWhereArraysStoodWhenACommandTookThem) {
    const std::vector<Command> commands = read(
        "GLuint names[] = {7, 8}; glTexImage1D(GL_TEXTURE_1D, 0, 3, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, names);"
        "glGenTextures(2, names);");
    EXPECT_EQ(load(commands[0].memory->bytes, Kind::kUint), 7);
}

TEST(Reading, ReadsOnlyAsManyValuesAsThePnameHas) {
    EXPECT_EQ(arguments_of("glMaterialfv(GL_FRONT, GL_SHININESS, (GLfloat[]){32, 7, 7, 7});"),
              (Values{0x0404, 0x1601, 32}));
}

TEST(Reading, PassesOverCommentsIncludesAndOthersPragmas) {
    const char* text =
        "#include <GL/gl.h>\n"
        "#pragma once\n"
        "/* a comment\n over lines */ glEnable(GL_LIGHTING); // and another\n"
        ";;\n";
    EXPECT_EQ(read(text).size(), 1u);
}

TEST(Reading, UnderstandsTwinlightsPragmas) {
    const std::vector<Command> commands = read(
        "#pragma twinlight specular(reflection)\n"
        "  #pragma twinlight spot_cone(GL_LIGHT7, 12.5, 17.5) // smooth\n"
        "#pragma twinlight shape(cylinder, 1, 2, 36)");
    ASSERT_EQ(commands.size(), 3u);
    EXPECT_EQ(commands[0].word(0), Word::reflection);
    EXPECT_EQ(commands[1].arguments, (Values{0x4007, 12.5, 17.5}));
    EXPECT_EQ(commands[2].word(0), Word::cylinder);
    EXPECT_EQ(commands[2].array().size(), 3u);
}

TEST(Reading, RemembersWhereACommandStands) {
    const std::vector<Command> commands = read("\n/* \xE5\x85\x89 */ glEnd();");
    ASSERT_EQ(commands.size(), 1u);
    EXPECT_EQ(commands[0].place.str(), "scene.gl:2:9");  // columns count characters, not bytes
}

// ---- Mistakes: one line with the place, the error, and the nearest known name ----

struct Mistake {
    const char* text;
    const char* message;
};

class Mistakes : public testing::TestWithParam<Mistake> {};

TEST_P(Mistakes, AreReportedOnOneLine) {
    const std::string error = error_of(GetParam().text);
    EXPECT_EQ(error.find('\n'), std::string::npos) << error;
    EXPECT_NE(error.find(GetParam().message), std::string::npos) << error;
}

INSTANTIATE_TEST_SUITE_P(
    Reading, Mistakes,
    testing::Values(
        Mistake{"glEnabel(GL_LIGHTING);", "scene.gl:1:1: unknown command 'glEnabel'; did you mean glEnable?"},
        Mistake{"glEnable(GL_LIGTH0);", "scene.gl:1:10: unknown name 'GL_LIGTH0'; did you mean GL_LIGHT0?"},
        Mistake{"glEnable(GL_LIGHT8);",
                "scene.gl:1:10: unknown name 'GL_LIGHT8'; GL has GL_LIGHT0 to GL_LIGHT7, others need #pragma"},
        Mistake{"glEnable();", "scene.gl:1:10: glEnable takes 1 argument: glEnable(cap); only 0 are given"},
        Mistake{"glScalef(1, 2);", "scene.gl:1:14: glScalef takes 3 arguments: glScalef(x, y, z); only 2 are given"},
        Mistake{"glScalef(1, 2, 3, 4);", "more are given"},
        Mistake{"glEnable(0.5);", "must be a GL name such as GL_LIGHT0, not the number 0.5"},
        Mistake{"glVertex2i(0.5, 1);", "must be a whole number, not 0.5"},
        Mistake{"glNormal3b(0, 0, 128);", "is 128; it must be from -128 to 127"},
        Mistake{"glColor3f(1e39, 0, 0);", "does not fit into a GLfloat"},
        Mistake{"glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){1, 2, 3});",
                "scene.gl:1:35: glLightfv with GL_POSITION reads 4 values, but this array has 3"},
        Mistake{"GLdouble key[] = {1,2,3,4}; glLightfv(GL_LIGHT0, GL_POSITION, key);",
                "glLightfv takes an array of GLfloat, but 'key' is an array of GLdouble"},
        Mistake{"GLfloat key[] = {1}; glColor3fv(kye);", "did you mean key?"},
        Mistake{"GLfloat got[4]; glGetLightfv(GL_LIGHT0, GL_POSITION, got); glColor4fv(got);",
                "glGetLightfv at scene.gl:1:17 writes to it"},
        Mistake{"GLfloat v[4]; glColor4fv(v);", "has no value here: it was declared without a value"},
        Mistake{"GLfloat v[2] = {1,2,3};", "has 3 values, but its length is 2"},
        Mistake{"GLfloat v[2][2] = {{1, 2, 3}};", "scene.gl:1:27: this row has more than 2 values"},
        Mistake{"GLfloat v[2][2] = {1, {2}};", "this row starts before the previous one is complete"},
        Mistake{"GLfloat v[2] = {{1}};", "these braces are one level too deep"},
        Mistake{"GLfloat v[2][2] = {1, 2, 3, 4, 5};", "'v' has 5 values, but its length is 4"},
        Mistake{"GLfloat v[3][2] = {1}; glVertex2fv(v[3]);", "this index is outside 'v', which has 3 rows"},
        Mistake{"GLfloat v[3][2] = {1}; glVertex2f(v[0], 1);", "a single number is needed here"},
        Mistake{"GLfloat v[3] = {1}; glVertex2fv(v + 4);", "this pointer is outside 'v', which has 3 values"},
        Mistake{"GLfloat v[3] = {1}; glVertex2fv(v + 2);", "glVertex2fv reads 2 values, but 'v' has 1"},
        Mistake{"GLfloat v[3] = {1}; glVertex2fv(v * 2);", "'*' cannot combine an array with this value"},
        Mistake{"glVertex2fv(NULL);", "expected an array such as (GLfloat[]){1, 0, 0, 1}"},
        Mistake{"GLuint t = glEnable(GL_LIGHTING);", "glEnable returns no value"},
        Mistake{"GLuint t[1]; glGenTextures(2, t);", "glGenTextures writes 2 values, but 't' has 1"},
        Mistake{"glBindTexture(GL_TEXTURE_2D, sizeof(nothing));", "unknown name 'nothing'"},
        Mistake{"GLdouble v[16777216], w[16777216], x[16777216]; ",
                "all arrays and pictures of a scene together can have at most 256 MiB"},
        Mistake{"GLubyte v[4]; glTexImage1D(GL_TEXTURE_1D, 0, 3, 1, 0, GL_RGB, GL_UNSIGNED_BYTE, v);",
                "'v' has no value here"},
        Mistake{"glTexImage1D(GL_TEXTURE_1D, 0, 3, 1, 0, GL_RGB, GL_UNSIGNED_BYTE, 12);",
                "the argument pixels of glTexImage1D must be an array, NULL, or an offset"},
        Mistake{"#pragma twinlight returns(3)\nglEnable(GL_LIGHTING);",
                "scene.gl:1:19: returns(...) must come before a call that returns a value; the next call is glEnable"},
        Mistake{"GLfloat v = 1; GLfloat v = 2;", "'v' is already declared at scene.gl:1:9"},
        Mistake{"GLfloat v[] = {1}; glColor3f(v[1], 0, 0);",
                "this index is outside 'v', which has 1 value; indices start at 0"},
        Mistake{"glScaled(1/0, 1, 1);", "this divides a whole number by 0"},
        Mistake{"glScaled(9223372036854775807 + 1, 1, 1);", "too large"},
        Mistake{"glScaled(99999999999999999999, 1, 1);", "too large for a whole number; write it with a decimal point"},
        Mistake{"glScaled(1.2.3, 1, 1);", "'1.2.3' is not a number"},
        Mistake{"glEnable(GL_LIGHTING)", "expected ';' after glEnable(...), found the end of the scene"},
        Mistake{"glEnable(GL_LIGHTING;", "expected ')'"}, Mistake{"for (;;) glEnd();", "a scene cannot use 'for'"},
        Mistake{"int main(int argc, char** argv) {",
                "scene.gl:1:5: a scene cannot define the function 'main'; write its calls directly"},
        Mistake{"void display(void) {", "this function is never closed"},
        Mistake{"GLfloat v[] = {1}; v[0] = 2;", "a scene cannot assign to"},
        Mistake{"/* open", "scene.gl:1:1: this comment is never closed"},
        Mistake{"#define N 3", "a scene cannot use #define"},
        Mistake{"\x01\x02", "scene.gl:1:1: unexpected '\\x01'; a scene consists of C statements"},
        Mistake{"#pragma twinlight speculr(reflection)", "unknown pragma 'speculr'; did you mean specular?"},
        Mistake{"#pragma twinlight specular(reflecton)", "did you mean reflection?"}));

TEST(Reading, RefusesNestingThatIsTooDeep) {
    const std::string deep = "glScaled(" + std::string(100'000, '(') + "1" + std::string(100'000, ')') + ",1,1);";
    EXPECT_NE(error_of(deep).find("nested"), std::string::npos);
    EXPECT_EQ(arguments_of("glScaled(" + std::string(100'000, '-') + "1.0, 1, 1);")[0], 1);
}

TEST(Reading, RefusesASceneThatIsTooLong) {
    EXPECT_NE(error_of(std::string(kMaxSceneBytes + 1, ' ')).find("the limit is"), std::string::npos);
}

// ---- Printing ----

TEST(Printing, WritesWhatACompilerTakes) {
    const auto printed = [](std::string_view text) { return print_command(read(text).front()); };
    EXPECT_EQ(printed("glLightfv(GL_LIGHT0,GL_POSITION,(GLfloat[]){2,3,4.5,1});"),
              "glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){2, 3, 4.5, 1});");
    EXPECT_EQ(printed("glBegin(0);"), "glBegin(GL_POINTS);");
    EXPECT_EQ(printed("glClear(0x4100);"), "glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);");
    EXPECT_EQ(printed("glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);"),
              "glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);");
    EXPECT_EQ(printed("GLfloat got[9]; glGetLightfv(GL_LIGHT0, GL_POSITION, got);"),
              "glGetLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[4]){0});");
    EXPECT_EQ(printed("GLuint t[2]; glGenTextures(2, t);"), "glGenTextures(2, (GLuint[]){1, 2});");
    EXPECT_EQ(printed("glTexImage1D(GL_TEXTURE_1D, 0, 3, 1, 0, GL_RGB, GL_FLOAT, (GLfloat[]){0.5, -0.0, 1, 2} + 1);"),
              "glTexImage1D(GL_TEXTURE_1D, 0, 3, 1, 0, GL_RGB, GL_FLOAT, (const GLfloat[]){0.5, -0.0, 1, 2} + 1);");
    EXPECT_EQ(printed("glTexImage1D(GL_TEXTURE_1D, 0, 3, 1, 0, GL_RGB, GL_BYTE, (char*)NULL + 3);"),
              "glTexImage1D(GL_TEXTURE_1D, 0, 3, 1, 0, GL_RGB, GL_BYTE, (const void*)3);");
    EXPECT_EQ(printed("glDepthMask(GL_FALSE);"), "glDepthMask(GL_FALSE);");
    EXPECT_EQ(printed("#pragma twinlight shape(sphere, 1, 64, 32)"), "#pragma twinlight shape(sphere, 1, 64, 32)");
}

TEST(Printing, WritesACProgramThatReadsBackAsTheScene) {
    const CommandList scene =
        read_scene("#pragma twinlight specular(reflection)\nglutSolidSphere(1, 8, 4); glEnable(GL_LIGHTING);",
                   "scene.gl", "scene");
    EXPECT_EQ(read(print_c_program(scene)), scene.commands);
}

// In a window with two buffers, what the scene draws to the front one would be hidden by the empty other one.
TEST(Printing, OpensAWindowWithOneBufferForASceneThatDrawsToTheFront) {
    const auto program = [](const std::string& text) { return print_c_program(read_scene(text, "scene.gl", "scene")); };
    const std::string front = program("glDrawBuffer(GL_FRONT); glutSolidSphere(1, 8, 4);");
    EXPECT_NE(front.find("GLUT_RGBA | GLUT_SINGLE | GLUT_DEPTH"), front.npos) << front;
    EXPECT_NE(front.find("    glFlush();\n}"), front.npos) << front;
    EXPECT_EQ(front.find("glutSwapBuffers"), front.npos) << front;
    for (const char* draws_to : {"", "glDrawBuffer(GL_BACK);", "glDrawBuffer(GL_FRONT); glDrawBuffer(GL_BACK);"}) {
        const std::string text = program(std::string(draws_to) + "glutSolidSphere(1, 8, 4);");
        EXPECT_NE(text.find("GLUT_RGBA | GLUT_DOUBLE | GLUT_DEPTH"), text.npos) << text;
        EXPECT_NE(text.find("    glutSwapBuffers();\n}"), text.npos) << text;
    }
}

TEST(Printing, OpensAWindowOfTheProgramsSize) {
    CommandList scene = read_scene("glutSolidSphere(1, 8, 4);", "scene.gl", "scene");
    EXPECT_NE(print_c_program(scene).find("glutInitWindowSize(640, 480);"), std::string::npos);
    scene.window = {300, 200};
    EXPECT_NE(print_c_program(scene).find("glutInitWindowSize(300, 200);"), std::string::npos);
}

TEST(Printing, KeepsTheSizeOfThePicture) {
    CommandList scene = read_scene("glutSolidSphere(1, 8, 4);", "scene.gl", "scene");
    EXPECT_EQ(print_scene(scene), "glutSolidSphere(1, 8, 4);\n");
    scene.window = {300, 200};
    EXPECT_EQ(print_scene(scene), "glutInitWindowSize(300, 200);\nglutSolidSphere(1, 8, 4);\n");
    for (const std::string& text : {print_scene(scene), print_c_program(scene)}) {
        const CommandList again = read_scene(text, "scene.gl", "scene");
        EXPECT_EQ(again.window, scene.window) << text;
        EXPECT_EQ(again.commands, scene.commands) << text;
    }
}

TEST(Reading, RefusesAWindowThatCannotBe) {
    EXPECT_EQ(error_of("glutInitWindowSize(300);"),
              "scene.gl:1:1: glutInitWindowSize takes 2 arguments: width and height");
    for (const char* sides : {"0, 200", "300, -1", "300, 8193", "0.0 / 0.0, 200"})
        EXPECT_EQ(error_of(std::string("glutInitWindowSize(") + sides + ");"),
                  "scene.gl:1:1: a window must be from 1 x 1 to 8192 x 8192 pixels")
            << sides;
}

TEST(Printing, DeclaresEachArrayOnce) {
    const CommandList scene = read_scene(
        "GLubyte v[] = {1, 2, 3, 4}; glTexSubImage1D(GL_TEXTURE_1D, 0, 0, 1, GL_RGB, GL_UNSIGNED_BYTE, v);"
        "glTexSubImage1D(GL_TEXTURE_1D, 0, 0, 1, GL_RGB, GL_UNSIGNED_BYTE, v + 1);",
        "scene.gl", "scene");
    const std::string text = print_scene(scene);
    EXPECT_EQ(text,
              "static const GLubyte memory1[] = {\n    1, 2, 3, 4};\n"
              "glTexSubImage1D(GL_TEXTURE_1D, 0, 0, 1, GL_RGB, GL_UNSIGNED_BYTE, memory1);\n"
              "glTexSubImage1D(GL_TEXTURE_1D, 0, 0, 1, GL_RGB, GL_UNSIGNED_BYTE, memory1 + 1);\n");
    EXPECT_EQ(read(text), scene.commands);
}

TEST(Reading, TakesASceneInAFunction) {
    const std::string body = "glBegin(GL_LINES); glVertex2fv(at); glEnd();";
    const std::vector<Command> expected = read("GLfloat at[] = {1, 2};" + body);
    EXPECT_EQ(expected.size(), 3u);
    for (const char* head : {"void display(void)", "static void display(void)", "void display()"}) {
        EXPECT_EQ(read(std::string(head) + " { GLfloat at[] = {1, 2};" + body + " }\n"), expected) << head;
        EXPECT_EQ(read("GLfloat at[] = {1, 2};\n" + std::string(head) + "\n{\n" + body + "\n}"), expected) << head;
    }
}

TEST(Reading, RefusesMoreThanOneFunctionWithPlaceAndRemedy) {
    const auto has = [](const std::string& text, const std::string& part) {
        EXPECT_NE(error_of(text).find(part), std::string::npos) << error_of(text);
    };
    has("void display(void) { glEnd(); }\nvoid keys(void) { }",
        "2:1: only the function 'display' is read; move the calls of other functions into it");
    has("void display(void) { void inner(void) { } }", "1:22: a function cannot be inside another function");
    has("void sphere(GLfloat radius) { }",
        "expected ')' after sphere(, because the function of a scene has no parameters");
    has("int main(void) { glEnd(); }", "a scene cannot define the function");
    has("void display(void) { glEnd();", "1:1: this function is never closed");
    has("static void draw_scene(void) { glEnd();", "never closed");
    has("void display(void) { glVertex3f(1, 2); }", "1:37: glVertex3f takes 3 arguments");
}

TEST(Printing, KeepsEveryBitOfANumber) {
    for (double value : {0.1, -0.0, 1e-300, 1e300, 4.9e-324, 1.0 / 3, 123456789012345680.0}) {
        const Command command{CommandId::glScaled, {value, 1, 1}, {}};
        const Command back = read(print_command(command)).front();
        EXPECT_EQ(std::signbit(back.number(0)), std::signbit(value));
        EXPECT_EQ(back.number(0), value);
    }
    for (float value : {0.1f, 0.09f, 1e-45f, std::numeric_limits<float>::max(), 16777216.0f, 1 / 3.0f}) {
        const Command command{CommandId::glScalef, {static_cast<double>(value), 1, 1}, {}};
        EXPECT_EQ(read(print_command(command)).front().number(0), static_cast<double>(value));
    }
}

}  // namespace

}  // namespace twinlight::text_test
