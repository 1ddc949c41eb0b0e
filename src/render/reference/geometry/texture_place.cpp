#include "render/reference/geometry/texture_place.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace twinlight::reference {

namespace {

// s, t, r and q divided by w; they are linear in the window.
struct Coordinates {
    glm::dvec4 value{0}, per_x{0}, per_y{0};
};
Coordinates coordinates_over_w(const TexCoords& tex_coords, const Piece& piece, const glm::dvec2& position_window) {
    if (tex_coords.are_replaced(piece)) {
        const TexCoords::OfSprite at = tex_coords.of_sprite(piece, position_window);
        return {{at.st, 0, 1}, {at.per_x, 0, 0}, {at.per_y, 0, 0}};
    }
    const Linear3 weights = weights_over_w_at(piece, position_window);
    Coordinates result;
    for (int i = 0; i < 3; ++i) {
        const glm::dvec4& t = tex_coords[piece.primitive.vertices[i]];
        result.value += weights.value[i] * t;
        result.per_x += weights.per_x[i] * t;
        result.per_y += weights.per_y[i] * t;
    }
    return result;
}

bool has_no_change(const TexCoords& tex_coords, const Piece& piece) {
    return piece.shape == Shape::kPoint && !tex_coords.are_replaced(piece);
}

glm::dvec3 divided(const glm::dvec4& c) { return {quotient(c.x, c.w), quotient(c.y, c.w), quotient(c.z, c.w)}; }

// The range of rho from differences over any 2 x 2 pixels that include this one, and from the derivatives themselves:
// implementations use differences (3.8.8 allows approximations) and choose the 2 x 2 pixels.
Interval rho_of_differences(const Texture& texture, const Coordinates& over_w, const TexturePlace& place,
                            double error) {
    const auto at = [&](int x, int y) {
        return divided(over_w.value + static_cast<double>(x) * over_w.per_x + static_cast<double>(y) * over_w.per_y);
    };
    const glm::dvec3 size = size_in_texels(texture);
    Interval along_x(glm::length(size * place.per_x)), along_y(glm::length(size * place.per_y));
    for (int across = -1; across <= 1; ++across)
        for (int step = -1; step <= 0; ++step) {
            along_x = hull(along_x, glm::length(size * (at(step + 1, across) - at(step, across))));
            along_y = hull(along_y, glm::length(size * (at(across, step + 1) - at(across, step))));
        }
    const double in_texels = 2 * error * std::max({size.x, size.y, size.z});
    return {std::max(0.0, std::max(along_x.low, along_y.low) - in_texels),
            std::max(along_x.high, along_y.high) + in_texels};
}

// 3.8.8: any function is right that lies between the largest of m_u, m_v and m_w and their sum; m_u is the larger change of u along x
// and y, in texels. The exact rho lies there, too.
Interval approximations_of_rho(const Texture& texture, const TexturePlace& place) {
    const glm::dvec3 m = size_in_texels(texture) * glm::max(glm::abs(place.per_x), glm::abs(place.per_y));
    return {std::max({m.x, m.y, m.z}), m.x + m.y + m.z};
}

// The change of the place on a face by the quotient rule, where the direction changes so.
glm::dvec3 change_on_face(const CubePlace& on_face, const glm::dvec3& of_direction) {
    const double of_major = on_face.signs[2] * of_direction[on_face.axes[2]];
    glm::dvec3 result(0);
    for (int i = 0; i < 2; ++i) {
        const auto n = static_cast<std::size_t>(i);
        const double of_part = on_face.signs[n] * of_direction[on_face.axes[n]];
        result[i] = quotient((of_part - (2 * on_face.st[i] - 1) * of_major) / 2, on_face.major);
    }
    return result;
}

// `over_w`: the direction, times a factor.
TexturePlace place_of(const Coordinates& over_w, const CubePlace& on_face) {
    TexturePlace place{.str = {on_face.st, 0}, .face = on_face.face};
    place.per_x = change_on_face(on_face, glm::dvec3(over_w.per_x));
    place.per_y = change_on_face(on_face, glm::dvec3(over_w.per_y));
    return place;
}

// The range of rho on a face, from differences of the direction over any 2 x 2 pixels that include this one: drivers use these, at any of
// the four. The direction is s, t and r divided by `divisor`, which a driver may divide by before (1/w, or q/w).
struct Divisor {
    double value = 0, per_x = 0, per_y = 0;

