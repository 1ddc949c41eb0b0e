// Preferences: what the window remembers from one start to the next.
#pragma once

#include <string>
#include <vector>

namespace twinlight::session {

struct Preferences {
    int width = 0, height = 0;  // of the window in pixels; 0: not known
    std::string panel{};        // a key of kPanels; empty: not known
    std::vector<std::string> solved_lessons{};
    bool lecture_symbols = false;
    std::vector<std::string> recent_files{};  // Session::recent_files

    friend bool operator==(const Preferences&, const Preferences&) = default;
};

// The program's folder in the one that `variable` names, or else in `otherwise` of the user's home. Empty if there is no such place.
std::string users_folder(const char* variable, const std::string& otherwise);
// In $XDG_CONFIG_HOME/twinlight, or ~/.config/twinlight. Empty if there is no such place.
std::string preferences_file();
// Without a file, or with one that is damaged, nothing is remembered.
Preferences read_preferences(const std::string& file);
// Does nothing if the file cannot be written.
void write_preferences(const std::string& file, const Preferences& preferences);

}  // namespace twinlight::session
