#include "app/cli/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace twinlight::cli {

namespace {
constexpr int kWidth = 60;  // of the line: blanks up to here cover what stood there before
constexpr int kBarWidth = 24;
}  // namespace

ProgressBar::ProgressBar() : terminal_(::isatty(STDERR_FILENO) != 0) {}

ProgressBar::~ProgressBar() { wipe(); }

void ProgressBar::wipe() {
    if (terminal_) fmt::print(stderr, "\r{:{}}\r", "", kWidth);
}

void ProgressBar::show(std::string_view doing) {
    if (!terminal_) return;
    fmt::print(stderr, "\r{:{}}", doing.substr(0, kWidth), kWidth);
    std::fflush(stderr);
}

void ProgressBar::show(int done, int total, std::string_view next) {
    if (!terminal_) return;
    const int filled = done * kBarWidth / total;
    const std::string line =
        fmt::format("[{:#<{}}{:.<{}}] {}/{} {}", "", filled, "", kBarWidth - filled, done, total, next);
    fmt::print(stderr, "\r{:{}}", line, kWidth);
    std::fflush(stderr);
}

}  // namespace twinlight::cli
