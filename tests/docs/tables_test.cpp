// The tables of docs/hard-cases.md and docs/driver.md that are made from the hard cases, from src/lighting/rulings.h and from
// golden/known_differences. A table stands between "<!-- table: NAME -->" and "<!-- end -->". `make tables` writes them.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "../unit/run_program.h"
#include "base/image/file.h"
#include "judge/check/case.h"
#include "lighting/rulings.h"
#include "render/reference/pixel_history.h"

namespace twinlight::tables_test {
namespace {

using check::Case;

const std::vector<Case>& cases() {
    static const std::vector<Case> list = check::load_cases();
    return list;
}

// Text for a cell: a bar would end it, and a browser takes < for a tag.
std::string cell(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c == '|')
            result += "\\|";
        else if (c == '<')
            result += "&lt;";
        else if (c == '*')
            result += "\\*";
        else
            result += c;
    }
    return result;
}

// "`a`, `b`, `c` and 5 more"
std::string names_text(const std::vector<std::string>& names) {
    constexpr std::size_t kShown = 3;
    std::vector<std::string> shown;
    for (const std::string& name : names)
        if (shown.size() < kShown || names.size() == kShown + 1) shown.push_back("`" + name + "`");
    std::string text = fmt::format("{}", fmt::join(shown, ", "));
    if (names.size() > shown.size()) text += fmt::format(" and {} more", names.size() - shown.size());
    return names.empty() ? "-" : text;
}

// ---- Our choices ----

// The rulings that affect a tested vertex of the case, or a tested pixel.
lighting::RulingSet rulings_of(const Case& hard_case) {
    const Frame frame = hard_case.carried_out(check::kSide).scene.frame;
    lighting::RulingSet rulings;
    const auto add = [&](const auto& decided) {
        for (const auto& [ruling, lights] : decided) rulings |= {ruling};
    };
    for (const check::Expectation& expected : hard_case.expectations) {
        const check::Spot& spot = expected.spot;
        if (spot.kind == check::Spot::Kind::kPixel) {
            reference::Options options;
            if (spot.shading) options.shading = *spot.shading;
            for (const auto& fragment :
                 reference::pixel_history(frame, options, spot.x, check::kSide - 1 - spot.y).fragments)
                add(fragment.rulings);
        } else if (spot.kind == check::Spot::Kind::kVertex) {
            const Draw* draw = nullptr;
            for (const auto& item : frame.items)
                if (const auto* one = std::get_if<Draw>(&item)) draw = one;
            const auto vertex = static_cast<std::uint32_t>(spot.vertex);
            if (!draw || !draw->lighting.enabled || vertex >= draw->vertices.size()) continue;
            add(reference::vertex_history(*draw, {}, vertex, reference::Face::kFront).rulings);
        }
    }
    return rulings;
}

std::string choices_table() {
    std::map<lighting::Ruling, std::vector<std::string>> names;
    for (const Case& hard_case : cases()) {
        const lighting::RulingSet rulings = rulings_of(hard_case);
        for (const lighting::RulingText& text : lighting::kRulings)
            if (rulings.contains(text.ruling)) names[text.ruling].push_back(hard_case.name);
    }
    std::string table = "| state | our choice | reason | cases |\n|---|---|---|---|\n";
    for (const lighting::RulingText& text : lighting::kRulings)
        table += fmt::format("| {} | {} | {} | {} |\n", cell(text.state), cell(text.answer), cell(text.reason),
                             names_text(names[text.ruling]));
    return table;
}

// ---- The cases ----

std::string subjects_table() {
    std::map<std::string, std::vector<const Case*>> subjects;  // by the name's first word
    for (const Case& hard_case : cases())
        subjects[hard_case.name.substr(0, hard_case.name.find('-'))].push_back(&hard_case);
    std::string table = "| names | cases | for example |\n|---|---|---|\n";
    for (const auto& [subject, list] : subjects)
        table += fmt::format("| `{}*` | {} | {} |\n", subject, list.size(), cell(list.front()->what));
    return table;
}

// ---- Known bugs ----

struct Bug {
    std::string name{}, section{}, text{}, driver{}, nvidia{}, fixed{}, since{};
};

// The entries of golden/known_differences; a line that starts with spaces continues the one before it.
std::vector<Bug> bugs() {
    std::vector<Bug> list;
    std::istringstream lines(read_file("golden/known_differences"));
    std::string* value = nullptr;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with('[') && line.ends_with(']')) {
            list.push_back({.name = line.substr(1, line.size() - 2)});
            value = nullptr;
        } else if (line.starts_with(' ') && value) {
            *value += line.substr(line.find_first_not_of(' ') - 1);
        } else if (!list.empty() && line.find(':') != line.npos) {
            const std::string key = line.substr(0, line.find(':'));
            Bug& bug = list.back();
            value = key == "section"  ? &bug.section
                    : key == "text"   ? &bug.text
                    : key == "driver" ? &bug.driver
                    : key == "nvidia" ? &bug.nvidia
                    : key == "fixed"  ? &bug.fixed
                                      : &bug.since;
            *value = line.substr(line.find_first_not_of(' ', key.size() + 1));
        }
    }
    return list;
}

// The names of the cases that list a bug of this driver, by bug.
std::map<std::string, std::vector<std::string>> cases_by_bug(const std::string& driver) {
    std::map<std::string, std::vector<std::string>> names;
    for (const Case& hard_case : cases())
        for (const check::Differs& differs : hard_case.differs) {
            if (!differs.is_of(driver)) continue;
            auto& list = names[differs.name];
            if (list.empty() || list.back() != hard_case.name) list.push_back(hard_case.name);
        }
    return names;
}

