// The words of frames: vertices, indices and texels. Frames of one page share them.
#pragma once

#include <bit>
#include <cstdint>
#include <functional>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/text/json.h"

namespace twinlight::webgl {

class Words {
  public:
    // Appends words, unless they are there already; returns their place, [first, count].
    template <class Word>
    Json place_of(const std::vector<Word>& words) {
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

    std::vector<std::uint32_t> all{};

  private:
    std::unordered_multimap<std::size_t, std::pair<std::size_t, std::size_t>>
        places_{};  // by the hash of what is there
};

}  // namespace twinlight::webgl
