// The line at the window's bottom, and the list of keys over the pictures.
#pragma once

#include <chrono>

#include "app/session/layout.h"
#include "app/session/session.h"

namespace twinlight::demo {

class StatusLine {
  public:
    // The scene's name, then its error, or the newest message, or which lights are on. A message that is old is cleared,
    // unless `keeps_messages`.
    void show(session::Session& session, const Rectangle& bar, bool keeps_messages);

  private:
    int messages_seen_ = 0;
    std::chrono::steady_clock::time_point message_since_{};
};

// In the middle of a window of this size.
// What the scene shows, and what to notice: two lines, and the whole comment under the mouse.
void show_caption(const session::Session& session, const Rectangle& box);
void show_keys(int width, int height);

}  // namespace twinlight::demo
