// Pictures that Chromium draws without a GPU, with SwiftShader, against the reference.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <optional>
#include <string>

#include "../unit/pictures.h"
#include "base/image/difference.h"
#include "base/image/png.h"
#include "browser.h"
#include "judge/compare/allowances.h"
#include "render/reference/reference.h"
#include "scene/scenes/load.h"
#include "scene/state/state.h"

namespace twinlight {

// The picture of a canvas's toDataURL(), opaque.
inline Image picture_of_url(const std::string& url, int width, int height) {
    const PngPixels png = decode_png_pixels(from_base64(url.substr(url.find(',') + 1)), 10'000);
    Image image(width, height, {0, 0, 0, 1});
    EXPECT_EQ(png.rgba.size(), 4 * image.pixels.size());
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) image.pixels[i][c] = static_cast<float>(png.rgba.at(4 * i + c)) / 255;
    return image;
}

// The browser draws with another driver (SwiftShader), which interpolates with other arithmetic than the reference: away
// from edges a channel may round to the neighbouring code, as anywhere, but in more pixels than on llvmpipe: up to 0.8 %
// in these scenes.
inline void expect_close(const std::string& scene, const Image& picture, std::optional<Shading> shading,
                         const std::string& step = {}) {
    const Frame frame = make_frame(*load_commands(scene, step), {});
    reference::Options options{{.shading = shading}};
    const Image exact = reference::render(frame, options);
    // As on the page for browsers (page_scene.cpp), edges are not checked.
    options.border += 0.5;
    AllowedDifference allowed = reference::allowed_difference(frame, options);
    allowed.ranges.clear();
    compare::allow_ties(allowed, exact);
    Image opaque = quantised(exact);
    for (Rgba& pixel : opaque.pixels) pixel[3] = 1;
    const ImageDifference found = difference(picture, opaque, allowed);
    const RegionDifference& interior = found.beyond_allowed;
    constexpr double kRoundingOf8Bits = 1.001 / 255, kShare = 0.01;
    EXPECT_LE(interior.max, kRoundingOf8Bits) << "at " << interior.worst_x << "," << interior.worst_y;
    EXPECT_LE(interior.differing_share(), kShare);
}

}  // namespace twinlight
