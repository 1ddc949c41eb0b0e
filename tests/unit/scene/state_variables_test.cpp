// The rows of state variables, and that the attribute stack saves what the tables of 6.2 say.
#include "scene/state/state_variables.h"

#include <gtest/gtest.h>

#include <set>

#include "scene/command/text.h"
#include "scene/frame/parameter_rows.h"
#include "scene/state/answers.h"

namespace twinlight::state_variables_test {

namespace {

State after(std::string_view text) {
    State state;
    for (const Command& command : read_scene(text, "scene.gl", "scene").commands) state.apply(command);
    return state;
}

TEST(StateVariables, HaveANameAndAGroup) {
    std::set<Enum> names;
    for (const StateVariable& row : state_variables()) {
        EXPECT_NE(row.groups, 0U) << enum_name(row.pname);
        if (row.pname == 0) continue;
        EXPECT_TRUE(names.insert(row.pname).second) << enum_name(row.pname) << " has two rows";
        EXPECT_EQ(find_state_variable(row.pname), &row);
        EXPECT_FALSE(row.values(State().attributes()).empty()) << enum_name(row.pname);
        const Attributes attributes;
        EXPECT_TRUE(!row.is_capability() || row.flag(attributes)) << enum_name(row.pname);
    }
    EXPECT_EQ(find_state_variable(kGL_MAX_LIGHTS), nullptr);
    EXPECT_EQ(find_state_variable(0), nullptr);
}

// Each capability can be turned on, and glPopAttrib restores it for each of its bits, and for no other.
TEST(StateVariables, AreRestoredByTheirBits) {
    constexpr Enum kBits[] = {
        kGL_CURRENT_BIT,   kGL_POINT_BIT,        kGL_LINE_BIT,         kGL_POLYGON_BIT,         kGL_LIGHTING_BIT,
        kGL_FOG_BIT,       kGL_DEPTH_BUFFER_BIT, kGL_ACCUM_BUFFER_BIT, kGL_VIEWPORT_BIT,        kGL_STENCIL_BUFFER_BIT,
        kGL_TRANSFORM_BIT, kGL_ENABLE_BIT,       kGL_SCISSOR_BIT,      kGL_COLOR_BUFFER_BIT,    kGL_HINT_BIT,
        kGL_EVAL_BIT,      kGL_PIXEL_MODE_BIT,   kGL_LIST_BIT,         kGL_POLYGON_STIPPLE_BIT, kGL_TEXTURE_BIT};
    for (const StateVariable& row : state_variables()) {
        if (!row.is_capability()) continue;
        const std::string cap = enum_name(row.pname), on = "glEnable(" + cap + "); ";
        for (const Enum bit : kBits) {
            const State state = after("glPushAttrib(" + enum_name(bit) + "); " + on + "glPopAttrib();");
            EXPECT_EQ(answer(state, row.pname).front() == 0, (row.groups & bit) != 0)
                << cap << " and " << enum_name(bit);
        }
    }
}

// Tables 6.16 and 6.17: all parameters of a texture belong to GL_TEXTURE_BIT, those of depth textures too.
TEST(StateVariables, OfTexturesAreRestoredWhole) {
    const std::string set =
        "glTexParameteri(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, GL_INTENSITY);"
        "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);"
        "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_GREATER);"
        "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);"
        "glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MIN_LOD, 3);";
    const Texture changed = after(set).bound_texture(kGL_TEXTURE_2D);
    EXPECT_EQ(changed.compare_func, Enum{kGL_GREATER});
    const State state = after("glPushAttrib(GL_TEXTURE_BIT); " + set + "glPopAttrib();");
    for (const ParameterRow<Texture>& row : kTextureParameters)
        EXPECT_TRUE(has_equal(state.bound_texture(kGL_TEXTURE_2D), Texture(), row)) << enum_name(row.pname);
}

}  // namespace

}  // namespace twinlight::state_variables_test
