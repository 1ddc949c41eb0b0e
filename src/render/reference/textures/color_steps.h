// How a lit colour becomes the fragment's colour, with all numbers: texture (3.8), colour sum (3.9), fog (3.10).
#pragma once

#include <optional>
#include <vector>

#include "render/reference/textures/texture.h"

namespace twinlight::reference {

// A texture unit's part of a fragment's colour.
struct TextureSteps {
    struct Texel {
        TexelPlace place{};
        bool is_border = false;  // outside the image: the border colour
        double weight = 1;
        glm::dvec4 color{0};
        double depth = 0;  // of a texture of depths
    };
    struct Image {
        int level = 0;
        double weight = 1;
        std::vector<Texel> texels{};  // the sum of the weights is 1
    };

    std::size_t unit = 0;
    glm::dvec4 coordinates{0, 0, 0, 1};  // s, t, r, q after the texture matrix; interpolated
    glm::dvec3 str{0};                   // s/q, t/q and r/q; on the face of a cube map: s and t
    std::size_t face = 0;                // of a cube map
    bool of_point = false;               // rho is 1 by definition (3.8.8)
    double rho = 1, lambda = 0;
    bool is_magnified = false;
    Enum filter = kGL_NEAREST;  // the magnification or the minification filter, whichever is used
    std::vector<Image> images{};
    glm::dvec4 texel{0};     // C_s and A_s: the sum of the weights times the texels
    glm::dvec4 fragment{0};  // C_f and A_f: after the unit before it
    glm::dvec4 result{0};    // C_v and A_v, of the texture environment
};

struct FogSteps {
    double distance = 0;  // c: |z_e|
    double factor = 1;    // f
    glm::dvec4 result{0};
};

struct ColorSteps {
    glm::dvec4 primary{0}, secondary{0};   // clamped
    std::vector<TextureSteps> textures{};  // one for each unit that has a texture, in their order
    glm::dvec4 sum{0};                     // with the secondary colour, clamped
    std::optional<FogSteps> fog{};
};

// All but the unit's number, the fragment and the result. `coordinates` and `place` are the fragment's.
TextureSteps texture_steps(const TextureUnit& unit, const glm::dvec4& coordinates, const TexturePlace& place);

}  // namespace twinlight::reference
