// glGet* (6.1) as State answers it: what the tests compare with the driver's answers.
#pragma once

#include <vector>

#include "scene/state/state.h"

namespace twinlight {

// As the query of doubles gives them; empty for names that GL, or Twinlight, does not know.
using Answer = std::vector<double>;

Answer answer(const State& state, Enum pname);  // glGetDoublev; a capability's answer is glIsEnabled's
Answer clip_plane_answer(const State& state, Enum plane);
Answer tex_env_answer(const State& state, Enum target, Enum pname);
Answer tex_parameter_answer(const State& state, Enum target, Enum pname);
Answer tex_level_answer(const State& state, Enum target, int level, Enum pname);

}  // namespace twinlight
