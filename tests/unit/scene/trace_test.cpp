// Reading recorded programs: apitrace's dumps, call by call and frame by frame.
#include "scene/trace/trace.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "../run_program.h"
#include "base/image/file.h"
#include "scene/command/text.h"
#include "scene/recorded/recorded_frame.h"
#include "scene/scenes/load.h"
#include "scene/trace/blobs.h"

namespace twinlight::trace_test {

namespace {

class Traces : public testing::Test {
  protected:
    std::shared_ptr<const Recording> recording(const std::string& text) {
        write_file_atomically(folder_ / "dump.txt", text);
        return load_recording(folder_ / "dump.txt");
    }
    // The steps, one line each: commands as C, "end of frame", "outside: ...", "cut off: ...".
    std::vector<std::string> steps(const std::string& text) {
        std::vector<std::string> lines;
        recording(text)->for_each([&](const Step& step) {
            switch (step.kind) {
                case Step::Kind::kCommand: lines.push_back(print_command(step.command)); break;
                case Step::Kind::kFrameEnd: lines.emplace_back("end of frame"); break;
                case Step::Kind::kOutside: lines.push_back("outside: " + std::string(step.text)); break;
                case Step::Kind::kElsewhere: lines.push_back("elsewhere: " + std::string(step.text)); break;
                case Step::Kind::kCutOff: lines.push_back("cut off: " + std::string(step.text)); break;
            }
            return true;
        });
        return lines;
    }
    std::string refusal(const std::string& text) {
        try {
            steps(text);
        } catch (const SceneError& error) {
            const std::string what = error.what();
            return what.substr(std::min(what.find("dump.txt"), what.size()));
        }
        return "no error";
    }
    RecordedFrame frame(const std::string& text, std::optional<int> number = std::nullopt) {
        return make_recorded_frame(recording(text), {.number = number});
    }

