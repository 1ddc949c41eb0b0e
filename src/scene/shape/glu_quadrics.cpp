// The quadrics of GLU 9.0.2 (its src/libutil/quad.c), call by call. GLU computes in float, this code in double;
// tests/window/glu_quadrics_test.cpp bounds the difference by the rounding of floats.
//
// Angles around z start at +y and turn towards +x. Three visible details of GLU that its specification does not mention
// are copied: more than 239 slices (for a sphere also stacks) become 239; with GLU_INSIDE the normals of a cylinder
// keep their z; with GLU_FLAT the first vertices of a sphere are sent before the first normal, so they have the normal
// that was current before.
//
// RULING: GLU 9.0.2 reads uninitialised normals for GLU_FLAT with GLU_POINT (sphere and cylinder) or GLU_SILHOUETTE
// (the lines along a cylinder, all lines of a sphere). Here points get the normals of the surface, silhouettes those of
// GLU_LINE.
#include "scene/shape/glu_quadrics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "base/text/translation.h"

namespace twinlight {
namespace {

constexpr int kMostSlices = 239;

// Collects the commands between glBegin and glEnd into parts.
class Sender {
  public:
    explicit Sender(const Quadric& quadric) : quadric_(quadric) {}

    void begin(Enum mode) {
        ShapePart part{mode, {}, {}};
        part.sends_tex_coords = quadric_.texture;
        part.immediate = true;
        parts_.push_back(std::move(part));
    }
    void normal(const glm::dvec3& normal) {
        normal_ = normal;
        has_normal_ = true;
    }
    void vertex(const glm::dvec3& position, const glm::dvec2& tex_coord) {
        ShapePart& part = parts_.back();
        part.vertices.push_back({position, normal_, quadric_.texture ? tex_coord : glm::dvec2(0)});
        if (!has_normal_) part.first_normal = part.vertices.size();
    }

    bool is(Enum choice) const {
        return choice == quadric_.normals || choice == quadric_.orientation || choice == quadric_.draw_style;
    }
    // The sign of the normals: 1 for GLU_OUTSIDE, -1 for GLU_INSIDE.
    double side() const { return is(kGLU_OUTSIDE) ? 1 : -1; }

    std::vector<ShapePart> parts() { return std::move(parts_); }

  private:
    const Quadric& quadric_;
    std::vector<ShapePart> parts_;
    glm::dvec3 normal_{0};
    bool has_normal_ = false;
};

void refuse_unless(bool allowed, std::string_view name, std::string_view needs) {
    if (!allowed) throw std::invalid_argument(tr("{} needs {}", name, tr(needs)));
}

// (sin, cos) of step i of n in a full turn; i need not be whole.
glm::dvec2 around(double i, int n) {
    const double angle = 2 * std::numbers::pi * i / n;
    return {std::sin(angle), std::cos(angle)};
}

double fraction(int i, int n) { return static_cast<double>(i) / n; }

// ---- The sphere: slices around z, stacks from the pole at +z to the pole at -z ----

class Sphere : public Sender {
  public:
    Sphere(const Quadric& quadric, double radius, int slices, int stacks)
        : Sender(quadric), radius_(radius), slices_(slices), stacks_(stacks) {}

    void fill(bool with_fans) {
        if (with_fans) {
            fan(0, 1, is(kGLU_OUTSIDE));
            fan(stacks_, stacks_ - 1, !is(kGLU_OUTSIDE));
        }
        for (int j = with_fans ? 1 : 0; j < stacks_ - (with_fans ? 1 : 0); ++j) {
            const int first = is(kGLU_OUTSIDE) ? j + 1 : j, second = is(kGLU_OUTSIDE) ? j : j + 1;
            begin(kGL_QUAD_STRIP);
            for (int i = 0; i <= slices_; ++i) {
                send(i, first, is(kGLU_SMOOTH));
                if (is(kGLU_FLAT)) normal_at(i - 0.5, j + 0.5);
                send(i, second, is(kGLU_SMOOTH));
            }
        }
    }

    void points() {
        begin(kGL_POINTS);
        for (int j = 0; j <= stacks_; ++j) {
            for (int i = 0; i < slices_; ++i) send(i, j, !is(kGLU_NONE));
        }
    }

    void lines() {
        for (int j = 1; j < stacks_; ++j) {
            begin(kGL_LINE_STRIP);
            for (int i = 0; i <= slices_; ++i) {
                if (is(kGLU_FLAT)) normal_at(i - 0.5, j);
                send(i, j, is(kGLU_SMOOTH));
            }
        }
        for (int i = 0; i < slices_; ++i) {
            begin(kGL_LINE_STRIP);
            for (int j = 0; j <= stacks_; ++j) {
                if (is(kGLU_FLAT)) normal_at(i, j - 0.5);
                send(i, j, is(kGLU_SMOOTH));
            }
        }
    }

