// The pages of compare and check in a browser without a window: what they open on, their buttons, steps and filters.
#include <gtest/gtest.h>

#include <string>

#include "../unit/compare_three_ways.h"
#include "../unit/run_program.h"
#include "base/image/file.h"
#include "base/text/json.h"
#include "browser.h"
#include "judge/report/report.h"
#include "scene/command/text.h"
#include "scene/state/state.h"

namespace twinlight::comparison_page_test {
namespace {

using nlohmann::json;

// Before the page: collects what the console would show, and what does not load.
constexpr const char* kListens = R"js(<script>
window.complaints = [];
console.error = console.warn = (...words) => complaints.push(words.join(" "));
addEventListener("error", (event) => complaints.push(event.message ?? "not loaded: " + event.target.src), true);
addEventListener("unhandledrejection", (event) => complaints.push(String(event.reason)));
</script>)js";

// Runs the script, whose `told` holds the results. `settle` waits until an event is handled.
std::string with_script(std::string page, const std::string& script) {
    page.insert(page.rfind("</body>"), R"js(<script>
(async () => {
    const told = {}, settle = () => new Promise((done) => setTimeout(done, 200));
    try {
        await settle();
)js" + script + R"js(
    } catch (error) {
        complaints.push(String(error.stack));
    }
    told.complaints = complaints;
    document.body.replaceChildren(Object.assign(document.createElement("pre"),
        {textContent: "told:" + JSON.stringify(told) + ":told"}));
})();
</script>)js");
    page.insert(page.find("<head>") + 6, kListens);
    return page;
}

class Pages : public testing::Test {
  protected:
    void SetUp() override {
        program_ = browser();
        if (program_.empty()) GTEST_SKIP() << "there is no chromium (apt-get install chromium)";
    }
    json told_by(const std::string& page, const std::string& script) {
        write_file_atomically(folder_ / "used.html", with_script(page, script));
        return json_of_page("timeout 60 " + program_, "--disable-gpu --window-size=1200,900", "used.html", folder_);
    }

