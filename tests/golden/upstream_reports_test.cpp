// docs/upstream: a bug report for each known bug of the newest measured Mesa. check writes those of hard cases; bugs that only queries show
// have reports by hand, whose names begin with "query-".
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>

#include "base/image/file.h"
#include "judge/check/case.h"
#include "judge/compare/departures.h"
#include "judge/conformance/c_scene.h"
#include "scene/command/text.h"

namespace twinlight::upstream_reports_test {
namespace {

std::string line_after(const std::string& text, const std::string& start) {
    const std::size_t at = text.find(start);
    if (at == std::string::npos) return "";
    const std::size_t begin = at + start.size();
    std::string line = text.substr(begin, text.find('\n', begin) - begin);
    if (line.ends_with('\\')) line.pop_back();
    return line;
}

// The files' texts, by their names: those of cases.
std::map<std::string, std::string> reports(bool of_queries = false) {
    std::map<std::string, std::string> some;
    for (const auto& entry : std::filesystem::directory_iterator("docs/upstream")) {
        const std::string name = entry.path().stem();
        if (name != "README" && name.starts_with("query-") == of_queries) some[name] = read_file(entry.path());
    }
    return some;
}

TEST(UpstreamReports, AreOfTheNewestMeasuredMesa) {
    std::string_view newest;
    for (const std::string_view release : compare::kMeasuredReleases)
        if (release.starts_with("Mesa")) newest = release;
    auto all = reports();
    all.merge(reports(true));
    for (const auto& [name, text] : all) {
        const Driver driver = parse_driver_name(line_after(text, "\nDriver: "));
        EXPECT_TRUE(driver.has_version(newest)) << name << ": write the reports again (docs/upstream/README.md)";
    }
}

TEST(UpstreamReports, AreOneForEachBugOfTheNewestMesa) {
    const std::map<std::string, std::string> all = reports();
    ASSERT_FALSE(all.empty());
    const std::string driver = line_after(all.begin()->second, "\nDriver: ");
    std::map<std::string, int> listed, reported;
    for (const check::Case& of : check::load_cases())
        for (const check::Differs& differs : of.differs)
            if (differs.is_of(driver)) listed[differs.name] = 1;
    for (const auto& [name, text] : all) ++reported[line_after(text, "\nKnown as: ")];
    EXPECT_EQ(reported, listed);

    // The list of known bugs, without those that this Mesa never had or has no more.
    for (const auto& [name, text] : reports(true)) ++reported[line_after(text, "\nKnown as: ")];
    std::istringstream lines(read_file("golden/known_differences"));
    std::string name;
    std::map<std::string, bool> known;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with('[')) name = line.substr(1, line.find(']') - 1);
        if (line.starts_with("driver:")) known[name] = true;
        if (line.starts_with("fixed:") && line.find("Mesa") != std::string::npos) known[name] = false;
    }
    for (const auto& [bug, is_there] : known) EXPECT_EQ(reported.contains(bug), is_there) << bug;
}

// The scenes are those of the cases, so that no report grows old.
TEST(UpstreamReports, HaveTheScenesOfTheirCases) {
    for (const auto& [name, text] : reports()) {
        const check::Case of = check::load_cases({name}).front();
        const std::string scene = print_c_function(conformance::c_scene(*of.scene), "draw_scene");
        EXPECT_NE(text.find(scene), std::string::npos) << name;
        EXPECT_NE(text.find("\nSpecification: OpenGL 2.1, section " + of.text), std::string::npos) << name;
    }
}

TEST(UpstreamReports, NameFilesOfMesa) {
    int named = 0;
    for (const compare::Departure& departure : compare::departures()) {
        if (departure.where.empty()) continue;
        EXPECT_TRUE(departure.where.starts_with("src/mesa/")) << departure.name;
        ++named;
    }
    EXPECT_GE(named, 10);
}

}  // namespace
}  // namespace twinlight::upstream_reports_test
