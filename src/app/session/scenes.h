// Opening scenes from the window: by name, and the ones before and after. Each scene keeps its history.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/session/session.h"

namespace twinlight::session {

// Shows a built-in scene or a file. One that was shown before comes back with its edits. Throws SceneError and FileError.
void show_scene(Session& session, const std::string& name);
// The session's file is now the first of its recent files, of which there are at most ten.
void note_recent_file(Session& session);
// The recent files that still exist. Those below this folder are named from here.
std::vector<std::string> recent_files(const Session& session);
// A built-in scene for a picture of this size.
std::shared_ptr<const Scene> small_scene(const std::string& name, WindowSize size);
// The scene `away` places after this one (before it, if negative), in a circle: the built-in ones, then those of the user.
std::string neighbour_scene(const Session& session, int away);

}  // namespace twinlight::session
