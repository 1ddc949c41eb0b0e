// What most tests include, compiled once for all of them (the Makefile's $(BUILD)/tests.h.gch). Each test still includes all that
// it uses: where files are compiled without this one, nothing is missing.
#include <fmt/format.h>
#include <gtest/gtest.h>

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
