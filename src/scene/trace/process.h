// Starting another program.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace twinlight::trace {

struct Start {
    std::vector<std::string> arguments;  // the first is the program, looked for in PATH
    int input, output, errors;           // what its standard files are; -1: /dev/null
    std::string folder;                  // where it runs
    bool in_session_of_its_own = false;  // a signal for this program's group, as Ctrl-C sends it, does not reach it
};

// The process; -1, and errno, where it cannot be started.
pid_t start(const Start& what);

// Its status, as waitpid() gives it, when it has ended.
int wait_for(pid_t process);

}  // namespace twinlight::trace
