#include "study/measure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace twinlight::study {

namespace {

class Sum {
  public:
    void add(const Rgba& picture, const Rgba& truth) {
        ++pixels_;
        for (std::size_t c = 0; c < 3; ++c) {
            const double difference = std::abs(static_cast<double>(picture[c]) - truth[c]);
            max_ = std::max(max_, difference);
            squares_ += difference * difference;
        }
    }
    Error error() const {
        return {.pixels = pixels_,
                .max = max_,
                .rms = pixels_ == 0 ? 0 : std::sqrt(squares_ / (3.0 * static_cast<double>(pixels_)))};
    }

  private:
    std::size_t pixels_ = 0;
    double max_ = 0, squares_ = 0;
};

}  // namespace

double Error::psnr_db() const { return rms > 0 ? -20 * std::log10(rms) : std::numeric_limits<double>::infinity(); }

std::string Measure::target_words(double target) const {
    return target == kCode ? "1 code of 8 bits" : fmt::format("{:g}", target);
}

std::vector<char> silhouettes(const std::vector<int>& seen, const std::vector<int>& seen_in_truth, int width,
                              int height) {
    std::vector<char> mask(seen.size());
    const auto at = [&](int x, int y) {
        const int column = std::clamp(x, 0, width - 1), row = std::clamp(y, 0, height - 1);
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
    };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const int here = seen[at(x, y)];
            bool is_border = false;
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx)
                    is_border |= seen_in_truth[at(x + dx, y + dy)] != here || seen[at(x + dx, y + dy)] != here;
            mask[at(x, y)] = is_border ? 1 : 0;
        }
    return mask;
}

Errors errors_of(const Image& picture, const Image& truth, const std::vector<char>& is_silhouette) {
    Sum whole, interior, silhouette;
    for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
        whole.add(picture.pixels[i], truth.pixels[i]);
        (is_silhouette[i] ? silhouette : interior).add(picture.pixels[i], truth.pixels[i]);
    }
    return {whole.error(), interior.error(), silhouette.error()};
}

}  // namespace twinlight::study
