// A GL texture that holds a picture of the window. Needs its context, from its making to its end.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <vector>

#include "base/image/image.h"
#include "render/context/gl.h"

namespace twinlight::demo {

class Texture {
  public:
    // GL_NEAREST or GL_LINEAR. Pictures that are shown pixel for pixel need GL_NEAREST; linear filters would round, and need other shaders.
    explicit Texture(GLint filter);
    ~Texture();
    Texture(const Texture&) = delete;
    Texture& operator=(const Texture&) = delete;

    void upload(const Image& image);
    // Four bytes for each pixel, the bottom row first.
    void upload(const std::vector<std::uint8_t>& rgba, int width, int height);
    // How it is enlarged from now on.
    void set_magnification(GLint filter);
    unsigned name() const { return name_; }

  private:
    unsigned name_ = 0;
};

// Shows the texture in a rectangle of the window.
void add_picture(ImDrawList& draw, unsigned texture, const ImVec2& from, const ImVec2& to);

}  // namespace twinlight::demo
