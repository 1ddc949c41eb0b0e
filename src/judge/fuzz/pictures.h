// Small pictures, three ways, held against each other as `twinlight compare` does.
#pragma once

#include <memory>
#include <vector>

#include "judge/fuzz/comparison.h"
#include "judge/report/comparison.h"
#include "render/context/context.h"
#include "render/programmable/programmable.h"

namespace twinlight::fuzz {

class Pictures {
  public:
    explicit Pictures(std::vector<std::string_view> lifted);
    ~Pictures();
    Pictures(const Pictures&) = delete;
    Pictures& operator=(const Pictures&) = delete;

    Found compare(const std::shared_ptr<const CommandList>& commands);
    static constexpr int kSide = 64;

  private:
    std::vector<std::string_view> lifted_;
    std::unique_ptr<OffscreenContext> context_;
    std::optional<programmable::Renderer> renderer_;  // dies before the context
    report::Renderers renderers_;
};

}  // namespace twinlight::fuzz
