// The current raster position: glRasterPos and glWindowPos (2.13).
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "scene/state/state.h"

namespace twinlight {

namespace {

// A driver computes the position in floats. This is far more than they lose with a window of thousands of pixels.
constexpr double kRasterDoubt = 0.01;  // of a pixel
constexpr double kClipDoubt = 1e-5;    // of the larger of two numbers that are compared

// A number that a driver computes in floats, and whether it finds just this one: without rounding, in whatever order it adds.
// glRasterPos2i(-1, -1) is often meant for the very corner of the window, and is certain there.
struct Computed {
    double value = 0;
    bool is_exact = false;
};

bool is_float(double x) { return static_cast<double>(static_cast<float>(x)) == x; }

Computed operator*(const Computed& a, const Computed& b) {
    const auto is_zero = [](const Computed& x) { return x.is_exact && x.value == 0; };
    const double product = a.value * b.value;
    return {product, is_zero(a) || is_zero(b) || (a.is_exact && b.is_exact && is_float(product))};
}

// If all terms are multiples of a power of two, and their magnitudes add up to less than 2^24 times it, no sum of some of them
// is rounded.
Computed sum(const std::array<Computed, 4>& terms) {
    Computed total{0, true};
    double magnitude = 0, step = HUGE_VAL;
    for (const Computed& term : terms) {
        total = {total.value + term.value, total.is_exact && term.is_exact};
        magnitude += std::abs(term.value);
        if (term.value == 0) continue;
        double last_bit = std::ldexp(1.0, std::ilogb(term.value));
        while (std::fmod(term.value, last_bit) != 0) last_bit /= 2;
        step = std::min(step, last_bit);
    }
    total.is_exact = total.is_exact && (magnitude == 0 || magnitude < 0x1p24 * step);
    return total;
}

struct ComputedMatrix {
    std::array<std::array<Computed, 4>, 4> columns{};

    explicit ComputedMatrix(const glm::dmat4& m) {
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t k = 0; k < 4; ++k) {
                const double x = m[static_cast<int>(i)][static_cast<int>(k)];
                columns[i][k] = {x, is_float(x)};
            }
    }
    std::array<Computed, 4> times(const std::array<Computed, 4>& v) const {
        std::array<Computed, 4> result;
        for (std::size_t k = 0; k < 4; ++k)
            result[k] = sum({columns[0][k] * v[0], columns[1][k] * v[1], columns[2][k] * v[2], columns[3][k] * v[3]});
        return result;
    }
    ComputedMatrix times(const ComputedMatrix& other) const {
        ComputedMatrix result = *this;
        for (std::size_t i = 0; i < 4; ++i) result.columns[i] = times(other.columns[i]);
        return result;
    }
};

// Which of the clip coordinates are exact, whether the driver multiplies the matrices first or the position.
std::array<bool, 4> exact_clip_coordinates(const glm::dmat4& clip_from_eye, const glm::dmat4& eye_from_object,
                                           const glm::dvec4& object) {
    const ComputedMatrix projection(clip_from_eye), modelview(eye_from_object);
    std::array<Computed, 4> position;
    for (std::size_t k = 0; k < 4; ++k)
        position[k] = {object[static_cast<int>(k)], is_float(object[static_cast<int>(k)])};
    const auto one_way = projection.times(modelview.times(position)),
               other = projection.times(modelview).times(position);
    std::array<bool, 4> exact{};
    for (std::size_t k = 0; k < 4; ++k) exact[k] = one_way[k].is_exact && other[k].is_exact;
    return exact;
}

}  // namespace

std::shared_ptr<RasterVertex> State::raster_vertex() const {
    auto raster = std::make_shared<RasterVertex>();
    raster->vertex = a_.current;
    raster->vertex.position_object = {0, 0, 0, 1};
    raster->vertex.material = 0;
    raster->fog_by_coordinates = a_.fog.by_coordinates;
    return raster;
}

// The position is transformed and lit as a vertex is. If the clip volume does not contain it, it is not valid.
void State::raster_pos(const Command& c) {
    const std::shared_ptr<RasterVertex> raster = raster_vertex();
    for (std::size_t i = 0; i < c.arguments.size(); ++i)
        raster->vertex.position_object[static_cast<int>(i)] = c.number(i);
    sanitize(raster->vertex);
    raster->lighting = a_.lighting;
    raster->eye_from_object = modelview();
    raster->clip_from_eye = projection();
    for (std::size_t i = 0; i < raster->units.size(); ++i) {
        raster->units[i].texture_matrix = texture_[i].back().matrix;
        raster->units[i].generated = generated_coordinates(a_.units[i]);
    }
    const glm::dvec4 eye = modelview() * raster->vertex.position_object, clip = projection() * eye;
    RasterPosition& position = a_.raster_position;
    position.is_valid = clip.w > 0;  // RULING: a position with w = 0 has no place in the window
    position.is_doubtful = false;
    const auto must_be_inside = [&](double distance, double size, bool is_exact = false) {
        position.is_valid = position.is_valid && distance >= 0;
        position.is_doubtful |= !is_exact && std::abs(distance) <= kClipDoubt * size;
    };
    const std::array<bool, 4> exact = exact_clip_coordinates(projection(), modelview(), raster->vertex.position_object);
    for (int i = 0; i < 3; ++i)
        must_be_inside(clip.w - std::abs(clip[i]), std::abs(clip.w), exact[static_cast<std::size_t>(i)] && exact[3]);
    for (const ClipPlane& plane : a_.clip_planes) {
        const glm::dvec4 terms = plane.equation_eye * eye;
        if (plane.enabled)
            must_be_inside(terms.x + terms.y + terms.z + terms.w,
                           std::abs(terms.x) + std::abs(terms.y) + std::abs(terms.z) + std::abs(terms.w));
    }
    position.is_doubtful = position.is_doubtful && clip.w > 0;
    position.vertex = raster;
    if (!position.is_valid && !position.is_doubtful) return;
    const glm::dvec3 ndc = glm::dvec3(clip) / clip.w;
    const Rectangle& viewport = a_.raster.viewport;
    const double near = a_.raster.depth_near, far = a_.raster.depth_far;
    position.position_window = {(ndc.x + 1) / 2 * viewport.width + viewport.x,
                                (ndc.y + 1) / 2 * viewport.height + viewport.y, (ndc.z + 1) / 2 * (far - near) + near,
                                clip.w};
    // A corner of the viewport is at a whole pixel.
    const bool at_corner = std::abs(ndc.x) == 1 && std::abs(ndc.y) == 1;
    position.doubt = at_corner && exact[0] && exact[1] && exact[3] ? 0 : kRasterDoubt;
}

// Without matrices, lighting and clipping; the distance for fog is 0.
void State::window_pos(const Command& c) {
    glm::dvec4 window{0, 0, 0, 1};
    for (std::size_t i = 0; i < c.arguments.size(); ++i) window[static_cast<int>(i)] = c.number(i);
    const double near = a_.raster.depth_near, far = a_.raster.depth_far;
    window.z = near + std::clamp(window.z, 0.0, 1.0) * (far - near);
    a_.raster_position = {.position_window = window, .vertex = raster_vertex()};
}

}  // namespace twinlight
