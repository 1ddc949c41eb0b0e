#include "scene/trace/temporary_folder.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "base/text/translation.h"
#include "scene/command/text.h"
#include "scene/trace/process.h"

namespace twinlight::trace {

namespace {

std::string pattern() {
    const char* parent = std::getenv("TMPDIR");
    return std::string(parent && *parent ? parent : "/tmp") + "/twinlight-XXXXXX";
}

[[noreturn]] void refuse(const std::string& path, const char* what) {
    throw SceneError(tr("{}: cannot create a temporary {} here: {}; set TMPDIR to a folder where you can write", path,
                        what, tr(std::strerror(errno))));
}

// Tries again, because a program that still runs may create a file meanwhile.
constexpr const char* kKeeper =
    R"(PATH=/usr/bin:/bin; read -r _; for i in 1 2 3 4 5 6 7 8 9; do rm -rf "$0" && exit; sleep 1; done)";

}  // namespace

TemporaryFolder::TemporaryFolder() : path_(pattern()) {
    if (!::mkdtemp(path_.data())) refuse(path_, tr("folder"));
    std::array<int, 2> ends{-1, -1};
    const bool has_pipe = ::pipe2(ends.data(), O_CLOEXEC) == 0;
    const Descriptor waiting(ends[0]);
    needed_ = Descriptor(ends[1]);
    if (has_pipe) {
        keeper_ = start({{"/bin/sh", "-c", kKeeper, path_}, waiting.get(), -1, -1, "/", true});
    }
    if (keeper_ <= 0) {
        const int error = errno;
        ::rmdir(path_.c_str());
        errno = error;
        refuse(path_, tr("folder"));
    }
}

TemporaryFolder::~TemporaryFolder() {
    needed_.close();
    wait_for(keeper_);
}

Descriptor nameless_file() {
    std::string path = pattern();
    Descriptor file(::mkostemp(path.data(), O_CLOEXEC));
    if (!file.valid()) refuse(path, tr("file"));
    ::unlink(path.c_str());
    return file;
}

}  // namespace twinlight::trace
