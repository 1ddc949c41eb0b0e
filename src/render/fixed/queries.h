// The driver's answers to a scene's queries.
#pragma once

#include <vector>

#include "scene/frame/scene.h"

namespace twinlight::fixed {

// Executes the scene and returns what the driver answers to each of its queries that is_answered() knows, in their order. An
// answer is empty where the driver gives none, or gives names of objects, which are its own.
std::vector<std::vector<double>> answers(const Scene& scene);

}  // namespace twinlight::fixed
