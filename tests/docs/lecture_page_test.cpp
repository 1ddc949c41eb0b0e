// docs/lecture.md and docs/zh-CN/lecture.md: both show every picture, run the same commands, and name every scene.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "../unit/run_program.h"
#include "base/image/file.h"
#include "scene/scenes/load.h"

namespace twinlight::lecture_page_test {
namespace {

constexpr const char* kPages[] = {"docs/lecture.md", "docs/zh-CN/lecture.md"};

// The first group of each match.
std::multiset<std::string> found(const std::string& text, const std::string& pattern) {
    const std::regex expression(pattern);
    std::multiset<std::string> all;
    for (std::sregex_iterator match(text.begin(), text.end(), expression), end; match != end; ++match)
        all.insert(match->str(1));
    return all;
}

std::set<std::string> as_set(const std::multiset<std::string>& all) { return {all.begin(), all.end()}; }

TEST(LecturePage, ShowsEveryPictureInBothLanguages) {
    std::set<std::string> drawn;
    for (const auto& entry : std::filesystem::directory_iterator("docs/lecture")) drawn.insert(entry.path().filename());
    for (const char* page : kPages)
        EXPECT_EQ(as_set(found(read_file(page), R"(\]\((?:\.\./)?lecture/([a-z0-9-]+\.png)\))")), drawn) << page;
    EXPECT_EQ(
        as_set(found(read_file("tests/docs/lecture_pictures.sh"), R"((?:^|\n)(?:gl|pixels) ([a-z0-9-]+) )")).size(),
        drawn.size());
}

TEST(LecturePage, RunsTheSameCommandsInBothLanguages) {
    std::set<std::string> commands[2];
    for (std::size_t i = 0; i < 2; ++i)
        commands[i] = as_set(found(read_file(kPages[i]), R"((build/twinlight[a-z-]*(?: [a-z0-9,."-]+| The)*))"));
    EXPECT_EQ(commands[0], commands[1]);
    EXPECT_GT(commands[0].size(), 20u);
}

// All but those of tests, and of what the lecture leaves out.
TEST(LecturePage, HasEverySceneOfTheLecture) {
    const std::string page = read_file(kPages[0]);
    for (const EmbeddedFile& file : kSceneFiles) {
        const std::string name(file.name.substr(0, file.name.rfind(".gl")));
        const bool is_beyond = name == "bezier" || name == "buffers" || name == "environment" ||
                               name == "fog-coordinates" || name == "fragments" || name == "labels" ||
                               name == "monitor" || name == "points" || name == "shadow-map" ||
                               name == "solid-texture" || name == "tex-gen" || name == "texture-units";
        if (name == "commands" || name == "legacy" || is_beyond) continue;
        EXPECT_TRUE(std::regex_search(page, std::regex("[` ]" + name + "[` ;<]"))) << name;
    }
}

// ---- The headings of the course ----

struct Heading {
    std::string_view title;  // in docs/lecture.md
    std::string_view scene;  // one that shows it; empty: the heading's command is that of a lesson
};
// Every heading of the course material: a lecture on local shading models, a report, a lab and a tutorial.
constexpr Heading kHeadings[] = {
    {"The rendering process", "shadow-map"},
    {"The standard model", "terms"},
    {"Diffuse light", "terms"},
    {"Set normals", ""},
    {"Specular light: Phong's model", "terms"},
    {"The half vector", "half-vector"},
    {"Ambient light, and the whole model", "terms"},
    {"Several lights", "several-lights"},
    {"Colour", "spectral"},
    {"Distant light", "distant-light"},
    {"Distant viewer", "distant-viewer"},
    {"OpenGL's model", "light-model"},
    {"Attenuation", "attenuation"},
    {"Spotlights", "spotlight"},
    {"Shading interpolation", "interpolation"},
    {"Material and light commands", "material-forms"},
    {"Queries", "queries"},
    {"Colour material", "color-material"},
    {"Materials", "materials"},
    {"No specular unless needed", "no-specular"},
    {"The scene", "report"},
    {"One loop over the lights", "report"},
    {"The shapes", "report"},
    {"The wrong cylinder", "cylinders"},
    {"The wrong cone", "cylinders"},
    {"Eight lights", "lab"},
    {"The smooth spot", "lab"},
    {"Shininess", "shininess"},
    {"Triangle normals", "mesh-normals"},
    {"Vertex normals", "mesh-normals"},
    {"From a buffer to GL's own calls", "mesh-normals"},
    {"The cosine, clamped", "cosine"},
    {"The sign of a normal", "cosine"},
    {"Material colour", "material-color"},
    {"The lamp, and the square of the distance", "tutorial"},
    {"Ambient light is a trick", "tutorial"},
    {"The reflection and its lobe", "tutorial"},
    {"Normals of a scaled model", "normals"},
};

