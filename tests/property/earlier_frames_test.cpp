// What a frame shows of the frames before it (scene/recorded/earlier_frames.h): the driver, the shaders and the reference show the same.
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "../unit/frames_of_texts.h"
#include "../unit/one_pixel.h"
#include "scene/recorded/recorded_frame.h"

namespace twinlight::earlier_frames_test {
namespace {

// Pictures of 16 x 16 pixels.
class EarlierFramesTest : public OnePixel {
  protected:
    RecordedFrame frame(const std::vector<std::string>& frames, int number, std::size_t memory = kDefaultMemory) {
        return make_recorded_frame(std::make_shared<const FramesOfTexts>(frames),
                                   {.number = number, .width = kSide, .height = kSide, .memory = memory});
    }
    Codes codes_of(const RecordedFrame& recorded, int x, int y) { return codes(recorded.scene, x, y, ""); }
};

constexpr const char* kClear = "glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);\n";
constexpr const char* kRedLeft = "glColor3f(1, 0, 0); glRectf(-1, -1, 0, 1);\n";
constexpr const char* kGreenBelow = "glColor3f(0, 1, 0); glRectf(-1, -1, 1, 0);\n";

TEST_F(EarlierFramesTest, StayUnderAFrameThatDoesNotClear) {
    const RecordedFrame recorded = frame({std::string(kClear) + kRedLeft, kGreenBelow}, 1);
    EXPECT_EQ(codes_of(recorded, 2, 13), (Codes{255, 0, 0, 255}));
    EXPECT_EQ(codes_of(recorded, 2, 2), (Codes{0, 255, 0, 255}));
    EXPECT_EQ(codes_of(recorded, 13, 13), (Codes{0, 0, 0, 0}));
    EXPECT_EQ(recorded.notes,
              std::vector<std::string>{"this frame shows what earlier frames left in the picture; the one before is "
                                       "drawn first, as for a window that keeps its picture"});
}

// A frame that clears what it shows needs no other, though it leaves out what it does not use.
TEST_F(EarlierFramesTest, AreLeftOutWhereNothingOfThemShows) {
    const RecordedFrame recorded =
        frame({std::string(kClear) + kRedLeft, "glClear(GL_COLOR_BUFFER_BIT);\n" + std::string(kGreenBelow)}, 1);
    EXPECT_EQ(recorded.scene.frame.items.size(), 2u);
    EXPECT_TRUE(recorded.notes.empty());
    EXPECT_EQ(codes_of(recorded, 2, 13), (Codes{0, 0, 0, 0}));
}

TEST_F(EarlierFramesTest, StayWhereOnlyPartIsCleared) {
    const std::string part = "glEnable(GL_SCISSOR_TEST); glScissor(8, 0, 8, 16); glClear(GL_COLOR_BUFFER_BIT); ";
    const std::string masked = "glColorMask(1, 0, 1, 1); glClear(GL_COLOR_BUFFER_BIT);\n";
    EXPECT_EQ(codes_of(frame({kRedLeft, part + kGreenBelow}, 1), 2, 13), (Codes{255, 0, 0, 255}));
    EXPECT_EQ(codes_of(frame({kGreenBelow, masked + kRedLeft}, 1), 2, 2), (Codes{255, 255, 0, 255}));
}

TEST_F(EarlierFramesTest, LeaveTheirStencils) {
    const std::string once = std::string(kClear) +
                             "glEnable(GL_STENCIL_TEST); glStencilFunc(GL_ALWAYS, 1, 1);\n"
                             "glStencilOp(GL_REPLACE, GL_REPLACE, GL_REPLACE);\n" +
                             kRedLeft + "glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP); glStencilFunc(GL_EQUAL, 1, 1);\n";
    const RecordedFrame recorded = frame({once, std::string(kClear) + kGreenBelow}, 1);
    EXPECT_EQ(codes_of(recorded, 2, 2), (Codes{0, 255, 0, 255}));
    EXPECT_EQ(codes_of(recorded, 13, 2), (Codes{0, 0, 0, 0}));
    EXPECT_NE(recorded.notes.at(0).find("left in the stencil buffer;"), std::string::npos) << recorded.notes.at(0);
}

TEST_F(EarlierFramesTest, LeaveTheirDepths) {
    const std::string test = "glEnable(GL_DEPTH_TEST);\n", far = "glTranslatef(0, 0, 0.5);\n";
    const RecordedFrame recorded =
        frame({std::string(kClear) + test + kRedLeft, "glClear(GL_COLOR_BUFFER_BIT);\n" + far + kGreenBelow}, 1);
    EXPECT_EQ(codes_of(recorded, 2, 2), (Codes{0, 0, 0, 0}));
    EXPECT_EQ(codes_of(recorded, 13, 2), (Codes{0, 255, 0, 255}));
}

// A motion blur: each frame weighs half of the one after it.
TEST_F(EarlierFramesTest, LeaveTheirSums) {
    const std::string clear = "glClear(GL_COLOR_BUFFER_BIT);\n";
    const std::string blur = "glAccum(GL_MULT, 0.5); glAccum(GL_ACCUM, 0.5); glAccum(GL_RETURN, 1);\n";
    const std::vector<std::string> frames = {clear + kRedLeft + "glAccum(GL_LOAD, 1);\n", clear + kGreenBelow + blur,
                                             clear + "glRectf(0.9, 0.9, 1, 1);\n" + blur};
    const Codes second = codes_of(frame(frames, 1), 2, 13), third = codes_of(frame(frames, 2), 2, 13);
    EXPECT_EQ(second[0], 128);
    EXPECT_EQ(third[0], 64);
}

// Each frame adds 1/255. More frames than the limit are left out, by all renderers.
TEST_F(EarlierFramesTest, AreAtMostFifty) {
    const std::string state = std::string(kClear) + "glEnable(GL_BLEND); glBlendFunc(GL_ONE, GL_ONE);\n";
    const std::string add = "glColor3ub(1, 0, 0); glRectf(-1, -1, 1, 1);\n";
    std::vector<std::string> frames(61, add);
    frames.front() = state + add;
    EXPECT_EQ(codes_of(frame(frames, 40), 8, 8)[0], 41);
    EXPECT_EQ(codes_of(frame(frames, 50), 8, 8)[0], 51);
    const RecordedFrame beyond = frame(frames, 60);
    EXPECT_EQ(codes_of(beyond, 8, 8)[0], 51);
    EXPECT_NE(beyond.notes.at(0).find("the 50 before are drawn first, and those before them left out, as for"),
              std::string::npos)
        << beyond.notes.at(0);
}

// Frames that are too many for the memory are left out. The frame itself is still drawn.
TEST_F(EarlierFramesTest, AreLeftOutWhereTheMemoryDoesNotHoldThem) {
    std::string many = "glBegin(GL_POINTS);\n";
    for (int i = 0; i < 1000; ++i) many += "glVertex2f(2, 2);\n";
    const std::vector<std::string> frames(20, many + "glEnd();\n" + kGreenBelow);
    constexpr std::size_t kFewFrames = 2 << 20;
    const RecordedFrame recorded = frame(frames, 19, kFewFrames);
    EXPECT_EQ(codes_of(recorded, 2, 2), (Codes{0, 255, 0, 255}));
    EXPECT_NE(recorded.notes.at(0).find("they are too large to draw them first"), std::string::npos)
        << recorded.notes.at(0);
    EXPECT_EQ(frame(frames, 19).scene.frame.draws().size(), 40u);
}

}  // namespace
}  // namespace twinlight::earlier_frames_test
