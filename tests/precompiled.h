// What most tests include, compiled once for all of them (the Makefile's tests-rooms.h.gch). Each test still includes all that
// it uses: with units=files only GoogleTest is in it, and nothing is missing.
#include <gtest/gtest.h>

#ifndef ONLY_GOOGLETEST
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <glm/glm.hpp>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <random>
#include <regex>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/image/file.h"
#include "render/fixed/fixed.h"
#include "render/programmable/programmable.h"
#include "render/reference/reference.h"
#include "scene/command/text.h"
#include "scene/state/frame.h"
#endif
