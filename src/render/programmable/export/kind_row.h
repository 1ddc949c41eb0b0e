// The rows of kinds.c: what gl_state.c compares with the state, to find the shaders that can draw it.
#pragma once

#include <string>

#include "render/effect/plan.h"
#include "render/programmable/numbers/form.h"
#include "render/programmable/numbers/shader_options.h"

namespace twinlight::programmable {

// The members of a struct ff_kind after its place. `texture`: the target of the Draw's texture; 0: none.
// `by_number`: only ffUseKind() chooses the shaders.
std::string kind_row(const Draw& draw, const Plan& plan, const Code& code, const Options& options, Enum texture,
                     bool by_number);

// Whether the Draw is lit by other equations than GL's (#pragma twinlight), so that no state of GL finds its shaders.
bool is_not_gl(const Plan& plan);

}  // namespace twinlight::programmable
