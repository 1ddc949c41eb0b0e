// Steps: a scene's steps (#pragma twinlight step) in the window, where the keys , and . show the one before or after.
#pragma once

#include <memory>
#include <string>

#include "app/session/session.h"

namespace twinlight::session {

// "step 2 of 4: Diffuse only"; empty for a scene without steps.
std::string step_caption(const CommandList& commands);

// The number of the step that many steps away, as a string for ReadOptions::step; the first follows the last. The scene
// must have steps.
std::string neighbour_step(const CommandList& commands, int away);

// Shows another step of the scene, as the file has it. The camera stays where the user has moved it. This can be undone.
void show_step(Session& session, std::shared_ptr<const CommandList> step);

}  // namespace twinlight::session
