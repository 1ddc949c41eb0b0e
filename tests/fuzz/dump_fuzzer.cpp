// What apitrace dumps: any text is a recording, up to the call at which one clear line says what is wrong.
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "base/image/file.h"
#include "scene/trace/dump_calls.h"
#include "scene/trace/temporary_folder.h"
#include "scene/trace/trace.h"
#include "visit_steps.h"

using namespace twinlight;
using namespace twinlight::trace;

namespace {

// In pieces, as a pipe gives them.
class TextSource final : public ByteSource {
  public:
    explicit TextSource(std::string_view text) : rest_(text) {}
    std::size_t read(char* to, std::size_t size) override {
        constexpr std::size_t kPiece = 61;
        const std::size_t count = std::min({size, rest_.size(), kPiece});
        std::memcpy(to, rest_.data(), count);
        rest_.remove_prefix(count);
        return count;
    }

  private:
    std::string_view rest_;
};

// A folder with a blob of some size, and one of nothing.
const std::string& blobs() {
    static const TemporaryFolder folder;
    static const std::string path = [] {
        write_file_atomically(folder.path() + "/a.bin", std::string(96, '\x3f'));
        write_file_atomically(folder.path() + "/b.bin", "");
        return folder.path();
    }();
    return path;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    is_trace(text);
    is_dump(text);
    visit_steps([text] { return std::make_unique<DumpCalls>(std::make_unique<TextSource>(text), "fuzz"); },
                blobs_in_folder(blobs()), size % 2 == 0);
    return 0;
}
