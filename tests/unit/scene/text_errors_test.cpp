// Several errors in one run: what the reader reports after the first, and how errors are printed.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "scene/command/characters.h"
#include "scene/command/text.h"
#include "scene/scenes/load.h"
#include "scene/state/state.h"

namespace twinlight::text_errors_test {
namespace {

// The places of all errors, "line:column", and the messages.
struct Errors {
    std::vector<std::string> places, messages;
};

Errors errors_of(const SceneError& error) {
    Errors errors;
    for (const TextError& one : error.errors) {
        errors.places.push_back(std::to_string(one.place.line) + ":" + std::to_string(one.place.column));
        errors.messages.push_back(one.message);
    }
    return errors;
}

Errors errors_in(std::string_view text) {
    try {
        make_frame(read_scene(text, "scene.gl", "scene"), {});
    } catch (const SceneError& error) {
        return errors_of(with_gl_errors(error, {}));
    }
    return {};
}

using Places = std::vector<std::string>;

std::string message_of(std::string_view text) {
    const Errors errors = errors_in(text);
    return errors.messages.empty() ? "no error" : errors.messages.front();
}

void expect_message(std::string_view text, const std::string& expected) {
    EXPECT_NE(message_of(text).find(expected), std::string::npos) << message_of(text) << "\n  expected: " << expected;
}

TEST(TextErrors, ContinueAfterASemicolon) {
    EXPECT_EQ(errors_in("glEnabel(1);\nglEnable(GL_LIGTHING);\nglEnable(1, 2);\nglutSolidCube(1);").places,
              (Places{"1:1", "2:10", "3:11"}));
    EXPECT_EQ(errors_in("glFoo((3;\nGLfloat a[] = {1, 2 3}; glBar();").places, (Places{"1:1", "2:21", "2:25"}));
}

TEST(TextErrors, ContinueInTheNextLineWhereASemicolonIsMissing) {
    EXPECT_EQ(errors_in("glEnable(GL_LIGHTING)\nglEnable(GL_LIGHT9);\n").places, (Places{"2:1", "2:10"}));
    EXPECT_EQ(errors_in("glFoo(1)\nGLfloat a = b;\n").places, (Places{"1:1", "2:13"}));
}

TEST(TextErrors, ContinueInsideAFunction) {
    EXPECT_EQ(errors_in("void display(void) {\n  glFoo();\n  glBar()\n}\n").places, (Places{"2:3", "3:3"}));
    EXPECT_EQ(errors_in("void display(void) {\n  glFoo();\n").places, (Places{"1:1", "2:3"}));
}

TEST(TextErrors, ContinueAfterWrongCharacters) {
    EXPECT_EQ(errors_in("glEnable(GL_LIGHTING) @;\nglFoo();\n").places, (Places{"1:23", "2:1"}));
    EXPECT_EQ(errors_in("#define N 5\nglFoo();\n").places, (Places{"1:1", "2:1"}));
    EXPECT_EQ(errors_in("#pragma twinlight texture(\"a\nglFoo();\n").places, (Places{"1:27", "2:1"}));
    EXPECT_EQ(errors_in("glFoo();\n/* open").places, (Places{"1:1", "2:1"}));
}

TEST(TextErrors, NameAVariableInItsOwnValue) {
    EXPECT_EQ(errors_in("GLfloat x = x;\nglutSolidCube(x);\n").places, (Places{"1:13"}));
}

TEST(TextErrors, LeaveOutWhatResultsFromAnEarlierError) {
    EXPECT_EQ(errors_in("GLfloat lamp[] = {1, x};\nglLightfv(GL_LIGHT0, GL_POSITION, lamp);\nlamp = 3;\n").places,
              (Places{"1:22"}));
    EXPECT_EQ(errors_in("glBegin(GL_LIGHT0);\nglVertex2f(0, 0);\nglEnd();\nglutSolidCube(1);\n").places,
              (Places{"1:1"}));
    EXPECT_EQ(errors_in("glBegin(GL_LINES);\nglEnable(GL_FOG);\nglutSolidCube(1);\nglClear(0);\n").places,
              (Places{"2:1"}));
}

TEST(TextErrors, AreTenAtMost) {
    std::string text;
    for (int i = 0; i < 30; ++i) text += "glFoo();\n";
    EXPECT_EQ(errors_in(text).places.size(), 10u);
    text.clear();
    for (int i = 0; i < 30; ++i) text += "glEnable(1);\n";
    const Errors errors = errors_in(text);
    EXPECT_EQ(errors.places.size(), 10u);
    EXPECT_EQ(errors.places.back(), "10:1");
}

TEST(TextErrors, OfGlAreReportedTogether) {
    EXPECT_EQ(errors_in("glEnable(1);\nglPopMatrix();\nglLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 120);\n").places,
              (Places{"1:1", "2:1", "3:1"}));
    // Beside errors of the text only those that do not depend on what could not be read.
    EXPECT_EQ(errors_in("glPushMatrx();\nglPopMatrix();\nglLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 120);\n").places,
              (Places{"1:1", "3:1"}));
}

TEST(TextErrors, NameTheRemedy) {
    expect_message("glEnable(GL_LIGHT8);", "GL has GL_LIGHT0 to GL_LIGHT7");
    expect_message("glShadeModel(GL_PHONG);", "GL has no Phong shading, only GL_FLAT and GL_SMOOTH");
    expect_message("glShadeModel(GL_PHONG);", "--shading phong");
    expect_message("GLfloat p[] = {1, 2, 3}; glLightfv(GL_LIGHT0, GL_POSITION, p);",
                   "reads 4 values, but 'p' has 3; add a fourth value w: 1 for a place, 0 for a direction");
    expect_message("glMaterialfv(GL_FRONT, GL_DIFFUSE, (GLfloat[]){1, 0, 0});", "add a fourth value, alpha");
    EXPECT_EQ(message_of("glMaterialfv(GL_FRONT, GL_DIFFUSE, (GLfloat[]){1, 0});").find("fourth"), std::string::npos);
    expect_message("glMaterialfv(GL_FRONT, GL_DIFFUSE, {1, 0, 0, 1});", "write (GLfloat[]){...}");
    expect_message("glVertex3dv({1, 0, 0});", "write (GLdouble[]){...}");
    expect_message("glVertexPointer(3, GL_FLOAT, 0, {1, 0});", "(GLfloat[]){1, 0, 0, 1}");
    expect_message("#pragma twinlight specular(mirror)\n", "expected one of half_vector, reflection, found 'mirror'");
    expect_message("#pragma twinlight ambient(atenuated)\n", "did you mean attenuated?");
}

TEST(TextErrors, NameWrongCharactersAndWhatToType) {
    const Errors semicolon = errors_in("glEnable(GL_FOG)\xEF\xBC\x9B\nglFoo();");
    EXPECT_EQ(semicolon.places, (Places{"1:17", "2:1"}));
    EXPECT_EQ(semicolon.messages[0], "'\xEF\xBC\x9B' (U+FF1B, full width) is not C; type ';' instead");
    // It is read as the ASCII character, so that nothing else is wrong.
    EXPECT_EQ(errors_in("glScalef\xEF\xBC\x88"
                        "1\xEF\xBC\x8C"
                        "1, 1);glutSolidCube(1);")
                  .places,
              (Places{"1:9", "1:11"}));
    expect_message(
        "glScalef(1, 1, \xE2\x88\x92"
        "1);",
        "(U+2212) is not C; type '-' instead");
    expect_message(
        "glScalef(1,\xE3\x80\x80"
        "1, 1);",
        "(U+3000) is not C; type a space instead");
    expect_message("glEnable(\xC3\xA9);", "unexpected character '\xC3\xA9' (U+00E9)");
    expect_message("glEnable(\xC3\x28);", "unexpected byte '\\xc3', which is not UTF-8");
}

TEST(TextErrors, ShowTheLineAndACaretBelowTheColumn) {
    const auto shown = [](std::string_view text, int line, int column) {
        return line_with_caret(text, {.file = nullptr, .line = line, .column = column});
    };
    EXPECT_EQ(shown("one\ntwo three\n", 2, 5), "two three\n    ^\n");
    EXPECT_EQ(shown("\tglFoo();\r\n", 1, 2), "\tglFoo();\n\t^\n");
    EXPECT_EQ(shown("a\x1b[31mb\n", 1, 3), "a?[31mb\n  ^\n");           // no escape sequences
    EXPECT_EQ(shown("\xEF\xBC\x88x\n", 1, 2), "\xEF\xBC\x88x\n  ^\n");  // two columns wide
    EXPECT_EQ(shown("\xC2\x9Bx\n", 1, 2), "?x\n ^\n");                  // a control character
    EXPECT_EQ(shown("one\n", 5, 1), "");
    EXPECT_EQ(shown("one\n", 1, Place::kCallNumber), "");
    const std::string long_line = shown(std::string(1000, 'a') + "b" + std::string(1000, 'c'), 1, 1001);
    EXPECT_LT(long_line.size(), 300u);
    EXPECT_EQ(long_line[long_line.find('^') - long_line.find('\n') - 1], 'b') << long_line;
}

// Random changes of a scene that uses much of the language: reading ends, with at most ten errors that a terminal can show.
TEST(TextErrors, OfRandomlyChangedTextsArePrintable) {
    const auto file = std::ranges::find(kSceneFiles, "report.gl", &EmbeddedFile::name);
    std::mt19937 random(17);
    const auto below = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
    int with_errors = 0;
    for (int i = 0; i < 300; ++i) {
        std::string text(file->text);
        for (std::size_t changes = 1 + below(5); changes > 0; --changes) {
            const std::size_t at = below(text.size());
            constexpr std::string_view kInserted[] = {"}",    "{",    ";", "(",      "\"", "/*", "\xEF\xBC\x9B",
                                                      "\xFF", "\x1b", "#", "void f("};
            if (below(2) == 0)
                text.erase(at, 1 + below(20));
            else
                text.insert(at, kInserted[below(std::size(kInserted))]);
        }
        try {
            make_frame(read_scene(text, "scene.gl", "scene"), {});
        } catch (const SceneError& error) {
            const SceneError all = with_gl_errors(error, {});
            ++with_errors;
            EXPECT_LE(all.errors.size(), kMaxErrorsShown);
            for (const char c : as_compilers_print(all)) {
                const auto byte = static_cast<unsigned char>(c);
                ASSERT_TRUE((byte >= 0x20 && byte != 0x7F) || c == '\n' || c == '\t') << "change " << i;
            }
        }
    }
    EXPECT_GT(with_errors, 200);
}

TEST(Characters, AreDecodedFromUtf8) {
    const auto decoded = [](std::string_view text) {
        const DecodedCharacter c = decode_utf8(text);
        return std::pair(static_cast<unsigned>(c.character), c.bytes);
    };
    using Pair = std::pair<unsigned, std::size_t>;
    EXPECT_EQ(decoded("ab"), Pair(0x61, 1));
    EXPECT_EQ(decoded("\xC3\xA9"), Pair(0xE9, 2));
    EXPECT_EQ(decoded("\xEF\xBC\x9B"), Pair(0xFF1B, 3));
    EXPECT_EQ(decoded("\xF0\x9F\x98\x80"), Pair(0x1F600, 4));
    // RFC 3629, section 3: overlong forms, surrogates, beyond U+10FFFF, cut short, a byte that continues.
    for (const char* bad : {"\xC0\x80", "\xE0\x80\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xEF\xBC", "\x80", ""})
        EXPECT_EQ(decoded(bad).second, 0u) << bad;
}

}  // namespace
}  // namespace twinlight::text_errors_test
