// The measures, and the table of them.
#include "judge/lesson/measures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "base/image/file.h"
#include "base/image/png.h"
#include "base/math/directions.h"
#include "judge/lint/lint.h"
#include "render/lighting_of.h"
#include "render/reference/reference.h"
#include "render/reference/vertices/lit_vertices.h"
#include "render/reference/vertices/vertex_stage.h"
#include "scene/command/names.h"
#include "scene/state/state.h"

namespace twinlight::lesson {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
// The largest file and the longest side of a picture that unlike() reads.
constexpr std::size_t kMaxPictureBytes = 1U << 24;
constexpr int kMaxSide = 1024;

// ---- Pictures ----

// Visits the pixels of a box of a picture of kWidth x kHeight.
template <class Visit>
void for_each_pixel(Rectangle box, const Visit& visit) {
    const int right = std::min((box.x + box.width) * kWidth / 640, kWidth);
    const int bottom = std::min((box.y + box.height) * kHeight / 480, kHeight);
    for (int y = box.y * kHeight / 480; y < bottom; ++y)
        for (int x = box.x * kWidth / 640; x < right; ++x)
            visit(static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x));
}

double mean_of(const Image& image, Rectangle box, std::size_t channel) {
    double sum = 0;
    int count = 0;
    for_each_pixel(box, [&](std::size_t i) {
        sum += image.pixels[i][channel];
        ++count;
    });
    return count == 0 ? kNone : sum / count;
}

// The mean difference of the channel that differs most.
double difference_of(const Image& a, const Image& b, Rectangle box) {
    double most = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        double sum = 0;
        int count = 0;
        for_each_pixel(box, [&](std::size_t i) {
            sum += std::abs(static_cast<double>(a.pixels[i][c]) - b.pixels[i][c]);
            ++count;
        });
        most = std::max(most, sum / count);
    }
    return most;
}

// ---- Lighting ----

double angle_deg(const glm::dvec3& a, const glm::dvec3& b) {
    const double cosine = glm::dot(unit(a), unit(b));
    return std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi;
}

// The first light that is on; null if the Draw is not lit.
const LightSource* light_of(const Draw& draw) {
    if (!draw.lighting.enabled) return nullptr;
    for (const LightSource& light : draw.lighting.lights)
        if (light.enabled) return &light;
    return nullptr;
}

// Measures the first Draw of a shape; NaN if no Draw has that shape.
template <class Function>
Measure on_shape(int shape, const Function& function) {
    return [shape, function](const Work& work) -> double {
        const std::vector<const Draw*> draws = work.shape(shape);
        return draws.empty() ? kNone : function(*draws.front());
    };
}

// The same for its first light.
template <class Function>
Measure on_light(int shape, const Function& function) {
    return on_shape(shape, [function](const Draw& draw) -> double {
        const LightSource* light = light_of(draw);
        return light ? function(draw, *light) : kNone;
    });
}

// The largest value of the Draws of a shape.
template <class Function>
Measure on_draws(int shape, const Function& function) {
    return [shape, function](const Work& work) -> double {
        double most = kNone;
        for (const Draw* draw : work.shape(shape)) most = std::fmax(most, function(*draw));
        return most;
    };
}

glm::dvec3 origin_eye(const Draw& draw) { return {draw.eye_from_object[3]}; }

// From the shape's origin to the light, in eye coordinates.
glm::dvec3 to_light_eye(const Draw& draw, const LightSource& light) {
    const glm::dvec4& at = light.position_eye;
    return at.w == 0 ? glm::dvec3(at) : glm::dvec3(at) / at.w - origin_eye(draw);
}

glm::dvec3 direction_eye(const Draw& draw, const glm::dvec3& direction_object) {
    return glm::dmat3(draw.eye_from_object) * direction_object;
}

