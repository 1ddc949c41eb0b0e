// Texts of a program that draws lines and points as rectangles, or smooth points (shaders/rectangles.glsl).
#pragma once

#include <string>
#include <vector>

#include "render/programmable/numbers/form.h"

namespace twinlight::programmable {

// In the vertex shader's main(): moves gl_Position from the vertex to the rectangle's corner. Also sets line_ends_window and
// point_window if the fragment shader needs them. `clip_position`: the statement that has set gl_Position. `clip_distances`: expressions.
std::string corner_text(const Form& form, const std::string& clip_position,
                        const std::vector<std::string>& clip_distances);

// In the fragment shader's main(): discards what is not on the line.
std::string line_text(const Form& form);

// In the fragment shader's main(): multiplies the alpha of smooth lines and points by the share of the pixel that they cover. `size`:
// of points.
std::string coverage_text(const Form& form, const std::string& size);

}  // namespace twinlight::programmable
