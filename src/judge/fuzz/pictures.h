// Compares small pictures of the three renderers, as `twinlight compare` does.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "judge/compare/comparison.h"
#include "judge/compare/shader_context.h"
#include "judge/fuzz/differences.h"

namespace twinlight::fuzz {

class Pictures {
  public:
    // `lifted`: known bugs that are not skipped.
    explicit Pictures(std::vector<std::string_view> lifted);

    StateDifferences compare(const std::shared_ptr<const CommandList>& commands);
    static constexpr int kSide = 64;

  private:
    std::vector<std::string_view> lifted_;
    compare::ShaderContext context_;
    compare::Renderers renderers_;
};

}  // namespace twinlight::fuzz
