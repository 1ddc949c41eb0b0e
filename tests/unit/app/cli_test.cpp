// The program twinlight, as built: what it prints, what it writes, its exit status.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "../pictures.h"
#include "../run_program.h"
#include "base/image/file.h"
#include "base/image/png.h"
#include "base/text/json.h"
#include "render/context/context.h"
#include "render/context/driver_name.h"

namespace twinlight::cli_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// A sphere that the default light, which shines along z, lights in its middle.
constexpr const char* kScene =
    R"(glMatrixMode(GL_PROJECTION); glOrtho(-1, 1, -1, 1, -1, 1); glMatrixMode(GL_MODELVIEW);
glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glEnable(GL_DEPTH_TEST);
glutSolidSphere(0.8, 24, 12);
)";

class Cli : public testing::Test {
  protected:
    // A scene file in the test's folder.
    std::string scene(const std::string& text, const std::string& name = "scene.gl") {
        write_file_atomically(in_ / name, text);
        return in_ / name;
    }
    ProgramResult run(const std::vector<std::string>& arguments) { return run_program("twinlight", arguments); }

    // Bad input or use: exit 2, nothing on standard output, one line on standard error, no file in out_.
    void expect_refused(const ProgramResult& result, const std::string& expected) {
        EXPECT_EQ(result.status, 2);
        EXPECT_EQ(result.out, "");
        EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
        EXPECT_NE(result.err.find(expected), std::string::npos) << result.err << "  expected: " << expected;
        EXPECT_EQ(out_.names(), std::vector<std::string>());
    }
    // The same for a scene whose text has errors: each has its line, and the line of the text with a caret.
    void expect_errors(const ProgramResult& result, const std::string& expected) {
        EXPECT_EQ(result.status, 2);
        EXPECT_EQ(result.out, "");
        EXPECT_NE(result.err.find(expected), std::string::npos) << result.err << "  expected: " << expected;
        EXPECT_LE(std::ranges::count(result.err, '\n'), 31) << result.err;
        EXPECT_EQ(out_.names(), std::vector<std::string>());
    }
    void expect_scene_refused(const std::string& text, const std::string& expected) {
        SCOPED_TRACE(text.substr(0, 200));
        const std::string file = scene(text);
        expect_errors(run({"render", file, "--with", "reference", "--size", "8x6", "-o", out_ / "p.png"}), expected);
        expect_errors(run({"compare", file, "--size", "8x6", "-o", out_ / "report"}), expected);
    }
    // Runs a line of shell in in_; $P is the program.
    ProgramResult run_inside(const std::string& line) {
        return run_shell("twinlight", "P=$(realpath \"$PROGRAM\"); cd " + quoted(in_.str()) + " && " + line);
    }

    const TemporaryFolder in_, out_;
};

// ---- Use ----

TEST_F(Cli, HelpsAndTellsItsVersionEverywhere) {
    for (const std::vector<std::string>& command : std::vector<std::vector<std::string>>{{},
                                                                                         {"render"},
                                                                                         {"compare"},
                                                                                         {"explain"},
                                                                                         {"export"},
                                                                                         {"record"},
                                                                                         {"scenes"},
                                                                                         {"study"},
                                                                                         {"fuzz"},
                                                                                         {"check"},
                                                                                         {"lint"},
                                                                                         {"lesson"}}) {
        for (const char* flag : {"--help", "-h", "--version"}) {
            std::vector<std::string> arguments = command;
            arguments.emplace_back(flag);
            const ProgramResult result = run(arguments);
            EXPECT_EQ(result.status, 0);
            EXPECT_EQ(result.err, "");
            EXPECT_NE(result.out.find(std::string(flag) == "--version" ? "twinlight 0" : "Usage: twinlight"),
                      std::string::npos);
        }
    }
}

TEST_F(Cli, NamesWhatItWasBuiltFromAndTheDriver) {
    const ProgramResult result = run({"--version"});
    const std::string commit = run_shell("", "tools/commit.sh").out;
    EXPECT_NE(result.out.find("commit     " + (commit.empty() ? "unknown\n" : commit)), std::string::npos)
        << result.out;
    const auto context = make_offscreen_context(1, 1);
    EXPECT_NE(result.out.find("\ndriver     " + driver_name() + "\n"), std::string::npos) << result.out;
    EXPECT_TRUE(std::regex_search(result.out, std::regex("\nlibraries  .*fmt [0-9]+\\.[0-9]+.*, glu [0-9]")))
        << result.out;
}

TEST_F(Cli, RefusesBadUse) {
    const std::string file = scene(kScene);
    expect_refused(
        run({}),
        "a command is missing: render, compare, explain, export, record, scenes, study, fuzz, check, lint or lesson");
    expect_refused(run({"rendr"}), "there is no command 'rendr'; did you mean 'render'?");
    expect_refused(run({"--bogus"}), "'--bogus'");
    expect_refused(run({"render"}), "SCENE is required; see 'twinlight render --help'");
    expect_refused(run({"report"}), "a command is missing before the scene 'report'; try 'twinlight compare report'");
    expect_refused(run({file}), "try 'twinlight compare " + file + "'");
    expect_refused(run({"help"}), "there is no command 'help'; 'twinlight --help'");
    expect_refused(run({"render", file, "--with", "fixed", "-o", out_ / "p.jpg"}),
                   "render writes only PNG files; use -o " + (out_ / "p.png"));
    expect_refused(run({"render", file, "--with", "fixed", "--budget", "2", "-o", out_ / "p.png"}),
                   "--budget: '2' is not a number from 0 to 1");
    expect_refused(run({"render", file, "--shading", "exact", "-o", out_ / "p.png"}),
                   "the fixed function cannot draw exact surfaces; use --with shaders");
    expect_refused(run({"render", file, "--with", "fixd", "-o", out_ / "p.png"}), "'fixd' is not one of fixed, ");
    expect_refused(run({"render", file, "--with", "fixed", "--bogus", "-o", out_ / "p.png"}),
                   "there is no option '--bogus'; see 'twinlight render --help'");
    expect_refused(run({"render", file, "--wiht", "fixed", "-o", out_ / "p.png"}),
                   "there is no option '--wiht'; did you mean '--with'?");
    expect_refused(run({"render", file, "-q"}), "there is no option '-q'; see 'twinlight render --help'");
    expect_refused(run({"compare", file, "-o", out_ / "r", "--siz=8x6"}), "did you mean '--size'?");
    expect_refused(run({"render", file, "extra", "--with", "fixed", "-o", out_ / "p.png"}),
                   "unexpected argument 'extra'");
    expect_refused(run({"render", file, "--with", "fixed", "-o"}), "-o needs a value");
    expect_refused(run({"render", file, "--with", "fixed", "-o", out_ / "p.png", "-o", out_ / "q.png"}),
                   "-o is given more than once");
    expect_refused(run({"render", file, "--with", "fixed", "-o", ""}), "-o: the name is empty");
    expect_refused(run({"compare", file, "-o", ""}), "-o: the name is empty");
    expect_refused(run({"compare", "", "-o", out_ / "r"}), "SCENE: the name is empty");
    expect_refused(run({"render", file, "--with", "fixed", "--shading", "phong", "-o", out_ / "p.png"}),
                   "use --with shaders or --with reference");
    expect_refused(run({"render", file, "--with", "fixed", "--shading", "smooth", "-o", out_ / "p.png"}), "flat");
    expect_refused(run({"render", file, "--with", "fixed", "--precise", "-o", out_ / "p.png"}),
                   "use it with --with shaders");
    expect_refused(run({"render", file, "--with", "shaders", "--precise", "--shading", "phong", "-o", out_ / "p.png"}),
                   "does not work with phong or exact shading");
    expect_refused(run({"render", file, "--with", "shaders", "--precise", "--baked", "-o", out_ / "p.png"}),
                   "does not work with constants");
    expect_refused(run({"export", file, "--as", "c", "--precise"}), "use it with --as glsl");
    expect_refused(run({"export", file, "--as", "c", "-o", out_ / "e"}),
                   "applies only to --as glsl, html, vulkan and wgsl");
    expect_refused(run({"export", file, "--as", "glsl", "--glsl", "330"}), "use it with --as glsl -o DIR");
    expect_refused(run({"export", file, "--as", "glsl", "-o", out_ / "e", "--glsl", "120"}),
                   "'120' is not one of 130, 300es, 330");
    expect_refused(run({"export", file, "--as", "glsl", "-o", out_ / "e", "--for-this-picture"}), "without -o");
    expect_refused(run({"export", file, "--as", "glsl", "-o", out_ / "e", "--frames", "0-3"}),
                   "--frames applies only to recorded programs");
    expect_refused(run({"export", file, "--as", "glsl", "--frames", "0-3"}), "use it with --as glsl -o DIR");
    const std::string gears = "tests/traces/glxgears/dump.txt";
    for (const char* range : {"3-2", "-1", "2-", "x", "0-1x", "1--2"})
        expect_refused(run({"export", gears, "--as", "glsl", "-o", out_ / "e", "--frames=" + std::string(range)}),
                       "is not a range of frames, such as 0-60");
    expect_refused(run({"export", gears, "--as", "glsl", "-o", out_ / "e", "--frames", "0-7"}),
                   "has no frame 7; its frames are 0 to 1");
    expect_refused(run({"export", gears, "--as", "glsl", "-o", out_ / "e", "--frames", "0-1", "--frame", "1"}),
                   "leave one of them out");
    expect_refused(run({"export", file, "--as", "glsl", "-o", out_ / "e", "--precise"}),
                   "use --as glsl --for-this-picture");
    expect_refused(run({"export", file, "--as", "glsl", "-o", out_ / "e", "--shading", "exact"}),
                   "use --as glsl --for-this-picture");
    expect_refused(run({"export", file, "--as", "wgsl"}), "use it with --as wgsl -o DIR");
    expect_refused(run({"export", file, "--as", "vulkan", "-o", out_ / "e", "--shading", "exact"}),
                   "use --as glsl --for-this-picture");
    expect_refused(run({"export", "shadow-map", "--as", "wgsl", "-o", out_ / "e"}), "8 bits a channel; leave it out");
    expect_refused(run({"export", file, "--as", "pascal"}),
                   "'pascal' is not one of c, glsl, html, scene, vulkan, wgsl");
    expect_refused(run({"scenes", "no-such-scene-at-all"}), "there is no built-in scene 'no-such-scene-at-all'");
}

