// Uses POSIX calls: C++ streams do not report the reason of a failure.
#include "base/image/file.h"

#include <fcntl.h>
#include <pthread.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <utility>

#include "base/image/descriptor.h"

namespace twinlight {

namespace {

[[noreturn]] void fail(const std::string& path, int error) { throw FileError(path + ": " + std::strerror(error)); }

// Blocks the signals that end a program, so that no temporary file is left behind.
class SignalsBlocked {
  public:
    SignalsBlocked() {
        sigset_t ending;
        sigemptyset(&ending);
        for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&ending, signal);
        pthread_sigmask(SIG_BLOCK, &ending, &before_);
    }
    ~SignalsBlocked() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
    SignalsBlocked(const SignalsBlocked&) = delete;
    SignalsBlocked& operator=(const SignalsBlocked&) = delete;

  private:
    sigset_t before_{};
};

// Returns 0 or the error number.
int write_and_close(Descriptor& file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(file.get(), bytes.data(), bytes.size());
        if (written >= 0) {
            bytes.remove_prefix(static_cast<std::size_t>(written));
        } else if (errno != EINTR) {
            return errno;
        }
    }
    return file.close();
}

// A file's bytes, written under a temporary name in the same folder. The destructor removes it unless put_in_place()
// ran.
class PendingFile {
  public:
    PendingFile(const std::string& path, std::string_view bytes) : path_(path) {
        // Renaming onto a link would replace the link, and onto /dev/null the device.
        struct stat existing {};
        const bool exists = ::stat(path.c_str(), &existing) == 0;
        if (exists && S_ISDIR(existing.st_mode)) fail(path, EISDIR);
        if (exists && !S_ISREG(existing.st_mode)) {
            Descriptor device(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
            if (!device.valid()) fail(path, errno);
            if (const int error = write_and_close(device, bytes); error != 0) fail(path, error);
            return;
        }
        if (exists && ::access(path.c_str(), W_OK) != 0) fail(path, errno);  // a rename would ignore this
        target_ = exists ? std::filesystem::canonical(path).string() : path;

        // The process number gives two writers of one file different temporary names.
        const std::string temporary = target_ + "." + std::to_string(::getpid()) + ".part";
        constexpr mode_t kAsUmaskAllows = 0666;
        Descriptor file(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC,
                               exists ? existing.st_mode & 0777 : kAsUmaskAllows));
        if (!file.valid()) fail(path, errno);
        temporary_ = temporary;
        if (const int error = write_and_close(file, bytes); error != 0) {
            remove_temporary();
            fail(path, error);
        }
    }
    ~PendingFile() { remove_temporary(); }
    PendingFile(PendingFile&& other) noexcept
        : path_(std::move(other.path_)),
          target_(std::move(other.target_)),
          temporary_(std::exchange(other.temporary_, {})) {}

    void remove_old() const {
        if (!temporary_.empty()) ::unlink(target_.c_str());
    }
    void put_in_place() {
        if (temporary_.empty()) return;
        if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail(path_, errno);
        temporary_.clear();
    }

  private:
    void remove_temporary() {
        if (!temporary_.empty()) ::unlink(temporary_.c_str());
    }

    std::string path_;       // as the user wrote it
    std::string target_;     // with links followed
    std::string temporary_;  // empty if there is no temporary file
};

// Reads to the end, at most `max_bytes`. `path` appears in the error message.
std::string read_rest(int descriptor, std::size_t max_bytes, const std::string& path) {
    std::string bytes;
    std::array<char, 1 << 16> block;
    while (bytes.size() < max_bytes) {
        const ssize_t count = ::read(descriptor, block.data(), std::min(block.size(), max_bytes - bytes.size()));
        if (count == 0) break;
        if (count > 0) {
            bytes.append(block.data(), static_cast<std::size_t>(count));
        } else if (errno != EINTR) {
            fail(path, errno);
        }
    }
    return bytes;
}

}  // namespace

std::string read_file(const std::string& path, std::size_t max_bytes) {
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (!file.valid()) fail(path, errno);
    return read_rest(file.get(), max_bytes, path);
}

std::string read_standard_input(std::size_t max_bytes) { return read_rest(STDIN_FILENO, max_bytes, "standard input"); }

void write_files_atomically(const std::vector<FileToWrite>& files, const std::vector<std::string>& stale) {
    const SignalsBlocked blocked;
    std::vector<PendingFile> pending;
    pending.reserve(files.size());
    for (const auto& [path, bytes] : files) pending.emplace_back(path, bytes);
    // If the process is killed here, files are missing, the last one always; new ones never lie beside old ones.
    if (pending.size() + stale.size() > 1)
        std::for_each(pending.rbegin(), pending.rend(), [](const PendingFile& file) { file.remove_old(); });
    for (const std::string& path : stale) ::unlink(path.c_str());
    for (PendingFile& file : pending) file.put_in_place();
}

void write_file_atomically(const std::string& path, std::string_view bytes) { write_files_atomically({{path, bytes}}); }

bool make_folder(const std::string& path) {
    std::error_code error;
    const bool made = std::filesystem::create_directories(path, error);
    if (error) throw FileError(path + ": " + error.message());
    return made;
}

}  // namespace twinlight
