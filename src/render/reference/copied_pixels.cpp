#include "render/reference/copied_pixels.h"

#include <algorithm>
#include <utility>

#include "render/reference/allowed_difference.h"
#include "render/reference/framebuffer.h"
#include "render/reference/pictures.h"

namespace twinlight::reference {

namespace {

CopySource source_with_range(const Frame& frame, Options options, const CopyRanges& ranges) {
    constexpr float kRounding =
        0.05F / 255;  // how near a colour must be to halfway between two 8-bit values, that either may be copied
    CopySource source;
    options.quad_cut = QuadCut::kSecondToFourth;
    const Image other_cut = render(frame, options);
    options.quad_cut = QuadCut::kFirstToThird;
    source.picture = render(frame, options);
    const AllowedDifference allowed = Pictures(frame, ranges).allowed_difference(options);
    source.low = source.high = source.picture;
    for (std::size_t i = 0; i < source.picture.pixels.size(); ++i) {
        const Rgba channels = allowed.channels(i);
        const bool is_known = allowed.is_judged(i) && !allowed.is_undefined(i);
        for (std::size_t c = 0; c < 4; ++c) {
            const auto [least, most] = std::minmax({source.picture.pixels[i][c], other_cut.pixels[i][c]});
            const float around = channels[c] + kRounding;
            source.low.pixels[i][c] = is_known ? std::max(least - around, 0.0F) : 0;
            source.high.pixels[i][c] = is_known ? std::min(most + around, 1.0F) : 1;
            if (!allowed.edge[i] || !is_known) continue;
            for (const AllowedRange& range : allowed.ranges.at(i)) {
                source.low.pixels[i][c] = std::min(source.low.pixels[i][c], std::max(range.low[c] - kRounding, 0.0F));
                source.high.pixels[i][c] =
                    std::max(source.high.pixels[i][c], std::min(range.high[c] + kRounding, 1.0F));
            }
        }
    }
    return source;
}

CopySource values(const Frame& frame, const Options& options, CopiedBuffer buffer) {
    const auto draw = buffer == CopiedBuffer::kDepths ? draw_depths : draw_stencils;
    return {.picture = draw(run_stages(frame, options), options, frame.width, frame.height)};
}

CopySource values_with_range(const Frame& frame, Options options, CopiedBuffer buffer, const CopyRanges& ranges) {
    CopySource source = values(frame, options, buffer);
    options.in_clip_plane = InClipPlane::kPerhaps;
    const auto range = [&](QuadCut cut) {
        options.quad_cut = cut;
        const auto find = buffer == CopiedBuffer::kDepths ? depth_bounds : stencil_bounds;
        return find(run_stages(frame, options, &ranges), options, frame.width, frame.height);
    };
    auto [low, high] = range(QuadCut::kFirstToThird);
    if (has_quadrilaterals(frame)) {
        const BufferBounds other = range(QuadCut::kSecondToFourth);
        for (std::size_t i = 0; i < low.pixels.size(); ++i)
            for (std::size_t c = 0; c < 3; ++c) {
                low.pixels[i][c] = std::min(low.pixels[i][c], other.low.pixels[i][c]);
                high.pixels[i][c] = std::max(high.pixels[i][c], other.high.pixels[i][c]);
            }
    }
    source.low = std::move(low);
    source.high = std::move(high);
    return source;
}

}  // namespace

DrawableFrame drawable(const Frame& frame, const Options& options) {
    return {frame, [&options](const Frame& picture, CopiedBuffer buffer, const Rectangle&) {
                return buffer == CopiedBuffer::kColors ? CopySource{.picture = render(picture, options)}
                                                       : values(picture, options, buffer);
            }};
}

DrawableFrame drawable_with_ranges(const Frame& frame, const Options& options, CopyRanges& ranges) {
    return {frame,
            [&](const Frame& picture, CopiedBuffer buffer, const Rectangle&) {
                return buffer == CopiedBuffer::kColors ? source_with_range(picture, options, ranges)
                                                       : values_with_range(picture, options, buffer, ranges);
            },
            &ranges};
}

}  // namespace twinlight::reference
