// The call stacks that `apitrace dump` prints after a call, if it was recorded with APITRACE_BACKTRACE:
//
//     37 @0 glEnable(cap = GL_LIGHT0)
//     Backtrace:
//     /home/me/lamp: Lamp::use(int) const+0x1a: /home/me/lamp.cpp:25
//     /home/me/lamp: display()+0x2f: /home/me/lamp.cpp:71
//     /lib/x86_64-linux-gnu/libglut.so.3.12: fghRedrawWindow+0x3c
//     ...
//
// The place of the call is the innermost frame in the program's own sources, lamp.cpp:25 here.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "scene/command/place.h"

namespace twinlight::trace {

inline constexpr std::size_t kLongestStack = 1 << 16;  // as text

// One line of a stack. Texts that are not known are empty, and an unknown line is 0.
struct CallFrame {
    std::string_view module, function, file;
    int line = 0;
};
// The frames of a stack as text, which must exist as long as they do.
std::vector<CallFrame> frames_of(std::string_view stack);

// The program's files, read once each.
class SourceTexts {
  public:
    // Null if this is not a file of source that can be read.
    std::shared_ptr<const std::string> find(const std::string& file);

  private:
    std::map<std::string, std::shared_ptr<const std::string>> texts_;
};

// Many calls share few stacks, so each is read only once.
class CallStacks {
  public:
    // The place of a call of `function` with this stack, whose frames are read where it is a new one; with null `file` if no frame is
    // in the program's sources. Its column is that of the function in the text of the line, or else of the library's function that
    // called it.
    const Place& place(std::string_view stack, std::string_view function,
                       const std::function<std::vector<CallFrame>(std::string_view)>& frames = frames_of);

  private:
    Place read(const std::vector<CallFrame>& stack, std::string_view function);
    std::shared_ptr<const std::string> shared(std::string text);

    SourceTexts sources_;
    std::unordered_map<std::string, Place> places_;                    // by the stack and the function
    std::map<std::string, std::shared_ptr<const std::string>> names_;  // of files, and chains of calls
};

}  // namespace twinlight::trace
