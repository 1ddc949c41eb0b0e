#include "app/web/dropped_files.h"

#include <fmt/format.h>

#include <cstring>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/web/page_scene.h"
#include "base/image/contrast.h"
#include "base/text/json.h"
#include "render/reference/reference.h"
#include "scene/command/text.h"
#include "scene/frame/resized.h"
#include "scene/recorded/recorded_frame.h"
#include "scene/trace/trace.h"

namespace twinlight::web {

namespace {

float contrast(const Scene& scene) {
    const Frame& frame = scene.frame;
    return color_contrast(reference::render(
        resized(frame, PageScene::coarse_side(frame.width), PageScene::coarse_side(frame.height)), {}));
}

std::shared_ptr<const Recording> recording_in(std::string_view bytes, const std::string& name,
                                              const trace::BlobFiles& files) {
    if (!trace::is_trace(bytes.substr(0, trace::kFrontBytes), name)) return trace::read_dump(bytes, name, files);
    if (auto recording = trace::read_trace(bytes, name)) return recording;
    throw SceneError(fmt::format(
        "{0}: this page reads the files that apitrace 5 to 13 records; this one is of another version, or of "
        "'apitrace repack'. Write its text with 'apitrace dump --color=never --blobs {0} >dump.txt', and "
        "drop dump.txt together with the blobs that this writes",
        one_line(name)));
}

}  // namespace

bool is_recording(std::string_view front, const std::string& name) {
    return trace::is_trace(front, name) || trace::is_dump(front);
}

void DroppedFiles::add(const std::string& name, std::span<const std::uint8_t> bytes) {
    Memory memory;
    memory.bytes.resize(bytes.size());
    if (!bytes.empty()) std::memcpy(memory.bytes.data(), bytes.data(), bytes.size());
    files_[name] = std::make_shared<const Memory>(std::move(memory));
}

std::string DroppedFiles::scene_of_recording(const std::string& name) {
    const trace::BlobFiles files = std::exchange(files_, {});
    const std::vector<std::byte>& file = files.at(name)->bytes;
    const std::string_view bytes(reinterpret_cast<const char*>(file.data()), file.size());  // NOLINT
    const RecordedFrame recorded =
        frame_to_see(recording_in(bytes, name, files), {.number = std::nullopt, .memory = kPageMemory}, contrast);
    const Frame& frame = recorded.scene.frame;
    const std::string scene = printed_frame(
        recorded, fmt::format("{}: {} x {} pixels. The program twinlight can draw other frames (--frame).",
                              recorded.scene.name(), frame.width, frame.height));
    if (scene.size() > kMaxPageBytes)
        throw SceneError(fmt::format(
            "{}: as a scene, this is {} MiB long, and the limit of this page is {} MiB. The program twinlight can "
            "draw it: 'twinlight compare {}'. If an earlier frame is enough, write it with 'twinlight export {} "
            "--as scene --frame N', and drop that",
            recorded.scene.name(), scene.size() >> 20, kMaxPageBytes >> 20, one_line(name), one_line(name)));
    return dumped({{"text", scene}, {"width", frame.width}, {"height", frame.height}});
}

}  // namespace twinlight::web