    TemporaryFolder folder_;
    std::string program_;
};

// A coarse sphere with a highlight, or without.
compare::Comparison comparison_of(const std::string& specular) {
    const std::string text =
        "glMatrixMode(GL_PROJECTION); gluPerspective(45, 1, 1, 10); glMatrixMode(GL_MODELVIEW); glTranslatef(0, 0, "
        "-4);\n"
        "glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glEnable(GL_DEPTH_TEST); glMaterialf(GL_FRONT, GL_SHININESS, "
        "60);\n"
        "glMaterialfv(GL_FRONT, GL_SPECULAR, (float[]){" +
        specular + ", 1}); glutSolidSphere(1, 8, 6);";
    const auto scene = std::make_shared<const CommandList>(read_scene(text, "scene.gl", "sphere"));
    return compare_three_ways(make_scene(scene, {.width = 60, .height = 60}));
}

TEST_F(Pages, OfAComparisonOpenOnThePairThatTeachesAndShowOneStepAtATime) {
    const compare::Comparison dull = comparison_of("0, 0, 0"), shiny = comparison_of("1, 1, 1");
    const report::EncodedPictures dull_pictures = report::encode_pictures(dull),
                                  shiny_pictures = report::encode_pictures(shiny);
    const std::string page = report::comparison_page({{"Dull", dull, dull_pictures}, {"Shiny", shiny, shiny_pictures}});
    const json told = told_by(page, R"js(
        const articles = [...document.querySelectorAll("article")], tabs = [...document.querySelectorAll("nav.steps a")];
        const shown = () => articles.map((article) => article.offsetParent !== null);
        told.thumbnails = tabs.map((tab) => tab.querySelector("img").naturalWidth);
        told.first = shown();
        tabs[1].click();
        await settle();
        told.second = shown();
        told.jumped = scrollY;
        told.current = tabs.map((tab) => tab.getAttribute("aria-current"));
        const of = (name) => articles[1].querySelector("." + name);
        told.opens_on = [of("left").value, of("right").value];
        told.says = of("says").textContent;
        told.pixel = of("pixel").textContent;
        told.labels = document.querySelectorAll(".show-labels").length;
        told.values = [...articles[1].querySelectorAll("output")].map((output) => output.value);
        articles[1].querySelectorAll(".pairs button")[3].click();
        told.difference = [of("left").value, of("right").value, of("right-picture").naturalWidth];
        told.pressed = [...articles[1].querySelectorAll(".pairs button")].map((button) => button.getAttribute("aria-pressed"));
        told.address = location.hash;
        of("wipe").value = 25;
        of("wipe").dispatchEvent(new Event("input"));
        told.wiped = of("right-picture").style.clipPath;
        articles[1].querySelector("button.place")?.click();
    )js");
    EXPECT_EQ(told["complaints"], json::array());
    EXPECT_EQ(told["thumbnails"], json({60, 60}));
    EXPECT_EQ(told["first"], json({true, false}));
    EXPECT_EQ(told["second"], json({false, true}));
    EXPECT_EQ(told["jumped"], 0) << "the steps stay in view";
    EXPECT_EQ(told["current"], json({nullptr, "true"}));
    EXPECT_EQ(told["opens_on"], json({"fixed", "shaders-phong"}));
    const RegionDifference& lost = shiny.pairs.back().difference.interior;
    ASSERT_GT(lost.max, 0.1) << "lighting vertices loses the highlight";
    EXPECT_EQ(told["says"],
              "Left: the fixed function lights only the vertices. Right: shaders light every pixel. They are "
              "meant to differ: in this scene by up to " +
                  std::to_string(std::lround(lost.max * 255)) + "/255.");
    EXPECT_TRUE(told["pixel"].get<std::string>().starts_with("Pixel " + std::to_string(lost.worst_x) + ", " +
                                                             std::to_string(lost.worst_y) + " "))
        << told["pixel"];
    EXPECT_EQ(told["labels"], 0) << "a switch only where there are labels";
    EXPECT_EQ(told["values"].size(), 5U);
    EXPECT_NE(told["values"][0], told["values"][3]);
    EXPECT_EQ(told["difference"], json({"fixed", "fixed ~ reference", 60}));
    EXPECT_EQ(told["pressed"], json({"false", "false", "false", "true"}));
    EXPECT_TRUE(told["address"].get<std::string>().starts_with("#step=2&left=fixed&right=fixed"));
    EXPECT_EQ(told["wiped"], "inset(0px 0px 0px 25%)");
}

TEST_F(Pages, OfAComparisonHaveTheScenesLabelsOverTheLargePicture) {
    const auto scene = std::make_shared<const CommandList>(read_scene(
        "glRectf(-0.5, -0.5, 0.5, 0.5);\n#pragma twinlight label(0, 0, 0, \"the middle\")\n", "scene.gl", "scene"));
    const compare::Comparison comparison = compare_three_ways(make_scene(scene, {.width = 200, .height = 100}));
    const report::EncodedPictures pictures = report::encode_pictures(comparison);
    const json told = told_by(report::comparison_page({{"", comparison, pictures}}), R"js(
        const stage = document.querySelector(".stage"), text = stage.querySelector("text");
        told.text = text.textContent;
        const place = text.getBoundingClientRect(), all = stage.getBoundingClientRect();
        told.off = [place.x + place.width / 2 - all.x - all.width / 2, place.y + place.height / 2 - all.y - all.height / 2]
            .map((off) => Math.round(off / all.width * 20));
        document.querySelector(".show-labels").click();
        told.hidden = text.getBoundingClientRect().width;
    )js");
    EXPECT_EQ(told["complaints"], json::array());
    EXPECT_EQ(told["text"], "the middle");
    EXPECT_EQ(told["off"], json({0, 0})) << "in twentieths of the width";
    EXPECT_EQ(told["hidden"], 0);
}

TEST_F(Pages, OfTheHardCasesShowWhatIsChosenAndSearched) {
    ASSERT_EQ(run_program("twinlight", {"check", "light-at-vertex", "flat-triangle", "attenuation-denormal-k1",
                                        "--html", folder_ / "page"})
                  .status,
              0);
    const json told = told_by(read_file(folder_ / "page/index.html"), R"js(
        const shown = () => [...document.querySelectorAll("section")].filter((one) => one.offsetParent !== null).map((one) => one.id).sort();
        const total = (group) => document.querySelector(`.totals [data-group="${group}"]`);
        const count = () => document.querySelector(".search output").value;
        told.all = [shown().length, count()];
        total(3).click();
        told.passed = shown();
        total(3).click();
        told.again = shown().length;
        const search = document.querySelector(".search input");
        search.value = "flat";
        search.dispatchEvent(new Event("input"));
        told.searched = [shown(), count(), [...document.querySelectorAll("h2")].filter((one) => one.offsetParent !== null).length];
        location.hash = "#light-at-vertex";
        await settle();
        told.linked = [shown().length, document.querySelector("#light-at-vertex details").open];
    )js");
    EXPECT_EQ(told["complaints"], json::array());
    EXPECT_EQ(told["all"], json({3, "3 cases"}));
    EXPECT_EQ(told["passed"], json({"flat-triangle", "light-at-vertex"})) << "the other shows a known bug of Mesa";
    EXPECT_EQ(told["again"], 3);
    EXPECT_EQ(told["searched"], json({json::array({"flat-triangle"}), "1 case", 2}));
    EXPECT_EQ(told["linked"], json({3, true}));
}

}  // namespace
}  // namespace twinlight::comparison_page_test
