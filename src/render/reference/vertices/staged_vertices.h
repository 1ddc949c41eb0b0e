// A Draw's vertices after the vertex stage, under their numbers in Draw::vertices: all, or only those that pieces need. A fine mesh has
// millions, and most of its triangles cover no pixel's centre.
#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "render/reference/vertices/vertex_stage.h"

namespace twinlight::reference {

class StagedVertices {
  public:
    StagedVertices() = default;
    // Has all vertices where at least half are needed. `needed`: of each vertex.
    StagedVertices(const Draw& draw, const std::vector<bool>& needed);
    // Deletes them; place() still answers.
    void clear() { std::vector<StageVertex>().swap(kept_); }

    const StageVertex& operator[](std::size_t number) const { return kept_[place(number)]; }
    // In the order of their numbers.
    std::span<const StageVertex> kept() const { return kept_; }
    // The number of the kept vertex i.
    std::size_t number(std::size_t i) const { return numbers_.empty() ? i : numbers_[i]; }
    // Which of the kept vertices has this number.
    std::size_t place(std::size_t number) const {
        if (words_.empty()) return number;
        const Word& word = words_[number / 64];
        const std::uint64_t before = word.bits & ((std::uint64_t{1} << number % 64) - 1);
        return word.before + static_cast<std::size_t>(std::popcount(before));
    }

  private:
    struct Word {
        std::uint64_t bits = 0;    // bit i: whether the vertex is kept
        std::uint32_t before = 0;  // how many are kept before these 64
    };

    std::vector<StageVertex> kept_;
    std::vector<Word> words_;             // empty: all are kept
    std::vector<std::uint32_t> numbers_;  // empty: all are kept
};

}  // namespace twinlight::reference
