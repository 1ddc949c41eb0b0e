// A context of its own and the shaders in it, for those who keep several.
#pragma once

#include <memory>
#include <optional>

#include "render/context/context.h"
#include "render/programmable/programmable.h"

namespace twinlight::compare {

class ShaderContext {
  public:
    // Current from here on. Throws std::runtime_error that says what the driver refused.
    ShaderContext(int width, int height, ColorBuffer color_buffer = ColorBuffer::kUnorm8)
        : context_(make_offscreen_context(width, height, color_buffer)) {
        shaders_.emplace();
    }
    ~ShaderContext() {
        make_current();
        shaders_.reset();
    }
    ShaderContext(const ShaderContext&) = delete;
    ShaderContext& operator=(const ShaderContext&) = delete;

    void make_current() { context_->make_current(); }
    programmable::Renderer& shaders() { return *shaders_; }

  private:
    std::unique_ptr<OffscreenContext> context_;
    std::optional<programmable::Renderer> shaders_;  // dies before the context
};

}  // namespace twinlight::compare