TEST_F(Cli, RefusesSizesOutsideTheLimits) {
    const std::string file = scene(kScene);
    for (const char* size : {"640", "x", "640x", "x480", "0x480", "640x0", "-1x5", "8193x1", "1x8193", "1e3x10",
                             "640x480x2", "99999999999x1", " 640x480", ""}) {
        expect_refused(run({"render", file, "--with", "fixed", "--size", size, "-o", out_ / "p.png"}), "--size");
    }
}

// ---- Bad scenes ----

TEST_F(Cli, RefusesBadScenesWithTheirPlace) {
    const std::string file = in_ / "scene.gl";
    expect_scene_refused("glEnable(GL_LIGHTING);\nglEnabel(GL_LIGHT0);\n", file + ":2:1: ");
    expect_scene_refused("glEnable();\n", file + ":1:");
    expect_scene_refused("glEnable(GL_LIGHTING, 1);\n", file + ":1:");
    expect_scene_refused("glEnable(\"light\");\n", file + ":1:");
    expect_scene_refused("glShadeModel(GL_SMOTH);\n", file + ":1:14: ");
    expect_scene_refused("glShadeModel(GL_LIGHT0);\nglutSolidCube(1);\n", file + ":1:1: ");
    expect_scene_refused("glBegin(GL_TRIANGLES);\nglVertex3f(0, 0, 0);\n", file + ":1:1: ");
    expect_scene_refused("glutSolidCube(1);\nglEnd();\n", file + ":2:1: ");
    expect_scene_refused("\nglPushMatrix();\nglutSolidCube(1);\n", file + ":2:1: ");
    expect_scene_refused("glutSolidCube(1);\nglPopMatrix();\n", file + ":2:1: ");
    expect_scene_refused("glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 120);\nglutSolidCube(1);\n", file + ":1:1: ");
    expect_scene_refused("#pragma twinlight specular(mirror)\n", file + ":1:");
    expect_scene_refused("glEnable(GL_LIGHTING", file + ":1:");
    expect_scene_refused("/* no end", file + ":1:");
}

TEST_F(Cli, RefusesScenesThatAreNone) {
    expect_scene_refused("", "scene.gl");
    expect_scene_refused("// nothing\n", "scene.gl");
    expect_scene_refused("glEnable(GL_LIGHTING);\n", "scene.gl");
    expect_scene_refused(std::string("\x7f"
                                     "ELF\x02\x01\x01\0\0\n\xff\xfe",
                                     12),
                         "scene.gl: this is a program, not a scene");
    expect_scene_refused(std::string(1 << 20, '\0'), "scene.gl:1:1: ");
    expect_scene_refused(std::string(1 << 20, '('), "scene.gl:1:");
    expect_scene_refused("glScalef(" + std::string(1 << 20, '(') + "1", "scene.gl:1:");
    expect_scene_refused("glScalef(" + std::string(1 << 20, '-') + "1", "scene.gl:1:");
    expect_scene_refused(std::string(1 << 20, 'a') + "();\n", "scene.gl:1:1: ");
}

TEST_F(Cli, ReportsSeveralErrorsAsCompilersDo) {
    scene(
        "glEnable(GL_LIGTHING);\n"
        "\tglLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 120);\n"
        "glutSolidSphere(1, 9 9);\n"
        "glutSolidSphere(1, 9, 9);\n");
    const ProgramResult result = run_inside("\"$P\" compare scene.gl");
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.err,
              "scene.gl:1:10: error: unknown name 'GL_LIGTHING'; did you mean GL_LIGHTING?\n"
              "glEnable(GL_LIGTHING);\n"
              "         ^\n"
              "scene.gl:2:2: error: GL_SPOT_CUTOFF is 120; it must be in [0, 90] or 180 (GL_INVALID_VALUE)\n"
              "\tglLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 120);\n"
              "\t^\n"
              "scene.gl:3:22: error: expected ',' between the arguments of glutSolidSphere, found '9'\n"
              "glutSolidSphere(1, 9 9);\n"
              "                     ^\n");
}

