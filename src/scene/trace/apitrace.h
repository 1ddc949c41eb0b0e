// Runs the program apitrace to dump a trace.
#pragma once

#include <sys/types.h>

#include <string>

#include "base/image/descriptor.h"
#include "scene/trace/blobs.h"
#include "scene/trace/temporary_folder.h"

namespace twinlight::trace {

class ApitraceDump {
  public:
    // Starts `apitrace dump --blobs` on the file `trace`, or on `input` if that is valid. `name` appears in messages.
    // Throws SceneError if apitrace is not installed.
    ApitraceDump(const std::string& name, const std::string& trace, const Descriptor& input, Blobs blobs);
    ~ApitraceDump();  // stops the process
    ApitraceDump(const ApitraceDump&) = delete;
    ApitraceDump& operator=(const ApitraceDump&) = delete;

    // The folder into which apitrace writes the blobs.
    const std::string& folder() const { return folder_.path(); }
    Descriptor take_output() { return std::move(output_); }
    // Waits for the process; call it at the end of the output. Returns apitrace's error message, or "" if it succeeded.
    std::string wait();

  private:
    TemporaryFolder folder_;
    Descriptor messages_;  // what apitrace writes to standard error
    pid_t process_ = 0;
    Descriptor output_;
};

}  // namespace twinlight::trace
