// Display lists (5.4): commands kept for later.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <span>
#include <vector>

#include "scene/command/command.h"
#include "scene/shape/quadric.h"
#include "scene/state/arrays.h"
#include "scene/state/pixel_unpacking.h"

namespace twinlight {

// Limits on what a scene may ask for: how many lists there are, and what all of them hold together, but for the memory
// that their commands name.
inline constexpr std::size_t kMaxLists = 1 << 20;
inline constexpr std::size_t kMaxListedBytes = std::size_t{1} << 30;
// GL_MAX_LIST_NESTING (table 6.29): 64 at least; Mesa's. What is nested deeper is not executed (5.4).
inline constexpr int kMaxListNesting = 64;
// How deep lists may stand in each other all the same, if they send vertices.
inline constexpr std::size_t kMaxListDepth = 20'000;

// How many bytes a name has in the memory of glCallLists (5.4); 0 for what is no type of a name.
int list_name_bytes(Enum type);
// The name at the start of `bytes`: an offset from the list base, that wraps round as GLuint does.
std::uint32_t list_name(std::span<const std::byte> bytes, Enum type);

struct ListedCommand {
    Command command;
    // What the command read of the client's state when it was compiled; null for commands that read nothing of it.
    std::shared_ptr<const PixelStore> pixel_store = nullptr;
    std::shared_ptr<const ArrayVertices> arrays = nullptr;
    // An error of a command that draws arrays: raised when it is executed, as others find theirs then.
    std::shared_ptr<const GlError> error = nullptr;
    // How the quadric was sent that it named then: GLU's own objects are not in the list.
    std::shared_ptr<const Quadric> quadric = nullptr;

    std::size_t elements() const { return arrays ? arrays->vertices.size() + arrays->indices.size() : 0; }
    std::size_t bytes() const;  // about
};

struct DisplayList {
    std::vector<ListedCommand> commands;
    std::size_t bytes = 0;
    // The names of the lists that it calls, without the list base; and whether it sends vertices itself. See walk_calls().
    std::vector<std::uint32_t> calls;
    bool sends_vertices = false;
};

struct Lists {
    std::map<std::uint32_t, std::shared_ptr<const DisplayList>> named;
    std::size_t bytes = 0;                       // of all of them
    std::set<std::uint32_t> called_before_made;  // names that lists called when there was no list of that name

    // The list that is being compiled: between glNewList and glEndList.
    std::uint32_t open_name = 0;  // 0: none
    Enum open_mode = 0;
    Place opened;
    std::shared_ptr<DisplayList> open;

    int nesting = 0;                   // of the lists that are being executed
    Place called;                      // where the outermost of them was called
    const Quadric* quadric = nullptr;  // of the command of a list that is being executed
};

}  // namespace twinlight
