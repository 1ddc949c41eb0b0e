// Uses POSIX calls: C++ streams do not report the reason of a failure.
#include "base/image/file.h"

#include <fcntl.h>
#include <pthread.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <utility>

#include "base/image/descriptor.h"
#include "base/text/translation.h"

namespace twinlight {

namespace {

[[noreturn]] void fail(const std::string& path, int error) { throw FileError(path + ": " + tr(std::strerror(error))); }

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

// Return 0 or the error number.
int write_all(const Descriptor& file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(file.get(), bytes.data(), bytes.size());
        if (written >= 0) {
            bytes.remove_prefix(static_cast<std::size_t>(written));
        } else if (errno != EINTR) {
            return errno;
        }
    }
    return 0;
}
int write_and_close(Descriptor& file, std::string_view bytes) {
    const int error = write_all(file, bytes);
    return error != 0 ? error : file.close();
}

// The folder itself, or the innermost one above it that exists.
std::string existing_part(const std::string& folder) {
    std::filesystem::path path = folder.empty() ? "." : folder;
    std::error_code ignored;
    while (!std::filesystem::exists(path, ignored)) {
        const std::filesystem::path above = path.parent_path();
        if (above == path) break;
        path = above.empty() ? "." : above;
    }
    return path.string();
}

// The folders that writing has made. The destructor removes those that are still empty.
class MadeFolders {
  public:
    MadeFolders() = default;
    ~MadeFolders() {
        while (!made_.empty()) {
            ::rmdir(made_.back().c_str());
            made_.pop_back();
        }
    }
    MadeFolders(const MadeFolders&) = delete;
    MadeFolders& operator=(const MadeFolders&) = delete;

    // With those that it lies in.
    void make(const std::string& folder) {
        if (folder.empty() || folder == last_) return;
        last_ = folder;
        if (made(folder)) return;
        if (errno != ENOENT) fail(folder, errno);
        const std::string above = std::filesystem::path(folder).parent_path().string();
        if (above == folder) fail(folder, ENOENT);
        make(above);
        if (!made(folder)) fail(folder, errno);
    }

  private:
    // False with errno if that fails.
    bool made(const std::string& folder) {
        made_.push_back(folder);  // needs memory, which may be short
        if (::mkdir(folder.c_str(), 0777) == 0) return true;
        const int error = errno;
        made_.pop_back();
        errno = error;
        return error == EEXIST;
    }

    std::vector<std::string> made_;  // the outer ones first
    std::string last_;               // many files follow each other in one folder
};

// A file's bytes. They have no name until put_in_place() gives them one, so that nothing is left behind even if the process is killed.
// A file system that has no such files (O_TMPFILE) holds them under a temporary name, which the destructor removes.
class PendingFile {
  public:
    // `made`: makes a missing folder; null where that is an error.
    PendingFile(const std::string& path, std::string_view bytes, bool may_be_nameless, MadeFolders* made)
        : path_(path) {
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

        constexpr mode_t kAsUmaskAllows = 0666;
        const mode_t mode = exists ? existing.st_mode & 0777 : kAsUmaskAllows;
        folder_ = std::filesystem::path(target_).parent_path().string();
        const std::string there = made ? existing_part(folder_) : folder_.empty() ? "." : folder_;
        if (made && !std::filesystem::is_directory(there)) fail(folder_, ENOTDIR);
        if (may_be_nameless && ::access("/proc/self/fd", X_OK) == 0) {
            file_ = Descriptor(::open(there.c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, mode));
        }
        if (file_.valid()) {
            if (const int error = write_all(file_, bytes); error != 0) fail(path, error);
            return;
        }
        if (made) made->make(folder_);
        // The process number gives two writers of one file different temporary names.
        std::string temporary = target_ + "." + std::to_string(::getpid()) + ".part";
        Descriptor file(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode));
        if (!file.valid()) fail(path, errno);
        temporary_ = std::move(temporary);  // needs no memory, which may be short
        if (const int error = write_and_close(file, bytes); error != 0) {
            remove_temporary();
            fail(path, error);
        }
    }
    ~PendingFile() { remove_temporary(); }
    PendingFile(PendingFile&& other) noexcept
        : path_(std::move(other.path_)),
          target_(std::move(other.target_)),
          folder_(std::move(other.folder_)),
          file_(std::move(other.file_)),
          temporary_(std::exchange(other.temporary_, {})) {}

