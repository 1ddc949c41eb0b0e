// Shared by the tests of malicious recordings: a folder with blobs, and the result of a recording.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "../unit/run_program.h"
#include "render/context/context.h"
#include "render/fixed/fixed.h"
#include "render/programmable/programmable.h"
#include "render/reference/reference.h"
#include "scene/command/text.h"
#include "scene/recorded/recorded_frame.h"
#include "scene/scenes/load.h"

namespace twinlight {

inline constexpr int kHostileSide = 32;
inline const std::string kPicture = "a picture";
inline const std::string kViewport = "1 glViewport(x = 0, y = 0, width = 32, height = 32)\n";
inline const std::string kTriangle =
    "glBegin(mode = GL_TRIANGLES)\nglVertex2f(x = 0, y = 0)\nglVertex2f(x = 1, y = 0)\nglVertex2f(x = 0, y = 1)\n"
    "glEnd()\n";
inline const std::string kSwap = "glXSwapBuffers(dpy = 0x1, drawable = 2)\n";

inline std::string times(int count, const std::string& text) {
    std::string result;
    for (int i = 0; i < count; ++i) result += text;
    return result;
}

inline std::string floats(const std::vector<float>& values) {
    std::string bytes(values.size() * sizeof(float), '\0');
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

class HostileTraces : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        context() = make_offscreen_context(kHostileSide, kHostileSide);
        shaders() = std::make_unique<programmable::Renderer>();
    }
    static void TearDownTestSuite() {
        shaders().reset();
        context().reset();
    }
    HostileTraces() {
        write("tiny.bin", std::string(4, '\0'));
        write("triangle.bin", floats({0, 0, 0, 1, 0, 0, 0, 1, 0}));
        write("zeros.bin", std::string(4096, '\0'));
        write("names.bin", std::string(1 << 20, '\1'));
        write("indices.bin", std::string("\0\1\2\xff\xff\xff\xff\xff", 8));
        write("empty.bin", "");
        write("nan.bin", std::string(36, '\xff'));
    }

    void write(const std::string& name, const std::string& bytes) { write_file_atomically(folder_ / name, bytes); }

    // The result of a recording: kPicture, or the error message. `renderers`: draws it too.
    std::string outcome(const std::string& text, bool renderers = true) {
        write("dump.txt", text);
        try {
            const auto recording = load_recording(folder_ / "dump.txt");
            const RecordedFrame recorded =
                make_recorded_frame(recording, {.number = {}, .width = kHostileSide, .height = kHostileSide});
            if (renderers) {
                const Frame& frame = recorded.scene.frame;
                EXPECT_EQ(fixed::render(recorded.scene).width, kHostileSide);
                EXPECT_EQ(shaders()->render(frame, {}).width, kHostileSide);
                EXPECT_EQ(reference::render(frame, {}).width, kHostileSide);
            }
            return kPicture;
        } catch (const SceneError& error) {
            const std::string said = error.what();
            EXPECT_LT(said.size(), 1000u) << said;
            EXPECT_TRUE(std::ranges::all_of(said, [](unsigned char c) { return c >= 0x20 && c < 0x7F; })) << said;
            EXPECT_NE(said.find("dump.txt"), std::string::npos) << said;
            return said;
        }
    }
    // Followed by a triangle in a separate frame.
    std::string before_triangle(const std::string& text) { return outcome(kViewport + text + kTriangle + kSwap); }

    static std::unique_ptr<OffscreenContext>& context() {
        static std::unique_ptr<OffscreenContext> one;
        return one;
    }
    static std::unique_ptr<programmable::Renderer>& shaders() {
        static std::unique_ptr<programmable::Renderer> one;
        return one;
    }

    TemporaryFolder folder_;
};

}  // namespace twinlight
