#include "command/names.h"

#include <gtest/gtest.h>

#include <set>

#include "command/command.h"
#include "context/gl.h"

namespace twinlight {

namespace {

TEST(Names, HaveTheValuesOfTheSystemsHeaders) {
#define ENUM(name, value) EXPECT_EQ(kGL_##name, static_cast<Enum>(GL_##name)) << "GL_" #name;
#define GLU_ENUM(name, value) EXPECT_EQ(kGLU_##name, static_cast<Enum>(GLU_##name)) << "GLU_" #name;
#include "command/enums.def"
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

TEST(Commands, HaveAnArrayWhoseLengthIsNotKnownOnlyAsTheLastArgument) {
    for (const Signature& sig : signatures()) {
        for (std::size_t i = 0; i + 1 < sig.c_arguments(); ++i) {
            const Extent extent = sig.parameters[i].extent;
            EXPECT_TRUE(extent != Extent::kByPname && extent != Extent::kOutput && extent != Extent::kRest)
                << sig.usage();
        }
    }
}

TEST(Commands, WithAnArrayByPnameHaveThePnameJustBeforeIt) {
    for (std::size_t i = 0; i < signatures().size(); ++i) {
        const Signature& sig = signatures()[i];
        if (sig.parameters.empty()) continue;
        const Extent extent = sig.parameters.back().extent;
        if (extent != Extent::kByPname && extent != Extent::kOutput) continue;
        EXPECT_EQ(sig.parameters[sig.scalars() - 1].name, "pname") << sig.usage();
        EXPECT_TRUE(owner_of(static_cast<CommandId>(i))) << sig.usage();
    }
}

}  // namespace

}  // namespace twinlight
