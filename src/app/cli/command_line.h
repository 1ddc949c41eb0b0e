// Shared by the subcommands: their declarations, common options, loading a scene.
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include "app/program.h"
#include "render/look.h"
#include "scene/command/command.h"
#include "scene/state/scene.h"

namespace twinlight::cli {

struct Subcommand {
    CLI::App* app;
    std::function<int()> run;  // returns the exit status
};

// Each has a file of its own.
Subcommand add_render(CLI::App& app);
Subcommand add_compare(CLI::App& app);
Subcommand add_explain(CLI::App& app);
Subcommand add_export(CLI::App& app);
Subcommand add_scenes(CLI::App& app);
Subcommand add_study(CLI::App& app);
Subcommand add_fuzz(CLI::App& app);
Subcommand add_check(CLI::App& app);
Subcommand add_lint(CLI::App& app);

// Accepts the keys of a map.
template <class Map>
CLI::Validator one_of(const Map& map) {
    std::string names;
    for (const auto& [name, value] : map) names += (names.empty() ? "" : ", ") + name;
    const auto check = [&map, names](const std::string& text) {
        return map.contains(text) ? "" : "'" + text + "' is not one of " + names;
    };
    return CLI::Validator(check, "");
}

// Accepts numbers from `low` to `high`. Unlike CLI::Range, adds nothing to --help, and its message is plain.
template <class Number>
CLI::Validator number_from(Number low, Number high) {
    const auto check = [low, high](const std::string& text) {
        if (CLI::Range(low, high)(text).empty()) return std::string();
        return fmt::format("'{}' is not a {}number from {} to {}", text, std::is_integral_v<Number> ? "whole " : "",
                           low, high);
    };
    return CLI::Validator(check, "");
}

CLI::Option* add_scene_argument(CLI::App& app, std::string& scene);
void add_shading_option(CLI::App& app, std::optional<Shading>& shading);

// For PlanOptions::budget.
void add_budget_option(CLI::App& app, double& budget);

// For programmable::Options::precise.
void add_precise_flag(CLI::App& app, bool& precise);

// The frame of a recorded program.
void add_frame_option(CLI::App& app, std::optional<int>& frame);

// Loads a scene, or a frame of a recorded program. Notes about a recording (cut short, GL errors) go to standard error.
Scene load_scene(const std::string& name, std::optional<Size> size, std::optional<int> frame = std::nullopt);

// Whether standard output may be coloured: it is a terminal, and NO_COLOR (no-color.org) is not set.
bool result_in_color();

}  // namespace twinlight::cli
