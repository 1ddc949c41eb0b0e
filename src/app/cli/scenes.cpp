// twinlight scenes: lists the built-in scenes, or prints one.
#include <fmt/format.h>

#include <algorithm>

#include "app/cli/command_line.h"
#include "base/text/input_text.h"
#include "base/text/json.h"
#include "scene/scenes/caption.h"
#include "scene/scenes/load.h"
#include "scene/scenes/scene_groups.h"

namespace twinlight::cli {

namespace {

struct ScenesArguments {
    std::string name;
    bool json = false;
};

// Wraps at 80 columns; all lines but the first are indented.
std::string wrapped(const std::string& words, std::size_t indent) {
    constexpr std::size_t kColumns = 80;
    std::string text;
    std::size_t column = indent;
    InputText in(words);
    for (std::string word; in >> word; column += word.size()) {
        if (column > indent && column + 1 + word.size() > kColumns) {
            text += "\n" + std::string(indent, ' ');
            column = indent;
        } else if (column > indent) {
            text += " ";
            ++column;
        }
        text += word;
    }
    return text;
}

std::string title_of(std::string_view scene) { return caption_of(find_built_in(scene)->text).title; }

int list(const ScenesArguments& arguments) {
    if (arguments.json) {
        Json json = {{"scenes", Json::array()}};
        for (const SceneGroup& group : scene_groups())
            for (const std::string_view name : group.scenes)
                json["scenes"].push_back({{"name", name},
                                          {"heading", group.heading},
                                          {"description", title_of(name)},
                                          {"steps", load_commands(std::string(name))->steps}});
        write_result(dumped_lines(json));
        return kFine;
    }
    std::size_t width = 0;
    for (const EmbeddedFile& file : kSceneFiles) width = std::max(width, built_in_name(file).size());
    std::string text;
    for (const SceneGroup& group : scene_groups()) {
        text += fmt::format("{}{}\n", text.empty() ? "" : "\n", group.heading);
        for (const std::string_view name : group.scenes)
            text += fmt::format("  {:{}}  {}\n", name, width, wrapped(title_of(name), width + 4));
    }
    write_result(text);
    return kFine;
}

int run_scenes(const ScenesArguments& arguments) {
    if (arguments.name.empty()) return list(arguments);
    if (const EmbeddedFile* file = find_built_in(arguments.name)) {
        const Json json = {{"name", arguments.name}, {"description", title_of(arguments.name)}, {"text", file->text}};
        write_result(arguments.json ? dumped_lines(json) : std::string(file->text));
        return kFine;
    }
    std::vector<std::string> names;
    for (const EmbeddedFile& file : kSceneFiles) names.push_back(built_in_name(file));
    const auto near = nearest(arguments.name, {names.begin(), names.end()});
    throw UsageError(
        fmt::format("there is no built-in scene '{}'; {}", arguments.name,
                    near ? fmt::format("did you mean '{}'?", *near) : "'twinlight scenes' lists the scenes"));
}

}  // namespace

Subcommand add_scenes(CLI::App& app) {
    const auto arguments = std::make_shared<ScenesArguments>();
    CLI::App* scenes = app.add_subcommand("scenes", "List the built-in scenes, or print one");
    scenes->add_option("NAME", arguments->name, "print the text of this scene")->type_name("");
    scenes->add_flag("--json", arguments->json, "print one JSON object instead of text");
    return {scenes, [arguments] { return run_scenes(*arguments); }};
}

}  // namespace twinlight::cli
