#include "render/reference/textures/texture_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <optional>
#include <tuple>
#include <vector>

#include "render/reference/textures/comparison.h"
#include "scene/frame/texture_formats.h"

namespace twinlight::reference {

namespace {

constexpr double kWeightStep = 1.0 / 256;   // the precision of GL_LINEAR's weights
constexpr double kRoundedMean = 0.5 / 255;  // the rounding error of a mean in 8 bits
// The error of lambda between two levels, or with a bias: log2 of rho squared, where log2 of the mantissa m (1 to 2) is
// replaced by m - 1, which is up to 0.0861 too small (at m = 1 / ln 2); plus truncation to the 8 bits of weights.
constexpr double kLogTooSmall = 0.0861 / 2 + kWeightStep;
constexpr double kSwitchError = 1.0 / 256;  // the error of lambda where it only chooses: drivers compare rho itself

void join(TexelBounds& all, const TexelBounds& more) {
    all.has_choice = all.has_choice || more.has_choice;
    all.texel = hull(all.texel, more.texel);
}

TexelBounds exactly(const glm::dvec4& texel) { return {channels<Interval>(texel), false}; }

}  // namespace

TexelBounds choice(const TexelBounds& a, const TexelBounds& b) {
    TexelBounds result = a;
    join(result, b);
    result.has_choice = result.has_choice || a.texel != b.texel;
    return result;
}

namespace {

// Coordinates on one axis that together show everything in an interval: the ends and the centres of texels between them, where
// the weights of GL_LINEAR have corners.
struct Looks {
    static constexpr int kMostCentres = 5;
    std::array<double, 2 + kMostCentres> at{};
    std::size_t count = 0;

    void push_back(double coordinate) { at[count++] = coordinate; }
    const double* begin() const { return at.data(); }
    const double* end() const { return at.data() + count; }
};
Looks looks(double coordinate, double error, int size) {
    Looks result{{coordinate - error, coordinate + error}, 2};
    const double first = std::ceil((coordinate - error) * size - 0.5);
    const double last = std::min(std::floor((coordinate + error) * size - 0.5), first + Looks::kMostCentres - 1);
    for (double centre = first; centre <= last; ++centre) result.push_back((centre + 0.5) / size);
    return result;
}

// The texels within `reach` of a coordinate on one axis; -1 is the border.
std::vector<int> texels_around(Enum wrap, double coordinate, double reach, int size) {
    std::vector<int> texels;
    const double middle = countable(coordinate) * size, wide = reach * size;
    const bool has_border = wrap == kGL_CLAMP || wrap == kGL_CLAMP_TO_BORDER;
    if (2 * wide + 1 >= size) {
        for (int i = has_border ? -1 : 0; i < size; ++i) texels.push_back(i);
        return texels;
    }
    for (double i = std::floor(middle - wide); i <= std::floor(middle + wide); ++i) {
        texels.push_back(nearest_texel(wrap, (i + 0.5) / size, size));
        if (has_border && (i < 0 || i >= size)) texels.push_back(-1);
    }
    return texels;
}

class Sampler {
  public:
    Sampler(const Texture& texture, std::size_t face, const glm::dvec3& str, const glm::dvec3& error)
        : texture_(texture), face_(texture.face(face)), str_(str), error_(error) {}

    TexelBounds level(int number, Enum filter) const {
        const TextureImage& image = face_[static_cast<std::size_t>(number)];
        const bool has_t = !texture_.is_flat(), has_r = texture_.is_volume();
        const glm::dvec3 size(image.width, image.height, image.depth);
        const glm::dvec3 error = filter == kGL_NEAREST ? error_ : error_ + kWeightStep / size;
        // Beyond that, all texels that the place may have.
        if (2 * std::max({error.x * size.x, error.y * size.y, has_r ? error.z * size.z : 0}) >
            Looks::kMostCentres - 1) {
            TexelBounds all = around(number, filter == kGL_NEAREST ? error : error + 0.5 / size);
            const auto is_wide = [](const Interval& channel) { return channel.width() > 0; };
            all.has_choice = filter == kGL_NEAREST && std::ranges::any_of(all.texel, is_wide);
            return all;
        }
        const Looks along_s = looks(str_.x, error.x, image.width);
        const Looks along_t = has_t ? looks(str_.y, error.y, image.height) : Looks{{0}, 1};
        const Looks along_r = has_r ? looks(str_.z, error.z, image.depth) : Looks{{0}, 1};
        if (filter == kGL_LINEAR && has_t && !has_r) return linear_level(image, along_s, along_t);
        std::optional<TexelBounds> all;
        for (double s : along_s)
            for (double t : along_t)
                for (double r : along_r) {
                    const TexelBounds one = exactly(sample_image(texture_, image, filter, {s, t, r}));
                    if (!all)
                        all = one;
                    else if (filter == kGL_NEAREST)
                        all = choice(*all, one);
                    else
                        join(*all, one);
                }
        if (filter == kGL_LINEAR) round_means(*all, has_r ? 3 : 1);
        return *all;
    }

