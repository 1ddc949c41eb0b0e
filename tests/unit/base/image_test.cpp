// Images: rounding to 8 bits, PNG, files, differences.
#include "base/image/image.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <filesystem>
#include <limits>

#include "../pictures.h"
#include "base/image/difference.h"
#include "base/image/file.h"
#include "base/image/png.h"

namespace twinlight::image_test {
namespace {

namespace fs = std::filesystem;

class FileTest : public testing::Test {
  protected:
    FileTest() {
        std::string pattern = (fs::temp_directory_path() / "twinlight-file-XXXXXX").string();
        folder_ = ::mkdtemp(pattern.data());
    }
    ~FileTest() override { fs::remove_all(folder_); }

    std::string path(const std::string& name) const { return (folder_ / name).string(); }
    std::ptrdiff_t files() const { return std::distance(fs::directory_iterator(folder_), fs::directory_iterator()); }

    fs::path folder_;
};

std::string message_of(const auto& act) {
    try {
        act();
    } catch (const std::exception& error) {
        return error.what();
    }
    return "(nothing was thrown)";
}

// ---- Rounding to 8 bits ----

TEST(Quantisation, ClampsAndRoundsToTheNearestCode) {
    EXPECT_EQ(channel_code(-1), 0);
    EXPECT_EQ(channel_code(2), 255);
    EXPECT_EQ(channel_code(std::numeric_limits<float>::infinity()), 255);
    EXPECT_EQ(channel_code(std::nanf("")), 0);
    EXPECT_EQ(channel_code(0.49F / 255), 0);
    EXPECT_EQ(channel_code(0.51F / 255), 1);
    EXPECT_EQ(channel_code(0.5F), 128);  // 127.5 rounds away from zero
}

TEST(Quantisation, KeepsEveryCode) {
    for (int code = 0; code < 256; ++code) EXPECT_EQ(channel_code(static_cast<float>(code) / 255.0F), code);
}

// Floats on both sides of each border between codes, and near 0, where adding half a code loses digits of a float.
TEST(Quantisation, RoundsNoFloatOtherwiseThanTheNearestCodeIs) {
    const auto expect_nearest = [](float channel) {
        EXPECT_EQ(channel_code(channel), std::lround(static_cast<double>(channel) * 255)) << channel;
    };
    for (int code = 0; code < 255; ++code) {
        float channel = static_cast<float>((code + 0.5) / 255);
        for (int i = 0; i < 8; ++i) channel = std::nextafter(channel, 0.0F);
        for (int i = 0; i < 16; ++i) expect_nearest(channel = std::nextafter(channel, 1.0F));
    }
    for (float channel = 1; channel > 0; channel /= 2) {
        expect_nearest(channel);
        expect_nearest(std::nextafter(channel, 0.0F));
    }
}

TEST(Quantisation, IsIdempotent) {
    Image image(256, 1);
    for (int x = 0; x < 256; ++x) image.at(x, 0) = {x * 0.0039F, x * 0.01F - 1, 0.3F, x / 255.0F};
    const Image once = quantised(image);
    EXPECT_EQ(quantised(once).pixels, once.pixels);
}

// ---- PNG ----

TEST(Png, GivesBackWhatEightBitsHold) {
    Image image(5, 3);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const auto value = static_cast<float>(i) / 20.0F;
        image.pixels[i] = {value, 1 - value, value * value, 1};
    }
    const Image back = decode_png(encode_png(image));
    ASSERT_EQ(back.width, 5);
    ASSERT_EQ(back.height, 3);
    EXPECT_EQ(back.pixels, quantised(image).pixels);
}

TEST(Png, HoldsNoAlpha) {
    const Image back = decode_png(encode_png(Image(1, 1, {1, 0, 0, 0.25F})));
    EXPECT_EQ(back.pixels[0], (Rgba{1, 0, 0, 1}));
}

TEST(Png, SaysThatRubbishCannotBeRead) {
    EXPECT_EQ(message_of([] { decode_png("not a picture"); }), "this is not a PNG; convert it to one");
    EXPECT_ANY_THROW(decode_png(""));
    const std::string whole = encode_png(Image(8, 8));
    EXPECT_ANY_THROW(decode_png(std::string_view(whole).substr(0, whole.size() / 2)));
}

// stb quotes the name of an unknown chunk in its message (found by make fuzz).
TEST(Png, SaysInOneLineWhatItHoldsBesides) {
    constexpr std::size_t kSignatureAndHeader = 8 + 25;
    std::string png = encode_png(Image(8, 8));
    png.insert(kSignatureAndHeader, std::string("\0\0\0\0G\r\n\x1b\0\0\0\0", 12));
    for (const std::string& message :
         {message_of([&] { decode_png(png); }), message_of([&] { decode_png_pixels(png, 8); })})
        EXPECT_TRUE(message.starts_with("the PNG cannot be read: G??? PNG chunk not known")) << message;
}

// ---- Files ----

TEST_F(FileTest, IsWrittenWholeAndReadBack) {
    const std::string bytes("a\0b\nc", 5);
    write_file_atomically(path("f"), bytes);
    EXPECT_EQ(read_file(path("f")), bytes);
    write_file_atomically(path("f"), "shorter");
    EXPECT_EQ(read_file(path("f")), "shorter");
    EXPECT_EQ(read_file(path("f"), 3), "sho");
    EXPECT_EQ(files(), 1);
}

TEST_F(FileTest, SaysPathAndReason) {
    EXPECT_EQ(message_of([&] { read_file(path("none")); }), path("none") + ": No such file or directory");
    EXPECT_EQ(message_of([&] { write_file_atomically(path("none/f"), "x"); }),
              path("none/f") + ": No such file or directory");
    EXPECT_EQ(message_of([&] { write_file_atomically(folder_.string(), "x"); }), folder_.string() + ": Is a directory");
    write_file_atomically(path("f"), "x");
    EXPECT_EQ(message_of([&] { write_file_atomically(path("f/g"), "x"); }), path("f/g") + ": Not a directory");
    EXPECT_EQ(files(), 1);
}

TEST_F(FileTest, OnAFullDiskIsAnError) {
    EXPECT_EQ(message_of([] { write_file_atomically("/dev/full", "x"); }), "/dev/full: No space left on device");
}

TEST_F(FileTest, LeavesDevicesWhatTheyAre) {
    write_file_atomically("/dev/null", "x");
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(FileTest, FollowsALinkAndKeepsTheMode) {
    write_file_atomically(path("f"), "x");
    ::chmod(path("f").c_str(), 0640);
    fs::create_symlink("f", path("link"));
    write_file_atomically(path("link"), "y");
    EXPECT_TRUE(fs::is_symlink(path("link")));
    EXPECT_EQ(read_file(path("f")), "y");
    EXPECT_EQ(static_cast<unsigned>(fs::status(path("f")).permissions()), 0640U);
}

// ---- Differences ----

TEST(Difference, OfEqualPicturesIsZero) {
    const Image image(4, 2, {0.1F, 0.2F, 0.3F, 1});
    const ImageDifference d = difference(image, image, PixelMask(8, false));
    EXPECT_EQ(d.interior.pixels, 8U);
    EXPECT_EQ(d.interior.differing, 0U);
    EXPECT_EQ(d.interior.max, 0);
    EXPECT_EQ(d.interior.rms, 0);
    EXPECT_EQ(d.edge.pixels, 0U);
}

TEST(Difference, CountsInteriorAndEdgeApart) {
    // 3 x 2 pixels; the right column is edge. Interior: one channel of (1,1) differs by 51 codes. Edge: all channels of
    // (2,0) differ by 255.
    Image a(3, 2), b(3, 2);
    b.at(1, 1) = {0, 0.2F, 0, 0};
    b.at(2, 0) = {1, 1, 1, 1};
    const PixelMask edge = {false, false, true, false, false, true};
    const ImageDifference d = difference(a, b, edge);
    EXPECT_EQ(d.interior.pixels, 4U);
    EXPECT_EQ(d.interior.differing, 1U);
    EXPECT_EQ(d.interior.max, 51 / 255.0);
    EXPECT_DOUBLE_EQ(d.interior.rms, std::sqrt(51.0 * 51.0 / 16) / 255);  // 4 pixels of 4 channels
    EXPECT_EQ(d.interior.worst_x, 1);
    EXPECT_EQ(d.interior.worst_y, 1);
    EXPECT_EQ(d.edge.pixels, 2U);
    EXPECT_EQ(d.edge.differing, 1U);
    EXPECT_EQ(d.edge.max, 1);
    EXPECT_DOUBLE_EQ(d.edge.rms, std::sqrt(0.5));
    EXPECT_EQ(d.edge.worst_x, 2);
    EXPECT_EQ(d.edge.worst_y, 0);
    EXPECT_EQ(d.edge.differing_share(), 0.5);
}

TEST(Difference, BelowHalfACodeDoesNotCount) {
    const Image a(1, 1, {0, 0, 0, 0});
    const Image b(1, 1, {0.4F / 255, 0, 0, 0});
    EXPECT_EQ(difference(a, b, PixelMask(1)).interior.differing, 0U);
}

TEST(Difference, OfAlphaCounts) {
    const Image a(1, 1, {0, 0, 0, 0});
    const Image b(1, 1, {0, 0, 0, 1});
    EXPECT_EQ(difference(a, b, PixelMask(1)).interior.max, 1);
    EXPECT_EQ(difference_picture(a, b, 1).pixels[0], (Rgba{1, 1, 1, 1}));
}

TEST(Difference, NeedsOneSize) {
    EXPECT_THROW(difference(Image(1, 2), Image(2, 1), PixelMask(2)), std::invalid_argument);
    EXPECT_THROW(difference(Image(1, 2), Image(1, 2), PixelMask(1)), std::invalid_argument);
}

TEST(Amplification, IsThePowerOfTwoThatKeepsTheLargestVisible) {
    EXPECT_EQ(amplification_for(0), 64);
    EXPECT_EQ(amplification_for(1 / 255.0), 64);
    EXPECT_EQ(amplification_for(4 / 255.0), 32);  // 64 * 4 = 256 of 255
    EXPECT_EQ(amplification_for(0.5), 2);
    EXPECT_EQ(amplification_for(0.6), 1);
    EXPECT_EQ(amplification_for(1), 1);
}

TEST(DifferencePicture, IsGreyWhereEqualAndBrightensWithTheDifference) {
    Image a(3, 1, {0, 0, 0, 1}), b = a;
    b.at(1, 0)[0] = 51 / 255.0F;
    b.at(2, 0)[0] = 1;
    const Image picture = difference_picture(a, b, 2);
    EXPECT_EQ(picture.at(0, 0), (Rgba{kZeroGrey, kZeroGrey, kZeroGrey, 1}));
    EXPECT_FLOAT_EQ(picture.at(1, 0)[0], kZeroGrey + (1 - kZeroGrey) * 0.4F);
    EXPECT_EQ(picture.at(1, 0)[1], kZeroGrey);
    EXPECT_EQ(picture.at(2, 0)[0], 1);
}

// A difference of 10 codes where 12 are allowed is correct; a difference of 6 where none is allowed is not.
TEST(Difference, TakesTheNearerOfTwoRightAnswersBeyondTheAllowedDifference) {
    const Image seen(1, 1, {0, 0, 0, 0}), allowed(1, 1, {0, 0, 0, 12 / 255.0F});
    const Image within(1, 1, {0, 0, 0, 10 / 255.0F}), beyond(1, 1, {6 / 255.0F, 0, 0, 0});
    EXPECT_EQ(nearer_of(seen, within, beyond).pixels, beyond.pixels);
    EXPECT_EQ(nearer_of(seen, within, beyond, allowed).pixels, within.pixels);
    EXPECT_EQ(nearer_of(seen, beyond, within, allowed).pixels, within.pixels);
    EXPECT_EQ(nearer_of(seen, within, within, allowed).pixels, within.pixels);
}

}  // namespace
}  // namespace twinlight::image_test
