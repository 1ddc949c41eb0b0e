// The stencil buffer and the accumulation buffer: the driver's fixed function, the shaders and the reference give the same
// colours for each test and each operation, and those are the ones of 4.1.5 and 4.2.4.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "render/context/context.h"
#include "render/context/gl.h"
#include "render/context/render_target.h"
#include "render/fixed/fixed.h"
#include "render/fixed/replay.h"
#include "render/programmable/programmable.h"
#include "render/reference/reference.h"
#include "scene/command/text.h"
#include "scene/state/answers.h"
#include "scene/state/state.h"

namespace twinlight::stencil_accumulation_test {
namespace {

constexpr int kSize = 16;

class Buffers : public testing::Test {
  protected:
    static Scene scene_of(const std::string& text) {
        const auto list = std::make_shared<const CommandList>(read_scene(text, "scene.gl", "scene"));
        return make_scene(list, {.width = kSize, .height = kSize});
    }

    // The colour at a pixel (y up), which all renderers must agree on; `tolerance` in 1/255.
    Rgba color(const std::string& text, int x = 8, int y = 8, float tolerance = 0.51F) {
        const Scene scene = scene_of(text);
        EXPECT_TRUE(scene.frame.unsupported.empty()) << text;
        const Rgba expected = reference::render(scene.frame, {}).at(x, kSize - 1 - y);
        const auto expect = [&](const char* name, const Image& image) {
            const Rgba found = image.at(x, kSize - 1 - y);
            for (std::size_t i = 0; i < 4; ++i)
                EXPECT_NEAR(255 * found[i], 255 * expected[i], tolerance) << name << text;
        };
        expect("fixed\n", fixed::render(scene));
        fixed::Replay(scene.frame, {}).draw();
        expect("replayed\n", read_pixels(kSize, kSize));
        expect("shaders\n", renderer_.render(scene.frame, {}));
        return expected;
    }

    // The stencil value at a pixel after these commands: 16 squares are drawn, one for each value that a test can find.
    int stencil(const std::string& text, int x = 8, int y = 8) {
        std::string probe =
            text +
            "glEnable(GL_STENCIL_TEST); glDisable(GL_DEPTH_TEST); glDisable(GL_ALPHA_TEST);"
            "glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP); glDisable(GL_SCISSOR_TEST);\n"
            "glColorMask(1, 1, 1, 1); glEnable(GL_BLEND); glBlendFunc(GL_ONE, GL_ONE); glClearColor(0, 0, 0, 0);"
            "glClear(GL_COLOR_BUFFER_BIT); glDisable(GL_CULL_FACE); glFrontFace(GL_CCW);\n";
        for (int bit = 0; bit < 8; ++bit)
            probe += fmt::format("glStencilFunc(GL_EQUAL, 255, {}); glColor3ub({}, 0, 0); glRectf(-1, -1, 1, 1);\n",
                                 1 << bit, 1 << bit);
        return static_cast<int>(std::lround(255 * color(probe, x, y)[0]));
    }

