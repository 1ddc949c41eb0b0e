// An offscreen context together with a shader renderer in it, for code that uses several contexts.
#pragma once

#include <memory>
#include <optional>

#include "render/context/context.h"
#include "render/programmable/programmable.h"

namespace twinlight::compare {

class ShaderContext {
  public:
    // Makes the context current. Throws std::runtime_error with the driver's reason if there is none.
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
