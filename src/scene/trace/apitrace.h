// The program apitrace, as a process that prints the dump of a trace.
#pragma once

#include <sys/types.h>

#include <string>

#include "base/image/descriptor.h"
#include "scene/trace/temporary_folder.h"

namespace twinlight::trace {

class ApitraceDump {
  public:
    // Starts `apitrace dump --blobs` on a .trace file, or on `input` where that is one. Throws SceneError where apitrace is
    // not installed. `name` is for messages.
    ApitraceDump(const std::string& name, const std::string& trace, const Descriptor& input);
    ~ApitraceDump();  // ends it
    ApitraceDump(const ApitraceDump&) = delete;
    ApitraceDump& operator=(const ApitraceDump&) = delete;

    // Where the blobs come.
    const std::string& folder() const { return folder_.path(); }
    Descriptor take_output() { return std::move(output_); }
    // To be called where the output has ended. What went wrong: apitrace's own words; empty if nothing did.
    std::string wait();

  private:
    TemporaryFolder folder_;
    Descriptor words_;  // what apitrace says
    pid_t process_ = 0;
    Descriptor output_;
};

}  // namespace twinlight::trace