  private:
    glm::dvec3 unit_at(double slice, double stack) const {
        const glm::dvec2 turn = around(slice, slices_);
        const double polar_angle = std::numbers::pi * stack / stacks_;
        const bool at_pole = stack == 0 || stack == stacks_;
        const double from_axis = at_pole ? 0 : std::sin(polar_angle);
        return {from_axis * turn.x, from_axis * turn.y, std::cos(polar_angle)};
    }
    void normal_at(double slice, double stack) { normal(side() * unit_at(slice, stack)); }
    void send(int slice, int stack, bool with_normal) {
        if (with_normal) normal_at(slice, stack);
        vertex(radius_ * unit_at(slice, stack), {1 - fraction(slice, slices_), 1 - fraction(stack, stacks_)});
    }

    // A fan around a pole, in either direction.
    void fan(int pole, int rim, bool backwards) {
        begin(kGL_TRIANGLE_FAN);
        send(0, pole, is(kGLU_SMOOTH));
        for (int n = 0; n <= slices_; ++n) {
            const int i = backwards ? slices_ - n : n;
            // In the backward direction, a facet's normal is sent with its second corner on the rim.
            if (is(kGLU_FLAT) && !(backwards && n == 0)) {
                normal_at(backwards ? i + 0.5 : i - 0.5, (pole + rim) / 2.0);
            }
            send(i, rim, is(kGLU_SMOOTH));
        }
    }

    double radius_;
    int slices_, stacks_;
};

// ---- The cylinder: slices around z, stacks from z = 0 up ----

class Cylinder : public Sender {
  public:
    Cylinder(const Quadric& quadric, double base, double top, double height, int slices, int stacks)
        : Sender(quadric), base_(base), top_(top), height_(height), slices_(slices), stacks_(stacks) {
        const double slant = std::hypot(base - top, height);
        outward_ = side() * height / slant;
        upward_ = (base - top) / slant;
    }

    void fill() {
        for (int j = 0; j < stacks_; ++j) {
            begin(kGL_QUAD_STRIP);
            for (int i = 0; i <= slices_; ++i) {
                facet_or_own_normal(i);
                send(i, is(kGLU_OUTSIDE) ? j : j + 1);
                send(i, is(kGLU_OUTSIDE) ? j + 1 : j);
            }
        }
    }

    void points() {
        begin(kGL_POINTS);
        for (int i = 0; i < slices_; ++i) {
            if (!is(kGLU_NONE)) normal_at(i, upward_);
            for (int j = 0; j <= stacks_; ++j) send(i, j);
        }
    }

    void lines(bool silhouette) {
        for (int j = 1; j < stacks_ && !silhouette; ++j) ring(j);
        ring(0);
        ring(stacks_);
        for (int i = 0; i < slices_; ++i) {
            if (!is(kGLU_NONE)) normal_at(i, 0);
            begin(kGL_LINE_STRIP);
            for (int j = 0; j <= stacks_; ++j) send(i, j);
        }
    }

  private:
    void normal_at(double slice, double z) {
        const glm::dvec2 turn = around(slice, slices_);
        normal({outward_ * turn.x, outward_ * turn.y, z});
    }
    void facet_or_own_normal(int slice) {
        if (is(kGLU_FLAT)) normal_at(slice - 0.5, upward_);
        if (is(kGLU_SMOOTH)) normal_at(slice, upward_);
    }
    void ring(int stack) {
        begin(kGL_LINE_STRIP);
        for (int i = 0; i <= slices_; ++i) {
            facet_or_own_normal(i);
            send(i, stack);
        }
    }
    void send(int slice, int stack) {
        const glm::dvec2 turn = around(slice, slices_);
        const double up = fraction(stack, stacks_), radius = base_ + (top_ - base_) * up;
        vertex({radius * turn.x, radius * turn.y, height_ * up}, {1 - fraction(slice, slices_), up});
    }

    double base_, top_, height_;
    int slices_, stacks_;
    double outward_ = 0, upward_ = 0;
};

// ---- The disk: slices of the sweep, loops from the outer radius inwards ----

class Disk : public Sender {
  public:
    Disk(const Quadric& quadric, double inner, double outer, int slices, int loops, double start_deg, double sweep_deg)
        : Sender(quadric), inner_(inner), outer_(outer), slices_(slices), loops_(loops) {
        start_deg_ = start_deg + std::min(sweep_deg, 0.0);
        sweep_deg_ = std::abs(sweep_deg);
        if (!is(kGLU_NONE)) normal({0, 0, side()});
    }

    void fill() {
        int strips = loops_;
        if (inner_ == 0) {
            --strips;
            begin(kGL_TRIANGLE_FAN);
            vertex({0, 0, 0}, {0.5, 0.5});
            for (int n = 0; n <= slices_; ++n) send(is(kGLU_OUTSIDE) ? slices_ - n : n, loops_ - 1);
        }
        for (int j = 0; j < strips; ++j) {
            begin(kGL_QUAD_STRIP);
            for (int i = 0; i <= slices_; ++i) {
                send(i, is(kGLU_OUTSIDE) ? j : j + 1);
                send(i, is(kGLU_OUTSIDE) ? j + 1 : j);
            }
        }
    }