    friend bool operator==(const Divisor&, const Divisor&) = default;
};
Interval rho_of_differences(const Texture& texture, const Coordinates& over_w, const Divisor& divisor,
                            std::size_t face) {
    // The directions at this pixel and at the eight around it.
    std::array<std::array<glm::dvec3, 3>, 3> directions{};
    const auto direction = [&](const glm::ivec2& at) -> glm::dvec3& {
        return directions[static_cast<std::size_t>(at.y + 1)][static_cast<std::size_t>(at.x + 1)];
    };
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            const glm::dvec3 str(over_w.value + static_cast<double>(x) * over_w.per_x +
                                 static_cast<double>(y) * over_w.per_y);
            direction({x, y}) = str / (divisor.value + x * divisor.per_x + y * divisor.per_y);
        }
    const glm::dvec3 size = size_in_texels(texture);
    double least = HUGE_VAL, most = 0;
    // The pixel (x, y) of the four whose lower left one is at `corner`.
    const auto add = [&](const glm::ivec2& corner, int x, int y) {
        const CubePlace on_face = place_on_face(direction(corner + glm::ivec2(x, y)), face);
        if (on_face.major <= 0) return;
        const auto change = [&](const glm::ivec2& from, const glm::ivec2& to) {
            return glm::length(size * change_on_face(on_face, direction(to) - direction(from)));
        };
        const std::array across{change(corner, corner + glm::ivec2(1, 0)),
                                change(corner + glm::ivec2(0, 1), corner + glm::ivec2(1, 1))};
        const std::array up{change(corner, corner + glm::ivec2(0, 1)),
                            change(corner + glm::ivec2(1, 0), corner + glm::ivec2(1, 1))};
        for (const double of_row : across)
            for (const double of_column : up) {
                const double one = std::max(of_row, of_column);
                if (!std::isfinite(one)) continue;
                least = std::min(least, one);
                most = std::max(most, one);
            }
    };
    for (int corner_x = -1; corner_x <= 0; ++corner_x)
        for (int corner_y = -1; corner_y <= 0; ++corner_y)
            for (int x = 0; x < 2; ++x)
                for (int y = 0; y < 2; ++y) add({corner_x, corner_y}, x, y);
    return {std::min(least, most), most};
}

// What a float loses of each coordinate: the plane (a constant plus slope times pixel number) and the texture matrix are added up
// from these magnitudes.
glm::dvec4 added_up(const Coordinates& over_w, const glm::dvec2& position_window) {
    return glm::abs(over_w.value) + glm::abs(over_w.per_x) * std::abs(position_window.x) +
           glm::abs(over_w.per_y) * std::abs(position_window.y);
}

}  // namespace

TexCoords::OfSprite TexCoords::of_sprite(const Piece& piece, const glm::dvec2& position_window) const {
    const double change = 1 / piece.sprite_size, up = sprite_origin_ == kGL_LOWER_LEFT ? change : -change;
    const glm::dvec2 way = position_window - glm::dvec2(piece.ends().from.position_window);
    return {.st = 0.5 + way * glm::dvec2(change, up), .per_x = {change, 0}, .per_y = {0, up}};
}

std::vector<TexturePlaceBounds> cube_place_bounds(const TexCoords& tex_coords, const Piece& piece,
                                                  const glm::dvec2& position_window, const Texture& texture,
                                                  const PlaceErrors& errors) {
    constexpr double kRoundings = 8 * 0x1p-24;
    const Coordinates over_w = coordinates_over_w(tex_coords, piece, position_window);
    const glm::dvec3 str(over_w.value);
    const Linear3 weights_over_w = weights_over_w_at(piece, position_window);
    const glm::dvec3 weights = glm::abs(weights_over_w.value);
    const glm::dvec3 error = kRoundings * glm::dvec3(added_up(over_w, position_window)) +
                             errors.snap * glm::dvec3(glm::abs(over_w.per_x) + glm::abs(over_w.per_y)) +
                             errors.vertex * (weights.x + weights.y + weights.z);
    const glm::dvec3 least = glm::abs(str) - error;
    const double major = std::max({least.x, least.y, least.z});
    const auto sum = [](const glm::dvec3& v) { return v.x + v.y + v.z; };
    const Divisor one_over_w{sum(weights_over_w.value), sum(weights_over_w.per_x), sum(weights_over_w.per_y)},
        q_over_w{over_w.value.w, over_w.per_x.w, over_w.per_y.w};
    const auto rho_of_differences = [&](std::size_t face) {
        const Interval rho = reference::rho_of_differences(texture, over_w, one_over_w, face);
        if (q_over_w == one_over_w) return rho;  // q is 1
        return hull(rho, reference::rho_of_differences(texture, over_w, q_over_w, face));
    };
    std::vector<TexturePlaceBounds> bounds;
    for (std::size_t face = 0; face < texture.face_count(); ++face) {
        const CubePlace on_face = place_on_face(str, face);
        const double of_major = error[on_face.axes[2]];
        if (on_face.major <= 0 || on_face.major + of_major < major) continue;
        TexturePlace place = place_of(over_w, on_face);
        place.of_point = has_no_change(tex_coords, piece);
        TexturePlaceBounds one{.str = {glm::clamp(on_face.st, 0.0, 1.0), 0}, .face = face};
        for (int i = 0; i < 2; ++i)
            one.str_error[i] = quotient(
                (error[on_face.axes[static_cast<std::size_t>(i)]] + std::abs(2 * on_face.st[i] - 1) * of_major) / 2,
                on_face.major);
        one.change = glm::abs(place.per_x) + glm::abs(place.per_y);
        const double rho = scale_factor(texture, place);
        one.rho = place.of_point ? Interval(rho) : hull(Interval(rho / 2, 2 * rho), rho_of_differences(face));
        bounds.push_back(one);
    }
    if (bounds.empty()) {  // the direction is 0
        const TexturePlace place = texture_place(tex_coords, piece, position_window, texture);
        bounds.push_back({.str = place.str, .rho = Interval(scale_factor(texture, place)), .face = place.face});
    }
    return bounds;
}

