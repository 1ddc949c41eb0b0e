// The vertex that gives a primitive its colour under flat shading (GL 2.1, section 2.14.7, table 2.12), for each of the
// ten primitive types. Vertex i has the i-th of these colours, so a pixel's colour names its vertex.
#include <gtest/gtest.h>

#include "../small_frames.h"

namespace twinlight::provoking_vertex_test {
namespace {

constexpr int kWide = 30;

glm::dvec4 color_of(int i) { return {(i + 1) / 16.0, 1 - i / 16.0, 0.5, 1}; }

struct Point {
    double x, y;
};

// The number of the vertex whose colour the pixel has; -1 if nothing was drawn there.
class Flat {
  public:
    Flat(Enum mode, const std::vector<Point>& points) {
        std::vector<Vertex> vertices;
        for (const Point& p : points) vertices.push_back(vertex(p.x, p.y, color_of(static_cast<int>(vertices.size()))));
        Draw draw = window_draw(kWide, kWide, mode, vertices);
        draw.lighting.shade_model = kGL_FLAT;
        image_ = reference::render(frame_of(kWide, kWide, {draw}), {});
    }
    int at(int x, int y) const {
        const glm::dvec4 color = pixel(image_, x, y);
        return color == kNothingDrawn ? -1 : static_cast<int>(color.r * 16 - 1 + 0.5);
    }

