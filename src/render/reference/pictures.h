// Several pictures of one frame. A comparison needs eight of them, which differ only in how lit Draws are shaded and in
// how quadrilaterals are cut. A picture is drawn again only where that can change a pixel.
#pragma once

#include <optional>
#include <vector>

#include "render/reference/geometry/coverage.h"
#include "render/reference/reference.h"
#include "render/reference/staged_frame.h"

namespace twinlight::reference {

// What makes correct pictures of a frame differ, while it is found: bytes, not bits, because bands write concurrently.
struct OpenDifference {
    OpenDifference(int width, int height)
        : edge(size_of(width, height)),
          drawn(edge.size()),
          undefined(edge.size()),
          open(edge.size()),
          why(edge.size(), Why::kTextures),
          channels(width, height) {}
    std::vector<char> edge, drawn, undefined;
    std::vector<Whys> open;
    std::vector<Why> why;  // of what `channels` allows
    Image channels;
    std::map<std::size_t, std::vector<AllowedRange>> ranges;

  private:
    static std::size_t size_of(int width, int height) {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    }
};

class Pictures {
  public:
    // The frame must outlive this, and must not change.
    explicit Pictures(const Frame& frame, const CopyRanges& ranges = {}) : frame_(&frame), ranges_(ranges) {}
    const Frame& frame() const { return *frame_; }

    // The same as the functions in reference.h, bit for bit.
    Image render(const Options& options);
    AllowedDifference allowed_difference(const Options& options);

  private:
    struct Drawn {
        Options options;
        Image image;
        PixelRect of_quadrilaterals;  // what they may reach, cut as in this picture
    };
    struct Found {
        Options options;
        OpenDifference difference;
        PixelRect of_quadrilaterals;  // in both cuts
    };

    const Frame* frame_;
    CopyRanges ranges_;           // what other renderers may have copied, and may make of images
    std::vector<Drawn> drawn_;    // the newest of each cut
    std::optional<Found> found_;  // the newest
    bool has_generated_ = false;  // whether ranges_ has the levels that GL_GENERATE_MIPMAP made
};

}  // namespace twinlight::reference
