// Progress on standard error: a bar where that is a terminal, nothing otherwise.
#pragma once

#include <string_view>

namespace twinlight::cli {

class ProgressBar {
  public:
    ProgressBar();
    ~ProgressBar();  // wipes the bar away
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    void show(int done, int total, std::string_view next);
    void show(std::string_view doing);  // where there is no telling how much is left
    void wipe();

  private:
    bool terminal_;
};

}  // namespace twinlight::cli
