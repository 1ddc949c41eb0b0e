#include "scene/shape/written_out.h"

#include <gtest/gtest.h>

#include "render/reference/reference.h"
#include "scene/command/text.h"
#include "scene/state/state.h"

namespace twinlight::written_out_test {

namespace {

TEST(PragmasWrittenOut, DrawTheSamePicture) {
    const CommandList scene = read_scene(
        "glRotated(30, 1, 1, 0); glScaled(0.4, 0.4, 0.4);\n"
        "glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glEnable(GL_DEPTH_TEST); glEnable(GL_NORMALIZE);\n"
        "#pragma twinlight shape(cube, 1)\n"
        "glTranslated(1.2, 0, 0);\n"
        "#pragma twinlight shape(cylinder, 0.5, 1, 12)\n"
        "glTranslated(-2.4, 0, 0);\n"
        "#pragma twinlight shape(cone, 0.5, 1, 12)\n"
        "glTranslated(0, 1.3, 0);\n"
        "#pragma twinlight shape(sphere, 0.5, 12, 6)\n",
        "scene.gl", "scene");
    const CommandList written_out = with_pragmas_written_out(scene);
    for (const Command& command : written_out.commands) EXPECT_NE(command.id, CommandId::pragma_shape);
    const auto picture = [](const CommandList& list) {
        const StateOptions options{.width = 64, .height = 64};
        return reference::render(make_frame(list, options), {});
    };
    EXPECT_EQ(picture(scene).pixels, picture(written_out).pixels);
}

}  // namespace

}  // namespace twinlight::written_out_test
