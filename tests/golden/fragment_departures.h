// The scenes that show where the driver leaves the text on the way from vertices to pixels.
#pragma once

#include <string_view>
#include <vector>

namespace twinlight {

struct FragmentCase {
    std::string_view name;  // in golden/known_differences
    const char* scene;
};
const std::vector<FragmentCase>& fragment_cases();

}  // namespace twinlight
