// What whole programs keep: structs, pointers, texts, allocated memory; and what they ask the system for.
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "../run_program.h"
#include "base/image/file.h"
#include "homework.h"
#include "scene/command/text.h"
#include "scene/state/state.h"

namespace twinlight::program_data_test {

namespace {

using Values = std::vector<double>;

std::string program(const std::string& statements, const std::string& before = "") {
    return before + "\nvoid display(void) {\n" + statements +
           "\n}\nint main(int argc, char **argv) { glutInit(&argc, argv); glutCreateWindow(argv[0]); "
           "glutDisplayFunc(display); glutMainLoop(); return 0; }\n";
}

using homework::error_of;
using homework::read_program;

Values values_of(const std::string& statements, const std::string& before = "") {
    return homework::arguments_of(read_program(program(statements, before)));
}

std::string printed(const std::string& statements, const std::string& before = "") {
    std::string text;
    for (const Command& command : read_program(program(statements, before)).commands) text += print_command(command);
    return text;
}

const std::string kBall =
    "typedef struct { float x, y, z; } point;\n"
    "struct ball { point at; GLfloat color[4]; int n; struct ball *next; };\n"
    "typedef struct ball ball;\n";

TEST(ProgramStructs, HaveMembersThatCanBeReadAndChanged) {
    EXPECT_EQ(
        values_of(
            "ball b; b.n = 2; b.at.y = 3; b.color[1] = 0.5; b.n += 1; b.at.y++; glScaled(b.n, b.at.y, b.color[1]);",
            kBall),
        (Values{3, 4, 0.5}));
    EXPECT_EQ(values_of("struct ball v[2][3], *p = &v[1][0]; v[1][2].n = 7; p += 2; p->at.x = 4; (*p).at.z = 5; "
                        "glScaled(p->n, v[1][2].at.x, (p - 1 + 1)->at.z);",
                        kBall),
              (Values{7, 4, 5}));
    EXPECT_EQ(values_of("union { int i; unsigned char c[4]; } u; u.i = 513; glScaled(u.c[0], u.c[1], sizeof u);"),
              (Values{1, 2, 4}));
    EXPECT_EQ(
        values_of(
            "struct { struct { int a, b; }; union { int c; int d; }; } s = {1, 2, {3}}; glScaled(s.a, s.b, s.d);"),
        (Values{1, 2, 3}));
    EXPECT_EQ(values_of("struct flags { unsigned int a : 3, b : 5; } f = {1, 2}; glScaled(f.a, f.b, 0);"),
              (Values{1, 2, 0}));
}

TEST(ProgramStructs, AreInitialisedAsInC) {
    EXPECT_EQ(
        values_of(
            "ball b = {{1, 2}, {3}, .n = 4}; glScaled(b.at.x, b.at.y, b.at.z); glScaled(b.color[0], b.color[1], b.n);",
            kBall),
        (Values{1, 2, 0, 3, 0, 4}));
    EXPECT_EQ(values_of("point v[] = {1, 2, 3, {4}, [3].z = 9}; glScaled(v[0].z, v[1].x, v[3].z); glLineWidth(sizeof v "
                        "/ sizeof *v);",
                        kBall),
              (Values{3, 4, 9, 4}));
    EXPECT_EQ(
        values_of(
            "point a = {1, 2, 3}, v[2] = {a, {.y = 5}}, w = {.z = 1, .x = 2}; glScaled(v[0].y, v[1].y, w.x + w.z);",
            kBall),
        (Values{2, 5, 3}));
    EXPECT_EQ(values_of("int v[5] = {[1] = 4, 5, [4] = 6}; glScaled(v[1], v[2], v[4]);"), (Values{4, 5, 6}));
    EXPECT_EQ(values_of("glLineWidth((point){1, 2, 3}.y); p(&(point){4, 5, 6});",
                        kBall + "void p(const point *a) { glLineWidth(a->z); }"),
              (Values{2, 6}));
}

TEST(ProgramStructs, AreCopiedWhereTheyArePassedReturnedAndAssigned) {
    const std::string add = kBall +
                            "point add(point a, point b) { a.x += b.x; a.y += b.y; return a; }\n"
                            "point where(const ball *b) { return b->at; }\n";
    EXPECT_EQ(values_of("point a = {1, 2}, b = {3, 4}, c = add(a, b); glScaled(c.x, c.y, a.x);", add),
              (Values{4, 6, 1}));
    EXPECT_EQ(values_of("ball b = {{1, 2}}; glScaled(where(&b).y, add(where(&b), where(&b)).x, 0);", add),
              (Values{2, 2, 0}));
    EXPECT_EQ(values_of("point a = {1}, b; b = a; b.x = 5; glScaled(a.x, b.x, 0);", kBall), (Values{1, 5, 0}));
    EXPECT_NE(error_of(program("point a; ball b = {{1}}; a = b;", kBall)).find("a struct can only be given another"),
              std::string::npos);
}

TEST(ProgramStructs, GoToCommandsAsArrays) {
    EXPECT_EQ(values_of("ball b = {{1, 2, 3}, {4, 5, 6, 7}}; glNormal3fv(&b.at.x); glColor4fv(b.color);", kBall),
              (Values{1, 2, 3, 4, 5, 6, 7}));
    EXPECT_EQ(values_of("point v[2] = {{1, 2, 3}, {4, 5, 6}}; glVertex3fv((GLfloat *)&v[1]);", kBall),
              (Values{4, 5, 6}));
}

TEST(ProgramStructs, HaveTheSizesThatCGivesThem) {
    EXPECT_EQ(values_of("glScaled(sizeof(struct mixed), sizeof(point), sizeof(struct ball));",
                        kBall + "struct mixed { char a; double b; short c; };"),
              (Values{24, 12, 40}));
}

TEST(ProgramStructs, NameTheMemberThatIsMissing) {
    const auto has = [](const std::string& statements, const std::string& part) {
        const std::string error = error_of(program(statements, "struct light { float power; };"));
        EXPECT_NE(error.find(part), std::string::npos) << error;
    };
    has("struct light a; a.powre = 1;", "3:19: this struct has no member 'powre'; did you mean power?");
    has("struct light a, *p = &a; p.power = 1;", "3:27: 'p' is not a struct but a pointer; write -> instead of '.'");
    has("struct light *p = 0; p->power = 1;", "3:22: this pointer is NULL");
    has("int i; i.x = 1;", "3:9: 'i' is not a struct, so it has no member 'x'");
}

TEST(ProgramPointers, PointAtPointersAndFunctions) {
    EXPECT_EQ(values_of("int a = 1, b = 2, *p = &a, **pp = &p; **pp = 5; *pp = &b; glScaled(a, *p, sizeof *pp);"),
              (Values{5, 2, 8}));
    EXPECT_EQ(
        values_of("int i; for (i = 0; i < 2; i++) shapes[i](i + 1); glLineWidth(pick(1) == two); (*pick(0))(9);",
                  "void two(int n) { glLineWidth(n * 2); } void one(int n) { glLineWidth(n); }\n"
                  "typedef void (*shape)(int); shape shapes[] = {one, &two}; shape pick(int i) { return shapes[i]; }"),
        (Values{1, 4, 1, 9}));
    EXPECT_EQ(values_of("each(draw, 3);",
                        "void draw(int n) { glLineWidth(n); } void each(void (*f)(int), int n) { if (f) f(n); }"),
              (Values{3}));
    EXPECT_EQ(values_of("*place(2) = 5; glLineWidth(values[2]); glLineWidth(next()[1]);",
                        "float values[3]; float *place(int i) { return &values[i]; }\n"
                        "const float *next(void) { static float v[2]; v[1] += 4; return v; }"),
              (Values{5, 4}));
    EXPECT_EQ(values_of("int v[4], *a = v, *b = v + 3; glScaled(b - a, b > a, a == v);"), (Values{3, 1, 1}));
}

TEST(ProgramTexts, AreReadCharacterByCharacter) {
    EXPECT_EQ(values_of("const char *s; for (s = \"ab\"; *s; s++) glLineWidth(*s);"), (Values{97, 98}));
    EXPECT_EQ(values_of("char t[] = \"a\\n\\x41\\102\"; glScaled(sizeof t, t[2], t[3]);"), (Values{5, 65, 66}));
    EXPECT_EQ(
        values_of(
            "char t[20]; strcpy(t, \"ab\"); strcat(t, \"c\" \"d\"); glScaled(strlen(t), strcmp(t, \"abcd\"), t[4]);"),
        (Values{4, 0, 0}));
    EXPECT_EQ(values_of("char t[40]; int n = sprintf(t, \"%d %5.2f|%-4s|%c%%\", 42, 1.5, \"x\", 'y'); glScaled(n, "
                        "t[5], t[n - 1]);"),
              (Values{16, 46, 37}));
    EXPECT_EQ(
        values_of("glScaled(atoi(\"12x\"), atof(\"0.5\"), names[1][0]);", "const char *names[] = {\"one\", \"two\"};"),
        (Values{12, 0.5, 116}));
    EXPECT_NE(error_of(program("char *s = \"a\"; s[0] = 'b';")).find("a text in quotes cannot be changed"),
              std::string::npos);
}

// As freeglut 3.4 does: how glBitmap reads rows is set and set back for each character.
TEST(ProgramCallbacks, OfDevicesAndWindowsComeAfterThePicture) {
    for (const char* name :
         {"glutPositionFunc", "glutMultiButtonFunc", "glutTabletMotionFunc", "glutSpaceballMotionFunc"})
        EXPECT_EQ(
            values_of(std::string(name) + "(moved); glLineWidth(2);", "void moved(int x, int y) { goto nowhere; }"),
            (Values{2}))
            << name;
}

TEST(ProgramTexts, AreMadeOfTheRestOfTheArguments) {
    const std::string functions =
        "char made[40];\n"
        "void inner(const char *form, ...) { va_list more; va_start(more, form); vsprintf(made, form, more); "
        "va_end(more); }\n"
        "int label(int n, const char *form, ...) {\n"
        "  char text[20];\n  va_list more;\n  va_start(more, form);\n  inner(\"%d\", 7);\n"
        "  n += vsnprintf(text, 4, form, more);\n  va_end(more);\n  glLineWidth(text[0] - '0');\n  return n;\n}\n";
    EXPECT_EQ(values_of("int n = label(10, \"%d-%s\", 3, \"abc\"); glScaled(n, made[0], 0);", functions),
              (Values{3, 15, '7', 0}));
    EXPECT_EQ(values_of("glScaled(label(10, \"5\"), 1, 1);", functions), (Values{5, 11, 1, 1}));
    EXPECT_NE(error_of(program("label(1);", functions)).find("takes at least 2 arguments, but 1 are given"),
              std::string::npos);
    EXPECT_NE(error_of(program("label(1, \"%d\");", functions)).find("the form '%d' has no value"), std::string::npos);
    const std::string passed =
        "char t[9]; void to(const char *f, va_list l) { vsprintf(t, f, l); }\n"
        "void from(const char *f, ...) { va_list l; va_start(l, f); to(f, l); }\n";
    EXPECT_NE(error_of(program("from(\"%d\", 3);", passed)), "");
}

TEST(ProgramTexts, AreDrawnInGlutsFonts) {
    const std::string one = printed("glutBitmapCharacter(GLUT_BITMAP_8_BY_13, '!');");
    EXPECT_TRUE(
        one.starts_with("glPushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);glPixelStorei(GL_UNPACK_SWAP_BYTES, 0);"))
        << one;
    EXPECT_NE(
        one.find("glBitmap(8, 14, 0, 3, 8, 0, (const GLubyte[]){0, 0, 0, 16, 0, 16, 16, 16, 16, 16, 16, 16, 0, 0});"
                 "glPopClientAttrib();"),
        std::string::npos)
        << one;
    EXPECT_EQ(printed("glutStrokeCharacter(GLUT_STROKE_ROMAN, '-');"),
              "glBegin(GL_LINE_STRIP);glVertex2f(7.38, 42.8571);glVertex2f(93.0943, "
              "42.8571);glEnd();glTranslatef(100.754, 0, 0);");
    EXPECT_EQ(
        values_of(
            "glScaled(glutBitmapWidth(GLUT_BITMAP_9_BY_15, 'x'), glutBitmapLength(GLUT_BITMAP_8_BY_13, \"four\"), "
            "glutBitmapHeight(GLUT_BITMAP_HELVETICA_18));"),
        (Values{9, 32, 23}));
    EXPECT_EQ(read_program(program("const char *s; for (s = \"text\"; *s; s++) glutBitmapCharacter(font, *s);",
                                   "void *font = GLUT_BITMAP_TIMES_ROMAN_24;"))
                  .commands.size(),
              4U * 9);
}

TEST(ProgramMemory, IsAllocatedAndFreed) {
    EXPECT_EQ(values_of("float *v = malloc(3 * sizeof(float)); int i; for (i = 0; i < 3; i++) v[i] = i + 1; "
                        "glNormal3fv(v); free(v);"),
              (Values{1, 2, 3}));
    EXPECT_EQ(values_of("ball *first = NULL, *b; int i; for (i = 0; i < 3; i++) { b = (ball *)calloc(1, sizeof *b); "
                        "b->n = i; b->next = first; "
                        "first = b; } for (b = first; b; b = b->next) glLineWidth(b->n + 1);",
                        kBall),
              (Values{3, 2, 1}));
    EXPECT_EQ(
        values_of("int *v = malloc(4), w[2] = {7, 8}; v[0] = 5; v = realloc(v, 8); memcpy(v + 1, w, sizeof(int)); "
                  "glScaled(v[0], v[1], 0); memset(w, 0, sizeof w); glLineWidth(w[0] + w[1] + 1);"),
        (Values{5, 7, 0, 1}));
    EXPECT_NE(error_of(program("int *v = malloc(4); glLineWidth(*v);"))
                  .find("the value of this memory (malloc gives it no values)"),
              std::string::npos);
    // What is freed can be allocated again.
    EXPECT_EQ(values_of("int i; for (i = 0; i < 9; i++) free(malloc(100000000)); glLineWidth(i);"), (Values{9}));
}

// Expected: what a program compiled with glibc prints.
TEST(ProgramNumbers, AreThoseThatRandGivesOnLinux) {
    EXPECT_EQ(values_of("glScaled(rand(), rand(), RAND_MAX);"), (Values{1804289383, 846930886, 2147483647}));
    EXPECT_EQ(values_of("srand(42); glScaled(rand(), rand() % 10, 0);"), (Values{71876166, 0, 0}));
    EXPECT_EQ(values_of("srand(time(NULL)); glScaled(rand(), 0, 0);"), (Values{1804289383, 0, 0}));
    EXPECT_EQ(values_of("glScaled(glutGet(GLUT_ELAPSED_TIME), glutGet(GLUT_SCREEN_WIDTH), clock());"),
              (Values{0, 1920, 0}));
}

TEST(ProgramTypes, HaveTheirWordsInAnyOrder) {
    EXPECT_EQ(
        values_of(
            "unsigned short int a = 65537; short unsigned b = 65538; int unsigned long c = -1; long double d = 0.5; "
            "const char unsigned e = 257; glScaled(a, b, d); glScaled(c, e, sizeof(long long int));"),
        (Values{1, 2, 0.5, 4294967295, 1, 8}));
    EXPECT_EQ(values_of("volatile int i = 2; const static int n = 3; glScaled(i, n, 0);"), (Values{2, 3, 0}));
    EXPECT_NE(error_of(program("short short i;")).find("3:7: this type cannot have the word 'short' here"),
              std::string::npos);
}

TEST(ProgramExpressions, HaveCommas) {
    EXPECT_EQ(values_of("int i, j; glLineWidth(1), glLineWidth(2); i = 3, j = 4; glLineWidth((i, j)); "
                        "for (i = 0, j = 9; i < 2, j > 7; i++, j--) glLineWidth(j);"),
              (Values{1, 2, 4, 9, 8}));
}

TEST(ProgramPreprocessor, JoinsAndQuotesWords) {
    EXPECT_EQ(
        values_of("glScaled(JOIN(va, lue), sizeof(QUOTE(a b)), __LINE__); CALL(glLineWidth, 1 + 1);",
                  "#define JOIN(a, b) a##b\n#define QUOTE(x) #x\n#define CALL(f, ...) f(__VA_ARGS__)\nint value = 6;"),
        (Values{6, 4, 6, 2}));
    EXPECT_EQ(values_of("glLineWidth(A); glLineWidth(B);",
                        "#if defined(__has_include) && __has_include(<GL/glut.h>)\n#define A 1\n#endif\n"
                        "#if __has_include(\"nothing.h\")\n#define B 1\n#else\n#define B 2\n#endif"),
              (Values{1, 2}));
}

TEST(ProgramPreprocessor, IncludesFilesOfTheProgramsFolder) {
    const std::map<std::string, std::string> files = {
        {"shapes.h", "#pragma once\n#include \"more.h\"\n#define WIDE 3\n"},
        {"more.h", "void more(int n) {\n  glLineWidth(n);\n}\n"},
        {"wrong.h", "\n  int wrong(void) { return 1 / 0; }\n"},
        {"again.h", "#include \"again.h\"\n"}};
    const ReadOptions options{.load_text = [&](const std::string& name) -> std::optional<std::string> {
        const auto found = files.find(name);
        return found == files.end() ? std::nullopt : std::optional(found->second);
    }};
    const CommandList list = read_program(
        program("more(WIDE);",
                "#include \"shapes.h\"\n#include \"shapes.h\"\n#include <shapes.h>\n#include \"missing.h\""),
        options);
    ASSERT_EQ(list.commands.size(), 1U);
    EXPECT_EQ(list.commands[0].place.str(), "more.h:2:3");
    EXPECT_EQ(list.included.size(), 2U);
    const auto error = [&](const std::string& text) {
        try {
            read_program(text, options);
        } catch (const SceneError& wrong) {
            return as_compilers_print(wrong);
        }
        return std::string("no error");
    };
    EXPECT_EQ(error(program("wrong();", "#include \"wrong.h\"")),
              "wrong.h:2:30: error: this divides a whole number by 0\n  int wrong(void) { return 1 / 0; }\n            "
              "                 ^\n");
    EXPECT_NE(error(program("", "#include \"again.h\"")).find("#include is nested more than 16 levels deep"),
              std::string::npos);
}

TEST(ProgramPreprocessor, IncludesNoFileOfAnotherFolder) {
    const TemporaryFolder folder;
    write_file_atomically(folder / "shapes.h", "void ball(void) { glutSolidSphere(0.5, 8, 8); }\n");
    write_file_atomically(folder / "main.c", program("ball();", "#include <GL/glut.h>\n#include \"shapes.h\""));
    write_file_atomically(
        folder / "outside.c",
        program("ball();", "#include \"../" + std::filesystem::path(folder.str()).filename().string() + "/shapes.h\""));
    EXPECT_EQ(run_program("twinlight", {"lint", folder / "main.c"}).err, "");
    EXPECT_NE(run_program("twinlight", {"lint", folder / "outside.c"})
                  .err.find("the function 'ball', which this file does not define"),
              std::string::npos);
}

TEST(ProgramsInCpp, SayThatTheyAreCppAndHowToRunThem) {
    const auto is = [](const std::string& text, const std::string& start) {
        const std::string error = error_of(text);
        EXPECT_TRUE(error.starts_with("homework.c:" + start)) << error;
        EXPECT_NE(error.find("twinlight record homework.c"), std::string::npos) << error;
        EXPECT_NE(error.find("twinlight lint --run homework.c"), std::string::npos) << error;
    };
    is(program("std::cout << 1;", "#include <iostream>"), "1:1: this is C++: #include <iostream>;");
    is(program("auto v = 1;"), "3:1: this is C++: the word 'auto';");
    is(program("", "class lamp { public: int n; };"), "1:1: this is C++: the word 'class';");
    is(program("", "template <class T> T twice(T x) { return x; }"), "1:1: this is C++: the word 'template';");
    is(program("float x; set(x);", "void set(float &x) { x = 1; }"), "1:10: this is C++: the reference float& x;");
    is(program("int *p = new int[3];"), "3:10: this is C++: the word 'new';");
    is(program("std::vector<int> v;"), "3:1: this is C++: std::;");
    // What C can do is read.
    EXPECT_EQ(values_of("bool on = true; glLineWidth(on);", "#include <iostream>\nusing namespace std;"), (Values{1}));
    EXPECT_NE(error_of(program("int new = 1 / 0;")).find("this divides a whole number by 0"), std::string::npos);
}

TEST(ProgramErrorsOfGl, AreNotesWithTheirLines) {
    const Scene scene = make_scene(std::make_shared<const CommandList>(read_program(
                                       program("glShadeModel(GL_LIGHT0);\nglPushMatrix();\nglBegin(GL_QUADS); "
                                               "glEnable(GL_FOG); glEnd();\nglRectf(0, 0, 1, 1);"))),
                                   {.width = 16, .height = 16});
    const std::vector<std::string> notes = scene.recording->notes();
    ASSERT_EQ(notes.size(), 3U);
    EXPECT_TRUE(notes[0].starts_with("homework.c:3:1: GL error: glShadeModel is given")) << notes[0];
    EXPECT_TRUE(notes[1].starts_with("homework.c:5:20: GL error: glEnable is not allowed between glBegin and glEnd"))
        << notes[1];
    EXPECT_TRUE(notes[2].starts_with("homework.c:4:1: GL error: this glPushMatrix has no glPopMatrix")) << notes[2];
    EXPECT_EQ(scene.frame.draws().size(), 1U);
    EXPECT_THROW(make_scene(std::make_shared<const CommandList>(
                                read_scene("glEnable(GL_QUADS); glRectf(0, 0, 1, 1);", "a.gl", "a")),
                            {}),
                 SceneError);
}

TEST(ProgramsWithoutMain, SayThatTheyHaveNone) {
    try {
        read_program("#include <GL/glut.h>\nvoid ball(float r) { glutSolidSphere(r, 8, 8); }\n");
        ADD_FAILURE() << "is read";
    } catch (const SceneError& error) {
        EXPECT_TRUE(error.note.starts_with("this file has no function main()")) << error.note;
    }
}

}  // namespace

}  // namespace twinlight::program_data_test
