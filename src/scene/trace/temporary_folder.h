// What exists only while the program runs: a folder, and files without a name. They go however the program ends.
#pragma once

#include <sys/types.h>

#include <string>

#include "base/image/descriptor.h"

namespace twinlight::trace {

// A new, empty folder in TMPDIR, or /tmp. A process of its own, the keeper, removes it and the files in it when this goes,
// or when this program has ended, were it by SIGKILL.
class TemporaryFolder {
  public:
    TemporaryFolder();  // throws SceneError
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::string& path() const { return path_; }

  private:
    std::string path_;
    Descriptor needed_;  // a pipe's end: the keeper waits until no process has it any more
    pid_t keeper_ = 0;
};

// A new, empty file there that has no name any more. Throws SceneError.
Descriptor nameless_file();

}  // namespace twinlight::trace
