// The maps of evaluators (5.1): Bezier curves and surfaces, of vertices and their attributes.
#pragma once

#include <cstddef>
#include <glm/vec4.hpp>
#include <vector>

#include "scene/command/names.h"

namespace twinlight {

inline constexpr int kMaxEvalOrder = 30;  // GL_MAX_EVAL_ORDER: at least 8 (table 6.29); 30 in Mesa

struct EvaluatorMap {
    struct Variable {  // u or v
        int order = 1;
        double first = 0, last = 1;
    };
    Variable u, v;                   // a curve has only u
    int size = 4;                    // the coordinates of a control point
    std::vector<glm::dvec4> points;  // u.order * v.order; those of one u follow each other

    // The value, and its derivatives by u and v before the division by the domain's length.
    struct Value {
        glm::dvec4 value{0}, per_u{0}, per_v{0};
    };
    Value at(double u, double v) const;
};

// The initial map of a target (table 6.24): order 1, one control point. A target that is not one of glMap has size 0.
EvaluatorMap initial_map(Enum target);

}  // namespace twinlight
