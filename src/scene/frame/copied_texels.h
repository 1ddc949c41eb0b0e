// Textures and pixel rectangles that were copied from the picture (3.8.2, 4.3.3), or drawn by framebuffer objects. Each renderer
// copies from its own pictures, so what it draws wrong shows in its copies too.
#pragma once

#include <array>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "base/image/image.h"
#include "scene/frame/frame.h"

namespace twinlight {

// A picture to copy from. One of depths, or of stencil values in 1/255, has them as red, green and blue.
struct CopySource {
    Image picture;
    // What another renderer's picture may have; empty: the same picture.
    Image low{}, high{};
    // The place of these images' lower left corner in the whole picture, y up.
    glm::ivec2 corner{0};
};

// What other renderers may have copied from their pictures, for the allowed difference.
struct CopyRanges {
    struct OfPixels {
        // The least and the largest values of each vertex; empty if something else was copied.
        std::vector<std::array<glm::dvec4, 2>> colors{};
        std::vector<glm::dvec2> depths{};
        // Places that may have any colour, or any stencil value.
        std::vector<glm::ivec2> doubtful{};
    };
    // The least and the largest values of each texel.
    struct OfTexels {
        Texture low, high;
    };
    std::map<std::shared_ptr<const WindowPixels>, OfPixels> pixels{};
    std::map<std::shared_ptr<const Texture>, OfTexels> textures{};

    // Null where nothing was copied. `ranges` may be null.
    static const OfPixels* of(const CopyRanges* ranges, const std::shared_ptr<const WindowPixels>& drawn) {
        return ranges && ranges->pixels.contains(drawn) ? &ranges->pixels.at(drawn) : nullptr;
    }
    static const OfTexels* of(const CopyRanges* ranges, const std::shared_ptr<const Texture>& texture) {
        return ranges && ranges->textures.contains(texture) ? &ranges->textures.at(texture) : nullptr;
    }
};

// Draws a Frame in which all copies are filled in, and returns its colours, depths or stencil values: those in the rectangle at
// least, which lies inside the picture. The picture of a framebuffer object has its own size, and is drawn apart from the window's.
using DrawSource = std::function<CopySource(const Frame&, CopiedBuffer, const Rectangle&)>;

// The frame with all copied texels in its textures and all copied pixels in its Draws, and without the commands that copied
// texels. The Draws are the same, in the same order. RULING: pixels outside the window, which 3.8.2 and 4.3.2 leave undefined,
// are black, with a depth of 0.
//
// `draw` is called once for each buffer of each picture that they are copied from: the commands since the last Clear that hides all
// before it; and once for each image that a framebuffer object drew.
//
// If `draw` gives what other renderers' pictures may have, `ranges` gets what these may have copied, by the objects in the result; it has
// that of all earlier copies when `draw` is called.
Frame with_copied_texels(const Frame& frame, const DrawSource& draw, CopyRanges* ranges = nullptr);

// Adds what other renderers may have in levels that GL_GENERATE_MIPMAP made: 3.8.8 asks for no particular filter, and an image with an
// odd side cannot be halved.
void add_generated_levels(const Frame& frame, CopyRanges& ranges);

// The Draws of all pictures that the frame shows: those of the window, of earlier pictures that textures have copies of, and of
// framebuffer objects.
std::vector<const Draw*> draws_of_all_pictures(const Frame& frame);

// The frame itself if it shows no copies; otherwise with_copied_texels().
class DrawableFrame {
  public:
    // The frame must outlive this.
    DrawableFrame(const Frame& frame, const DrawSource& draw, CopyRanges* ranges = nullptr) : given_(&frame) {
        if (frame.copies_pixels) taken_ = with_copied_texels(frame, draw, ranges);
    }
    const Frame& operator*() const { return taken_ ? *taken_ : *given_; }

  private:
    const Frame* given_;
    std::optional<Frame> taken_;
};

}  // namespace twinlight