TEST_F(Cli, ShowsWhatQueriesReturn) {
    const std::string file = scene(
        "GLfloat f[16]; GLint i[16]; GLboolean b[16]; GLdouble d[16];\n"
        "glTranslatef(0, 0, -2); glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){2, 3, 4, 1});\n"
        "glGetLightfv(GL_LIGHT0, GL_POSITION, f);\n"
        "GLboolean lit = glIsEnabled(GL_LIGHT0);\n"
        "glGetIntegerv(GL_SHADE_MODEL, i); glGetBooleanv(GL_LIGHT_MODEL_TWO_SIDE, b);\n"
        "glGetDoublev(GL_MODELVIEW_MATRIX, d); glGetFloatv(GL_CURRENT_COLOR, f);\n"
        "glGetMaterialfv(GL_FRONT, GL_AMBIENT, f); glGetMaterialiv(GL_BACK, GL_DIFFUSE, i);\n"
        "glGetLightiv(GL_LIGHT1, GL_SPOT_DIRECTION, i); glGetIntegerv(GL_DEPTH_RANGE, i);\n"
        "glGetClipPlane(GL_CLIP_PLANE0, d); glGetTexEnviv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, i);\n"
        "glGetTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, f); glGetIntegerv(GL_TEXTURE_BINDING_2D, i);\n"
        "glLoadIdentity(); glutSolidCube(1);\n"
        "// twinlight: allow(lighting-off)\n");
    const ProgramResult result = run({"compare", file, "--size", "8x6", "--json", "-o", out_.str()});
    const json queries = json::parse(result.out)["queries"];
    ASSERT_EQ(queries.size(), 14U);
    EXPECT_EQ(queries[0], (json{{"place", file + ":3:1"},
                                {"call", "glGetLightfv(GL_LIGHT0, GL_POSITION)"},
                                {"twinlight", "2, 3, 2, 1"},  // in eye coordinates
                                {"driver", "2, 3, 2, 1"},
                                {"agree", true}}));
    EXPECT_EQ(queries[1]["driver"], "GL_FALSE");
    EXPECT_EQ(queries[2]["driver"], "GL_SMOOTH");
    for (const json& query : queries) {
        EXPECT_TRUE(query["agree"]) << query;
        EXPECT_NE(query["twinlight"], "?") << query;
        // The driver has its own names for textures, so it is not asked for them.
        const bool names_texture = query["call"] == "glGetIntegerv(GL_TEXTURE_BINDING_2D)";
        EXPECT_EQ(query["driver"] == "?", names_texture) << query;
    }
    EXPECT_NE(read_file(out_ / "index.html").find("<code>glGetLightfv(GL_LIGHT0, GL_POSITION)</code>"),
              std::string::npos);
    const ProgramResult render = run({"render", file, "--with", "reference", "--size", "8x6", "-o", out_ / "p.png"});
    EXPECT_TRUE(render.err.starts_with(
        file + ":3:1: glGetLightfv(GL_LIGHT0, GL_POSITION) returns 2, 3, 2, 1 (driver: the same)\n"))
        << render.err;
    EXPECT_EQ(std::ranges::count(render.err, '\n'), 14);
}

TEST_F(Cli, NamesItsOutputAfterTheScene) {
    scene(kScene, "lamp.gl");
    const ProgramResult picture = run_inside("\"$P\" render lamp.gl --with reference --size 8x6");
    EXPECT_EQ(picture.out, "Picture: lamp.png\n") << picture.err;
    EXPECT_EQ(read_png(in_ / "lamp.png").width, 8);
    const ProgramResult report = run_inside("\"$P\" compare lamp.gl --size 8x6");
    EXPECT_NE(report.out.find("Report: lamp-report/index.html\n"), std::string::npos) << report.out << report.err;
    EXPECT_TRUE(fs::exists(in_ / "lamp-report/index.html"));
    const ProgramResult study = run_inside("\"$P\" study lamp.gl --quick --seconds 0.01 --size 8x6");
    EXPECT_NE(study.out.find("Report: lamp-study/index.html\n"), std::string::npos) << study.out << study.err;
    const ProgramResult input = run_inside("\"$P\" compare - --size 8x6 <lamp.gl");
    EXPECT_NE(input.out.find("Report: stdin-report/index.html\n"), std::string::npos) << input.out << input.err;
}

TEST_F(Cli, NamesRecordForProgramsAndTheirSource) {
    write_file_atomically(in_ / "homework", std::string("\x7f"
                                                        "ELF\x02\x01\x01\0",
                                                        8));
    expect_refused(run({"compare", in_ / "homework", "-o", out_ / "r"}),
                   "this is a program, not a scene; to run it and record what it draws: twinlight record " +
                       (in_ / "homework") + " -o homework.trace");
    const std::string source = scene("struct light { float x; };\nint main(void) { return 0; }\n", "homework.c");
    expect_errors(run({"compare", source, "-o", out_ / "r"}),
                  "note: this is a C program; to run it and record what it draws: twinlight record " + source);
}

TEST_F(Cli, RefusesALineOfAGigabyteUnread) {
    const ProgramResult result = run_shell("twinlight",
                                           "head -c 1000000000 /dev/zero | tr '\\0' ' ' | "
                                           "\"$PROGRAM\" render - --with reference -o " +
                                               quoted(out_ / "p.png"));
    expect_refused(result, "is larger than 64 MiB, the limit for a scene");
}

// 2048 x 2048 texels of four numbers, each "200, " in C, and line breaks.
TEST_F(Cli, WritesNoSceneFileThatNoCommandReads) {
    write_file_atomically(in_ / "texels.bin", std::string(std::size_t{4} << 22, '\xC8'));
    write_file_atomically(
        in_ / "dump.txt",
        "1 glTexImage2D(target = GL_TEXTURE_2D, level = 0, internalformat = GL_RGBA, width = 2048, height = 2048, "
        "border = 0, format = GL_RGBA, type = GL_UNSIGNED_BYTE, pixels = blob(\"texels.bin\"))\n"
        "2 glBegin(mode = GL_POINTS)\n3 glVertex2f(x = 0, y = 0)\n4 glEnd()\n5 glXSwapBuffers()\n");
    expect_refused(run({"export", in_ / "dump.txt", "--as", "scene"}),
                   "as a scene file this frame has 83 MiB, and no command reads more than 64");
}

TEST_F(Cli, RefusesScenesThatAreNotThere) {
    const auto render = [&](const std::string& name) {
        return run({"render", name, "--with", "reference", "-o", out_ / "p.png"});
    };
    expect_refused(render(in_ / "none.gl"), in_ / "none.gl: No such file or directory");
    expect_refused(render(in_.str()), "Is a directory");
    expect_refused(render("no-such-scene-at-all"), "there is no built-in scene and no file with this name");
    expect_refused(render("a\nb"), "a\\x0ab");
    expect_refused(render("game.trace"), "game.trace: No such file or directory");
    expect_refused(render("repot"), "did you mean 'report'?");
}

// ---- Bad outputs ----

TEST_F(Cli, SaysWhereItCannotWrite) {
    const std::string file = scene(kScene);
    const auto render = [&](const std::string& output) {
        return run({"render", file, "--with", "fixed", "--size", "8x6", "-o", output});
    };
    expect_refused(render(out_ / "none/p.png"), "No such file or directory");
    expect_refused(render(out_.str()), "Is a directory");
    expect_refused(render("/dev/full"), "/dev/full: No space left on device");
    expect_refused(run({"compare", file, "--size", "8x6", "-o", file}), file);
    expect_refused(run_shell("twinlight", "\"$PROGRAM\" export " + quoted(file) + " --as c >/dev/full"),
                   "standard output: No space left on device");
    expect_refused(run_shell("twinlight", "\"$PROGRAM\" scenes >/dev/full"),
                   "standard output: No space left on device");
}

TEST_F(Cli, LeavesNothingBehindWhenTheDiskIsFull) {
    // ulimit counts blocks of 512 bytes; the reports' files are larger than one.
    const std::string file = scene(kScene);
    const ProgramResult result =
        run_shell("twinlight", "trap '' XFSZ; ulimit -f 1; \"$PROGRAM\" render " + quoted(file) + " --with fixed -o " +
                                   quoted(out_ / "p.png"));
    expect_refused(result, "p.png: File too large");
}

TEST_F(Cli, LeavesAnOldReportWholeWhenTheDiskIsFull) {
    const std::string file = scene(kScene);
    const auto compare = [&](const std::string& limit, const std::string& folder) {
        return run_shell("twinlight", limit + "\"$PROGRAM\" compare " + quoted(file) + " --size 64x48 -o " +
                                          quoted(folder) + " >/dev/null");
    };
    // The pictures and the numbers fit into sixteen blocks of 512 bytes, the page does not.
    const std::string limit = "trap '' XFSZ; ulimit -f 16; ";
    const std::string page_fails = "index.html: File too large";
    expect_refused(compare(limit, out_ / "new"), page_fails);

    const std::string old = in_ / "old";
    EXPECT_EQ(compare("", old).status, 0);
    write_file_atomically(old + "/fixed.png", "of the old report");
    expect_refused(compare(limit, old), page_fails);
    EXPECT_EQ(read_file(old + "/fixed.png"), "of the old report");
}

