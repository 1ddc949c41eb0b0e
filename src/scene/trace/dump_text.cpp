#include "scene/trace/dump_text.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "base/text/translation.h"
#include "scene/command/text.h"

namespace twinlight::trace {

void DumpText::refuse(int error) const { throw SceneError(fmt::format("{}: {}", name_, tr(std::strerror(error)))); }

std::size_t DumpText::read_at(std::uint64_t offset, char* to, std::size_t size) {
    const bool in_file = !pipe_.valid() || offset < kept_;
    if (in_file) {
        while (true) {
            const ssize_t count = ::pread(file_.get(), to, size, static_cast<off_t>(offset));
            if (count >= 0) return static_cast<std::size_t>(count);
            if (errno != EINTR) refuse(errno);
        }
    }
    ssize_t count = 0;
    do {
        count = ::read(pipe_.get(), to, size);
    } while (count < 0 && errno == EINTR);
    if (count < 0) refuse(errno);
    if (count == 0) {
        pipe_.close();
        if (ended_) std::exchange(ended_, nullptr)();
        return 0;
    }
    keep({to, static_cast<std::size_t>(count)});
    return static_cast<std::size_t>(count);
}

void DumpText::keep(std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::pwrite(file_.get(), bytes.data(), bytes.size(), static_cast<off_t>(kept_));
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) {
            throw SceneError(
                tr("{}: cannot store the recording in a temporary file: {}; set TMPDIR to a folder with more "
                   "space",
                   name_, tr(std::strerror(errno))));
        }
        bytes.remove_prefix(static_cast<std::size_t>(written));
        kept_ += static_cast<std::uint64_t>(written);
    }
}

}  // namespace twinlight::trace
