// A .trace: whatever its bytes are, it is a recording, up to the place where one clear line says what is wrong. Input that starts with
// "at" is the file; other input is what its chunks hold.
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>

#include "base/image/descriptor.h"
#include "scene/trace/temporary_folder.h"
#include "scene/trace/trace_calls.h"
#include "visit_steps.h"

using namespace twinlight;
using namespace twinlight::trace;

namespace {

// In chunks of some bytes, so that calls go on in the next one.
std::string file_of(std::string_view bytes) {
    constexpr std::size_t kPiece = 61;
    std::string file = "at";
    for (; !bytes.empty(); bytes.remove_prefix(std::min(kPiece, bytes.size())))
        file += chunk_of(bytes.substr(0, kPiece));
    return file;
}

void write_to(const Descriptor& file, const std::string& bytes) {
    if (::ftruncate(file.get(), 0) != 0 || ::pwrite(file.get(), bytes.data(), bytes.size(), 0) < 0) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const Descriptor file = nameless_file();
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    write_to(file, bytes.starts_with("at") ? std::string(bytes) : file_of(bytes));
    if (!TraceCalls::can_read(TraceFile(file.get()))) return 0;
    const auto start = [] { return std::make_unique<TraceCalls>(TraceFile(file.get()), "fuzz", Blobs::kAreRead); };
    visit_steps(start, blobs_too_large, size % 2 == 0);
    return 0;
}
