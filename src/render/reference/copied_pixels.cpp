#include "render/reference/copied_pixels.h"

#include <algorithm>

#include "render/reference/pictures.h"

namespace twinlight::reference {

namespace {

CopySource source_with_range(const Frame& frame, Options options) {
    constexpr float kRounding = 0.05F / 255;  // how near a colour must be to halfway between two 8-bit values, that either may be copied
    CopySource source;
    options.quad_cut = QuadCut::kSecondToFourth;
    const Image other_cut = render(frame, options);
    options.quad_cut = QuadCut::kFirstToThird;
    source.picture = render(frame, options);
    const AllowedDifference allowed = allowed_difference(frame, options);
    source.low = source.high = source.picture;
    for (std::size_t i = 0; i < source.picture.pixels.size(); ++i)
        for (std::size_t c = 0; c < 4; ++c) {
            const auto [least, most] = std::minmax({source.picture.pixels[i][c], other_cut.pixels[i][c]});
            const float around = allowed.channels.pixels[i][c] + kRounding;
            source.low.pixels[i][c] = allowed.edge[i] ? 0 : std::max(least - around, 0.0F);
            source.high.pixels[i][c] = allowed.edge[i] ? 1 : std::min(most + around, 1.0F);
        }
    return source;
}

}  // namespace

DrawableFrame drawable(const Frame& frame, const Options& options) {
    return {frame, [&options](const Frame& picture) { return CopySource{.picture = render(picture, options)}; }};
}

DrawableFrame drawable_with_ranges(const Frame& frame, const Options& options) {
    return {frame, [&options](const Frame& picture) { return source_with_range(picture, options); }};
}

}  // namespace twinlight::reference
