// The same scene, said otherwise: display lists, vertex arrays, attribute stacks and matrix stacks, where none of them may
// change the picture.
#pragma once

#include "judge/fuzz/random.h"
#include "scene/command/command.h"

namespace twinlight::fuzz {

CommandList disguised(const CommandList& scene, Random& random);

}  // namespace twinlight::fuzz
