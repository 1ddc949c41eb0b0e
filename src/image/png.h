// Images as PNG: 8 bits a channel, red, green and blue.
//
// Alpha is left out: a renderer's alpha is data (the diffuse alpha, GL 2.1 section 2.14.1), not transparency,
// and a viewer would take it for that.
#pragma once

#include <string>
#include <string_view>

#include "image/image.h"

namespace twinlight {

std::string encode_png(const Image& image);

// Any PNG of 8 bits or fewer; alpha is 1 where the file has none. Throws std::runtime_error with the decoder's reason.
Image decode_png(std::string_view bytes);

void write_png(const std::string& path, const Image& image);  // atomically: see file.h
Image read_png(const std::string& path);

}  // namespace twinlight
