// What a check can measure: a number of an answer's picture, its lighting or its commands.
//
// A row is a measure: its name, its parameters, what it is. NaN stands for "cannot be measured" and fails every check.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/image/rectangle.h"
#include "judge/lesson/work.h"

namespace twinlight::lesson {

using Measure = std::function<double(const Work&)>;

enum class ParameterKind : std::uint8_t {
    kBox,  // x, y, width, height in pixels of a picture of 640 x 480, from the top left; may be left out at the end: the whole picture
    kObject,   // the number of an object of the start's scene, from 1, in the order of drawing
    kObjects,  // one or more of them
    kVector,   // x, y, z
    kNumber,
    kText,       // a name, or text in quotes
    kMaybeText,  // the same, or nothing
};

// Arguments as the parameters' kinds have them.
struct MeasureArguments {
    std::vector<Rectangle> boxes{};
    std::vector<int> objects{};     // from 0
    std::vector<double> numbers{};  // a vector's three, too
    std::vector<std::string> texts{};
    std::string folder{};  // of the lesson's file; pictures lie there

    const Rectangle& box() const { return boxes.front(); }
    int object() const { return objects.front(); }
    glm::dvec3 vector() const { return {numbers[0], numbers[1], numbers[2]}; }
};

struct MeasureRow {
    std::string_view name;
    std::vector<ParameterKind> parameters;
    std::string_view what;  // with the names of its parameters
    // Throws std::runtime_error for arguments that have no meaning.
    Measure (*make)(const MeasureArguments&);
};
std::span<const MeasureRow> measures();

}  // namespace twinlight::lesson
