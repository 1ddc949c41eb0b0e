// twinlight-demo as a process of its own, for the tests that press its keys.
#pragma once

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "../unit/run_program.h"

namespace twinlight::demo_window {

inline std::string program() { return build_folder() + "/twinlight-demo"; }

inline const std::filesystem::path& folder() {
    static const std::filesystem::path kFolder = [] {
        std::string name = (std::filesystem::temp_directory_path() / "twinlight-demo-test-XXXXXX").string();
        return std::filesystem::path(::mkdtemp(name.data()));
    }();
    return kFolder;
}

// For a sanitized program: what the driver and GLX leak is not ours.
inline constexpr const char* kSanitizer = "detect_leaks=0";

struct Ran {
    int status = -1;
    std::string output;  // stdout and stderr
};

inline Ran run(const std::string& command) {
    Ran ran;
    FILE* pipe =
        ::popen(("{ export ASAN_OPTIONS=" + std::string(kSanitizer) + "; " + command + "; } 2>&1").c_str(), "r");
    if (pipe == nullptr) return ran;
    char piece[4096];
    while (const std::size_t n = std::fread(piece, 1, sizeof piece, pipe)) ran.output.append(piece, n);
    const int waited = ::pclose(pipe);
    ran.status = WIFEXITED(waited) ? WEXITSTATUS(waited) : -1;
    return ran;
}

inline bool wait_for(const std::function<bool()>& condition) {
    using Clock = std::chrono::steady_clock;
    const auto deadline = Clock::now() + std::chrono::seconds(20);  // only a broken program waits that long
    while (Clock::now() < deadline) {
        if (condition()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
}

// The demo, running with a window.
class RunningDemo {
  public:
    RunningDemo(const std::string& display, const std::vector<std::string>& options) {
        pid_ = ::fork();
        if (pid_ != 0) return;
        ::prctl(PR_SET_PDEATHSIG, SIGTERM);
        for (const int signal : {SIGINT, SIGHUP})
            ::signal(signal, SIG_DFL);  // ignored if the tests run in the background
        ::setenv("DISPLAY", display.c_str(), 1);
        ::setenv("LC_ALL", "C", 1);                 // in English
        ::setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);  // Xvfb has no GPU; the host may
        ::setenv("ASAN_OPTIONS", kSanitizer, 1);
        ::setenv("XDG_STATE_HOME", (folder() / "state").c_str(), 1);    // where it keeps unsaved changes
        ::setenv("XDG_CONFIG_HOME", (folder() / "config").c_str(), 1);  // and what it remembers
        const std::string path = std::filesystem::absolute(program()).string();
        std::filesystem::current_path(folder());  // where it saves files
        std::vector<char*> arguments{const_cast<char*>(path.c_str())};
        for (const std::string& option : options) arguments.push_back(const_cast<char*>(option.c_str()));
        arguments.push_back(nullptr);
        const int log = ::open((folder() / "demo.log").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        ::dup2(log, STDOUT_FILENO);
        ::dup2(log, STDERR_FILENO);
        ::execv(path.c_str(), arguments.data());
        ::_exit(127);
    }
    ~RunningDemo() {
        if (pid_ <= 0) return;
        ::kill(pid_, SIGKILL);
        ::waitpid(pid_, nullptr, 0);
    }
    RunningDemo(const RunningDemo&) = delete;
    RunningDemo& operator=(const RunningDemo&) = delete;

    // The exit status once it has ended by itself; -1 if it does not.
    int ended() {
        int waited = 0;
        if (!wait_for([&] { return ::waitpid(pid_, &waited, WNOHANG) == pid_; })) return -1;
        pid_ = -1;
        return WIFEXITED(waited) ? WEXITSTATUS(waited) : -1;
    }

    pid_t pid() const { return pid_; }

    // Whether it uses no processor time for a second, at last. At first it draws, and the reference works.
    bool comes_to_rest() const {
        const auto ticks = [&] {
            const std::string stat = read_file("/proc/" + std::to_string(pid_) + "/stat");
            std::istringstream fields(stat.substr(stat.rfind(')') + 2));
            std::string skipped;
            for (int i = 0; i < 11; ++i) fields >> skipped;
            long user = 0, system = 0;
            fields >> user >> system;
            return user + system;
        };
        long before = -1;
        return wait_for([&] {
            std::this_thread::sleep_for(std::chrono::seconds(1));
            const long now = ticks();
            return std::exchange(before, now) == now && now > 0;
        });
    }

  private:
    pid_t pid_ = -1;
};

}  // namespace twinlight::demo_window