Measure objects_moved() {
    return [](const Work& work) -> double {
        const std::vector<int>&now = work.shapes(), &before = work.start().shapes();
        // Shapes may have other numbers, and may be split or joined: a pixel is the same where most pixels of the one are
        // pixels of the other.
        std::map<int, std::map<int, int>> votes_before, votes_now;
        for (std::size_t i = 0; i < now.size(); ++i) {
            ++votes_before[before[i]][now[i]];
            ++votes_now[now[i]][before[i]];
        }
        const auto favourite = [](const std::map<int, int>& votes) {
            return std::ranges::max_element(votes, {}, [](const auto& vote) { return vote.second; })->first;
        };
        int moved = 0, covered = 0;
        for (std::size_t i = 0; i < now.size(); ++i) {
            if (before[i] < 0 && now[i] < 0) continue;
            ++covered;
            const bool is_same =
                before[i] >= 0 && now[i] >= 0 &&
                (favourite(votes_before[before[i]]) == now[i] || favourite(votes_now[now[i]]) == before[i]);
            if (!is_same) ++moved;
        }
        return covered == 0 ? kNone : static_cast<double>(moved) / covered;
    };
}

template <std::size_t channel>
Measure mean(const MeasureArguments& arguments) {
    return [box = arguments.box()](const Work& work) { return mean_of(work.picture(), box, channel); };
}
Measure color_error(Rectangle box, glm::dvec3 color) {
    return [=](const Work& work) {
        double most = 0;
        for (int c = 0; c < 3; ++c)
            most = std::max(most, std::abs(mean_of(work.picture(), box, static_cast<std::size_t>(c)) - color[c]));
        return most;
    };
}
Measure colors_apart(Rectangle a, Rectangle b) {
    return [=](const Work& work) {
        double most = 0;
        for (std::size_t c = 0; c < 3; ++c)
            most = std::max(most, std::abs(mean_of(work.picture(), a, c) - mean_of(work.picture(), b, c)));
        return most;
    };
}
// The file is read once, when the check is.
Measure unlike(const std::string& folder, const std::string& name, double codes) {
    if (name.find_first_of("/\\") != std::string::npos)
        throw std::runtime_error(fmt::format("'{}': the picture must be beside the lesson, in the same folder", name));
    const std::string path = (std::filesystem::path(folder) / name).string();
    const PngPixels goal = decode_png_pixels(read_file(path, kMaxPictureBytes), kMaxSide);
    return [=](const Work& work) {
        const Image picture = work.picture_of_size(goal.width, goal.height);
        std::size_t unlike = 0;
        for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
            bool is_unlike = false;
            for (std::size_t c = 0; c < 3; ++c)
                is_unlike |= std::abs(channel_code(picture.pixels[i][c]) - goal.rgba[4 * i + c]) > codes;
            unlike += is_unlike;
        }
        return static_cast<double>(unlike) / static_cast<double>(picture.pixels.size());
    };
}
Measure change(Rectangle box) {
    return [=](const Work& work) { return difference_of(work.picture(), work.start().picture(), box); };
}
Measure change_per_pixel(Rectangle box) {
    return [=](const Work& work) {
        return difference_of(work.picture(Shading::kPhong), work.start().picture(Shading::kPhong), box);
    };
}
Measure matte_change(Rectangle box) {
    return [=](const Work& work) { return difference_of(work.matte(), work.start().matte(), box); };
}
Measure highlight_peak(Rectangle box) {
    return [=](const Work& work) {
        double most = 0;
        for_each_pixel(box, [&](std::size_t i) { most = std::max(most, work.highlight()[i]); });
        return most;
    };
}
Measure highlight_least(Rectangle box) {
    return [=](const Work& work) {
        double least = 1;
        for_each_pixel(box, [&](std::size_t i) { least = std::min(least, work.highlight()[i]); });
        return least;
    };
}
Measure whitest(Rectangle box) {
    return [=](const Work& work) {
        double most = 0;
        for_each_pixel(box, [&](std::size_t i) {
            const Rgba& pixel = work.picture().pixels[i];
            most = std::max<double>(most, std::min({pixel[0], pixel[1], pixel[2]}));
        });
        return most;
    };
}
Measure highlight_pixels() {
    return [](const Work& work) {
        const std::vector<double>& highlight = work.highlight();
        const double half = std::ranges::max(highlight) / 2;
        return half == 0
                   ? kNone
                   : static_cast<double>(std::ranges::count_if(highlight, [half](double h) { return h >= half; }));
    };
}
// The mean place of the pixels of highlight_pixels(): x (0) or y (1), in pixels of 640 x 480.
Measure highlight_place(int axis) {
    return [=](const Work& work) {
        const std::vector<double>& highlight = work.highlight();
        const double half = std::ranges::max(highlight) / 2;
        double sum = 0, count = 0;
        for (std::size_t i = 0; i < highlight.size(); ++i) {
            if (half == 0 || highlight[i] < half) continue;
            sum += static_cast<double>(axis == 0 ? i % kWidth : i / kWidth) + 0.5;
            ++count;
        }
        return count == 0 ? kNone : sum / count * 640 / kWidth;
    };
}
Measure vertex_error(Rectangle box) {
    return [=](const Work& work) { return difference_of(work.picture(), work.picture(Shading::kPhong), box); };
}

