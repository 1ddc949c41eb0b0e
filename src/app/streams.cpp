#include "app/streams.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <string>

#include "base/image/file.h"

namespace twinlight {

namespace {

// A handler, because a program that this one starts would inherit that a signal is ignored.
void ignore_signal(int signal) {
    struct sigaction before {
    }, action{};
    if (::sigaction(signal, nullptr, &before) != 0 || before.sa_handler != SIG_DFL) return;
    action.sa_handler = [](int) {};
    action.sa_flags = SA_RESTART;
    ::sigaction(signal, &action, nullptr);
}

}  // namespace

void prepare_streams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(stream, F_GETFD) != -1 || errno != EBADF) continue;
        // It takes the lowest free number. Opened the wrong way round, reading and writing still fail as with a closed stream.
        ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    }
    ignore_signal(SIGPIPE);
    ignore_signal(SIGXFSZ);
}

void write_result(std::string_view bytes) {
    if (std::fwrite(bytes.data(), 1, bytes.size(), stdout) != bytes.size() || std::fflush(stdout) != 0) {
        throw FileError(std::string("standard output: ") + std::strerror(errno));
    }
}

}  // namespace twinlight
