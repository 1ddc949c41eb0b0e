// Places of recorded calls in the program's own source.
#include "scene/trace/call_stacks.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "../run_program.h"
#include "base/image/file.h"
#include "scene/recorded/recorded_frame.h"
#include "scene/scenes/load.h"

namespace twinlight::call_stacks_test {
namespace {

class CallStack : public testing::Test {
  protected:
    // The place of each command: "lamp.cpp:2:5".
    std::vector<std::string> places(const std::string& dump) {
        write_file_atomically(in_ / "dump.txt", dump);
        std::vector<std::string> found;
        recording_ = load_recording(in_ / "dump.txt");
        recording_->for_each([&](const Step& step) {
            if (step.kind == Step::Kind::kFrameEnd) return true;
            std::string place = step.command.place.str();
            if (const std::size_t at = place.find(in_.str()); at == 0) place = place.substr(in_.str().size() + 1);
            found.push_back(place);
            calls_.push_back(step.command.place.calls ? *step.command.place.calls : "");
            return true;
        });
        return found;
    }
    // A frame in this program.
    std::string frame(const std::string& function, const std::string& file, int line) const {
        return (in_ / "lamp") + ": " + function + "+0x1f: " + (in_ / file) + ":" + std::to_string(line) + "\n";
    }

    const TemporaryFolder in_;
    std::shared_ptr<const Recording> recording_;
    std::vector<std::string> calls_;
};

constexpr const char* kGlut = "/lib/x86_64-linux-gnu/libglut.so.3.12: fghRedrawWindow+0x3c\n";
constexpr const char* kLibc = "/lib/x86_64-linux-gnu/libc.so.6: __libc_start_main+0x84: ../csu/libc-start.c:360\n?\n";

using Lines = std::vector<std::string>;

TEST_F(CallStack, GivesTheInnermostFrameInTheProgramsSource) {
    write_file_atomically(in_ / "lamp.cpp",
                          "void use() {\n"
                          "    if (on) glEnable(GL_LIGHT0); else glDisable(GL_LIGHT0);\n"
                          "\tglutSolidCube(1);\n"
                          "    DRAW(\"\xC3\xA4\"); gluSphere(q, 1, 9, 9);\n"
                          "}\n");
    const std::string outer = kGlut + frame("main", "lamp.cpp", 9) + kLibc;
    EXPECT_EQ(
        places("// process.name = \"lamp\"\n"
               "1 @0 glEnable(GL_LIGHTING)\n"
               "2 @0 glEnable(GL_LIGHT0)\nBacktrace:\n" +
               frame("Lamp::use(std::vector<float> const&) const", "lamp.cpp", 2) + frame("display()", "lamp.cpp", 5) +
               outer + "3 @0 glDisable(GL_LIGHT0)\nBacktrace:\n" + frame("use()", "lamp.cpp", 2) + outer +
               "4 @0 glVertex3f(1, 2, 3)\nBacktrace:\n"
               "/usr/lib/libglut.so.3: fghDraw+0x3c\n" +
               frame("use()", "lamp.cpp", 3) + outer + "5 @0 glXSwapBuffers(0x1, 2)\nBacktrace:\n" + outer +
               "6 @0 glVertex3f(1, 2, 3)\nBacktrace:\n/lib/libGLU.so.1: gluSphere+0x3c\n" +
               frame("use()", "lamp.cpp", 4) + "7 @0 glNormal3f(0, 0, 1)\nBacktrace:\n" +
               frame("use()", "gone.cpp", 4) + "8 @0 glNormal3f(0, 0, 1)\nBacktrace:\n" + kGlut + kLibc),
        (Lines{"dump.txt: call 1", "lamp.cpp:2:13", "lamp.cpp:2:39", "lamp.cpp:3:2", "lamp.cpp:4:16", "gone.cpp:4",
               "dump.txt: call 8"}));
    EXPECT_EQ(calls_, (Lines{"", "main > display > Lamp::use", "main > use", "main > use", "use", "use", ""}));
}

TEST_F(CallStack, OfTheDrawIsThatOfTheArraysThatTheTracerInserts) {
    write_file_atomically(in_ / "lamp.cpp", "glDrawArrays(GL_POINTS, 0, 1);\n");
    EXPECT_EQ(places("1 glEnable(GL_LIGHT0)\nBacktrace:\n" + frame("main", "lamp.cpp", 7) +
                     "2 glVertexPointer(3, GL_FLOAT, 0, NULL) // fake\n"
                     "3 glDrawArrays(GL_POINTS, 0, 1)\nBacktrace:\n" +
                     frame("main", "lamp.cpp", 1) + "4 glVertexPointer(3, GL_FLOAT, 0, NULL) // fake\n"),
              (Lines{"lamp.cpp:7", "lamp.cpp:1:1", "lamp.cpp:1:1", "dump.txt: call 4"}));
}

TEST_F(CallStack, IsReadWithoutCallNumbersAndInAnyText) {
    EXPECT_EQ(
        places("// process.name = \"lamp\"\nglEnable(GL_LIGHT0)\nBacktrace:\n" + frame("main", "lamp.cpp", 7) + kLibc +
               "glEnable(GL_LIGHT1)\nBacktrace:\n\n"
               "glEnable(GL_LIGHT2)\nBacktrace:\n: : :\n+0x: x:99999999999999999999\n?:1\nglEnable(GL_LIGHT3)\n"
               "glEnable(GL_LIGHT4)\nBacktrace:"),
        (Lines{"lamp.cpp:7", "dump.txt: call 1", "dump.txt: call 2", "dump.txt: call 3", "dump.txt: call 4"}));
}

TEST_F(CallStack, ShowsTextOfSourceFilesOnly) {
    write_file_atomically(in_ / "secret.txt", "secret\n");
    write_file_atomically(in_ / "lamp.h", "glEnable(GL_LIGHT0);\n");
    places("1 glEnable(GL_LIGHT0)\nBacktrace:\n" + frame("main", "secret.txt", 1) +
           "2 glEnable(GL_LIGHT0)\nBacktrace:\n" + frame("main", "lamp.h", 1));
    std::vector<Place> found;
    recording_->for_each([&](const Step& step) {
        found.push_back(step.command.place);
        return true;
    });
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(recording_->text_of(found[0]), nullptr);
    ASSERT_NE(recording_->text_of(found[1]), nullptr);
    EXPECT_EQ(*recording_->text_of(found[1]), "glEnable(GL_LIGHT0);\n");
}

}  // namespace
}  // namespace twinlight::call_stacks_test
