// Reading .trace files: those of the seeds of the fuzzer, whose calls are written here as `apitrace dump` prints them; what comes in
// parts, and what is damaged. trace_and_dump_test.cpp compares recordings with what apitrace reads in them.
#include "scene/trace/trace_calls.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "../run_program.h"
#include "base/image/file.h"
#include "scene/command/text.h"
#include "scene/trace/as_printed.h"
#include "scene/trace/trace.h"

namespace twinlight::trace_calls_test {
namespace {

using trace::as_printed;
using Lines = std::vector<std::string>;

constexpr std::string_view kFrame = R"(0 @0 glXChooseVisual(1, 0, {100001, 4, 0}) = &{visual = 0x55d0, visualid = 33}
1 @0 glXCreateContext(1, &{visual = 0x55d0, visualid = 33}, NULL, 1) = 0x4d
2 @0 glXMakeCurrent(1, 2, 0x4d) = 1
3 @0 glViewport(0, 0, 64, 48) // fake
4 @0 glClear(GL_DEPTH_BUFFER_BIT | GL_COLOR_BUFFER_BIT)
5 @0 glEnable(GL_LIGHTING)
Backtrace:
/home/me/lamp: draw(): /home/me/lamp.c:12
/home/me/lamp: main: /home/me/lamp.c:30
/lib/libglut.so: glutMainLoop: :0
6 @0 glLightfv(GL_LIGHT0, GL_POSITION, {1, 0.3, -2e-09, 0})
Backtrace:
/home/me/lamp: draw(): /home/me/lamp.c:12
/home/me/lamp: main: /home/me/lamp.c:30
7 @0 glGenTextures(2, {3, 4})
8 @0 glGenLists(1) = 1
9 @0 glBegin(GL_POLYGON)
10 @0 glVertex3f(0.1, 1e+30, -0)
11 @0 glVertex2i(-5, 6)
12 @0 glNormal3d(0.3333333333333333, 1e-100, 2)
13 @0 glEnd()
14 @0 glXSwapBuffers(1, 2)
)";
constexpr std::string_view kArrays = R"(0 @0 glVertexPointer(3, GL_FLOAT, 0, blob("blob_call0.bin")) // fake
1 @0 glDrawArrays(GL_TRIANGLES, 0, 3)
2 @0 glMapBuffer(GL_ARRAY_BUFFER, 35001) = 0x1000
3 @0 memcpy(0x1004, blob("blob_call3.bin"), 4)
4 @0 glStringMarkerGREMEDY(0, "python: display: lamp.py:12
")
5 @0 glFinish()
6 @0 glShaderSource(1, 1, &"void main")
7 @0 eglSwapBuffers(1, 2)
)";
constexpr std::string_view kThreads = R"(1 @1 glFlush()
0 @0 glClear(256)
2 @0 glEnable(false)
3 @0 glEnable(true)
4 @0 glObjectLabel(L"ab")
5 @0 glXSwapBuffers() // incomplete
6 @0 glUseProgram(3) // incomplete
)";

Lines steps_of(const Recording& recording) {
    Lines lines;
    recording.for_each([&](const Step& step) {
        std::string line = fmt::format("{} {}", static_cast<int>(step.kind), step.text);
        if (step.kind == Step::Kind::kCommand) {
            line += print_command(step.command);
            for (const double argument : step.command.arguments) line += fmt::format(" {:a}", argument);
            if (step.command.memory) line += fmt::format(" with {} bytes", step.command.memory->bytes.size());
        }
        const Place& place = step.command.place;
        line += place.calls ? fmt::format(" at {}:{} {}", *place.file, place.line, *place.calls)
                            : fmt::format(" at {}", place.line);
        lines.push_back(line);
        return true;
    });
    return lines;
}

Lines steps_of_dump(std::string_view dump) {
    const auto memory = [](const std::string& bytes) {
        const auto* const first = reinterpret_cast<const std::byte*>(bytes.data());
        return std::make_shared<const Memory>(Memory{.bytes = {first, first + bytes.size()}});
    };
    return steps_of(*trace::read_dump(
        dump, "dump.txt", {{"blob_call0.bin", memory(std::string(36, '\0'))}, {"blob_call3.bin", memory("abcd")}}));
}

class TraceCalls : public testing::Test {
  protected:
    // The steps of a trace with these uncompressed bytes, in chunks of some length; or an error.
    Lines steps(std::string_view bytes, std::size_t chunk) {
        std::string file = "at";
        for (; !bytes.empty(); bytes.remove_prefix(std::min(chunk, bytes.size())))
            file += trace::chunk_of(bytes.substr(0, chunk));
        return steps_of_file(file);
    }
    Lines steps_of_file(const std::string& file) {
        write_file_atomically(in_ / "a.trace", file);
        try {
            return steps_of(*trace::open_trace(in_ / "a.trace"));
        } catch (const SceneError& error) {
            const std::string what = error.what();
            return {what.substr(what.find("a.trace"))};
        }
    }
    static std::string seed(const std::string& name) { return read_file("tests/fuzz/seeds/trace/" + name); }

