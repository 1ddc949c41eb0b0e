// The built-in scenes in the order of the lecture.
#pragma once

#include <span>
#include <string_view>

namespace twinlight {

// The names of scenes below a heading. Each built-in scene is in one group.
struct SceneGroup {
    std::string_view heading;
    std::span<const std::string_view> scenes;
};
std::span<const SceneGroup> scene_groups();

}  // namespace twinlight