    std::unique_ptr<OffscreenContext> context_ = make_offscreen_context(kSize, kSize);
    programmable::Renderer renderer_;
};

constexpr const char* kRect = "glRectf(-1, -1, 1, 1);\n";
// A stencil of this value everywhere, and the test enabled.
std::string start(int value) {
    return fmt::format("glClearStencil({}); glClear(GL_STENCIL_BUFFER_BIT); glEnable(GL_STENCIL_TEST);\n", value);
}

TEST_F(Buffers, StencilTestsCompareTheReferenceWithTheStoredValue) {
    const std::pair<const char*, std::function<bool(int, int)>> funcs[] = {
        {"GL_NEVER", [](int, int) { return false; }},
        {"GL_LESS", std::less<>()},
        {"GL_EQUAL", std::equal_to<>()},
        {"GL_LEQUAL", std::less_equal<>()},
        {"GL_GREATER", std::greater<>()},
        {"GL_NOTEQUAL", std::not_equal_to<>()},
        {"GL_GEQUAL", std::greater_equal<>()},
        {"GL_ALWAYS", [](int, int) { return true; }}};
    for (const auto& [name, passes] : funcs)
        for (const auto& [ref, stored, mask] :
             {std::array{2, 1, 255}, {1, 2, 255}, {2, 2, 255}, {6, 3, 2}, {5, 2, 4}, {300, 255, 255}, {-4, 0, 255}}) {
            const int clamped = std::clamp(ref, 0, 255);
            const Rgba found =
                color(start(stored) + fmt::format("glStencilFunc({}, {}, {});", name, ref, mask) + kRect);
            EXPECT_EQ(found[0], passes(clamped & mask, stored & mask) ? 1 : 0) << name << ref << stored << mask;
        }
}

TEST_F(Buffers, StencilOperationsChangeTheStoredValueThroughTheMask) {
    const auto after = [&](const char* operation, int stored, int mask = 255) {
        return stencil(start(stored) +
                       fmt::format("glStencilFunc(GL_ALWAYS, 77, 255); glStencilMask({}); "
                                   "glStencilOp(GL_KEEP, GL_KEEP, {});",
                                   mask, operation) +
                       kRect + "glStencilMask(255);");
    };
    EXPECT_EQ(after("GL_KEEP", 5), 5);
    EXPECT_EQ(after("GL_ZERO", 5), 0);
    EXPECT_EQ(after("GL_REPLACE", 5), 77);
    EXPECT_EQ(after("GL_INCR", 5), 6);
    EXPECT_EQ(after("GL_INCR", 255), 255);
    EXPECT_EQ(after("GL_INCR_WRAP", 255), 0);
    EXPECT_EQ(after("GL_DECR", 5), 4);
    EXPECT_EQ(after("GL_DECR", 0), 0);
    EXPECT_EQ(after("GL_DECR_WRAP", 0), 255);
    EXPECT_EQ(after("GL_INVERT", 5), 250);
    EXPECT_EQ(after("GL_INVERT", 5, 0x0F), 10);
    EXPECT_EQ(after("GL_REPLACE", 128, 0x0F), 128 + 13);
    EXPECT_EQ(after("GL_INCR", 15, 0x0F), 0) << "16 in the lowest four bits";
}

TEST_F(Buffers, EachOutcomeOfTheTestsHasItsOperation) {
    const std::string operations = "glStencilOp(GL_INCR, GL_INVERT, GL_ZERO); glEnable(GL_DEPTH_TEST);";
    EXPECT_EQ(stencil(start(5) + "glStencilFunc(GL_NEVER, 0, 255);" + operations + kRect), 6);
    EXPECT_EQ(stencil(start(5) + operations + "glDepthFunc(GL_NEVER);" + kRect), 250);
    EXPECT_EQ(stencil(start(5) + operations + kRect), 0);
    EXPECT_EQ(stencil(start(5) + operations + "glDepthFunc(GL_NEVER); glDisable(GL_DEPTH_TEST);" + kRect), 0);
    EXPECT_EQ(stencil(start(5) + operations + "glColorMask(0, 0, 0, 0);" + kRect), 0);
    // What the alpha test or the scissor drops never reaches the stencil test.
    EXPECT_EQ(stencil(start(5) + operations + "glEnable(GL_ALPHA_TEST); glAlphaFunc(GL_NEVER, 0);" + kRect), 5);
    EXPECT_EQ(stencil(start(5) + operations + "glEnable(GL_SCISSOR_TEST); glScissor(0, 0, 4, 4);" + kRect), 5);
    // A fragment that fails leaves colour and depth as they are.
    EXPECT_EQ(color(start(5) + "glEnable(GL_DEPTH_TEST); glStencilFunc(GL_EQUAL, 4, 255);" + kRect +
                    "glDisable(GL_STENCIL_TEST); glColor3f(0, 1, 0);" + kRect),
              (Rgba{0, 1, 0, 1}));
}

TEST_F(Buffers, FacesHaveTheirOwnStencilTest) {
    const std::string both =
        "glStencilOpSeparate(GL_FRONT, GL_KEEP, GL_KEEP, GL_INCR); glStencilMaskSeparate(GL_BACK, 3);\n"
        "glStencilFuncSeparate(GL_BACK, GL_ALWAYS, 7, 255); glStencilOpSeparate(GL_BACK, GL_KEEP, GL_KEEP, "
        "GL_REPLACE);\n";
    EXPECT_EQ(stencil(start(8) + both + kRect), 9);
    EXPECT_EQ(stencil(start(8) + both + "glFrontFace(GL_CW);" + kRect + "glStencilMask(255);"), 11);
    EXPECT_EQ(
        stencil(start(8) + both + "glFrontFace(GL_CW); glPointSize(9); glBegin(GL_POINTS); glVertex2f(0, 0); glEnd();"),
        9)
        << "points have a front";
}

TEST_F(Buffers, ClearsObeyScissorAndMask) {
    EXPECT_EQ(stencil("glClearStencil(0x1F5); glClear(GL_STENCIL_BUFFER_BIT);"), 0xF5);
    EXPECT_EQ(stencil("glStencilMask(0x3F); glClearStencil(255); glClear(GL_STENCIL_BUFFER_BIT); glStencilMask(255);"),
              0x3F);
    EXPECT_EQ(stencil("glStencilMaskSeparate(GL_BACK, 1); glClearStencil(255); glClear(GL_STENCIL_BUFFER_BIT);"
                      "glStencilMask(255);"),
              255)
        << "the front's mask counts";
    const std::string part =
        "glEnable(GL_SCISSOR_TEST); glScissor(0, 0, 8, 16); glClearStencil(9); glClear(GL_STENCIL_BUFFER_BIT);";
    EXPECT_EQ(stencil(part, 7, 8), 9);
    EXPECT_EQ(stencil(part, 8, 8), 0);
}

// Each picture starts with 0 in both buffers, whatever the one before left.
TEST_F(Buffers, StartEmptyInEachPicture) {
    const std::string leaves = start(200) + "glClear(GL_ACCUM_BUFFER_BIT);" + kRect + "glAccum(GL_LOAD, 1);";
    color(leaves);
    EXPECT_EQ(stencil(kRect), 0);
    EXPECT_EQ(color(std::string(kRect) + "glAccum(GL_RETURN, 1);"), (Rgba{0, 0, 0, 0}));
}

TEST_F(Buffers, AccumulationFollowsSection424) {
    const std::string first = "glColor4f(0.8, 0.4, 0, 1);" + std::string(kRect),
                      second = "glColor4f(0, 0.4, 0.6, 0);" + std::string(kRect);
    const auto expect = [&](const std::string& text, const Rgba& expected) {
        // The driver cuts each product to 16 bits, five times at most.
        const Rgba found = color(first + text, 8, 8, 1.1F);
        for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(255 * found[i], 255 * expected[i], 1) << text << i;
    };
    expect("glAccum(GL_LOAD, 0.5); glAccum(GL_RETURN, 1);", {0.4F, 0.2F, 0, 0.5F});
    expect("glAccum(GL_LOAD, 0.5); glAccum(GL_RETURN, 3);", {1, 0.6F, 0, 1});
    expect("glAccum(GL_LOAD, 0.5);" + second + "glAccum(GL_ACCUM, 0.5); glAccum(GL_RETURN, 1);",
           {0.4F, 0.4F, 0.3F, 0.5F});
    expect("glAccum(GL_LOAD, 0.5);" + second + "glAccum(GL_LOAD, 0.5); glAccum(GL_RETURN, 1);", {0, 0.2F, 0.3F, 0});
    expect("glAccum(GL_LOAD, 0.5); glAccum(GL_ADD, -0.25); glAccum(GL_RETURN, 1);", {0.15F, 0, 0, 0.25F});
    expect("glAccum(GL_LOAD, 0.5); glAccum(GL_ADD, -0.25); glAccum(GL_MULT, -2); glAccum(GL_RETURN, 1);",
           {0, 0.1F, 0.5F, 0});
    expect("glClearAccum(0.25, 0, 0.5, 2); glClear(GL_ACCUM_BUFFER_BIT); glAccum(GL_RETURN, 1);", {0.25F, 0, 0.5F, 1});
    expect("glAccum(GL_LOAD, 0.5); glColorMask(1, 0, 1, 0); glAccum(GL_RETURN, 1);", {0.4F, 0.4F, 0, 1});
    expect("glAccum(GL_LOAD, 0.5); glDrawBuffer(GL_NONE); glAccum(GL_RETURN, 1); glDrawBuffer(GL_BACK);",
           {0.8F, 0.4F, 0, 1});
    // No other operation on fragments applies.
    expect(
        "glAccum(GL_LOAD, 0.5); glEnable(GL_BLEND); glBlendFunc(GL_ZERO, GL_ONE); glEnable(GL_DEPTH_TEST);"
        "glDepthFunc(GL_NEVER); glEnable(GL_ALPHA_TEST); glAlphaFunc(GL_NEVER, 0); glEnable(GL_STENCIL_TEST);"
        "glStencilFunc(GL_NEVER, 0, 255); glAccum(GL_RETURN, 1);",
        {0.4F, 0.2F, 0, 0.5F});
    const std::string left = "glEnable(GL_SCISSOR_TEST); glScissor(0, 0, 9, 16);", right = "glScissor(9, 0, 9, 16);";
    expect(left + "glAccum(GL_LOAD, 0.5); glAccum(GL_RETURN, 1);", {0.4F, 0.2F, 0, 0.5F});
    expect("glAccum(GL_LOAD, 0.5);" + left + right + "glAccum(GL_RETURN, 1);", {0.8F, 0.4F, 0, 1});
    expect(left + right + "glAccum(GL_LOAD, 0.5); glDisable(GL_SCISSOR_TEST); glAccum(GL_RETURN, 1);", {0, 0, 0, 0});
}

// Framebuffer objects have no accumulation buffer, so there the fixed function gets one too.
TEST_F(Buffers, AccumulateInAFramebufferObjectToo) {
    const Scene scene = scene_of("glColor4f(0.8, 0.4, 0, 1);" + std::string(kRect) +
                                 "glAccum(GL_LOAD, 0.5); glEnable(GL_LIGHTING); glMatrixMode(GL_TEXTURE);"
                                 "glColor4f(0, 0.4, 0.6, 1); glAccum(GL_ACCUM, 0.25); glAccum(GL_RETURN, 1);");
    const RenderTarget target(kSize, kSize, ColorBuffer::kUnorm8);
    for (const bool fixed : {true, false}) {
        target.bind();
        if (fixed)
            fixed::draw(scene);
        else
            renderer_.draw(scene.frame, {});
        target.resolve();
        const Rgba found = target.read().at(8, 8);
        EXPECT_NEAR(found[0], 0.6, 0.5 / 255) << fixed;
        EXPECT_NEAR(found[1], 0.3, 0.51 / 255) << fixed;
    }
}

// ---- What is kept of a picture ----

TEST(DropHidden, KeepsWhatTheBuffersHoldOfEarlierPictures) {
    const auto items_after = [](const std::string& text) {
        State state({.width = kSize, .height = kSize});
        for (const Command& command : read_scene(text, "scene.gl", "scene").commands) {
            state.apply(command);
            state.drop_hidden();
        }
        return state.items().size();
    };
    const std::string
        rect = kRect,
        clear = "glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);",
        clear_all = "glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT | GL_ACCUM_BUFFER_BIT);";
    EXPECT_EQ(items_after(rect + clear), 1U);
    EXPECT_EQ(items_after(rect + "glAccum(GL_LOAD, 1);" + clear), 3U);
    EXPECT_EQ(items_after(rect + "glAccum(GL_LOAD, 1);" + clear_all), 1U);
    EXPECT_EQ(items_after("glEnable(GL_STENCIL_TEST);" + rect + clear), 2U);
    EXPECT_EQ(items_after("glEnable(GL_STENCIL_TEST);" + rect + clear_all), 1U);
    EXPECT_EQ(items_after("glEnable(GL_STENCIL_TEST);" + rect + "glStencilMask(1);" + clear_all), 2U);
    EXPECT_EQ(items_after("glClearStencil(1); glClear(GL_STENCIL_BUFFER_BIT);" + clear), 2U);
    // GL_LOAD forgets all that was accumulated, so the last clear hides what came before it.
    EXPECT_EQ(items_after(rect + "glAccum(GL_LOAD, 1);" + clear + rect + "glAccum(GL_LOAD, 1);"), 3U);
    EXPECT_EQ(items_after(rect + "glAccum(GL_LOAD, 1);" + clear + rect + "glAccum(GL_RETURN, 1); glAccum(GL_LOAD, 1);"),
              6U);
}

// An edge that marks the stencil buffer is an edge of what is drawn through it.
TEST(AllowedDifference, OpensPixelsWhoseStencilValueIsOpen) {
    const auto list = std::make_shared<const CommandList>(read_scene(
        "glEnable(GL_STENCIL_TEST); glStencilFunc(GL_ALWAYS, 1, 255); glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);\n"
        "glColorMask(0, 0, 0, 0); glRectf(-0.4375, -0.5, 0.5, 0.5); glColorMask(1, 1, 1, 1);\n"
        "glStencilFunc(GL_EQUAL, 1, 255); glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP); glRectf(-1, -1, 1, 1);\n"
        "glAccum(GL_LOAD, 0.5); glClear(GL_COLOR_BUFFER_BIT); glAccum(GL_RETURN, 1);",
        "scene.gl", "scene"));
    const Frame frame = make_frame(*list, {.width = kSize, .height = kSize});
    const AllowedDifference allowed = reference::allowed_difference(frame);
    const auto is_edge = [&](int x, int y) { return static_cast<bool>(allowed.edge[allowed.index(x, y)]); };
    EXPECT_TRUE(is_edge(4, 8) || is_edge(3, 8));
    EXPECT_FALSE(is_edge(10, 10)) << "inside, beside the diagonal";
    EXPECT_FALSE(is_edge(1, 8));
}

}  // namespace
}  // namespace twinlight::stencil_accumulation_test