    // The texels for an interval of lambda; between levels they are linear in lambda.
    TexelBounds between_levels(const Interval& lambda, Enum filter) const {
        const int last = last_level(texture_);
        std::vector<double> looked = {lambda.low, lambda.high};
        for (double k = std::ceil(lambda.low); k < lambda.high && k <= last; ++k) looked.push_back(k);
        std::optional<TexelBounds> all;
        for (double at : looked) {
            const double clamped_lambda = std::clamp(at, 0.0, static_cast<double>(last));
            const int finer = std::min(static_cast<int>(clamped_lambda), last);
            TexelBounds one = level(finer, filter);
            if (finer < last) {
                const TexelBounds coarser = level(finer + 1, filter);
                const double weight = clamped_lambda - finer;
                const Channels<Interval> finest = one.texel;
                for (std::size_t i = 0; i < 4; ++i)
                    one.texel[i] = one.texel[i] * Interval(1 - weight) + coarser.texel[i] * Interval(weight);
                one.has_choice = one.has_choice || (weight > 0 && coarser.has_choice);
                // Two levels of one value each have a mean that is not exact, either.
                for (std::size_t i = 0; i < 4; ++i)
                    if (weight > 0 && finest[i] != coarser.texel[i]) one.texel[i] = rounded_mean(one.texel[i], 1);
            }
            if (!all) all = one;
            join(*all, one);
        }
        return *all;
    }

    // Any mean of the texels within `reach` of the place.
    TexelBounds around(int number, const glm::dvec3& reach) const {
        const TextureImage& image = face_[static_cast<std::size_t>(number)];
        constexpr double kMostTexels = 4096;  // more of them take too long, and mostly have all colours
        const auto texels = [&](int size, double share) { return std::min<double>(size, 2 * share * size + 2); };
        if (texels(image.width, reach.x) * texels(image.height, reach.y) * texels(image.depth, reach.z) > kMostTexels)
            return {{Interval{0, 1}, {0, 1}, {0, 1}, {0, 1}}, false};
        std::optional<TexelBounds> all;
        for_each_texel_around(image, reach, [&](const TexelPlace& place) {
            const TexelBounds one = exactly(texel_at(texture_, image, place));
            if (all)
                join(*all, one);
            else
                all = one;
        });
        round_means(*all, texture_.is_volume() ? 3 : 2);
        return *all;
    }

    // The depths within `reach` texels of the place.
    Interval depths(int number, double reach) const {
        const TextureImage& image = face_[static_cast<std::size_t>(number)];
        std::optional<Interval> all;
        for_each_texel_around(image, error_ + reach / glm::dvec3(image.width, image.height, 1),
                              [&](const TexelPlace& place) {
                                  const Interval one(texel_depth(texture_, image, place));
                                  all = all ? hull(*all, one) : one;
                              });
        return *all;
    }

  private:
    template <class Visit>
    void for_each_texel_around(const TextureImage& image, const glm::dvec3& reach, const Visit& visit) const {
        const std::vector<int> only{0};
        const std::vector<int> columns = texels_around(texture_.wrap_s, str_.x, reach.x, image.width);
        const std::vector<int> rows =
            texture_.is_flat() ? only : texels_around(texture_.wrap_t, str_.y, reach.y, image.height);
        const std::vector<int> layers =
            texture_.is_volume() ? texels_around(texture_.wrap_r, str_.z, reach.z, image.depth) : only;
        for (const int k : layers)
            for (const int j : rows)
                for (const int i : columns) visit(TexelPlace{i, j, k});
    }

