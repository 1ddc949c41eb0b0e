#include "scene/record/running.h"

#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "scene/trace/process.h"

namespace twinlight::trace {

namespace {

namespace fs = std::filesystem;
using std::chrono::steady_clock;

constexpr auto kPause = std::chrono::milliseconds(20);

std::string line_of(const fs::path& file) {
    std::ifstream in(file);
    std::string line;
    std::getline(in, line);
    return line;
}

std::vector<fs::path> numbered(const fs::path& folder) {
    std::vector<fs::path> found;
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
        if (at->path().filename().string().find_first_not_of("0123456789") == std::string::npos)
            found.push_back(at->path());
    return found;
}

// Its folders in /proc.
std::vector<fs::path> processes_of_group(pid_t group) {
    std::vector<fs::path> found;
    for (const fs::path& process : numbered("/proc")) {
        const std::string stat = line_of(process / "stat");
        std::istringstream rest(stat.substr(std::min(stat.rfind(')') + 1, stat.size())));
        std::string state;
        pid_t parent = 0, of = 0;
        if (rest >> state >> parent >> of && of == group && state != "Z") found.push_back(process);
    }
    return found;
}

// The library or program that a process has at this address; "" for other memory, such as code that Mesa has compiled.
std::string mapped_at(const fs::path& process, unsigned long address) {
    std::ifstream maps(process / "maps");
    for (std::string line; std::getline(maps, line);) {
        unsigned long first = 0, last = 0;
        char dash = 0;
        std::istringstream in(line);
        if (!(in >> std::hex >> first >> dash >> last) || address < first || address >= last) continue;
        const std::size_t name = line.find('/');
        return name == std::string::npos ? "" : fs::path(line.substr(name)).filename().string();
    }
    return "";
}

// Whether a stopped thread may be in apitrace, or in what apitrace calls: the C library, the unwinder of stacks.
bool may_record(const fs::path& process, const fs::path& thread) {
    static constexpr std::array kWaiting = {
#ifdef SYS_poll
        SYS_poll,  SYS_select,
#endif
        SYS_ppoll, SYS_pselect6, SYS_futex, SYS_nanosleep, SYS_clock_nanosleep, SYS_recvmsg, SYS_wait4, SYS_sched_yield,
    };
    std::istringstream in(line_of(thread / "syscall"));
    long call = 0;
    if (!(in >> call)) return true;  // "running"
    if (call >= 0) return std::ranges::find(kWaiting, call) == kWaiting.end();
    unsigned long stack = 0, address = 0;
    if (!(in >> std::hex >> stack >> address)) return true;
    const std::string name = mapped_at(process, address);
    static constexpr std::array kOfTracer = {"glxtrace", "egltrace",  "libc.", "libc-",
                                             "libgcc_s", "libstdc++", "ld-",   "libz"};
    return std::ranges::any_of(kOfTracer, [&](const char* start) { return name.starts_with(start); });
}

bool may_record(pid_t group) {
    for (const fs::path& process : processes_of_group(group))
        for (const fs::path& thread : numbered(process / "task"))
            if (may_record(process, thread)) return true;
    return false;
}

}  // namespace

bool Running::wait(const std::function<bool()>& done) {
    while (!ended()) {
        if (done()) return false;
        std::this_thread::sleep_for(kPause);
    }
    return true;
}

void Running::end() {
    if (ended()) return;
    constexpr int kTries = 500;
    constexpr auto kShort = std::chrono::milliseconds(1);
    for (int i = 0; i < kTries && fs::exists("/proc/self/syscall"); ++i) {
        ::kill(-process_, SIGSTOP);
        std::this_thread::sleep_for(kShort);
        if (!may_record(process_)) break;
        ::kill(-process_, SIGCONT);
        std::this_thread::sleep_for(kShort);
    }
    // `apitrace trace`, which leads them, ends at once on SIGINT, before the program has written its buffer.
    const std::vector<fs::path> processes = processes_of_group(process_);
    for (const fs::path& process : processes) {
        const pid_t id = std::stoi(process.filename().string());
        if (id != process_ || processes.size() == 1) ::kill(id, SIGINT);
    }
    ::kill(-process_, SIGCONT);
    const auto limit = steady_clock::now() + std::chrono::seconds(3);  // some programs catch it and continue
    wait([&] { return steady_clock::now() >= limit; });
    kill();
}

void Running::kill() {
    if (process_ <= 0) return;
    ::kill(-process_, SIGKILL);
    wait_for(std::exchange(process_, 0));
}

bool Running::ended() {
    if (process_ <= 0) return true;
    int status = 0;
    const pid_t found = ::waitpid(process_, &status, WNOHANG);
    if (found == 0 || (found < 0 && errno == EINTR)) return false;
    status_ = status;
    ::kill(-process_, SIGKILL);  // children that are left
    process_ = 0;
    return true;
}

}  // namespace twinlight::trace