    TemporaryFolder folder_;
};

using Lines = std::vector<std::string>;

// ---- Calls ----

TEST_F(Traces, AreReadCallByCall) {
    EXPECT_EQ(
        steps("// process.name = \"/usr/bin/gears\"\n"
              "3 glViewport(x = 0, y = 0, width = 300, height = 200) // fake\n"
              "9 @0 glLightfv(light = GL_LIGHT0, pname = GL_POSITION, params = {5, 5.25, 1e-05, 0})\n"
              "10 glMaterialf(face = GL_FRONT, pname = GL_SHININESS, param = 20)\n"
              "11 glClear(mask = GL_DEPTH_BUFFER_BIT | GL_COLOR_BUFFER_BIT)\n"
              "12 glColor4ub(red = 12, green = 200, blue = 3, alpha = 255)\n"
              "13 glDepthMask(flag = GL_TRUE)\n"
              "14 glXSwapBuffers(dpy = 0x1, drawable = 2)\n\n"
              "15 glLightfv(light = GL_LIGHT0, pname = GL_SPOT_CUTOFF, params = &45)\n"),
        (Lines{"glViewport(0, 0, 300, 200);", "glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){5, 5.25, 1e-05, 0});",
               "glMaterialf(GL_FRONT, GL_SHININESS, 20);", "glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);",
               "glColor4ub(12, 200, 3, 255);", "glDepthMask(GL_TRUE);", "end of frame",
               "glLightfv(GL_LIGHT0, GL_SPOT_CUTOFF, (GLfloat[]){45});"}));
}

TEST_F(Traces, AreReadWithoutNumbersAndWithoutNamesOfArguments) {
    EXPECT_EQ(steps("// process.name = \"a\"\nglBegin(GL_POINTS)\nglVertex2f(0.5, -0)\r\nglEnd()\n"),
              (Lines{"glBegin(GL_POINTS);", "glVertex2f(0.5, -0.0);", "glEnd();"}));
}

TEST_F(Traces, TakeTheNamesOfExtensionsAndOfLaterVersionsForTheCommandsTheyAre) {
    EXPECT_EQ(
        steps("1 glActiveTextureARB(texture = GL_TEXTURE1)\n"
              "2 glEnable(cap = GL_CLIP_DISTANCE2)\n"
              "3 glTexParameteri(target = GL_TEXTURE_2D, pname = GL_TEXTURE_WRAP_S, param = GL_CLAMP_TO_EDGE_EXT)\n"),
        (Lines{"glActiveTexture(GL_TEXTURE1);", "glEnable(GL_CLIP_PLANE2);",
               "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);"}));
}

TEST_F(Traces, PassOverWhatChangesNoPixelAndNameWhatTheyDoNotKnow) {
    EXPECT_EQ(steps("1 glGetString(name = GL_VERSION) = \"4.5 (Compatibility)\"\n"
                    "2 glXChooseVisual(dpy = 0x1, screen = 0, attribList = {4, 8, 9}) = &{visual = 0x2, visualid = 3}\n"
                    "3 glUseProgram(program = 0)\n"
                    "4 glUseProgram(program = 7)\n"
                    "5 glDrawArraysInstanced(mode = GL_TRIANGLES, first = 0, count = 3, instancecount = 2)\n"
                    "6 glHint(target = GL_FRAGMENT_SHADER_DERIVATIVE_HINT_XYZ, mode = GL_NICEST)\n"),
              (Lines{"outside: glUseProgram", "outside: glDrawArraysInstanced"}));
}

// What GL refuses, and messages for debuggers, make no frame partial.
TEST_F(Traces, PassOverWhatGlRefusesAndWhatIsForDebuggers) {
    EXPECT_EQ(steps("1 glEnable(cap = GL_DEBUG_OUTPUT)\n"
                    "2 glEnable(cap = GL_DEBUG_OUTPUT_SYNCHRONOUS)\n"
                    "3 glShadeModel(mode = GL_NO_SUCH_MODEL)\n"
                    "4 glEnable(cap = GL_FRAMEBUFFER_SRGB_XYZ)\n"),
              (Lines{"outside: glEnable(GL_FRAMEBUFFER_SRGB_XYZ)"}));
}

// The bias of the extension is a depth: 1 / (2^24 - 1) is one step.
TEST_F(Traces, ReadThePolygonOffsetOfTheExtension) {
    EXPECT_EQ(steps("1 glPolygonOffsetEXT(factor = 1.5, bias = 0)\n2 glPolygonOffsetEXT(factor = 0, bias = -1)\n"),
              (Lines{"glPolygonOffset(1.5, 0);", "glPolygonOffset(0, -16777215);"}));
}

TEST_F(Traces, HoldTheNamesThatADriverGave) {
    EXPECT_EQ(steps("1 glGenLists(range = 3) = 17\n2 glGenTextures(n = 2, textures = {4, 9})\n"
                    "3 glDeleteTextures(n = 1, textures = &4)\n"),
              (Lines{"glGenLists(3);", "glGenTextures(2, (GLuint[]){4, 9});", "glDeleteTextures(1, (GLuint[]){4});"}));
}

TEST_F(Traces, ReadTheMemoryOfArraysFromBlobs) {
    write_file_atomically(folder_ / "blob_call1.bin", std::string("\x01\x02\x03\xff", 4));
    const auto list = recording(
        "1 glColorPointer(size = 4, type = GL_UNSIGNED_BYTE, stride = 0, pointer = blob(\"blob_call1.bin\")) // fake\n"
        "2 glVertexPointer(size = 3, type = GL_FLOAT, stride = 12, pointer = 0x18)\n"
        "3 glNormalPointer(type = GL_FLOAT, stride = 0, pointer = NULL)\n");
    std::vector<Command> commands;
    list->for_each([&](const Step& step) {
        commands.push_back(step.command);
        return true;
    });
    ASSERT_EQ(commands.size(), 3u);
    ASSERT_TRUE(commands[0].memory);
    EXPECT_EQ(commands[0].memory->bytes, (std::vector{std::byte{1}, std::byte{2}, std::byte{3}, std::byte{255}}));
    EXPECT_EQ(commands[0].arguments.back(), 0);
    EXPECT_FALSE(commands[1].memory);
    EXPECT_EQ(commands[1].arguments.back(), 24);  // in the buffer object that is bound
    EXPECT_EQ(commands[2].arguments.back(), 0);
}

// Also by the extension that became a part of GL 1.2.
TEST_F(Traces, HaveTexturesOfThreeDimensions) {
    write_file_atomically(folder_ / "layers.bin", std::string("\x0a\x14\x1e\x28", 4));
    const auto list = recording(
        "1 glViewport(x = 0, y = 0, width = 32, height = 24)\n2 glPixelStorei(pname = GL_UNPACK_ALIGNMENT, param = 1)\n"
        "3 glTexImage3DEXT(target = GL_TEXTURE_3D, level = 0, internalformat = GL_LUMINANCE, width = 2, height = 1, "
        "depth = 2, "
        "border = 0, format = GL_LUMINANCE, type = GL_UNSIGNED_BYTE, pixels = blob(\"layers.bin\"))\n"
        "4 glTexParameteri(target = GL_TEXTURE_3D, pname = GL_TEXTURE_MIN_FILTER, param = GL_NEAREST)\n"
        "5 glEnable(cap = GL_TEXTURE_3D)\n6 glRectf(x1 = -1, y1 = -1, x2 = 1, y2 = 1)\n"
        "7 glXSwapBuffers(dpy = 0x1, drawable = 2)\n");
    const Frame frame = make_recorded_frame(list, {}).scene.frame;
    EXPECT_TRUE(frame.unsupported.empty());
    ASSERT_EQ(frame.draws().size(), 1u);
    ASSERT_TRUE(frame.draws()[0]->texture.texture);
    const TextureImage& image = frame.draws()[0]->texture.texture->levels.at(0);
    EXPECT_EQ(image.depth, 2);
    EXPECT_FLOAT_EQ(255 * image.texel(1, 0, 0).r, 20);
    EXPECT_FLOAT_EQ(255 * image.texel(0, 0, 1).r, 30);
}

// As glutBitmapCharacter and the usual display list for each letter record it.
TEST_F(Traces, HaveTextOfBitmaps) {
    write_file_atomically(folder_ / "letter.bin", std::string("\x80\xC0", 2));
    write_file_atomically(folder_ / "text.bin", "AA");
    const auto list = recording(
        "1 glViewport(x = 0, y = 0, width = 32, height = 24)\n"
        "2 glPixelStorei(pname = GL_UNPACK_ALIGNMENT, param = 1)\n"
        "3 glNewList(list = 1065, mode = GL_COMPILE)\n"
        "4 glBitmap(width = 2, height = 2, xorig = 0, yorig = 0, xmove = 3, ymove = 0, bitmap = blob(\"letter.bin\"))\n"
        "5 glEndList()\n6 glListBase(base = 1000)\n7 glRasterPos2f(x = 0.03, y = 0.03)\n"
        "8 glCallLists(n = 2, type = GL_UNSIGNED_BYTE, lists = blob(\"text.bin\"))\n"
        "9 glXSwapBuffers(dpy = 0x1, drawable = 2)\n");
    const Frame frame = make_recorded_frame(list, {}).scene.frame;
    EXPECT_EQ(std::pair(frame.width, frame.height), std::pair(32, 24));
    EXPECT_TRUE(frame.unsupported.empty());
    ASSERT_EQ(frame.draws().size(), 2u);
    ASSERT_TRUE(frame.draws()[1]->pixels);
    EXPECT_EQ(frame.draws()[1]->pixels->places, (std::vector<glm::ivec2>{{19, 12}, {19, 13}, {20, 13}}));
}

// The tracer records a program's writes to a mapped buffer as memcpy.
TEST_F(Traces, TakeWritesToMappedBuffersForGlBufferSubData) {
    write_file_atomically(folder_ / "blob_call3.bin", "abcd");
    EXPECT_EQ(steps("1 glBindBuffer(target = GL_ARRAY_BUFFER, buffer = 1)\n"
                    "2 glMapBuffer(target = GL_ARRAY_BUFFER, access = GL_WRITE_ONLY) = 0x1000\n"
                    "3 memcpy(dest = 0x1008, src = blob(\"blob_call3.bin\"), n = 4)\n")
                  .back(),
              "glBufferSubData(GL_ARRAY_BUFFER, 8, 4, (const GLubyte[]){97, 98, 99, 100});");
}

// ---- Contexts ----

// One window draws a label, then the other a triangle.
constexpr const char* kTwoWindows =
    "1 @0 glXMakeCurrent(dpy = 0x1, drawable = 2, ctx = 0xa) = True\n2 @0 glEnable(cap = GL_LIGHT0)\n"
    "3 @1 glXMakeCurrent(dpy = 0x1, drawable = 3, ctx = 0xb) = True\n4 @1 glEnable(cap = GL_LIGHT1)\n"
    "5 @0 glBegin(mode = GL_POINTS)\n6 @0 glVertex2f(x = 0, y = 0)\n7 @0 glEnd()\n"
    "8 @1 glNewList(list = 1, mode = GL_COMPILE)\n9 @1 glVertex2f(x = 1, y = 0)\n10 @1 glVertex2f(x = 2, y = 0)\n"
    "11 @1 glEndList()\n12 @1 glCallList(list = 1)\n13 @0 glEnable(cap = GL_LIGHT2)\n";

TEST_F(Traces, FollowTheContextThatDrawsMost) {
    EXPECT_EQ(steps(kTwoWindows), (Lines{"glEnable(GL_LIGHT1);", "glNewList(1, GL_COMPILE);", "glVertex2f(1, 0);",
                                         "glVertex2f(2, 0);", "glEndList();", "glCallList(1);"}));
    EXPECT_EQ(
        recording(kTwoWindows)->notes(),
        Lines{"context 1 draws 2 vertices, context 0 draws 1 vertex; this is context 1, --context N chooses another"});
    // What shaders draw counts less than anything that the fixed function draws.
    const std::string with_shaders =
        std::string(kTwoWindows).replace(std::string(kTwoWindows).find("8 @1"), 0, "7 @1 glUseProgram(program = 1)\n");
    EXPECT_EQ(steps(with_shaders).front(), "glEnable(GL_LIGHT0);");
    EXPECT_EQ(recording(with_shaders)->notes(),
              Lines{"context 0 draws 1 vertex, context 1 draws 2 vertices with shaders; this is context 0, --context N "
                    "chooses another"});
    // What a list holds counts only when it is called.
    const std::string uncalled = std::string(kTwoWindows).replace(std::string(kTwoWindows).find("12 @1"), 29, "");
    EXPECT_EQ(steps(uncalled).front(), "glEnable(GL_LIGHT0);");
    EXPECT_EQ(recording(uncalled)->notes(), Lines{});
}

TEST_F(Traces, SayThatArraysOfElementsAreNotRecorded) {
    const std::string context = "1 glXMakeCurrent(dpy = 0x1, drawable = 2, ctx = 0xa) = True\n";
    const std::string draws = "3 glBegin(mode = GL_POINTS)\n4 glArrayElement(i = 0)\n5 glEnd()\n";
    ASSERT_EQ(recording(context + draws)->notes().size(), 1u);
    EXPECT_TRUE(
        recording(context + draws)->notes()[0].starts_with("apitrace does not record the arrays that glArrayElement"));
    EXPECT_EQ(recording(context + "2 glBindBuffer(target = GL_ARRAY_BUFFER, buffer = 1)\n" + draws)->notes(), Lines{});
    EXPECT_EQ(recording(context + "3 glBegin(mode = GL_POINTS)\n4 glVertex2f(x = 0, y = 0)\n5 glEnd()\n")->notes(),
              Lines{});
}

// Formats are chosen by calls as apitrace prints them; two contexts are made with them, of which the second draws.
TEST_F(Traces, SayThatAWindowHasSeveralSamples) {
    const std::string draws =
        "8 glXMakeCurrent(dpy = 0x1, drawable = 2, ctx = 0xb) = True\n9 glBegin(mode = GL_POINTS)\n"
        "10 glVertex2f(x = 0, y = 0)\n11 glEnd()\n";
    const auto notes = [&](const std::string& calls) { return recording(calls + draws)->notes(); };
    const auto config = [](const std::string& attributes) {
        return "1 glXChooseFBConfig(dpy = 0x1, screen = 0, attribList = {GLX_RED_SIZE, 1, GLX_DOUBLEBUFFER, True, " +
               attributes + "0}, nitems = &2) = {0x70, 0x80}\n";
    };
    const std::string visual =
        "&{visual = 0x55a1, visualid = 992, screen = 0, depth = 24, c_class = 4, red_mask = 16711680}";
    const auto create = [](const std::string& format) {
        return "4 glXCreateNewContext(dpy = 0x1, config = " + format +
               ", renderType = GLX_RGBA_TYPE, shareList = NULL, direct = True) = 0xb\n";
    };
    const auto choose = [&](const std::string& attributes) {
        return "2 glXChooseVisual(dpy = 0x1, screen = 0, attribList = {GLX_RGBA, " + attributes + "0}) = " + visual +
               "\n";
    };
    const std::string of_visual =
        "5 glXCreateContext(dpy = 0x1, vis = " + visual + ", shareList = NULL, direct = True) = 0xb\n";
    const auto egl = [](const std::string& samples) {
        return "3 eglChooseConfig(dpy = 0x1, attrib_list = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_SAMPLES, " +
               samples +
               ", EGL_NONE}, configs = {0x70}, config_size = 1, num_config = &1) = EGL_TRUE\n"
               "4 eglCreateContext(dpy = 0x1, config = 0x70, share_context = NULL, attrib_list = {}) = 0xb\n";
    };
    const Lines yes{std::string(kOneSampleNote)}, no;
    EXPECT_EQ(notes(config("GLX_SAMPLE_BUFFERS, 1, GLX_SAMPLES, 4, ") + create("0x80")), yes);
    EXPECT_EQ(notes(config("GLX_SAMPLE_BUFFERS, 1, ") + create("0x80")), yes);
    EXPECT_EQ(notes(choose("GLX_SAMPLES, 4, ") + of_visual), yes);
    EXPECT_EQ(notes(config("GLX_SAMPLES, 4, ") + "3 glXGetVisualFromFBConfig(dpy = 0x1, config = 0x70) = " + visual +
                    "\n" + of_visual),
              yes);
    EXPECT_EQ(notes(egl("4")), yes);

    EXPECT_EQ(notes(config("GLX_SAMPLE_BUFFERS, 0, GLX_SAMPLES, 1, ") + create("0x80")), no);
    EXPECT_EQ(notes(config("GLX_SAMPLES, 4, ") + create("0x90")), no) << "another format";
    EXPECT_EQ(notes(config("GLX_SAMPLES, 4, ") + "4 glXCreateNewContext(dpy = 0x1, config = 0x80, renderType = "
                                                 "GLX_RGBA_TYPE, shareList = NULL, direct = True) = 0xa\n"),
              no)
        << "another context";
    EXPECT_EQ(notes(choose("") + of_visual), no);
    EXPECT_EQ(notes("2 glXChooseVisual(dpy = 0x1, screen = 0, attribList = {GLX_SAMPLES, 4, 0}) = NULL\n" + of_visual),
              no)
        << "there was no such format";
    EXPECT_EQ(notes(egl("0")), no);
    EXPECT_EQ(notes("2 glXChooseVisual(GLX_SAMPLES, ,) = 4\n" + create("0x80")), no) << "a call that cannot be read";
}

TEST_F(Traces, FollowTheContextThatIsChosen) {
    recording(kTwoWindows);
    const auto first = load_recording(folder_ / "dump.txt", std::nullopt, {}, 0);
    Lines lines;
    first->for_each([&](const Step& step) {
        if (step.kind == Step::Kind::kCommand) lines.push_back(print_command(step.command));
        return true;
    });
    EXPECT_EQ(lines, (Lines{"glEnable(GL_LIGHT0);", "glBegin(GL_POINTS);", "glVertex2f(0, 0);", "glEnd();",
                            "glEnable(GL_LIGHT2);"}));
    try {
        load_recording(folder_ / "dump.txt", std::nullopt, {}, 2);
        ADD_FAILURE() << "there is no context 2";
    } catch (const SceneError& error) {
        EXPECT_TRUE(std::string(error.what()).ends_with("the recording has no context 2; its contexts are 0 to 1"))
            << error.what();
    }
}

// An object that another context makes is missing only if the two share objects, and if the frame shows it.
TEST_F(Traces, NameObjectsOfOtherContextsThatAFrameShows) {
    constexpr const char *kDraw =
                             "19 glClear(mask = GL_COLOR_BUFFER_BIT)\n20 glRecti(x1 = 0, y1 = 0, x2 = 1, y2 = 1)\n",
                         *kEnd = "21 glXSwapBuffers(dpy = 0x1, drawable = 2)\n",
                         *kOther = "22 glXMakeCurrent(dpy = 0x1, drawable = 2, ctx = 0xb) = True\n",
                         *kBack = "23 glXMakeCurrent(dpy = 0x1, drawable = 2, ctx = 0xa) = True\n";
    const auto in_frame = [this](int number, const std::string& share, const std::string& made,
                                 const std::string& used) {
        const RecordedFrame made_frame = frame(
            "1 glXCreateContext(dpy = 0x1, vis = &{visualid = 3}, shareList = NULL, direct = True) = 0xa\n"
            "2 glXCreateContext(dpy = 0x1, vis = &{visualid = 3}, shareList = " +
                share + ", direct = True) = 0xb\n" + kOther + made + kBack + used + kDraw + kEnd,
            number);
        return std::ranges::count_if(made_frame.scene.frame.unsupported, [](const Unsupported& unsupported) {
            return unsupported.name.ends_with("in context 0");
        });
    };
    const auto of_other = [&](const std::string& share, const std::string& made, const std::string& used) {
        return in_frame(0, share, made, used);
    };
    const std::string list = "4 glNewList(list = 1, mode = GL_COMPILE)\n5 glEndList()\n";
    const auto call = [](int name) { return fmt::format("9 glCallList(list = {})\n", name); };
    EXPECT_EQ(of_other("0xa", list, call(1)), 1);
    EXPECT_EQ(of_other("0xc", list, call(1)), 1);  // not known
    EXPECT_EQ(of_other("NULL", list, call(1)), 0);
    EXPECT_EQ(of_other("0xa", list, call(1) + call(1)), 1) << "once for each object";
    EXPECT_EQ(of_other("0xa", list, call(2)), 0);
    write_file_atomically(folder_ / "two.bin", "\x02");
    const std::string call_two = "9 glCallLists(n = 1, type = GL_UNSIGNED_BYTE, lists = blob(\"two.bin\"))\n";
    EXPECT_EQ(of_other("0xa", list, call_two), 0);
    EXPECT_EQ(of_other("0xa", "4 glNewList(list = 2, mode = GL_COMPILE)\n5 glEndList()\n", call_two), 1);
    EXPECT_EQ(of_other("0xa", list, "9 glNewList(list = 1, mode = GL_COMPILE)\n10 glEndList()\n" + call(1)), 0);
    EXPECT_EQ(in_frame(1, "0xa", list, call(1) + kDraw + kEnd), 0) << "only the first frame shows it";

    const std::string image =
        "glTexImage1D(target = GL_TEXTURE_1D, level = 0, internalformat = GL_RGB, width = 1, border = 0, format = "
        "GL_RGB, type = GL_UNSIGNED_BYTE, pixels = NULL)\n";
    const auto bind = [](int name) {
        return fmt::format("9 glBindTexture(target = GL_TEXTURE_1D, texture = {})\n", name);
    };
    const std::string enable = "10 glEnable(cap = GL_TEXTURE_1D)\n";
    EXPECT_EQ(of_other("0xa", bind(5) + "5 " + image, enable + bind(5)), 1);
    EXPECT_EQ(of_other("0xa", bind(5) + "5 " + image, bind(5)), 0) << "bound, but not shown";
    EXPECT_EQ(of_other("0xa", bind(5) + "5 " + image, enable + bind(6)), 0);
    EXPECT_EQ(of_other("NULL", bind(5) + "5 " + image, enable + bind(5)), 0);
    EXPECT_EQ(of_other("0xa", "5 " + image, ""), 1) << "of no known texture";
    // A texture that is bound already changes at once.
    const std::string later = enable + bind(5) + kDraw + kEnd + kOther + bind(5) + "11 " + image + kBack;
    EXPECT_EQ(in_frame(0, "0xa", "", later), 0);
    EXPECT_EQ(in_frame(1, "0xa", "", later), 1);

    const std::string buffer =
        "4 glBindBuffer(target = GL_ARRAY_BUFFER, buffer = 3)\n5 glBufferData(target = "
        "GL_ARRAY_BUFFER, size = 8, data = NULL, usage = GL_STATIC_DRAW)\n";
    const auto use = [](int name) {
        return fmt::format(
            "9 glBindBuffer(target = GL_ARRAY_BUFFER, buffer = {})\n"
            "10 glVertexPointer(size = 2, type = GL_FLOAT, stride = 0, pointer = NULL)\n"
            "11 glEnableClientState(array = GL_VERTEX_ARRAY)\n",
            name);
    };
    const std::string draw = "12 glDrawArrays(mode = GL_POINTS, first = 0, count = 1)\n";
    EXPECT_EQ(of_other("0xa", buffer, use(3) + draw), 1);
    EXPECT_EQ(of_other("0xa", buffer, use(3)), 0);
    EXPECT_EQ(of_other("0xa", buffer, use(4) + draw), 0);
}

// A widget: context 0xa draws into an object, context 0xb shows it with shaders. The object changes with the widget's size.
TEST_F(Traces, ReadAnObjectThatIsShownAsTheWindow) {
    const auto current = [](const std::string& context) {
        return "1 glXMakeCurrent(dpy = 0x1, drawable = 2, ctx = " + context + ") = True\n";
    };
    const auto make = [](int name) {
        return fmt::format(
            "2 glBindFramebuffer(target = GL_FRAMEBUFFER, framebuffer = {})\n"
            "3 glFramebufferTexture2D(target = GL_FRAMEBUFFER, attachment = GL_COLOR_ATTACHMENT0, textarget = "
            "GL_TEXTURE_2D, "
            "texture = 9, level = 0)\n"
            "4 glFramebufferRenderbuffer(target = GL_FRAMEBUFFER, attachment = GL_DEPTH_ATTACHMENT, renderbuffertarget "
            "= "
            "GL_RENDERBUFFER, renderbuffer = 1)\n"
            "5 glDrawBuffer(mode = GL_COLOR_ATTACHMENT0)\n",
            name);
    };
    const std::string draw = "6 glRecti(x1 = 0, y1 = 0, x2 = 1, y2 = 1)\n";
    const std::string compose = current("0xb") + "7 glUseProgram(program = 1)\n" +
                                "8 glDrawArrays(mode = GL_TRIANGLES, first = 0, count = 6)\n"
                                "9 glXSwapBuffers(dpy = 0x1, drawable = 2)\n";
    const std::string widget = current("0xa") + make(1) + draw + compose + current("0xa") + make(2) + draw + compose;
    const Lines picture{"glBindFramebuffer(GL_FRAMEBUFFER, 0);", "glRecti(0, 0, 1, 1);", "end of frame"};
    Lines twice = picture;
    twice.insert(twice.end(), picture.begin(), picture.end());
    EXPECT_EQ(steps(widget), twice);
    EXPECT_EQ(
        recording(widget)->notes(),
        (Lines{"the program draws into a framebuffer object, as widgets of Qt and GTK do; the picture is what it shows",
               "context 0 draws 2 vertices, context 1 draws 12 vertices with shaders; this is context 0, --context N "
               "chooses another"}));

    // With samples, which are resolved into another object.
    const std::string samples =
        "4 glRenderbufferStorageMultisample(target = GL_RENDERBUFFER, samples = 4, internalformat = GL_RGBA8, width = "
        "8, "
        "height = 8)\n";
    const auto blit = [](int from, int to) {
        return fmt::format(
            "7 glBindFramebuffer(target = GL_READ_FRAMEBUFFER, framebuffer = {})\n"
            "8 glBindFramebuffer(target = GL_DRAW_FRAMEBUFFER, framebuffer = {})\n"
            "9 glBlitFramebuffer(srcX0 = 0, srcY0 = 0, srcX1 = 8, srcY1 = 8, dstX0 = 0, dstY0 = 0, dstX1 = 8, dstY1 = "
            "8, "
            "mask = GL_COLOR_BUFFER_BIT, filter = GL_NEAREST)\n",
            from, to);
    };
    const std::string swap = "10 glXSwapBuffers(dpy = 0x1, drawable = 2)\n";
    const std::string smooth = current("0xa") + make(1) + samples + draw + blit(1, 0) + swap;
    EXPECT_EQ(steps(smooth),
              (Lines{"glBindFramebuffer(GL_FRAMEBUFFER, 0);", "glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 8, 8);",
                     "glRecti(0, 0, 1, 1);", "glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);",
                     "glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);", "end of frame"}));
    EXPECT_EQ(recording(smooth)->notes().back(), kOneSampleNote);

    EXPECT_EQ(recording(current("0xa") + samples + draw)->notes(), Lines{}) << "drawn into the window";

    // A program that also draws into its window has an object of its own.
    EXPECT_EQ(steps(current("0xa") + draw + make(1) + draw + swap)[1], "glBindFramebuffer(GL_FRAMEBUFFER, 1);");
}

// glBlitFramebuffer from one texture to another.
TEST_F(Traces, ReadCopiesBetweenObjects) {
    const auto copy = [this](const std::string& rectangles, const std::string& mask) {
        const std::string attach =
            "3 glFramebufferTexture2D(target = GL_DRAW_FRAMEBUFFER, attachment = GL_COLOR_ATTACHMENT0, textarget = "
            "GL_TEXTURE_2D, texture = 7, level = 0)\n";
        const Lines lines = steps(
            "0 glRecti(x1 = 0, y1 = 0, x2 = 1, y2 = 1)\n1 glBindFramebuffer(target = GL_READ_FRAMEBUFFER, framebuffer "
            "= 1)\n"
            "2 glBindFramebuffer(target = GL_DRAW_FRAMEBUFFER, framebuffer = 2)\n" +
            attach + "4 glBlitFramebufferEXT(" + rectangles + ", mask = " + mask + ", filter = GL_NEAREST)\n");
        return Lines(lines.begin() + 4, lines.end());
    };
    const std::string from = "srcX0 = 1, srcY0 = 2, srcX1 = 9, srcY1 = 8, ", color = "GL_COLOR_BUFFER_BIT";
    const std::string same_size = from + "dstX0 = 3, dstY0 = 4, dstX1 = 11, dstY1 = 10";
    EXPECT_EQ(copy(same_size, color),
              (Lines{"glPushAttrib(GL_TEXTURE_BIT);", "glBindTexture(GL_TEXTURE_2D, 7);",
                     "glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 3, 4, 1, 2, 8, 6);", "glPopAttrib();"}));
    const Lines lacking{"outside: glBlitFramebufferEXT"};
    EXPECT_EQ(copy(same_size, "GL_DEPTH_BUFFER_BIT"), lacking);
    EXPECT_EQ(copy(from + "dstX0 = 0, dstY0 = 0, dstX1 = 16, dstY1 = 6", color), lacking) << "scaled";
    EXPECT_EQ(copy(from + "dstX0 = 8, dstY0 = 0, dstX1 = 0, dstY1 = 6", color), lacking) << "mirrored";
}

// Of texture units that only shaders have, the state is passed over until another unit is chosen.
TEST_F(Traces, PassOverTheStateOfUnitsForShaders) {
    for (const std::string unit : {"GL_TEXTURE8", "GL_MAX_TEXTURE_UNITS", "GL_VARIABLE_A_NV", "34043"}) {
        const std::string bias =
            "2 glTexEnvf(target = GL_TEXTURE_FILTER_CONTROL, pname = GL_TEXTURE_LOD_BIAS, param = 1)\n";
        EXPECT_EQ(steps("1 glActiveTexture(texture = " + unit + ")\n" + bias +
                        "3 glBindTexture(target = GL_TEXTURE_2D, texture = 4)\n4 glDisable(cap = GL_TEXTURE_2D)\n"
                        "5 glEnable(cap = GL_TEXTURE_GEN_S)\n"
                        "5 glEnable(cap = GL_LIGHTING)\n6 glActiveTexture(texture = GL_TEXTURE7)\n" +
                        bias),
                  (Lines{"glEnable(GL_LIGHTING);", "glActiveTexture(GL_TEXTURE7);",
                         "glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, 1);"}))
            << unit;
    }
    EXPECT_EQ(steps("1 glActiveTexture(texture = GL_LIGHT0)\n"), Lines{"glActiveTexture(GL_LIGHT0);"});
}

TEST_F(Traces, EnableArraysAsExtVertexArrayDoes) {
    EXPECT_EQ(steps("1 glEnable(cap = GL_VERTEX_ARRAY)\n2 glDisable(cap = GL_EDGE_FLAG_ARRAY)\n"),
              (Lines{"glEnableClientState(GL_VERTEX_ARRAY);", "glDisableClientState(GL_EDGE_FLAG_ARRAY);"}));
}

// ---- Errors ----

TEST_F(Traces, TellWhereTheyEndInsideACall) {
    for (const char* end : {"3 glVertex2f(x = 1,", "3 glVertex2f(x = 1, y = 2", "3 glVer", "3 "}) {
        SCOPED_TRACE(end);
        const Lines lines = steps("1 glBegin(mode = GL_POINTS)\n" + std::string(end));
        EXPECT_EQ(lines.front(), "glBegin(GL_POINTS);");
        EXPECT_LE(lines.size(), 2u);
    }
    EXPECT_EQ(steps("1 glFlush()\n2 glVertex2f(x = 1,").back(), "cut off: the recording ends inside call 2");
}

TEST_F(Traces, RefuseWhatIsNoDumpWithItsLine) {
    EXPECT_EQ(
        refusal("1 glFlush()\nhello\n"),
        "dump.txt:2:1: expected a call as apitrace prints it, such as '9 glEnable(cap = GL_LIGHT0)', found 'hello'");
    EXPECT_EQ(refusal("1 glFlush()\n2 \x1b[1mglFlush\x1b[0m()\n"),
              "dump.txt:2:1: this dump contains colour codes; create it with 'apitrace dump --color=never'");
}

TEST_F(Traces, RefuseArgumentsThatGlCouldNotHaveBeenGiven) {
    const std::vector<std::pair<std::string, std::string>> cases = {
        {"1 glVertex2f(x = 1)", "glVertex2f takes 2 arguments"},
        {"1 glColor3ub(red = 300, green = 0, blue = 0)", "red of glColor3ub is 300; it must be from 0 to 255"},
        {"1 glVertex2i(x = 0.5, y = 1)", "x of glVertex2i must be a whole number, not 0.5"},
        {"1 glLightfv(light = GL_LIGHT0, pname = GL_POSITION, params = {1, 2, 3})", "has 3 values, but 4 are needed"},
        {"1 glVertexPointer(size = 3, type = GL_FLOAT, stride = 0, pointer = blob(36))",
         "create the dump with 'apitrace dump --blobs'"},
    };
    for (const auto& [call, expected] : cases) {
        const std::string found = refusal(call + "\n");
        EXPECT_NE(found.find(expected), std::string::npos) << call << ": " << found;
        EXPECT_TRUE(found.starts_with("dump.txt: call 1: ")) << found;
    }
}

TEST_F(Traces, RefuseNamesThatNoGluintHolds) {
    EXPECT_EQ(refusal("1 glBindTexture(target = GL_TEXTURE_2D, texture = -1)\n"),
              "dump.txt: call 1: texture of glBindTexture is -1; it must be from 0 to 4294967295");
    EXPECT_EQ(refusal("1 glCallList(list = 1e15)\n"),
              "dump.txt: call 1: list of glCallList is 1000000000000000; it must be from 0 to 4294967295");
    EXPECT_EQ(refusal("1 glMapBuffer(target = 1e300, access = GL_WRITE_ONLY) = 0x1000\n"), "no error");
}

// Each of these once caused a stack overflow or an endless loop.
TEST_F(Traces, AreNotFollowedIntoTheDepth) {
    for (const char* opening : {"{", "&", "a = ", "{a = ", "&{"}) {
        std::string deep = "1 glViewport(x = ";
        for (int i = 0; i < 1'000'000; ++i) deep += opening;
        EXPECT_NE(refusal(deep + "1)\n").find("nested more than 8 deep"), std::string::npos) << opening;
    }
    EXPECT_FALSE(trace::is_dump("\x1b[1"));
    EXPECT_FALSE(trace::is_dump("\x1b["));
}

TEST_F(Traces, HoldOnlySoManyBytesOfBlobsAtOnce) {
    write_file_atomically(folder_ / "a.bin", "123456");
    const trace::BlobLoader blobs = trace::blobs_in_folder(folder_.str(), 16);
    std::shared_ptr<const Memory> first = blobs("a.bin", {}), second = blobs("a.bin", {});
    EXPECT_THROW(blobs("a.bin", {}), SceneError);
    first.reset();
    EXPECT_EQ(blobs("a.bin", {})->bytes.size(), 6u);
}

TEST_F(Traces, ReadBlobsFromTheirOwnFolderOnly) {
    const TemporaryFolder elsewhere;
    write_file_atomically(elsewhere / "secret.bin", "secret");
    std::filesystem::create_symlink(elsewhere / "secret.bin", folder_ / "link.bin");
    for (const std::string& name : {elsewhere / "secret.bin", std::string("../secret.bin"), std::string("link.bin"),
                                    std::string("missing.bin"), std::string("")}) {
        const std::string found =
            refusal("1 glVertexPointer(size = 3, type = GL_FLOAT, stride = 0, pointer = blob(\"" + name + "\"))\n");
        EXPECT_TRUE(found.starts_with("dump.txt: call 1: ")) << name << ": " << found;
        EXPECT_EQ(found.find("it is a link") != std::string::npos, name == "link.bin") << found;
    }
}

// ---- Frames ----

constexpr const char* kTriangle =
    "9 glBegin(mode = GL_TRIANGLES)\nglVertex2f(x = 0, y = 0)\nglVertex2f(x = 1, y = 0)\nglVertex2f(x = 0, y = "
    "1)\nglEnd()\n";
constexpr const char* kSwap = "glXSwapBuffers(dpy = 0x1, drawable = 2)\n\n";

std::size_t draws(const Frame& frame) {
    return static_cast<std::size_t>(
        std::ranges::count_if(frame.items, [](const auto& item) { return std::holds_alternative<Draw>(item); }));
}

TEST_F(Traces, KeepTheStateOfEarlierFrames) {
    const std::string clear = "2 glClear(mask = GL_COLOR_BUFFER_BIT)\n";
    const std::string text = "1 glViewport(x = 0, y = 0, width = 64, height = 48)\nglEnable(cap = GL_LIGHTING)\n" +
                             std::string(kSwap) + "glColor3f(red = 1, green = 0, blue = 0)\n" + kTriangle + kSwap +
                             clear + "glDisable(cap = GL_LIGHTING)\n" + kTriangle + kTriangle + kSwap;
    const RecordedFrame first = frame(text);
    EXPECT_EQ(first.number, 1);  // the first that draws
    EXPECT_EQ(draws(first.scene.frame), 1u);
    EXPECT_EQ(first.scene.frame.width, 64);
    EXPECT_EQ(first.scene.frame.height, 48);
    EXPECT_TRUE(first.scene.name().ends_with("frame 1"));
    const RecordedFrame second = frame(text, 2);
    EXPECT_EQ(draws(second.scene.frame), 2u);
    const auto is_lit = [](const Frame& f) {
        for (const auto& item : f.items) {
            if (const Draw* draw = std::get_if<Draw>(&item)) return draw->lighting.enabled;
        }
        return false;
    };
    EXPECT_TRUE(is_lit(first.scene.frame));
    EXPECT_FALSE(is_lit(second.scene.frame));
    EXPECT_THROW(frame(text, 3), SceneError);
    EXPECT_THROW(frame(text, 0), SceneError);  // draws nothing
}

// Two views of a window of 64 pixels, the second of which begins a pixel beyond its middle.
TEST_F(Traces, HaveTheSizeOfTheWindowWhereAViewReachesAPixelBeyond) {
    const auto views = [](int second, int width) {
        return "1 glViewport(x = 0, y = 0, width = 64, height = 48)\nglViewport(x = 0, y = 0, width = 32, height = "
               "48)\n" +
               std::string(kTriangle) + "glViewport(x = " + std::to_string(second) +
               ", y = 0, width = " + std::to_string(width) + ", height = 48)\n" + kTriangle + kSwap;
    };
    EXPECT_EQ(frame(views(33, 32)).scene.frame.width, 64);
    EXPECT_EQ(frame(views(32, 32)).scene.frame.width, 64);
    EXPECT_EQ(frame(views(40, 40)).scene.frame.width, 80);  // the window has grown
}

// Printers to vector files ask for feedback (5.3) in a viewport of their own, and picking (5.2) may.
TEST_F(Traces, HaveNoSizeFromTheViewportsOfSelectionAndFeedback) {
    const std::string window = "1 glViewport(x = 0, y = 0, width = 64, height = 48)\n";
    const std::string large = "3 glViewport(x = -8192, y = -8192, width = 16384, height = 16384)\n";
    const std::string feedback =
        "2 glFeedbackBuffer(size = 4, type = GL_2D, buffer = &0)\n2 glRenderMode(mode = GL_FEEDBACK) = 0\n" + large +
        kTriangle + "4 glRenderMode(mode = GL_RENDER) = 0\n";
    const std::string selection = "2 glSelectBuffer(size = 4, buffer = &0)\n2 glRenderMode(mode = GL_SELECT) = 0\n" +
                                  large + kTriangle + "4 glRenderMode(mode = GL_RENDER) = 0\n";
    for (const std::string& mode : {feedback, selection}) {
        EXPECT_EQ(frame(window + mode + window + kTriangle + kSwap).scene.frame.width, 64);
        EXPECT_EQ(frame(window + kTriangle + mode + kSwap).scene.frame.width, 64);    // stays at the end of the frame
        EXPECT_EQ(frame(window + mode + kTriangle + kSwap).scene.frame.width, 8192);  // draws in it
    }
}

// Without a swap there is one buffer, and the next frame draws over it.
TEST_F(Traces, EndAFrameAtGlFlushWhereNothingIsEverSwapped) {
    const std::string text = "1 glFlush()\n" + std::string(kTriangle) + "glFlush()\n" + kTriangle + "glFinish()\n";
    EXPECT_EQ(frame(text).number, 0);
    EXPECT_EQ(draws(frame(text, 0).scene.frame), 1u);
    EXPECT_EQ(draws(frame(text, 1).scene.frame), 2u);
    // In a program that swaps, a flush does not end a frame.
    EXPECT_EQ(draws(frame(std::string(kTriangle) + "glFlush()\n" + kTriangle + kSwap).scene.frame), 2u);
}

// A recording may go on for hours. The limits of a picture do not count what a later Clear or the end of its frame drops.
TEST_F(Traces, CountTheLimitsOfAPictureForEachPicture) {
    const std::string many = "1 glEvalMesh2(mode = GL_POINT, i1 = 1, i2 = 6000, j1 = 1, j2 = 5000)\n";  // draws nothing
    const std::string part = many + kTriangle, flush = "2 glFlush()\n";
    const std::string clear = "2 glClear(mask = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)\n";
    EXPECT_EQ(draws(frame(part + flush + part + flush).scene.frame), 1u);
    EXPECT_THROW(frame(part + flush + part + flush, 1), SceneError);  // it shows both
    EXPECT_EQ(draws(frame(part + clear + part + kSwap).scene.frame), 1u);
    EXPECT_THROW(frame(part + flush + part + kSwap), SceneError);
    EXPECT_THROW(frame(part + part + flush), SceneError);
}

TEST_F(Traces, SayWhyTheyDrawNothing) {
    const auto why = [this](const std::string& text) {
        try {
            frame(text);
        } catch (const SceneError& error) {
            const std::string what = error.what();
            return what.substr(std::min(what.find(": this "), what.size()));
        }
        return std::string("no error");
    };
    EXPECT_EQ(why("1 glFlush()\n" + std::string(kSwap)),
              ": this recording draws nothing: 1 frame; none of its 1 command draws: perhaps it ended or was cut "
              "before that");
    EXPECT_EQ(why("1 glUseProgram(program = 4)\nglUseProgram(program = 5)\nglVertexAttribPointer(index = 0)\n"),
              ": this recording draws nothing: 0 frames; it draws with shaders: glUseProgram (2 times), "
              "glVertexAttribPointer (once); it has no GL command");
    EXPECT_EQ(why("1 glNewList(list = 1, mode = GL_COMPILE)\n" + std::string(kTriangle) + "glEndList()\n"),
              ": this recording draws nothing: 0 frames; it draws only inside display lists that it never calls (once "
              "in lists)");
    EXPECT_EQ(why("1 glBegin(mode = GL_POINTS)\nglEnd()\n"),
              ": this recording draws nothing: 0 frames; glBegin (once): no vertex that shows");
    EXPECT_NE(why("1 glFlush()\n2 glVertex2f(x = 1,").find("; the recording ends inside call 2"), std::string::npos);
    const std::string other =
        why("1 glXMakeCurrent(dpy = 0x1, drawable = 2, ctx = 0xa) = True\n2 glFlush()\n"
            "3 @1 glXMakeCurrent(dpy = 0x1, drawable = 3, ctx = 0xb) = True\n4 @1 glRecti(x1 = 0, y1 = 0, x2 = 1, y2 = "
            "1)\n");
    EXPECT_EQ(other, "no error");
    try {
        make_recorded_frame(load_recording(folder_ / "dump.txt", std::nullopt, {}, 0), {});
        ADD_FAILURE() << "context 0 draws nothing";
    } catch (const SceneError& error) {
        EXPECT_NE(std::string(error.what()).find("; context 1 draws 1 vertex; this is context 0, --context N chooses"),
                  std::string::npos)
            << error.what();
    }
}

// A scene must end what it begins.
TEST_F(Traces, EndWhatAFrameLeavesOpen) {
    const auto last = [](const RecordedFrame& found) {
        Lines lines;
        found.scene.recording->for_each([&](const Step& step) {
            if (step.kind == Step::Kind::kCommand) lines.push_back(print_command(step.command));
            return true;
        });
        return lines;
    };
    const std::string open =
        "1 glPushAttrib(mask = GL_LIGHTING_BIT)\nglMatrixMode(mode = GL_PROJECTION)\nglPushMatrix()\nglPushMatrix()\n" +
        std::string(kTriangle);
    const RecordedFrame whole = frame(open + kSwap);
    Lines lines = last(whole);
    ASSERT_GT(lines.size(), 5U);
    EXPECT_EQ(Lines(lines.end() - 4, lines.end()),
              (Lines{"glPopAttrib();", "glMatrixMode(GL_PROJECTION);", "glPopMatrix();", "glPopMatrix();"}));
    EXPECT_EQ(whole.notes, Lines{});
    // What the export prints can be read again.
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    const auto again = std::make_shared<CommandList>(read_scene(text, "again.gl", "again"));
    EXPECT_NO_THROW(make_scene(again, {.width = 64, .height = 48}));

    const RecordedFrame cut =
        frame(std::string(kTriangle) + kSwap + "glClear(mask = GL_COLOR_BUFFER_BIT)\nglNewList(list = 3, mode = " +
                  "GL_COMPILE_AND_EXECUTE)\n" + kTriangle + "glBegin(mode = GL_POINTS)\n",
              1);
    lines = last(cut);
    EXPECT_EQ(Lines(lines.end() - 2, lines.end()), (Lines{"glEnd();", "glEndList();"}));
    EXPECT_EQ(cut.notes, Lines{"the recording ends inside this frame, so its picture may be incomplete"});
}

TEST_F(Traces, GoOnAfterWhatGlRefuses) {
    const RecordedFrame found =
        frame("1 glEnable(cap = GL_LIGHTING)\nglMatrixMode(mode = GL_LIGHT0)\n" + std::string(kTriangle) + kSwap);
    EXPECT_EQ(found.error_count, 1u);
    ASSERT_TRUE(found.first_error);
    EXPECT_EQ(found.first_error->code, kGL_INVALID_ENUM);
    EXPECT_EQ(found.first_error->place.line, 2);  // the call's number
    EXPECT_EQ(draws(found.scene.frame), 1u);
}

TEST_F(Traces, CountWhatNoRendererDoes) {
    const RecordedFrame found =
        frame("1 glUseProgram(program = 3)\nglUseProgram(program = 4)\n" + std::string(kTriangle));
    ASSERT_EQ(found.scene.frame.unsupported.size(), 1u);
    EXPECT_EQ(found.scene.frame.unsupported[0].name, "glUseProgram");
    EXPECT_EQ(found.scene.frame.unsupported[0].count, 2);
    EXPECT_EQ(found.scene.frame.unsupported[0].first.line, 1);
    EXPECT_EQ(found.scene.frame.unsupported[0].missing_from, MissingFrom::kEverything);
}

// The start of a .trace of an old version, which only apitrace reads.
const std::string kOldTrace = "\x1f\x8b" + std::string(64, 'x');

TEST(Apitrace, IsAskedForWhereItIsMissing) {
    const TemporaryFolder folder;
    write_file_atomically(folder / "game.trace", kOldTrace);
    const ProgramResult result =
        run_shell("twinlight", "PATH=/nowhere \"$PROGRAM\" compare " + quoted(folder / "game.trace") + " -o " +
                                   quoted(folder / "report"));
    EXPECT_EQ(result.status, 2);
    EXPECT_NE(result.err.find("apitrace, which is not installed; install it (apt-get install apitrace)"),
              std::string::npos)
        << result.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "report"));
}

