#include "app/session/alignment.h"

#include <algorithm>

namespace twinlight::session {

std::vector<std::optional<std::size_t>> aligned(std::size_t before, std::size_t after,
                                                const std::function<bool(std::size_t, std::size_t)>& same) {
    constexpr std::size_t kMostCompared = 4'000'000;
    std::vector<std::optional<std::size_t>> partners(after);
    std::size_t start = 0, end_before = before, end_after = after;
    for (; start < std::min(before, after) && same(start, start); ++start) partners[start] = start;
    for (; end_before > start && end_after > start && same(end_before - 1, end_after - 1); --end_before, --end_after)
        partners[end_after - 1] = end_before - 1;
    const std::size_t rows = end_before - start, columns = end_after - start;
    if (rows == 0 || columns == 0 || rows > kMostCompared / columns) return partners;

    // lengths: of the common subsequence of what is left from (row, column) on.
    std::vector<std::size_t> lengths((rows + 1) * (columns + 1), 0);
    const auto length = [&](std::size_t row, std::size_t column) -> std::size_t& {
        return lengths[row * (columns + 1) + column];
    };
    for (std::size_t row = rows; row-- > 0;)
        for (std::size_t column = columns; column-- > 0;)
            length(row, column) = same(start + row, start + column)
                                      ? length(row + 1, column + 1) + 1
                                      : std::max(length(row + 1, column), length(row, column + 1));
    for (std::size_t row = 0, column = 0; row < rows && column < columns;) {
        if (same(start + row, start + column)) {
            partners[start + column++] = start + row++;
        } else if (length(row + 1, column) >= length(row, column + 1)) {
            ++row;
        } else {
            ++column;
        }
    }
    return partners;
}

}  // namespace twinlight::session
