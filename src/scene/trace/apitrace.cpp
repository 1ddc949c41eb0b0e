#include "scene/trace/apitrace.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string_view>
#include <vector>

#include "scene/command/text.h"

namespace twinlight::trace {

namespace {

constexpr const char* kWords = "stderr.txt";  // what apitrace says, in the folder

std::string find_apitrace() {
    const char* path = std::getenv("PATH");
    std::string_view rest = path ? path : "/usr/bin:/bin";
    while (true) {
        const std::size_t end = rest.find(':');
        const std::string candidate = std::string(rest.substr(0, end)) + "/apitrace";
        if (::access(candidate.c_str(), X_OK) == 0) return candidate;
        if (end == std::string_view::npos) return "";
        rest.remove_prefix(end + 1);
    }
}

// The start of what apitrace said, on one line.
std::string first_words(const std::string& path) {
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    std::array<char, 200> text{};
    const ssize_t count = file.valid() ? ::read(file.get(), text.data(), text.size()) : 0;
    std::string line(text.data(), count > 0 ? static_cast<std::size_t>(count) : 0);
    line.resize(std::min(line.find('\n'), line.size()));
    // It may quote the trace, which may hold anything.
    std::ranges::replace_if(
        line, [](char c) { return c < 0x20 || c == 0x7F; }, '?');
    return line;
}

}  // namespace

ApitraceDump::ApitraceDump(const std::string& trace, TemporaryFolder& folder) : folder_(folder) {
    const std::string program = find_apitrace();
    if (program.empty()) {
        throw SceneError(trace +
                         ": a .trace is read by apitrace, which is not installed; install it (apt-get install "
                         "apitrace), or give the text that 'apitrace dump --blobs' prints elsewhere");
    }
    // The dump runs in the folder, for it writes its blobs where it runs.
    std::error_code error;
    const std::string file = std::filesystem::absolute(trace, error).string();
    const std::string words = folder.path() + "/" + kWords;
    const std::array arguments = {program.c_str(),
                                  "dump",
                                  "--color=never",
                                  "--blobs",
                                  "--thread-ids=yes",
                                  "--arg-names=no",
                                  "--multiline=no",
                                  file.c_str(),
                                  static_cast<const char*>(nullptr)};
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw SceneError(trace + ": " + std::strerror(errno));
    output_ = Descriptor(ends[0]);
    const Descriptor input(ends[1]);
    const pid_t parent = ::getpid();
    process_ = ::fork();
    if (process_ < 0) throw SceneError(trace + ": " + std::strerror(errno));
    if (process_ == 0) {
        // Only system calls from here on.
        ::prctl(PR_SET_PDEATHSIG, SIGKILL);
        if (::getppid() != parent || ::chdir(folder.path().c_str()) != 0) ::_exit(127);
        const int nothing = ::open("/dev/null", O_RDONLY);
        const int said = ::open(words.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        ::dup2(nothing, STDIN_FILENO);
        ::dup2(input.get(), STDOUT_FILENO);
        ::dup2(said, STDERR_FILENO);
        ::execv(program.c_str(), const_cast<char* const*>(arguments.data()));
        ::_exit(127);
    }
    folder_.set_writer(process_);
}

ApitraceDump::~ApitraceDump() {
    if (process_ <= 0) return;
    folder_.set_writer(0);
    ::kill(process_, SIGKILL);
    while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
}

std::string ApitraceDump::wait() {
    int status = 0;
    while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    folder_.set_writer(0);
    process_ = 0;
    const std::string words = first_words(folder_.path() + "/" + kWords);
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return words;
    if (!words.empty()) return words;
    return WIFSIGNALED(status) ? std::string("it was ended by signal ") + std::to_string(WTERMSIG(status))
                               : std::string("it ended with status ") + std::to_string(WEXITSTATUS(status));
}

}  // namespace twinlight::trace
