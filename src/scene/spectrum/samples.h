// n samples of a spectrum. A renderer multiplies these instead of red, green and blue.
//
// The range 380 to 780 nm is divided into n bands; a sample is the weighted mean of the spectrum over its band. The
// weights are x_bar + y_bar + z_bar. All bands have the same share of the cube root of that weight, because the error
// of a sum over n intervals is smallest if their density follows the cube root of the weight. With n = 81 the samples
// are the lines.
//
// Samples are relative to white and preserve colours exactly: that of a reflectance under D65, and that of a light on
// white. For every n, D65 on white has n samples of 1 and the colour (1, 1, 1), and the samples of a colour or a
// measured spectrum give its colour. The means alone would change the colour slightly, so a smooth spectrum with the
// difference is added.
#pragma once

#include <span>
#include <vector>

#include "base/math/srgb.h"
#include "scene/spectrum/spectrum.h"

namespace twinlight {

class SpectralSamples {
  public:
    static constexpr int kFewest = 3;  // because a colour has three numbers
    static constexpr int kMost = kLines;

    // Precondition: kFewest <= count <= kMost.
    explicit SpectralSamples(int count);

    int count() const { return static_cast<int>(rgb_.size()); }

    // The samples of a smooth spectrum (primaries() in spectrum.h) with this colour in linear sRGB. They are linear in
    // the colour. Colours outside [0,1] are allowed; their samples may be negative.
    std::vector<double> of_color(Vec3<double> rgb) const;
    // The samples of one of reflectances(), and of one of illuminants().
    const std::vector<double>& of_reflectance(const Spectrum& reflectance) const;
    const std::vector<double>& of_illuminant(const Spectrum& illuminant) const;

    // The colour of samples in linear sRGB. Outside the gamut a channel is negative.
    Vec3<double> color(std::span<const double> samples) const;
    // The colour of the product of a light and a surface, sample by sample.
    Vec3<double> color_of_product(std::span<const double> light, std::span<const double> surface) const;
    // The colour that a sample of value 1 adds.
    Vec3<double> weight(std::size_t sample) const { return rgb_[sample]; }

  private:
    std::vector<double> means(const Lines& lines) const;
    std::vector<double> with_color(std::vector<double> samples, Vec3<double> rgb) const;

    std::vector<Lines> shares_;        // for each sample: the weight of each line in its mean; they sum to 1
    std::vector<Vec3<double>> rgb_;    // for each sample: weight()
    std::vector<Vec3<double>> basis_;  // for each sample: what red, green and blue add to it
    std::vector<std::vector<double>> reflectances_, illuminants_;
};

}  // namespace twinlight
