#include "picture_failure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "../unit/run_program.h"
#include "base/image/difference.h"
#include "base/image/png.h"

namespace twinlight {

testing::AssertionResult picture_failure(const std::string& name, const Image& actual, const Image& expected) {
    const std::string kept = build_folder() + "/failed";
    std::filesystem::create_directories(kept);
    write_png(fmt::format("{}/{}-actual.png", kept, name), actual);
    write_png(fmt::format("{}/{}-expected.png", kept, name), expected);
    auto failure = testing::AssertionFailure();
    if (actual.width != expected.width || actual.height != expected.height) {
        return failure << fmt::format("{}: the size is {} x {}, expected {} x {}", name, actual.width, actual.height,
                                      expected.width, expected.height);
    }
    const ImageDifference all = difference(actual, expected, PixelMask(actual.pixels.size()));
    write_png(fmt::format("{}/{}-difference.png", kept, name),
              difference_picture(actual, expected, amplification_for(all.interior.max)));

    struct Worst {
        std::size_t pixel;
        int codes;
    };
    std::vector<Worst> worst;
    for (std::size_t i = 0; i < actual.pixels.size(); ++i) {
        int codes = 0;
        for (std::size_t c = 0; c < 4; ++c) {
            codes = std::max(codes, std::abs(channel_code(actual.pixels[i][c]) - channel_code(expected.pixels[i][c])));
        }
        if (codes > 0) worst.push_back({i, codes});
    }
    constexpr std::size_t kShown = 10;
    const std::size_t shown = std::min(kShown, worst.size());
    std::partial_sort(worst.begin(), worst.begin() + static_cast<std::ptrdiff_t>(shown), worst.end(),
                      [](const Worst& a, const Worst& b) { return a.codes > b.codes; });
    failure << fmt::format("{}: {} of {} pixels differ; the pictures are {}/{}-*.png", name, all.interior.differing,
                           actual.pixels.size(), kept, name);
    for (std::size_t i = 0; i < shown; ++i) {
        const auto x = worst[i].pixel % static_cast<std::size_t>(actual.width);
        const auto y = worst[i].pixel / static_cast<std::size_t>(actual.width);
        const Rgba& a = actual.pixels[worst[i].pixel];
        const Rgba& e = expected.pixels[worst[i].pixel];
        failure << fmt::format("\n  {},{}: {} codes off, ({:.3f} {:.3f} {:.3f}) instead of ({:.3f} {:.3f} {:.3f})", x,
                               y, worst[i].codes, a[0], a[1], a[2], e[0], e[1], e[2]);
    }
    return failure;
}

}  // namespace twinlight
