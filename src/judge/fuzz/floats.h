// Compares vertex colours in floats: the fixed function in feedback mode, unclamped; the shaders in a buffer of floats,
// clamped to [0,1] (2.14.6); and the reference.
#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "judge/compare/shader_context.h"
#include "judge/fuzz/differences.h"

namespace twinlight::fuzz {

class Floats {
  public:
    // `lifted`: known bugs that are not skipped.
    explicit Floats(std::vector<std::string_view> lifted);

    // At most kMostScenes scenes. Their last Draw has at most three vertices, each in a different corner of the view.
    std::vector<StateDifferences> compare(std::span<const std::shared_ptr<const CommandList>> scenes);
    static constexpr std::size_t kMostScenes = 1024;

  private:
    std::vector<std::string_view> lifted_;
    compare::ShaderContext context_;
};

}  // namespace twinlight::fuzz
