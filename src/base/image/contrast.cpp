#include "base/image/contrast.h"

#include <algorithm>

namespace twinlight {

float color_contrast(const Image& image) {
    float most = 0;
    for (int channel = 0; channel < 3; ++channel) {
        const auto value = [channel](const Rgba& pixel) { return pixel[channel]; };
        const auto [least, largest] = std::ranges::minmax(image.pixels, {}, value);
        most = std::max(most, largest[channel] - least[channel]);
    }
    return most;
}

}  // namespace twinlight
