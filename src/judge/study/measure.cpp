#include "judge/study/measure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace twinlight::study {

namespace {

class Sum {
  public:
    void add(const Rgba& picture, const Rgba& truth, double delta_e) {
        delta_es_.push_back(delta_e);
        for (std::size_t c = 0; c < 3; ++c) {
            const double difference = std::abs(static_cast<double>(picture[c]) - truth[c]);
            max_ = std::max(max_, difference);
            squares_ += difference * difference;
        }
    }
    Error error() {
        Error error;
        error.pixels = delta_es_.size();
        if (error.pixels == 0) return error;
        const auto count = static_cast<double>(error.pixels);
        error.max = max_;
        error.rms = std::sqrt(squares_ / (3 * count));
        error.delta_e = std::accumulate(delta_es_.begin(), delta_es_.end(), 0.0) / count;
        constexpr double kPart = 0.95;
        const auto place = delta_es_.begin() + static_cast<std::ptrdiff_t>(std::ceil(kPart * count)) - 1;
        std::ranges::nth_element(delta_es_, place);
        error.delta_e_95 = *place;
        return error;
    }

  private:
    double max_ = 0, squares_ = 0;
    std::vector<double> delta_es_;
};

Lab lab_of(const Rgba& pixel) {
    const auto code = [&](std::size_t c) { return std::clamp(static_cast<double>(pixel[c]), 0.0, 1.0); };
    return lab_from_srgb_codes({code(0), code(1), code(2)});
}

}  // namespace

double Error::psnr_db() const { return rms > 0 ? -20 * std::log10(rms) : std::numeric_limits<double>::infinity(); }

double quantile(std::vector<double> values, double part) {
    if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
    std::ranges::sort(values);
    const double place = part * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
}

std::string Measure::demand_of(double target) const {
    return fmt::format(fmt::runtime(demand), target == kCode ? "1/255" : fmt::format("{:g}", target));
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

Truth::Truth(Image image) : image_(std::move(image)) {
    for (const Rgba& pixel : image_.pixels) labs_.push_back(lab_of(pixel));
}

Errors Truth::errors_of(const Image& picture, const std::vector<char>& is_silhouette) const {
    Sum whole, interior, silhouette;
    for (std::size_t i = 0; i < image_.pixels.size(); ++i) {
        const Rgba &pixel = picture.pixels[i], &truth = image_.pixels[i];
        const double delta_e = pixel == truth ? 0 : delta_e_2000(lab_of(pixel), labs_[i]);
        whole.add(pixel, truth, delta_e);
        (is_silhouette[i] ? silhouette : interior).add(pixel, truth, delta_e);
    }
    return {whole.error(), interior.error(), silhouette.error()};
}

}  // namespace twinlight::study
