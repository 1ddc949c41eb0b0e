// Starts another program.
#pragma once

#include <sys/types.h>

#include <string>
#include <string_view>
#include <vector>

#include "base/image/descriptor.h"

namespace twinlight::trace {

struct Start {
    std::vector<std::string> arguments;  // the first is the program, searched in PATH
    int input, output, errors;           // descriptors of its standard files; -1: /dev/null
    std::string folder;                  // its working folder
    bool has_own_session = false;        // if true, Ctrl-C does not reach it
};

// Returns the process, or -1 (see errno) if it cannot be started.
pid_t start(const Start& what);

// A program in PATH; "" if there is none.
std::string in_path(const std::string& name);
bool is_executable(const std::string& file);
// Throws SceneError, which names the package, if a tool is not in PATH.
void need(const std::string& tool, std::string_view package, std::string_view why);

// The end of what a process wrote to a file.
std::string written_to(const Descriptor& file);
std::string last_line(const std::string& text);

// Runs a tool to its end. Returns its last message if it fails, else "".
std::string run_tool(const std::vector<std::string>& arguments);

// Waits until the process ends. Returns its status as waitpid() does.
int wait_for(pid_t process);

}  // namespace twinlight::trace
