// Errors of pictures: what is measured, and at which pixels. Medians and quantiles of times.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "base/image/delta_e.h"
#include "base/image/image.h"

namespace twinlight::study {

// The difference of red, green and blue, on [0,1], and how visible it is (Delta E).
struct Error {
    std::size_t pixels = 0;
    double max = 0;
    double rms = 0;
    double delta_e = 0, delta_e_95 = 0;  // base/image/delta_e.h: mean and 95th percentile over the pixels

    double psnr_db() const;  // 20 log10(1 / rms); infinite without an error

    friend bool operator==(const Error&, const Error&) = default;
};

struct Errors {
    Error whole;       // all pixels
    Error interior;    // inside shapes: the same shape as in the exact picture, and no other within a pixel
    Error silhouette;  // at outlines: all other pixels

    friend bool operator==(const Errors&, const Errors&) = default;
};

struct Region {
    const char* name;  // "interior"
    Error Errors::*errors;
};
inline constexpr Region kRegions[] = {
    {"whole", &Errors::whole}, {"interior", &Errors::interior}, {"silhouette", &Errors::silhouette}};

// A measure of a picture's error.
struct Measure {
    const char* name;    // "rms"
    const char* axis;    // "rms error (0 to 1)": title of a plot's axis and of a table's column
    const char* unit;    // "rms": in front of a value
    const char* demand;  // "an rms error of at most {}": in a sentence
    double Error::*value;
    std::array<double, 6> targets;  // errors to name the fastest choice for, from large to small; 0 ends the list

    std::string demand_of(double target) const;
};
inline constexpr double kCode = 1.0 / 255;  // the step of an 8-bit channel
inline constexpr Measure kMeasures[] = {
    {"rms",
     "rms error (0 to 1)",
     "rms",
     "an rms error of at most {}",
     &Error::rms,
     {0.1, 0.03, 0.01, kCode, 0.001, 0.0001}},
    {"max",
     "largest error (0 to 1)",
     "max",
     "a largest error of at most {}",
     &Error::max,
     {0.5, 0.1, 0.03, 0.01, kCode}},
    {"delta_e", "mean Delta E 2000", "Delta E", "a mean Delta E of at most {}", &Error::delta_e, {5, 2, 1, 0.5, 0.1}},
    {"delta_e_95",
     "Delta E 2000, 95th percentile",
     "Delta E",
     "a Delta E of at most {} at 95 % of the pixels",
     &Error::delta_e_95,
     {5, 2, 1}},
};
inline constexpr double kLargestError = 1e3;  // larger than any measure of a picture
inline constexpr std::size_t kMeasureCount = std::size(kMeasures);

// The mask of the pixels at outlines, row by row: another shape is seen than in the exact picture, or one within a
// pixel in either.
std::vector<char> silhouettes(const std::vector<int>& seen, const std::vector<int>& seen_in_truth, int width,
                              int height);

// The quantile `part` of the values, interpolated between the two nearest; NaN without values.
double quantile(std::vector<double> values, double part);
inline double median(std::vector<double> values) { return quantile(std::move(values), 0.5); }

// The exact picture, with which all others are compared.
class Truth {
  public:
    explicit Truth(Image image);

    const Image& image() const { return image_; }
    Errors errors_of(const Image& picture, const std::vector<char>& is_silhouette) const;

  private:
    Image image_;
    std::vector<Lab> labs_;
};

}  // namespace twinlight::study
