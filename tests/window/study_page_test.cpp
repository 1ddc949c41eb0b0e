// The study's page in a browser without a window: it is opened, pointed at, its sliders are moved, its table is sorted.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "../unit/run_program.h"

namespace twinlight {
namespace {

using nlohmann::json;

constexpr const char* kScene = R"(
glMatrixMode(GL_PROJECTION); gluPerspective(45, 1, 1, 10);
glMatrixMode(GL_MODELVIEW); glTranslatef(0, 0, -4);
glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glEnable(GL_DEPTH_TEST);
glMaterialfv(GL_FRONT, GL_SPECULAR, (float[]){0.5, 0.5, 0.5, 1}); glMaterialf(GL_FRONT, GL_SHININESS, 20);
glutSolidSphere(1, 16, 8);
)";

// Ahead of the page: what the console would show, resources that do not load among it.
constexpr const char* kListens = R"(<script>
window.complaints = [];
console.error = console.warn = (...words) => complaints.push(words.join(" "));
addEventListener("error", (event) => complaints.push(event.message ?? "not loaded: " + event.target.src), true);
addEventListener("unhandledrejection", (event) => complaints.push(String(event.reason)));
</script>)";

// Behind it: uses it as a reader would, and leaves one object behind in its place.
constexpr const char* kUses = R"(<script>
(async () => {
    const pause = () => new Promise((done) => setTimeout(done, 150));
    const element = (id) => document.getElementById(id);
    const told = {};
    const canvas = element("chart"), chart = Chart.getChart(canvas);
    const point_at = async (number) => {
        canvas.scrollIntoView();
        const dot = chart.getDatasetMeta(0).data[number], box = canvas.getBoundingClientRect();
        const place = {clientX: box.left + dot.x, clientY: box.top + dot.y, bubbles: true};
        canvas.dispatchEvent(new MouseEvent("mousemove", place));
        await pause();
    };
    const press = async (key) => {
        canvas.dispatchEvent(new KeyboardEvent("keydown", {key, bubbles: true}));
        await pause();
    };
    const slide = async (id, value) => {
        element(id).value = value;
        element(id).dispatchEvent(new Event("input", {bubbles: true}));
        await pause();
    };
    const choose = async (id, value) => {
        element(id).value = value;
        element(id).dispatchEvent(new Event("change", {bubbles: true}));
        await pause();
    };
    const column = (n) => [...document.querySelectorAll("#points tbody tr")].map((row) => row.cells[n].textContent);
    try {
        await pause();
        told.dots = chart.data.datasets[0].data.length;
        told.hidden_at_first = element("detail").hidden;
        await point_at(3);
        told.pointed_at = element("detail-name").textContent;
        told.expected = chart.data.datasets[0].data[3].point.words;
        told.picture = [element("detail-picture").naturalWidth, element("detail-picture").offsetWidth > 0];
        told.difference = element("detail-difference").naturalWidth;
        await press("ArrowRight");
        told.by_key = element("detail-name").textContent;

        await slide("target", 900);
        told.rough = element("target-choice").textContent;
        await slide("target", 100);
        told.fine = element("target-choice").textContent;
        await slide("wipe", 25);
        told.wiped = element("truth").style.clipPath;

        told.unsorted = column(1);
        document.querySelectorAll("#points thead button")[1].click();
        told.rising = column(1);
        document.querySelectorAll("#points thead button")[1].click();
        told.falling = column(1);

        const first = document.querySelector("#filters input");
        first.click();
        await pause();
        told.dots_filtered = chart.data.datasets[0].data.length;
        told.rows_filtered = document.querySelectorAll("#points tbody tr:not([hidden])").length;
first.click();

told.measures = [];
for (const option of element("measure").options) {
    await choose("measure", option.value);
    told.measures.push(chart.options.scales.y.title.text);
}
await choose("region", "silhouette");
await choose("colour", "shading");
told.legend = element("legend").textContent;
told.orders = Chart.getChart(element("convergence")).data.datasets.map((line) = > line.label);
}
catch (error) {
    complaints.push(String(error.stack));
}
told.complaints = complaints;
document.body.replaceChildren(Object.assign(document.createElement("pre"),
                                            {textContent : "told:" + JSON.stringify(told) + ":told"}));
})();
</script>)";

std::string browser() {
    for (const char* name : {"chromium", "chromium-browser", "google-chrome"})
        if (run_shell("", std::string("command -v ") + name).status == 0) return name;
    return {};
}

// What innerHTML escapes.
std::string unescaped(std::string text) {
    for (const auto& [escaped, character] : {std::pair("&lt;", "<"), {"&gt;", ">"}, {"&nbsp;", " "}, {"&amp;", "&"}})
        for (std::size_t at = 0; (at = text.find(escaped, at)) != std::string::npos; ++at)
            text.replace(at, std::string_view(escaped).size(), character);
    return text;
}

// The page after kUses, given as JSON.
json told_by(const std::string& program, const std::string& page, const TemporaryFolder& folder) {
    std::string text = read_file(page);
    const std::size_t head = text.find("<head>") + 6, end = text.rfind("</body>");
    text.insert(end, kUses);
    text.insert(head, kListens);
    std::ofstream(folder / "used.html", std::ios::binary) << text;
    const ProgramResult result = run_shell(
        "", "timeout 60 " + program + " --headless --no-sandbox --disable-gpu --no-first-run --window-size=1200,900 " +
                "--host-resolver-rules='MAP * ~NOTFOUND' --user-data-dir=" + quoted(folder / "profile") +
                " --virtual-time-budget=20000 --dump-dom " + quoted("file://" + folder / "used.html"));
    const std::size_t begin = result.out.find("told:{"), close = result.out.rfind("}:told");
    if (begin == std::string::npos || close == std::string::npos)
        throw std::runtime_error("the browser's page tells nothing: " + result.out.substr(0, 500) + result.err);
    return json::parse(unescaped(result.out.substr(begin + 5, close - begin - 4)));
}

class StudyPage : public testing::Test {
  protected:
    void SetUp() override {
        program_ = browser();
        if (program_.empty()) GTEST_SKIP() << "there is no chromium (apt-get install chromium)";
        std::ofstream(folder_ / "scene.gl") << kScene;
        study("study");
    }
    void study(const std::string& name) {
        const ProgramResult result = run_program("twinlight", {"study", folder_ / "scene.gl", "-o", folder_ / name,
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
    EXPECT_TRUE(told["pointed_at"].get<std::string>().starts_with(told["expected"].get<std::string>())) << told.dump(1);
    EXPECT_EQ(told["picture"], json({40, true}));
    EXPECT_EQ(told["difference"], 40);
    EXPECT_NE(told["by_key"], told["pointed_at"]);

    EXPECT_TRUE(told["rough"].get<std::string>().starts_with("The fastest: "));
    EXPECT_TRUE(told["fine"].get<std::string>().starts_with("The fastest: "));
    EXPECT_NE(told["rough"], told["fine"]);
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
}  // namespace twinlight
