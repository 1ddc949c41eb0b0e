// Recordings that are dropped on the page, without a browser: the text draws what the recording draws.
#include "app/web/dropped_files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "app/web/page_scene.h"
#include "base/image/file.h"
#include "base/text/json.h"
#include "render/reference/reference.h"
#include "scene/command/text.h"
#include "scene/recorded/recorded_frame.h"
#include "scene/scenes/load.h"
#include "scene/trace/trace_file.h"

namespace twinlight::web::dropped_files_test {

namespace {

using Json = nlohmann::json;

void add(DroppedFiles& files, const std::string& name, std::string_view bytes) {
    files.add(name, {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});  // NOLINT
}

std::string error_of(const std::string& dump) {
    DroppedFiles files;
    add(files, "dump.txt", dump);
    try {
        files.scene_of_recording("dump.txt");
    } catch (const SceneError& error) {
        return error.what();
    }
    return "no error";
}

std::string text_of(const std::string& dump) {
    DroppedFiles files;
    add(files, "dump.txt", dump);
    return Json::parse(files.scene_of_recording("dump.txt"))["text"];
}

constexpr const char* kTriangle =
    "1 glBegin(mode = GL_TRIANGLES)\n2 glVertex2f(x = 0, y = 0)\n3 glVertex2f(x = 1, y = 0)\n4 glVertex2f(x = 0, y = "
    "1)\n5 glEnd()\n";

TEST(WebDroppedFiles, DrawAsTheRecording) {
    int programs = 0;
    for (const auto& program : std::filesystem::directory_iterator("tests/traces")) {
        if (!program.is_directory()) continue;
        SCOPED_TRACE(program.path());
        ++programs;
        DroppedFiles files;
        for (const auto& file : std::filesystem::directory_iterator(program.path()))
            add(files, file.path().filename(), read_file(file.path()));
        const Json answer = Json::parse(files.scene_of_recording("dump.txt"));
        const WindowSize size{answer["width"], answer["height"]};
        PageScene page;
        EXPECT_EQ(Json::parse(page.open(answer["text"].get<std::string>(), "dump", "", size))["errors"], Json::array());
        ASSERT_TRUE(page.is_open());

        // The frame that `twinlight compare` shows where the first one has contrast.
        const Frame frame = make_recorded_frame(load_recording(program.path() / "dump.txt"), {}).scene.frame;
        const Frame& drawn = page.scene().frame;
        ASSERT_EQ(std::pair(drawn.width, drawn.height), std::pair(frame.width, frame.height));
        EXPECT_EQ(reference::render(drawn, {}).pixels, reference::render(frame, {}).pixels);
    }
    EXPECT_GT(programs, 10);
}

TEST(WebDroppedFiles, SayWhatTheTextLacks) {
    const std::string text =
        text_of("1 glUseProgram(program = 7)\n2 glLightf(light = GL_LIGHT0, pname = GL_SPOT_CUTOFF, param = 100)\n" +
                std::string(kTriangle));
    EXPECT_NE(text.find("// dump.txt, frame 0: 640 x 480 pixels."), std::string::npos) << text;
    EXPECT_NE(text.find("// Note: glUseProgram is left out"), std::string::npos) << text;
    EXPECT_NE(text.find("1 of the program's commands causes a GL error"), std::string::npos) << text;
    PageScene page;
    EXPECT_EQ(Json::parse(page.open(text, "dump", "", {}))["errors"], Json::array());
}

TEST(WebDroppedFiles, ShowALaterFrameIfTheFirstIsOfOneColour) {
    const std::string swap = "6 glXSwapBuffers(dpy = 0x1, drawable = 2)\n";
    const std::string text = text_of("0 glColor3f(red = 0, green = 0, blue = 0)\n" + (kTriangle + swap) +
                                     "7 glColor3f(red = 1, green = 0, blue = 0)\n" + (kTriangle + swap));
    EXPECT_NE(text.find("// dump.txt, frame 1"), std::string::npos) << text;
    EXPECT_NE(text.find("frame 0 is almost of one colour"), std::string::npos) << text;
}

TEST(WebDroppedFiles, HaveErrorsWithTheirPlaces) {
    EXPECT_EQ(error_of("1 glVertexPointer(size = 3, type = GL_FLOAT, stride = 0, pointer = blob(\"b.bin\"))\n"),
              "dump.txt: call 1: the blob 'b.bin' is missing; give the dump and all its blobs together");
    EXPECT_TRUE(error_of("1 glEnable(cap = GL_LIGHTING)\n2 glFog\nx").starts_with("dump.txt:2:1: "))
        << error_of("1 glEnable(cap = GL_LIGHTING)\n2 glFog\nx");
    EXPECT_NE(error_of("1 glEnable(cap = GL_LIGHTING)\n").find("draws nothing"), std::string::npos);
}

TEST(WebDroppedFiles, AreKnownByTheirFronts) {
    EXPECT_TRUE(is_recording("1 glEnable(cap = GL_LIGHTING)\n", "dump.txt"));
    EXPECT_TRUE(is_recording(std::string_view("at\x05\0\0\0", 6), "lamp"));
    EXPECT_TRUE(is_recording("\x06\x01\x02", "new.trace"));
    EXPECT_FALSE(is_recording("glEnable(GL_LIGHTING);\n", "lamp.gl"));
}

// The seeds of the fuzzer are the events of a .trace, without its chunks.
TEST(WebDroppedFiles, MayBeATrace) {
    const std::string bytes = read_file("tests/fuzz/seeds/trace/frame");
    DroppedFiles files;
    add(files, "frame.trace", "at" + trace::chunk_of(bytes));
    const Json answer = Json::parse(files.scene_of_recording("frame.trace"));
    const std::string text = answer["text"];
    EXPECT_TRUE(text.starts_with("// frame.trace, frame 0: ")) << text;
    PageScene page;
    EXPECT_EQ(Json::parse(page.open(text, "frame", "", {}))["errors"], Json::array());
}

TEST(WebDroppedFiles, OfATraceOfAnotherVersionNameWhatToDo) {
    for (const auto& [name, bytes] : {std::pair("old.trace", "\x1f\x8b\x08"), {"new.trace", "\x06\x01\x02"}}) {
        DroppedFiles files;
        add(files, name, bytes);
        try {
            files.scene_of_recording(name);
            ADD_FAILURE() << name;
        } catch (const SceneError& error) {
            const std::string said = error.what();
            EXPECT_TRUE(said.starts_with(std::string(name) + ": this page reads the files that apitrace 5 to 13"))
                << said;
            EXPECT_NE(said.find("'apitrace dump --color=never --blobs"), std::string::npos) << said;
        }
    }
}

TEST(WebDroppedFiles, TooLongForTheEditorNameWhatToDo) {
    std::string dump = "0 glViewport(x = 0, y = 0, width = 64, height = 64)\n1 glBegin(mode = GL_POINTS)\n";
    for (int i = 0; i < 900'000; ++i) dump += "2 glNormal3f(x = 0, y = 0, z = 1)\n";
    dump += "3 glVertex2f(x = 0, y = 0)\n4 glEnd()\n";
    EXPECT_NE(error_of(dump).find("twinlight export dump.txt --as scene --frame N"), std::string::npos)
        << error_of(dump).substr(0, 300);
}

}  // namespace

}  // namespace twinlight::web::dropped_files_test
