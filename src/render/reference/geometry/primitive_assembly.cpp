#include "render/reference/geometry/primitive_assembly.h"

#include <algorithm>
#include <cassert>
#include <variant>

namespace twinlight::reference {

namespace {

// Collects the primitives. Its arguments are positions in the sequence of sent vertices.
class Assembler {
  public:
    Assembler(const Draw& draw, QuadCut cut) : draw_(draw), cut_(cut) {}

    void point(std::size_t a) { add({.shape = Shape::kPoint, .vertices = {at(a)}, .provoking = at(a)}); }
    void line(std::size_t a, std::size_t b) {
        add({.shape = Shape::kLine, .vertices = {at(a), at(b)}, .provoking = at(b)});
    }
    void triangle(std::size_t a, std::size_t b, std::size_t c, std::size_t provoking,
                  std::array<bool, 3> boundary = {true, true, true}) {
        add({.shape = Shape::kTriangle,
             .vertices = {at(a), at(b), at(c)},
             .provoking = at(provoking),
             .boundary = boundary});
    }
    // The corners in order around the quadrilateral, and whether the edge from each to the next is a boundary edge.
    void quad(std::size_t a, std::size_t b, std::size_t c, std::size_t d, std::size_t provoking,
              std::array<bool, 4> boundary = {true, true, true, true}) {
        const auto [ab, bc, cd, da] = boundary;
        if (cut_ == QuadCut::kFirstToThird) {
            triangle(a, b, c, provoking, {ab, bc, false});
            triangle(a, c, d, provoking, {false, cd, da});
        } else {
            triangle(a, b, d, provoking, {ab, false, da});
            triangle(b, c, d, provoking, {bc, cd, false});
        }
    }
    bool flag(std::size_t i) const { return draw_.vertices[at(i)].edge_flag; }
    std::vector<Primitive> take() { return std::move(primitives_); }

  private:
    std::uint32_t at(std::size_t i) const {
        assert(draw_.index(i) < draw_.vertices.size());
        return draw_.index(i);
    }
    void add(const Primitive& primitive) { primitives_.push_back(primitive); }

    const Draw& draw_;
    const QuadCut cut_;
    std::vector<Primitive> primitives_;
};

}  // namespace

bool is_quadrilaterals(const Draw& draw) { return draw.mode == kGL_QUADS || draw.mode == kGL_QUAD_STRIP; }

bool has_quadrilaterals(const Frame& frame) {
    return std::ranges::any_of(frame.draws(), [](const Draw* draw) { return is_quadrilaterals(*draw); });
}

std::vector<std::size_t> draws_of_quadrilaterals(const Frame& frame) {
    const std::vector<const Draw*> draws = frame.draws();
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < draws.size(); ++i)
        if (is_quadrilaterals(*draws[i])) numbers.push_back(i);
    return numbers;
}

std::vector<Primitive> assemble(const Draw& draw, QuadCut cut) {
    const std::size_t n = draw.count();
    Assembler out(draw, cut);
    switch (draw.mode) {
        case kGL_POINTS:
            for (std::size_t i = 0; i < n; ++i) out.point(i);
            break;
        case kGL_LINES:
            for (std::size_t i = 0; i + 1 < n; i += 2) out.line(i, i + 1);
            break;
        case kGL_LINE_STRIP:
        case kGL_LINE_LOOP:
            for (std::size_t i = 0; i + 1 < n; ++i) out.line(i, i + 1);
            if (draw.mode == kGL_LINE_LOOP && n >= 2) out.line(n - 1, 0);
            break;
        case kGL_TRIANGLES:
            for (std::size_t i = 0; i + 2 < n; i += 3)
                out.triangle(i, i + 1, i + 2, i + 2, {out.flag(i), out.flag(i + 1), out.flag(i + 2)});
            break;
        case kGL_TRIANGLE_STRIP:  // every second triangle is reversed, so that all face the same way
            for (std::size_t i = 0; i + 2 < n; ++i)
                i % 2 == 0 ? out.triangle(i, i + 1, i + 2, i + 2) : out.triangle(i + 1, i, i + 2, i + 2);
            break;
        case kGL_TRIANGLE_FAN:
            for (std::size_t i = 0; i + 2 < n; ++i) out.triangle(0, i + 1, i + 2, i + 2);
            break;
        case kGL_QUADS:
            for (std::size_t i = 0; i + 3 < n; i += 4)
                out.quad(i, i + 1, i + 2, i + 3, i + 3,
                         {out.flag(i), out.flag(i + 1), out.flag(i + 2), out.flag(i + 3)});
            break;
        case kGL_QUAD_STRIP:
            for (std::size_t i = 0; i + 3 < n; i += 2) out.quad(i, i + 1, i + 3, i + 2, i + 3);
            break;
        case kGL_POLYGON:
            for (std::size_t i = 0; i + 2 < n; ++i)
                out.triangle(0, i + 1, i + 2, 0,
                             {i == 0 && out.flag(0), out.flag(i + 1), i + 3 == n && out.flag(i + 2)});
            break;
    }
    return out.take();
}

}  // namespace twinlight::reference
