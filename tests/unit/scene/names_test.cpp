#include "scene/command/names.h"

#include <gtest/gtest.h>

#include <set>

#include "render/context/gl.h"
#include "scene/command/command.h"
#include "scene/command/object_names.h"
#include "scene/command/text.h"

namespace twinlight::names_test {

namespace {

TEST(Names, HaveTheValuesOfTheSystemsHeaders) {
#define ENUM(name, value) EXPECT_EQ(kGL_##name, static_cast<Enum>(GL_##name)) << "GL_" #name;
#define GLU_ENUM(name, value) EXPECT_EQ(kGLU_##name, static_cast<Enum>(GLU_##name)) << "GLU_" #name;
#include "scene/command/enums.def"
#undef ENUM
#undef GLU_ENUM
}

TEST(Names, StandInTheTableOnce) {
    std::set<std::string_view> seen;
    for (const NamedValue& row : gl_names()) EXPECT_TRUE(seen.insert(row.name).second) << row.name;
}

TEST(Names, ReadBackAsTheSameValue) {
    for (const NamedValue& row : gl_names()) {
        EXPECT_EQ(find_gl_name(row.name), row.value);
        if (row.value > kGL_POLYGON && !row.name.ends_with("_BIT")) {
            EXPECT_EQ(find_gl_name(enum_name(row.value)), row.value);
        }
    }
    for (Enum mode = kGL_POINTS; mode <= kGL_POLYGON; ++mode) EXPECT_EQ(find_gl_name(primitive_name(mode)), mode);
}

// 0 to 9 are GL_POINTS, GL_ZERO, GL_NONE, GL_FALSE and others.
TEST(Names, OfSmallValuesArePrintedByWhatTheCommandMeans) {
    const std::string text =
        "glDrawArrays(GL_LINES, 0, 0);\nglBegin(GL_POINTS);\nglEnd();\nglBlendFunc(GL_ONE, GL_ZERO);\n"
        "glStencilOp(GL_ZERO, GL_KEEP, GL_INVERT);\nglDrawBuffer(GL_NONE);\n";
    EXPECT_EQ(print_scene(read_scene(text, "a.gl", "a")), text);
}

TEST(Names, FindTheNearestToAMisspeltOne) {
    const std::vector<std::string_view> candidates = {"GL_LIGHT0", "GL_LIGHTING", "GL_SPOT_CUTOFF"};
    EXPECT_EQ(nearest("GL_LIGTHING", candidates), "GL_LIGHTING");  // two letters swapped
    EXPECT_EQ(nearest("GL_SPOT_CUTOF", candidates), "GL_SPOT_CUTOFF");
    EXPECT_EQ(nearest("xyz", candidates), std::nullopt);
    EXPECT_EQ(nearest("", candidates), std::nullopt);
}

TEST(Commands, StandInTheTableOnceAndFindThemselves) {
    for (std::size_t i = 0; i < signatures().size(); ++i) {
        const Signature& sig = signatures()[i];
        const auto found = sig.family == Family::kPragma ? find_pragma(sig.name) : find_command(sig.name);
        ASSERT_TRUE(found) << sig.name;
        EXPECT_EQ(static_cast<std::size_t>(*found), i) << sig.name;
    }
}

TEST(Commands, HaveWhatVariesInLengthLast) {
    for (const Signature& sig : signatures()) {
        for (std::size_t i = 0; i < sig.parameters.size(); ++i) {
            const Extent extent = sig.parameters[i].extent;
            if (sig.parameters[i].is_by_pname() || extent == Extent::kRest || extent == Extent::kResult) {
                EXPECT_EQ(i + 1, sig.parameters.size()) << sig.usage();
            }
        }
    }
}

TEST(Commands, WithAnArrayByPnameHaveThePnameJustBeforeIt) {
    for (std::size_t i = 0; i < signatures().size(); ++i) {
        const Signature& sig = signatures()[i];
        if (sig.parameters.empty()) continue;
        if (!sig.parameters.back().is_by_pname()) continue;
        EXPECT_EQ(sig.parameters[sig.parameters.size() - 2].name, "pname") << sig.usage();
        const bool asks_state = sig.name.starts_with("glGet") && sig.parameters.size() == 2;
        EXPECT_TRUE(asks_state || owner_of(static_cast<CommandId>(i))) << sig.usage();
    }
}

TEST(Commands, WithACountedArrayHaveTheCountBeforeIt) {
    int counted = 0;
    for (const Signature& sig : signatures()) {
        bool has_count = false;
        for (const Parameter& parameter : sig.parameters) {
            has_count |= parameter.kind == Kind::kSizei;
            if (parameter.extent != Extent::kArrayByCount && parameter.extent != Extent::kNewNames &&
                parameter.extent != Extent::kOutputByCount)
                continue;
            ++counted;
            EXPECT_TRUE(has_count) << sig.usage();
            if (parameter.extent == Extent::kNewNames) {
                EXPECT_TRUE(named_objects(parameter)) << sig.usage();
            }
        }
    }
    EXPECT_GT(counted, 0);
}

TEST(Commands, KnowWhereEachParametersValuesStand) {
    const Command rect{CommandId::glRectfv, {1, 2, 3, 4}, {}};
    EXPECT_EQ(rect.first(1), 2u);
    EXPECT_EQ(rect.values(1)[1], 4);
    const Command names{CommandId::glDeleteTextures, {3, 7, 8, 9}, {}};
    EXPECT_EQ(names.count(1), 3u);
    EXPECT_EQ(names.array()[2], 9);
    EXPECT_EQ((Command{CommandId::glDeleteTextures, {-1}, {}}).count(1), 0u);
}

TEST(ObjectNames, FindTheFirstRowThatIsFree) {
    ObjectNames names;
    for (double taken : {2, 3, 7}) names.take(ObjectType::kList, taken, 1);
    EXPECT_EQ(names.next(ObjectType::kList, 1), 1u);
    EXPECT_EQ(names.next(ObjectType::kList, 3), 4u);
    EXPECT_EQ(names.next(ObjectType::kList, 4), 8u);
    EXPECT_EQ(names.next(ObjectType::kTexture, 4), 1u);
    names.take(ObjectType::kList, 1, 20);
    EXPECT_EQ(names.next(ObjectType::kList, 1), 21u);
    names.take(ObjectType::kList, 21, 4294967295.0 - 21);
    EXPECT_EQ(names.next(ObjectType::kList, 1), 4294967295u);
    EXPECT_EQ(names.next(ObjectType::kList, 2), 0u);
}

}  // namespace

}  // namespace twinlight::names_test
