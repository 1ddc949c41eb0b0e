// A driver that refuses shaders ends no other work, and nobody sees a page of GLSL. Mesa pretends to know no GLSL of the
// kind that is needed. (llvmpipe of Mesa 25.1 and later crashes when it pretends so; softpipe does not.)
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
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
        run_without_shaders(folder, "render report --with shaders --size 16x16 -o " + quoted(folder / "a.png"));
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
    const ProgramResult result =
        run_without_shaders(folder, "study report --quick --size 16x16 --seconds 0 -o " + quoted(folder / "study"));
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.err.find("choices are left out: the driver refuses a vertex shader"), std::string::npos)
        << result.err;
    EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
    EXPECT_NE(read_file(folder / "study/study.json").find("\"fixed\""), std::string::npos);
}

TEST(RefusedShaders, LeaveTheOtherPicturesOfAComparison) {
    const TemporaryFolder folder;
    const ProgramResult result =
        run_without_shaders(folder, "compare report --step 1 --size 16x16 -o " + quoted(folder / "report"));
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.out.find("a picture by shaders (the driver refuses a vertex shader: "), std::string::npos)
        << result.out;
    EXPECT_NE(result.out.find("is not drawn by shaders."), std::string::npos) << result.out;
    EXPECT_TRUE(std::filesystem::exists(folder / "report/reference.png"));
}

// A driver's shaders have room for some thousand lights: on llvmpipe of Mesa 22.3 for 2048.
TEST(RefusedShaders, ForTooManyLightsSayHowManyTheDriverTakes) {
    const TemporaryFolder folder;
    const std::string scene = folder / "lights.gl";
    const auto write_lights = [&](int count) {
        std::string text = "glEnable(GL_LIGHTING);\n";
        for (int i = 8; i < 8 + count; ++i)
            text += "#pragma twinlight light(" + std::to_string(i) + ", GL_POSITION, " + std::to_string(i % 7) +
                    ", 2, 5, 1)\n#pragma twinlight light(" + std::to_string(i) + ", GL_DIFFUSE, 0.02, 0.02, 0.02, 1)\n";
        write_file_atomically(scene, text + "glutSolidSphere(1, 8, 8);\n");
    };
    const auto run = [&](const std::string& arguments) {
        return run_shell("twinlight", "TMPDIR=" + quoted(folder.str()) + " \"$PROGRAM\" " + arguments);
    };
    const std::string render =
        "render " + quoted(scene) + " --with shaders --size 16x12 -o " + quoted(folder / "p.png");
    write_lights(4096);
    const ProgramResult refused = run(render);
    if (refused.status == 0) GTEST_SKIP() << "this driver takes as many";
    EXPECT_EQ(refused.status, 2);
    const std::string before = "twinlight: a draw has more lights than the ",
                      after = " that this driver can have in a shader; --with reference draws them\n";
    ASSERT_TRUE(refused.err.starts_with(before) && refused.err.ends_with(after)) << refused.err;
    EXPECT_EQ(folder.names(), std::vector<std::string>{"lights.gl"});  // no text of a shader
    const int fitting = std::stoi(refused.err.substr(before.size()));

    const ProgramResult compared = run("compare " + quoted(scene) + " --size 16x12 -o " + quoted(folder / "report"));
    EXPECT_EQ(compared.status, 0) << compared.err;
    EXPECT_NE(compared.out.find("a picture by shaders (a draw has more lights than the " + std::to_string(fitting)),
              std::string::npos)
        << compared.out;
    EXPECT_TRUE(std::filesystem::exists(folder / "report/reference.png"));

    write_lights(fitting);
    EXPECT_EQ(run(render).status, 0);
    write_lights(fitting + 1);
    EXPECT_EQ(run(render).status, 2);
}

}  // namespace
}  // namespace twinlight::refused_shaders_test
