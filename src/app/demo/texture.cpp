#include "app/demo/texture.h"

namespace twinlight::demo {

Texture::Texture(GLint filter) {
    glGenTextures(1, &name_);
    glBindTexture(GL_TEXTURE_2D, name_);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    // Until there is a picture. Three pixels wide, since llvmpipe compiles other shaders for powers of two.
    constexpr int kSide = 3;
    std::vector<std::uint8_t> dark;
    for (int i = 0; i < kSide * kSide; ++i) dark.insert(dark.end(), {28, 31, 37, 255});
    upload(dark, kSide, kSide);
}

Texture::~Texture() { glDeleteTextures(1, &name_); }

// Row 0 of a texture is at the bottom of the picture, as in GL.
void Texture::upload(const Image& image) {
    std::vector<std::uint8_t> codes;
    codes.reserve(image.pixels.size() * 3);
    for (int y = image.height - 1; y >= 0; --y)
        for (int x = 0; x < image.width; ++x)
            for (std::size_t channel = 0; channel < 3; ++channel)
                codes.push_back(channel_code(image.at(x, y)[channel]));
    glBindTexture(GL_TEXTURE_2D, name_);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, image.width, image.height, 0, GL_RGB, GL_UNSIGNED_BYTE, codes.data());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glBindTexture(GL_TEXTURE_2D, 0);
}

void Texture::upload(const std::vector<std::uint8_t>& rgba, int width, int height) {
    glBindTexture(GL_TEXTURE_2D, name_);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    glBindTexture(GL_TEXTURE_2D, 0);
}

void Texture::set_magnification(GLint filter) {
    glBindTexture(GL_TEXTURE_2D, name_);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    glBindTexture(GL_TEXTURE_2D, 0);
}

void add_picture(ImDrawList& draw, unsigned texture, const ImVec2& from, const ImVec2& to) {
    // ImTextureID is an integer or a pointer, by ImGui's release.
    draw.AddImage((ImTextureID)(std::intptr_t)texture, from, to, {0, 1}, {1, 0});
}

}  // namespace twinlight::demo