    const TemporaryFolder in_;
};

TEST_F(TraceCalls, AreThoseOfTheDumpHoweverTheyLieInChunks) {
    for (const std::size_t chunk : {1, 2, 7, 61, 10'000}) {
        EXPECT_EQ(steps(seed("frame"), chunk), steps_of_dump(kFrame)) << chunk;
        EXPECT_EQ(steps(seed("arrays"), chunk), steps_of_dump(kArrays)) << chunk;
        EXPECT_EQ(steps(seed("threads"), chunk), steps_of_dump(kThreads)) << chunk;
    }
}

// All steps but the last ones are there, and a note if the file ends inside a chunk.
TEST_F(TraceCalls, AreReadUpToWhereTheFileEnds) {
    const std::string bytes = seed("frame"), file = "at" + trace::chunk_of(bytes);
    const Lines whole = steps_of_dump(kFrame);
    for (std::size_t size = file.size() - bytes.size() + 400; size < file.size(); size += 3) {
        const Lines found = steps_of_file(file.substr(0, size));
        ASSERT_GE(found.size(), 2u);
        EXPECT_NE(found.back().find("the recording ends inside call "), std::string::npos) << size << found.back();
        for (std::size_t i = 0; i + 2 < found.size(); ++i) EXPECT_EQ(found[i], whole[i]) << size;
    }
}

TEST_F(TraceCalls, EndWhereAByteIsWrong) {
    std::string bytes = seed("threads");
    bytes[bytes.rfind("glUseProgram") - 4] = '\x07';  // no kind of event
    const Lines found = steps(bytes, 61);
    ASSERT_GE(found.size(), 4u);
    EXPECT_NE(found.back().find("the file is damaged in call 6; record it again"), std::string::npos) << found.back();
    bytes[1] = '\x07';
    EXPECT_EQ(steps(bytes, 61), Lines{"a.trace: the file is damaged in call 0; record it again"});
}

// An array of a million values in an array, a text of 2^60 bytes, 300 calls that never return, 65 arrays in each other, a
// signature of 2^40 arguments.
TEST_F(TraceCalls, BoundWhatLengthsCanCost) {
    const std::string head = "\4", enter("\0\0\0\4glHi\1\1a", 11), argument("\1\0", 2);
    const std::string far = "\xff\xff\xff\xff\xff\xff\xff\xff\x0f";
    const Lines damaged = {"a.trace: the file is damaged in call 0; record it again"};
    EXPECT_EQ(steps(head + enter + argument + "\7" + far, 61), damaged);
    EXPECT_EQ(steps(head + enter + argument + "\x08" + far, 61), damaged);
    EXPECT_EQ(steps(head + enter + argument + "\x0b" + far, 61), Lines{});  // goes on after the end of the file
    std::string deep;
    for (int i = 0; i < 65; ++i) deep += "\x0b\1";
    EXPECT_EQ(steps(head + enter + argument + deep + "\x04\1", 61), damaged);
    EXPECT_EQ(steps(head + std::string("\0\0\0\4glHi", 8) + far, 61), damaged);
    std::string open = head + enter + std::string(1, '\0');
    for (int i = 0; i < 300; ++i) open += std::string("\0\0\0\0", 4);
    EXPECT_NE(steps(open, 61).back().find("the file is damaged in call 256"), std::string::npos);
}

// As printf and strtod round.
TEST(AsPrinted, HasSevenDigitsOfFloatsAndSixteenOfDoubles) {
    std::mt19937 random(1);
    const auto printed = [](const char* format, double value) {
        return std::strtod(fmt::format(fmt::runtime(format), value).c_str(), nullptr);
    };
    for (int i = 0; i < 1'000'000; ++i) {
        const auto any = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
        const float usual = std::ldexp(static_cast<float>(random() & 0xFFFFFFU), static_cast<int>(random() % 60) - 50);
        for (const float value : {any, usual, -usual}) {
            if (std::isnan(value)) continue;
            ASSERT_EQ(as_printed(value), printed("{:.7g}", value)) << value;
            ASSERT_EQ(std::signbit(as_printed(value)), std::signbit(value)) << value;
        }
        const double wide = std::bit_cast<double>(std::uint64_t{random()} << 32 | random());
        ASSERT_TRUE(std::isnan(wide) || as_printed(wide) == printed("{:.16g}", wide)) << wide;
    }
    // Halfway between two numbers of seven digits.
    EXPECT_EQ(as_printed(1234566.5F), 1234566.0);
    EXPECT_EQ(as_printed(1234567.5F), 1234568.0);
    EXPECT_TRUE(std::isnan(as_printed(-NAN)));
    EXPECT_EQ(as_printed(-INFINITY), -INFINITY);
}

}  // namespace
}  // namespace twinlight::trace_calls_test
