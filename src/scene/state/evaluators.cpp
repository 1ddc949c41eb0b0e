// Evaluators (5.1): glMap defines Bezier curves and surfaces, glMapGrid their grids; glEvalCoord, glEvalPoint and
// glEvalMesh send the vertices that lie on them.
#include "scene/state/evaluators.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "scene/state/state.h"

namespace twinlight {

namespace {

// The values of the Bernstein polynomials of degree order - 1 at t.
std::array<double, kMaxEvalOrder> bernstein(int order, double t) {
    std::array<double, kMaxEvalOrder> b{1};
    for (std::size_t degree = 1; degree < static_cast<std::size_t>(order); ++degree) {
        for (std::size_t i = degree; i > 0; --i) b[i] = t * b[i - 1] + (1 - t) * b[i];
        b[0] *= 1 - t;
    }
    return b;
}

// The derivatives of these polynomials.
std::array<double, kMaxEvalOrder> bernstein_slopes(int order, double t) {
    std::array<double, kMaxEvalOrder> slopes{};
    if (order == 1) return slopes;
    const std::array<double, kMaxEvalOrder> lower = bernstein(order - 1, t);
    for (std::size_t i = 0; i < static_cast<std::size_t>(order); ++i)
        slopes[i] =
            (order - 1) * ((i > 0 ? lower[i - 1] : 0) - (i + 1 < static_cast<std::size_t>(order) ? lower[i] : 0));
    return slopes;
}

double in_domain(const EvaluatorMap::Variable& variable, double at) {
    return (at - variable.first) / (variable.last - variable.first);
}

bool is_of_surfaces(Enum target) { return target >= kGL_MAP2_COLOR_4; }

// The target of the same data for curves.
Enum as_curve(Enum target) { return is_of_surfaces(target) ? target - kGL_MAP2_COLOR_4 + kGL_MAP1_COLOR_4 : target; }

// A point on two variables' grids.
struct GridPoint {
    double u = 0, v = 0;
};

// The points of glEvalMesh2, one list for each primitive.
std::vector<std::vector<GridPoint>> mesh_lines(Enum mode, const Command& c, const MapGrid& u, const MapGrid& v) {
    const auto whole = [&c](std::size_t i) { return static_cast<int>(c.number(i)); };
    const int i1 = whole(1), i2 = whole(2), j1 = whole(3), j2 = whole(4);
    std::vector<std::vector<GridPoint>> lines;
    const auto point = [&](int i, int j) { lines.back().push_back({u.at(i), v.at(j)}); };
    if (mode == kGL_POINT) {
        lines.emplace_back();
        for (int j = j1; j <= j2; ++j)
            for (int i = i1; i <= i2; ++i) point(i, j);
    } else if (mode == kGL_LINE) {
        for (int j = j1; j <= j2; ++j) {
            lines.emplace_back();
            for (int i = i1; i <= i2; ++i) point(i, j);
        }
        for (int i = i1; i <= i2; ++i) {
            lines.emplace_back();
            for (int j = j1; j <= j2; ++j) point(i, j);
        }
    } else {
        for (int j = j1; j < j2; ++j) {
            lines.emplace_back();
            for (int i = i1; i <= i2; ++i) {
                point(i, j);
                point(i, j + 1);
            }
        }
    }
    return lines;
}

// The number of points that a command evaluates. If the range ends at the largest integer, Mesa loops forever.
double evaluated_points(const Command& c) {
    const auto between = [&c](std::size_t from) {
        constexpr double kLargest = 2147483647;
        const double first = c.number(from), last = c.number(from + 1);
        return last == kLargest ? kLargest : std::max(0.0, last - first + 1);
    };
    const double along = between(1);
    return c.id == CommandId::glEvalMesh1 ? along : along * between(3);
}

}  // namespace

EvaluatorMap initial_map(Enum target) {
    EvaluatorMap map;
    map.points = {glm::dvec4(0, 0, 0, 1)};
    switch (as_curve(target)) {
        case kGL_MAP1_COLOR_4: map.points = {glm::dvec4(1)}; break;
        case kGL_MAP1_INDEX:
            map.points = {glm::dvec4(1)};
            map.size = 1;
            break;
        case kGL_MAP1_NORMAL:
            map.points = {glm::dvec4(0, 0, 1, 1)};
            map.size = 3;
            break;
        case kGL_MAP1_TEXTURE_COORD_1: map.size = 1; break;
        case kGL_MAP1_TEXTURE_COORD_2: map.size = 2; break;
        case kGL_MAP1_TEXTURE_COORD_3:
        case kGL_MAP1_VERTEX_3: map.size = 3; break;
        case kGL_MAP1_TEXTURE_COORD_4:
        case kGL_MAP1_VERTEX_4: break;
        default: map.size = 0;
    }
    return map;
}

// p(u', v') is the sum of the control points times the polynomials of u' and of v'; both are 0 and 1 at the ends of the
// domain.
EvaluatorMap::Value EvaluatorMap::at(double at_u, double at_v) const {
    const double s = in_domain(u, at_u), t = v.order == 1 ? 0 : in_domain(v, at_v);
    const auto of_u = bernstein(u.order, s), of_v = bernstein(v.order, t);
    const auto slopes_u = bernstein_slopes(u.order, s), slopes_v = bernstein_slopes(v.order, t);
    Value result;
    std::size_t n = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(u.order); ++i)
        for (std::size_t j = 0; j < static_cast<std::size_t>(v.order); ++j, ++n) {
            result.value += of_u[i] * of_v[j] * points[n];
            result.per_u += slopes_u[i] * of_v[j] * points[n];
            result.per_v += of_u[i] * slopes_v[j] * points[n];
        }
    return result;
}

