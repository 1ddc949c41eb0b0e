#include "scene/command/names.h"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

namespace twinlight {

const std::vector<NamedValue>& gl_names() {
    static const std::vector<NamedValue> names = {
#define ENUM(name, value) {"GL_" #name, value},
#define GLU_ENUM(name, value) {"GLU_" #name, value},
#include "scene/command/enums.def"
#undef ENUM
#undef GLU_ENUM
    };
    return names;
}

const std::vector<NamedValue>& words() {
    static const std::vector<NamedValue> all = {
#define WORD(word) {#word, static_cast<Enum>(Word::word)},
#include "scene/command/words.def"
#undef WORD
    };
    return all;
}

namespace {

std::unordered_map<std::string_view, Enum> index_by_name(const std::vector<NamedValue>& names) {
    std::unordered_map<std::string_view, Enum> index;
    for (const NamedValue& row : names) index.emplace(row.name, row.value);
    return index;
}

std::optional<Enum> find(const std::unordered_map<std::string_view, Enum>& index, std::string_view name) {
    const auto found = index.find(name);
    return found == index.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace

std::optional<Enum> find_gl_name(std::string_view name) {
    static const auto index = index_by_name(gl_names());
    return find(index, name);
}

std::optional<Enum> find_gl_name_or_extension(std::string_view name) {
    if (const auto value = find_gl_name(name)) return value;
    for (std::string_view suffix : {"_ARB", "_EXT", "_SGIS", "_NV"}) {
        if (name.ends_with(suffix)) return find_gl_name(name.substr(0, name.size() - suffix.size()));
    }
    return std::nullopt;
}

std::optional<Enum> find_word(std::string_view word) {
    static const auto index = index_by_name(words());
    return find(index, word);
}

std::string_view word_name(Word word) { return words()[static_cast<std::size_t>(word)].name; }

std::string enum_name(Enum value) {
    static const auto index = [] {
        std::unordered_map<Enum, std::string_view> names;
        for (const NamedValue& row : gl_names()) {
            // Some bits of glClear have the same values as GL_LIGHT0 and GL_NEVER; bit_names() prints those.
            const bool is_bit = row.name.ends_with("_BIT");
            if (row.value > kGL_POLYGON && !is_bit) names.emplace(row.value, row.name);
        }
        return names;
    }();
    const auto found = index.find(value);
    return found == index.end() ? fmt::format("{:#x}", value) : std::string(found->second);
}

std::string bit_names(Enum mask) {
    if (mask == kGL_ALL_ATTRIB_BITS) return "GL_ALL_ATTRIB_BITS";
    std::string shown;
    const auto join = [&shown](std::string_view name) { shown.append(shown.empty() ? "" : " | ").append(name); };
    for (const NamedValue& row : gl_names()) {
        if (!row.name.ends_with("_BIT") || (mask & row.value) == 0) continue;
        join(row.name);
        mask &= ~row.value;
    }
    if (mask != 0 || shown.empty()) join(fmt::format("{:#x}", mask));
    return shown;
}

std::string primitive_name(Enum mode) {
    static constexpr std::string_view kNames[] = {
        "GL_POINTS",         "GL_LINES",        "GL_LINE_LOOP", "GL_LINE_STRIP", "GL_TRIANGLES",
        "GL_TRIANGLE_STRIP", "GL_TRIANGLE_FAN", "GL_QUADS",     "GL_QUAD_STRIP", "GL_POLYGON"};
    return mode <= kGL_POLYGON ? std::string(kNames[mode]) : enum_name(mode);
}

namespace {

// The edit distance with transpositions (optimal string alignment), at most `limit`. Keeps three rows of the table:
// two, and one more for transpositions.
std::size_t edit_distance(std::string_view a, std::string_view b, std::size_t limit) {
    if (std::max(a.size(), b.size()) - std::min(a.size(), b.size()) >= limit) return limit;
    std::size_t least_of_last = 0;
    std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
        }
        before.swap(last);
        last.swap(row);
        // A row depends on the two rows before it, and its values are never less than theirs.
        const std::size_t least = *std::ranges::min_element(last);
        if (std::min(least, least_of_last) >= limit) return limit;
        least_of_last = least;
    }
    return std::min(last[b.size()], limit);
}

}  // namespace

std::optional<std::string_view> nearest(std::string_view name, const std::vector<std::string_view>& candidates) {
    // A suggestion may differ in a third of the letters, at most three.
    constexpr std::size_t kLongestName = 80;
    if (name.empty() || name.size() > kLongestName) return std::nullopt;
    const std::size_t limit = std::min<std::size_t>(3, (name.size() + 2) / 3);
    std::optional<std::string_view> best;
    std::size_t best_distance = limit + 1;
    for (std::string_view candidate : candidates) {
        const std::size_t distance = edit_distance(name, candidate, best_distance);
        if (distance < best_distance) {
            best_distance = distance;
            best = candidate;
        }
    }
    return best;
}

}  // namespace twinlight
