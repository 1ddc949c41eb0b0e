// Starts another program.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace twinlight::trace {

struct Start {
    std::vector<std::string> arguments;  // the first is the program, searched in PATH
    int input, output, errors;           // descriptors of its standard files; -1: /dev/null
    std::string folder;                  // its working folder
    bool has_own_session = false;        // if true, Ctrl-C does not reach it
};

// Returns the process, or -1 (see errno) if it cannot be started.
pid_t start(const Start& what);

// Waits until the process ends. Returns its status as waitpid() does.
int wait_for(pid_t process);

}  // namespace twinlight::trace
