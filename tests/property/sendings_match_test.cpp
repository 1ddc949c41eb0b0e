// The fixed function draws the same picture, bit by bit, however the vertices are sent: for every built-in scene.
#include <gtest/gtest.h>

#include "render/context/context.h"
#include "render/fixed/replay.h"
#include "scene/command/text.h"
#include "scene/scenes/load.h"
#include "scene/state/state.h"

namespace twinlight::sendings_match_test {
namespace {

TEST(Sending, ChangesNothingOfThePicture) {
    constexpr int kWidth = 160, kHeight = 120;
    const auto context = make_offscreen_context(kWidth, kHeight);
    const auto picture = [&](const Frame& frame, fixed::Sending sending) {
        fixed::Replay(frame, {.sending = sending}).draw();
        return read_pixels(kWidth, kHeight);
    };
    std::vector<CommandList> scenes;
    for (const EmbeddedFile& file : kSceneFiles) scenes.push_back(read_built_in(file));
    // Colours and edge flags that vary from vertex to vertex, indices, and positions with a w.
    scenes.push_back(read_scene(R"(
glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
GLfloat positions[] = {-0.5, -0.5, 0, 0.5,  0.5, -0.5, 0, 1,  0.5, 0.5, 0, 1,  -0.5, 0.5, 0, 2};
GLfloat colors[] = {1, 0, 0,  0, 1, 0,  0, 0, 1,  1, 1, 0};
GLboolean flags[] = {1, 0, 1, 1};
GLubyte indices[] = {0, 1, 2, 2, 3, 0};
glEnableClientState(GL_VERTEX_ARRAY); glEnableClientState(GL_COLOR_ARRAY); glEnableClientState(GL_EDGE_FLAG_ARRAY);
glVertexPointer(4, GL_FLOAT, 0, positions); glColorPointer(3, GL_FLOAT, 0, colors); glEdgeFlagPointer(0, flags);
glDrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_BYTE, indices);
)",
                                "arrays", "arrays"));
    for (const CommandList& scene : scenes) {
        const std::string& name = scene.name;
        const Frame frame = make_frame(scene, {.width = kWidth, .height = kHeight});
        const Image buffers = picture(frame, fixed::Sending::kBuffers);
        EXPECT_NE(buffers.pixels, Image(kWidth, kHeight).pixels) << name << " draws nothing";
        EXPECT_TRUE(picture(frame, fixed::Sending::kClientArrays).pixels == buffers.pixels) << name;
        EXPECT_TRUE(picture(frame, fixed::Sending::kImmediate).pixels == buffers.pixels) << name;
        // In a display list Mesa cuts quadrilaterals along the other diagonal, which GL allows (3.5).
        Frame without_quads = frame;
        std::erase_if(without_quads.items, [](const auto& item) {
            const Draw* draw = std::get_if<Draw>(&item);
            return draw && (draw->mode == kGL_QUADS || draw->mode == kGL_QUAD_STRIP);
        });
        EXPECT_TRUE(picture(without_quads, fixed::Sending::kDisplayList).pixels ==
                    picture(without_quads, fixed::Sending::kBuffers).pixels)
            << name;
    }
}

}  // namespace
}  // namespace twinlight::sendings_match_test
