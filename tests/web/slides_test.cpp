// The lecture as slides (tools/slides), in Chromium.
#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "../unit/run_program.h"
#include "../window/browser.h"
#include "base/image/file.h"
#include "base/text/json.h"

namespace twinlight::slides_test {
namespace {

using Json = nlohmann::json;

std::size_t headings_of(const std::string& page) {
    std::size_t count = 0;
    std::istringstream lines(read_file(page));
    for (std::string line; std::getline(lines, line);)
        count += line.starts_with("# ") || line.starts_with("## ") || line.starts_with("### ");
    return count;
}

TEST(Slides, HaveAHeadingEachAndALiveScene) {
    const std::string program = browser();
    if (program.empty()) GTEST_SKIP() << "there is no chromium (apt-get install chromium)";
    if (first_installed({"cmark-gfm"}).empty()) GTEST_SKIP() << "there is no cmark-gfm (apt-get install cmark-gfm)";
    const TemporaryFolder folder;
    const std::string slides = folder / "slides";
    const ProgramResult made = run_shell("twinlight", "tools/slides/slides.sh \"$PROGRAM\" " + slides);
    ASSERT_EQ(made.status, 0) << made.err;
    const ProgramResult run = run_shell("", "timeout 300 node tests/web/slides.mjs " + slides + " " + program);
    ASSERT_EQ(run.status, 0) << run.err;
    const Json told = Json::parse(run.out);
    for (const auto& [page, source] :
         {std::pair("index.html", "docs/lecture.md"), {"zh.html", "docs/zh-CN/lecture.md"}}) {
        SCOPED_TRACE(page);
        const std::vector<std::string> titles = told[page]["titles"];
        EXPECT_EQ(titles.size(), headings_of(source));
        for (const std::string& title : titles) EXPECT_TRUE(!title.empty() && title.find('|') == title.npos) << title;
        EXPECT_EQ(told[page]["crowded"], Json::array());
        EXPECT_EQ(told[page]["place"], std::to_string(titles.size()) + " / " + std::to_string(titles.size()));
    }
    EXPECT_EQ(told["before"], (Json{"The standard model", 0, 1, 0})) << "the scene, no notes, no picture";
    EXPECT_NE(told["notes"].get<std::string>().find("Notice that each pixel"), std::string::npos) << told["notes"];
    EXPECT_NE(told["notes"].get<std::string>().find("only the specular term has v in it"), std::string::npos);
    EXPECT_EQ(told["pictures"], (Json{0, 1}));
    EXPECT_EQ(told["complaints"], Json::array());
    EXPECT_GT(told["scene"][0].get<int>(), 100) << "colours of the scene";
    EXPECT_EQ(told["scene"][1], false) << "only the picture";
    EXPECT_EQ(told["scene"][2], "Diffuse");
}

}  // namespace
}  // namespace twinlight::slides_test