TEST_F(Cli, LeavesNoPartOfAFileWhenItIsInterrupted) {
    const std::string file = scene(kScene);
    for (const char* delay : {"0.02", "0.05", "0.1", "0.15", "0.2", "0.25", "0.3", "0.4"}) {
        run_shell("twinlight", "timeout -s INT " + std::string(delay) + " \"$PROGRAM\" compare " + quoted(file) +
                                   " -o " + quoted(out_.str()) + " >/dev/null");
        for (const std::string& name : out_.names()) {
            EXPECT_TRUE(name.ends_with(".png") || name.ends_with(".json") || name.ends_with(".html")) << name;
            if (name.ends_with(".png")) {
                EXPECT_NO_THROW(read_png(out_ / name)) << name;
            }
            if (name.ends_with(".json")) {
                EXPECT_TRUE(json::accept(read_file(out_ / name)));
            }
        }
    }
}

// ---- What it does ----

TEST_F(Cli, RendersWithEachRenderer) {
    const std::string file = scene(kScene);
    for (const char* renderer : {"fixed", "shaders", "reference"}) {
        const std::string path = out_ / (std::string(renderer) + ".png");
        const ProgramResult result = run({"render", file, "--with", renderer, "--size", "64x48", "-o", path});
        EXPECT_EQ(result.status, 0);
        EXPECT_EQ(result.out + result.err, "");
        const Image image = read_png(path);
        EXPECT_EQ(image.width, 64);
        EXPECT_EQ(image.height, 48);
        EXPECT_GT(image.at(32, 24)[0], 0.5F) << renderer;
        EXPECT_EQ(image.at(0, 0)[0], 0) << renderer;
    }
    const std::string by_default = out_ / "default.png";
    EXPECT_EQ(run({"render", file, "--size", "64x48", "-o", by_default}).status, 0);
    EXPECT_EQ(read_file(by_default), read_file(out_ / "fixed.png"));
}

TEST_F(Cli, RendersFromStandardInputToStandardOutput) {
    const ProgramResult result = run_shell(
        "twinlight", "\"$PROGRAM\" render - --with fixed --size 16x12 -o - <" + quoted(scene(kScene)) + " | cat");
    EXPECT_EQ(result.err, "");
    EXPECT_EQ(decode_png(result.out).width, 16);
}

TEST_F(Cli, ComparesAndPrintsATable) {
    const std::string folder = out_ / "a/b";
    const ProgramResult result = run({"compare", scene(kScene), "--size", "64x48", "-o", folder});
    EXPECT_EQ(result.status, 0) << result.out;
    EXPECT_EQ(result.err, "");
    EXPECT_NE(result.out.find("All three agree: "), std::string::npos);
    EXPECT_NE(result.out.find(folder + "/index.html"), std::string::npos);
    EXPECT_EQ(result.out.find('\x1b'), std::string::npos) << "no colours where it is no terminal";
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 12);
}

TEST_F(Cli, ComparesAndPrintsOneJsonObject) {
    const ProgramResult result = run({"compare", scene(kScene), "--size", "64x48", "--json", "-o", out_.str()});
    EXPECT_EQ(result.err, "");
    const json object = json::parse(result.out);
    EXPECT_EQ(object["scene"], "scene.gl");
    EXPECT_EQ(object["size"], json({64, 48}));
    ASSERT_EQ(object["pairs"].size(), 5U);
    for (const json& pair : object["pairs"]) {
        EXPECT_EQ(pair["interior"]["pixels"].get<int>() + pair["edge"]["pixels"].get<int>(), 64 * 48);
    }
    EXPECT_EQ(read_file(out_ / "comparison.json"), result.out);
    for (const json& render : object["renders"]) {
        EXPECT_TRUE(fs::exists(out_ / render["file"].get<std::string>()));
    }
}

TEST_F(Cli, ComparesInTheFixedFunctionsOrderOfOperations) {
    const std::string file = scene(kScene);
    const ProgramResult result = run({"compare", file, "--size", "64x48", "--precise", "--json", "-o", out_.str()});
    if (result.err.find("--precise needs GLSL 4.00") != std::string::npos) GTEST_SKIP() << result.err;
    EXPECT_EQ(result.status, 0);
    const json object = json::parse(result.out);
    EXPECT_EQ(object["pairs"][0]["interior"]["differing"], 0);
    EXPECT_FALSE(object["renders"][1].contains("error_bound")) << "it is not drawn from plans";
    const ProgramResult shaders = run({"export", file, "--as", "glsl", "--precise"});
    EXPECT_NE(shaders.out.find("precise float n_dot_vp"), std::string::npos);
    const std::string nine =
        scene("#pragma twinlight light(8, GL_DIFFUSE, 1, 1, 1, 1)\n" + std::string(kScene), "nine.gl");
    const ProgramResult refused = run({"render", nine, "--with", "shaders", "--precise", "-o", out_ / "p.png"});
    EXPECT_EQ(refused.status, 2);
    EXPECT_NE(refused.err.find("has only 8 lights, so it cannot draw light(8)"), std::string::npos) << refused.err;
}

TEST_F(Cli, ListsScenes) {
    const json object = json::parse(run({"scenes", "--json"}).out);
    const std::string text = run({"scenes"}).out;
    ASSERT_FALSE(object["scenes"].empty());
    for (const json& item : object["scenes"]) {
        EXPECT_NE(text.find(item["name"].get<std::string>()), std::string::npos);
        const std::string description = item["description"];
        EXPECT_TRUE(description.ends_with('.')) << description;
        EXPECT_EQ(description.find(". "), std::string::npos) << description;
    }
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80u) << line;
    EXPECT_NE(text.find("arrays.\n"), std::string::npos) << "the whole sentence of legacy, which takes several lines";
    const ProgramResult report = run({"scenes", "report"});
    EXPECT_EQ(report.status, 0);
    EXPECT_NE(report.out.find("glEnable(GL_LIGHTING);"), std::string::npos);
}

TEST_F(Cli, ExportsAProgramThatCompiles) {
    const ProgramResult result = run({"export", scene(kScene), "--as", "c"});
    EXPECT_EQ(result.status, 0);
    EXPECT_EQ(result.err, "");
    write_file_atomically(out_ / "scene.c", result.out);
    const ProgramResult compiled = run_shell("", "${CC:-gcc} -fsyntax-only -Wall -Werror " + quoted(out_ / "scene.c"));
    EXPECT_EQ(compiled.status, 0) << compiled.err;
}

// blinkbox's window has 300 x 300 pixels, the picture of a scene without a program 640 x 480.
TEST_F(Cli, ExportsAProgramWithTheWindowOfTheOneThatWasRecorded) {
    const auto exported = [&](const std::string& name) { return run({"export", name, "--as", "c"}).out; };
    EXPECT_NE(exported("tests/traces/blinkbox/dump.txt").find("glutInitWindowSize(300, 300);"), std::string::npos);
    EXPECT_NE(exported("report").find("glutInitWindowSize(640, 480);"), std::string::npos);
}

TEST_F(Cli, ExportsASceneThatShowsThePictureOfTheRecording) {
    const std::string recording = "tests/traces/blinkbox/dump.txt";
    write_file_atomically(out_ / "blinkbox.gl", run({"export", recording, "--as", "scene"}).out);
    const auto picture = [&](const std::string& of, const std::string& name) {
        const ProgramResult drawn = run({"render", of, "--with", "reference", "-o", out_ / name});
        EXPECT_EQ(drawn.status, 0) << drawn.err;
        return read_png(out_ / name);
    };
    const Image recorded = picture(recording, "recorded.png"), exported = picture(out_ / "blinkbox.gl", "exported.png");
    EXPECT_EQ(std::pair(exported.width, exported.height), std::pair(300, 300));
    EXPECT_EQ(exported.pixels, recorded.pixels);
}