Measure light_away(int shape, glm::dvec3 point_world) {
    return on_light(shape, [=](const Draw& draw, const LightSource& light) -> double {
        if (light.is_directional()) return std::numeric_limits<double>::infinity();
        const glm::dvec4 wanted = draw.eye_from_object * glm::dvec4(point_world, 1);
        return glm::distance(glm::dvec3(wanted), glm::dvec3(light.position_eye) / light.position_eye.w);
    });
}
Measure light_angle(int shape, glm::dvec3 direction_world) {
    return on_light(shape, [=](const Draw& draw, const LightSource& light) {
        return angle_deg(direction_eye(draw, direction_world), to_light_eye(draw, light));
    });
}
Measure spot_angle(int shape, glm::dvec3 direction_world) {
    return on_light(shape, [=](const Draw& draw, const LightSource& light) {
        return angle_deg(direction_eye(draw, direction_world), light.spot_direction_eye);
    });
}
Measure spot_cutoff(int shape) {
    return on_light(shape, [](const Draw&, const LightSource& light) { return light.spot_cutoff_deg; });
}
Measure arrival(int shape) {
    return on_light(shape, [](const Draw& draw, const LightSource& light) {
        return arrival_at(origin_eye(draw), light).attenuation;
    });
}
Measure directions_apart(std::vector<int> shapes) {
    return [shapes = std::move(shapes)](const Work& work) -> double {
        std::vector<glm::dvec3> directions;
        for (const int shape : shapes) {
            const std::vector<const Draw*> draws = work.shape(shape);
            const LightSource* light = draws.empty() ? nullptr : light_of(*draws.front());
            if (!light) return kNone;
            directions.push_back(to_light_eye(*draws.front(), *light));
        }
        double most = 0;
        for (const glm::dvec3& a : directions)
            for (const glm::dvec3& b : directions) most = std::max(most, angle_deg(a, b));
        return most;
    };
}
Measure normal_length_error(int shape) {
    return on_draws(shape, [](const Draw& draw) {
        double most = 0;
        for (const reference::StageVertex& vertex : reference::vertex_stage(draw))
            most = std::max(most, std::abs(glm::length(vertex.normal_eye) - 1));
        return most;
    });
}
Measure brightest(int shape) {
    return on_draws(shape, [](const Draw& draw) {
        double most = 0;
        for (const reference::LitVertex& vertex : reference::light_vertices(draw, {}, false))
            for (int c = 0; c < 3; ++c) most = std::max(most, vertex.front_primary[c] + vertex.front_secondary[c]);
        return most;
    });
}
Measure least_light(int count, Rectangle box) {
    return [=](const Work& work) -> double {
        std::vector<double> gains;
        const std::size_t lights = work.frame().draws().empty() ? 0 : work.frame().draws()[0]->lighting.lights.size();
        for (std::size_t light = 0; light < lights; ++light) {
            Frame without = work.frame();
            bool is_on = false;
            for (Draw* draw : without.editable_draws())
                is_on |= std::exchange(draw->lighting.lights[light].enabled, false);
            if (!is_on) continue;
            reference::Options options;
            options.lecture_variants = false;
            gains.push_back(difference_of(reference::render(without, options), work.picture(), box));
        }
        return static_cast<int>(gains.size()) < count ? 0 : std::ranges::min(gains);
    };
}
Measure colors(int shape) {
    return [=](const Work& work) {
        std::set<std::tuple<double, double, double>> found;
        for (const Draw* draw : work.shape(shape))
            for (const Vertex& vertex : draw->vertices) found.insert({vertex.color.r, vertex.color.g, vertex.color.b});
        return static_cast<double>(found.size());
    };
}

