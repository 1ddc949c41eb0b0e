#include "app/session/scenes.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <vector>

#include "scene/scenes/load.h"

namespace twinlight::session {

void show_scene(Session& session, const std::string& name) {
    if (name == key_of(session)) return;
    if (!reopen(session, name)) {
        auto scene = load_commands(name);
        std::error_code ignored;
        const bool is_file = std::filesystem::is_regular_file(name, ignored);
        open(session, std::move(scene), is_file ? std::optional(name) : std::nullopt);
    }
    say(session, "scene " + name);
}

std::string neighbour_scene(const Session& session, int away) {
    std::vector<std::string> names;
    for (const EmbeddedFile& file : kSceneFiles) names.push_back(built_in_name(file));
    const auto add = [&names](const std::string& name) {
        if (std::ranges::find(names, name) == names.end()) names.push_back(name);
    };
    add(key_of(session));
    for (const auto& [key, scene] : session.others) add(key);
    const auto here = std::ranges::find(names, key_of(session)) - names.begin();
    const auto count = std::ssize(names);
    return names[static_cast<std::size_t>(((here + away) % count + count) % count)];
}

}  // namespace twinlight::session
