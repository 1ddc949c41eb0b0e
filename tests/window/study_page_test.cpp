// The study's page in a browser without a window: it is opened, pointed at, its sliders are moved, its table is sorted.
#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <string>

#include "../unit/run_program.h"
#include "base/text/json.h"
#include "browser.h"

namespace twinlight::study_page_test {
namespace {

using nlohmann::json;

constexpr const char* kScene = R"(
glMatrixMode(GL_PROJECTION); gluPerspective(45, 1, 1, 10);
glMatrixMode(GL_MODELVIEW); glTranslatef(0, 0, -4);
glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glEnable(GL_DEPTH_TEST);
glMaterialfv(GL_FRONT, GL_SPECULAR, (float[]){0.5, 0.5, 0.5, 1}); glMaterialf(GL_FRONT, GL_SHININESS, 20);
glutSolidSphere(1, 16, 8);
)";

// Ahead of the page: what the console would show, and what does not load. Time is the browser's own here, which it lets pass
// faster, at times without drawing: who waits for the next picture waits for a while instead.
constexpr const char* kListens = R"js(<script>
window.complaints = [];
window.requestAnimationFrame = (answer) => setTimeout(() => answer(performance.now()), 16);
console.error = console.warn = (...words) => complaints.push(words.join(" "));
addEventListener("error", (event) => complaints.push(event.message ?? "not loaded: " + event.target.src), true);
addEventListener("unhandledrejection", (event) => complaints.push(String(event.reason)));
</script>)js";

// What study_page.js leaves behind.
json told_by(const std::string& program, const std::string& page, const TemporaryFolder& folder) {
    std::string text = read_file(page);
    text.insert(text.rfind("</body>"), "<script>" + read_file("tests/window/study_page.js") + "</script>");
    text.insert(text.find("<head>") + 6, kListens);
    std::ofstream(folder / "used.html", std::ios::binary) << text;
    return json_of_page("timeout 60 " + program, "--disable-gpu --window-size=1200,900", "used.html", folder);
}

class StudyPage : public testing::Test {
  protected:
    void SetUp() override {
        program_ = browser();
        if (program_.empty()) GTEST_SKIP() << "there is no chromium (apt-get install chromium)";
        std::ofstream(folder_ / "scene.gl") << kScene;
        const ProgramResult result = run_program("twinlight", {"study", folder_ / "scene.gl", "-o", folder_ / "study",
                                                               "--quick", "--seconds", "0", "--size", "40x40"});
        ASSERT_EQ(result.status, 0) << result.err;
    }
    json told(const std::string& name) { return told_by(program_, folder_ / (name + "/index.html"), folder_); }

    TemporaryFolder folder_;
    std::string program_;
};

TEST_F(StudyPage, AnswersWhoPointsSlidesSortsAndFilters) {
    const json told = this->told("study");
    EXPECT_EQ(told["complaints"], json::array());
    EXPECT_GT(told["dots"], 30);
    EXPECT_EQ(told["hidden_at_first"], true);
    EXPECT_TRUE(told["pointed_at"].get<std::string>().starts_with("fixed function, flat, 64 slices (")) << told.dump(1);
    EXPECT_EQ(told["picture"], json({40, true}));
    EXPECT_EQ(told["difference"], 40);
    EXPECT_NE(told["key_moves"][0], told["key_moves"][1]);

    for (const char* side : {"rough", "fine"})
        EXPECT_TRUE(told[side][1].get<std::string>().starts_with("The fastest choice: ")) << told[side];
    EXPECT_GT(std::stod(told["rough"][0].get<std::string>()), 10 * std::stod(told["fine"][0].get<std::string>()));
    EXPECT_EQ(told["wiped"], "inset(0px 0px 0px 25%)");

    const auto numbers = [](const json& column) {
        std::vector<double> values;
        for (const json& text : column) values.push_back(std::stod(text.get<std::string>()));
        return values;
    };
    const std::vector<double> rising = numbers(told["rising"]), falling = numbers(told["falling"]);
    EXPECT_FALSE(std::ranges::is_sorted(numbers(told["unsorted"])));
    EXPECT_TRUE(std::ranges::is_sorted(rising));
    EXPECT_TRUE(std::ranges::is_sorted(falling, std::greater{}));
    EXPECT_EQ(rising.size(), falling.size());

    EXPECT_LT(told["dots_filtered"], told["dots"]);
    EXPECT_LT(told["rows_filtered"].get<std::size_t>(), rising.size());
    EXPECT_GT(told["measures"].size(), 1U);
    EXPECT_NE(told["legend"].get<std::string>().find("phong"), std::string::npos);
    ASSERT_EQ(told["orders"].size(), 3U);  // flat, gouraud, phong
    for (const json& label : told["orders"])
        EXPECT_NE(label.get<std::string>().find(": order "), std::string::npos) << label;
}

TEST_F(StudyPage, ShowsSeveralMachines) {
    const std::string file = folder_ / "study/study.json";
    ASSERT_EQ(run_program("twinlight", {"study", "--merge", file, file, "-o", folder_ / "both"}).status, 0);
    const json told = this->told("both");
    EXPECT_EQ(told["complaints"], json::array());
    EXPECT_EQ(told["orders"].size(), 6U);
}

}  // namespace
}  // namespace twinlight::study_page_test
