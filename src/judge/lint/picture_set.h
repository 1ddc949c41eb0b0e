// The pictures of a scene, as the linter sees them: used only by lint.cpp and tried.cpp.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "judge/lint/lint.h"

namespace twinlight::lint {

// The last picture of a recording; nullopt where it cannot be drawn.
std::optional<Frame> last_frame(const Recording& recording, int width, int height);

// The warnings of all pictures, before comments silence them and equal ones are joined. Those that do not hold in each picture say
// when.
std::vector<Warning> warnings_of_all_pictures(const Scene& scene, std::span<const LaterScene> later);

// Whether both are of the same rule and statement, and about the same. Calls of a recording without places of its source are one
// statement.
bool is_same_mistake(const Warning& a, const Warning& b);

}  // namespace twinlight::lint