TEST_F(Cli, ExportsTheShapesOfPragmasAsPrimitives) {
    const ProgramResult result = run({"export", "report", "--as", "c"});
    EXPECT_EQ(result.status, 0);
    EXPECT_EQ(result.out.find("twinlight shape"), std::string::npos);
    EXPECT_NE(result.out.find("glBegin(GL_TRIANGLE_FAN);"), std::string::npos);
}

// The frame of a recorded program as a scene draws the same picture.
TEST_F(Cli, ExportsARecordedProgramAsAScene) {
    const std::string program = "tests/traces/geomview/dump.txt";
    const ProgramResult result = run({"export", program, "--as", "scene"});
    ASSERT_EQ(result.status, 0) << result.err;
    const std::string exported = scene(result.out, "exported.gl");
    for (const std::string& input : {program, exported}) {
        const std::string picture = out_ / (input == program ? "a.png" : "b.png");
        const ProgramResult drawn = run({"render", input, "--with", "fixed", "--size", "300x300", "-o", picture});
        ASSERT_EQ(drawn.status, 0) << drawn.err;
    }
    EXPECT_EQ(read_file(out_ / "a.png"), read_file(out_ / "b.png"));
}

TEST_F(Cli, ExportsTheShadersOfEachShading) {
    const std::string file = scene(kScene);
    const ProgramResult result = run({"export", file, "--as", "glsl"});
    EXPECT_EQ(result.status, 0);
    EXPECT_EQ(result.err, "");
    EXPECT_NE(result.out.find("void main("), std::string::npos);
    EXPECT_NE(run({"export", file, "--as", "glsl", "--shading", "phong"}).out, result.out);
}

// Without -o the shaders are those of this picture, printed; with -o those to keep, in files.
TEST_F(Cli, ExportsShadersForThisPictureAndToKeep) {
    const std::string file = scene(kScene);
    const std::string printed = run({"export", file, "--as", "glsl"}).out;
    EXPECT_EQ(run({"export", file, "--as", "glsl", "--for-this-picture"}).out, printed);
    EXPECT_NE(printed.find("// Left out, with the reasons:"), std::string::npos);

    const ProgramResult kept = run({"export", file, "--as", "glsl", "-o", out_ / "new/kept"});
    EXPECT_EQ(kept.status, 0);
    EXPECT_EQ(kept.out + kept.err, "");
    EXPECT_NE(read_file(out_ / "new/kept/kind1.vert").find("#version 330 core"), std::string::npos);
    EXPECT_NE(read_file(out_ / "new/kept/scene.c").find("void draw_scene(void)"), std::string::npos);

    const ProgramResult page = run({"export", file, "--as", "html"});
    EXPECT_EQ(page.status, 0);
    EXPECT_NE(page.out.find("#version 300 es"), std::string::npos);
    EXPECT_EQ(run({"export", file, "--as", "html", "-o", out_ / "scene.html"}).out, "");
    EXPECT_EQ(read_file(out_ / "scene.html"), page.out);
}

// ---- check ----

TEST_F(Cli, CheckTellsOfEachCase) {
    const ProgramResult result = run({"check", "--json", "light-at-vertex", "spot-180-behind"});
    EXPECT_EQ(result.status, 0) << result.out;
    EXPECT_EQ(result.err, "");
    const json found = json::parse(result.out);
    ASSERT_EQ(found["cases"].size(), 2u);
    EXPECT_EQ(found["cases"][0]["name"], "light-at-vertex");
    EXPECT_EQ(found["cases"][0]["status"], "ruling");
    for (const char* path : {"fixed", "shaders", "reference"}) EXPECT_EQ(found["cases"][1][path], "pass");
    EXPECT_EQ(found["failing"], 0);
    const ProgramResult table = run({"check", "light-at-vertex"});
    EXPECT_NE(table.out.find("\nNothing unexpected.\n1 case."), std::string::npos) << table.out;
    EXPECT_EQ(run({"check", "light-at-vertex", "flat-triangle", "--html", out_.str()}).status, 0);
    const std::string page = read_file(out_ / "index.html");
    EXPECT_NE(page.find("<section id=\"light-at-vertex\">"), std::string::npos);
    EXPECT_NE(page.find("<img alt=\"shaders baked\" src=\"data:image/png;base64,"), std::string::npos);
    EXPECT_NE(page.find("<p class=\"headline\">Nothing unexpected: 2 of 2 cases pass, and none shows "),
              std::string::npos);
    EXPECT_NE(page.find("data-group=\"3\" aria-pressed=\"false\"><b>2</b>passed</button>"), std::string::npos);
    // Known bugs come before what passes.
    EXPECT_EQ(run({"check", "flat-triangle", "light-w-1e-30", "--html", out_.str()}).status, 0);
    const std::string both = read_file(out_ / "index.html");
    EXPECT_LT(both.find("<section id=\"light-w-1e-30\">"), both.find("<section id=\"flat-triangle\">"));
}

TEST_F(Cli, CheckFailsWhereAnAnswerIsUnexpected) {
    const std::string file = scene(
        "// what: a point that emits 0.5\n// why: it does not\n// text: 2.14.1\n// status: defined\n// derived: "
        "wrongly\n"
        "// expect: vertex 0: 0.25 0.5 0.5 1\n"
        "glLightModelfv(GL_LIGHT_MODEL_AMBIENT, (GLfloat[]){0, 0, 0, 1});\n"
        "glMaterialfv(GL_FRONT, GL_EMISSION, (GLfloat[]){0.5, 0.5, 0.5, 1});\n"
        "glEnable(GL_LIGHTING); glBegin(GL_POINTS); glVertex3f(-0.75, -0.75, 0); glEnd();\n");
    const ProgramResult result = run({"check", file});
    EXPECT_EQ(result.status, 1);
    const std::string found = "fixed, vertex 0: (0.5, 0.5, 0.5, 1), expected (0.25, 0.5, 0.5, 1) (2.14.1)";
    EXPECT_NE(result.out.find(found), std::string::npos) << result.out;
}

TEST_F(Cli, CheckWritesCasesAsPrograms) {
    const ProgramResult result = run({"check", "light-behind", "cone-smooth", "--write-cases", out_ / "cases"});
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.out, "1 case in " + (out_ / "cases") +
                              ": run it with `make report` there (README.md).\n"
                              "Not written, because GL's fixed function lacks what they need: cone-smooth.\n");
    EXPECT_TRUE(std::filesystem::exists(out_ / "cases/cases/light-behind.c"));
}

TEST_F(Cli, CheckRefusesBadUse) {
    expect_refused(run({"check", "light-at-vertex", "--write-cases", ""}), "--write-cases");
    expect_refused(run({"check", "light-behind", "--write-cases", out_ / "cases", "--json"}), "--write-cases");
    expect_refused(run({"check", "light-at-vertx"}), "did you mean 'light-at-vertex'?");
    expect_refused(run({"check", scene(kScene)}), "docs/hard-cases.md");
}

// ---- fuzz ----

TEST_F(Cli, FuzzTellsWhatItCompared) {
    const ProgramResult result = run({"fuzz", "--count", "64", "--seed", "3", "-o", out_ / "failures", "--json"});
    EXPECT_EQ(result.status, 0) << result.out;
    EXPECT_EQ(result.err, "");
    const json summary = json::parse(result.out);
    EXPECT_EQ(summary["float_states"], 62);
    EXPECT_EQ(summary["picture_states"], 2);
    EXPECT_EQ(summary["pairs"].size(), 3u);
    EXPECT_EQ(summary["failures"], json::array());
    EXPECT_EQ(out_.names(), std::vector<std::string>());  // the folder is made for failures alone
}