    void remove_old() const {
        if (!target_.empty()) ::unlink(target_.c_str());
    }
    void make_folder(MadeFolders& made) const {
        if (!target_.empty()) made.make(folder_);
    }
    // Needs no memory if there is no file of this name.
    void put_in_place() {
        if (target_.empty()) return;
        if (temporary_.empty() && link_to(target_)) return;
        if (temporary_.empty()) {
            // No call replaces a file with a nameless one. If the process is killed here, the .part file stays until this file is written again.
            temporary_ = target_ + ".part";
            ::unlink(temporary_.c_str());
            if (!link_to(temporary_)) fail(path_, EEXIST);
        }
        if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail(path_, errno);
        temporary_.clear();
    }

  private:
    // False if there is a file with this name.
    bool link_to(const std::string& name) const {
        std::array<char, 32> file;
        std::snprintf(file.data(), file.size(), "/proc/self/fd/%d", file_.get());
        if (::linkat(AT_FDCWD, file.data(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0) return true;
        if (errno != EEXIST) fail(path_, errno);
        return false;
    }
    void remove_temporary() {
        if (!temporary_.empty()) ::unlink(temporary_.c_str());
    }

    std::string path_;       // as the user wrote it
    std::string target_;     // with links followed; empty for a device
    std::string folder_;     // that it lies in; empty for the working one
    Descriptor file_;        // without a name; or
    std::string temporary_;  // its name
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

std::string extension_of(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

void refuse_special_file(const std::string& path) {
    struct stat about {};
    if (::stat(path.c_str(), &about) != 0 || S_ISREG(about.st_mode) || S_ISDIR(about.st_mode)) return;
    if (path.starts_with("/dev/") || path.starts_with("/proc/")) return;
    throw FileError(tr("{}: this is {}, not a file; give a file, or - for standard input", path,
                       S_ISFIFO(about.st_mode)   ? tr("a named pipe")
                       : S_ISSOCK(about.st_mode) ? tr("a socket")
                                                 : tr("a device")));
}

std::string read_file(const std::string& path, std::size_t max_bytes) {
    refuse_special_file(path);
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (!file.valid()) fail(path, errno);
    return read_rest(file.get(), max_bytes, path);
}

std::string read_standard_input(std::size_t max_bytes) {
    return read_rest(STDIN_FILENO, max_bytes, tr("standard input"));
}

void write_files_atomically(const std::vector<FileToWrite>& files, const std::vector<std::string>& stale,
                            MissingFolders missing) {
    constexpr std::size_t kMostNameless = 256;  // each is open until it has its name
    const SignalsBlocked blocked;
    MadeFolders all_made;
    MadeFolders* made = missing == MissingFolders::kMade ? &all_made : nullptr;
    std::vector<PendingFile> pending;
    pending.reserve(files.size());
    for (const auto& [path, bytes] : files) pending.emplace_back(path, bytes, pending.size() < kMostNameless, made);
    if (made)
        for (const PendingFile& file : pending) file.make_folder(*made);
    // If the process is killed here, files are missing, the last one always; new ones never lie beside old ones.
    if (pending.size() + stale.size() > 1)
        std::for_each(pending.rbegin(), pending.rend(), [](const PendingFile& file) { file.remove_old(); });
    for (const std::string& path : stale) ::unlink(path.c_str());
    for (PendingFile& file : pending) file.put_in_place();
}

void write_file_atomically(const std::string& path, std::string_view bytes) { write_files_atomically({{path, bytes}}); }

void try_folder(const std::string& path) {
    const std::string there = existing_part(path);
    if (!std::filesystem::is_directory(there)) fail(path, ENOTDIR);
    if (::access(there.c_str(), W_OK | X_OK) != 0) fail(path, errno);
}

bool make_folder(const std::string& path) {
    std::error_code error;
    const bool made = std::filesystem::create_directories(path, error);
    if (error) throw FileError(path + ": " + tr(error.message()));
    return made;
}

}  // namespace twinlight
