// The shader path: GLSL assembled for the effects that each Draw calls for, in the current context.
// Buffers, attributes and uniforms only: no built-in GL lighting or matrix state.
#pragma once

#include <memory>
#include <string>

#include "image/image.h"
#include "state/frame.h"

namespace twinlight::programmable {

// Owns the programs and buffers that it made in the context that is current; die before that context does.
class Renderer {
  public:
    Renderer();
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    // Clears to black and depth 1 and draws the frame into the current colour buffer. Throws
    // std::runtime_error with the log, the numbered source and the EffectSet when the driver refuses a shader.
    void draw(const Frame& frame, const RenderOptions& options);
    // The same, and reads the picture.
    Image render(const Frame& frame, const RenderOptions& options);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// The GLSL that draws the frame, for people to read: the program of each Draw, with its effects, what is left
// out and why, and the uniforms' values in comments. Needs no context.
std::string shader_source(const Frame& frame, const RenderOptions& options);

}  // namespace twinlight::programmable
