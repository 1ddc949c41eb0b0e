// What a failing picture test leaves behind: the two pictures and their amplified difference under build/failed, and the
// ten worst pixels in the test's output.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "base/image/image.h"

namespace twinlight {

testing::AssertionResult picture_failure(const std::string& name, const Image& actual, const Image& expected);

}  // namespace twinlight
