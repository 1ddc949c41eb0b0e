// Clip: records the window's pictures as PNG files, 30 for each second, and as a video where ffmpeg is installed.
#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "base/image/image.h"

namespace twinlight::session {

class Clip {
  public:
    static constexpr int kFramesPerSecond = 30;

    // Makes the folder. Throws FileError.
    explicit Clip(std::string folder);
    ~Clip();
    Clip(const Clip&) = delete;
    Clip& operator=(const Clip&) = delete;

    // The picture that the window shows from this time on, in seconds since the start. It is shown until the next one. Pictures
    // that come faster than they can be written are left out.
    void add(double seconds, Image picture);
    // Shows the last picture until this time, then writes the video. The work goes on in a thread, or is done at once if the system
    // gives none.
    void end(double seconds);
    bool is_ending() const;
    // What was written, when everything is: one sentence. Empty before.
    std::string result() const;
    int frames() const;
    const std::string& folder() const { return folder_; }

  private:
    struct Shown {
        double seconds = 0;
        Image picture;  // empty at the end
    };
    void run();
    bool write_next();
    std::string written(const Shown& shown);
    void write_frames(int until);
    std::string write_video() const;

    std::string folder_;
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Shown> waiting_;
    bool is_ending_ = false, is_abandoned_ = false;
    int frames_ = 0;
    std::string png_;  // the picture that is shown
    std::string result_;
    std::thread thread_;  // the last member: it uses the others
};

// The rectangle of a picture with this upper left corner; at least one pixel, and only what lies inside.
Image part_of(const Image& picture, int x, int y, int width, int height);

// The number of frames of a clip that are to be written before the one that starts at this time.
int frames_before(double seconds);

}  // namespace twinlight::session
