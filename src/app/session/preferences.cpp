#include "app/session/preferences.h"

#include <cstdlib>
#include <exception>
#include <filesystem>

#include "base/image/file.h"
#include "base/text/json.h"

namespace twinlight::session {

std::string users_folder(const char* variable, const std::string& otherwise) {
    const char* folder = std::getenv(variable);
    if (folder && *folder == '/') return std::string(folder) + "/twinlight";
    const char* home = std::getenv("HOME");
    return home && *home == '/' ? std::string(home) + "/" + otherwise + "/twinlight" : "";
}

std::string preferences_file() {
    const std::string folder = users_folder("XDG_CONFIG_HOME", ".config");
    return folder.empty() ? "" : folder + "/window.json";
}

Preferences read_preferences(const std::string& file) {
    try {
        const Json json = parsed_json(read_file(file));
        return {json.at("width"),
                json.at("height"),
                json.at("panel"),
                json.at("solved_lessons"),
                json.value("lecture_symbols", false),
                json.value("recent_files", std::vector<std::string>{})};
    } catch (const std::exception&) {
        return {};
    }
}

void write_preferences(const std::string& file, const Preferences& preferences) {
    if (file.empty()) return;
    const Json json = {{"width", preferences.width},
                       {"height", preferences.height},
                       {"panel", preferences.panel},
                       {"solved_lessons", preferences.solved_lessons},
                       {"lecture_symbols", preferences.lecture_symbols},
                       {"recent_files", preferences.recent_files}};
    std::error_code ignored;
    std::filesystem::create_directories(std::filesystem::path(file).parent_path(), ignored);
    try {
        write_file_atomically(file, dumped_lines(json));
    } catch (const FileError&) {
        // The window then starts as it did before.
    }
}

}  // namespace twinlight::session