  private:
    Image image_;
};

TEST(ProvokingVertex, OfAPointIsItself) {
    const Flat flat(kGL_POINTS, {{2.5, 2.5}, {8.5, 3.5}});
    EXPECT_EQ(flat.at(2, 2), 0);
    EXPECT_EQ(flat.at(8, 3), 1);
}

TEST(ProvokingVertex, OfALineIsItsSecond) {
    const Flat flat(kGL_LINES, {{1.2, 2.5}, {9.2, 2.5}, {9.2, 6.5}, {1.2, 6.5}});
    EXPECT_EQ(flat.at(5, 2), 1);
    EXPECT_EQ(flat.at(5, 6), 3);
}

TEST(ProvokingVertex, OfALineStripsSegmentIsItsSecond) {
    const Flat flat(kGL_LINE_STRIP, {{1.2, 2.5}, {9.2, 2.5}, {9.2, 9.5}});
    EXPECT_EQ(flat.at(5, 2), 1);
    EXPECT_EQ(flat.at(9, 6), 2);
    EXPECT_EQ(flat.at(4, 6), -1);
}

TEST(ProvokingVertex, OfALineLoopsClosingSegmentIsTheFirst) {
    const Flat flat(kGL_LINE_LOOP, {{1.2, 2.5}, {9.2, 2.5}, {9.2, 9.5}, {1.2, 9.5}});
    EXPECT_EQ(flat.at(5, 2), 1);
    EXPECT_EQ(flat.at(9, 6), 2);
    EXPECT_EQ(flat.at(5, 9), 3);
    EXPECT_EQ(flat.at(1, 6), 0);
}

TEST(ProvokingVertex, OfATriangleIsItsThird) {
    const Flat flat(kGL_TRIANGLES, {{0, 0}, {10, 0}, {0, 10}, {20, 0}, {30, 0}, {20, 10}});
    EXPECT_EQ(flat.at(2, 2), 2);
    EXPECT_EQ(flat.at(22, 2), 5);
}

TEST(ProvokingVertex, OfATriangleStripIsTheNewestOfEachTriangle) {
    const Flat flat(kGL_TRIANGLE_STRIP, {{0, 0}, {0, 10}, {10, 0}, {10, 10}, {20, 0}});
    EXPECT_EQ(flat.at(2, 2), 2);
    EXPECT_EQ(flat.at(8, 8), 3);
    EXPECT_EQ(flat.at(12, 2), 4);
}

TEST(ProvokingVertex, OfATriangleFanIsTheNewestOfEachTriangle) {
    const Flat flat(kGL_TRIANGLE_FAN, {{0, 0}, {20, 0}, {20, 20}, {0, 20}});
    EXPECT_EQ(flat.at(15, 5), 2);
    EXPECT_EQ(flat.at(5, 15), 3);
}

TEST(ProvokingVertex, OfAQuadIsItsFourth) {
    const Flat flat(kGL_QUADS, {{0, 0}, {10, 0}, {10, 10}, {0, 10}, {20, 0}, {30, 0}, {30, 10}, {20, 10}});
    for (const int offset : {2, 7}) {  // both halves, on either side of any diagonal
        EXPECT_EQ(flat.at(offset, 2), 3);
        EXPECT_EQ(flat.at(offset, 7), 3);
        EXPECT_EQ(flat.at(20 + offset, 2), 7);
        EXPECT_EQ(flat.at(20 + offset, 7), 7);
    }
}

TEST(ProvokingVertex, OfAQuadStripIsTheLastOfEachQuad) {
    const Flat flat(kGL_QUAD_STRIP, {{0, 0}, {0, 10}, {10, 0}, {10, 10}, {20, 0}, {20, 10}});
    for (const int offset : {2, 7}) {
        EXPECT_EQ(flat.at(offset, 2), 3);
        EXPECT_EQ(flat.at(offset, 7), 3);
        EXPECT_EQ(flat.at(10 + offset, 2), 5);
        EXPECT_EQ(flat.at(10 + offset, 7), 5);
    }
}

TEST(ProvokingVertex, OfAPolygonIsItsFirst) {
    const Flat flat(kGL_POLYGON, {{10, 0}, {20, 8}, {16, 20}, {4, 20}, {0, 8}});
    EXPECT_EQ(flat.at(10, 3), 0);
    EXPECT_EQ(flat.at(15, 15), 0);
    EXPECT_EQ(flat.at(4, 12), 0);
}

TEST(ProvokingVertex, ColoursWhatClippingLeavesEvenIfItIsOutside) {
    const Flat flat(kGL_TRIANGLES, {{5, 5}, {20, 5}, {-40, 200}});
    EXPECT_EQ(flat.at(6, 6), 2);
    EXPECT_EQ(flat.at(2, 25), 2);
}

TEST(ProvokingVertex, CountsIndicesInTheOrderTheyAreSent) {
    Draw draw =
        window_draw(kWide, kWide, kGL_TRIANGLES, {vertex(0, 0, kRed), vertex(10, 0, kGreen), vertex(0, 10, kBlue)});
    draw.indices = {1, 2, 0};
    draw.lighting.shade_model = kGL_FLAT;
    EXPECT_EQ(pixel(reference::render(frame_of(kWide, kWide, {draw}), {}), 2, 2), kRed);
}

// ---- Incomplete primitives (2.6.1): remaining vertices are not drawn ----

TEST(Primitives, LeaveOutWhatIsIncomplete) {
    const std::vector<Point> five = {{2, 2}, {25, 3}, {24, 24}, {3, 25}, {12, 12}};
    const struct {
        Enum mode;
        std::size_t sent;
    } cases[] = {{kGL_LINES, 1},     {kGL_LINE_STRIP, 1},     {kGL_LINE_LOOP, 1},
                 {kGL_TRIANGLES, 2}, {kGL_TRIANGLE_STRIP, 2}, {kGL_TRIANGLE_FAN, 2},
                 {kGL_QUADS, 3},     {kGL_QUAD_STRIP, 3},     {kGL_POLYGON, 2}};
    for (const auto& [mode, sent] : cases) {
        const Flat flat(mode, {five.begin(), five.begin() + static_cast<std::ptrdiff_t>(sent)});
        for (int y = 0; y < kWide; ++y)
            for (int x = 0; x < kWide; ++x) ASSERT_EQ(flat.at(x, y), -1) << mode << " at " << x << ',' << y;
    }
}

}  // namespace
}  // namespace twinlight::provoking_vertex_test
