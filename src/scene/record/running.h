// A program that runs under apitrace.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <functional>
#include <optional>

namespace twinlight::trace {

// A process with a session of its own; ends with all its children.
class Running {
  public:
    explicit Running(pid_t process) : process_(process) {}
    ~Running() { kill(); }
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;

    // Waits until it ends or `done` is true. Returns whether it ended.
    bool wait(const std::function<bool()>& done);
    // Ends it. On SIGINT apitrace writes its buffer, up to a megabyte, but only if the program is not in the middle of a call that
    // it records just then: the buffer, perhaps the whole recording, is lost otherwise. So this waits for such a moment.
    void end();
    // As waitpid() gives it, once it has ended.
    std::optional<int> status() const { return status_; }

  private:
    bool ended();
    void kill();

    pid_t process_;
    std::optional<int> status_{};
};

}  // namespace twinlight::trace
