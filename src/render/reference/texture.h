// Texturing (3.8.7 to 3.8.10): from texture coordinates to a filtered texel, in one and two dimensions.
//
// In: a complete texture (3.8.10), the place in it, and lambda, the level of detail. Out: (R, G, B, A) as the base
// internal format has them; what table 3.21 makes of it, stands in texture_environment.h.
#pragma once

#include <cmath>
#include <glm/vec2.hpp>

#include "lighting/real.h"
#include "scene/state/frame.h"

namespace twinlight::reference {

// Where a fragment lies in its texture: (s, t) divided by q, and how that changes by one pixel along x and y.
struct TexturePlace {
    glm::dvec2 st{0};
    glm::dvec2 per_x{0}, per_y{0};
    bool of_point = false;  // rho is 1 for all of a point (3.8.8)
};

// rho of 3.8.8, equation 3.18 itself: not one of the functions near it that the text allows, which lie between half of
// it and twice it. 3.8.8's lambda is log2 of it and the bias.
double scale_factor(const Texture& texture, const TexturePlace& place);
double level_of_detail(double rho, double lod_bias);

// The constant c of 3.8.9: up to which lambda a texture is magnified.
double magnification_limit(const Texture& texture);

// The number of the last level that is used: q of 3.8.8.
int last_level(const Texture& texture);

glm::dvec4 sample(const Texture& texture, const glm::dvec2& st, double lambda);

// ---- Its parts ----

// One axis of an image under a wrap mode (table 3.19): which texels lie at a coordinate. -1 or `size`: the border's.
struct TexelPair {
    int first = 0, second = 0;
    double weight = 0;  // of the second; the first has the rest
};
// RULING: a coordinate that is no number, or beyond what double can count, is 0.
template <class Real>
Real countable(Real coordinate) {
    using std::abs;
    return abs(coordinate) < Real(1e15) ? coordinate : ruled(lighting::Ruling::kUncountable, Real(0));
}
int nearest_texel(Enum wrap, double coordinate, int size);
TexelPair linear_texels(Enum wrap, double coordinate, int size);

// The texel at i, j, or the border's colour outside (3.8.8), as the image's base internal format has it (table 3.15).
glm::dvec4 texel_at(const Texture& texture, const TextureImage& image, int i, int j);

// tau of one image by one of the filters GL_NEAREST and GL_LINEAR.
glm::dvec4 sample_image(const Texture& texture, const TextureImage& image, Enum filter, const glm::dvec2& st);

// What a minification filter is made of: how it filters an image, and how it chooses images.
Enum image_filter(Enum min_filter);  // GL_NEAREST or GL_LINEAR
enum class LevelChoice : std::uint8_t { kBase, kNearest, kTwo };
LevelChoice level_choice(Enum min_filter);
int nearest_level(const Texture& texture, double lambda);

}  // namespace twinlight::reference
