#include "app/session/clip.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <utility>
#include <vector>

#include "base/image/file.h"
#include "base/image/png.h"
#include "base/text/reason.h"
#include "base/text/translation.h"
#include "base/threads/threads.h"

namespace twinlight::session {
namespace {

constexpr std::size_t kMostWaiting = 4;  // pictures of 16 bytes a pixel

// Runs a program without a shell and without output. Returns whether it was found and succeeded.
bool runs(std::vector<std::string> words) {
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    pid_t child = 0;
    const int error = posix_spawnp(&child, arguments[0], &files, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&files);
    if (error != 0) return false;
    int status = 0;
    return waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

Image part_of(const Image& picture, int x, int y, int width, int height) {
    x = std::clamp(x, 0, picture.width - 1);
    y = std::clamp(y, 0, picture.height - 1);
    Image part(std::clamp(width, 1, picture.width - x), std::clamp(height, 1, picture.height - y));
    for (int row = 0; row < part.height; ++row)
        for (int column = 0; column < part.width; ++column) part.at(column, row) = picture.at(x + column, y + row);
    return part;
}

int frames_before(double seconds) { return static_cast<int>(std::lround(seconds * Clip::kFramesPerSecond)); }

Clip::Clip(std::string folder) : folder_(std::move(folder)) {
    make_folder(folder_);
    thread_ = try_start_thread([this] { run(); });
}

Clip::~Clip() {
    {
        const std::lock_guard lock(mutex_);
        is_abandoned_ = true;
    }
    changed_.notify_all();
    if (thread_.joinable()) thread_.join();
}

void Clip::add(double seconds, Image picture) {
    {
        const std::lock_guard lock(mutex_);
        if (is_ending_ || waiting_.size() >= kMostWaiting) return;
        waiting_.push_back({seconds, std::move(picture)});
    }
    changed_.notify_all();
    if (!thread_.joinable()) write_next();
}

void Clip::end(double seconds) {
    {
        const std::lock_guard lock(mutex_);
        if (is_ending_) return;
        is_ending_ = true;
        waiting_.push_back({seconds, {}});
    }
    changed_.notify_all();
    if (!thread_.joinable()) write_next();
}

bool Clip::is_ending() const {
    const std::lock_guard lock(mutex_);
    return is_ending_;
}

std::string Clip::result() const {
    const std::lock_guard lock(mutex_);
    return result_;
}

int Clip::frames() const {
    const std::lock_guard lock(mutex_);
    return frames_;
}

void Clip::run() {
    while (write_next()) {
    }
}

// Waits for a picture and writes what comes before it. Returns whether more follows.
bool Clip::write_next() {
    Shown shown;
    {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return is_abandoned_ || !waiting_.empty(); });
        if (is_abandoned_) return false;
        shown = std::move(waiting_.front());
        waiting_.pop_front();
    }
    std::string result;
    try {
        result = written(shown);
    } catch (const std::exception& error) {
        result = reason_of(error);
    }
    if (result.empty()) return true;
    const std::lock_guard lock(mutex_);
    is_ending_ = true;
    result_ = std::move(result);
    return false;
}

// Returns what was written, if this is the end.
std::string Clip::written(const Shown& shown) {
    const bool is_end = shown.picture.pixels.empty();
    // A clip has at least one frame.
    if (!png_.empty()) write_frames(std::max(frames_before(shown.seconds), is_end ? 1 : 0));
    if (is_end) return write_video();
    png_ = encode_png(shown.picture);
    return "";
}

// The same picture for each frame up to this number.
void Clip::write_frames(int until) {
    for (int number = frames() + 1; number <= until; ++number) {
        {
            const std::lock_guard lock(mutex_);
            if (is_abandoned_) return;
        }
        write_file_atomically((std::filesystem::path(folder_) / fmt::format("frame-{:05}.png", number)).string(), png_);
        const std::lock_guard lock(mutex_);
        frames_ = number;
    }
}

std::string Clip::write_video() const {
    const int count = frames();
    const std::string frames_written = tr("{} frames, {:.1f} s", count, 1.0 * count / kFramesPerSecond);
    if (count == 0) return tr("no picture was recorded");
    const std::string video = folder_ + ".mp4";
    std::error_code ignored;
    if (std::filesystem::exists(video, ignored)) return tr("wrote {}/: {}", folder_, frames_written);
    // Players want an even width and height, and this format of colours.
    const bool made = runs({"ffmpeg", "-nostdin", "-loglevel", "error", "-framerate", std::to_string(kFramesPerSecond),
                            "-i", (std::filesystem::path(folder_) / "frame-%05d.png").string(), "-vf",
                            "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p", video});
    return made ? tr("wrote {} and {}/: {}", video, folder_, frames_written)
                : tr("wrote {}/: {}; no video, because ffmpeg is missing or failed", folder_, frames_written);
}

}  // namespace twinlight::session
