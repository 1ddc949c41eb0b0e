// The language of a lesson's checks: a measure, and what it must be.
//
//     condition:  value "at least" NUMBER | value "at most" NUMBER | value "from" NUMBER "to" NUMBER | value "is" NUMBER
//     value:      numbers, measures such as red(40, 40, 60, 60), + - * /, parentheses,
//                 abs(value), min(value, ...), max(value, ...),
//                 at_start(value): in the scene to start from, camera_moved(value): with gluLookAt's camera elsewhere
#pragma once

#include <string>
#include <string_view>

#include "judge/lesson/measures.h"

namespace twinlight::lesson {

struct Condition {
    Measure measure;
    double low = 0, high = 0;

    // Not for NaN.
    bool holds(double value) const { return value >= low && value <= high; }
};

// `folder`: that of the lesson's file, for its pictures. Throws std::runtime_error, which says what is wrong.
Condition read_condition(std::string_view text, const std::string& folder);

}  // namespace twinlight::lesson
