#include "render/reference/color_steps.h"

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
    const glm::dvec2& st = place.st;
    const TextureImage& image = texture.face(place.face)[static_cast<std::size_t>(level)];
    const bool is_flat = texture.target == kGL_TEXTURE_1D;
    const std::vector<Weighted> rows =
        is_flat ? std::vector<Weighted>{{0, 1}} : texels_on_axis(filter, texture.wrap_t, st.y, image.height);
    for (const Weighted& j : rows)
        for (const Weighted& i : texels_on_axis(filter, texture.wrap_s, st.x, image.width))
            steps.texels.push_back(
                {.i = i.index,
                 .j = j.index,
                 .is_border = i.index < 0 || i.index >= image.width || j.index < 0 || j.index >= image.height,
                 .weight = i.weight * j.weight,
                 .color = texel_at(texture, image, i.index, j.index, place.r),
                 .depth = texture.has_depths() ? texel_depth(texture, image, i.index, j.index) : 0});
    return steps;
}

}  // namespace

TextureSteps texture_steps(const TextureUnit& unit, const glm::dvec4& coordinates, const TexturePlace& place) {
    const Texture& texture = *unit.texture;
    TextureSteps steps{
        .coordinates = coordinates, .st = place.st, .face = place.face, .r = place.r, .of_point = place.of_point};
    steps.rho = scale_factor(texture, place);
    steps.lambda = level_of_detail(steps.rho, unit);
    const FilteredImages images = filtered_images(texture, steps.lambda);
    steps.is_magnified = images.is_magnified;
    steps.filter = images.is_magnified ? texture.mag_filter : texture.min_filter;
    steps.images.push_back(image_steps(texture, images.first, 1 - images.weight, images.filter, place));
    if (images.weight > 0)
        steps.images.push_back(image_steps(texture, images.second, images.weight, images.filter, place));
    steps.texel = sample(texture, place.st, steps.lambda, place.face, place.r);
    return steps;
}

}  // namespace twinlight::reference
