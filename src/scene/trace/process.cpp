#include "scene/trace/process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "base/text/input_text.h"
#include "base/text/translation.h"
#include "scene/command/text.h"
#include "scene/trace/temporary_folder.h"

namespace twinlight::trace {

namespace fs = std::filesystem;

pid_t start(const Start& what) {
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    const int files[] = {what.input, what.output, what.errors};
    for (int standard = STDIN_FILENO; standard <= STDERR_FILENO; ++standard) {
        if (files[standard] < 0) {
            posix_spawn_file_actions_addopen(&actions, standard, "/dev/null", O_RDWR, 0);
        } else {
            posix_spawn_file_actions_adddup2(&actions, files[standard], standard);
        }
    }
    posix_spawn_file_actions_addchdir_np(&actions, what.folder.c_str());

    // Resets SIGPIPE, so that a program that writes to a pipe ends when the reader ends.
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t as_usual;
    sigemptyset(&as_usual);
    sigaddset(&as_usual, SIGPIPE);
    posix_spawnattr_setsigdefault(&attributes, &as_usual);
    posix_spawnattr_setflags(
        &attributes, static_cast<short>(POSIX_SPAWN_SETSIGDEF | (what.has_own_session ? POSIX_SPAWN_SETSID : 0)));

    std::vector<char*> arguments;
    for (const std::string& argument : what.arguments) arguments.push_back(const_cast<char*>(argument.c_str()));
    arguments.push_back(nullptr);
    pid_t process = -1;
    const int error = ::posix_spawnp(&process, arguments[0], &actions, &attributes, arguments.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    errno = error;
    return error == 0 ? process : -1;
}

bool is_executable(const std::string& file) {
    std::error_code ignored;
    return fs::is_regular_file(file, ignored) && ::access(file.c_str(), X_OK) == 0;
}

std::string in_path(const std::string& name) {
    const char* path = std::getenv("PATH");
    InputText folders(path ? path : "/usr/bin:/bin");
    for (std::string folder; std::getline(folders, folder, ':');) {
        const fs::path file = fs::path(folder.empty() ? "." : folder) / name;
        if (is_executable(file.string())) return fs::absolute(file).string();
    }
    return "";
}

void need(const std::string& tool, std::string_view package, std::string_view why) {
    if (in_path(tool).empty()) {
        throw SceneError(tr("{}: is not installed; {} needs it (apt-get install {})", tool, why, package));
    }
}

std::string written_to(const Descriptor& file) {
    constexpr off_t kMost = 1 << 16;
    const off_t size = std::max<off_t>(::lseek(file.get(), 0, SEEK_END), 0);
    const off_t from = std::max<off_t>(size - kMost, 0);
    std::string text(static_cast<std::size_t>(size - from), '\0');
    const ssize_t count = ::pread(file.get(), text.data(), text.size(), from);
    text.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    return text;
}

std::string last_line(const std::string& text) {
    InputText lines(text);
    std::string last;
    for (std::string line; std::getline(lines, line);)
        if (!line.empty()) last = line;
    return last;
}

std::string run_tool(const std::vector<std::string>& arguments) {
    const Descriptor messages = nameless_file();
    const pid_t process = start({arguments, -1, messages.get(), messages.get(), "."});
    if (process <= 0) return tr(std::strerror(errno));
    const int status = wait_for(process);
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return "";
    const std::string words = last_line(written_to(messages));
    return words.empty() ? tr("{} failed", arguments[0]) : words;
}

int wait_for(pid_t process) {
    int status = 0;
    while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
}

}  // namespace twinlight::trace
