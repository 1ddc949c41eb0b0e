// The window's clips: one PNG for each thirtieth of a second, whenever the pictures came.
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <thread>

#include "../no_threads.h"
#include "../run_program.h"
#include "app/session/clip.h"
#include "base/image/file.h"
#include "base/image/png.h"

namespace twinlight::session::session_clip_test {
namespace {

Image filled(float gray) {
    Image image(4, 2);
    for (Rgba& pixel : image.pixels) pixel = {gray, gray, gray, 1};
    return image;
}

std::string finished(const Clip& clip) {
    std::string result;
    for (int i = 0; i < 1000 && result.empty(); ++i) {
        result = clip.result();
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return result;
}

int red_of(const std::string& file) { return decode_png_pixels(read_file(file), 100).rgba[0]; }

TEST(SessionClip, RepeatsAPictureUntilTheNextOne) {
    const TemporaryFolder folder;
    Clip clip(folder / "clip");
    clip.add(0, filled(0));
    clip.add(3.0 / 30, filled(1));  // after three frames
    clip.end(5.0 / 30);
    const std::string result = finished(clip);
    EXPECT_NE(result.find("5 frames, 0.2 s"), std::string::npos) << result;
    EXPECT_EQ(clip.frames(), 5);
    for (int i = 1; i <= 5; ++i)
        EXPECT_EQ(red_of(folder / ("clip/frame-0000" + std::to_string(i) + ".png")), i <= 3 ? 0 : 255) << i;
    EXPECT_FALSE(std::filesystem::exists(folder / "clip/frame-00006.png"));
}

TEST(SessionClip, ShowsOfPicturesInOneFrameTheLast) {
    const TemporaryFolder folder;
    Clip clip(folder / "clip");
    clip.add(0, filled(0));
    clip.add(0.001, filled(1));
    clip.end(0.002);
    finished(clip);
    EXPECT_EQ(clip.frames(), 1);  // a clip has at least one
    EXPECT_EQ(red_of(folder / "clip/frame-00001.png"), 255);
}

TEST(SessionClip, WithoutPicturesSaysSo) {
    const TemporaryFolder folder;
    Clip clip(folder / "clip");
    clip.end(1);
    EXPECT_EQ(finished(clip), "no picture was recorded");
}

TEST(SessionClip, SaysWhatCannotBeWritten) {
    const TemporaryFolder folder;
    write_file_atomically(folder / "clip", "a file");
    EXPECT_THROW(Clip(folder / "clip"), FileError);
    Clip clip(folder / "gone");
    std::filesystem::remove(folder / "gone");
    clip.add(0, filled(0));
    clip.end(1);
    EXPECT_NE(finished(clip).find("frame-00001.png"), std::string::npos);
}

TEST(SessionClip, IsWrittenAtOnceWithoutAThread) {
    const TemporaryFolder folder;
    const NoThreads none;
    Clip clip(folder / "clip");
    for (int i = 0; i < 9; ++i) clip.add(i / 30.0, filled(static_cast<float>(i % 2)));
    EXPECT_EQ(clip.frames(), 8);
    clip.end(9 / 30.0);
    EXPECT_NE(clip.result().find("9 frames, 0.3 s"), std::string::npos) << clip.result();
}

TEST(SessionClip, TakesPartOfAPicture) {
    Image image(3, 2);
    image.at(2, 1) = {1, 0, 0, 1};
    const Image part = part_of(image, 1, 1, 9, 9);
    EXPECT_EQ(part.width, 2);
    EXPECT_EQ(part.height, 1);
    EXPECT_EQ(part.at(1, 0)[0], 1);
    EXPECT_EQ(part_of(image, 0, 0, 0, 0).width, 1);
}

}  // namespace
}  // namespace twinlight::session::session_clip_test
