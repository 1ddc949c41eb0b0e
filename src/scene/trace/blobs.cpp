#include "scene/trace/blobs.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "base/image/descriptor.h"
#include "base/text/translation.h"
#include "scene/command/lexer.h"

namespace twinlight::trace {

std::shared_ptr<Memory> BlobBudget::allocate(std::size_t size) const {
    const std::shared_ptr<Memory> memory(new Memory, [held = held_, size](const Memory* gone) {
        *held -= size;
        delete gone;
    });
    *held_ += size;
    memory->bytes.resize(size);
    return memory;
}

namespace {

class BlobFolder {
  public:
    BlobFolder(std::string path, std::size_t most_held) : path_(std::move(path)), budget_(most_held) {}

    std::shared_ptr<const Memory> operator()(const std::string& name, const Place& place) const;

  private:
    std::string path_;
    BlobBudget budget_;
};

std::shared_ptr<const Memory> BlobFolder::operator()(const std::string& name, const Place& place) const {
    if (name.empty() || name.starts_with('.') || name.find('/') != std::string::npos ||
        name.find('\0') != std::string::npos)
        fail(place, "the blob {} is not a plain file name; blobs must be in the folder of the dump", in_quotes(name));
    const auto refuse = [&](const std::string& why) {
        fail(place, "cannot read the blob {}: {}; 'apitrace dump --blobs' writes blobs next to the dump",
             in_quotes(name), why);
    };
    // Does not follow links, which could lead anywhere, and does not wait for the other end of a pipe.
    const Descriptor file(::open((path_ + "/" + name).c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
    if (!file.valid()) refuse(tr(errno == ELOOP ? "it is a link" : std::strerror(errno)));
    struct stat status {};
    if (::fstat(file.get(), &status) != 0) refuse(tr(std::strerror(errno)));
    if (!S_ISREG(status.st_mode)) refuse(tr("it is not a regular file"));
    const auto size = static_cast<std::size_t>(status.st_size);
    if (size > kMaxBlobBytes)
        fail(place, "the blob {} has {} bytes; the limit is {}", in_quotes(name), size, kMaxBlobBytes);
    if (!budget_.allows(size)) {
        fail(place, "the blob {} has {} bytes; with {} bytes of other blobs in use this is above the limit of {}",
             in_quotes(name), size, budget_.held(), budget_.most());
    }
    const std::shared_ptr<Memory> memory = budget_.allocate(size);
    std::size_t filled = 0;
    while (filled < size) {
        const ssize_t count = ::read(file.get(), memory->bytes.data() + filled, size - filled);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) refuse(tr(std::strerror(errno)));
        if (count == 0) break;
        filled += static_cast<std::size_t>(count);
    }
    memory->bytes.resize(filled);
    return memory;
}

}  // namespace

BlobLoader blobs_in_folder(std::string path, std::size_t most_held) { return BlobFolder(std::move(path), most_held); }

std::shared_ptr<const Memory> blobs_too_large(const std::string& name, const Place& place) {
    fail(place, "a blob {} is too large; the limit is {}, and {} for all that are in use", name, kMaxBlobBytes,
         kMaxHeldBlobBytes);
}

BlobLoader blobs_in_memory(BlobFiles files) {
    return [files = std::move(files)](const std::string& name, const Place& place) {
        const auto found = files.find(name);
        if (found == files.end())
            fail(place, "the blob {} is missing; give the dump and all its blobs together", in_quotes(name));
        return found->second;
    };
}

}  // namespace twinlight::trace
