// A temporary folder, and files without a name. They are removed however the program ends.
#pragma once

#include <sys/types.h>

#include <string>

#include "base/image/descriptor.h"

namespace twinlight::trace {

// A new, empty folder in TMPDIR or /tmp. A separate process, the keeper, removes it with its files when this object is
// destroyed or when this program ends, even by SIGKILL.
class TemporaryFolder {
  public:
    TemporaryFolder();  // throws SceneError
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::string& path() const { return path_; }

  private:
    std::string path_;
    Descriptor needed_;  // one end of a pipe; the keeper waits until no process has it open
    pid_t keeper_ = 0;
};

// A new, empty file in TMPDIR or /tmp whose name is already removed. Throws SceneError.
Descriptor nameless_file();

}  // namespace twinlight::trace
