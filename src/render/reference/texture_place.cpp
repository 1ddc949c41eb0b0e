#include "render/reference/texture_place.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace twinlight::reference {

namespace {

// s, t and q divided by w; they are linear in the window. `third`: 2 for r in place of q.
Linear3 stq_over_w(const TexCoords& tex_coords, const Piece& piece, const glm::dvec2& position_window, int third = 3) {
    if (tex_coords.are_replaced(piece)) {  // r is 0, and q is 1
        const TexCoords::OfSprite at = tex_coords.of_sprite(piece, position_window);
        return {{at.st, third == 3 ? 1 : 0}, {at.per_x, 0}, {at.per_y, 0}};
    }
    const Linear3 weights = weights_over_w_at(piece, position_window);
    Linear3 result;
    for (int i = 0; i < 3; ++i) {
        const glm::dvec4& t = tex_coords[piece.primitive.vertices[i]];
        const glm::dvec3 stq(t.x, t.y, t[third]);
        result.value += weights.value[i] * stq;
        result.per_x += weights.per_x[i] * stq;
        result.per_y += weights.per_y[i] * stq;
    }
    return result;
}

bool has_no_change(const TexCoords& tex_coords, const Piece& piece) {
    return piece.shape == Shape::kPoint && !tex_coords.are_replaced(piece);
}

glm::dvec2 divided(const glm::dvec3& stq) { return {quotient(stq.x, stq.z), quotient(stq.y, stq.z)}; }

// The range of rho from differences over any 2 x 2 pixels that include this one, and from the derivatives themselves:
// implementations use differences (3.8.8 allows approximations) and choose the 2 x 2 pixels.
Interval rho_of_differences(const Texture& texture, const Linear3& stq, const TexturePlace& place, double st_error) {
    const auto at = [&](int x, int y) {
        return divided(stq.value + static_cast<double>(x) * stq.per_x + static_cast<double>(y) * stq.per_y);
    };
    const glm::dvec2 size(texture.levels[0].width, texture.target == kGL_TEXTURE_1D ? 0 : texture.levels[0].height);
    Interval along_x(glm::length(size * place.per_x)), along_y(glm::length(size * place.per_y));
    for (int across = -1; across <= 1; ++across)
        for (int step = -1; step <= 0; ++step) {
            along_x = hull(along_x, glm::length(size * (at(step + 1, across) - at(step, across))));
            along_y = hull(along_y, glm::length(size * (at(across, step + 1) - at(across, step))));
        }
    const double error = 2 * st_error * std::max(size.x, size.y);
    return {std::max(0.0, std::max(along_x.low, along_y.low) - error), std::max(along_x.high, along_y.high) + error};
}

constexpr int kR = 2;

// `str`: the direction, times a factor.
TexturePlace place_of(const Linear3& str, const CubePlace& on_face) {
    TexturePlace place{.st = on_face.st, .face = on_face.face};
    const auto change = [&](const glm::dvec3& d) {  // the quotient rule
        const double of_major = on_face.signs[2] * d[on_face.axes[2]];
        glm::dvec2 result;
        for (int i = 0; i < 2; ++i) {
            const auto n = static_cast<std::size_t>(i);
            const double of_part = on_face.signs[n] * d[on_face.axes[n]];
            result[i] = quotient((of_part - (2 * on_face.st[i] - 1) * of_major) / 2, on_face.major);
        }
        return result;
    };
    place.per_x = change(str.per_x);
    place.per_y = change(str.per_y);
    return place;
}

}  // namespace

TexCoords::OfSprite TexCoords::of_sprite(const Piece& piece, const glm::dvec2& position_window) const {
    const double change = 1 / piece.sprite_size, up = sprite_origin_ == kGL_LOWER_LEFT ? change : -change;
    const glm::dvec2 way = position_window - glm::dvec2(piece.ends().from.position_window);
    return {.st = 0.5 + way * glm::dvec2(change, up), .per_x = {change, 0}, .per_y = {0, up}};
}

std::vector<TexturePlaceBounds> cube_place_bounds(const TexCoords& tex_coords, const Piece& piece,
                                                  const glm::dvec2& position_window, const Texture& texture,
                                                  double vertex_error) {
    constexpr double kRoundings = 8 * 0x1p-24;
    const Linear3 str = stq_over_w(tex_coords, piece, position_window, kR);
    const glm::dvec3 weights = glm::abs(weights_over_w_at(piece, position_window).value);
    const glm::dvec3 error = kRoundings * (glm::abs(str.value) + glm::abs(str.per_x) * std::abs(position_window.x) +
                                           glm::abs(str.per_y) * std::abs(position_window.y)) +
                             kSnap * (glm::abs(str.per_x) + glm::abs(str.per_y)) +
                             vertex_error * (weights.x + weights.y + weights.z);
    const glm::dvec3 least = glm::abs(str.value) - error;
    const double major = std::max({least.x, least.y, least.z});
    std::vector<TexturePlaceBounds> bounds;
    for (std::size_t face = 0; face < texture.face_count(); ++face) {
        const CubePlace on_face = place_on_face(str.value, face);
        const double of_major = error[on_face.axes[2]];
        if (on_face.major <= 0 || on_face.major + of_major < major) continue;
        TexturePlace place = place_of(str, on_face);
        place.of_point = has_no_change(tex_coords, piece);
        TexturePlaceBounds one{.st = glm::clamp(on_face.st, 0.0, 1.0), .face = face};
        for (int i = 0; i < 2; ++i)
            one.st_error[i] = quotient(
                (error[on_face.axes[static_cast<std::size_t>(i)]] + std::abs(2 * on_face.st[i] - 1) * of_major) / 2,
                on_face.major);
        one.change = glm::abs(place.per_x) + glm::abs(place.per_y);
        const double rho = scale_factor(texture, place);
        one.rho = place.of_point ? Interval(rho) : Interval(rho / 2, 2 * rho);
        bounds.push_back(one);
    }
    if (bounds.empty()) {  // the direction is 0
        const TexturePlace place = texture_place(tex_coords, piece, position_window, texture);
        bounds.push_back({.st = place.st, .rho = Interval(scale_factor(texture, place)), .face = place.face});
    }
    return bounds;
}

