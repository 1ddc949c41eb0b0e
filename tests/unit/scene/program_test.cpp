// Whole GLUT programs as scenes: what their statements mean, the order of their functions, limits and messages.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "../run_program.h"
#include "base/image/file.h"
#include "homework.h"
#include "scene/command/text.h"

namespace twinlight::program_test {

namespace {

using Values = std::vector<double>;

// A program whose display function has these statements. `before` comes before it.
std::string program(const std::string& statements, const std::string& before = "") {
    return before + "\nvoid display(void) {\n" + statements +
           "\n}\nint main(int argc, char **argv) {\n"
           "glutInit(&argc, argv); glutCreateWindow(\"a window\"); glutCreateMenu(menu); glutAddMenuEntry(\"a\", 1); "
           "glutDisplayFunc(display); glutMainLoop(); return 0; "
           "}\n";
}

using homework::error_of;
using homework::read_program;

Values values_of(const std::string& statements, const std::string& before = "") {
    return homework::arguments_of(read_program(program(statements, before)));
}

TEST(Programs, RunInGlutsOrder) {
    const CommandList scene = read_program(
        "#include <GL/glut.h>\n"
        "int calls = 0;\n"
        "void display(void) { glLineWidth(10 + ++calls); glutSwapBuffers(); }\n"
        "void reshape(int w, int h) { glViewport(0, 0, w, h); glLineWidth(20 + ++calls); }\n"
        "void keys(unsigned char key, int x, int y) { if (key == 'q') exit(0); glLineWidth(99); }\n"
        "void idle(void) { glLineWidth(98); }\n"
        "void init(void) { glLineWidth(30 + ++calls); }\n"
        "int main(int argc, char** argv) {\n"
        "  glutInit(&argc, argv); glutInitDisplayMode(GLUT_DOUBLE | GLUT_DEPTH); glutInitWindowSize(300, 200);\n"
        "  glutCreateWindow(argv[0]); init();\n"
        "  glutDisplayFunc(display); glutReshapeFunc(&reshape); glutKeyboardFunc(keys); glutIdleFunc(idle);\n"
        "  glutMainLoop();\n"
        "  glLineWidth(97);\n"
        "}\n");
    std::string printed;
    for (const Command& command : scene.commands) printed += print_command(command);
    EXPECT_EQ(printed, "glLineWidth(31);glViewport(0, 0, 300, 200);glLineWidth(22);glLineWidth(13);");
    EXPECT_EQ(scene.window, (WindowSize{300, 200}));
    EXPECT_EQ(scene.commands[1].place.str(), "homework.c:4:30");
}

TEST(Programs, TakeTheirSizeFromTheCommandLineIfItIsGiven) {
    const std::string text =
        "void display(void) {} void reshape(int w, int h) { glViewport(0, 0, w, h); }\n"
        "int main() { glutInitWindowSize(300, 200); glutDisplayFunc(display); glutReshapeFunc(reshape); "
        "glutMainLoop(); }";
    const CommandList scene = read_program(text, {.window = WindowSize{80, 60}});
    EXPECT_EQ(print_command(scene.commands.at(0)), "glViewport(0, 0, 80, 60);");
    EXPECT_EQ(scene.window, (WindowSize{80, 60}));

    const TemporaryFolder folder;
    write_file_atomically(
        folder / "red.c",
        program("glClearColor(1, 0, 0, 1); glClear(GL_COLOR_BUFFER_BIT); glRecti(0,0,1,1);", "#include <GL/glut.h>"));
    const auto render = [&](const std::vector<std::string>& more) {
        std::vector<std::string> arguments = {"render", folder / "red.c",  "--with", "reference",
                                              "-o",     folder / "red.png"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const ProgramResult result = run_program("twinlight", arguments);
        EXPECT_EQ(result.status, 0) << result.err;
        const std::string png = read_file(folder / "red.png");
        const auto number = [&](std::size_t at) {
            return static_cast<unsigned char>(png[at + 2]) * 256 + static_cast<unsigned char>(png[at + 3]);
        };
        return WindowSize{number(16), number(20)};  // in the header of a PNG
    };
    EXPECT_EQ(render({}), (WindowSize{300, 300}));  // GLUT's own size
    EXPECT_EQ(render({"--size", "64x48"}), (WindowSize{64, 48}));
}

TEST(Programs, SayThatTheirWindowHasSeveralSamples) {
    const auto with_mode = [](const std::string& mode) {
        return "#include <GL/glut.h>\nvoid display(void) { glRectf(0, 0, 1, 1); }\n"
               "int main(int argc, char** argv) { glutInit(&argc, argv); glutInitDisplayMode(" +
               mode + "); glutCreateWindow(\"a\"); glutDisplayFunc(display); glutMainLoop(); }";
    };
    EXPECT_EQ(read_program(with_mode("GLUT_RGB | GLUT_MULTISAMPLE")).notes(), std::vector{std::string(kOneSampleNote)});
    EXPECT_EQ(read_program(with_mode("GLUT_RGB | GLUT_DEPTH")).notes(), std::vector<std::string>{});

    const TemporaryFolder folder;
    write_file_atomically(folder / "smooth.c", with_mode("GLUT_MULTISAMPLE"));
    const ProgramResult result =
        run_program("twinlight", {"compare", folder / "smooth.c", "--size", "8x8", "-o", folder / "report"});
    const std::string note = "smooth.c: " + std::string(kOneSampleNote);
    EXPECT_NE(result.err.find("twinlight: note: " + note + "\n"), std::string::npos) << result.err;
    EXPECT_NE(read_file(folder / "report/index.html").find(kOneSampleNote), std::string::npos);
}

TEST(Programs, ShowTheirFirstWindow) {
    const CommandList scene = read_program(
        "void big(void) { glLineWidth(glutGetWindow()); glutSetWindow(2); glLineWidth(9); glutSetWindow(1); "
        "glLineWidth(3); "
        "glutSetWindow(7); glLineWidth(4); }\n"
        "void small(void) { glLineWidth(8); }\n"
        "void shape(int w, int h) { glViewport(0, 0, w, h); }\n"
        "int main() { glutInitWindowSize(200, 100); int one = glutCreateWindow(\"one\"); glutDisplayFunc(big);\n"
        "glutReshapeFunc(shape); glLineWidth(2); glutInitWindowSize(50, 50); int two = glutCreateWindow(\"two\");\n"
        "glutDisplayFunc(small); glutReshapeFunc(NULL); glLineWidth(7); glutCreateSubWindow(one, 0, 0, 9, 9);\n"
        "glutDisplayFunc(small); glLineWidth(6); glutSetWindow(one); glLineWidth(two + 3); glutMainLoop(); }\n");
    std::string printed;
    for (const Command& command : scene.commands) printed += print_command(command);
    EXPECT_EQ(printed,
              "glLineWidth(2);glLineWidth(5);glViewport(0, 0, 200, 100);glLineWidth(1);glLineWidth(3);glLineWidth(4);");
    EXPECT_EQ(scene.window, (WindowSize{200, 100}));
    EXPECT_EQ(scene.notes(), std::vector<std::string>{"this program has 3 windows; the picture is that of the first"});
}

TEST(Programs, GiveTheirUserDataToTheDisplayFunction) {
    EXPECT_EQ(homework::arguments_of(read_program(
                  "struct S { int width; };\n"
                  "void draw(void *data) { struct S *s = (struct S *)data; glLineWidth(s->width); }\n"
                  "void tick(int value, void *data) { ((struct S *)data)->width = value; }\n"
                  "int main() { struct S s = {5}; glutCreateWindow(\"w\"); glutDisplayFuncUcall(draw, &s);\n"
                  "glutTimerFuncUcall(10, tick, 7, &s); glutMainLoop(); }\n")),
              (Values{5}));
    EXPECT_NE(error_of("void draw(void *data) { glLineWidth(*(int *)data); }\n"
                       "void init() { int gone = 1; glutDisplayFuncUcall(draw, &gone); }\n"
                       "int main() { glutCreateWindow(\"w\"); init(); glutMainLoop(); }\n")
                  .find("what this pointer pointed at is not there any more"),
              std::string::npos);
}

// main() never ends while GLUT's loop runs.
TEST(Programs, KeepTheVariablesOfMain) {
    EXPECT_EQ(homework::arguments_of(read_program(
                  "int *width;\nvoid draw(void) { int main_has_another = 1; glLineWidth(*width); *width = 9; }\n"
                  "void loop() { glutMainLoop(); }\n"
                  "int main() { int local = 4; width = &local; glutCreateWindow(\"w\");\n"
                  "glutDisplayFunc(draw); loop(); local = 8; }\n")),
              (Values{4}));
}

TEST(Programs, MayRunGlutsLoopThemselves) {
    EXPECT_EQ(homework::arguments_of(read_program(
                  "int goes_on = 1; void draw(void) { glLineWidth(2); glutMainLoopEvent(); glLineWidth(3); }\n"
                  "int main() { glutCreateWindow(\"w\"); glutDisplayFunc(draw);\n"
                  "while (goes_on) { glutMainLoopEvent(); glLineWidth(9); } }\n")),
              (Values{2, 3}));
}

TEST(Programs, HaveNoInput) {
    EXPECT_EQ(values_of("char line[9]; glScaled(fgets(line, 9, stdin) == NULL, getchar(), 0);"), (Values{1, -1, 0}));
    EXPECT_EQ(
        values_of(
            "glScaled(glutGet(GLUT_WINDOW_DEPTH_SIZE), glutGet(GLUT_HAS_JOYSTICK), glutDeviceGet(GLUT_NUM_DIALS));"),
        (Values{24, -1, 0}));
}

TEST(Programs, HaveLoopsAndConditions) {
    EXPECT_EQ(values_of("int i; for (i = 0; i < 3; i++) glLineWidth(i + 1);"), (Values{1, 2, 3}));
    EXPECT_EQ(values_of("for (int i = 3, j = 0; i; --i, j += 2) glScaled(i, j, 0);"),
              (Values{3, 0, 0, 2, 2, 0, 1, 4, 0}));
    EXPECT_EQ(values_of("int i = 5; while (i > 3) { glLineWidth(i); i--; }"), (Values{5, 4}));
    EXPECT_EQ(values_of("int i = 5; do glLineWidth(i++); while (i < 7);"), (Values{5, 6}));
    EXPECT_EQ(values_of("for (;;) { glLineWidth(1); break; } do { glLineWidth(2); continue; } while (0);"),
              (Values{1, 2}));
    EXPECT_EQ(values_of("for (int i = 0; i < 6; i++) { if (i % 2) continue; if (i > 3) break; glLineWidth(i + 1); }"),
              (Values{1, 3}));
    EXPECT_EQ(values_of("for (int i = 0; i < 4; i++) if (i == 1) glLineWidth(1); else if (i == 2) glLineWidth(2); else "
                        "glLineWidth(9);"),
              (Values{9, 1, 2, 9}));
    EXPECT_EQ(values_of("int a = 1; if (a) if (!a) glLineWidth(1); else glLineWidth(2);"), (Values{2}));
    EXPECT_EQ(values_of("int i = 0; while (i++ < 9) if (i == 3) { glLineWidth(i); return; }"), (Values{3}));
}

TEST(Programs, Switch) {
    const std::string cases =
        "for (int i = 0; i < 5; i++) switch (i) { case 0: glLineWidth(10); case ONE: glLineWidth(11); break;"
        "case 'a' - 95: { glLineWidth(12); break; } case 3: continue; default: glLineWidth(13); }";
    EXPECT_EQ(values_of(cases, "enum { ZERO, ONE };"), (Values{10, 11, 11, 12, 13}));
    EXPECT_EQ(values_of("switch (7) { default: glLineWidth(1); break; case 8: glLineWidth(2); }"), (Values{1}));
    EXPECT_EQ(values_of("switch (7) { case 8: glLineWidth(2); } glLineWidth(3);"), (Values{3}));
}

TEST(Programs, HaveCsOperators) {
    EXPECT_EQ(values_of("glScaled(7 % 3, -7 % 3, 7 / 2 % 2);"), (Values{1, -1, 1}));
    EXPECT_EQ(values_of("glScaled(1 << 4, 255 >> 2, 6 & 3);"), (Values{16, 63, 2}));
    EXPECT_EQ(values_of("glScaled(6 ^ 3, ~5, 1 | 6 & 4);"), (Values{5, -6, 5}));
    EXPECT_EQ(values_of("glScaled(1 < 2, 2 <= 1, 1 + 1 == 2);"), (Values{1, 0, 1}));
    EXPECT_EQ(values_of("glScaled(!0, !2.5, !!3);"), (Values{1, 0, 1}));
    EXPECT_EQ(values_of("glScaled(0 || 2, 1 && 0, 1 || 1 && 0);"), (Values{1, 0, 1}));
    EXPECT_EQ(values_of("int n = 0; glScaled(n && 1 / n, !n || 1 / n, n);"), (Values{0, 1, 0}));
    EXPECT_EQ(
        values_of("int a = 7; a += 3; a -= 1; a *= 2; a /= 4; a %= 3; a <<= 3; a |= 1; a ^= 3; glLineWidth(a + 1);"),
        (Values{11}));
    EXPECT_EQ(values_of("int a = 1, b = a++ + 5, c = ++a - 1; glScaled(a, b, c);"), (Values{3, 6, 2}));
    EXPECT_EQ(values_of("int a, b; a = b = 4; glScaled(a, b, (a = 2) + a);"), (Values{4, 4, 4}));
    EXPECT_EQ(values_of("glScaled('a', '\\n', '\\0');"), (Values{97, 10, 0}));
}

// The common type of both choices decides, as in C, and the other choice is not evaluated.
TEST(Programs, ChooseWithQuestionMarks) {
    EXPECT_EQ(values_of("glScaled((1 ? 1 : 0.5) / 2, (1 ? 1 : 2) / 2, (0 ? 0.5f : 1) / 2);"), (Values{0.5, 0, 0.5}));
    EXPECT_EQ(values_of("int n = 0, i = 1; glScaled(n ? 1 / n : 3, n ? i++ : 4, i);"), (Values{3, 4, 1}));
    EXPECT_EQ(values_of("int i = 2; glLineWidth(i < 0 ? 5 : i > 1 ? 6 : 7);"), (Values{6}));
    EXPECT_EQ(values_of("float v[2] = {1, 2}; int i = 2; glLineWidth(i < 2 ? v[i] : f());",
                        "float f(void) { glLineWidth(9); return 1; }"),
              (Values{9, 1}));
}

TEST(Programs, ConvertAsCDoes) {
    EXPECT_EQ(values_of("int i = 2.9; unsigned char c = 300; float f = 0.1; glScaled(i, c, f);"),
              (Values{2, 44, static_cast<double>(0.1F)}));
    EXPECT_EQ(values_of("unsigned int u = -1; short s = 40000; glScaled(u, s, (int)-2.7);"),
              (Values{4294967295.0, -25536, -2}));
    EXPECT_EQ(values_of("unsigned int seed = 3000000000u; seed = seed * 1103515245u + 12345u; glScaled(seed, 0, 0);"),
              (Values{1398552121.0, 0, 0}));
    EXPECT_EQ(values_of("glutSolidSphere(1, 16.0, 12.9);"), (Values{1, 16, 12}));
    EXPECT_EQ(values_of("GLfloat shininess = {100.0}; int i = {3,}; glScaled(shininess, i, 0);"), (Values{100, 3, 0}));
}

TEST(Programs, CallFunctions) {
    EXPECT_EQ(values_of("glScaled(f(3), half(3), g(2, 0.5));",
                        "int f(int n) { return n < 2 ? 1 : n * f(n - 1); } int half(int x) { return x / 2.0; }"
                        "static double g(int a, double b); double g(int a, double b) { return a * b; }"),
              (Values{6, 1, 1}));
    EXPECT_EQ(values_of("count(); count(); glLineWidth(count());", "int count(void) { static int n = 0; return ++n; }"),
              (Values{3}));
    EXPECT_EQ(values_of("int x = 1; { int x = 2; glLineWidth(x); } glLineWidth(x);"), (Values{2, 1}));
    EXPECT_EQ(
        values_of(
            "set(v, 2); glNormal3fv(v); set(rows[1], 5); glVertex3fv(rows[1]);",
            "float v[3], rows[2][3]; void set(float *a, float x) { int i; for (i = 0; i < 3; ++i) a[i] = x * i; }"),
        (Values{0, 2, 4, 0, 5, 10}));
    EXPECT_EQ(values_of("float x; out(&x); glLineWidth(x);", "void out(float *to) { *to = 7; }"), (Values{7}));
    EXPECT_EQ(values_of("q(GL_LIGHT0, (GLfloat[]){1, 2, 3, 4});",
                        "void q(GLenum l, const GLfloat c[4]) { int i = 0; i++; glLightfv(l, GL_DIFFUSE, c); }"),
              (Values{0x4000, 0x1201, 1, 2, 3, 4}));
}

TEST(Programs, HavePointersIntoArrays) {
    EXPECT_EQ(values_of("const float *p = v; glLineWidth(*p++); glLineWidth(*p); p = v + 2; glLineWidth(*p--); "
                        "glLineWidth(p[0]); glLineWidth(*(p + 2)); p += 2; --p; glLineWidth(*p);",
                        "float v[4] = {1, 2, 3, 4};"),
              (Values{1, 2, 3, 2, 4, 3}));
    EXPECT_EQ(values_of("turn(1); glTexGenfv(GL_S, GL_OBJECT_PLANE, plane); turn(0); glNormal3fv(plane);",
                        "GLfloat a[] = {1, 0, 0, 0}, b[] = {0, 1, 0, 0}; static GLfloat *plane;"
                        "void turn(int to_a) { if (to_a) plane = a; else plane = b; }"),
              (Values{0x2000, 0x2501, 1, 0, 0, 0, 0, 1, 0}));
    EXPECT_EQ(values_of("float v[3]; put(v); glNormal3fv(v);",
                        "void put(float *to) { int i; for (i = 0; i < 3; i++) *to++ = i + 5; }"),
              (Values{5, 6, 7}));
    EXPECT_EQ(values_of("int m[2][3] = {{1, 2, 3}, {4, 5, 6}}; int *p = m[0], n = 0; while (n < 6) n += *p++ > 0; "
                        "glScaled(n, sizeof(p), sizeof(m));"),
              (Values{6, 8, 24}));
    EXPECT_EQ(values_of("float m[2][3] = {{1, 2, 3}, {4, 5, 6}}; glNormal3fv(*m); glNormal3fv(*(m + 1)); line(m);",
                        "void line(float row[][3]) { glVertex3fv(*row++); glVertex3fv(*row); }"),
              (Values{1, 2, 3, 4, 5, 6, 1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(values_of("int v[2] = {7, 8}, i, *p = v; for (i = 0; i < 3; i++) glLineWidth(i < 2 ? *p++ : 9); "
                        "glLineWidth(p - 0 ? 1 : *p); p = 0; glLineWidth(p ? *p : 2);"),
              (Values{7, 8, 9, 1, 2}));
    EXPECT_EQ(values_of("int n = 3; float m[2][3] = {{1, 2, 3}, {4, 5, 6}}; up(&n); glScaled(n, (*m)[2], 0); last(m);",
                        "void up(int *n) { (*n)++; (*n) *= 2; (*n) += 1; } void last(float rows[][3]) { rows++; "
                        "glLineWidth((*rows)[2]); }"),
              (Values{9, 3, 0, 6}));
    EXPECT_EQ(values_of("float m[2][3] = {{1, 2, 3}, {4, 5, 6}}, *p = m[0]; (p + 1)[1] = 7; glNormal3fv((m + 1)[0]); "
                        "glScaled((*(m + 1))[2], (p + 1)[1], (1 ? p + 4 : p)[0]);"),
              (Values{4, 5, 6, 6, 7, 5}));
    EXPECT_EQ(values_of("int *p = 0; if (!p && p == NULL) glLineWidth(1); put(NULL);",
                        "void put(float *to) { if (to) *to = 1; else glLineWidth(2); }"),
              (Values{1, 2}));
    EXPECT_EQ(values_of("next(); glLineWidth(next());",
                        "int v[2] = {3, 4}; int next(void) { static int *p = v; return *p++; }"),
              (Values{4}));
    const auto has = [](const std::string& statements, const std::string& part) {
        EXPECT_NE(error_of(program(statements)).find(part), std::string::npos) << error_of(program(statements));
    };
    has("float *p; glLineWidth(*p);", "3:23: this pointer is NULL");
    has("float *p; glLineWidth(p[0]);", "3:23: the pointer 'p' is NULL");
    has("float v[2]; float *p = v + 2; glLineWidth(*p);", "3:43: this pointer is outside 'v', which has 2 values");
    has("float v[2]; float *p = v + 2; (*p)++;", "3:32: this pointer is outside 'v'");
    has("float *p; (*p) = 1;", "3:12: this pointer is NULL");
    has("float v[2]; float *p = v; p--;", "this pointer is outside 'v'");
    // An array ends with its block, so no pointer may be used after it.
    const std::string ended = "what this pointer pointed at is not there any more";
    has("float *p; { float v[2]; p = v; } *p = 1;", "3:34: " + ended);
    has("float *p; p = (GLfloat[]){1, 2}; *p = 1;", ended);
    has("float *p; for (float v[2], f = 0; f < 1; f++) p = v; *p = 1;", ended);
    has("float *p; switch (1) { case 1: ; float v[2]; p = v; } p[0] = 1;", ended);
    has("for (;;) float v[2];", "3:10: a declaration here needs { and } around it");
    EXPECT_EQ(values_of("float *p, v[1] = {3}; p = v; { float *q = p; glLineWidth(*q); }"), (Values{3}));
}

// In the parameters of macros, names have parentheses around them.
TEST(Programs, StepWhatIsBehindAPointer) {
    EXPECT_EQ(values_of("int v[] = {3, 7}; int *p = v; ++*p; --*(p + 1); ++(*p); glLineWidth(v[0]); glLineWidth(v[1]);"
                        "glLineWidth(++*p);"),
              (Values{5, 6, 6}));
    EXPECT_EQ(values_of("GLfloat v[] = {0.5}; GLfloat *p = v; glLineWidth(1 ? ++*p : 2);"), (Values{1.5}));
}

TEST(Programs, HaveArraysOfPointers) {
    const std::string tables =
        "GLfloat red[] = {1, 0, 0, 1}, blue[] = {0, 0, 1, 1};\nGLfloat *colors[] = {red, blue, NULL};\n";
    EXPECT_EQ(values_of("for (int i = 0; colors[i] != NULL; i++) glColor3fv(colors[i]);", tables),
              (Values{1, 0, 0, 0, 0, 1}));
    EXPECT_EQ(values_of("glLineWidth(sizeof(colors) / sizeof(colors[0]) + colors[1][2]);", tables), (Values{4}));
    EXPECT_EQ(values_of("colors[0] = blue; colors[0][1] = 5; glColor3fv(blue);", tables), (Values{0, 5, 1}));
}

TEST(Programs, HaveArraysOfPointersInFunctions) {
    EXPECT_EQ(values_of("GLfloat a[] = {1, 2}; GLfloat *rows[2]; rows[0] = a; rows[1] = rows[0] + 1; "
                        "glLineWidth(*rows[1]); glLineWidth(rows[1][0] + *rows[0]);"),
              (Values{2, 3}));
    EXPECT_NE(error_of(program("GLfloat *rows[2]; { GLfloat a[] = {1, 2}; rows[0] = a; } glLineWidth(rows[0][0]);"))
                  .find("not there any more"),
              std::string::npos);
    EXPECT_NE(error_of(program("GLfloat a[] = {1}; GLfloat *rows[] = {a}; glLineWidth(rows[1][0]);"))
                  .find("this index is outside 'rows', which has 1 value"),
              std::string::npos);
    EXPECT_NE(error_of(program("static GLfloat *rows[2]; glLineWidth(rows[0][0]);")).find("is NULL here"),
              std::string::npos);
    EXPECT_NE(error_of(program("GLfloat a[] = {1}; GLfloat *rows[1] = {a, a};"))
                  .find("'rows' has 2 values, but its length is 1"),
              std::string::npos);
}

TEST(Programs, KnowTheirViewport) {
    const std::string ask = "GLint v[4]; glGetIntegerv(GL_VIEWPORT, v); glLineWidth(v[2] + v[3] + v[0]);";
    const auto width = [&](const std::string& statements) { return values_of(statements + ask).back(); };
    EXPECT_EQ(width(""), 600);  // GLUT's window is 300 x 300
    EXPECT_EQ(width("glViewport(10, 20, 30, 40);"), 80);
    EXPECT_EQ(values_of("GLdouble v[4]; glGetDoublev(GL_VIEWPORT, v); glLineWidth(v[3] / 2);").back(), 150);
    EXPECT_NE(error_of(program("glPushAttrib(GL_VIEWPORT_BIT); glViewport(1, 2, 3, 4); glPopAttrib();" + ask))
                  .find("the value of 'v'"),
              std::string::npos);
    EXPECT_NE(
        error_of(program("GLint v[4]; glGetIntegerv(GL_SCISSOR_BOX, v); glLineWidth(v[2]);")).find("the value of 'v'"),
        std::string::npos);
}

TEST(Programs, KnowTheExtensionsThatEveryDriverHas) {
    EXPECT_EQ(values_of("if (!glutExtensionSupported(\"GL_ARB_multitexture\")) exit(1); glLineWidth(2);"), (Values{2}));
    EXPECT_NE(error_of(program("if (glutExtensionSupported(\"GL_ARB_fragment_program\")) glLineWidth(2);"))
                  .find("glutExtensionSupported(\"GL_ARB_fragment_program\")"),
              std::string::npos);
}

// The arguments of the commands of the next picture; nothing if the reader cannot follow it.
Values values_of_next(const std::string& text) {
    Values values;
    const CommandList scene = read_program(text);
    if (!scene.later) return values;
    for (const Command& command : scene.later->front().commands)
        values.insert(values.end(), command.arguments.begin(), command.arguments.end());
    return values;
}

TEST(Programs, DrawTheirNextPictureAfterIdleOrTimer) {
    const auto text = [](const std::string& registers) {
        return "double angle = 1;\nvoid display(void) { glLineWidth(angle); }\n"
               "void turn(void) { angle = angle + 1; glPointSize(5); }\nvoid tick(int by) { angle += by; }\n"
               "void clock(void) { angle = glutGet(GLUT_ELAPSED_TIME); }\n"
               "int main(int argc, char **argv) { glutCreateWindow(\"w\"); glutDisplayFunc(display); " +
               registers + " glutMainLoop(); return 0; }";
    };
    EXPECT_EQ(values_of_next(text("")), (Values{1}));
    EXPECT_EQ(values_of_next(text("glutIdleFunc(turn);")), (Values{5, 2}));
    EXPECT_EQ(values_of_next(text("glutIdleFunc(turn); glutIdleFunc(NULL);")), (Values{1}));
    EXPECT_EQ(values_of_next(text("glutTimerFunc(40, &tick, 7);")), (Values{8}));
    EXPECT_EQ(values_of_next(text("glutIdleFunc(clock);")), (Values{20}));  // milliseconds
    const CommandList scene = read_program(text("glutIdleFunc(turn);"));
    EXPECT_EQ(scene.later->front().start.str(), "homework.c:2:22");
    EXPECT_EQ(scene.commands.size(), 1u);
    // The second call of the display function cannot be followed.
    EXPECT_EQ(read_program(program("static int n = 0; glLineWidth(++n > 1 ? system(0) : 1);")).later, nullptr);
    EXPECT_EQ(read_scene("glLineWidth(2);", "scene.gl", "scene.gl").later, nullptr);
}

TEST(Programs, DrawLaterPicturesAfterASecondAndAfterAKey) {
    const auto later = [](const std::string& key, const std::string& registers) {
        const CommandList scene = read_program(
            "int ticks = 0, is_on = 0;\nvoid display(void) { glLineWidth(1 + ticks); if (is_on) glPointSize(2); }\n"
            "void turn(void) { ++ticks; }\nvoid key(unsigned char k, int x, int y) {\n" +
            key + "\n}\nint main(int argc, char **argv) { glutCreateWindow(\"w\"); glutDisplayFunc(display); " +
            registers + " glutMainLoop(); return 0; }");
        std::vector<std::string> pictures;
        for (const LaterPicture& picture : *scene.later) {
            std::string text = picture.when + ":";
            for (const Command& command : picture.commands) text += " " + print_command(command);
            pictures.push_back(text);
        }
        return pictures;
    };
    const std::string on = "if (k == 27 || k == 'q') exit(0); switch (k) { case 'a': break; case 'o': is_on = 1; }";
    using Pictures = std::vector<std::string>;
    const std::string second = "from the second picture on: glLineWidth(";
    EXPECT_EQ(later(on, ""), (Pictures{second + "1);"}));
    EXPECT_EQ(later(on, "glutIdleFunc(turn);"), (Pictures{second + "2);", "after 1 s: glLineWidth(51);"}));
    EXPECT_EQ(later(on, "glutKeyboardFunc(key);"),
              (Pictures{second + "1);", "after the key 'o': glLineWidth(1); glPointSize(2);"}));
    // Keys that cannot be read, and those that change nothing, are left out.
    EXPECT_EQ(later("if (k == 'o') is_on = system(0);", "glutKeyboardFunc(key);"), (Pictures{second + "1);"}));
    EXPECT_EQ(later("if (k == 'o') ticks = 0;", "glutKeyboardFunc(key);"), (Pictures{second + "1);"}));
}

TEST(Programs, KnowNamesInParentheses) {
    EXPECT_EQ(values_of("float a[2]; SET(a, 3, 4); (i) = 5; ((i))++; glScaled((a)[0], ((a))[1], (i));",
                        "#define SET(v, x, y) { (v)[0] = x; (v)[1] = y; }\nint i;"),
              (Values{3, 4, 6}));
}

TEST(Programs, HaveTypedefsAndEnumTypes) {
    EXPECT_EQ(
        values_of("point p = {7, 8, 9}; face(corners[1], p); glScaled(sizeof(point), sizeof(corners), (real)1);",
                  "typedef GLfloat point[3]; typedef double real, reals[2]; point corners[2] = {{1, 2, 3}, {4, 5, 6}};"
                  "void face(point a, point b) { glNormal3fv(a); glVertex3fv(b); }"),
        (Values{4, 5, 6, 7, 8, 9, 12, 24, 1}));
    EXPECT_EQ(values_of("glScaled(now, f(OFF), later);",
                        "typedef enum { OFF, ON = 4 } state; enum mode { LINE = 2, FILL } now = FILL; state later = ON;"
                        "int f(state s) { enum mode m = LINE; return m + s; }"),
              (Values{3, 2, 4}));
    EXPECT_NE(
        error_of(program("", "typedef float many[5000]; typedef many more[5000];")).find("an array can have at most"),
        std::string::npos);
}

TEST(Programs, ReadTheOldestFormOfFunctions) {
    const CommandList scene = read_program(
        "float twice(x, v) int x; float v[2]; { return x * v[1]; }\n"
        "display() { float v[2] = {0, 2.5}; glLineWidth(twice(3.9, v)); }\n"
        "main(argc, argv) int argc; char **argv; { if (argc > 1) exit(1); glutDisplayFunc(display); glutMainLoop(); "
        "}\n");
    ASSERT_EQ(scene.commands.size(), 1U);
    EXPECT_EQ(print_command(scene.commands[0]), "glLineWidth(7.5);");
}

TEST(Programs, PassTextsOn) {
    EXPECT_EQ(values_of("char line[20]; sprintf(line, \"%d\", 3); label(2, \"a text\"); label(3, line);",
                        "void label(int x, const char *text) { glLineWidth(x); printf(text); }"),
              (Values{2, 3}));
    const CommandList scene = read_program(
        "#include <stdio.h>\nvoid args(int n, char *words[]) { int i; for (i = 1; i < n; i++) if (words[i][0]) "
        "exit(1); }\n"
        "void display(void) { glLineWidth(2); } int main(int n, char *words[]) { args(n, words); "
        "glutDisplayFunc(display); "
        "glutMainLoop(); }");
    EXPECT_EQ(scene.commands.size(), 1U);
    // The text hides the number.
    EXPECT_NE(error_of(program("char *c = \"a\"; glLineWidth(c);", "int c = 3;")).find("a single number is needed"),
              std::string::npos);
    EXPECT_EQ(values_of("{ char *c = \"a\"; } glLineWidth(c);", "int c = 3;"), (Values{3}));
}

// A function of which only a key would need something that cannot be read.
TEST(Programs, RefuseAFunctionOnlyWhereItIsCalled) {
    const std::string functions = "PPMImage *data(void) { return 0; } void load(GLUnurbs *from) { }";
    EXPECT_EQ(values_of("glLineWidth(2);", functions), (Values{2}));
    EXPECT_NE(error_of(program("data();", functions)).find("1:1: reading a program cannot follow the type 'PPMImage'"),
              std::string::npos);
    EXPECT_NE(
        error_of(program("load(0);", functions)).find("1:46: reading a program cannot follow the type 'GLUnurbs'"),
        std::string::npos);
}

TEST(Programs, KnowGlutsNames) {
    EXPECT_EQ(values_of("int mode = GLUT_RGB; mode |= GLUT_DOUBLE | GLUT_DEPTH; glutInitDisplayMode(mode); "
                        "glScaled(mode, GLUT_RIGHT_BUTTON, GLUT_STENCIL);"),
              (Values{18, 2, 32}));
}

// extern names a variable that the file itself may define later.
TEST(Programs, PassOverExternAndUsingNamespace) {
    EXPECT_EQ(values_of("extern float x; using namespace std; glLineWidth(x);",
                        "using namespace std; extern float x, v[]; float x = 3;"),
              (Values{3}));
}

// A variable of a block or a function is unknown after it.
TEST(Programs, ForgetVariablesAfterTheirBlock) {
    EXPECT_EQ(values_of("f(); glLineWidth(A);", "enum { A = 3 }; void f(void) { int A = 1; glLineWidth(A); }"),
              (Values{1, 3}));
    for (const char* statements :
         {"{ int k = 1; } k = 2;", "{ int k[2] = {1}; } k[0] = 2;", "f(); k = 2;", "{ float v[2], *k = v; } k[0] = 2;"})
        EXPECT_NE(error_of(program(statements, "void f(void) { static int k = 1; }")).find("unknown name 'k'"),
                  std::string::npos)
            << statements;
    EXPECT_NE(error_of(program("f(); f(); k = 2;", "void f(void) { static int k = 1; }")).find("unknown name 'k'"),
              std::string::npos);
}

TEST(Programs, KnowCsMathematics) {
    EXPECT_EQ(values_of("glScaled(sin(0.5), cosf(0.5f), tan(1));"),
              (Values{std::sin(0.5), static_cast<double>(std::cos(0.5F)), std::tan(1.0)}));
    EXPECT_EQ(values_of("glScaled(sqrt(2), fabs(-1.5), pow(2, 0.5));"),
              (Values{std::sqrt(2.0), 1.5, std::pow(2, 0.5)}));
    EXPECT_EQ(values_of("glScaled(atan2(1, -1), fmod(7.5, 2), floor(-0.5));"), (Values{std::atan2(1, -1), 1.5, -1}));
    EXPECT_EQ(values_of("glScaled(abs(-3), ceil(0.2), M_PI);"), (Values{3, 1, 3.14159265358979323846}));
}

TEST(Programs, HaveAPreprocessor) {
    EXPECT_EQ(values_of("glScaled(N, TWICE(N + 1), AREA);",
                        "#define N 3\n#define TWICE(x) ((x) * 2)\n#define AREA (N * \\\n N)\n#define QUIET\n"),
              (Values{3, 8, 9}));
    EXPECT_EQ(
        values_of(
            "glScaled(A, B, C);",
            "#ifdef __APPLE__\n#include <GLUT/glut.h>\n#define A 1\n#else\n#include <GL/glut.h>\n#define A 2\n#endif\n"
            "#ifndef M_PI\n#define M_PI 3\n#define B 3\n#elif defined(A) && A == 2\n#define B 4\n#else\n#define B "
            "5\n#endif\n"
            "#if 0\n it's not C \n#if 1\n#endif\n#endif\n#define C 6\n#undef N\n"),
        (Values{2, 4, 6}));
    EXPECT_EQ(
        values_of("glScaled(A, B, C);",
                  "#define X 0x1F\n#if X >= 0x10 && X == 037 && 31UL == X\n#define A 1\n#else\n#define A 2\n#endif\n"
                  "#if 'a' > 96\n#define B 3\n#else\n#define B 4\n#endif\n"
                  "#ifdef GLU_VERSION_1_2\n#define C 5\n#else\n#define C 6\n#endif\n"
                  "#define UNUSED(x) puts(#x)\n"),
        (Values{1, 3, 5}));
    EXPECT_NE(error_of(program("", "#define X 1 + 1\n#if X == 2\n#endif\n")).find("1:13: a program's #if can use"),
              std::string::npos);
    EXPECT_NE(error_of(program("", "#if 1.5\n#endif\n")).find("1:5: '1.5' is not a whole number"), std::string::npos);
    EXPECT_NE(error_of(program("", "#if 1\n")).find("homework.c:1:1: this #if is never closed"), std::string::npos);
    EXPECT_NE(error_of(program("", "#endif\n")).find("homework.c:1:1: #endif without #if"), std::string::npos);
    EXPECT_NE(error_of(program("glLineWidth(F(1));", "#define F(a, b) a\n")).find("takes 2 arguments"),
              std::string::npos);
}

TEST(Programs, NameNewObjects) {
    EXPECT_EQ(
        values_of("GLuint list = glGenLists(2), t; glNewList(list + 1, GL_COMPILE); glEndList();"
                  "glGenTextures(1, &t); glBindTexture(GL_TEXTURE_2D, t); if (glGetError() != GL_NO_ERROR) exit(1);"),
        (Values{2, 1, 2, 0x1300, 1, 1, 0xDE1, 1, 0}));
    EXPECT_EQ(values_of("GLUquadricObj *q; q = gluNewQuadric(); if (!q) return; draw(q);",
                        "void draw(GLUquadricObj *it) { gluSphere(it, 1, 8, 8); }"),
              (Values{1, 1, 1, 8, 8}));
}

struct OutOfReach {
    const char* statement;
    const char* message;
};
class ProgramsOutOfReach : public testing::TestWithParam<OutOfReach> {};
TEST_P(ProgramsOutOfReach, NameTheConstructAndTheCommandThatRecords) {
    const std::string message = error_of(program(GetParam().statement));
    EXPECT_TRUE(message.starts_with("homework.c:3:")) << message;
    EXPECT_NE(message.find(GetParam().message), std::string::npos) << message;
    EXPECT_NE(message.find("twinlight record homework.c"), std::string::npos) << message;
}
INSTANTIATE_TEST_SUITE_P(
    All, ProgramsOutOfReach,
    testing::Values(
        OutOfReach{"struct point p;", "the variable 'p', whose type has no size"}, OutOfReach{"goto end;", "'goto'"},
        OutOfReach{"FILE *f = fopen(\"a.ppm\", \"rb\");", "the function fopen"},
        OutOfReach{"static PPMImage *image;", "the type 'PPMImage'"},
        OutOfReach{"glLineWidth(jitter);", "unknown name 'jitter'; if another file defines it"},
        OutOfReach{"init_map();", "the function 'init_map', which this file does not define"},
        OutOfReach{"gluPickMatrix(1, 1, 5, 5, 0);", "the function 'gluPickMatrix', which Twinlight does not know"},
        OutOfReach{"glutUseLayer(1);", "the function 'glutUseLayer', which Twinlight does not know"},
        OutOfReach{"glMultiDrawElements(GL_POINTS, 0, 0, 0, 2);",
                   "the function 'glMultiDrawElements', which Twinlight does not know"},
        OutOfReach{"GLUtesselator *t;", "the name 'GLUtesselator', which Twinlight does not know"},
        OutOfReach{"float g[1]; glGetFloatv(GL_LINE_WIDTH_GRANULARITY, g);",
                   "the name 'GL_LINE_WIDTH_GRANULARITY', which Twinlight does not know"},
        OutOfReach{"char s[9]; fgets(s, 9, file);", "the function fgets"},
        OutOfReach{"glutInitDisplayMode(GLUT_INDEX);", "a window with colour indices"},
        OutOfReach{"float m[16]; glGetFloatv(GL_MODELVIEW_MATRIX, m); glMultMatrixf(m);", "the value of 'm'"},
        OutOfReach{"float m[16]; glGetFloatv(GL_MODELVIEW_MATRIX, m); glLineWidth(m[0]);", "the value of 'm'"},
        OutOfReach{"int t = glutGet(GLUT_INIT_STATE);", "glutGet(GLUT_INIT_STATE)"},
        OutOfReach{"if (glIsEnabled(GL_FOG)) return;", "the result of glIsEnabled"},
        OutOfReach{"std::cout << 1;", "this is C++: std::"},
        OutOfReach{"load_model(1, 2);", "the function 'load_model'"}));

TEST(ProgramErrors, HaveTheirPlaceAndARemedy) {
    const auto has = [](const std::string& text, const std::string& part) {
        EXPECT_NE(error_of(text).find(part), std::string::npos) << error_of(text);
    };
    has(program("glVertex3f(1, 2);"), "homework.c:3:16: glVertex3f takes 3 arguments");
    has(program("glLigthfv(1);"), "homework.c:3:1: unknown function 'glLigthfv'; did you mean glLightfv?");
    has(program("speer(1);", "void sphere(int r) { }"), "did you mean sphere?");
    has(program("sphere();", "void sphere(int r) { }"),
        "3:1: the function 'sphere' takes 1 arguments, but 0 are given");
    has(program("int i = 1 / 0;"), "3:11: this divides a whole number by 0");
    has(program("float v[2]; int i = 2; v[i] = 1;"), "3:26: this index is outside 'v'");
    has(program("(1;"), "does not close the '(' at homework.c:3:1");
    has("int main() { glutMainLoop();", "1:12: this '{' is never closed");
    has(program("float v[2]; glLightfv(GL_LIGHT0, GL_POSITION, v);"), "reads 4 values, but 'v' has 2");
    has(program("", "void display(void) { }"), "the function 'display' is already defined at homework.c:1:6");
    has("void display(void) {} int main() { glutDisplayFunc(display); return 0; glutMainLoop(); }",
        "1:27: main ends before it calls glutMainLoop");
    has("int main() { glutMainLoop(); }", "this program has no display function");
    has("int main() { glutDisplayFunc(draw); glutMainLoop(); }", "1:30: unknown name 'draw'");
    has("int main() { exit(1); glutMainLoop(); }", "1:14: the program ends itself here");
}

TEST(ProgramLimits, EndWhatDoesNotEnd) {
    for (const char* statement : {"for (;;);", "while (1) ;", "do ; while (1);", "for (;;) glLineWidth(2);",
                                  "int i = 0; for (i = 0; i < 10; i--) ;"}) {
        const std::string message = error_of(program(statement), {.most_steps = 100'000});
        EXPECT_NE(message.find("homework.c:3:"), std::string::npos) << message;
        EXPECT_NE(message.find("is stopped here after 100000 steps"), std::string::npos) << message;
    }
    EXPECT_NE(error_of(program("again();", "void again(void) { again(); }")).find("nested too deeply"),
              std::string::npos);
    EXPECT_NE(
        error_of(program("again(1);", "int again(int n) { return 1 + (again(n + 1) * 2); }")).find("nested too deeply"),
        std::string::npos);
}

TEST(ProgramLimits, BoundMemoryAndDepth) {
    const auto has = [](const std::string& text, const std::string& part) {
        EXPECT_NE(error_of(text).find(part), std::string::npos) << error_of(text);
    };
    std::string macros = "#define A0\n";
    for (int i = 1; i < 60; ++i)
        macros += "#define A" + std::to_string(i) + " A" + std::to_string(i - 1) + " A" + std::to_string(i - 1) + "\n";
    has(program("A59", macros), "macros make this program too long");
    has(program("float v[100000000];"), "an array's length must be");
    has(program("for (;;) { float v[16000000]; f(v); }",
                "void f(float *v) { static float a[16000000]; float b[16000000], "
                "c[16000000], d[16000000]; }"),
        "together can have at most 256 MiB");
    has(program("int i;" + std::string(5000, '{') + std::string(5000, '}')), "nested too deeply");
    has(program("int i = " + std::string(5000, '!') + "1;"), "nested too deeply");
    has(program("int i = " + std::string(5000, '(') + "1" + std::string(5000, ')') + ";"),
        "nested more than 64 levels");
    std::string ifs;
    for (int i = 0; i < 5000; ++i) ifs += "if (0) ";
    has(program(ifs + ";"), "nested too deeply");
    std::string many;
    for (int i = 0; i < 1001; ++i) many += "int v" + std::to_string(i) + " = 0;";
    has(program(many), "at most 1000 variables");
    // Arrays of finished functions give their memory back.
    EXPECT_EQ(values_of("for (int i = 0; i < 100; i++) f(); glLineWidth(2);",
                        "void f(void) { double v[1000000]; v[0] = 1; }"),
              (Values{2}));
}

// A scene that only mentions the words of a program is still a scene.
TEST(Programs, AreTextsWithMainAndGlutsLoop) {
    EXPECT_EQ(read_program("// main(); glutMainLoop();\nglLineWidth(3);").commands.size(), 1U);
    EXPECT_FALSE(read_program("glLineWidth(3);").window);
    EXPECT_NE(error_of("int main(void) { for (;;) glEnd(); }").find("a scene cannot define the function 'main'"),
              std::string::npos);
}

}  // namespace

}  // namespace twinlight::program_test
