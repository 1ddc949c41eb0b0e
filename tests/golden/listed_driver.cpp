#include "listed_driver.h"

#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "render/context/context.h"

namespace twinlight {

bool is_listed_driver() {
    constexpr std::string_view kMeasuredOn = "measured on: ";
    std::ifstream file("golden/known_differences");
    for (std::string line; std::getline(file, line);) {
        if (!line.starts_with(kMeasuredOn)) continue;
        const std::string listed = line.substr(kMeasuredOn.size(), line.find(" (") - kMeasuredOn.size());
        return driver_name().find(listed + '.') != std::string::npos;
    }
    throw std::runtime_error("golden/known_differences does not say on which driver it was measured");
}

}  // namespace twinlight
