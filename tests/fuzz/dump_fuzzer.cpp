// What apitrace dumps: any text is a recording, up to the call at which one clear line says what is wrong.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "base/image/file.h"
#include "scene/command/text.h"
#include "scene/trace/contexts.h"
#include "scene/trace/dump_reader.h"
#include "scene/trace/temporary_folder.h"
#include "scene/trace/trace.h"

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
    ContextCounts counts;
    try {
        TextSource source(text);
        const bool whole = size % 2 == 0;
        DumpReader(source, "fuzz", blobs_in_folder(blobs())).count_contexts(whole, counts);
    } catch (const SceneError&) {  // reading throws it again
    }
    list_of_contexts(counts.contexts());
    const std::optional<std::size_t> busiest = counts.busiest();
    try {
        TextSource source(text);
        DumpReader reader(source, "fuzz", blobs_in_folder(blobs()));
        if (busiest) {
            const ContextUse& use = counts.contexts()[*busiest];
            reader.follow(use.name, use.shown_objects());
        }
        reader.for_each([](const Step& step) {
            if (step.kind == Step::Kind::kCommand) print_command(step.command);
            return true;
        });
    } catch (const SceneError& error) {
        if (std::strchr(error.what(), '\n')) std::abort();
    }
    return 0;
}