    void points() {
        begin(kGL_POINTS);
        for (int i = 0; i < spokes(); ++i) {
            for (int j = 0; j <= loops_; ++j) send(i, j);
        }
    }

    void lines() {
        if (inner_ == outer_) return ring(0);
        for (int j = 0; j <= loops_; ++j) ring(j);
        for (int i = 0; i < spokes(); ++i) spoke(i);
    }

    void silhouette() {
        if (sweep_deg_ < kTurn) {
            spoke(0);
            spoke(slices_);
        }
        ring(0);
        if (inner_ != outer_) ring(loops_);
    }

    static constexpr double kTurn = 360;

  private:
    int spokes() const { return sweep_deg_ == kTurn ? slices_ : slices_ + 1; }
    void ring(int loop) {
        begin(kGL_LINE_STRIP);
        for (int i = 0; i <= slices_; ++i) send(i, loop);
    }
    void spoke(int slice) {
        begin(kGL_LINE_STRIP);
        for (int j = 0; j <= loops_; ++j) send(slice, j);
    }
    void send(int slice, int loop) {
        const double angle = (start_deg_ + sweep_deg_ * fraction(slice, slices_)) / 180 * std::numbers::pi;
        const glm::dvec2 turn(std::sin(angle), std::cos(angle));
        const double radius = outer_ - (outer_ - inner_) * fraction(loop, loops_);
        // The texture covers the square around the disk.
        vertex({radius * turn.x, radius * turn.y, 0}, radius / outer_ / 2 * turn + 0.5);
    }

    double inner_, outer_;
    int slices_, loops_;
    double start_deg_ = 0, sweep_deg_ = 0;
};

}  // namespace

std::vector<ShapePart> glu_sphere(const Quadric& quadric, double radius, int slices, int stacks) {
    refuse_unless(slices >= 2 && stacks >= 1 && radius >= 0, "gluSphere", "slices >= 2, stacks >= 1 and radius >= 0");
    Sphere sphere(quadric, radius, std::min(slices, kMostSlices), std::min(stacks, kMostSlices));
    if (sphere.is(kGLU_FILL)) {
        // With a texture there are no fans: at a pole, each slice needs its own texture coordinate.
        sphere.fill(!quadric.texture);
    } else if (sphere.is(kGLU_POINT)) {
        sphere.points();
    } else {
        sphere.lines();
    }
    return sphere.parts();
}

std::vector<ShapePart> glu_cylinder(const Quadric& quadric, double base, double top, double height, int slices,
                                    int stacks) {
    refuse_unless(slices >= 2 && stacks >= 1 && base >= 0 && top >= 0 && height >= 0, "gluCylinder",
                  "slices >= 2, stacks >= 1, and radii and height >= 0");
    const double slant = (base - top) * (base - top) + height * height;
    refuse_unless(slant > 0, "gluCylinder", "a height above 0 or two different radii");
    slices = std::min(slices, kMostSlices);
    limit_shape("gluCylinder", slices, stacks);
    Cylinder cylinder(quadric, base, top, height, slices, stacks);
    if (cylinder.is(kGLU_FILL)) {
        cylinder.fill();
    } else if (cylinder.is(kGLU_POINT)) {
        cylinder.points();
    } else {
        cylinder.lines(cylinder.is(kGLU_SILHOUETTE));
    }
    return cylinder.parts();
}

namespace {

std::vector<ShapePart> disk(std::string_view name, const Quadric& quadric, double inner, double outer, int slices,
                            int loops, double start_deg, double sweep_deg) {
    refuse_unless(slices >= 2 && loops >= 1 && outer > 0 && inner >= 0 && inner <= outer, name,
                  "slices >= 2, loops >= 1, an outer radius above 0, and an inner radius from 0 to the outer one");
    slices = std::min(slices, kMostSlices);
    limit_shape(name, slices, loops);
    if (std::abs(sweep_deg) > Disk::kTurn) sweep_deg = Disk::kTurn;
    Disk result(quadric, inner, outer, slices, loops, start_deg, sweep_deg);
    if (result.is(kGLU_FILL)) {
        result.fill();
    } else if (result.is(kGLU_POINT)) {
        result.points();
    } else if (result.is(kGLU_LINE)) {
        result.lines();
    } else {
        result.silhouette();
    }
    return result.parts();
}

}  // namespace

std::vector<ShapePart> glu_disk(const Quadric& quadric, double inner, double outer, int slices, int loops) {
    return disk("gluDisk", quadric, inner, outer, slices, loops, 0, Disk::kTurn);
}

std::vector<ShapePart> glu_partial_disk(const Quadric& quadric, double inner, double outer, int slices, int loops,
                                        double start_deg, double sweep_deg) {
    return disk("gluPartialDisk", quadric, inner, outer, slices, loops, start_deg, sweep_deg);
}

}  // namespace twinlight
