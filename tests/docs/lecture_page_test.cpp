// docs/lecture.md and docs/zh-CN/lecture.md: both show every picture, run the same commands, and name every scene.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>
#include <string>

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

}  // namespace
}  // namespace twinlight::lecture_page_test
