// The memory that the pictures of a Frame need. It is counted before any is drawn; State counts what the Frame itself needs.
#pragma once

#include <cstddef>
#include <cstdint>

#include "scene/frame/frame.h"

namespace twinlight {

std::uint64_t pixels_of(int width, int height);

// `bytes_of_pixel`: what is held for each pixel of the window at one time, all pictures, copies and buffers together, for a Frame
// without glAccum and copied pixels. 0: no picture is drawn, and none is needed.
std::uint64_t bytes_of_pictures(const Frame& frame, std::size_t bytes_of_pixel);
// What the Frame and the pictures of its framebuffer objects need, whatever the window's size is.
std::uint64_t bytes_of_scene(const Frame& frame);

}  // namespace twinlight
