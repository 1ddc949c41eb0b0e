// Display lists (5.4): commands that are stored and executed later.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <span>
#include <vector>

#include "scene/command/command.h"
#include "scene/frame/frame.h"
#include "scene/shape/quadric.h"
#include "scene/state/arrays.h"
#include "scene/state/pixel_unpacking.h"

namespace twinlight {

// Limits of a scene: the number of lists, and the size of all lists together, without the memory that their commands
// point to.
inline constexpr std::size_t kMaxLists = 1 << 20;
inline constexpr std::size_t kMaxListedBytes = std::size_t{1} << 30;
// GL_MAX_LIST_NESTING: at least 64 (table 6.29); 64 in Mesa. Lists that are nested deeper are not executed (5.4).
inline constexpr int kMaxListNesting = 64;
// The deepest nesting that is accepted for lists that send vertices (see walk_calls()).
inline constexpr std::size_t kMaxListDepth = 20'000;

// The size in bytes of a list name of this type in the memory of glCallLists (5.4); 0 if the type is not allowed.
int list_name_bytes(Enum type);
// The name at the start of `bytes`: an offset from the list base that wraps around like a GLuint.
std::uint32_t list_name(std::span<const std::byte> bytes, Enum type);

struct ListedCommand {
    Command command;
    // The client state that the command read when it was compiled; null if it reads none.
    std::shared_ptr<const PixelStore> pixel_store = nullptr;
    std::shared_ptr<const ArrayVertices> arrays = nullptr;
    // The error of a command that draws arrays. It is raised when the list is executed, like the errors of other
    // commands.
    std::shared_ptr<const GlError> error = nullptr;
    // The settings of the command's quadric at that time: GLU's objects are not part of the list.
    std::shared_ptr<const Quadric> quadric = nullptr;

    std::size_t elements() const { return arrays ? arrays->vertices.size() + arrays->indices.size() : 0; }
    std::size_t bytes() const;  // approximately
};

struct DisplayList {
    std::vector<ListedCommand> commands;
    std::size_t bytes = 0;
    // The names of the lists that it calls, without the list base, and whether it sends vertices itself. See
    // walk_calls().
    std::vector<std::uint32_t> calls;
    bool sends_vertices = false;
};

struct Lists {
    std::map<std::uint32_t, std::shared_ptr<const DisplayList>> named;
    std::size_t bytes = 0;                       // the size of all lists
    std::set<std::uint32_t> called_before_made;  // names that a list called before a list of that name existed

    // The list that is being compiled: between glNewList and glEndList.
    std::uint32_t open_name = 0;  // 0: none
    Enum open_mode = 0;
    Place opened;
    std::shared_ptr<DisplayList> open;

    int nesting = 0;                       // how many lists are being executed
    std::shared_ptr<const ListCall> call;  // of the innermost one
    const Quadric* quadric = nullptr;      // that of the listed command being executed
};

}  // namespace twinlight
