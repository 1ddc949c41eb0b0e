#include "app/session/recorded_program.h"

#include <fmt/format.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>

#include "app/session/language.h"
#include "base/image/file.h"
#include "base/text/translation.h"
#include "base/threads/async.h"
#include "scene/command/text.h"
#include "scene/record/compile.h"
#include "scene/record/record.h"
#include "scene/record/running.h"
#include "scene/recorded/recorded_frame.h"
#include "scene/scenes/load.h"
#include "scene/trace/process.h"

namespace twinlight::session {

namespace {

namespace fs = std::filesystem;

std::shared_ptr<const CommandList> busiest_frame_of(const std::shared_ptr<const Recording>& recording,
                                                    const std::string& file) {
    FrameChoice choice;
    if (fs::path(file).extension() == ".trace")
        if (const auto busiest = trace::busiest_frame(file)) choice.number = busiest->number;
    const RecordedFrame recorded = make_recorded_frame(recording, choice);
    const std::string& name = recorded.scene.name();
    return std::make_shared<CommandList>(read_text_of("", name, printed_frame(recorded, tr("{}.", name))));
}

// The program `twinlight` in this program's folder, or else in PATH.
std::string twinlight() {
    std::error_code ignored;
    const fs::path beside = fs::read_symlink("/proc/self/exe", ignored).parent_path() / "twinlight";
    return trace::is_executable(beside.string()) ? beside.string() : "twinlight";
}

}  // namespace

Opened load_openable(const std::string& name, const std::string& step) {
    const std::shared_ptr<const Recording> recording = load_recording(name, std::nullopt, step);
    if (!recording->command_list()) return {busiest_frame_of(recording, name)};
    std::error_code ignored;
    return {{recording, recording->command_list()},
            fs::is_regular_file(name, ignored) ? std::optional(name) : std::nullopt};
}

bool can_be_recorded(const std::string& file) {
    std::error_code ignored;
    return fs::is_regular_file(file, ignored) &&
           (trace::is_source(file) || trace::is_python(file) || trace::is_executable(file));
}

ProgramRecording::ProgramRecording(const std::string& program)
    : scene_(std::async(kThreadIfPossible, [this, program] { return record(program); })) {}

bool ProgramRecording::is_done() const {
    return scene_.wait_for(std::chrono::seconds(0)) != std::future_status::timeout;
}

std::shared_ptr<const CommandList> ProgramRecording::record(const std::string& program) const {
    const std::string file = folder_.path() + "/" + fs::path(program).stem().string() + ".trace";
    const Descriptor messages = trace::nameless_file();
    // A path, so that it is not searched for in PATH.
    const std::string path = fs::absolute(program).string();
    const pid_t process = trace::start({{twinlight(), "record", "--language",
                                         language() == lesson::Language::kChinese ? "zh" : "en", path, "-o", file},
                                        -1,
                                        messages.get(),
                                        messages.get(),
                                        ".",
                                        /*has_own_session=*/true});
    if (process <= 0) throw SceneError(fmt::format("twinlight record: {}", tr(std::strerror(errno))));
    trace::Running running(process);
    // Interrupted, it keeps what it has recorded.
    if (!running.wait([this] { return is_stopped_.load(); })) {
        ::kill(process, SIGINT);
        running.wait([] { return false; });
    }
    if (running.status() != 0) {
        // If it cannot be compiled, the last line says "see above".
        const std::string printed = trace::written_to(messages), error = trace::first_error(printed);
        throw SceneError((error.empty() ? "" : error + "\n") + trace::last_line(printed));
    }
    return busiest_frame_of(load_recording(file), file);
}

}  // namespace twinlight::session
