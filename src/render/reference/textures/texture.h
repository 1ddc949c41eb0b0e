// Texturing (3.8.7 to 3.8.10): from texture coordinates to a filtered texel, in one to three dimensions and on the faces of
// a cube.
//
// In: a complete texture (3.8.10), the place in it, and lambda, the level of detail. Out: (R, G, B, A) in the base
// internal format. texture_environment.h applies table 3.21.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "lighting/real.h"
#include "scene/frame/frame.h"

namespace twinlight::reference {

// A fragment's place in its texture: (s, t, r) divided by q, and their change per pixel in x and y. On the face of a cube map:
// (s, t, 0). A texture that compares depths does so with r (3.8.14).
struct TexturePlace {
    glm::dvec3 str{0};
    glm::dvec3 per_x{0}, per_y{0};
    bool of_point = false;  // the fragment is part of a point, where rho is 1 (3.8.8)
    std::size_t face = 0;   // of a cube map: see Texture::face()
};

// The face of a cube map that a direction (s, t, r) points to, and (s, t) on it (3.8.7, table 3.21). RULING: between two faces
// with equally large coordinates it is that of s, then that of t.
struct CubePlace {
    std::size_t face = 0;
    glm::dvec2 st{0.5};
    double major = 0;  // |m_a|
    // The signed coordinates of the direction that are s_c, t_c and m_a.
    std::array<int, 3> axes{};
    std::array<double, 3> signs{};
};
CubePlace cube_place(const glm::dvec3& direction);
CubePlace place_on_face(const glm::dvec3& direction, std::size_t face);

// The width, height and depth of level 0; 0 in a dimension that the texture lacks.
glm::dvec3 size_in_texels(const Texture& texture);

// rho of 3.8.8, exactly by equation 3.18. (The specification also allows approximations between half and twice of it.)
double scale_factor(const Texture& texture, const TexturePlace& place);
// lambda of 3.8.8: log2(rho) plus the bias, limited by GL_TEXTURE_MIN_LOD and GL_TEXTURE_MAX_LOD.
// RULING: if the first is larger than the second, they change places, as in Mesa; 3.8.8 leaves that open.
double level_of_detail(double rho, const TextureUnit& unit);

// The constant c of 3.8.9: the texture is magnified if lambda is at most c.
double magnification_limit(const Texture& texture);

// The number of the last level in use: q of 3.8.8.
int last_level(const Texture& texture);

glm::dvec4 sample(const Texture& texture, const glm::dvec3& str, double lambda, std::size_t face = 0);

// ---- The parts of sampling ----

// The texels at a coordinate on one axis, under a wrap mode (table 3.19). -1 or `size` means the border.
struct TexelPair {
    int first = 0, second = 0;
    double weight = 0;  // of the second; the first has 1 - weight
};
// RULING: a coordinate that is NaN or too large to count texels is replaced by 0.
template <class Real>
Real countable(Real coordinate) {
    using std::abs;
    return abs(coordinate) < Real(1e15) ? coordinate : ruled(lighting::Ruling::kUncountable, Real(0));
}
int nearest_texel(Enum wrap, double coordinate, int size);
TexelPair linear_texels(Enum wrap, double coordinate, int size);

// The place of a texel in an image.
struct TexelPlace {
    int i = 0, j = 0, k = 0;

    bool is_inside(const TextureImage& image) const {
        return i >= 0 && i < image.width && j >= 0 && j < image.height && k >= 0 && k < image.depth;
    }
};

// The texel there, or the border colour outside (3.8.8), in the image's base internal format (table 3.15). A depth is a colour of
// the texture's depth_mode. If the texture compares depths with r, 1 stands for each that passes, and 0 for the others (3.8.14).
// RULING: a linear filter mixes the outcomes; 3.8.14 leaves that open. llvmpipe does this too; softpipe compares the mean of the
// depths.
glm::dvec4 texel_at(const Texture& texture, const TextureImage& image, const TexelPlace& place, double r = 0);
glm::dvec4 depth_texel(Enum depth_mode, double value);
// The depth there, or that of the border.
double texel_depth(const Texture& texture, const TextureImage& image, const TexelPlace& place);

// tau of one image, filtered with GL_NEAREST or GL_LINEAR.
glm::dvec4 sample_image(const Texture& texture, const TextureImage& image, Enum filter, const glm::dvec3& str);

// The two parts of a minification filter: how it filters an image, and how it chooses images.
Enum image_filter(Enum min_filter);  // GL_NEAREST or GL_LINEAR
enum class LevelChoice : std::uint8_t { kBase, kNearest, kTwo };
LevelChoice level_choice(Enum min_filter);
int nearest_level(const Texture& texture, double lambda);

// The images that are filtered at a level of detail, and how (3.8.8, 3.8.9).
struct FilteredImages {
    bool is_magnified = false;
    Enum filter = kGL_NEAREST;  // of each image
    int first = 0, second = 0;  // levels
    double weight = 0;          // of the second; the first has 1 - weight
};
FilteredImages filtered_images(const Texture& texture, double lambda);

// RULING: a quotient with a q of 0 is 0.
template <class Real>
Real quotient(Real a, Real b) {
    return b == Real(0) ? ruled(lighting::Ruling::kZeroQuotient, Real(0)) : a / b;
}

}  // namespace twinlight::reference
