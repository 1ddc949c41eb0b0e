// Shapes are what freeglut sends: mode by mode, vertex by vertex, against a recording of the real library.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "command/command.h"
#include "shape/shape.h"
#include "xvfb.h"

namespace twinlight {
namespace {

const std::vector<std::string> kCalls = {
    "glutSolidCube 1",
    "glutWireCube 1",
    "glutSolidCube 2.5",
    "glutWireCube 0.3",
    "glutSolidCube 0",
    "glutSolidCube -1",
    // slices, stacks: usual, odd, the least that draws, the most that does not
    "glutSolidSphere 1 16 12",
    "glutWireSphere 1 16 12",
    "glutSolidSphere 0.7 7 5",
    "glutWireSphere 0.7 7 5",
    "glutSolidSphere 1 64 32",
    "glutSolidSphere -2 5 3",
    "glutSolidSphere 1 1 2",
    "glutWireSphere 1 1 2",
    "glutSolidSphere 1 2 3",
    "glutSolidSphere 1 3 2",
    "glutWireSphere 1 3 2",
    "glutSolidSphere 1 0 5",
    "glutWireSphere 1 0 5",
    "glutSolidSphere 1 5 1",
    "glutWireSphere 1 5 1",
    "glutSolidSphere 1 5 0",
    "glutSolidSphere 1 5 -3",
    "glutSolidCone 1 2 16 8",
    "glutWireCone 1 2 16 8",
    "glutSolidCone 0.4 0.3 7 1",
    "glutWireCone 0.4 0.3 7 1",
    "glutSolidCone 1 1 1 1",
    "glutWireCone 1 1 1 1",
    "glutSolidCone 1 -2 5 3",
    "glutSolidCone 0 1 4 2",
    "glutSolidCone 1 0 4 2",
    "glutSolidCone 1 1 0 3",
    "glutSolidCone 1 1 5 0",
    "glutWireCone 1 1 5 -1",
    "glutSolidCylinder 1 2 16 4",
    "glutWireCylinder 1 2 16 4",
    "glutSolidCylinder 0.5 0.25 9 1",
    "glutWireCylinder 0.5 0.25 9 1",
    "glutSolidCylinder 1 1 1 1",
    "glutSolidCylinder 1 -1 5 2",
    "glutSolidCylinder 1 1 0 3",
    "glutWireCylinder 1 1 5 0",
    "glutSolidTorus 0.25 1 12 24",
    "glutWireTorus 0.25 1 12 24",
    "glutSolidTorus 0.3 0.5 5 7",
    "glutWireTorus 0.3 0.5 5 7",
    "glutSolidTorus 0.3 0.5 2 2",
    "glutWireTorus 0.3 0.5 2 2",
    "glutSolidTorus 1 0.5 3 4",
    "glutSolidTorus 0.3 0.5 1 5",
    "glutSolidTorus 0.3 0.5 5 1",
    "glutWireTorus 0.3 0.5 0 5",
    "glutWireTorus 0.3 0.5 5 -2",
    // beyond 65535 vertices the 16-bit indices wrap
    "glutSolidSphere 1 300 220",
    "glutSolidTorus 0.3 1 300 220",
};

struct Recording {
    std::string call;
    std::vector<ShapePart> parts;
};

std::vector<Recording> record(const std::string& display) {
    const char* build = std::getenv("TWINLIGHT_BUILD");
    // freeglut frees nothing at exit: a leak checker would call that a failure.
    std::string command =
        "ASAN_OPTIONS=detect_leaks=0 DISPLAY=" + display + " '" + (build ? build : "build") + "/freeglut-recorder'";
    for (const std::string& call : kCalls) command += " '" + call + "'";
    std::FILE* pipe = ::popen((command + " 2>/dev/null").c_str(), "r");
    std::string text;
    if (pipe) {
        std::vector<char> buffer(1 << 16);
        while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe)) text.append(buffer.data(), n);
        EXPECT_EQ(::pclose(pipe), 0) << command;
    }

