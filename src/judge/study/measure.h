// Errors of pictures: what is measured, and where. What times come to.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "base/image/delta_e.h"
#include "base/image/image.h"

namespace twinlight::study {

// Of red, green and blue on [0,1]; and what the eye sees of it.
struct Error {
    std::size_t pixels = 0;
    double max = 0;
    double rms = 0;
    double delta_e = 0, delta_e_95 = 0;  // base/image/delta_e.h: the mean, and what 95 % of the pixels do not exceed

    double psnr_db() const;  // 20 log10(1 / rms); infinite where there is none

    friend bool operator==(const Error&, const Error&) = default;
};

struct Errors {
    Error whole;       // of all pixels
    Error interior;    // where the same shape is seen as in truth, and more than a pixel from where another is
    Error silhouette;  // elsewhere

    friend bool operator==(const Errors&, const Errors&) = default;
};

struct Region {
    const char* name;  // "interior"
    Error Errors::*errors;
};
inline constexpr Region kRegions[] = {
    {"whole", &Errors::whole}, {"interior", &Errors::interior}, {"silhouette", &Errors::silhouette}};

// A number that says how far off a picture is.
struct Measure {
    const char* name;    // "rms"
    const char* axis;    // "rms error, of 1": of a plot, and of a table
    const char* unit;    // "rms": what stands before a value of it
    const char* demand;  // "an rms error of at most {}": in a sentence
    double Error::*value;
    std::array<double, 6> targets;  // for which a choice is recommended, from rough to fine; 0: no more

    std::string demand_of(double target) const;
};
inline constexpr double kCode = 1.0 / 255;  // of a channel of 8 bits
inline constexpr Measure kMeasures[] = {
    {"rms",
     "rms error, of 1",
     "rms",
     "an rms error of at most {}",
     &Error::rms,
     {0.1, 0.03, 0.01, kCode, 0.001, 0.0001}},
    {"max", "largest error, of 1", "max", "a largest error of at most {}", &Error::max, {0.5, 0.1, 0.03, 0.01, kCode}},
    {"delta_e", "mean Delta E 2000", "Delta E", "a mean Delta E of at most {}", &Error::delta_e, {5, 2, 1, 0.5, 0.1}},
    {"delta_e_95",
     "Delta E 2000 of 95 %",
     "Delta E",
     "95 % of the pixels within a Delta E of {}",
     &Error::delta_e_95,
     {5, 2, 1}},
};
inline constexpr double kLargestError = 1e3;  // of any measure: beyond what pictures can have
inline constexpr std::size_t kMeasureCount = std::size(kMeasures);

// Where another shape is seen than in truth, or where one begins within a pixel, in either picture; row by row.
std::vector<char> silhouettes(const std::vector<int>& seen, const std::vector<int>& seen_in_truth, int width,
                              int height);

// Of times, a part of which is no longer: between the two nearest. NaN of none.
double quantile(std::vector<double> values, double part);
inline double median(std::vector<double> values) { return quantile(std::move(values), 0.5); }

// What pictures are held against.
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