TEST_F(Cli, FuzzAgainstTheOracleTellsWhatItJudged) {
    const ProgramResult result =
        run({"fuzz", "--against", "oracle", "--count", "16", "--json", "-o", out_ / "failures"});
    EXPECT_EQ(result.status, 0) << result.out;
    const json summary = json::parse(result.out);
    EXPECT_EQ(summary["against"], "oracle");
    EXPECT_EQ(summary["states"], 16);
    EXPECT_EQ(summary["failures"], json::array());
    bool has_reference = false, has_shaders = false;
    for (const json& judged : summary["results"]) {
        EXPECT_GT(judged["compared"], 0) << judged["name"];
        EXPECT_GT(judged["verdicts"]["right"], 0) << judged["name"];
        has_reference = has_reference || judged["name"] == "reference, double";
        has_shaders = has_shaders || judged["name"] == "shaders, uniform";
    }
    EXPECT_TRUE(has_reference && has_shaders) << result.out;
    const ProgramResult text = run({"fuzz", "--against", "oracle", "--count", "4", "-o", out_ / "failures"});
    EXPECT_EQ(text.status, 0);
    EXPECT_NE(text.out.find("No unexplained difference."), std::string::npos) << text.out;
    EXPECT_EQ(out_.names(), std::vector<std::string>());
}

TEST_F(Cli, FuzzRefusesBadUse) {
    expect_refused(run({"fuzz", "--against", "oracel"}), "'oracel' is not one of oracle, renderers");
    expect_refused(run({"fuzz", "--against", "oracle", "--pictures-only"}), "--pictures-only");
    expect_refused(run({"fuzz", "--baked-every", "4"}), "--baked-every goes only with --against oracle");
    expect_refused(run({"fuzz", "--most-failures", "0"}), "--most-failures");
    expect_refused(run({"fuzz", "--count", "0"}), "--count");
    expect_refused(run({"fuzz", "--float-only", "--pictures-only"}), "--pictures-only");
    expect_refused(run({"fuzz", "--lift", "fog of a vertex whose w is not 2"}),
                   "did you mean 'fog of a vertex whose w is not 1'?");
}

// A vertex beyond the light's cone by the driver, on its edge by the text: any driver but the listed one may agree.
TEST_F(Cli, FuzzWritesWhatItFindsAsAScene) {
    const ProgramResult result = run({"fuzz", "--count", "8", "--float-only", "--lift",
                                      "a vertex on the edge of a spot's cone", "-o", out_ / "failures"});
    const std::vector<std::string> names = out_.names();
    EXPECT_EQ(result.status, names.empty() ? 0 : 1) << result.out;
    if (names.empty()) return;
    for (const auto& file : fs::directory_iterator(out_ / "failures")) {
        const std::string text = read_file(file.path());
        EXPECT_TRUE(text.starts_with("// twinlight fuzz --seed 1 --first ")) << text;
        EXPECT_NE(result.out.find(file.path().filename()), std::string::npos) << result.out;
        EXPECT_EQ(run({"render", file.path(), "--with", "reference", "--size", "8x8", "-o", out_ / "p.png"}).status, 0);
    }
}

// ---- explain ----

// A square that a lamp above its middle lights; the spot looks away, GL_LIGHT2 is faint.
constexpr const char* kLamps =
    R"(glMatrixMode(GL_PROJECTION); glOrtho(-1, 1, -1, 1, -1, 1); glMatrixMode(GL_MODELVIEW);
glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glEnable(GL_LIGHT1); glEnable(GL_LIGHT2);
glLightModelfv(GL_LIGHT_MODEL_AMBIENT, (GLfloat[]){0, 0, 0, 1});
glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){0, 0, 1, 0});
glLightfv(GL_LIGHT1, GL_POSITION, (GLfloat[]){0, 0, 5, 1});
glLightfv(GL_LIGHT1, GL_DIFFUSE, (GLfloat[]){1, 1, 1, 1});
glLightfv(GL_LIGHT1, GL_SPOT_DIRECTION, (GLfloat[]){1, 0, 0});
glLightf(GL_LIGHT1, GL_SPOT_CUTOFF, 20);
glLightfv(GL_LIGHT2, GL_DIFFUSE, (GLfloat[]){0.001, 0.001, 0.001, 1});
glBegin(GL_QUADS);
glVertex2f(-1, -1); glVertex2f(1, -1); glVertex2f(1, 1); glVertex2f(-1, 1);
glEnd();
)";

TEST_F(Cli, ExplainsWhichLightsMatterAndWhyNotTheOthers) {
    const std::string file = scene(kLamps);
    const ProgramResult text = run({"explain", file, "--all"});
    EXPECT_EQ(text.status, 0);
    EXPECT_EQ(text.err, "");
    // 90 degrees less the cone's 20 and asin(sqrt(2) / 5).
    for (const char* expected :
         {"1 draw with 1 different set of effects; allowed change of a channel: 0.5",
          "used     directional, diffuse: it adds at most 204/255 to a channel",
          "its cone misses the draw's bounding sphere by 53.6 degrees", "it would add at most 0.204/255 to a channel",
          "GL_LIGHT3 to GL_LIGHT7", "skipping changes:       a channel by at most 0.204"})
        EXPECT_NE(text.out.find(expected), std::string::npos) << expected << "\n" << text.out;
    EXPECT_EQ(text.out.find('\x1b'), std::string::npos);
    EXPECT_NE(run({"explain", file, "--budget", "0"}).out.find("skipping changes:       no pixel"), std::string::npos);

    const json explained = json::parse(run({"explain", file, "--json"}).out);
    EXPECT_NEAR(explained["error_bound"].get<double>(), 0.0008, 1e-9);
    const json& lights = explained["plans"][0]["lights"];
    ASSERT_EQ(lights.size(), 8U);
    EXPECT_EQ(lights[0]["effects"], "directional, diffuse");
    EXPECT_EQ(lights[0]["in"], true);
    EXPECT_EQ(lights[1]["in"], false);
    EXPECT_EQ(lights[2]["in"], false);
    EXPECT_NEAR(lights[2]["bound"][1].get<double>(), 0.0008, 1e-9);
    expect_refused(run({"explain", file, "--budget", "2"}), "--budget");
}

// The strips of a sphere: those that the light reaches, and those behind, each told once with numbers that hold for
// all.
TEST_F(Cli, ExplainsThePartsOfAShapeTogether) {
    const std::string file = scene(
        "glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glLightfv(GL_LIGHT0, GL_POSITION, (float[]){0, 0, 1, 0}); "
        "glutSolidSphere(0.8, 24, 12); glutSolidSphere(0.5, 24, 12);");
    const json explained = json::parse(run({"explain", file, "--json", "--budget", "0"}).out);
    std::set<int> numbers;
    for (const json& plan : explained["plans"])
        for (const json& number : plan["draws"]) EXPECT_TRUE(numbers.insert(number.get<int>()).second) << number;
    EXPECT_EQ(numbers.size(), 24U);
    EXPECT_EQ(*numbers.begin(), 1);
    EXPECT_LE(explained["plans"].size(), 4U);
    double largest = 0;
    for (const json& plan : explained["plans"])
        largest = std::max(largest, plan["lights"][0]["bound"][0].get<double>());
    EXPECT_NEAR(largest, 0.8, 1e-6);  // of the strip around the pole, which faces the light
}

