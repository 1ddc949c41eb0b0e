// The program apitrace, as a process that prints the dump of a trace.
#pragma once

#include <sys/types.h>

#include <string>

#include "scene/trace/descriptor.h"
#include "scene/trace/temporary_folder.h"

namespace twinlight::trace {

class ApitraceDump {
  public:
    // Starts `apitrace dump --blobs` on a .trace file; its blobs come into `folder`, which outlives this. Throws
    // SceneError where apitrace is not installed.
    ApitraceDump(const std::string& trace, TemporaryFolder& folder);
    ~ApitraceDump();  // ends it
    ApitraceDump(const ApitraceDump&) = delete;
    ApitraceDump& operator=(const ApitraceDump&) = delete;

    Descriptor take_output() { return std::move(output_); }
    // To be called where the output has ended. What went wrong: apitrace's own words; empty if nothing did.
    std::string wait();

  private:
    TemporaryFolder& folder_;
    pid_t process_ = 0;
    Descriptor output_;
};

}  // namespace twinlight::trace
