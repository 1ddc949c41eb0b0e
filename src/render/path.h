// The three renderers of a scene, and which features each of them lacks.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "scene/frame/frame.h"

namespace twinlight {

enum class Path : std::uint8_t { kFixed, kProgrammable, kReference };
inline constexpr std::size_t kPaths = 3;
inline constexpr std::array<Path, kPaths> kAllPaths = {Path::kFixed, Path::kProgrammable, Path::kReference};
inline constexpr std::array<std::string_view, kPaths> kPathNames = {"fixed", "shaders", "reference"};
inline constexpr std::string_view name_of(Path path) { return kPathNames[static_cast<std::size_t>(path)]; }

inline bool lacks(Path path, const Unsupported& item) {
    switch (item.missing_from) {
        case MissingFrom::kFrame: return path != Path::kFixed;
        case MissingFrom::kEverything: return true;
        case MissingFrom::kShaders: return path == Path::kProgrammable;
        case MissingFrom::kFixedFunction: return path == Path::kFixed;
    }
    return false;
}

}  // namespace twinlight
