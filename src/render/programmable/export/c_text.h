// Values in C, for scene.c.
#pragma once

#include <string>

#include "scene/frame/frame.h"

namespace twinlight::programmable {

// A scene's name or place, for comments and HTML.
std::string printable(std::string text);

std::string c_number(double x);

// "1, 2, 3"
template <class Vector>
std::string c_numbers(const Vector& v) {
    std::string text;
    for (int i = 0; i < Vector::length(); ++i) text += (i == 0 ? "" : ", ") + c_number(v[i]);
    return text;
}

}  // namespace twinlight::programmable
