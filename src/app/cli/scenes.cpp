// twinlight scenes: the built-in scenes.
#include "scene/scenes/scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/cli/command_line.h"

namespace twinlight::cli {

namespace {

struct Arguments {
    std::string name;
    bool json = false;
};

using Json = nlohmann::ordered_json;

std::string name_of(const EmbeddedFile& file) { return std::string(file.name.substr(0, file.name.rfind(".gl"))); }

// A scene's first comment line says what it is.
std::string description_of(const EmbeddedFile& file) {
    std::string_view line = file.text.substr(0, file.text.find('\n'));
    if (!line.starts_with("//")) return "";
    line.remove_prefix(std::min(line.find_first_not_of("/ "), line.size()));
    return std::string(line);
}

int list(const Arguments& arguments) {
    if (arguments.json) {
        Json json = {{"scenes", Json::array()}};
        for (const EmbeddedFile& file : kSceneFiles) {
            json["scenes"].push_back({{"name", name_of(file)}, {"description", description_of(file)}});
        }
        write_result(json.dump(2) + "\n");
        return kFine;
    }
    std::size_t width = 0;
    for (const EmbeddedFile& file : kSceneFiles) width = std::max(width, name_of(file).size());
    std::string text;
    for (const EmbeddedFile& file : kSceneFiles) {
        text += fmt::format("{:{}}  {}\n", name_of(file), width, description_of(file));
    }
    write_result(text);
    return kFine;
}

int run(const Arguments& arguments) {
    if (arguments.name.empty()) return list(arguments);
    std::vector<std::string> names;
    for (const EmbeddedFile& file : kSceneFiles) {
        names.push_back(name_of(file));
        if (names.back() != arguments.name) continue;
        const Json json = {{"name", arguments.name}, {"description", description_of(file)}, {"text", file.text}};
        write_result(arguments.json ? json.dump(2) + "\n" : std::string(file.text));
        return kFine;
    }
    const auto near = nearest(arguments.name, {names.begin(), names.end()});
    throw UsageError(
        fmt::format("there is no built-in scene '{}'; {}", arguments.name,
                    near ? fmt::format("did you mean '{}'?", *near) : "'twinlight scenes' lists the scenes"));
}

}  // namespace

Subcommand add_scenes(CLI::App& app) {
    const auto arguments = std::make_shared<Arguments>();
    CLI::App* scenes = app.add_subcommand("scenes", "List the built-in scenes, or print one");
    scenes->add_option("NAME", arguments->name, "print this scene's text")->type_name("");
    scenes->add_flag("--json", arguments->json, "print one JSON object");
    return {scenes, [arguments] { return run(*arguments); }};
}

}  // namespace twinlight::cli
