#include "app/session/merge.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "app/session/alignment.h"

namespace twinlight::session {
namespace {

using TextLines = std::span<const std::string_view>;

// With their line feeds, so that a last line without one differs.
std::vector<std::string_view> lines_of(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t length = std::min(text.find('\n'), text.size() - 1) + 1;
        lines.push_back(text.substr(0, length));
        text.remove_prefix(length);
    }
    return lines;
}

bool same_lines(TextLines a, TextLines b) { return std::equal(a.begin(), a.end(), b.begin(), b.end()); }

// The side that changed the lines; both if they agree. Lines that both changed are merged one by one where their number is the same.
bool add_part(std::string& result, TextLines base, TextLines mine, TextLines theirs) {
    const auto add = [&result](TextLines lines) {
        for (const std::string_view line : lines) result += line;
        return true;
    };
    if (same_lines(mine, base) || same_lines(mine, theirs)) return add(theirs);
    if (same_lines(theirs, base)) return add(mine);
    if (base.size() < 2 || mine.size() != base.size() || theirs.size() != base.size()) return false;
    for (std::size_t i = 0; i < base.size(); ++i)
        if (!add_part(result, base.subspan(i, 1), mine.subspan(i, 1), theirs.subspan(i, 1))) return false;
    return true;
}

// For each line of the base its partner.
std::vector<std::optional<std::size_t>> partners_of(TextLines base, TextLines changed) {
    return aligned(changed.size(), base.size(), [&](std::size_t a, std::size_t b) { return changed[a] == base[b]; });
}

}  // namespace

std::optional<std::string> merged(std::string_view base, std::string_view mine, std::string_view theirs) {
    const std::vector<std::string_view> all_base = lines_of(base), all_mine = lines_of(mine),
                                        all_theirs = lines_of(theirs);
    const TextLines base_lines = all_base, mine_lines = all_mine, theirs_lines = all_theirs;
    const auto in_mine = partners_of(base_lines, mine_lines), in_theirs = partners_of(base_lines, theirs_lines);
    std::string result;
    std::size_t b = 0, m = 0, t = 0;  // what is not merged yet starts here
    for (std::size_t i = 0; i <= base_lines.size(); ++i) {
        const bool is_end = i == base_lines.size();
        if (!is_end && !(in_mine[i] && in_theirs[i])) continue;
        const std::size_t mine_end = is_end ? mine_lines.size() : *in_mine[i];
        const std::size_t theirs_end = is_end ? theirs_lines.size() : *in_theirs[i];
        if (!add_part(result, base_lines.subspan(b, i - b), mine_lines.subspan(m, mine_end - m),
                      theirs_lines.subspan(t, theirs_end - t)))
            return {};
        if (!is_end) result += base_lines[i];
        b = i + 1;
        m = mine_end + 1;
        t = theirs_end + 1;
    }
    return result;
}

}  // namespace twinlight::session
