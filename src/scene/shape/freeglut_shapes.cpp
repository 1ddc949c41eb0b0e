// freeglut 3.4's round shapes, with the vertices in freeglut's order.
//
// A round shape is a table of vertices in rings around its axis (z). A solid has one GL_TRIANGLE_STRIP between each
// pair of neighbouring rings; its first pair of vertices is repeated at the end. A wire shape has its meridians, then
// its rings. freeglut computes in float, this code in double; tests/window/freeglut_shapes_test.cpp bounds the
// difference by the rounding of floats. freeglut's indices have 16 bits and wrap beyond 65535 vertices (it warns "too
// many slices or stacks"). This is copied, because it is visible.
#include "scene/shape/freeglut_shapes.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace twinlight {
namespace {

struct CirclePoint {
    double cosine, sine;
};

// Point `i` of `n` around the circle, counter-clockwise or clockwise seen from the positive axis.
CirclePoint circle_point(int i, int n, int direction) {
    const double angle = direction * 2 * std::numbers::pi * i / n;
    return {std::cos(angle), std::sin(angle)};
}
constexpr int kCounterClockwise = 1;
constexpr int kClockwise = -1;

// The vertices first, first + stride, ... of the table: around the axis, along a meridian, or a single one on the axis.
struct Ring {
    std::size_t first = 0;
    int count = 1;
    std::size_t stride = 1;

    std::size_t index(int i) const { return first + static_cast<std::size_t>(i % count) * stride; }
};

class Table {
  public:
    explicit Table(const TakePart& take) : take_(take) {}

    Ring add_point(const ShapeVertex& vertex) {
        add(vertex);
        return {count_ - 1, 1};
    }

    // Adds vertex_at(cosine, sine) for `slices` points clockwise around z.
    template <class VertexAt>
    Ring add_ring(int slices, const VertexAt& vertex_at) {
        const Ring ring{count_, slices};
        for (int i = 0; i < slices; ++i) {
            const auto [cosine, sine] = circle_point(i, slices, kClockwise);
            add(vertex_at(cosine, sine));
        }
        return ring;
    }

    // Once around: vertices of the first and the second ring alternate, and the first pair is repeated.
    void send_strip(const Ring& first, const Ring& second, int slices) {
        open(kGL_TRIANGLE_STRIP);
        part_.vertices.reserve(2 * static_cast<std::size_t>(slices + 1));
        for (int i = 0; i <= slices; ++i) {
            send(first.index(i));
            send(second.index(i));
        }
    }

    void send_loop(const Ring& ring) {
        open(kGL_LINE_LOOP);
        for (int i = 0; i < ring.count; ++i) send(ring.index(i));
    }

    void open(Enum mode) {
        close();
        part_.mode = mode;
    }

    void send(std::size_t index) { part_.vertices.push_back(vertices_[index & kIndexMask]); }

    // After the last part.
    void close() {
        if (part_.vertices.empty()) return;
        is_wanted_ = is_wanted_ && take_(std::move(part_));
        part_ = {};
    }

  private:
    static constexpr std::size_t kIndexMask = 0xffff;  // a GLushort

    void add(const ShapeVertex& vertex) {
        if (count_++ <= kIndexMask) vertices_.push_back(vertex);
    }

    const TakePart& take_;
    std::vector<ShapeVertex> vertices_;  // that an index reaches
    std::size_t count_ = 0;              // of all vertices
    ShapePart part_;
    bool is_wanted_ = true;
};

// The side of a cone or cylinder as wires: one GL_LINES from end to end, and the given rings.
void send_side_wires(Table& table, const std::vector<Ring>& side, std::size_t loops) {
    table.open(kGL_LINES);
    for (int i = 0; i < side.front().count; ++i) {
        table.send(side.front().index(i));
        table.send(side.back().index(i));
    }
    for (std::size_t k = 0; k < loops; ++k) table.send_loop(side[k]);
}

}  // namespace

void freeglut_sphere(double radius, int slices, int stacks, bool wire, const TakePart& take) {
    if (slices < 1 || stacks < 2) return;

    // From the pole at +z to the pole at -z.
    Table table(take);
    std::vector<Ring> rings{table.add_point({{0, 0, radius}, {0, 0, 1}})};
    for (int i = 1; i < stacks; ++i) {
        const double polar_angle = std::numbers::pi * i / stacks;
        rings.push_back(table.add_ring(slices, [&](double cosine, double sine) {
            const glm::dvec3 normal(cosine * std::sin(polar_angle), sine * std::sin(polar_angle),
                                    std::cos(polar_angle));
            return ShapeVertex{radius * normal, normal};
        }));
    }
    rings.push_back(table.add_point({{0, 0, -radius}, {0, 0, -1}}));

    if (!wire) {
        for (std::size_t k = 1; k < rings.size(); ++k) table.send_strip(rings[k], rings[k - 1], slices);
        return table.close();
    }
    for (int i = 0; i < slices; ++i) {
        table.open(kGL_LINE_STRIP);
        for (const Ring& ring : rings) table.send(ring.index(i));
    }
    for (std::size_t k = 1; k + 1 < rings.size(); ++k) table.send_loop(rings[k]);
    return table.close();
}

