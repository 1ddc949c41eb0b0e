// The front: the choices that no other beats; and what they come to in words.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "study/study.h"

namespace twinlight::study {

namespace {

bool is_timed(const Point& point) { return !point.seconds.empty(); }

std::string milliseconds(double seconds) { return fmt::format("{:.3g} ms", 1000 * seconds); }

std::string words_of(const Point& point) {
    return fmt::format("{} ({}, rms {:.2g})", point.choice.words(), milliseconds(point.median_seconds()),
                       point.whole.rms);
}

// The fastest of those that `is_meant`, of an error at most as large.
template <class IsMeant>
const Point* fastest(const std::vector<Point>& points, double most_rms, const IsMeant& is_meant) {
    const Point* best = nullptr;
    for (const Point& point : points) {
        if (!is_timed(point) || point.whole.rms > most_rms || !is_meant(point)) continue;
        if (!best || point.median_seconds() < best->median_seconds()) best = &point;
    }
    return best;
}

// By full simulation, so that meshes and shadings are compared, not models.
bool is_whole(const Point& point, Shading shading) {
    const Choice& choice = point.choice;
    return choice.renderer == "programmable" && choice.shading == shading && choice.tier == Tier::kUniform &&
           choice.without == Without::kNothing && choice.budget == RenderOptions{}.budget;
}

// Where the finer shading on a coarser mesh begins to be the cheaper way to an error.
std::optional<std::string> crossover(const std::vector<Point>& points, Shading coarse, Shading fine) {
    std::vector<double> errors;
    for (const Point& point : points)
        if (is_timed(point) && (is_whole(point, coarse) || is_whole(point, fine))) errors.push_back(point.whole.rms);
    std::sort(errors.rbegin(), errors.rend());
    const Point* last_of_coarse = nullptr;
    for (const double error : errors) {
        const Point* a = fastest(points, error, [&](const Point& point) { return is_whole(point, coarse); });
        const Point* b = fastest(points, error, [&](const Point& point) { return is_whole(point, fine); });
        if (!b || (a && a->median_seconds() <= b->median_seconds())) {
            last_of_coarse = a;
            continue;
        }
        const std::string beaten =
            a ? fmt::format("; {} takes {} for that", a->choice.words(), milliseconds(a->median_seconds()))
              : fmt::format("; no {} mesh of this study is as near", name_of(coarse));
        if (!last_of_coarse)
            return fmt::format("For any error {} is cheaper than {}: from {} on", name_of(fine), name_of(coarse),
                               words_of(*b));
        return fmt::format("From an rms error of {:.2g} down, {} is cheaper than {}: {}{}", error, name_of(fine),
                           name_of(coarse), words_of(*b), beaten);
    }
    return {};
}

}  // namespace

void find_front(std::vector<Point>& points) {
    std::vector<Point*> by_time;
    for (Point& point : points) {
        point.on_front = false;
        if (is_timed(point)) by_time.push_back(&point);
    }
    std::ranges::stable_sort(by_time, [](const Point* a, const Point* b) {
        return std::pair(a->median_seconds(), a->whole.rms) < std::pair(b->median_seconds(), b->whole.rms);
    });
    double least = std::numeric_limits<double>::infinity();
    for (Point* point : by_time) {
        if (!(point->whole.rms < least)) continue;
        least = point->whole.rms;
        point->on_front = true;
    }
}

std::vector<std::string> findings(const std::vector<Point>& points) {
    std::vector<std::string> sentences;
    const auto any = [](const Point& /*point*/) { return true; };
    for (const double target : {0.1, 0.03, 0.01, 0.003, 0.001, 0.0001}) {
        if (const Point* best = fastest(points, target, any))
            sentences.push_back(fmt::format("For an rms error of {:g} at most: {}.", target, words_of(*best)));
        else
            sentences.push_back(fmt::format("No choice of this study has an rms error of {:g} at most.", target));
    }
    for (const auto& [coarse, fine] :
         {std::pair(Shading::kFlat, Shading::kGouraud), {Shading::kGouraud, Shading::kPhong}})
        if (const auto sentence = crossover(points, coarse, fine)) sentences.push_back(*sentence + ".");
    return sentences;
}

}  // namespace twinlight::study
