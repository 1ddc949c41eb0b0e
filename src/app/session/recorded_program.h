// Programs that cannot be read as scenes: they run, and a picture of their recording becomes a scene.
#pragma once

#include <atomic>
#include <future>
#include <memory>
#include <optional>
#include <string>

#include "scene/command/command.h"
#include "scene/trace/temporary_folder.h"

namespace twinlight::session {

// What the window opens: a built-in scene, a file with a scene or a C program, or a recording, whose busiest frame is shown
// (trace::busiest_frame). `file` is what saving writes; a recording has none. Throws SceneError and FileError.
struct Opened {
    std::shared_ptr<const CommandList> scene;
    std::optional<std::string> file{};
};
Opened load_openable(const std::string& name, const std::string& step = {});

// Whether `twinlight record` can run it: a program, or its source in C, C++ or Python.
bool can_be_recorded(const std::string& file);

// `twinlight record`, the program beside this one, in a thread that begins here. Throws SceneError if there are no temporary files.
class ProgramRecording {
  public:
    explicit ProgramRecording(const std::string& program);
    ~ProgramRecording() { stop(); }
    ProgramRecording(const ProgramRecording&) = delete;
    ProgramRecording& operator=(const ProgramRecording&) = delete;

    // What the program has drawn until now is enough.
    void stop() { is_stopped_ = true; }
    bool is_done() const;
    // Waits for it. Throws SceneError with the reason if there is no picture.
    std::shared_ptr<const CommandList> scene() { return scene_.get(); }

  private:
    std::shared_ptr<const CommandList> record(const std::string& program) const;

    trace::TemporaryFolder folder_;
    std::atomic<bool> is_stopped_ = false;
    std::future<std::shared_ptr<const CommandList>> scene_;  // the last member: its thread uses the others
};

}  // namespace twinlight::session
