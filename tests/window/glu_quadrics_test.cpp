// Quadrics are what GLU sends: call by call, against a recording of the real library, in every style.
#include "scene/shape/glu_quadrics.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "recording.h"

namespace twinlight::glu_quadrics_test {
namespace {

// Shapes and their sizes; counts usual, odd, the least, and beyond what GLU takes.
const std::vector<std::string> kShapes = {
    "gluSphere 1 16 12",
    "gluSphere 0.7 7 5",
    "gluSphere 2.5 2 1",
    "gluSphere 1 3 2",
    "gluSphere 1 5 9",
    "gluSphere 0 4 3",
    "gluSphere 1 500 3",
    "gluSphere 1 3 300",
    "gluCylinder 1 1 2 16 4",
    "gluCylinder 1 0.5 2 7 3",
    "gluCylinder 0.2 1.5 0.5 5 1",
    "gluCylinder 1 0 3 9 2",
    "gluCylinder 1 0.25 0 6 2",
    "gluCylinder 0 0 1 4 1",
    "gluCylinder 3 2 1 2 1",
    "gluCylinder 1 1 1 300 2",
    "gluDisk 0 1 16 4",
    "gluDisk 0.5 2 7 3",
    "gluDisk 0 1 2 1",
    "gluDisk 1 1 8 3",
    "gluDisk 0 3 300 1",
    "gluPartialDisk 0 1 16 4 0 90",
    "gluPartialDisk 0.25 1 7 3 30 200",
    "gluPartialDisk 0.5 2 5 2 45 -120",
    "gluPartialDisk 0.5 2 5 2 -45 360",
    "gluPartialDisk 0 1 6 2 10 400",
    "gluPartialDisk 0 1 6 2 10 -400",
    "gluPartialDisk 0.5 1 4 1 20 0",
    "gluPartialDisk 1 1 4 2 0 180",
    "gluPartialDisk 0.1 1 9 2 1000 77",
};

const std::vector<std::string> kRefused = {
    "gluSphere 1 1 5",
    "gluSphere 1 5 0",
    "gluSphere -1 5 5",
    "gluSphere 1 -3 5",
    "gluCylinder 1 1 1 1 1",
    "gluCylinder 1 1 1 5 0",
    "gluCylinder -1 1 1 5 1",
    "gluCylinder 1 -1 1 5 1",
    "gluCylinder 1 1 -1 5 1",
    "gluCylinder 1 1 0 5 1",
    "gluCylinder 0 0 0 5 1",
    "gluDisk 0 1 1 1",
    "gluDisk 0 1 5 0",
    "gluDisk 0 0 5 1",
    "gluDisk -1 1 5 1",
    "gluDisk 2 1 5 1",
    "gluDisk 0 -1 5 1",
    "gluPartialDisk 0 1 1 1 0 90",
    "gluPartialDisk 0 1 5 0 0 90",
    "gluPartialDisk 2 1 5 1 0 90",
};

const std::vector<std::string> kNormals = {"GLU_SMOOTH", "GLU_FLAT", "GLU_NONE"};
const std::vector<std::string> kOrientations = {"GLU_OUTSIDE", "GLU_INSIDE"};
const std::vector<std::string> kStyles = {"GLU_FILL", "GLU_LINE", "GLU_SILHOUETTE", "GLU_POINT"};

// "gluSphere 1 16 12" in all styles.
std::vector<std::string> in_every_style(const std::string& shape) {
    const std::size_t name_end = shape.find(' ');
    std::vector<std::string> calls;
    for (const std::string& normals : kNormals) {
        for (const std::string& orientation : kOrientations) {
            for (const std::string& style : kStyles) {
                for (const int texture : {0, 1}) {
                    calls.push_back(fmt::format("{} {} {} {} {}{}", shape.substr(0, name_end), normals, orientation,
                                                style, texture, shape.substr(name_end)));
                }
            }
        }
    }
    return calls;
}

struct Call {
    std::string name;
    Quadric quadric;
    std::vector<double> arguments;
};

Call parse(const std::string& text) {
    std::istringstream words(text);
    Call call;
    std::string normals, orientation, style;
    words >> call.name >> normals >> orientation >> style >> call.quadric.texture;
    call.quadric.normals = find_gl_name(normals).value();
    call.quadric.orientation = find_gl_name(orientation).value();
    call.quadric.draw_style = find_gl_name(style).value();
    for (double argument = 0; words >> argument;) call.arguments.push_back(argument);
    return call;
}

std::vector<ShapePart> parts_of(const Call& call) {
    const Quadric& q = call.quadric;
    const std::vector<double>& a = call.arguments;
    const auto count = [&](std::size_t i) { return static_cast<int>(a[i]); };
    if (call.name == "gluSphere") return glu_sphere(q, a[0], count(1), count(2));
    if (call.name == "gluCylinder") return glu_cylinder(q, a[0], a[1], a[2], count(3), count(4));
    if (call.name == "gluDisk") return glu_disk(q, a[0], a[1], count(2), count(3));
    return glu_partial_disk(q, a[0], a[1], count(2), count(3), a[4], a[5]);
}

// What GLU's floats can differ from doubles by.
Tolerance float_tolerance(const Call& call) {
    constexpr double kHalfUlp = 0x1p-24;
    const std::vector<double>& a = call.arguments;
    const bool partial = call.name == "gluPartialDisk";
    // An angle is a float; of a partial disk so is its start.
    const double largest_angle = 2 * std::numbers::pi + (partial ? std::abs(a[4]) / 180 * std::numbers::pi : 0);
    const double angle = (partial ? 2 : 1) * largest_angle * kHalfUlp;
    // Sine and cosine, radii and their steps, their products, the sum; of a normal the slopes in place of radii.
    constexpr double kProducts = 6 * kHalfUlp;
    const double size = call.name == "gluSphere" ? a[0] : std::max({a[0], a[1], call.name == "gluCylinder" ? a[2] : 0});
    // A texture coordinate lies in [0,1].
    return {(angle + kProducts) * size, angle + kProducts, angle + kProducts};
}

// Where GLU 9.0.2 reads numbers that it has never written (a ruling of glu_quadrics.cpp says what ours are).
bool normal_is_undefined(const Call& call, std::size_t part, std::size_t vertex) {
    const Quadric& q = call.quadric;
    const std::vector<double>& a = call.arguments;
    const bool point = q.draw_style == kGLU_POINT, silhouette = q.draw_style == kGLU_SILHOUETTE;
    if (call.name == "gluSphere") {
        if (q.normals == kGLU_FLAT) return point || silhouette;
        // The second fan's centre: the entry of the last stack in a table of slices.
        return q.normals == kGLU_SMOOTH && q.draw_style == kGLU_FILL && !q.texture && a[2] > a[1] && part == 1 &&
               vertex == 0;
    }
    if (call.name == "gluCylinder") return q.normals == kGLU_FLAT && (point || (silhouette && part >= 2));
    return false;
}

TEST(GluQuadrics, AreWhatTheLibrarySends) {
    double worst = 0;
    int undefined = 0, compared = 0;
    for (const std::string& shape : kShapes) {
        for (RecordedCall& recording : record(in_every_style(shape))) {
            SCOPED_TRACE(recording.call);
            const Call call = parse(recording.call);
            std::vector<SentPart> ours = sent_parts(parts_of(call));
            EXPECT_EQ(recording.error, std::nullopt);
            ASSERT_EQ(recording.parts.size(), ours.size());
            for (std::size_t p = 0; p < ours.size(); ++p) {
                for (std::size_t i = 0; i < std::min(ours[p].vertices.size(), recording.parts[p].vertices.size());
                     ++i) {
                    if (!normal_is_undefined(call, p, i)) continue;
                    ++undefined;
                    recording.parts[p].vertices[i].normal_object = ours[p].vertices[i].normal_object;
                }
            }
            worst =
                std::max(worst, expect_same(ours, recording.parts, [&](auto, auto) { return float_tolerance(call); }));
            ++compared;
        }
    }
    EXPECT_EQ(compared, 48 * static_cast<int>(kShapes.size()));
    EXPECT_GT(undefined, 0);
    EXPECT_GT(worst, 0.2);  // the bound is not slack
    RecordProperty("worst", fmt::format("{:.2g}", worst));
}

TEST(GluQuadrics, AreRefusedWhereTheLibraryRefusesThem) {
    for (const std::string& shape : kRefused) {
        std::vector<std::string> calls = in_every_style(shape);
        for (const RecordedCall& recording : record(calls)) {
            SCOPED_TRACE(recording.call);
            EXPECT_EQ(recording.error, kGLU_INVALID_VALUE);
            EXPECT_TRUE(recording.parts.empty());
            EXPECT_THROW(parts_of(parse(recording.call)), std::invalid_argument);
        }
    }
}

}  // namespace
}  // namespace twinlight::glu_quadrics_test
