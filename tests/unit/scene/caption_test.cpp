// What the window and `twinlight scenes` say about a scene.
#include "scene/scenes/caption.h"

#include <gtest/gtest.h>

#include "scene/command/text.h"
#include "scene/scenes/load.h"

namespace twinlight::caption_test {
namespace {

Caption caption(const std::string& text) { return caption_of(read_scene(text, "s.gl", "s.gl")); }

TEST(SceneCaption, IsTheTitleAndWhatToNotice) {
    const Caption both = caption(
        "// A lamp at (0, 1.5, 0). It is\n// white.\n//\n// Light falls. Notice the edge. It is sharp.\n"
        "// twinlight: allow(lighting-off)\nglutSolidCube(1);  // a cube\n");
    EXPECT_EQ(both.title, "A lamp at (0, 1.5, 0).");
    EXPECT_EQ(both.notice, "Notice the edge. It is sharp.");
    EXPECT_EQ(both.all, "A lamp at (0, 1.5, 0). It is white.\n\nLight falls. Notice the edge. It is sharp.");
}

TEST(SceneCaption, WithoutANoticeItIsWhatFollowsTheTitle) {
    EXPECT_EQ(caption("// One.\n// Two. Three! Four.\nglutSolidCube(1);").notice, "Two. Three!");
    EXPECT_EQ(caption("// One\nglutSolidCube(1);").notice, "");
    EXPECT_EQ(caption("glutSolidCube(1);\n// One").title, "");
}

TEST(SceneCaption, MayBeInChinese) {
    const Caption found = caption("// 一盏灯。\n// 注意边缘。它很清楚。别的。\nglutSolidCube(1);");
    EXPECT_EQ(found.title, "一盏灯。");
    EXPECT_EQ(found.notice, "注意边缘。它很清楚。");
}

TEST(SceneCaption, EveryBuiltInSceneHasOne) {
    for (const EmbeddedFile& file : kSceneFiles) {
        const Caption found = caption_of(read_built_in(file));
        EXPECT_NE(found.title, "") << file.name;
        EXPECT_NE(found.notice, "") << file.name;
    }
}

}  // namespace
}  // namespace twinlight::caption_test
