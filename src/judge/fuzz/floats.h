// Lit vertices at float precision, three ways: the fixed function in feedback mode, unclamped; shaders into a buffer of
// floats, clamped to [0,1] (2.14.6); the reference.
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
    // `lifted`: departures that are not left out.
    explicit Floats(std::vector<std::string_view> lifted);

    // Scenes whose last Draw has three vertices or fewer, each in a corner of the view of its own. At most kMostScenes.
    std::vector<StateDifferences> compare(std::span<const std::shared_ptr<const CommandList>> scenes);
    static constexpr std::size_t kMostScenes = 1024;

  private:
    std::vector<std::string_view> lifted_;
    compare::ShaderContext context_;
};

}  // namespace twinlight::fuzz
