// The lessons and their checks. The pages have the words.
#include <limits>
#include <stdexcept>
#include <string>

#include "judge/lesson/lesson.h"

namespace twinlight::lesson {

namespace {

constexpr double kMany = std::numeric_limits<double>::infinity();
// Two right pictures of one scene; a border that falls on other pixels.
constexpr double kSame = 0.01, kUnmoved = 0.02;

// In colours: what rounding hides.
constexpr double kEqual = 0.01;

const Check kObjects = {"objects", objects_moved(), 0, kUnmoved};
Check all_lit(int shapes) {
    std::vector<Measure> each;
    for (int shape = 0; shape < shapes; ++shape) each.push_back(lit(shape));
    return {"lit", smallest(std::move(each)), 1, 1};
}

// The strongest of the other two channels over this one, in the mean of a box.
Measure other_colors(Rectangle box, int channel) {
    return ratio(largest({mean(box, (channel + 1) % 3), mean(box, (channel + 2) % 3)}), mean(box, channel));
}
// How far the mean of a box is from a colour, in its worst channel.
Measure color_error(Rectangle box, glm::dvec3 color) {
    std::vector<Measure> channels;
    for (int c = 0; c < 3; ++c) channels.push_back(difference(mean(box, c), constant(color[c])));
    return largest(std::move(channels));
}
Measure boxes_apart(Rectangle a, Rectangle b) {
    std::vector<Measure> channels;
    for (int c = 0; c < 3; ++c) channels.push_back(difference(mean(a, c), mean(b, c)));
    return largest(std::move(channels));
}
// How much more light a ball gets than the one at its left, at most, in a row of five.
Measure next_over_last() {
    std::vector<Measure> steps;
    for (int ball = 1; ball < 5; ++ball) steps.push_back(ratio(arrival(ball), arrival(ball - 1)));
    return largest(std::move(steps));
}
// The share of the background (red: 0.35) that comes through the front ball, which is opaque at the start.
Measure let_through(Rectangle box) {
    const Measure red = mean(box, 0);
    return ratio(difference(red, of_start(red)), difference(constant(0.35), of_start(red)));
}

struct LessonChecks {
    std::string_view name;
    std::vector<Check> checks;
};

// In the order of teaching. Boxes are in pixels of 640 x 480; they lie on the object that the check is about.
const std::vector<LessonChecks>& table() {
    static const std::vector<LessonChecks> lessons = {
        {"light-and-camera",
         {kObjects,
          all_lit(1),
          {"lamp", light_away(0, {-3, 3, 1}), 0, 0.05},
          {"moving-camera", with_camera_moved(light_away(0, {-3, 3, 1})), 0, 0.05}}},
        {"sun-or-lamp",
         {kObjects,
          all_lit(5),
          {"same", directions_apart({0, 1, 2, 3, 4}), 0, 1},
          {"direction", light_angle(2, {-1, 1, 1}), 0, 2}}},
        {"second-light",
         {kObjects,
          {"right-side", mean({430, 190, 60, 100}, 2), 0.35, kMany},
          {"blue", ratio(mean({430, 190, 60, 100}, 0), mean({430, 190, 60, 100}, 2)), 0, 0.7},
          {"left-side", change({145, 190, 60, 100}), 0, kSame}}},
        {"attenuation",
         {kObjects,
          all_lit(5),
          {"lamp", light_away(0, {-1.1, 1.5, 2.5}), 0, 0.05},  // the first ball is at (-3.4, 0, 0)
          {"falls", next_over_last(), 0, 0.97},
          {"last", ratio(arrival(4), arrival(0)), 0, 0.25},
          {"first", mean({35, 210, 60, 60}, 1), 0.3, kMany}}},
        {"spot-direction",
         {kObjects,
          all_lit(2),
          {"place", largest({light_away(0, {0, 4, 0}), with_camera_moved(light_away(0, {0, 4, 0}))}), 0, 0.05},
          {"cone", spot_cutoff(0), 1, 20},
          {"down", spot_angle(0, {0, -1, 0}), 0, 2},
          {"moving-camera", with_camera_moved(spot_angle(0, {0, -1, 0})), 0, 2}}},
        {"shininess",
         {kObjects,
          {"colors", matte_change(kWholePicture), 0, kSame},
          {"peak", ratio_to_start(highlight_peak(kWholePicture)), 0.9, 1.1},
          {"size", ratio_to_start(highlight_pixels()), 0, 0.25}}},
        {"local-viewer",
         {kObjects,
          all_lit(1),
          // The floor is turned by -90 degrees about x. A sun is infinitely far away; a lamp within 1000 units is not a sun.
          {"sun", largest({light_angle(0, {0.4, 2, 1}), ratio(constant(2000), light_away(0, {0, 0, 0}))}), 0, 2},
          {"spot", difference(highlight_peak({120, 220, 420, 140}), highlight_least({120, 220, 420, 140})), 0.4,
           kMany}}},
        {"coarse-mesh",
         {kObjects,
          all_lit(1),
          {"light", change_per_pixel({250, 160, 220, 160}), 0, kSame},
          {"round", vertex_error({250, 160, 220, 160}), 0, 0.01}}},
        {"saturation",
         {kObjects,
          {"three-lights", least_light(3, {220, 140, 200, 200}), 0.02, kMany},
          {"too-bright", brightest(0), 0, 1.001},
          {"too-dark", brightest(0), 0.8, kMany}}},
        {"missing-normals",
         {kObjects,
          all_lit(1),
          {"left", mean({225, 190, 40, 40}, 1), 0.453 - 2 * kEqual, 0.453 + 2 * kEqual},
          {"right", mean({385, 230, 40, 40}, 1), 0.133 - kEqual, 0.133 + kEqual},
          {"gable", mean({225, 345, 30, 25}, 1), 0.213 - kEqual, 0.213 + kEqual}}},
        {"scaled-normals",
         {kObjects,
          all_lit(2),
          {"left-ball", change({130, 180, 80, 80}), 0, kSame},
          {"normals", normal_length_error(1), 0, 0.02},
          {"equal", boxes_apart({130, 180, 80, 80}, {430, 180, 80, 80}), 0, 2 * kEqual}}},
        {"two-sides",
         {kObjects,
          {"inside", mean({240, 90, 160, 90}, 0), 0.35, kMany},
          {"red", ratio(mean({240, 90, 160, 90}, 2), mean({240, 90, 160, 90}, 0)), 0, 0.6},
          {"lit-inside", boxes_apart({220, 100, 60, 60}, {360, 100, 60, 60}), 0.02, kMany},
          {"outside", change({280, 300, 80, 70}), 0, kSame}}},
        {"provoking-vertex",
         {kObjects,
          {"flat", smallest({flat(0), flat(1), flat(2)}), 1, 1},
          {"corners", smallest({colors(0), colors(1), colors(2)}), 3, kMany},
          {"triangle", other_colors({95, 270, 30, 30}, 1), 0, 0.5},
          {"quadrilateral", other_colors({270, 190, 100, 100}, 1), 0, 0.5},
          {"polygon", other_colors({490, 220, 60, 60}, 1), 0, 0.5}}},
        {"color-material",
         {kObjects,
          all_lit(3),
          {"red", other_colors({90, 255, 50, 40}, 0), 0, 0.5},
          {"green", other_colors({295, 255, 50, 40}, 1), 0, 0.5},
          {"blue", other_colors({495, 255, 50, 40}, 2), 0, 0.5},
          {"highlight",
           smallest({whitest({30, 150, 180, 180}), whitest({230, 150, 180, 180}), whitest({430, 150, 180, 180})}), 0.55,
           kMany}}},
        {"textured-highlight",
         {{"texture", matte_change(kWholePicture), 0, kSame / 2}, {"highlight", highlight_peak({335, 170, 50, 50}), 0.5, kMany}}},
        {"transparency",
         {{"red-ball", change({160, 200, 70, 80}), 0, kSame},
          {"glass", let_through({410, 200, 80, 80}), 0.3, 0.7},
          {"behind", difference(mean({290, 200, 50, 80}, 0), of_start(mean({290, 200, 50, 80}, 0))), 0.15, kMany}}},
        {"overlay",
         {kObjects,
          {"ball", change({160, 60, 330, 330}), 0, kSame / 2},
          {"bar", color_error({60, 418, 360, 24}, {1, 0.8, 0.1}), 0, kEqual}}},
    };
    return lessons;
}

}  // namespace

std::span<const std::string_view> names() {
    static const std::vector<std::string_view> all = [] {
        std::vector<std::string_view> found;
        for (const LessonChecks& lesson : table()) found.push_back(lesson.name);
        return found;
    }();
    return all;
}

std::span<const Check> checks_of(std::string_view name) {
    for (const LessonChecks& lesson : table())
        if (lesson.name == name) return lesson.checks;
    throw std::out_of_range("there is no lesson '" + std::string(name) + "'");
}

}  // namespace twinlight::lesson
