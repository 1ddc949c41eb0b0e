#include "scene/frame/picture_memory.h"

namespace twinlight {

namespace {

// Measured: up to 74 bytes more for an accumulation buffer (compare), 33 for the pictures that pixels are copied from, and 70 for each
// pixel of a framebuffer object's picture. These are drawn one after the other.
constexpr std::uint64_t kAccumulation = 80, kCopies = 40, kObject = 80;

}  // namespace

std::uint64_t pixels_of(int width, int height) {
    return static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
}

std::uint64_t bytes_of_pictures(const Frame& frame, std::size_t bytes_of_pixel) {
    if (bytes_of_pixel == 0) return 0;
    std::uint64_t each = bytes_of_pixel;
    if (accumulates(frame)) each += kAccumulation;
    if (frame.copies_pixels) each += kCopies;
    return pixels_of(frame.width, frame.height) * each;
}

std::uint64_t bytes_of_scene(const Frame& frame) { return frame.bytes + frame.object_pixels * kObject; }

}  // namespace twinlight
