#include "render/reference/textures/color_steps.h"

namespace twinlight::reference {

namespace {

struct Weighted {
    int index;
    double weight;
};

// The texels on one axis that have a weight.
std::vector<Weighted> texels_on_axis(Enum filter, Enum wrap, double coordinate, int size) {
    if (filter == kGL_NEAREST) return {{nearest_texel(wrap, coordinate, size), 1}};
    const TexelPair pair = linear_texels(wrap, coordinate, size);
    std::vector<Weighted> texels = {{pair.first, 1 - pair.weight}};
    if (pair.weight > 0) texels.push_back({pair.second, pair.weight});
    return texels;
}

TextureSteps::Image image_steps(const Texture& texture, int level, double weight, Enum filter,
                                const TexturePlace& place) {
    TextureSteps::Image steps{.level = level, .weight = weight};
    const glm::dvec3& str = place.str;
    const TextureImage& image = texture.face(place.face)[static_cast<std::size_t>(level)];
    const std::vector<Weighted> only{{0, 1}};
    const std::vector<Weighted> rows =
        texture.is_flat() ? only : texels_on_axis(filter, texture.wrap_t, str.y, image.height);
    const std::vector<Weighted> layers =
        texture.is_volume() ? texels_on_axis(filter, texture.wrap_r, str.z, image.depth) : only;
    for (const Weighted& k : layers)
        for (const Weighted& j : rows)
            for (const Weighted& i : texels_on_axis(filter, texture.wrap_s, str.x, image.width)) {
                const TexelPlace texel{i.index, j.index, k.index};
                steps.texels.push_back({.place = texel,
                                        .is_border = !texel.is_inside(image),
                                        .weight = i.weight * j.weight * k.weight,
                                        .color = texel_at(texture, image, texel, str.z),
                                        .depth = texture.has_depths() ? texel_depth(texture, image, texel) : 0});
            }
    return steps;
}

}  // namespace

TextureSteps texture_steps(const TextureUnit& unit, const glm::dvec4& coordinates, const TexturePlace& place) {
    const Texture& texture = *unit.texture;
    TextureSteps steps{.coordinates = coordinates, .str = place.str, .face = place.face, .of_point = place.of_point};
    steps.rho = scale_factor(texture, place);
    steps.lambda = level_of_detail(steps.rho, unit);
    const FilteredImages images = filtered_images(texture, steps.lambda);
    steps.is_magnified = images.is_magnified;
    steps.filter = images.is_magnified ? texture.mag_filter : texture.min_filter;
    steps.images.push_back(image_steps(texture, images.first, 1 - images.weight, images.filter, place));
    if (images.weight > 0)
        steps.images.push_back(image_steps(texture, images.second, images.weight, images.filter, place));
    steps.texel = sample(texture, place.str, steps.lambda, place.face);
    return steps;
}

}  // namespace twinlight::reference