TEST_F(Cli, StudiesWhatAccuracyCosts) {
    const std::string folder = out_ / "study";
    const ProgramResult result =
        run({"study", scene(kScene), "-o", folder, "--quick", "--seconds", "0", "--size", "48x48", "--json"});
    ASSERT_EQ(result.status, 0) << result.err;
    const json study = json::parse(result.out);
    EXPECT_EQ(read_file(folder + "/study.json"), result.out);
    for (const char* file : {"/study.csv", "/study.svg", "/index.html"}) EXPECT_FALSE(read_file(folder + file).empty());
    std::map<std::string, json> points;
    for (const json& point : study["points"]) points[point["key"]] = point;
    const auto rms = [&](const char* key) { return points.at(key)["error"]["interior"]["rms"].get<double>(); };
    EXPECT_EQ(points.at("reference-exact")["error"]["whole"]["rms"], 0);
    // Finer is nearer, and what is lit at every pixel is nearer than what is lit at vertices.
    EXPECT_LT(rms("shaders-phong-32"), rms("shaders-phong-8"));
    EXPECT_LT(rms("shaders-gouraud-32"), rms("shaders-gouraud-8"));
    EXPECT_LT(rms("shaders-phong-32"), rms("shaders-gouraud-32"));
    EXPECT_LT(rms("shaders-gouraud-32"), rms("shaders-flat-32"));
    EXPECT_NEAR(rms("fixed-gouraud-32"), rms("shaders-gouraud-32"), 1e-4);  // codes that round to either side
    for (const auto& [key, point] : points) EXPECT_EQ(point["seconds"]["samples"].size(), 3U) << key;
    // What is only sent in another way is the same picture, and so are normals that are rescaled.
    for (const char* sending : {"client-arrays", "immediate", "display-list"})
        EXPECT_EQ(points.at(std::string("fixed-gouraud-32-") + sending)["error"],
                  points.at("fixed-gouraud-32")["error"]);
    const auto largest = [&](const char* key) { return points.at(key)["error"]["whole"]["max"].get<double>(); };
    EXPECT_GT(largest("reference-exact-floats"), 0);
    EXPECT_LT(largest("reference-exact-floats"), 1e-4);
    EXPECT_LT(largest("reference-exact-long-double"), largest("reference-exact-floats"));
    // Floats have nothing to round.
    EXPECT_LT(rms("shaders-phong-32-float"), rms("shaders-phong-32"));
    EXPECT_LT(std::filesystem::file_size(folder + "/pictures/reference-exact-difference.png"), 1000U);  // one grey

    // Goes on: the rounds are added to those that there were.
    const ProgramResult more = run({"study", scene(kScene), "-o", folder, "--resume", "--seconds", "0.001", "--json"});
    ASSERT_EQ(more.status, 0) << more.err;
    const json resumed = json::parse(more.out);
    EXPECT_EQ(resumed["size"], study["size"]);
    EXPECT_EQ(resumed["series"][0]["rounds"], 4);
    EXPECT_EQ(resumed["points"].size(), study["points"].size());
    const auto expect_refusal = [](const ProgramResult& refused, const std::string& expected) {
        EXPECT_EQ(refused.status, 2);
        EXPECT_NE(refused.err.find(expected), std::string::npos) << refused.err;
    };
    expect_refusal(run({"study", scene("glutSolidCube(1);"), "-o", folder, "--resume"}), "leave --resume out");
    expect_refusal(run({"study", scene(kScene), "-o", folder, "--resume", "--size", "9x9"}),
                   "of 48 x 48 pixels, not 9 x 9");
    expect_refusal(run({"study", scene(kScene), "-o", out_ / "none", "--resume"}), "none/study.json");

    // Two of them laid over each other, with their pictures.
    const std::string file = folder + "/study.json", both = out_ / "both";
    const ProgramResult merged = run({"study", "--merge", file, file, "-o", both, "--json"});
    ASSERT_EQ(merged.status, 0) << merged.err;
    EXPECT_EQ(json::parse(merged.out)["series"].size(), 2U);
    EXPECT_EQ(read_file(both + "/pictures/2-reference-exact.png"), read_file(folder + "/pictures/reference-exact.png"));
    expect_refusal(run({"study", "--merge", file, "-o", both}), "at least two");
    expect_refusal(run({"study", "--merge", file, scene(kScene), "-o", both}), "this is not JSON");
    expect_refusal(run({"study", "-o", both}), "SCENE is missing");
}

TEST_F(Cli, KeepsWhatAnInterruptedStudyHas) {
    const std::string file = scene(kScene), folder = out_ / "study";
    // --foreground: otherwise timeout also signals its process group, and a second interrupt ends the program at once.
    const ProgramResult result =
        run_shell("twinlight", "timeout --foreground --preserve-status -s INT 2 \"$PROGRAM\" study " + quoted(file) +
                                   " -o " + quoted(folder) + " --quick --seconds 1000 --size 24x24 --json");
    ASSERT_EQ(result.status, 0) << result.err;
    const json begun = json::parse(result.out);
    const ProgramResult more = run({"study", file, "-o", folder, "--resume", "--seconds", "0", "--json"});
    ASSERT_EQ(more.status, 0) << more.err;
    const json ended = json::parse(more.out);
    EXPECT_GE(ended["points"].size(), begun["points"].size());
    EXPECT_GE(ended["series"][0]["rounds"], begun["series"][0]["rounds"]);
    for (const json& point : ended["points"]) EXPECT_GE(point["seconds"]["samples"].size(), 3U) << point["key"];
}

TEST_F(Cli, StudiesEdgesByCoverage) {
    const ProgramResult result = run({"study", scene(kScene), "-o", out_ / "study", "--quick", "--seconds", "0",
                                      "--size", "48x48", "--coverage", "8", "--json"});
    ASSERT_EQ(result.status, 0) << result.err;
    std::map<std::string, json> points;
    const json study = json::parse(result.out);
    for (const json& point : study["points"]) points[point["key"]] = point;
    const auto rms = [&](const std::string& key) { return points.at(key)["error"]["silhouette"]["rms"].get<double>(); };
    for (const std::string choice : {"fixed-gouraud-32", "shaders-phong-32", "reference-exact"}) {
        EXPECT_LT(rms(choice + "-samples-2"), rms(choice));
        EXPECT_LT(rms(choice + "-samples-4"), rms(choice + "-samples-2"));
    }
    EXPECT_GT(rms("reference-exact"), 0.01);  // one sample is not the mean of sixty-four
    EXPECT_EQ(run({"study", scene(kScene), "-o", out_ / "study", "--coverage", "3"}).status, 2);
}

TEST_F(Cli, DrawsExactSurfacesByShadersAndTheReference) {
    const std::string file = scene(kScene);
    const auto render = [&](const char* renderer) {
        return run({"render", file, "--with", renderer, "--shading", "exact", "--size", "32x32", "-o", out_ / "p.png"});
    };
    expect_refused(render("fixed"), "use --with shaders or --with reference");
    expect_refused(run({"render", file, "--with", "shaders", "--precise", "--shading", "exact", "-o", out_ / "p.png"}),
                   "does not work with phong or exact shading");
    EXPECT_NE(run({"export", file, "--as", "glsl", "--shading", "exact"}).out.find("cast_ray()"), std::string::npos);
    const ProgramResult explained = run({"explain", file, "--shading", "exact"});
    EXPECT_EQ(explained.status, 0) << explained.err;
    expect_refused(
        run({"render", file, "--with", "reference", "--scrubbed", "--shading", "exact", "-o", out_ / "p.png"}),
        "use either --scrubbed or --shading exact");
    expect_refused(run({"compare", file, "--shading", "flat", "-o", out_.str()}), "exact, phong");
    EXPECT_EQ(render("shaders").status, 0);
    EXPECT_EQ(render("reference").status, 0);
    const ProgramResult compared = run({"compare", file, "--shading", "exact", "--size", "32x32", "-o", out_.str()});
    EXPECT_EQ(compared.status, 0) << compared.err;
    EXPECT_NE(compared.out.find("shaders-exact"), std::string::npos);
}

