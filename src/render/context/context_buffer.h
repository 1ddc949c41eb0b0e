// A buffer of the current context to draw into, where its surface has not the colours that are wanted, or it has none.
#pragma once

#include <array>
#include <string_view>

#include "render/context/context.h"

namespace twinlight {

// Owns objects of the current context, so it must be destroyed before the context. It stays bound.
class ContextBuffer {
  public:
    // With 24 bits of depth and 8 of stencil. Throws std::runtime_error if the driver cannot draw into it.
    ContextBuffer(int width, int height, ColorBuffer color_buffer);
    ~ContextBuffer();
    ContextBuffer(const ContextBuffer&) = delete;
    ContextBuffer& operator=(const ContextBuffer&) = delete;

  private:
    void release();

    std::array<unsigned, 2> buffers_{};  // colour; depth and stencil
    unsigned framebuffer_ = 0;
};

// What a new context starts with: the viewport and scissor of this size, clamped colours, cleared buffers.
void prepare_context(int width, int height);

// Whether a list of extensions, with spaces between them, has one. `words` may be nullptr.
bool has_word(const char* words, std::string_view word);

}  // namespace twinlight
