// Progress on standard error: a bar if that is a terminal, nothing otherwise.
#pragma once

#include <chrono>
#include <optional>
#include <string_view>

namespace twinlight::cli {

class ProgressBar {
  public:
    ProgressBar();
    ~ProgressBar();  // wipes the bar
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    void show(int done, int total, std::string_view next, std::optional<double> seconds_left = std::nullopt);
    void show(std::string_view doing);  // for work of unknown length
    void wipe();

  private:
    void print(std::string_view line);

    bool terminal_;
    std::optional<std::chrono::steady_clock::time_point> printed_;
};

}  // namespace twinlight::cli
