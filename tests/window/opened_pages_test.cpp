// Every page that the programs write, opened in a browser without a window: its scripts raise no error, all that it names loads, and it
// is not wider than the window.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "../unit/effort.h"
#include "../unit/run_program.h"
#include "base/image/file.h"
#include "base/text/json.h"
#include "browser.h"

namespace twinlight::opened_pages_test {
namespace {

using nlohmann::json;

// Before the page: what the console would show, and what does not load.
constexpr const char* kListens = R"js(<script>
window.complaints = [];
for (const kind of ["error", "warn"]) console[kind] = (...words) => complaints.push(kind + ": " + words.join(" "));
addEventListener("error", (event) =>
    complaints.push(event.message ?? "not loaded: " + (event.target.src || event.target.href)), true);
addEventListener("unhandledrejection", (event) => complaints.push(String(event.reason)));
</script>)js";

// After it: opens all that is folded, waits for pictures, and leaves what was found instead of the page.
constexpr const char* kReports = R"js(<script>
addEventListener("load", async () => {
    for (const details of document.querySelectorAll("details")) details.open = true;
    const pictures = [...document.images];
    for (const picture of pictures) picture.loading = "eager";
    await new Promise((resolve) => setTimeout(resolve, 1000));
    const told = {complaints, pictures: pictures.length, title: document.title, letters: document.body.innerText.length,
                  too_wide: document.documentElement.scrollWidth - document.documentElement.clientWidth};
    for (const picture of pictures)
        if (picture.src && !(picture.complete && picture.naturalWidth > 0)) complaints.push("no picture: " + picture.src.slice(0, 200));
    document.body.replaceChildren("told:" + JSON.stringify(told) + ":told");
});
</script>)js";

class OpenedPages : public testing::Test {
  protected:
    void SetUp() override {
        program_ = browser();
        if (program_.empty()) GTEST_SKIP() << "there is no chromium (apt-get install chromium)";
    }

    // The page lies in the folder `name`, beside its pictures.
    json opened(const std::string& name, int width = 1200) {
        std::string text = read_file(folder_ / (name + "/index.html"));
        const std::size_t head = text.find("<head>"), end = text.rfind("</body>");
        EXPECT_TRUE(head != text.npos && end != text.npos);
        text.insert(end, kReports);
        text.insert(head + 6, kListens);
        std::ofstream(folder_ / (name + "/opened.html"), std::ios::binary) << text;
        return json_of_page("timeout 120 " + program_,
                            "--use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader --window-size=" +
                                std::to_string(width) + ",900",
                            name + "/opened.html", folder_);
    }
    void expect_right(const std::string& name, int least_pictures) {
        for (const int width : tries_all() ? std::vector{1200, 500} : std::vector{500}) {
            SCOPED_TRACE(name + ", " + std::to_string(width) + " pixels wide");
            const json told = opened(name, width);
            EXPECT_EQ(told["complaints"], json::array());
            EXPECT_LE(told["too_wide"], 0);
            EXPECT_GE(told["pictures"], least_pictures);
            EXPECT_GE(told["letters"], 100);
            EXPECT_NE(told["title"], "");
        }
    }
    // Runs a program that writes into the folder `name`.
    void write(const std::string& name, std::vector<std::string> arguments, const std::string& option) {
        arguments.insert(arguments.end(), {option, folder_ / name});
        const ProgramResult result = run_program("twinlight", arguments);
        EXPECT_LE(result.status, 1) << result.err;
    }

    TemporaryFolder folder_;
    std::string program_;
};

TEST_F(OpenedPages, OfCompareCheckAndStudyAreWithoutErrors) {
    write("compare", {"compare", "report", "--size", "160x120"}, "-o");
    expect_right("compare", 2);
    write("check", {"check", "light-none", "rescale-1e7", "vertex-w-2"}, "--html");
    expect_right("check", 0);
    write("study", {"study", "report", "--quick", "--seconds", "0", "--size", "40x30"}, "-o");
    expect_right("study", 1);
}

TEST_F(OpenedPages, OfScenesWithStepsAndSpectraAreWithoutErrors) {
    std::ofstream(folder_ / "steps.gl") << R"(
        glMatrixMode(GL_PROJECTION); gluPerspective(45, 1, 1, 10); glMatrixMode(GL_MODELVIEW); glTranslatef(0, 0, -4);
        glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glEnable(GL_DEPTH_TEST);
#pragma twinlight step("Ambient <only>")
        glLightfv(GL_LIGHT0, GL_DIFFUSE, (GLfloat[]){0, 0, 0, 1});
#pragma twinlight step("Diffuse & ambient")
#pragma twinlight step()
        glutSolidSphere(1, 16, 8);
)";
    write("steps", {"compare", folder_ / "steps.gl", "--size", "80x60"}, "-o");
    expect_right("steps", 2);
    write("spectral", {"study", "spectral", "--quick", "--seconds", "0", "--size", "40x30"}, "-o");
    expect_right("spectral", 1);
}

TEST_F(OpenedPages, OfTheGalleryAreWithoutErrors) {
    std::filesystem::create_directory(folder_ / "web");
    write_file_atomically(folder_ / "web/twinlight.html", "the page");
    const ProgramResult drawn =
        run_shell("twinlight", "tools/gallery.sh \"$PROGRAM\" " + quoted(folder_ / "gallery") + " report");
    ASSERT_EQ(drawn.status, 0) << drawn.err;
    expect_right("gallery", 4);
    const std::string gallery = read_file(folder_ / "gallery/index.html");
    EXPECT_NE(gallery.find("<a href=\"report-1/index.html\">All three agree"), std::string::npos);
    EXPECT_NE(gallery.find("<a href=\"../web/twinlight.html#scene=report&amp;step=1\">"), std::string::npos);
    const ProgramResult unknown =
        run_shell("twinlight", "tools/gallery.sh \"$PROGRAM\" " + quoted(folder_ / "none") + " repotr");
    EXPECT_EQ(unknown.status, 2);
    EXPECT_EQ(unknown.err, "gallery.sh: there is no such scene: repotr\n");
}

TEST_F(OpenedPages, ThatAreExportedAreWithoutErrors) {
    std::filesystem::create_directory(folder_ / "export");
    write("export/index.html", {"export", "report", "--as", "html"}, "-o");
    const json told = opened("export");
    if (told["complaints"].dump().find("WebGL") != std::string::npos) GTEST_SKIP() << "this chromium has no WebGL 2";
    EXPECT_EQ(told["complaints"], json::array());
    EXPECT_GE(told["letters"], 20);
}

TEST_F(OpenedPages, WithErrorsAreFound) {
    std::filesystem::create_directory(folder_ / "wrong");
    std::ofstream(folder_ / "wrong/index.html") << "<!DOCTYPE html><html><head><title>t</title></head><body><img "
                                                   "src=\"none.png\"><div style=\"width: 3000px\">wide</div>"
                                                   "<script>console.error('said'); setTimeout(() => noFunction(), 10); "
                                                   "Promise.reject('refused')</script></body></html>";
    const json told = opened("wrong");
    const std::string complaints = told["complaints"].dump();
    for (const char* part :
         {"error: said", "noFunction is not defined", "refused", "not loaded: file", "no picture: file"})
        EXPECT_NE(complaints.find(part), std::string::npos) << part << " in " << complaints;
    EXPECT_GT(told["too_wide"], 1000);
}

}  // namespace
}  // namespace twinlight::opened_pages_test