// 1 if `is_so` holds for the first Draw of each shape, and else 0.
template <class Function>
Measure on_each_shape(const std::vector<int>& shapes, const Function& is_so) {
    return [shapes, is_so](const Work& work) -> double {
        for (const int shape : shapes) {
            const std::vector<const Draw*> draws = work.shape(shape);
            if (draws.empty()) return kNone;
            if (!is_so(*draws.front())) return 0;
        }
        return 1;
    };
}

// ---- Commands ----

Measure calls(const std::vector<std::string>& texts) {
    const auto command = find_command_or_extension(texts[0]);
    if (!command) throw std::runtime_error(fmt::format("there is no command '{}'", texts[0]));
    std::optional<Enum> value;
    if (texts.size() > 1) {
        value = find_gl_name_or_extension(texts[1]);
        if (!value) throw std::runtime_error(fmt::format("OpenGL has no name '{}'", texts[1]));
    }
    return [=](const Work& work) {
        return static_cast<double>(std::ranges::count_if(work.commands()->commands, [&](const Command& call) {
            return call.id == *command && (!value || std::ranges::find(call.arguments, *value) != call.arguments.end());
        }));
    };
}

Measure warnings(const std::vector<std::string>& texts) {
    const lint::Rule* rule = texts.empty() ? nullptr : lint::find_rule(texts[0]);
    if (!texts.empty() && !rule) throw std::runtime_error(fmt::format("the linter has no rule '{}'", texts[0]));
    return [rule](const Work& work) {
        const WindowSize size = work.commands()->window.value_or(WindowSize{});
        const Scene scene = make_scene(work.commands(), {.width = size.width, .height = size.height});
        return static_cast<double>(std::ranges::count_if(
            lint::lint(scene), [&](const lint::Warning& warning) { return !rule || warning.rule == rule; }));
    };
}

}  // namespace

