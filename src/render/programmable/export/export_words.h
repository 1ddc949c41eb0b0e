// The words of exported frames: vertices, indices and texels. Frames of one export share them.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace twinlight::programmable {

class ExportWords {
  public:
    // Appends words, unless they were appended before; returns their place: the first one's, and their count.
    template <class Word>
    std::pair<std::size_t, std::size_t> place_of(const std::vector<Word>& words) {
        static_assert(sizeof(Word) == 4);
        const auto bytes = [&](const void* at) {
            return std::string_view(static_cast<const char*>(at), 4 * words.size());
        };
        const std::size_t hash = std::hash<std::string_view>()(bytes(words.data()));
        for (auto [at, end] = places_.equal_range(hash); at != end; ++at) {
            const auto [first, count] = at->second;
            if (count == words.size() && bytes(all.data() + first) == bytes(words.data())) return {first, count};
        }
        const std::size_t first = all.size();
        for (const Word word : words) all.push_back(std::bit_cast<std::uint32_t>(word));
        places_.emplace(hash, std::pair(first, words.size()));
        return {first, words.size()};
    }

    std::string_view bytes() const { return {reinterpret_cast<const char*>(all.data()), 4 * all.size()}; }  // NOLINT

    std::vector<std::uint32_t> all{};

  private:
    std::unordered_multimap<std::size_t, std::pair<std::size_t, std::size_t>>
        places_{};  // by the hash of what is there
};

}  // namespace twinlight::programmable
