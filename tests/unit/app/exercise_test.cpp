// twinlight explain --as exercise: an exam sheet.
#include <gtest/gtest.h>

#include <regex>
#include <string>

#include "../run_program.h"
#include "base/image/file.h"

namespace twinlight::exercise_test {
namespace {

std::size_t count(const std::string& text, const std::string& what) {
    std::size_t found = 0;
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += what.size()) ++found;
    return found;
}

// The cells of a row by its symbol.
std::string row(const std::string& page, const std::string& symbol) {
    const std::size_t at = page.find("<th scope=\"row\">" + symbol + "</th>");
    return at == page.npos ? "" : page.substr(at, page.find("</tr>", at) - at);
}

struct Sheet {
    std::string question, solution;
};
Sheet sheet_of(const std::string& arguments) {
    const ProgramResult result = run_shell("twinlight", "\"$PROGRAM\" explain " + arguments + " --as exercise -o -");
    EXPECT_EQ(result.status, 0) << result.err;
    const std::size_t middle = result.out.find("<section class=\"solution\">");
    EXPECT_NE(middle, std::string::npos);
    return {result.out.substr(0, middle), result.out.substr(middle)};
}

TEST(Exercise, HasTheGivenNumbersAndBlanksAndThenTheSolution) {
    const auto [question, solution] = sheet_of("report --pixel 351,225");
    // Given: what the scene says, and the place and normal of the pixel.
    EXPECT_NE(question.find("<td>0.45</td><td>0.85</td><td>0.4</td>"), std::string::npos) << "d_cm";
    EXPECT_NE(question.find("GL_LIGHT0: k0 = 1, k1 = 0.09, k2 = 0.032"), std::string::npos);
    EXPECT_NE(question.find("GL_SHININESS: s = 32"), std::string::npos);
    EXPECT_NE(row(question, "n").find("(-0.40796, 0.16671, 0.89765)"), std::string::npos) << row(question, "n");
    // Blank: each result. The solution has it, with the way to it.
    for (const std::string symbol :
         {"VP", "att", "n.VP", "r", "r.v", "(r.v)^s", "diffuse", "specular", "sum", "c_pri", "clamped"}) {
        EXPECT_NE(row(question, symbol).find("class=\"blank\""), std::string::npos) << symbol;
        EXPECT_FALSE(std::regex_search(row(question, symbol), std::regex("[0-9]\\.[0-9]"))) << row(question, symbol);
        EXPECT_TRUE(std::regex_search(row(solution, symbol), std::regex("[0-9]"))) << symbol;
    }
    EXPECT_NE(row(question, "att").find("1 / (k0 + k1 d + k2 d d)"), std::string::npos);
    EXPECT_EQ(count(solution, "class=\"blank\""), 0U);
    // The two lamps.
    EXPECT_EQ(count(question, ">n.VP</th>"), 2U);
    EXPECT_EQ(count(question, "data:image/png;base64,"), 1U);
    EXPECT_EQ(question.find("http"), std::string::npos);
}

TEST(Exercise, AsksForAVertexWithGouraudShading) {
    const auto [question, solution] = sheet_of("attenuation --pixel 200,240 --shading gouraud");
    EXPECT_TRUE(
        std::regex_search(question, std::regex("vertex [0-9]+ of draw [0-9]+, which counts most at pixel 200, 240")));
}

TEST(Exercise, RefusesBadUse) {
    const auto error_of = [](const std::string& arguments) {
        const ProgramResult result = run_shell("twinlight", "\"$PROGRAM\" explain terms " + arguments);
        EXPECT_EQ(result.status, 2);
        return result.err;
    };
    EXPECT_EQ(error_of("--as exercise --pixel 1,1"), "twinlight: --as exercise needs --pixel X,Y and -o FILE.html\n");
    EXPECT_EQ(error_of("--as exercise -o x.html"), "twinlight: --as exercise needs --pixel X,Y and -o FILE.html\n");
    EXPECT_EQ(error_of("-o x.html"), "twinlight: -o needs --as exercise\n");
    EXPECT_EQ(error_of("--as exercise --pixel 1,1 -o - --json"), "twinlight: choose --json or --as exercise\n");
    EXPECT_EQ(error_of("--as exercise --pixel 1,1 -o -"),
              "twinlight: --as exercise: no lit surface shows at pixel 1,1\n");
}

}  // namespace
}  // namespace twinlight::exercise_test
