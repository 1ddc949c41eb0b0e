// Display lists (5.4): commands kept for later.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "command/command.h"
#include "state/pixels.h"

namespace twinlight {

// Limits on what a scene may ask for, so that a hostile one ends with an error and not with the machine's memory or a
// day's work: the commands that all lists hold together, and the commands that one call from outside of the lists may
// come to (64 lists that call the next one twice would be 2^64).
inline constexpr std::size_t kMaxListedCommands = 20'000'000;
inline constexpr std::size_t kMaxCommandsPerCall = 50'000'000;
// GL_MAX_LIST_NESTING (table 6.29): 64 at least; Mesa's. What is nested deeper is not executed (5.4).
inline constexpr int kMaxListNesting = 64;

struct ListedCommand {
    Command command;
    // What the command read of the client's state when it was compiled; null for commands that read nothing of it.
    std::shared_ptr<const PixelStore> pixel_store;
};

using DisplayList = std::vector<ListedCommand>;

struct Lists {
    std::map<std::uint32_t, std::shared_ptr<const DisplayList>> named;
    std::size_t commands = 0;  // in all of them

    // The list that is being compiled: between glNewList and glEndList.
    std::uint32_t open_name = 0;  // 0: none
    Enum open_mode = 0;
    Place opened;
    std::shared_ptr<DisplayList> open;

    int nesting = 0;           // of the lists that are being executed
    std::size_t executed = 0;  // commands since the outermost call
};

}  // namespace twinlight
