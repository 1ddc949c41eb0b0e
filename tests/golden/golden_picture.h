// A picture held to its golden one.
#pragma once

#include <string>

#include "base/image/difference.h"
#include "base/image/image.h"

namespace twinlight {

// Compares with golden/folder/file_name: edges may fall to either side on another driver, and the interior is held to what two
// renderers are held to. If `make golden CASE=name` asks for it, writes the file instead.
void expect_golden(const std::string& name, const std::string& folder, const std::string& file_name, const Image& image,
                   const AllowedDifference& allowed);

// For pictures of the reference alone, where nothing is left to a driver.
AllowedDifference nothing_is_allowed(const Image& image);

}  // namespace twinlight
