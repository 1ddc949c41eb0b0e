// A folder for what exists only while the program runs.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <string>

namespace twinlight::trace {

// A new, empty folder in TMPDIR, or /tmp. It goes, with the files in it, when this goes, and when a signal ends the
// program (SIGINT, SIGTERM, SIGHUP).
class TemporaryFolder {
  public:
    TemporaryFolder();  // throws SceneError
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::string& path() const { return path_; }
    // The process that writes into the folder, 0 for none: it is ended before the folder goes.
    void set_writer(pid_t process);

  private:
    std::string path_;
    std::size_t slot_ = 0;  // among those that the handler of signals knows
};

}  // namespace twinlight::trace