    std::vector<Recording> recordings;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        if (line.starts_with("call ")) {
            recordings.push_back({line.substr(5), {}});
        } else if (line.starts_with("draw ")) {
            std::string draw;
            ShapePart part;
            words >> draw >> part.mode;
            recordings.back().parts.push_back(part);
        } else {
            ShapeVertex v{};
            words >> v.position_object.x >> v.position_object.y >> v.position_object.z >> v.normal_object.x >>
                v.normal_object.y >> v.normal_object.z;
            EXPECT_TRUE(words) << line;
            recordings.back().parts.back().vertices.push_back(v);
        }
    }
    return recordings;
}

Command parse(const std::string& call) {
    std::istringstream words(call);
    std::string name;
    words >> name;
    Command command;
    command.id = find_command(name).value();
    for (double argument = 0; words >> argument;) command.arguments.push_back(argument);
    return command;
}

// What freeglut's floats can differ from doubles by, relative to the shape's size.
double float_tolerance(const Command& command) {
    constexpr double kHalfUlp = 0x1p-24;
    // An angle is float(pi) / n * i: one rounding each of pi, the quotient and the product.
    constexpr double kAngle = 2 * std::numbers::pi * 3 * kHalfUlp;
    // cos and sin rounded, times one another, times the radius, itself rounded.
    constexpr double kProducts = 5 * kHalfUlp;
    // A cone or cylinder climbs by adding a rounded step for each stack.
    const bool climbs = command.name().ends_with("Cone") || command.name().ends_with("Cylinder");
    const double stacks = climbs ? std::abs(command.arguments.back()) : 0;
    return kAngle + kProducts + 2 * stacks * kHalfUlp;
}

double size_of(const Command& command) {
    const std::size_t counts = command.name().ends_with("Cube") ? 0 : 2;
    double size = 0;
    for (std::size_t i = 0; i + counts < command.arguments.size(); ++i) size += std::abs(command.number(i));
    return size;
}

class FreeglutShapes : public testing::Test {
  protected:
    void SetUp() override {
        if (!server_.running()) GTEST_SKIP() << server_.reason();
    }
    Xvfb server_;
};

TEST_F(FreeglutShapes, AreWhatTheLibrarySends) {
    const std::vector<Recording> recordings = record(server_.display());
    ASSERT_EQ(recordings.size(), kCalls.size());
    double worst = 0;
    for (const Recording& recording : recordings) {
        SCOPED_TRACE(recording.call);
        const Command command = parse(recording.call);
        const std::vector<ShapePart> parts = shape_parts(command);
        ASSERT_EQ(parts.size(), recording.parts.size());
        const double tolerance = float_tolerance(command);
        for (std::size_t p = 0; p < parts.size(); ++p) {
            const ShapePart& ours = parts[p];
            const ShapePart& theirs = recording.parts[p];
            ASSERT_EQ(ours.mode, theirs.mode) << "part " << p;
            const std::size_t count = ours.indices.empty() ? ours.vertices.size() : ours.indices.size();
            ASSERT_EQ(count, theirs.vertices.size()) << "part " << p;
            for (std::size_t i = 0; i < count; ++i) {
                const ShapeVertex& mine = ours.vertices[ours.indices.empty() ? i : ours.indices[i]];
                const ShapeVertex& sent = theirs.vertices[i];
                const double position = glm::distance(mine.position_object, sent.position_object);
                const double normal = glm::distance(mine.normal_object, sent.normal_object);
                ASSERT_LE(position, tolerance * size_of(command)) << "part " << p << " vertex " << i;
                ASSERT_LE(normal, tolerance) << "part " << p << " vertex " << i;
                worst = std::max({worst, normal, size_of(command) > 0 ? position / size_of(command) : 0});
            }
        }
    }
    // The bound is not slack: freeglut's floats are really seen.
    EXPECT_GT(worst, float_tolerance(parse("glutSolidCube 1")) / 20);
    RecordProperty("worst", fmt::format("{:.2g}", worst));
}

}  // namespace
}  // namespace twinlight
