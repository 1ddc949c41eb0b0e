// The functions and names in a dump, and how Twinlight treats them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

#include "scene/command/command.h"

namespace twinlight::trace {

// How a call of a function is treated.
enum class Role : std::uint8_t {
    kCommand,      // a row of commands.def
    kIgnored,      // a function of the window system, a query, or one without effect on the picture
    kFrameEnd,     // SwapBuffers
    kMakeCurrent,  // sets a thread's context; the last argument names it
    kMapBuffer,    // glMapBuffer: later writes to the mapping are copied into the buffer object
    kCopy,         // memcpy: such a write
    kBlit,         // glBlitFramebuffer
    kStorage,      // glRenderbufferStorageMultisample
    kDepthOffset,  // glPolygonOffsetEXT
    kBinding,      // binds an object that Twinlight lacks, or 0 for none (the last argument)
    kOutside,      // anything else: reported as unsupported
};

struct Function {
    Role role = Role::kOutside;
    CommandId command{};         // for kCommand
    bool draws = false;          // draws vertices or pixels
    bool is_vertex = false;      // one vertex between glBegin and glEnd: glVertex*, glArrayElement
    bool makes_context = false;  // creates a context: one argument names the context to share objects with
    bool names_format = false;   // WindowFormats::is_needed()
    bool makes_objects = false;  // creates objects that contexts may share: textures, lists, buffer objects
    bool names_shared = false;   // names such objects: binds a texture or a buffer, makes or calls lists
    bool is_mark = false;        // glStringMarkerGREMEDY, which may hold a stack of Python
    bool sets_units = false;     // chooses a texture unit, or may set the state of one
};

// Whether a function of the window system creates a context: its second argument names a pixel format, its result the context.
bool makes_context(std::string_view name);

// Looks up functions by name. Each name is classified at its first use.
class FunctionTable {
  public:
    // The reference is valid until the next call.
    const Function& find(std::string_view name);

  private:
    struct Hash {
        using is_transparent = void;
        std::size_t operator()(std::string_view text) const { return std::hash<std::string_view>{}(text); }
    };
    std::unordered_map<std::string, Function, Hash, std::equal_to<>> known_;
    Function other_;  // for names that no longer fit into known_
};

// The value of an enumerant in a dump. It may have a different name there: apitrace prints some values of GL 2.1 under
// the names of later versions, and a program may use the name of an extension.
std::optional<Enum> find_dumped_name(std::string_view name);

}  // namespace twinlight::trace
