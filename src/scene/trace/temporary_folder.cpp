#include "scene/trace/temporary_folder.h"

#include <fcntl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>

#include "scene/command/text.h"

namespace twinlight::trace {

namespace {

// Removes a folder that holds no folders. Only what a signal's handler may call: system calls, no memory.
void remove_folder(const char* path) {
    const int folder = ::open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC | O_NOFOLLOW);
    if (folder < 0) return;
    struct Entry {  // linux_dirent64, getdents64(2)
        std::uint64_t inode;
        std::int64_t offset;
        std::uint16_t size;
        std::uint8_t type;
        char name[1];
    };
    alignas(Entry) char buffer[4096];
    while (true) {
        // From the start each time, for what is removed may move the rest.
        ::lseek(folder, 0, SEEK_SET);
        const long bytes = ::syscall(SYS_getdents64, folder, buffer, sizeof buffer);
        bool removed = false;
        for (long at = 0; at < bytes;) {
            const auto* entry = reinterpret_cast<const Entry*>(buffer + at);
            const char* const name = entry->name;
            const bool is_dots = name[0] == '.' && (name[1] == '\0' || (name[1] == '.' && name[2] == '\0'));
            if (!is_dots && ::unlinkat(folder, name, 0) == 0) removed = true;
            at += entry->size;
        }
        if (!removed) break;
    }
    ::close(folder);
    ::rmdir(path);
}

// The folders there are, for the handler: it may come at any instruction, so a slot holds a whole path or none.
constexpr std::size_t kMostFolders = 8;
constexpr std::size_t kLongestPath = 4096;
struct Slot {
    std::atomic<bool> used{false};
    std::atomic<pid_t> writer{0};
    std::array<char, kLongestPath> path{};
};
std::array<Slot, kMostFolders> slots;  // NOLINT: a handler reaches nothing but what is global

constexpr std::array kEndingSignals = {SIGINT, SIGTERM, SIGHUP};
std::array<struct sigaction, kEndingSignals.size()> actions_before;  // NOLINT
int folders = 0;                                                     // NOLINT

extern "C" void remove_folders_and_end(int signal) {
    for (const Slot& slot : slots) {
        if (!slot.used) continue;
        if (const pid_t writer = slot.writer; writer > 0 && ::kill(writer, SIGKILL) == 0) {
            ::waitpid(writer, nullptr, 0);
        }
        remove_folder(slot.path.data());
    }
    // As it would have ended: the caller sees the signal.
    ::signal(signal, SIG_DFL);
    ::raise(signal);
}

void watch_signals() {
    if (folders++ > 0) return;
    struct sigaction action {};
    action.sa_handler = remove_folders_and_end;
    for (std::size_t i = 0; i < kEndingSignals.size(); ++i) {
        ::sigaction(kEndingSignals[i], nullptr, &actions_before[i]);
        // Who ignores a signal (nohup) goes on ignoring it.
        if (actions_before[i].sa_handler == SIG_DFL) ::sigaction(kEndingSignals[i], &action, nullptr);
    }
}

void leave_signals() {
    if (--folders > 0) return;
    for (std::size_t i = 0; i < kEndingSignals.size(); ++i) {
        if (actions_before[i].sa_handler == SIG_DFL) ::sigaction(kEndingSignals[i], &actions_before[i], nullptr);
    }
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
    const char* parent = std::getenv("TMPDIR");
    path_ = std::string(parent && *parent ? parent : "/tmp") + "/twinlight-XXXXXX";
    while (slot_ < slots.size() && slots[slot_].used) ++slot_;
    if (slot_ == slots.size()) throw SceneError("too many recordings are open at once");
    Slot& slot = slots[slot_];
    watch_signals();
    if (path_.size() >= kLongestPath || !::mkdtemp(path_.data())) {
        const std::string reason = std::strerror(errno);
        leave_signals();
        throw SceneError(path_ + ": no folder can be made here: " + reason +
                         "; set TMPDIR to a folder that can be written to");
    }
    std::memcpy(slot.path.data(), path_.c_str(), path_.size() + 1);
    slot.writer = 0;
    slot.used = true;
}

TemporaryFolder::~TemporaryFolder() {
    remove_folder(path_.c_str());
    slots[slot_].used = false;
    leave_signals();
}

void TemporaryFolder::set_writer(pid_t process) { slots[slot_].writer = process; }

}  // namespace twinlight::trace