TexturePlace texture_place(const TexCoords& tex_coords, const Piece& piece, const glm::dvec2& position_window,
                           const Texture& texture) {
    const Coordinates over_w = coordinates_over_w(tex_coords, piece, position_window);
    if (texture.is_cube()) {
        TexturePlace place = place_of(over_w, cube_place(glm::dvec3(over_w.value)));
        place.of_point = has_no_change(tex_coords, piece);
        return place;
    }
    TexturePlace place{.str = divided(over_w.value), .of_point = has_no_change(tex_coords, piece)};
    const auto change = [&](const glm::dvec4& d) {  // the quotient rule
        const glm::dvec3 of_str = glm::dvec3(d) - place.str * d.w;
        return divided({of_str, over_w.value.w});
    };
    place.per_x = change(over_w.per_x);
    place.per_y = change(over_w.per_y);
    return place;
}

TexturePlaceBounds surface_place_bounds(const TexturePlace& place, const Texture& texture) {
    constexpr double kBesideCentre = 1e-3;      // of a pixel, by which a ray in floats may miss the centre
    constexpr double kRoundings = 8 * 0x1p-24;  // the angle about the axis, and the texture matrix
    const glm::dvec3 change = glm::abs(place.per_x) + glm::abs(place.per_y);
    return {.str = place.str,
            .str_error = kRoundings * (1.0 + glm::abs(place.str)) + kBesideCentre * change,
            .rho = approximations_of_rho(texture, place),
            .change = change};
}

lighting::RulingSet texture_rulings(const TexCoords& tex_coords, const Piece& piece, const glm::dvec2& position_window,
                                    const Texture& texture) {
    using lighting::Marked;
    const glm::dvec4 over_w = coordinates_over_w(tex_coords, piece, position_window).value;
    const auto rulings_of = [&](double coordinate) {
        return countable(quotient(Marked(coordinate), Marked(over_w.w))).rulings;
    };
    const lighting::RulingSet of_st = rulings_of(over_w.x) | rulings_of(over_w.y);
    return texture.is_volume() ? of_st | rulings_of(over_w.z) : of_st;
}

TexturePlaceBounds texture_place_bounds(const TexCoords& tex_coords, const Piece& piece,
                                        const glm::dvec2& position_window, const Texture& texture,
                                        const PlaceErrors& errors) {
    // Float arithmetic: the rounding of the texture matrix, of the plane (a constant plus slope times pixel number) and
    // of the division, each at most half a unit in the last place of the magnitudes added.
    constexpr double kRoundings = 8 * 0x1p-24;
    const TexturePlace place = texture_place(tex_coords, piece, position_window, texture);
    Coordinates over_w = coordinates_over_w(tex_coords, piece, position_window);
    const glm::dvec4 magnitudes = added_up(over_w, position_window);
    const double q = std::abs(over_w.value.w);
    const glm::dvec3 sizes = glm::abs(place.str);
    glm::dvec3 arithmetic = kRoundings * divided({glm::dvec3(magnitudes) + sizes * magnitudes.w, q});
    if (errors.vertex > 0) {
        const glm::dvec3 weights = glm::abs(weights_over_w_at(piece, position_window).value);
        arithmetic += quotient(errors.vertex * (weights.x + weights.y + weights.z), q) * (1.0 + sizes);
    }

    const glm::dvec3 change = glm::abs(place.per_x) + glm::abs(place.per_y);
    TexturePlaceBounds bounds{.str = place.str,
                              .str_error = arithmetic + errors.snap * change,
                              .rho = Interval(scale_factor(texture, place)),
                              .change = change};
    const bool has_one_image = level_choice(texture.min_filter) == LevelChoice::kBase &&
                               image_filter(texture.min_filter) == texture.mag_filter;
    if (place.of_point || (has_one_image && texture.max_anisotropy <= 1)) return bounds;  // then rho decides nothing
    double error = std::max(arithmetic.x, arithmetic.y);
    if (texture.is_volume()) error = std::max(error, arithmetic.z);
    bounds.rho = rho_of_differences(texture, over_w, place, error);
    if (piece.shape == Shape::kLine) {
        // 3.8.8 uses the change along the line; drivers use the change along its longer axis, x or y.
        const glm::dvec2 way =
            glm::abs(glm::dvec2(piece.ends().to.position_window - piece.ends().from.position_window));
        const double longer = quotient(glm::length(way), std::max(way.x, way.y));
        over_w.per_x *= longer;
        bounds.rho = hull(bounds.rho, rho_of_differences(texture, over_w, place, error));
    }
    if (errors.approximates_rho) {
        const Interval allowed = approximations_of_rho(texture, place);
        const double rho = scale_factor(texture, place);
        bounds.rho = {bounds.rho.low * quotient(allowed.low, rho), bounds.rho.high * quotient(allowed.high, rho)};
    }
    return bounds;
}

}  // namespace twinlight::reference
