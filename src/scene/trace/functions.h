// The functions and names that stand in a dump, and what they are to Twinlight.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

#include "scene/command/command.h"

namespace twinlight::trace {

// What a call of a function comes to.
enum class Role : std::uint8_t {
    kCommand,      // a row of commands.def
    kPassedOver,   // of the window system, or a query, or without an effect on the picture
    kFrameEnd,     // SwapBuffers
    kMakeCurrent,  // a thread's context; the last argument says which
    kMapBuffer,    // glMapBuffer: what is written there later is copied into the buffer object
    kCopy,         // memcpy: such a copy
    kBinding,      // of an object that Twinlight does not have; 0, the last argument, is GL's own
    kOutside,      // anything else: named as unsupported
};

struct Function {
    Role role = Role::kOutside;
    CommandId command{};         // of kCommand
    bool draws = false;          // vertices or pixels
    bool makes_objects = false;  // that contexts may share: textures, lists, buffer objects
};

// What each name is, worked out when it is first met.
class FunctionTable {
  public:
    // The answer is valid until the next.
    const Function& find(std::string_view name);

  private:
    struct Hash {
        using is_transparent = void;
        std::size_t operator()(std::string_view text) const { return std::hash<std::string_view>{}(text); }
    };
    std::unordered_map<std::string, Function, Hash, std::equal_to<>> known_;
    Function other_;  // for what no longer fits into known_
};

// The value of an enumerant under any name that it has in a dump: apitrace prints some of GL 2.1's values by the names
// that later versions gave them, and a program may use an extension's.
std::optional<Enum> find_dumped_name(std::string_view name);

}  // namespace twinlight::trace
