// The measures that the checks of lessons combine.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <numbers>
#include <set>
#include <tuple>
#include <utility>

#include "base/math/directions.h"
#include "judge/lesson/work.h"
#include "render/lighting_of.h"
#include "render/reference/reference.h"
#include "render/reference/vertices/lit_vertices.h"
#include "render/reference/vertices/vertex_stage.h"

namespace twinlight::lesson {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

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

}  // namespace

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

Measure mean(Rectangle box, int channel) {
    return [=](const Work& work) { return mean_of(work.picture(), box, static_cast<std::size_t>(channel)); };
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
Measure lit(int shape) {
    return on_shape(shape, [](const Draw& draw) { return light_of(draw) ? 1.0 : 0.0; });
}
Measure flat(int shape) {
    return on_shape(shape, [](const Draw& draw) { return draw.lighting.shade_model == kGL_FLAT ? 1.0 : 0.0; });
}

Measure constant(double value) {
    return [value](const Work&) { return value; };
}
Measure of_start(Measure measure) {
    return [measure = std::move(measure)](const Work& work) { return measure(work.start()); };
}
Measure ratio(Measure above, Measure below) {
    return [above = std::move(above), below = std::move(below)](const Work& work) { return above(work) / below(work); };
}
Measure ratio_to_start(const Measure& measure) { return ratio(measure, of_start(measure)); }
Measure difference(Measure a, Measure b) {
    return [a = std::move(a), b = std::move(b)](const Work& work) { return std::abs(a(work) - b(work)); };
}
Measure largest(std::vector<Measure> measures) {
    return [measures = std::move(measures)](const Work& work) {
        double most = -std::numeric_limits<double>::infinity();
        for (const Measure& measure : measures) {
            const double value = measure(work);
            if (!(value <= most)) most = value;  // NaN stays
            if (std::isnan(most)) return kNone;
        }
        return most;
    };
}
Measure smallest(std::vector<Measure> measures) {
    for (Measure& measure : measures) measure = [measure](const Work& work) { return -measure(work); };
    const Measure most = largest(std::move(measures));
    return [most](const Work& work) { return -most(work); };
}
Measure with_camera_moved(Measure measure) {
    return [measure = std::move(measure)](const Work& work) {
        const Work* moved = work.moved();
        return measure(moved ? *moved : work);
    };
}

}  // namespace twinlight::lesson