void freeglut_cone(double base, double height, int slices, int stacks, bool wire, const TakePart& take) {
    if (slices < 1 || stacks < 1) return;

    // The side's normal leans by the slope base / height. It is 0 for a cone of size 0, where freeglut divides by 0.
    const double slant = std::hypot(base, height);
    const double outward = slant == 0 ? 0 : height / slant;
    const double upward = slant == 0 ? 0 : base / slant;

    Table table(take);
    const Ring centre = table.add_point({{0, 0, 0}, {0, 0, -1}});
    const Ring rim = table.add_ring(slices, [&](double cosine, double sine) {
        return ShapeVertex{{base * cosine, base * sine, 0}, {0, 0, -1}};
    });
    std::vector<Ring> side;  // from the base to the apex, where all vertices meet
    for (int k = 0; k <= stacks; ++k) {
        const double up = static_cast<double>(k) / stacks;
        side.push_back(table.add_ring(slices, [&](double cosine, double sine) {
            const double radius = base * (1 - up);
            return ShapeVertex{{radius * cosine, radius * sine, height * up},
                               {outward * cosine, outward * sine, upward}};
        }));
    }

    if (wire) {
        send_side_wires(table, side, side.size() - 1);  // no loop at the apex
        return table.close();
    }
    table.send_strip(centre, rim, slices);
    for (std::size_t k = 1; k < side.size(); ++k) table.send_strip(side[k - 1], side[k], slices);
    return table.close();
}

void freeglut_cylinder(double radius, double height, int slices, int stacks, bool wire, const TakePart& take) {
    if (slices < 1 || stacks < 1) return;

    Table table(take);
    const auto cap_ring = [&](double z, double normal_z) {
        return table.add_ring(slices, [&](double cosine, double sine) {
            return ShapeVertex{{radius * cosine, radius * sine, z}, {0, 0, normal_z}};
        });
    };
    const Ring bottom = table.add_point({{0, 0, 0}, {0, 0, -1}});
    const Ring bottom_rim = cap_ring(0, -1);
    std::vector<Ring> side;
    for (int k = 0; k <= stacks; ++k) {
        const double z = height * k / stacks;
        side.push_back(table.add_ring(slices, [&](double cosine, double sine) {
            return ShapeVertex{{radius * cosine, radius * sine, z}, {cosine, sine, 0}};
        }));
    }
    const Ring top_rim = cap_ring(height, 1);
    const Ring top = table.add_point({{0, 0, height}, {0, 0, 1}});

    if (wire) {
        send_side_wires(table, side, side.size());
        return table.close();
    }
    table.send_strip(bottom, bottom_rim, slices);
    for (std::size_t k = 1; k < side.size(); ++k) table.send_strip(side[k - 1], side[k], slices);
    table.send_strip(top_rim, top, slices);
    return table.close();
}

void freeglut_torus(double inner_radius, double outer_radius, int sides, int rings, bool wire, const TakePart& take) {
    if (sides < 2 || rings < 2) return;

    // inner_radius is the radius of the tube, outer_radius that of the circle along which the tube runs.
    Table table(take);
    for (int ring = 0; ring < rings; ++ring) {
        const CirclePoint turn =
            circle_point(ring, rings, kCounterClockwise);  // not a structured binding: clang 14 cannot capture those
        table.add_ring(sides, [&](double cosine, double sine) {
            const double from_axis = outer_radius + inner_radius * cosine;
            return ShapeVertex{{turn.cosine * from_axis, turn.sine * from_axis, inner_radius * sine},
                               {turn.cosine * cosine, turn.sine * cosine, sine}};
        });
    }
    const auto stride = static_cast<std::size_t>(sides);
    const auto around_tube = [&](int ring) { return Ring{static_cast<std::size_t>(ring) * stride, sides}; };
    const auto around_axis = [&](int side) { return Ring{static_cast<std::size_t>(side), rings, stride}; };

    if (wire) {
        for (int ring = 0; ring < rings; ++ring) table.send_loop(around_tube(ring));
        for (int side = 0; side < sides; ++side) table.send_loop(around_axis(side));
        return table.close();
    }
    for (int side = 0; side < sides; ++side) {
        table.send_strip(around_axis(side), around_axis((side + 1) % sides), rings);
    }
    return table.close();
}

}  // namespace twinlight
