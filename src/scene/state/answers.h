// The answers to glGet* (6.1), from State.
#pragma once

#include <vector>

#include "scene/state/state.h"

namespace twinlight {

// As the query of doubles gives them; empty for names that GL, or Twinlight, does not know.
using Answer = std::vector<double>;

Answer answer(const State& state, Enum pname);  // glGetDoublev; a capability's answer is glIsEnabled's
Answer clip_plane_answer(const State& state, Enum plane);
Answer tex_env_answer(const State& state, Enum target, Enum pname);
Answer tex_gen_answer(const State& state, Enum coord, Enum pname);
Answer tex_parameter_answer(const State& state, Enum target, Enum pname);
Answer tex_level_answer(const State& state, Enum target, int level, Enum pname);

// The queries of lights, materials, capabilities, clip planes, textures and other state, that answer() knows.
bool is_answered(CommandId id);
// What a query of is_answered() returns, in its own type (6.1.2): glGetIntegerv whole numbers, glGetFloatv floats.
Answer answer(const State& state, const Command& query);

}  // namespace twinlight
