// Xvfb: an X server without a screen, alive as long as the object. It picks a free display number itself.
//
//   Xvfb server;
//   if (!server.running()) GTEST_SKIP() << server.reason();
//   run("DISPLAY=" + server.display() + " build/twinlight-demo ...");
#pragma once

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

namespace twinlight {

class Xvfb {
  public:
    explicit Xvfb(const std::string& screen = "1280x1024x24") {
        int ready[2];
        if (::pipe2(ready, O_CLOEXEC) != 0) {
            reason_ = std::string("no pipe for Xvfb: ") + std::strerror(errno);
            return;
        }
        const std::string descriptor = std::to_string(ready[1]);
        pid_ = ::fork();
        if (pid_ == 0) {
            // Without -noreset the server starts again when its last client leaves, and refuses those that come just then.
            // The child: the server may write to the pipe, says nothing on the test's output, and ends with
            // the test even where that is killed.
            ::prctl(PR_SET_PDEATHSIG, SIGTERM);
            ::fcntl(ready[1], F_SETFD, 0);
            const int null = ::open("/dev/null", O_RDWR);
            for (const int fd : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::dup2(null, fd);
            ::execlp("Xvfb", "Xvfb", "-displayfd", descriptor.c_str(), "-screen", "0", screen.c_str(), "-nolisten",
                     "tcp", "-noreset", nullptr);
            ::_exit(127);
        }
        ::close(ready[1]);
        if (pid_ > 0) read_display(ready[0]);
        ::close(ready[0]);
        if (!running() && reason_.empty()) {
            reason_ = "Xvfb did not start; it is in Debian's package xvfb";
        }
    }

    ~Xvfb() {
        if (pid_ <= 0) return;
        ::kill(pid_, SIGTERM);
        ::waitpid(pid_, nullptr, 0);
    }

    Xvfb(const Xvfb&) = delete;
    Xvfb& operator=(const Xvfb&) = delete;

    bool running() const { return !display_.empty(); }
    const std::string& display() const { return display_; }  // ":1"
    const std::string& reason() const { return reason_; }    // why it is not running

  private:
    // The server writes its number and a newline once it accepts connections, or closes the pipe and ends.
    void read_display(int fd) {
        constexpr int kStartMilliseconds = 20'000;
        std::string number;
        pollfd waiting{fd, POLLIN, 0};
        while (::poll(&waiting, 1, kStartMilliseconds) > 0) {
            char c = 0;
            if (::read(fd, &c, 1) != 1) return;
            if (c == '\n') {
                display_ = ":" + number;
                return;
            }
            number += c;
        }
        reason_ = "Xvfb did not answer";
    }

    pid_t pid_ = -1;
    std::string display_;
    std::string reason_;
};

}  // namespace twinlight
