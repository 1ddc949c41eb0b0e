#include "app/session/scenes.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <utility>
#include <vector>

#include "app/session/recorded_program.h"
#include "base/text/translation.h"
#include "scene/scenes/load.h"
#include "scene/state/state.h"

namespace twinlight::session {

namespace fs = std::filesystem;

void show_scene(Session& session, const std::string& name) {
    if (name == key_of(session)) return;
    if (!reopen(session, name)) {
        Opened opened = load_openable(name);
        open(session, std::move(opened.scene), std::move(opened.file));
    }
    say(session, tr("scene {}", name));
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

std::shared_ptr<const Scene> small_scene(const std::string& name, WindowSize size) {
    const std::shared_ptr<const CommandList> commands = load_commands(name);
    auto small = std::make_shared<const CommandList>(scaled(*commands, natural_size(*commands), size));
    return std::make_shared<const Scene>(make_scene(std::move(small), {.width = size.width, .height = size.height}));
}

void note_recent_file(Session& session) {
    constexpr std::size_t kMost = 10;
    if (!session.file) return;
    std::error_code error;
    const std::string file = fs::absolute(*session.file, error).lexically_normal().string();
    std::vector<std::string>& files = session.recent_files;
    if (error || (!files.empty() && files.front() == file)) return;
    std::erase(files, file);
    files.insert(files.begin(), file);
    files.resize(std::min(files.size(), kMost));
}

std::vector<std::string> recent_files(const Session& session) {
    std::vector<std::string> files;
    std::error_code error;
    const fs::path here = fs::current_path(error);
    for (const std::string& file : session.recent_files) {
        if (!fs::is_regular_file(file, error)) continue;
        const fs::path from_here = fs::path(file).lexically_relative(here);
        const bool is_below = !from_here.empty() && *from_here.begin() != "..";
        files.push_back(is_below ? from_here.string() : file);
    }
    return files;
}

}  // namespace twinlight::session
