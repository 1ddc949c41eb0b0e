// The page in Chromium: what it does, and whether the pictures by its shaders agree with the reference.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "../unit/run_program.h"
#include "../window/browser.h"
#include "app/session/keys.h"
#include "app/web/page_scene.h"
#include "base/image/file.h"
#include "judge/check/case.h"
#include "scene/scenes/load.h"

namespace twinlight::web {

namespace {

using Json = nlohmann::json;

constexpr const char* kPage = "build/web/page";

// Pictures that differ with SwiftShader though the page names nothing that they lack.
const std::map<std::string, const char*>& known_differences() {
    static const std::map<std::string, const char*> known = {
        {"shadow-beyond-far", "r is not clamped to [0, 1], probably because ANGLE keeps 24-bit depths as floats"},
        {"nan-vertex", "SwiftShader draws a triangle though a vertex has w = 0; ours becomes (0, 0, 0, 0)"},
        {"nan-vertex-infinite", "the same"},
        {"clipping-near-light-inside",
         "SwiftShader loses the colour of vertices with w = 0 (with w = 1e-6 it does not)"},
        {"flat-points-clipped", "SwiftShader draws a part of a point whose vertex is clipped away"},
        {"lab 5", "a pixel on the border of the spot's cone, where light begins within the rasteriser's rounding"},
    };
    return known;
}

Json jobs() {
    Json list = Json::array();
    const auto add = [&](std::string_view name, std::string_view text, const std::string& step, int width, int height) {
        list.push_back({{"name", name}, {"text", text}, {"step", step}, {"width", width}, {"height", height}});
        list.back()["shadings"] = step == "case" ? Json{"scene"} : Json{"scene", "phong"};
        if (step == "case") list.back()["step"] = "";
    };
    for (const EmbeddedFile& file : kSceneFiles) {
        const CommandList scene = read_built_in(file);
        if (scene.steps.empty()) add(scene.name, file.text, "", 160, 120);
        for (std::size_t i = 1; i <= scene.steps.size(); ++i) add(scene.name, file.text, std::to_string(i), 160, 120);
    }
    for (const EmbeddedFile& file : kCaseFiles)
        add(file.name.substr(0, file.name.rfind('.')), file.text, "case", check::kSide, check::kSide);
    return list;
}

TEST(WebPage, DrawsEveryScene) {
    if (!std::filesystem::exists(std::string(kPage) + "/module.wasm"))
        GTEST_SKIP()
            << "the page is not built: make web (Debian's packages emscripten, node-acorn and libjs-codemirror)";
    const std::string program = browser();
    if (program.empty()) GTEST_SKIP() << "there is no chromium (apt-get install chromium)";
    const TemporaryFolder folder;
    write_file_atomically(folder / "jobs.json", jobs().dump());
    const ProgramResult run = run_shell(
        "", "timeout 300 node tests/web/page.mjs " + program + " " + kPage + " " + quoted(folder / "jobs.json"));
    ASSERT_EQ(run.status, 0) << run.err;
    const Json told = Json::parse(run.out), page = told["page"];

    EXPECT_EQ(page["verdict"], "Shaders and reference are equal away from edges.");
    EXPECT_LE(page["tooWide"], 0) << "at 360 pixels";
    EXPECT_NE(page["explanation"].get<std::string>().find("GL_LIGHT"), std::string::npos) << page["explanation"];
    EXPECT_TRUE(page["error"].get<std::string>().starts_with("3:1: error: ")) << page["error"];
    EXPECT_EQ(page["markup"], 0);
    EXPECT_EQ(page["marks"], (Json{Json::array({"mark error"}), "glFoo(<img src=x>);"}));
    EXPECT_EQ(page["mended"], (Json{255, 0, 0, 255}));
    EXPECT_LT(page["first"], 1000) << "milliseconds until the reference's first picture";

    // Each key and move changes the text where it changes the scene.
    EXPECT_EQ(page["light"], (Json{Json::array(), {"glEnable(GL_LIGHT7);"}}));
    EXPECT_TRUE(page["said"].get<std::string>().starts_with("GL_LIGHT7 ")) << page["said"];
    EXPECT_EQ(page["undone"], true);
    EXPECT_EQ(page["flat"], (Json{Json::array(), {"glShadeModel(GL_FLAT);"}}));
    for (const char* move : {"arrow", "drag", "wheel"}) {
        const std::string line = page[move][1].empty() ? "" : page[move][1].back();
        EXPECT_TRUE(line.starts_with("gluLookAt(")) << move << ": " << page[move];
    }
    EXPECT_EQ(page["keys"][0], true);
    for (const session::Key& key : session::keys())
        EXPECT_EQ(page["keys"][1].get<std::string>().find(key.what) != std::string::npos, key.in_page) << key.what;
    EXPECT_EQ(page["letter"], true) << "a key in the editor is a letter";
    EXPECT_EQ(page["undoneInEditor"], true) << "a drag is one step of undo";
    EXPECT_EQ(page["leaves"], true) << "Tab leaves the editor";
    EXPECT_NEAR(page["clicked"].get<double>(), 320, 2);

    EXPECT_NE(page["dumpErrors"][0].get<std::string>().find("dump.txt: call 39: the blob 'blob_call39.bin' is missing"),
              std::string::npos)
        << page["dumpErrors"];
    EXPECT_NE(page["dumpErrors"][1].get<std::string>().find("apitrace's binary form"), std::string::npos)
        << page["dumpErrors"];
    const std::string dump = page["dump"][0], verdict_on_dump = page["dump"][1];
    EXPECT_TRUE(dump.starts_with("// dump.txt, frame 0: 300 x 300 pixels.")) << dump.substr(0, 200);
    EXPECT_TRUE(verdict_on_dump.starts_with("Shaders and reference ")) << verdict_on_dump;
    EXPECT_EQ(verdict_on_dump.find("differ:"), std::string::npos) << verdict_on_dump;
    EXPECT_EQ(page["dump"][2], 300);
    EXPECT_EQ(page["dumpLink"], "300x300");

    const char* const memory[] = {"error: this scene needs more memory than a page gets",
                                  "2:1: error: this picture needs more than 0.97 GB",  // 1e9 - 112 * 640 * 480
                                  "error: pictures of 8000 x 8000 need 7.2 GB"};
    for (std::size_t i = 0; i < std::size(memory); ++i)
        EXPECT_TRUE(page["memory"][i].get<std::string>().starts_with(memory[i])) << page["memory"];
    EXPECT_EQ(page["afterMemory"], "Shaders and reference are equal away from edges.") << "the page goes on";

    EXPECT_EQ(page["forms"], (Json{"gl", "c", "glsl", "html", "#shaders", "#reference", "#difference", "#floats"}));
    PageScene scene;
    scene.open(page["files"]["gl"].get<std::string>(), "spotlight", "", {});
    for (const char* form : {"c", "glsl", "html"}) EXPECT_EQ(page["files"][form], scene.exported(form, {})) << form;
    EXPECT_EQ(page["files"]["#reference"], "image/png");

    EXPECT_EQ(page["mesa"][0], true) << "hidden for a text of your own";
    EXPECT_EQ(page["mesa"][1], false);
    EXPECT_EQ(page["mesa"][2], page["mesa"][3]);
    EXPECT_EQ(page["slider"], Json::parse("[[\"reference\", \"inset(0px 0px 0px 30%)\"], [\"mesa\", \"none\"]]"));

    EXPECT_TRUE(page["wrong"].get<std::string>().starts_with("Not yet. The highlight covers 1 times")) << page["wrong"];
    EXPECT_EQ(page["outdated"], "The scene has changed since this check.");
    EXPECT_EQ(page["solved"], "Right.");
    EXPECT_TRUE(page["prediction"].get<std::string>().starts_with("A is wrong; B is right.")) << page["prediction"];
    EXPECT_EQ(page["afterFailedUpload"], (Json{"no texture", true}));
    EXPECT_EQ(page["leaks"][0], page["leaks"][1]) << "after 20 and 100 edits";

    EXPECT_TRUE(page["link"].get<std::string>().starts_with("#text=")) << page["link"];
    EXPECT_EQ(page["complaints"], Json::array());
    for (const Json& url : page["requests"])
        EXPECT_TRUE(url.get<std::string>().starts_with("http://127.0.0.1:") ||
                    url.get<std::string>().starts_with("data:"))
            << url;

    std::size_t agree = 0;
    for (const Json& picture : told["pictures"]) {
        const std::string step = picture["step"],
                          name = picture["name"].get<std::string>() + (step.empty() ? "" : " " + step);
        SCOPED_TRACE(name + ", " + picture["shading"].get<std::string>());
        EXPECT_EQ(picture.value("error", ""), "");
        if (picture.contains("error")) continue;
        // What WebGL lacks is named on the page.
        const bool is_known = known_differences().contains(name) || !picture["missing"].empty();
        EXPECT_TRUE(picture["judged"]["within"] || is_known) << picture["judged"];
        agree += picture["judged"]["within"] ? 1 : 0;
    }
    EXPECT_GT(agree, 350u);
}

}  // namespace

}  // namespace twinlight::web