    // The same with sample_image(); here each row of texels is mixed once for all looks between the same two rows.
    TexelBounds linear_level(const TextureImage& image, const Looks& along_s, const Looks& along_t) const {
        std::array<TexelPair, std::tuple_size_v<decltype(Looks::at)>> rows{};
        for (std::size_t k = 0; k < along_t.count; ++k)
            rows[k] = linear_texels(texture_.wrap_t, along_t.at[k], image.height);
        std::optional<TexelBounds> all;
        for (double s : along_s) {
            const TexelPair i = linear_texels(texture_.wrap_s, s, image.width);
            const auto row = [&](int j) {
                return glm::mix(texel_at(texture_, image, {i.first, j}), texel_at(texture_, image, {i.second, j}),
                                i.weight);
            };
            glm::dvec4 first(0), second(0);
            for (std::size_t k = 0; k < along_t.count; ++k) {
                if (k == 0 || rows[k].first != rows[k - 1].first || rows[k].second != rows[k - 1].second) {
                    first = row(rows[k].first);
                    second = row(rows[k].second);
                }
                const TexelBounds one = exactly(glm::mix(first, second, rows[k].weight));
                if (all)
                    join(*all, one);
                else
                    all = one;
            }
        }
        round_means(*all, 2);
        return *all;
    }

    // Means of equal texels are exact, so only channels with a width are rounded.
    static void round_means(TexelBounds& bounds, int means) {
        for (Interval& channel : bounds.texel)
            if (channel.width() > 0) channel = rounded_mean(channel, means);
    }
    static Interval rounded_mean(const Interval& channel, int means) {
        return clamp01(widened(channel, means * kRoundedMean));
    }

