// What the checks of lessons look at: a student's scene, its pictures and its lighting, beside the scene to start from.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/image/image.h"
#include "render/look.h"
#include "scene/command/command.h"
#include "scene/frame/frame.h"

namespace twinlight::lesson {

// Lessons compare pictures of this size.
inline constexpr int kWidth = 320, kHeight = 240;

class Work {
  public:
    // Throws SceneError for a scene that GL refuses. `start` must outlive the Work; null for the scene to start from itself.
    explicit Work(std::shared_ptr<const CommandList> commands, const Work* start = nullptr);
    Work(const Work&) = delete;
    Work& operator=(const Work&) = delete;

    const Work& start() const { return start_ ? *start_ : *this; }
    const std::shared_ptr<const CommandList>& commands() const { return commands_; }
    // At kWidth x kHeight.
    const Frame& frame() const { return frame_; }
    // By the reference, in GL's own model. Empty: shaded as the scene says.
    const Image& picture(std::optional<Shading> shading = std::nullopt) const;
    // The same in another size.
    Image picture_of_size(int width, int height) const;
    // The same as picture() without highlights: every material's specular colour is black.
    const Image& matte() const;
    // The picture minus the matte one: the largest difference of a channel at each pixel.
    const std::vector<double>& highlight() const;
    // The number of the shape at each pixel (reference::seen_shapes).
    const std::vector<int>& shapes() const;
    // The Draws of the shape that takes the place of the start's shape `number` in the picture. Empty if nothing does.
    std::vector<const Draw*> shape(int number) const;
    // The scene with its camera elsewhere: each gluLookAt is turned about the point that it looks at, and raised. Null without gluLookAt.
    const Work* moved() const;

  private:
    int number_of(int shape) const;  // the number in this scene of the start's shape

    std::shared_ptr<const CommandList> commands_;
    const Work* start_;
    const Work* unmoved_ = nullptr;  // with the camera where it was
    Frame frame_;
    // Made when they are first needed.
    mutable std::map<std::optional<Shading>, Image> pictures_;
    mutable std::optional<Image> matte_;
    mutable std::optional<std::vector<double>> highlight_;
    mutable std::optional<std::vector<int>> shapes_;
    mutable std::optional<std::unique_ptr<Work>> moved_;
};

}  // namespace twinlight::lesson