std::span<const MeasureRow> measures() {
    using enum ParameterKind;
    using A = const MeasureArguments&;
    static const std::vector<MeasureRow> rows = {
        // The picture: by the reference, in OpenGL's own model. Colours are from 0 to 1.
        {"objects_moved",
         {},
         "the share of the objects' pixels that show a different object than at the start, or none",
         [](A) { return objects_moved(); }},
        {"red", {kBox}, "the mean red in a box", mean<0>},
        {"green", {kBox}, "the mean green in a box", mean<1>},
        {"blue", {kBox}, "the mean blue in a box", mean<2>},
        {"color_error",
         {kBox, kVector},
         "how far the mean colour of a box is from this red, green and blue, in the channel where it is furthest",
         [](A a) { return color_error(a.box(), a.vector()); }},
        {"colors_apart",
         {kBox, kBox},
         "how far apart the mean colours of two boxes are, in the channel where they are furthest",
         [](A a) { return colors_apart(a.boxes[0], a.boxes[1]); }},
        {"change",
         {kBox},
         "how far the picture is from the one at the start: the mean difference, in the channel where it is largest",
         [](A a) { return change(a.box()); }},
        {"change_per_pixel",
         {kBox},
         "the same for both pictures lit at every pixel",
         [](A a) { return change_per_pixel(a.box()); }},
        {"change_without_highlights",
         {kBox},
         "the same for both pictures without specular light",
         [](A a) { return matte_change(a.box()); }},
        {"unlike",
         {kText, kNumber},
         "the share of pixels that differ from a PNG file by more than this many codes (of 255) in a channel; the file "
         "is beside the lesson",
         [](A a) { return unlike(a.folder, a.texts[0], a.numbers[0]); }},
        {"vertex_error",
         {kBox},
         "how far the picture is from the same one lit at every pixel",
         [](A a) { return vertex_error(a.box()); }},
        {"whitest",
         {kBox},
         "the weakest channel of the pixel where it is strongest",
         [](A a) { return whitest(a.box()); }},
        {"highlight",
         {kBox},
         "what specular light adds to the pixel where it adds most",
         [](A a) { return highlight_peak(a.box()); }},
        {"least_highlight",
         {kBox},
         "what specular light adds to the pixel where it adds least",
         [](A a) { return highlight_least(a.box()); }},
        {"highlight_size",
         {},
         "the number of pixels (of 320 x 240) with at least half of the strongest highlight",
         [](A) { return highlight_pixels(); }},
        {"highlight_x",
         {},
         "the middle of these pixels, from the left, in pixels of a picture of 640 x 480",
         [](A) { return highlight_place(0); }},
        {"highlight_y", {}, "the same from the top", [](A) { return highlight_place(1); }},
        // Lighting. The light is the first one that is on for the object. Points and directions are in the object's coordinates.
        {"lit",
         {kObjects},
         "1 if a light that is on lights each of these objects, and else 0",
         [](A a) { return on_each_shape(a.objects, [](const Draw& draw) { return light_of(draw) != nullptr; }); }},
        {"flat",
         {kObjects},
         "1 if each of these objects is drawn with GL_FLAT, and else 0",
         [](A a) {
             return on_each_shape(a.objects, [](const Draw& draw) { return draw.lighting.shade_model == kGL_FLAT; });
         }},
        {"light_distance",
         {kObject, kVector},
         "how far the light is from a point; infinite for a directional light",
         [](A a) { return light_away(a.object(), a.vector()); }},
        {"light_angle",
         {kObject, kVector},
         "the angle in degrees between a direction and the one from the object's origin to the light",
         [](A a) { return light_angle(a.object(), a.vector()); }},
        {"light_directions_apart",
         {kObjects},
         "the largest angle in degrees between the directions from these objects' origins to the light",
         [](A a) { return directions_apart(a.objects); }},
        {"spot_angle",
         {kObject, kVector},
         "the angle in degrees between a direction and the spotlight's",
         [](A a) { return spot_angle(a.object(), a.vector()); }},
        {"spot_cutoff", {kObject}, "GL_SPOT_CUTOFF in degrees", [](A a) { return spot_cutoff(a.object()); }},
        {"attenuation",
         {kObject},
         "how much of the light attenuation leaves at the object's origin",
         [](A a) { return arrival(a.object()); }},
        {"brightest",
         {kObject},
         "the largest channel of the object's lit vertices, before the clamp to 1",
         [](A a) { return brightest(a.object()); }},
        {"weakest_light",
         {kNumber, kBox},
         "what the light that adds least adds to the mean of a box; 0 where fewer lights than this number are on",
         [](A a) { return least_light(static_cast<int>(a.numbers[0]), a.box()); }},
        {"normal_length_error",
         {kObject},
         "how far the length of a normal is from 1 at worst, in eye coordinates as OpenGL lights it",
         [](A a) { return normal_length_error(a.object()); }},
        {"vertex_colors",
         {kObject},
         "how many different current colours the object's vertices have",
         [](A a) { return colors(a.object()); }},
        // Commands.
        {"calls",
         {kText, kMaybeText},
         "how often the scene calls this command; with a second name, as in calls(glLightfv, GL_POSITION), only calls "
         "that have it as an argument",
         [](A a) { return calls(a.texts); }},
        {"warnings",
         {kMaybeText},
         "how many warnings the linter has, all of them or those of one rule, as in warnings(\"light-before-camera\")",
         [](A a) { return warnings(a.texts); }},
    };
    return rows;
}

}  // namespace twinlight::lesson
