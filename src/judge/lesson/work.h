// What the checks of lessons look at: a student's scene, its pictures and its lighting, beside the scene to start from.
//
// A Measure is a number of a Work. Lessons combine a few of them (lessons.cpp). NaN stands for "cannot be measured" and fails
// every check.
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/image/image.h"
#include "base/image/rectangle.h"
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

    const Work& start() const { return start_ ? *start_ : *this; }
    const CommandList& commands() const { return *commands_; }
    // At kWidth x kHeight.
    const Frame& frame() const { return frame_; }
    // By the reference, in GL's own model. Empty: shaded as the scene says.
    const Image& picture(std::optional<Shading> shading = std::nullopt) const;
    // The same without highlights: every material's specular colour is black.
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

using Measure = std::function<double(const Work&)>;

// Parts of the picture are in pixels of a picture of 640 x 480, from the top left.
inline constexpr Rectangle kWholePicture{0, 0, 640, 480};

// ---- Measures of pictures ----

// The share of the start's pixels (0 to 1) that show another object, or none.
Measure objects_moved();
// The mean of a channel (0 red, 1 green, 2 blue) in a box: 0 to 1.
Measure mean(Rectangle box, int channel);
// The largest mean difference of a channel in a box from the start's picture: 0 to 1.
Measure change(Rectangle box);
// The same of the pictures lit per pixel, and of those without highlights.
Measure change_per_pixel(Rectangle box);
Measure matte_change(Rectangle box);
// How bright the highlight is at its brightest in a box, 0 to 1, and at its darkest.
Measure highlight_peak(Rectangle box);
Measure highlight_least(Rectangle box);
// How white the whitest pixel of a box is: its weakest channel, 0 to 1.
Measure whitest(Rectangle box);
// The number of pixels where the highlight has at least half of its largest brightness.
Measure highlight_pixels();
// How far the picture with lighting per vertex is from that with lighting per pixel, mean of a box: 0 to 1.
Measure vertex_error(Rectangle box);

// ---- Measures of lighting ----
// `shape` is the number of a shape of the start's scene, from 0. "World" is the object space of that shape. The light is the
// first one that is on for the shape.

// The distance of the light from a point of the world; infinite if w is 0.
Measure light_away(int shape, glm::dvec3 point_world);
// The angle in degrees between a direction of the world and the direction from the shape's origin to the light.
Measure light_angle(int shape, glm::dvec3 direction_world);
// The angle in degrees between a direction of the world and the direction of the spotlight.
Measure spot_angle(int shape, glm::dvec3 direction_world);
// GL_SPOT_CUTOFF in degrees.
Measure spot_cutoff(int shape);
// How much of the light attenuation leaves at the shape's origin: 0 to 1.
Measure arrival(int shape);
// The largest angle in degrees between the directions to the light from the origins of these shapes.
Measure directions_apart(std::vector<int> shapes);
// How far the normals' length is from 1 at most, in eye coordinates as GL lights them.
Measure normal_length_error(int shape);
// The largest channel of the lit vertices in view, before the clamp to 1.
Measure brightest(int shape);
// How much of the picture the light that changes it least adds: the largest change of a mean channel in a box. 0 where fewer
// than `count` lights are on.
Measure least_light(int count, Rectangle box);
// The number of different vertex colours of the shape.
Measure colors(int shape);
// 1 if the shape is lit by a light that is on, and if it is drawn with GL_FLAT; else 0.
Measure lit(int shape);
Measure flat(int shape);

// ---- Combinations ----

Measure constant(double value);
Measure of_start(Measure measure);
Measure ratio(Measure above, Measure below);
// The measure now over that of the scene to start from.
Measure ratio_to_start(const Measure& measure);
Measure difference(Measure a, Measure b);  // |a - b|
Measure largest(std::vector<Measure> measures);
Measure smallest(std::vector<Measure> measures);
// Of the scene with its camera elsewhere; without gluLookAt, of the scene.
Measure with_camera_moved(Measure measure);

}  // namespace twinlight::lesson