void State::map1(const Command& c) { set_map(c, false); }
void State::map2(const Command& c) { set_map(c, true); }

void State::set_map(const Command& c, bool two) {
    const Enum target = c.enumerant(0);
    EvaluatorMap map = initial_map(target);
    if (map.size == 0 || is_of_surfaces(target) != two) {
        return raise(kGL_INVALID_ENUM, c, "{} is given {}; expected GL_MAP{}_VERTEX_3, GL_MAP{}_COLOR_4, ...", c.name(),
                     enum_name(target), two ? 2 : 1, two ? 2 : 1);
    }
    const auto take = [&](std::size_t first, EvaluatorMap::Variable& variable, double& stride) {
        variable = {static_cast<int>(c.number(first + 3)), c.number(first), c.number(first + 1)};
        stride = c.number(first + 2);
        if (variable.first == variable.last) {
            raise(kGL_INVALID_VALUE, c, "{} is given a domain that starts and ends at {}", c.name(), variable.first);
        } else if (c.number(first + 3) < 1 || c.number(first + 3) > kMaxEvalOrder) {
            raise(kGL_INVALID_VALUE, c, "{} is given the order {}; it must be from 1 to {}", c.name(),
                  c.number(first + 3), kMaxEvalOrder);
        } else if (stride < map.size) {
            raise(kGL_INVALID_VALUE, c, "{} is given the stride {}; {} has {} numbers a control point", c.name(),
                  stride, enum_name(target), map.size);
        } else {
            return true;
        }
        return false;
    };
    double stride_u = 0, stride_v = 0;
    if (!take(1, map.u, stride_u) || (two && !take(5, map.v, stride_v))) return;
    if (a_.active_unit != 0)
        return raise(kGL_INVALID_OPERATION, c, "{} needs GL_TEXTURE0 as the active texture unit", c.name());
    const std::span<const double> numbers = c.array();
    map.points.clear();
    for (int i = 0; i < map.u.order; ++i)
        for (int j = 0; j < map.v.order; ++j) {
            const auto first = static_cast<std::size_t>(i * stride_u + j * stride_v);
            glm::dvec4 point(0, 0, 0, 1);
            for (int n = 0; n < map.size; ++n) point[n] = numbers[first + static_cast<std::size_t>(n)];
            map.points.push_back(point);
        }
    maps_[target] = std::move(map);
}

std::optional<MapGrid> State::map_grid(const Command& c, std::size_t first) {
    if (c.number(first) >= 1)
        return MapGrid{static_cast<int>(c.number(first)), c.number(first + 1), c.number(first + 2)};
    raise(kGL_INVALID_VALUE, c, "{} is given {} segments; the number must be 1 or more", c.name(), c.number(first));
    return std::nullopt;
}

void State::map_grid1(const Command& c) {
    if (const auto grid = map_grid(c, 0)) a_.grid1 = *grid;
}

void State::map_grid2(const Command& c) {
    const auto u = map_grid(c, 0);
    if (!u) return;
    const auto v = map_grid(c, 3);
    if (!v) return;
    a_.grid2_u = *u;
    a_.grid2_v = *v;
}

