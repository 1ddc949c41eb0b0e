#include "render/reference/textures/texture.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/reference/textures/comparison.h"

namespace twinlight::reference {

namespace {

// 3.8.7: the texture coordinate after the wrap mode, between 0 and 1 (with half a texel more for the border).
double wrapped(Enum wrap, double coordinate, int size) {
    const double half_texel = 0.5 / size;
    switch (wrap) {
        case kGL_CLAMP: return std::clamp(coordinate, 0.0, 1.0);
        case kGL_CLAMP_TO_EDGE: return std::clamp(coordinate, half_texel, 1 - half_texel);
        case kGL_CLAMP_TO_BORDER: return std::clamp(coordinate, -half_texel, 1 + half_texel);
        case kGL_MIRRORED_REPEAT: {  // every second period is reversed
            const double period = std::floor(coordinate), rest = coordinate - period;
            const bool backwards = std::fmod(period, 2) != 0;
            return std::clamp(backwards ? 1 - rest : rest, half_texel, 1 - half_texel);
        }
    }
    return coordinate - std::floor(coordinate);  // GL_REPEAT
}

int floor_int(double x) { return static_cast<int>(std::floor(x)); }

const TextureImage& image_of(const Texture& texture, int level) {
    return texture.levels[static_cast<std::size_t>(level)];
}

}  // namespace

int nearest_texel(Enum wrap, double coordinate, int size) {
    const int i = floor_int(size * wrapped(wrap, countable(coordinate), size));
    // A coordinate of 1 is in the last texel; rounding may also take a smaller one there.
    return wrap == kGL_CLAMP_TO_BORDER ? i : std::min(i, size - 1);
}

TexelPair linear_texels(Enum wrap, double coordinate, int size) {
    const double u = size * wrapped(wrap, countable(coordinate), size) - 0.5;
    TexelPair pair{.first = floor_int(u), .second = floor_int(u) + 1, .weight = u - std::floor(u)};
    if (wrap == kGL_REPEAT) {
        pair.first = (pair.first + size) % size;
        pair.second %= size;
    } else if (wrap == kGL_CLAMP_TO_EDGE || wrap == kGL_MIRRORED_REPEAT) {
        // After the last texel the weight is 0, so the second texel does not matter.
        pair.first = std::clamp(pair.first, 0, size - 1);
        pair.second = std::clamp(pair.second, 0, size - 1);
    }
    return pair;
}

double texel_depth(const Texture& texture, const TextureImage& image, const TexelPlace& place) {
    return place.is_inside(image) ? static_cast<double>(image.texel(place.i, place.j).r) : texture.border_texel().r;
}

glm::dvec4 depth_texel(Enum depth_mode, double value) {
    switch (depth_mode) {
        case kGL_ALPHA: return {0, 0, 0, value};
        case kGL_INTENSITY: return glm::dvec4(value);
        default: return {value, value, value, 1};  // GL_LUMINANCE
    }
}

glm::dvec4 texel_at(const Texture& texture, const TextureImage& image, const TexelPlace& place, double r) {
    if (texture.has_depths()) {
        const double depth = texel_depth(texture, image, place);
        if (!texture.compares()) return depth_texel(texture.depth_mode, depth);
        return depth_texel(texture.depth_mode, compares(texture.compare_func, std::clamp(r, 0.0, 1.0), depth) ? 1 : 0);
    }
    if (!place.is_inside(image)) return texture.border_texel();
    glm::dvec4 texel(image.texel(place.i, place.j, place.k));
    if (image.base_format == kGL_INTENSITY) texel.a = texel.r;  // table 3.21: A_s is I_t
    return texel;
}

// 3.8.8: the nearest texel, or the mean of two, four or eight.
glm::dvec4 sample_image(const Texture& texture, const TextureImage& image, Enum filter, const glm::dvec3& str) {
    const bool has_t = !texture.is_flat(), has_r = texture.is_volume();
    if (filter == kGL_NEAREST) {
        TexelPlace place{.i = nearest_texel(texture.wrap_s, str.x, image.width)};
        if (has_t) place.j = nearest_texel(texture.wrap_t, str.y, image.height);
        if (has_r) place.k = nearest_texel(texture.wrap_r, str.z, image.depth);
        return texel_at(texture, image, place, str.z);
    }
    const TexelPair i = linear_texels(texture.wrap_s, str.x, image.width);
    const auto row = [&](int j, int k) {
        return glm::mix(texel_at(texture, image, {i.first, j, k}, str.z),
                        texel_at(texture, image, {i.second, j, k}, str.z), i.weight);
    };
    if (!has_t) return row(0, 0);
    const TexelPair j = linear_texels(texture.wrap_t, str.y, image.height);
    const auto layer = [&](int k) { return glm::mix(row(j.first, k), row(j.second, k), j.weight); };
    if (!has_r) return layer(0);
    const TexelPair k = linear_texels(texture.wrap_r, str.z, image.depth);
    return glm::mix(layer(k.first), layer(k.second), k.weight);
}

glm::dvec3 size_in_texels(const Texture& texture) {
    const TextureImage& base = image_of(texture, 0);
    return {base.width, texture.is_flat() ? 0 : base.height, texture.is_volume() ? base.depth : 0};
}

double scale_factor(const Texture& texture, const TexturePlace& place) {
    if (place.of_point) return 1;
    const glm::dvec3 size = size_in_texels(texture);
    return std::max(glm::length(size * place.per_x), glm::length(size * place.per_y));
}

double level_of_detail(double rho, const TextureUnit& unit) {
    constexpr double kSmallest = -1100;  // log2 of what rounds to 0
    const auto [low, high] = std::minmax(unit.texture->min_lod, unit.texture->max_lod);
    return std::clamp((rho > 0 ? std::log2(rho) : kSmallest) + unit.lod_bias, low, high);
}

double magnification_limit(const Texture& texture) {
    const bool sharper = texture.mag_filter == kGL_LINEAR && (texture.min_filter == kGL_NEAREST_MIPMAP_NEAREST ||
                                                              texture.min_filter == kGL_NEAREST_MIPMAP_LINEAR);
    return sharper ? 0.5 : 0;
}

int last_level(const Texture& texture) {
    const TextureImage& base = image_of(texture, 0);
    const auto longest = static_cast<unsigned>(std::max({base.width, base.height, base.depth}));
    const int halvings = static_cast<int>(std::bit_width(longest)) - 1;
    return std::min(halvings, static_cast<int>(texture.levels.size()) - 1);
}

Enum image_filter(Enum min_filter) {
    const bool nearest = min_filter == kGL_NEAREST || min_filter == kGL_NEAREST_MIPMAP_NEAREST ||
                         min_filter == kGL_NEAREST_MIPMAP_LINEAR;
    return nearest ? kGL_NEAREST : kGL_LINEAR;
}

LevelChoice level_choice(Enum min_filter) {
    if (min_filter == kGL_NEAREST || min_filter == kGL_LINEAR) return LevelChoice::kBase;
    const bool nearest = min_filter == kGL_NEAREST_MIPMAP_NEAREST || min_filter == kGL_LINEAR_MIPMAP_NEAREST;
    return nearest ? LevelChoice::kNearest : LevelChoice::kTwo;
}

// 3.8.8, equation 3.20: the nearer of two levels; the finer one if halfway.
int nearest_level(const Texture& texture, double lambda) {
    const int last = last_level(texture);
    if (lambda <= 0.5) return 0;
    return lambda > last + 0.5 ? last : static_cast<int>(std::ceil(lambda + 0.5)) - 1;
}

FilteredImages filtered_images(const Texture& texture, double lambda) {
    if (lambda <= magnification_limit(texture)) return {.is_magnified = true, .filter = texture.mag_filter};
    FilteredImages images{.filter = image_filter(texture.min_filter)};
    switch (level_choice(texture.min_filter)) {
        case LevelChoice::kBase: break;
        case LevelChoice::kNearest: images.first = images.second = nearest_level(texture, lambda); break;
        case LevelChoice::kTwo: {  // equation 3.21
            const int last = last_level(texture);
            images.first = std::min(floor_int(lambda), last);
            images.second = std::min(images.first + 1, last);
            if (images.first < last) images.weight = lambda - images.first;
            break;
        }
    }
    return images;
}

// In the order of Texture::face().
CubePlace place_on_face(const glm::dvec3& direction, std::size_t face) {
    struct Row {
        std::array<int, 3> axes;  // of s_c, t_c and m_a: 0 to 2 for s, t and r
        std::array<double, 3> signs;
    };
    static constexpr Row kFaces[] = {
        {{2, 1, 0}, {-1, -1, 1}}, {{2, 1, 0}, {1, -1, -1}}, {{0, 2, 1}, {1, 1, 1}},
        {{0, 2, 1}, {1, -1, -1}}, {{0, 1, 2}, {1, -1, 1}},  {{0, 1, 2}, {-1, -1, -1}},
    };
    const Row& row = kFaces[face];
    CubePlace place{.face = face, .axes = row.axes, .signs = row.signs};
    place.major = row.signs[2] * direction[row.axes[2]];
    for (int i = 0; i < 2; ++i) {
        const auto n = static_cast<std::size_t>(i);
        const double quotient = place.major > 0 ? row.signs[n] * direction[row.axes[n]] / place.major : 0;
        place.st[i] = (quotient + 1) / 2;
    }
    return place;
}

CubePlace cube_place(const glm::dvec3& direction) {
    const glm::dvec3 size = glm::abs(direction);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    return place_on_face(direction, static_cast<std::size_t>(2 * axis + (direction[axis] < 0 ? 1 : 0)));
}

glm::dvec4 sample(const Texture& texture, const glm::dvec3& str, double lambda, std::size_t face) {
    assert(!texture.levels.empty() && !image_of(texture, 0).texels.empty());
    const FilteredImages images = filtered_images(texture, lambda);
    const auto level = [&](int number) {
        return sample_image(texture, texture.face(face)[static_cast<std::size_t>(number)], images.filter, str);
    };
    if (images.first == images.second) return level(images.first);
    return glm::mix(level(images.first), level(images.second), images.weight);
}

}  // namespace twinlight::reference
