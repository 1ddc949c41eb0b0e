// What the tests of the linter share: scenes as texts, and the rules that warn about them.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "judge/lint/lint.h"
#include "scene/command/text.h"
#include "scene/state/state.h"

namespace twinlight::lint_test {

inline constexpr int kWidth = 160, kHeight = 120;  // of the pictures in docs/lint

inline Scene scene_of(const std::string& text) {
    const auto list = std::make_shared<CommandList>(read_scene(text, "scene.gl", "scene.gl"));
    return make_scene(list, {.width = kWidth, .height = kHeight});
}

// The names of the rules that warn, each once.
inline std::set<std::string> names(const std::vector<lint::Warning>& warnings) {
    std::set<std::string> names;
    for (const lint::Warning& warning : warnings) names.emplace(warning.rule->name);
    return names;
}

inline std::vector<lint::Warning> warnings_of(const std::string& text) { return lint::lint(scene_of(text)); }

// `text` with one part of it replaced.
inline std::string changed(std::string text, const std::string& part, const std::string& by) {
    const std::size_t at = text.find(part);
    EXPECT_NE(at, std::string::npos) << part;
    return text.replace(at, part.size(), by);
}

}  // namespace twinlight::lint_test
