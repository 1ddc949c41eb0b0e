#include "scene/trace/apitrace.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <vector>

#include "base/text/translation.h"
#include "scene/command/text.h"
#include "scene/trace/process.h"

namespace twinlight::trace {

namespace {

// A damaged trace of nine bytes can make apitrace fill the memory. Blobs have at most 256 MiB.
constexpr rlim_t kMostBytes = 2'000'000'000;

// The first line of apitrace's messages.
std::string first_words(const Descriptor& file) {
    std::array<char, 200> text{};
    const ssize_t count = ::pread(file.get(), text.data(), text.size(), 0);
    std::string line(text.data(), count > 0 ? static_cast<std::size_t>(count) : 0);
    line.resize(std::min(line.find('\n'), line.size()));
    // The message may quote bytes of the trace, so control characters become '?'.
    std::ranges::replace_if(
        line, [](char c) { return c < 0x20 || c == 0x7F; }, '?');
    return line;
}

}  // namespace

ApitraceDump::ApitraceDump(const std::string& name, const std::string& trace, const Descriptor& input, Blobs blobs)
    : messages_(nameless_file()) {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw SceneError(name + ": " + tr(std::strerror(errno)));
    output_ = Descriptor(ends[0]);
    const Descriptor dump(ends[1]);
    // It runs in the temporary folder, because it writes blobs to its working folder. With --multiline=no it leaves out stacks.
    std::vector<std::string> command = {"apitrace", "dump", "--color=never", "--thread-ids=yes", "--arg-names=no"};
    if (blobs == Blobs::kAreRead) command.emplace_back("--blobs");
    command.push_back(input.valid() ? "/dev/stdin" : std::filesystem::absolute(trace).string());
    process_ = start({command, input.get(), dump.get(), messages_.get(), folder()});
    if (process_ > 0) {
        const rlimit most{kMostBytes, kMostBytes};
        ::prlimit(process_, RLIMIT_AS, &most, nullptr);
        return;
    }
    if (errno != ENOENT && errno != EACCES) throw SceneError(name + ": " + tr(std::strerror(errno)));
    throw SceneError(
        tr("{}: reading a .trace needs apitrace, which is not installed; install it (apt-get install apitrace), or "
           "run 'apitrace dump --blobs' on another computer and give its output instead",
           name));
}

ApitraceDump::~ApitraceDump() {
    if (process_ <= 0) return;
    ::kill(process_, SIGKILL);
    wait_for(process_);
}

std::string ApitraceDump::wait() {
    const int status = wait_for(std::exchange(process_, 0));
    // Then its last words are about its own code.
    if (WIFSIGNALED(status))
        return tr("it failed (signal {}); the file is damaged, or not a recording", WTERMSIG(status));
    const std::string words = first_words(messages_);
    if (!words.empty() || WEXITSTATUS(status) == 0) return words;
    return tr("it ended with status {}", WEXITSTATUS(status));
}

}  // namespace twinlight::trace
