// A driver that refuses shaders ends no other work, and nobody sees a page of GLSL. Mesa pretends to know no GLSL of the
// kind that is needed. (llvmpipe of Mesa 25.1 and later crashes when it pretends so; softpipe does not.)
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "../run_program.h"
#include "base/image/file.h"

namespace twinlight::refused_shaders_test {
namespace {

// $PROGRAM with these arguments; temporary files go to the folder.
ProgramResult run_without_shaders(const TemporaryFolder& folder, const std::string& arguments) {
    return run_shell(
        "twinlight",
        "TMPDIR=" + quoted(folder.str()) +
            " GALLIUM_DRIVER=softpipe MESA_GL_VERSION_OVERRIDE=2.1 MESA_GLSL_VERSION_OVERRIDE=120 \"$PROGRAM\" " +
            arguments);
}

TEST(RefusedShaders, AreReportedInOneLineThatNamesAFileWithTheText) {
    const TemporaryFolder folder;
    const ProgramResult result =
        run_without_shaders(folder, "render report --with programmable --size 16x16 -o " + quoted(folder / "a.png"));
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
    EXPECT_TRUE(result.err.starts_with("twinlight: the driver refuses a vertex shader: ")) << result.err;
    const std::string before = "; its text is in ";
    const std::size_t at = result.err.find(before);
    ASSERT_NE(at, std::string::npos) << result.err;
    const std::string file = result.err.substr(at + before.size(), result.err.size() - at - before.size() - 1);
    EXPECT_NE(read_file(file).find("1 #version"), std::string::npos);
}

TEST(RefusedShaders, AreAResultOfTheirCase) {
    const TemporaryFolder folder;
    const ProgramResult result = run_without_shaders(folder, "check spot-180-behind polygon-edge-on error-cutoff-91");
    EXPECT_EQ(result.status, 1) << result.err;
    for (const char* name : {"spot-180-behind", "polygon-edge-on", "error-cutoff-91"})
        EXPECT_NE(result.out.find(std::string("\n") + name), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("rejected: the driver refuses a vertex shader"), std::string::npos) << result.out;
    EXPECT_LT(std::ranges::count(result.out, '\n'), 20) << result.out;
}

TEST(RefusedShaders, LeaveTheOtherChoicesOfAStudy) {
    const TemporaryFolder folder;
    const ProgramResult result = run_without_shaders(
        folder, "study report --quick --size 16x16 --seconds 0 -o " + quoted(folder / "study") + " 2>&1 >/dev/null");
    EXPECT_EQ(result.status, 0) << result.out;
    EXPECT_NE(result.out.find("choices are left out: the driver refuses a vertex shader"), std::string::npos)
        << result.out;
    EXPECT_EQ(std::ranges::count(result.out, '\n'), 1) << result.out;
    EXPECT_NE(read_file(folder / "study/study.json").find("\"fixed\""), std::string::npos);
}

}  // namespace
}  // namespace twinlight::refused_shaders_test