TEST(Apitrace, LeavesNothingBehindHoweverTheProgramEnds) {
    const TemporaryFolder folder, temporary;
    write_file_atomically(folder / "game.trace", kOldTrace);
    // A replacement for apitrace that writes a blob and a dump without end.
    write_file_atomically(folder / "apitrace",
                          "#!/bin/sh\necho x >blob.bin; echo '1 glFlush()'; while sleep 0.05; do echo; done\n");
    std::filesystem::permissions(folder / "apitrace", std::filesystem::perms::owner_all);
    for (const char* signal : {"INT", "TERM", "HUP", "KILL"}) {
        const ProgramResult result = run_shell(
            "twinlight", "export TMPDIR=" + quoted(temporary.str()) + " PATH=" + quoted(folder.str()) + ":\"$PATH\"\n" +
                             "env --default-signal=INT,HUP \"$PROGRAM\" render " + quoted(folder / "game.trace") +
                             " --with reference -o " + quoted(folder / "picture.png") + " &\n" +
                             "for i in $(seq 200); do ls \"$TMPDIR\"/*/blob.bin && break; sleep 0.1; done; kill -" +
                             signal + " $!; wait $!\n" +
                             "for i in $(seq 100); do [ -z \"$(ls -A \"$TMPDIR\")\" ] || sleep 0.1; done\n" +
                             "echo left:; ls -A \"$TMPDIR\"");
        EXPECT_NE(result.out.find("blob.bin"), std::string::npos) << signal << ": " << result.err;
        EXPECT_TRUE(result.out.ends_with("left:\n")) << signal << ": " << result.out;
    }
}

}  // namespace

}  // namespace twinlight::trace_test