struct Section {
    std::string title, text;
};
std::vector<Section> sections_of(const std::string& page) {
    std::vector<Section> sections;
    std::istringstream lines(read_file(page));
    bool is_inside = false;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("### ")) sections.push_back({line.substr(4), ""});
        is_inside = line.starts_with("### ") || (is_inside && !line.starts_with("## "));
        if (is_inside && !sections.empty()) sections.back().text += line + "\n";
    }
    return sections;
}

bool has(const std::string& text, const std::string& pattern) { return std::regex_search(text, std::regex(pattern)); }

TEST(LecturePage, HasASceneACommandAPictureAndAQuestionForEachHeading) {
    const std::vector<Section> english = sections_of(kPages[0]), chinese = sections_of(kPages[1]);
    ASSERT_EQ(english.size(), std::size(kHeadings));
    ASSERT_EQ(chinese.size(), std::size(kHeadings));
    for (std::size_t i = 0; i < english.size(); ++i) {
        const auto& [title, scene] = kHeadings[i];
        SCOPED_TRACE(title);
        EXPECT_EQ(english[i].title, title);
        const std::string command =
            scene.empty() ? "build/twinlight lesson" : "build/twinlight[a-z -]* " + std::string(scene);
        for (const Section& section : {english[i], chinese[i]}) {
            EXPECT_TRUE(has(section.text, command + "[`\\n ]")) << section.title;
            EXPECT_NE(section.text.find("!["), std::string::npos) << section.title;
            EXPECT_NE(section.text.find("<details><summary>"), std::string::npos) << section.title;
        }
        EXPECT_NE(english[i].text.find("**Notice**"), std::string::npos);
        EXPECT_NE(chinese[i].text.find("**注意**"), std::string::npos);
    }
}

// Those in the text, which CommandsOfDocs does not run. Of a window and of compare the scene and its step must exist.
TEST(LecturePage, HasCommandsThatRun) {
    const TemporaryFolder folder;
    const std::regex loads(R"re(build/twinlight(-demo| compare) ([a-z-]+)(?: --step "?([^"-]+?)"?)?(?: -o .*)?)re");
    for (const std::string& line : as_set(found(read_file(kPages[0]), "`(build/twinlight[^`]+)`"))) {
        SCOPED_TRACE(line);
        std::smatch scene;
        if (std::regex_match(line, scene, loads)) {
            EXPECT_NO_THROW(load_commands(scene.str(2), scene.str(3)));
            continue;
        }
        if (line == "build/twinlight lint" || line == "build/twinlight scenes" || has(line, " study ")) continue;
        const std::string rest = line.substr(std::string("build/twinlight").size());
        const ProgramResult result = run_shell(
            "twinlight", "program=$(realpath \"$PROGRAM\") && cd " + folder.str() + " && \"$program\"" + rest);
        EXPECT_EQ(result.status, 0) << result.err;
    }
}

}  // namespace
}  // namespace twinlight::lecture_page_test
