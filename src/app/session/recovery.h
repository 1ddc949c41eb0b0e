// Recovery: a file beside the scenes' own that has the changes that are not saved, so that they survive the end of the program by
// a crash, Ctrl+C or a signal. The next window offers them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/session/session.h"

namespace twinlight::session {

// $XDG_STATE_HOME/twinlight, or ~/.local/state/twinlight. Empty if there is no such place.
std::string recovery_folder();

// The file of this process. A class, because it must know whether there is one.
class RecoveryFile {
  public:
    explicit RecoveryFile(std::string folder);

    // Writes the edited scenes, or removes the file if no scene is edited. Does nothing if the file cannot be written.
    void keep(const Session& session);
    void remove();

  private:
    std::string path_;  // empty: no recovery
    bool exists_ = false;
};

// What a window left that ended without saving.
struct LostScenes {
    std::string path;     // of its recovery file
    std::string summary;  // "scene.gl and report, on 3 May at 14:32"
};
// The newest such file of a window that is no longer open; nullopt if there is no such file.
// An empty folder has none.
std::optional<LostScenes> find_lost_scenes(const std::string& folder);
// Opens the scenes, with their changes not yet saved, and removes the file. Throws FileError and SceneError.
void restore(Session& session, const LostScenes& lost);
void forget(const LostScenes& lost);

}  // namespace twinlight::session
