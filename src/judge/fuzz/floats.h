// Lit vertices at float precision, three ways: the fixed function in feedback mode, unclamped; shaders into a buffer of
// floats, clamped to [0,1] (2.14.6); the reference.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "judge/fuzz/comparison.h"
#include "render/context/context.h"
#include "render/programmable/programmable.h"

namespace twinlight::fuzz {

class Floats {
  public:
    explicit Floats(std::vector<std::string_view> lifted);
    ~Floats();
    Floats(const Floats&) = delete;
    Floats& operator=(const Floats&) = delete;

    // Scenes whose last Draw has three vertices or fewer, each in a corner of the view of its own. At most kMostScenes.
    std::vector<Found> compare(std::span<const std::shared_ptr<const CommandList>> scenes);
    static constexpr std::size_t kMostScenes = 1024;

  private:
    std::vector<std::string_view> lifted_;
    std::unique_ptr<OffscreenContext> context_;
    std::optional<programmable::Renderer> renderer_;  // dies before the context
};

}  // namespace twinlight::fuzz