TexturePlace texture_place(const TexCoords& tex_coords, const Piece& piece, const glm::dvec2& position_window,
                           const Texture& texture) {
    if (texture.is_cube()) {
        const Linear3 str = stq_over_w(tex_coords, piece, position_window, kR);
        TexturePlace place = place_of(str, cube_place(str.value));
        place.of_point = has_no_change(tex_coords, piece);
        return place;
    }
    const Linear3 stq = stq_over_w(tex_coords, piece, position_window);
    TexturePlace place{.st = divided(stq.value), .of_point = has_no_change(tex_coords, piece)};
    const auto change = [&](const glm::dvec3& d) {  // the quotient rule
        return glm::dvec2(quotient(d.x - place.st.x * d.z, stq.value.z), quotient(d.y - place.st.y * d.z, stq.value.z));
    };
    place.per_x = change(stq.per_x);
    place.per_y = change(stq.per_y);
    if (texture.compares()) place.r = quotient(stq_over_w(tex_coords, piece, position_window, kR).value.z, stq.value.z);
    return place;
}

lighting::RulingSet texture_rulings(const TexCoords& tex_coords, const Piece& piece,
                                    const glm::dvec2& position_window) {
    using lighting::Marked;
    const glm::dvec3 stq = stq_over_w(tex_coords, piece, position_window).value;
    const Marked s = quotient(Marked(stq.x), Marked(stq.z)), t = quotient(Marked(stq.y), Marked(stq.z));
    return countable(s).rulings | countable(t).rulings;
}

TexturePlaceBounds texture_place_bounds(const TexCoords& tex_coords, const Piece& piece,
                                        const glm::dvec2& position_window, const Texture& texture,
                                        double vertex_error) {
    // Float arithmetic: the rounding of the texture matrix, of the plane (a constant plus slope times pixel number) and
    // of the division, each at most half a unit in the last place of the magnitudes added.
    constexpr double kRoundings = 8 * 0x1p-24;
    const TexturePlace place = texture_place(tex_coords, piece, position_window, texture);
    Linear3 stq = stq_over_w(tex_coords, piece, position_window);
    const glm::dvec3 added_up = glm::abs(stq.value) + glm::abs(stq.per_x) * std::abs(position_window.x) +
                                glm::abs(stq.per_y) * std::abs(position_window.y);
    const double q = std::abs(stq.value.z);
    glm::dvec2 arithmetic = kRoundings * glm::dvec2(quotient(added_up.x + std::abs(place.st.x) * added_up.z, q),
                                                    quotient(added_up.y + std::abs(place.st.y) * added_up.z, q));
    double of_vertices = 0;
    if (vertex_error > 0) {
        const glm::dvec3 weights = glm::abs(weights_over_w_at(piece, position_window).value);
        of_vertices = quotient(vertex_error * (weights.x + weights.y + weights.z), q);
        for (int i = 0; i < 2; ++i) arithmetic[i] += of_vertices * (1 + std::abs(place.st[i]));
    }

    TexturePlaceBounds bounds{.st = place.st,
                              .st_error = arithmetic + kSnap * (glm::abs(place.per_x) + glm::abs(place.per_y)),
                              .rho = Interval(scale_factor(texture, place)),
                              .change = glm::abs(place.per_x) + glm::abs(place.per_y)};
    if (texture.compares()) {  // as s and t
        const Linear3 str = stq_over_w(tex_coords, piece, position_window, kR);
        const auto magnitude = [&](const Linear3& one) {
            return std::abs(one.value.z) + std::abs(one.per_x.z * position_window.x) +
                   std::abs(one.per_y.z * position_window.y);
        };
        const auto change = [&](const glm::dvec3& of_r, const glm::dvec3& of_q) {
            return std::abs(quotient(of_r.z - place.r * of_q.z, q));
        };
        const double error = kRoundings * quotient(magnitude(str) + std::abs(place.r) * magnitude(stq), q) +
                             of_vertices * (1 + std::abs(place.r)) +
                             kSnap * (change(str.per_x, stq.per_x) + change(str.per_y, stq.per_y));
        bounds.r = {place.r - error, place.r + error};
    }
    const bool has_one_image = level_choice(texture.min_filter) == LevelChoice::kBase &&
                               image_filter(texture.min_filter) == texture.mag_filter;
    if (place.of_point || (has_one_image && texture.max_anisotropy <= 1)) return bounds;  // then rho decides nothing
    const double st_error = std::max(arithmetic.x, arithmetic.y);
    bounds.rho = rho_of_differences(texture, stq, place, st_error);
    if (piece.shape == Shape::kLine) {
        // 3.8.8 uses the change along the line; drivers use the change along its longer axis, x or y.
        const glm::dvec2 way =
            glm::abs(glm::dvec2(piece.ends().to.position_window - piece.ends().from.position_window));
        const double longer = quotient(glm::length(way), std::max(way.x, way.y));
        stq.per_x *= longer;
        bounds.rho = hull(bounds.rho, rho_of_differences(texture, stq, place, st_error));
    }
    return bounds;
}

}  // namespace twinlight::reference
