// docs/lecture.md and docs/zh-CN/lecture.md: their pictures, links and scenes exist, and both pages have the same ones.
#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include "base/image/file.h"
#include "scene/scenes/load.h"

namespace twinlight {
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

// All but those of tests, and those of the tutorial, which the page only names.
TEST(LecturePage, HasEverySceneOfTheLecture) {
    const std::string page = read_file(kPages[0]);
    for (const EmbeddedFile& file : kSceneFiles) {
        const std::string name(file.name.substr(0, file.name.rfind(".gl")));
        if (name == "commands" || name == "legacy") continue;
        EXPECT_TRUE(std::regex_search(page, std::regex("[` ]" + name + "[` ;<]"))) << name;
    }
}

// GitHub makes the anchor of "### No specular, please" from its words: no-specular-please.
std::string anchor_of(const std::string& heading) {
    std::string anchor;
    for (const char c : heading) {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isalnum(byte) || c == '-' || c == '_')
            anchor += static_cast<char>(std::tolower(byte));
        else if (byte >= 0x80)
            anchor += c;
        else if (c == ' ')
            anchor += '-';
    }
    for (const std::string mark : {"\xEF\xBC\x9A", "\xEF\xBC\x8C"})  // the full-width colon and comma
        for (std::size_t at = anchor.find(mark); at != anchor.npos; at = anchor.find(mark))
            anchor.erase(at, mark.size());
    return anchor;
}

TEST(LecturePage, LinksToHeadingsThatExist) {
    for (const char* page : kPages) {
        const std::string text = read_file(page);
        std::set<std::string> anchors;
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line);)
            if (const std::size_t start = line.find("# "); start != line.npos && start < 4 && line[0] == '#')
                anchors.insert(anchor_of(line.substr(start + 2)));
        for (const std::string& link : found(text, R"re((?:\]\(|href=")#([^)"]+))re"))
            EXPECT_TRUE(anchors.contains(link)) << page << " links to #" << link;
        for (const std::string& link : found(text, R"(\]\(([^)#:]+)(?:#[^)]*)?\))"))
            EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(page).parent_path() / link))
                << page << " links to " << link;
    }
}

}  // namespace
}  // namespace twinlight