const std::string kMesa = "llvmpipe, 4.5 Mesa 22.3.6, OSMesa",
                  kNvidia = "NVIDIA H200/PCIe/SSE2, 4.6.0 NVIDIA 580.159.04, EGL";

// "all", "before 25.0"
std::string releases_of(const Bug& bug) {
    const auto number = [](const std::string& release) { return release.substr(release.find(' ') + 1); };
    std::string words;
    if (!bug.since.empty()) words = "from " + number(bug.since);
    if (!bug.fixed.empty()) words += (words.empty() ? "before " : " before ") + number(bug.fixed);
    return words.empty() ? "all" : words;
}

std::string bugs_table() {
    auto names = cases_by_bug(kMesa);
    std::string table = "| bug | section | GL requires | Mesa | releases | cases |\n|---|---|---|---|---|---|\n";
    for (const Bug& bug : bugs()) {
        if (bug.driver.empty()) continue;
        table += fmt::format("| {} | {} | {} | {} | {} | {} |\n", cell(bug.name), bug.section, cell(bug.text),
                             cell(bug.driver), releases_of(bug), names_text(names[bug.name]));
    }
    return table;
}

std::string nvidia_table() {
    auto names = cases_by_bug(kNvidia);
    std::string table = "| bug | section | GL requires | NVIDIA 580 | cases |\n|---|---|---|---|---|\n";
    for (const Bug& bug : bugs()) {
        if (bug.nvidia.empty()) continue;
        const bool is_same = bug.nvidia.starts_with("the same");
        table += fmt::format("| {} | {} | {} | {} | {} |\n", cell(bug.name), bug.section, cell(bug.text),
                             is_same ? "as Mesa" + cell(bug.nvidia.substr(8)) : cell(bug.nvidia),
                             names_text(names[bug.name]));
    }
    return table;
}

// The first channel that differs, of the first place that the case lists.
std::string numbers_table() {
    const auto number = [](const check::Seen& seen, int channel) {
        if (const auto* color = std::get_if<glm::dvec4>(&seen)) return fmt::format("{:.6g}", (*color)[channel]);
        return check::text_of(seen);
    };
    std::string table = "| case | state | right | driver | bug |\n|---|---|---|---|---|\n";
    for (const Case& hard_case : cases()) {
        const auto listed =
            std::ranges::find_if(hard_case.differs, [](const check::Differs& differs) { return differs.is_of(kMesa); });
        if (listed == hard_case.differs.end()) continue;
        const check::Differs& differs = *listed;
        for (const check::Expectation& expected : hard_case.expectations) {
            if (expected.spot != differs.spot) continue;
            int channel = 0;
            if (std::holds_alternative<glm::dvec4>(expected.value))
                while (channel < 3 && number(expected.value, channel) == number(differs.value, channel)) ++channel;
            table += fmt::format("| `{}` | {} | {} | {} | {} |\n", hard_case.name, cell(hard_case.what),
                                 number(expected.value, channel), number(differs.value, channel), cell(differs.name));
            break;
        }
    }
    return table;
}

// ---- The pages ----

std::string measures_table() { return run_program("twinlight", {"lesson", "--measures"}).out; }

struct Table {
    const char* page;
    const char* name;
    std::string (*text)();
};
constexpr Table kTables[] = {
    {"docs/hard-cases.md", "choices", choices_table}, {"docs/hard-cases.md", "subjects", subjects_table},
    {"docs/driver.md", "bugs", bugs_table},           {"docs/driver.md", "nvidia", nvidia_table},
    {"docs/driver.md", "numbers", numbers_table},     {"docs/teaching.md", "measures", measures_table},
};

TEST(DocsTables, AreCurrent) {
    for (const Table& table : kTables) {
        SCOPED_TRACE(fmt::format("{}, table {}: `make tables` writes it again", table.page, table.name));
        std::string page = read_file(table.page);
        const std::string start = fmt::format("<!-- table: {} -->\n", table.name);
        std::size_t from = page.find(start);
        ASSERT_NE(from, page.npos);
        from += start.size();
        const std::size_t end = page.find("<!-- end -->\n", from);
        ASSERT_NE(end, page.npos);
        const std::string text = "\n" + table.text() + "\n";
        if (std::getenv("TWINLIGHT_WRITE_TABLES"))
            write_file_atomically(table.page, page.replace(from, end - from, text));
        else
            EXPECT_EQ(page.substr(from, end - from), text);
    }
}

// The pages that say how many hard cases and known bugs there are.
TEST(DocsTables, AreCountedRight) {
    const auto expect = [](const char* page, const std::string& words) {
        EXPECT_NE(read_file(page).find(words), std::string::npos) << page << " should say: " << words;
    };
    const std::size_t count = cases().size();
    for (const char* page : {"README.md", "docs/driver.md", "docs/hard-cases.md", "docs/figures.md"})
        expect(page, fmt::format("{} hard cases", count));
    expect("README.zh-CN.md", fmt::format("{} 个疑难情形", count));
    const std::vector<Bug> all = bugs();
    const auto of_mesa = std::ranges::count_if(all, [](const Bug& bug) { return !bug.driver.empty(); });
    expect("docs/figures.md", fmt::format("| known bugs of Mesa's fixed function | {} |", of_mesa));
}

}  // namespace
}  // namespace twinlight::tables_test
