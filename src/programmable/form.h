// Form: what of a program's code the numbers of a Draw decide, beside its effects.
#pragma once

#include <compare>
#include <cstdint>

#include "effect/plan.h"

namespace twinlight::programmable {

// NOLINT below: clang-tidy takes a defaulted <=> for a null pointer.
struct Form {
    // The vertices are lit in object coordinates, to which the lights are brought once: where the modelview matrix keeps
    // angles, no vertex's position and normal need be brought to the lights.
    bool object_space = false;
    bool position_w = true;  // w of a vertex's position may be other than 1

    friend auto operator<=>(const Form&, const Form&) = default;  // NOLINT
};

Form form_of(const Draw& draw, const Plan& plan);

// By what factor the modelview matrix scales lengths, if it turns, mirrors and scales the same in all directions (to
// the precision of floats) and nothing else, or 0.
double similarity_scale(const glm::dmat4& eye_from_object);

}  // namespace twinlight::programmable
