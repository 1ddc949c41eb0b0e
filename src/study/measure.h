// Errors of pictures: what is measured, and where.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "image/image.h"

namespace twinlight::study {

// Of red, green and blue on [0,1].
struct Error {
    std::size_t pixels = 0;
    double max = 0;
    double rms = 0;

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
    const char* name;   // "rms"
    const char* words;  // "an rms error", in a sentence
    const char* unit;   // what stands before a value of it
    const char* axis;   // of a plot, and of a table
    double Error::*value;
    std::array<double, 6> targets;  // for which a choice is recommended, from rough to fine; 0: no more

    // "0.01", and "1 code (1/255)"
    std::string target_words(double target) const;
};
inline constexpr double kCode = 1.0 / 255;  // of a channel of 8 bits
inline constexpr Measure kMeasures[] = {
    {"rms", "an rms error", "rms", "rms error, of 1", &Error::rms, {0.1, 0.03, 0.01, kCode, 0.001, 0.0001}},
    {"max", "a largest error", "max", "largest error, of 1", &Error::max, {0.5, 0.1, 0.03, 0.01, kCode}},
};
inline constexpr double kLargestError = 1e3;  // of any measure: beyond what pictures can have
inline constexpr std::size_t kMeasureCount = std::size(kMeasures);

// Where another shape is seen than in truth, or where one begins within a pixel, in either picture; row by row.
std::vector<char> silhouettes(const std::vector<int>& seen, const std::vector<int>& seen_in_truth, int width,
                              int height);

Errors errors_of(const Image& picture, const Image& truth, const std::vector<char>& is_silhouette);

}  // namespace twinlight::study