// Values that no enabled map gives are the current ones, which stay as they are. A map of more coordinates goes before
// one of fewer.
std::optional<Vertex> State::evaluated(double u, std::optional<double> v) const {
    const Enum first = v ? kGL_MAP2_COLOR_4 : kGL_MAP1_COLOR_4;
    const auto value = [&](Enum curve) -> std::optional<EvaluatorMap::Value> {
        const Enum target = curve - kGL_MAP1_COLOR_4 + first;
        if (!a_.driver_only.contains({target, 0})) return std::nullopt;
        const auto found = maps_.find(target);
        return (found == maps_.end() ? initial_map(target) : found->second).at(u, v.value_or(0));
    };
    const auto first_of = [&](std::initializer_list<Enum> curves) {
        std::optional<EvaluatorMap::Value> result;
        for (const Enum curve : curves)
            if (!result) result = value(curve);
        return result;
    };
    const auto position = first_of({kGL_MAP1_VERTEX_4, kGL_MAP1_VERTEX_3});
    if (!position) return std::nullopt;
    Vertex vertex = a_.current;
    vertex.position_object = position->value;
    if (const auto color = value(kGL_MAP1_COLOR_4)) vertex.color = color->value;
    if (const auto coordinates = first_of(
            {kGL_MAP1_TEXTURE_COORD_4, kGL_MAP1_TEXTURE_COORD_3, kGL_MAP1_TEXTURE_COORD_2, kGL_MAP1_TEXTURE_COORD_1}))
        vertex.tex_coord = coordinates->value;
    if (v && a_.driver_only.contains({kGL_AUTO_NORMAL, 0})) {
        // The derivatives of (x, y, z) / w, times the square of w.
        const auto tangent = [&](const glm::dvec4& change) {
            return glm::dvec3(change) * position->value.w - glm::dvec3(position->value) * change.w;
        };
        const glm::dvec3 across = glm::cross(tangent(position->per_u), tangent(position->per_v));
        const double length = glm::length(across);
        vertex.normal_object = length > 0 ? across / length : glm::dvec3(0);  // RULING: 0 where there is no normal
    } else if (const auto normal = value(kGL_MAP1_NORMAL)) {
        vertex.normal_object = glm::dvec3(normal->value);
    }
    sanitize(vertex);
    return vertex;
}

void State::send_evaluated(const Command& c, double u, std::optional<double> v) {
    if (!open_) return;  // as glVertex
    const std::optional<Vertex> vertex = evaluated(u, v);
    if (!vertex || !has_time(c, 1) || !has_room(c, vertex_bytes(open_->mode, 1))) return;
    open_->vertices.edit().push_back(*vertex);
    fill_columns(*open_, a_.current);
}

void State::eval_coord(const Command& c) {
    send_evaluated(c, c.number(0), c.arguments.size() > 1 ? std::optional(c.number(1)) : std::nullopt);
}

void State::eval_point(const Command& c) {
    const auto whole = [&c](std::size_t i) { return static_cast<int>(c.number(i)); };
    if (c.id == CommandId::glEvalPoint1)
        send_evaluated(c, a_.grid1.at(whole(0)), std::nullopt);
    else
        send_evaluated(c, a_.grid2_u.at(whole(0)), a_.grid2_v.at(whole(1)));
}

void State::eval_mesh(const Command& c) {
    const bool two = c.id == CommandId::glEvalMesh2;
    const Enum mode = c.enumerant(0);
    if (!(two ? known(c, mode, {kGL_POINT, kGL_LINE, kGL_FILL}) : known(c, mode, {kGL_POINT, kGL_LINE}))) return;
    if (!has_time(c, evaluated_points(c))) return;
    if (!evaluated(0, two ? std::optional(0.0) : std::nullopt)) return;  // no map of vertices is enabled
    std::vector<std::vector<GridPoint>> lines;
    if (two) {
        lines = mesh_lines(mode, c, a_.grid2_u, a_.grid2_v);
    } else {
        lines.emplace_back();
        for (int i = static_cast<int>(c.number(1)); i <= static_cast<int>(c.number(2)); ++i)
            lines.back().push_back({a_.grid1.at(i), 0});
    }
    const Enum primitive = mode == kGL_POINT ? kGL_POINTS : mode == kGL_LINE ? kGL_LINE_STRIP : kGL_QUAD_STRIP;
    for (const std::vector<GridPoint>& line : lines) {
        if (line.empty()) continue;
        if (!has_room(c, bytes_of_draw() + vertex_bytes(primitive, line.size()))) return;
        Draw draw = new_draw(primitive, c.place);
        std::vector<Vertex> vertices;
        vertices.reserve(line.size());
        for (const GridPoint& at : line) vertices.push_back(*evaluated(at.u, two ? std::optional(at.v) : std::nullopt));
        for (Vertex& vertex : vertices) vertex.material = 0;
        draw.vertices = std::move(vertices);
        fill_columns(draw, a_.current);
        show(std::move(draw));
    }
}

}  // namespace twinlight
