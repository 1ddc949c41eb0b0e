// Opening scenes from the window: by name, and the ones before and after. Each scene keeps its history.
#pragma once

#include <string>

#include "app/session/session.h"

namespace twinlight::session {

// Shows a built-in scene or a file. One that was shown before comes back with its edits. Throws SceneError and FileError.
void show_scene(Session& session, const std::string& name);
// The scene `away` places after this one (before it, if negative), in a circle: the built-in ones, then those of the user.
std::string neighbour_scene(const Session& session, int away);

}  // namespace twinlight::session
