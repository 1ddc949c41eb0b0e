// Which elements of two sequences belong together: the longest common subsequence.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace twinlight::session {

// For each of the `after` elements its partner among the `before` ones; partners are the same and in the same order. Equal
// starts and ends take no time. What is between them is left without partners if it is very long.
std::vector<std::optional<std::size_t>> aligned(std::size_t before, std::size_t after,
                                                const std::function<bool(std::size_t, std::size_t)>& same);

}  // namespace twinlight::session
