// n samples of a spectrum: what a renderer computes with in the place of red, green and blue.
//
// 380 to 780 nm is cut into n bands, and a sample is the mean over its band. The cuts lie where bands have equal shares of
// (x_bar + y_bar + z_bar)^(1/3), and lines are weighted by that sum: of a sum over n intervals the error is smallest where they are
// as dense as the cube root of what weights them. n = 81 are the lines themselves.
//
// Samples are relative to white, and keep colours: a reflectance's under D65, a light's on white. So D65 on white is n
// ones and the colour (1, 1, 1), an RGB colour's samples give that colour, and a measured one's its own, for every n. What the
// means alone get wrong is put right by a smooth spectrum, that of the missing colour.
#pragma once

#include <span>
#include <vector>

#include "base/math/srgb.h"
#include "scene/spectrum/spectrum.h"

namespace twinlight {

class SpectralSamples {
  public:
    static constexpr int kFewest = 3;  // a colour has three numbers
    static constexpr int kMost = kLines;

    // Precondition: kFewest <= count <= kMost.
    explicit SpectralSamples(int count);

    int count() const { return static_cast<int>(rgb_.size()); }

    // Of the smoothest spectrum at hand (spectrum.h, primaries()) that has a colour of linear sRGB; linear in the colour. Colours
    // outside of [0,1] are as good as any, and their samples may be negative.
    std::vector<double> of_color(Vec3<double> rgb) const;
    // Of one of reflectances(), and of one of illuminants().
    const std::vector<double>& of_reflectance(const Spectrum& reflectance) const;
    const std::vector<double>& of_illuminant(const Spectrum& illuminant) const;

    // Their colour in linear sRGB. What lies outside of the gamut is negative.
    Vec3<double> color(std::span<const double> samples) const;
    // The same, of what is sample by sample the product of a light and a surface.
    Vec3<double> color_of_product(std::span<const double> light, std::span<const double> surface) const;
    // What one sample adds for each unit.
    Vec3<double> weight(std::size_t sample) const { return rgb_[sample]; }

  private:
    std::vector<double> means(const Lines& lines) const;
    std::vector<double> with_color(std::vector<double> samples, Vec3<double> rgb) const;

    std::vector<Lines> shares_;        // of each sample: what each line weighs in its mean; their sum is 1
    std::vector<Vec3<double>> rgb_;    // of each sample
    std::vector<Vec3<double>> basis_;  // of each sample: what red, green and blue add to it
    std::vector<std::vector<double>> reflectances_, illuminants_;
};

}  // namespace twinlight
