#include "app/cli/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <string>

#include "app/streams.h"
#include "scene/command/text.h"

namespace twinlight::cli {

namespace {
constexpr int kWidth = 79;  // each line is padded to this width, to overwrite the one before
constexpr int kBarWidth = 24;

std::string time_left(double seconds) {
    constexpr double kMinute = 60, kManySeconds = 100;
    if (seconds < kManySeconds) return fmt::format("{:.0f} s left", std::ceil(seconds));
    return fmt::format("{:.0f} min left", std::ceil(seconds / kMinute));
}
}  // namespace

ProgressBar::ProgressBar() : terminal_(::isatty(STDERR_FILENO) != 0) {}

ProgressBar::~ProgressBar() { wipe(); }

void ProgressBar::wipe() {
    if (terminal_) print_message("\r{:{}}\r", "", kWidth);
}

void ProgressBar::show(std::string_view doing) { print(doing); }

void ProgressBar::show(int done, int total, std::string_view next, std::optional<double> seconds_left) {
    const int filled = done * kBarWidth / total;
    const std::string left = seconds_left ? time_left(*seconds_left) + ", " : "";
    print(fmt::format("[{:#<{}}{:.<{}}] {}/{} {}{}", "", filled, "", kBarWidth - filled, done, total, left, next));
}

void ProgressBar::print(std::string_view line) {
    constexpr std::chrono::milliseconds kTooSoon(50);  // redrawing more often only costs time
    const auto now = std::chrono::steady_clock::now();
    if (!terminal_ || (printed_ && now - *printed_ < kTooSoon)) return;
    printed_ = now;
    print_message("\r{:{}}", one_line(line).substr(0, kWidth), kWidth);
}

}  // namespace twinlight::cli