    const Texture& texture_;
    const std::vector<TextureImage>& face_;
    const glm::dvec3 str_, error_;
};

// GL_TEXTURE_MAX_ANISOTROPY_EXT above 1: EXT_texture_filter_anisotropic leaves to the driver how it filters, and for which
// filters. So this allows any mean of texels around the pixel's place in the texture, at levels from that of rho down to
// that of rho / GL_TEXTURE_MAX_ANISOTROPY_EXT. llvmpipe's weights fall off in an ellipse whose radii are the changes per pixel
// and one texel; softpipe filters so only between two levels.
TexelBounds anisotropic_bounds(const Texture& texture, const TextureUnit& unit, const Sampler& sampler,
                               const Interval& rho, const glm::dvec3& change) {
    int first = 0, last = 0;
    if (level_choice(texture.min_filter) != LevelChoice::kBase) {
        const auto level = [&](double scale) {
            return std::clamp(level_of_detail(scale, unit), 0.0, static_cast<double>(last_level(texture)));
        };
        first = static_cast<int>(std::floor(std::max(level(rho.low / texture.max_anisotropy) - kLogTooSmall, 0.0)));
        last = std::min(static_cast<int>(std::floor(level(rho.high) + kSwitchError)) + 1, last_level(texture));
    }
    std::optional<TexelBounds> all;
    for (int i = first; i <= last; ++i) {
        const TextureImage& image = texture.levels[static_cast<std::size_t>(i)];
        constexpr double kTexels = 1.5;  // the ellipse's own texel, and half of a texel of GL_LINEAR
        const TexelBounds one =
            sampler.around(i, change + kTexels / glm::dvec3(image.width, image.height, image.depth));
        if (all)
            join(*all, one);
        else
            all = one;
    }
    return *all;
}

// The depths that the comparison of 3.8.14 may see, at the levels and with the filters that correct implementations may use.
Interval depths_around(const Texture& texture, const TextureUnit& unit, const Sampler& sampler, const Interval& rho) {
    const Interval lambda(level_of_detail(rho.low, unit) - kLogTooSmall,
                          level_of_detail(rho.high, unit) + kSwitchError);
    const bool may_be_magnified = lambda.low <= magnification_limit(texture), may_be_minified = lambda.high > 0;
    const bool is_linear = (may_be_magnified && texture.mag_filter == kGL_LINEAR) ||
                           (may_be_minified && image_filter(texture.min_filter) == kGL_LINEAR);
    int first = 0, last = 0;
    if (may_be_minified && level_choice(texture.min_filter) != LevelChoice::kBase) {
        const auto level = [&](double at) {
            return static_cast<int>(std::clamp(std::floor(at), 0.0, static_cast<double>(last_level(texture))));
        };
        first = may_be_magnified ? 0 : level(lambda.low);
        last = level(lambda.high + 1);
    }
    std::optional<Interval> all;
    for (int i = first; i <= last; ++i) {
        const Interval one = sampler.depths(i, is_linear ? 0.5 + kWeightStep : 0);
        all = all ? hull(*all, one) : one;
    }
    return *all;
}

// A texture that compares (3.8.14).
TexelBounds compared_bounds(const TextureUnit& unit, const glm::dvec3& str, const glm::dvec3& error,
                            const Interval& rho, const CopyRanges::OfTexels* copied) {
    const Texture& texture = *unit.texture;
    const auto around = [&](const Texture& one) { return depths_around(one, unit, Sampler(one, 0, str, error), rho); };
    Interval depths = copied ? hull(around(copied->low), around(copied->high)) : around(texture);
    // All renderers store 0 and 1 exactly, and clamp r to them.
    const Interval clamped_r = clamp01(Interval(str.z - error.z, str.z + error.z));
    if (depths == clamped_r && (depths == Interval(0) || depths == Interval(1)))
        return exactly(depth_texel(texture.depth_mode, compares(texture.compare_func, 0, 0) ? 1 : 0));
    // Drivers round depths to the bits of the format in ways of their own.
    constexpr double kCode = 1;
    const int bits = internal_format(texture.levels.front().internal_format)->red;
    depths = widened(depths, kCode / (std::exp2(bits) - 1));
    switch (depth_outcome(texture.compare_func, clamped_r - depths)) {
        case Outcome::kFails: return exactly(depth_texel(texture.depth_mode, 0));
        case Outcome::kPasses: return exactly(depth_texel(texture.depth_mode, 1));
        case Outcome::kOpen: break;
    }
    TexelBounds bounds = exactly(depth_texel(texture.depth_mode, 0));
    join(bounds, exactly(depth_texel(texture.depth_mode, 1)));
    bounds.has_choice = true;
    return bounds;
}

// With the images of `texture` in place of the unit's.
TexelBounds bounds_of(const Texture& texture, const TextureUnit& unit, const glm::dvec3& str, const glm::dvec3& error,
                      const Interval& rho, std::size_t face, const glm::dvec3& change) {
    const Sampler sampler(texture, face, str, error);
    if (texture.max_anisotropy > 1) return anisotropic_bounds(texture, unit, sampler, rho, change + error);
    const LevelChoice levels = level_choice(texture.min_filter);
    const Enum filter = image_filter(texture.min_filter);
    if (levels == LevelChoice::kBase && filter == texture.mag_filter) return sampler.level(0, filter);

    const bool takes_log = levels == LevelChoice::kTwo || unit.lod_bias != 0;
    const Interval lambda(level_of_detail(rho.low, unit) - (takes_log ? kLogTooSmall : kSwitchError),
                          level_of_detail(rho.high, unit) + (takes_log ? 0 : kSwitchError));
    // 3.8.9's constant c is 0.5 for some pairs of filters; GL 3.1 and later let it be 0 for all.
    const bool may_be_magnified = lambda.low <= magnification_limit(texture);
    const bool may_be_minified = lambda.high > 0;

    std::optional<TexelBounds> minified;
    if (may_be_minified) {
        const Interval above(std::max(lambda.low, 0.0), lambda.high);
        switch (levels) {
            case LevelChoice::kBase: minified = sampler.level(0, filter); break;
            case LevelChoice::kNearest:
                for (int i = nearest_level(texture, above.low); i <= nearest_level(texture, above.high); ++i)
                    minified = minified ? choice(*minified, sampler.level(i, filter)) : sampler.level(i, filter);
                break;
            case LevelChoice::kTwo: minified = sampler.between_levels(above, filter); break;
        }
    }
    if (!may_be_magnified) return *minified;
    const TexelBounds magnified = sampler.level(0, texture.mag_filter);
    if (!minified) return magnified;
    if (filter != texture.mag_filter) return choice(magnified, *minified);
    join(*minified, magnified);
    return *minified;
}

}  // namespace

// Weights are not negative, so the smallest texels give the smallest mean.
TexelBounds sample_bounds(const TextureUnit& unit, const glm::dvec3& str, const glm::dvec3& error, const Interval& rho,
                          std::size_t face, const glm::dvec3& change, const CopyRanges::OfTexels* copied) {
    if (unit.texture->compares()) return compared_bounds(unit, str, error, rho, copied);
    if (!copied) return bounds_of(*unit.texture, unit, str, error, rho, face, change);
    TexelBounds bounds = bounds_of(copied->low, unit, str, error, rho, face, change);
    join(bounds, bounds_of(copied->high, unit, str, error, rho, face, change));
    return bounds;
}

}  // namespace twinlight::reference