TEST_F(Cli, ExplainsAPixelTermByTermThreeWays) {
    const std::string file = scene(kLamps);
    const json pixel = json::parse(run({"explain", file, "--size", "20x20", "--pixel", "3,5", "--json"}).out);
    ASSERT_EQ(pixel["fragments"].size(), 1U);
    const json& fragment = pixel["fragments"][0];
    EXPECT_EQ(fragment["draw"], 1);
    EXPECT_EQ(fragment["passes"], true);
    ASSERT_EQ(fragment["lights"].size(), 3U);
    EXPECT_NEAR(fragment["lights"][0]["n_dot_vp"].get<double>(), 1, 1e-12);
    EXPECT_NEAR(fragment["lights"][0]["diffuse"][0].get<double>(), 0.8, 1e-12);
    EXPECT_NEAR(fragment["lights"][1]["spot"].get<double>(), 0, 0);
    EXPECT_NEAR(fragment["primary_unclamped"][2].get<double>(), 0.8 + 0.8 * double{0.001F}, 1e-12);
    for (const char* renderer : {"fixed", "shaders", "reference"})
        EXPECT_NEAR(pixel["pictures"][renderer][0].get<double>(), 0.8008, 1.0 / 255) << renderer;

    const ProgramResult text = run({"explain", file, "--size", "20x20", "--pixel", "3,5"});
    for (const char* expected : {"1 fragment", "GL_LIGHT0: directional", "n.VP         1.00000", "clamped", "shaders"})
        EXPECT_NE(text.out.find(expected), std::string::npos) << expected << "\n" << text.out;
    EXPECT_NE(run({"explain", scene(kScene), "--size", "20x20", "--pixel", "0,0"}).out.find("no draw covers it"),
              std::string::npos);
    expect_refused(run({"explain", file, "--size", "20x20", "--pixel", "20,0"}), "the last pixel is 19,19");
    expect_refused(run({"explain", file, "--pixel", "a"}), "--pixel is 'a'; it must be X,Y");
}

// kLamps with a pragma: explain names the factors that its terms have.
TEST_F(Cli, ComparesAllStepsOnOnePage) {
    const std::string file = scene(std::string(kScene) +
                                   "#pragma twinlight step(\"One light\")\nglEnable(GL_LIGHT1);\n"
                                   "#pragma twinlight step(\"Nine lights\")\n"
                                   "#pragma twinlight light(8, GL_DIFFUSE, 1, 1, 1, 1)\nglutSolidCube(0.2);\n");
    for (const bool from_input : {false, true}) {
        const std::string folder = out_ / (from_input ? "input" : "file");
        const ProgramResult result = from_input ? run_shell("twinlight", "\"$PROGRAM\" compare - --size 64x48 -o " +
                                                                             quoted(folder) + " <" + quoted(file))
                                                : run({"compare", file, "--size", "64x48", "-o", folder});
        ASSERT_EQ(result.status, 0) << result.err;
        EXPECT_NE(result.out.find("\n1. One light\n   All three agree"), std::string::npos) << result.out;
        EXPECT_NE(result.out.find("\n2. Nine lights\n"), std::string::npos) << result.out;
        const json all = json::parse(read_file(fs::path(folder) / "comparison.json"));
        EXPECT_EQ(all["scene"], from_input ? "stdin" : "scene.gl");
        EXPECT_EQ(all["verdict"], "partial") << "the worst of the steps";
        ASSERT_EQ(all["steps"].size(), 2U);
        EXPECT_EQ(all["steps"][1]["title"], "Nine lights");
        EXPECT_EQ(all["steps"][0]["comparison"]["verdict"], "within");
        for (const json& step : all["steps"])
            for (const json& render : step["comparison"]["renders"])
                EXPECT_TRUE(fs::exists(fs::path(folder) / step["folder"].get<std::string>() /
                                       render["file"].get<std::string>()));
        const std::string page = read_file(fs::path(folder) / "index.html");
        for (const std::string title : {"1. One light", "2. Nine lights"})
            EXPECT_NE(page.find(title), std::string::npos) << title;
    }
    // One step has the report of a scene without steps.
    ASSERT_EQ(run({"compare", file, "--step", "1", "--size", "64x48", "-o", out_ / "one"}).status, 0);
    EXPECT_TRUE(fs::exists(out_ / "one/fixed.png"));
    EXPECT_EQ(json::parse(read_file(out_ / "one/comparison.json"))["scene"], "scene.gl, step 1: One light");
    const json printed = json::parse(run({"compare", file, "--size", "64x48", "-o", out_ / "file", "--json"}).out);
    EXPECT_EQ(printed["steps"].size(), 2U);
    // A folder that cannot be made leaves nothing behind.
    write_file_atomically(out_ / "blocked", "");
    EXPECT_EQ(run({"compare", file, "--size", "64x48", "-o", out_ / "blocked"}).status, 2);
}

TEST_F(Cli, ReadsTheStepThatIsChosen) {
    std::string text = kScene;
    text += R"(#pragma twinlight step("One light")
glEnable(GL_LIGHT1);
#pragma twinlight step("Two lights")
glEnable(GL_LIGHT2);
)";
    const std::string file = scene(text);
    const std::string two = run({"export", file, "--as", "scene", "--step", "2"}).out;
    EXPECT_NE(two.find("GL_LIGHT2"), std::string::npos) << two;
    EXPECT_EQ(two.find("GL_LIGHT1"), std::string::npos) << two;
    EXPECT_EQ(run({"export", file, "--as", "scene", "--step", "Two lights"}).out, two);
    EXPECT_NE(run({"explain", file, "--step", "2"}).out.find("scene.gl, step 2: Two lights"), std::string::npos);
    // Each command that takes a scene reads the step, and refuses one that is not there.
    const std::string missing = "this scene has no step '3'; its steps are 1 \"One light\", 2 \"Two lights\"";
    for (const std::vector<std::string>& command :
         std::vector<std::vector<std::string>>{{"render", file, "--with", "reference", "-o", out_ / "p.png"},
                                               {"compare", file, "-o", out_ / "report"},
                                               {"explain", file},
                                               {"export", file, "--as", "c"},
                                               {"lint", file},
                                               {"study", file, "-o", out_ / "study"}}) {
        std::vector<std::string> with_step = command;
        with_step.insert(with_step.end(), {"--step", "3"});
        SCOPED_TRACE(command[0]);
        expect_refused(run(with_step), missing);
    }
    expect_refused(run({"explain", "normals", "--step", "1"}), "normals.gl: this scene has no steps; leave out --step");
    expect_refused(run({"explain", file, "--step", ""}), "--step");
}

TEST_F(Cli, ExplainsAPixelWithTheFormulasOfTheLecturesVariants) {
    struct Formulas {
        const char *pragma, *ambient, *specular, *ambient_rows, *specular_rows;
    };
    for (const Formulas& expected : {
             Formulas{"", "att spot a_cm a_cli", "att spot f(n.h)^s s_cm s_cli",
                      "att spot a_cm a_cli\n                 1.00000 x 1.00000 x (0.2",
                      "att spot f(n.h)^s s_cm s_cli\n                 1.00000 x 1.00000 x 1.00000 x (0 0 0)"},
             Formulas{"#pragma twinlight specular(reflection)\n", "att spot a_cm a_cli", "att spot (r.v)^s s_cm s_cli",
                      "att spot a_cm a_cli\n                 1.00000 x 1.00000 x (0.2",
                      "att spot (r.v)^s s_cm s_cli\n                 1.00000 x 1.00000 x 1.00000 x (0 0 0)"},
             Formulas{"#pragma twinlight ambient(unattenuated)\n", "a_cm a_cli", "att spot f(n.h)^s s_cm s_cli",
                      "a_cm a_cli\n                 (0.2", "att spot f(n.h)^s s_cm s_cli\n                 1.00000"},
         }) {
        const std::string file = scene(expected.pragma + std::string(kLamps));
        const json pixel =
            json::parse(run({"explain", file, "--variants", "--size", "20x20", "--pixel", "3,5", "--json"}).out);
        const json& formulas = pixel["fragments"][0]["lights"][0]["formulas"];
        EXPECT_EQ(formulas["ambient"], expected.ambient) << expected.pragma;
        EXPECT_EQ(formulas["diffuse"], "att spot n.VP d_cm d_cli") << expected.pragma;
        EXPECT_EQ(formulas["specular"], expected.specular) << expected.pragma;

        const std::string text = run({"explain", file, "--variants", "--size", "20x20", "--pixel", "3,5", "--all"}).out;
        for (const char* rows :
             {expected.ambient_rows, expected.specular_rows, "att spot n.VP d_cm d_cli\n                 1.00000 x"})
            EXPECT_NE(text.find(rows), std::string::npos) << rows << "\n" << text;
    }
}

}  // namespace
}  // namespace twinlight::cli_test
