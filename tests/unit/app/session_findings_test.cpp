// The linter in the window: each finding has its command, and fixing it fixes the scene as `twinlight lint --fix` does.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include "../in_chinese.h"
#include "app/session/edits.h"
#include "app/session/findings.h"
#include "scene/command/text.h"
#include "scene/scenes/load.h"
#include "scene/state/state.h"

namespace twinlight::session::session_findings_test {
namespace {

constexpr WindowSize kSize{160, 120};

CommandList read(const std::string& text) { return read_scene(text, "test.gl", "test"); }

// The window leaves out what only the text or a program's next picture shows, because edits change neither.
std::vector<lint::Warning> warnings_of(CommandList commands) {
    commands.later = nullptr;
    std::vector<lint::Warning> warnings = lint::lint(
        make_scene(std::make_shared<CommandList>(std::move(commands)), {.width = kSize.width, .height = kSize.height}));
    std::erase_if(warnings, [](const lint::Warning& warning) { return warning.rule->name == "shininess-scaled"; });
    return warnings;
}

TEST(SessionFindings, AreThoseOfTheLinter) {
    for (const lint::Rule& rule : lint::rules()) {
        const CommandList commands = read(lint::wrong_scene(rule));
        const auto expected = warnings_of(commands);
        const auto findings = findings_of(commands, kSize);
        ASSERT_EQ(findings.size(), expected.size()) << rule.name;
        for (std::size_t i = 0; i < findings.size(); ++i) {
            EXPECT_EQ(findings[i].warning.rule, expected[i].rule);
            EXPECT_EQ(findings[i].warning.message, expected[i].message);
            EXPECT_EQ(commands.commands[findings[i].command].place, expected[i].place) << rule.name;
        }
        EXPECT_TRUE(findings_of(read(lint::corrected_scene(rule)), kSize).empty()) << rule.name;
    }
}

TEST(SessionFindings, FixingEqualsTheEditOfTheText) {
    int corrected_rules = 0;
    for (const lint::Rule& rule : lint::rules()) {
        const std::string text = lint::wrong_scene(rule);
        const CommandList commands = read(text);
        const auto findings = findings_of(commands, kSize);
        const auto expected = warnings_of(commands);
        ASSERT_EQ(findings.empty(), expected.empty()) << rule.name;
        if (findings.empty() || !findings[0].can_fix) continue;
        ++corrected_rules;
        const CommandList by_text = read(lint::corrected(text, expected[0]));
        EXPECT_EQ(corrected(commands, findings[0]).commands, by_text.commands) << rule.name;
    }
    EXPECT_GT(corrected_rules, 15);
}

TEST(SessionFindings, FollowTheCommandsWhenTheyAreEdited) {
    const CommandList commands = read(
        "glEnable(GL_LIGHTING); glEnable(GL_LIGHT0);\n"
        "glEnable(GL_LIGHT1);\n"
        "glutSolidSphere(1, 16, 8);\n");
    const auto black = [](const CommandList& list) {
        const auto findings = findings_of(list, kSize);
        const auto found = std::ranges::find_if(
            findings, [](const Finding& finding) { return finding.warning.rule->name == "light-black"; });
        return found == findings.end() ? std::optional<Finding>{} : *found;
    };
    ASSERT_TRUE(black(commands));
    EXPECT_EQ(black(commands)->command, 2u);
    EXPECT_EQ(black(commands)->where, "line 2");
    // An inserted command moves it on, and its line stays that of the file.
    const CommandList moved = with_inserted(commands, 0, new_command(CommandId::glEnable, {kGL_NORMALIZE}));
    ASSERT_TRUE(black(moved));
    EXPECT_EQ(black(moved)->command, 3u);
    EXPECT_EQ(black(moved)->where, "line 2");
    const CommandList toggled = toggle_light(without_command(commands, 2), 1);
    ASSERT_TRUE(black(toggled));
    EXPECT_EQ(black(toggled)->where, "inserted here");
    EXPECT_FALSE(black(corrected(toggled, *black(toggled))));
}

TEST(SessionFindings, NameLinesOfTheFile) {
    const CommandList commands = read(
        "glMatrixMode(GL_MODELVIEW); glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){2, 3, 4, 1});\n\n\n"
        "gluLookAt(0, 0, 5, 0, 0, 0, 0, 1, 0); glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glEnable(GL_DEPTH_TEST);\n"
        "glutSolidSphere(1, 16, 8);\n");
    const auto findings = findings_of(commands, kSize);
    ASSERT_FALSE(findings.empty());
    EXPECT_NE(findings[0].warning.message.find("before gluLookAt (line 4)"), std::string::npos)
        << findings[0].warning.message;
    const InChinese chinese;
    EXPECT_EQ(findings_of(commands, kSize)[0].warning.message,
              "GL_LIGHT0 的位置在 gluLookAt（第 4 行）之前设置，所以光源跟着相机移动");
}

TEST(SessionFindings, AreInChinese) {
    for (const lint::Rule& rule : lint::rules()) {
        SCOPED_TRACE(rule.name);
        const std::string text = lint::wrong_scene(rule);
        const auto in_english = findings_of(read(text), kSize);
        const InChinese chinese;
        const auto findings = findings_of(read(text), kSize);
        ASSERT_EQ(findings.size(), in_english.size());
        std::vector<lint::Warning> warnings;
        for (std::size_t i = 0; i < findings.size(); ++i) {
            EXPECT_EQ(findings[i].can_fix, in_english[i].can_fix);
            warnings.push_back(findings[i].warning);
        }
        // Those of later pictures, too.
        const auto all =
            lint::lint(make_scene(std::make_shared<CommandList>(read(text)), {.width = 160, .height = 120}));
        warnings.insert(warnings.end(), all.begin(), all.end());
        EXPECT_FALSE(warnings.empty());
        for (const lint::Warning& warning : warnings) {
            EXPECT_EQ(english_left(warning.message, text), "") << warning.message;
            EXPECT_EQ(english_left(warning.fix, text), "") << warning.fix;
        }
    }
}

TEST(SessionFindings, ObeyTheCommentsThatSilenceRules) {
    const std::string scene =
        "glEnable(GL_LIGHTING); glEnable(GL_LIGHT0);\n"
        "glEnable(GL_LIGHT1);{}\n"
        "glutSolidSphere(1, 16, 8);\n";
    const auto count = [&](const std::string& comment) {
        std::string text = scene;
        text.replace(text.find("{}"), 2, comment);
        const auto findings = findings_of(read(text), kSize);
        return std::ranges::count_if(
            findings, [](const Finding& finding) { return finding.warning.rule->name == "light-black"; });
    };
    EXPECT_EQ(count(""), 1);
    EXPECT_EQ(count("  // twinlight: allow(light-black)"), 0);
}

TEST(SessionFindings, OfTheBuiltInScenesAreThoseOfTheLinter) {
    for (const EmbeddedFile& file : kSceneFiles) {
        const CommandList commands = *load_commands(std::string(file.name.substr(0, file.name.rfind(".gl"))));
        EXPECT_EQ(findings_of(commands, kSize).size(), warnings_of(commands).size()) << file.name;
    }
}

}  // namespace
}  // namespace twinlight::session::session_findings_test
