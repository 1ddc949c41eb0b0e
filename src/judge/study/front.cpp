// The front (the choices for which no other is both faster and more accurate), and sentences that sum up the study.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "judge/study/study.h"
#include "render/look.h"

namespace twinlight::study {

namespace {

using PointsOf = std::vector<const Point*>;

std::string milliseconds(double seconds) { return fmt::format("{:.3g} ms", 1000 * seconds); }

double error_of(const Point& point, const Measure& measure) { return point.errors.whole.*measure.value; }

std::string words_of(const Point& point, const Measure& measure) {
    return fmt::format("{} ({}, {} {:.2g})", point.choice.words(), milliseconds(point.median_seconds()), measure.unit,
                       error_of(point, measure));
}

// The fastest of the points that satisfy `is_meant` and have an error of at most `most`; null if there is none.
template <class IsMeant>
const Point* fastest(const PointsOf& points, const Measure& measure, double most, const IsMeant& is_meant) {
    const Point* best = nullptr;
    for (const Point* point : points) {
        if (error_of(*point, measure) > most || !is_meant(*point)) continue;
        if (!best || point->median_seconds() < best->median_seconds()) best = point;
    }
    return best;
}

// Drawn by shaders with the unchanged lighting model, so that only meshes and shadings are compared.
bool is_whole(const Point& point, Shading shading) {
    const Choice plain{.method = Method::kUniforms, .shading = shading, .slices = point.choice.slices};
    return point.choice == plain;
}

// The error from which on the finer shading, on a coarser mesh, is faster than the coarse shading.
std::optional<std::string> crossover(const PointsOf& points, Shading coarse, Shading fine) {
    const Measure& rms = kMeasures[0];
    std::vector<double> errors;
    for (const Point* point : points)
        if (is_whole(*point, coarse) || is_whole(*point, fine)) errors.push_back(error_of(*point, rms));
    std::sort(errors.rbegin(), errors.rend());
    const Point* last_of_coarse = nullptr;
    for (const double error : errors) {
        const Point* a = fastest(points, rms, error, [&](const Point& point) { return is_whole(point, coarse); });
        const Point* b = fastest(points, rms, error, [&](const Point& point) { return is_whole(point, fine); });
        if (!b || (a && a->median_seconds() <= b->median_seconds())) {
            last_of_coarse = a;
            continue;
        }
        const std::string beaten =
            a ? fmt::format("; {} takes {}", a->choice.words(), milliseconds(a->median_seconds()))
              : fmt::format("; no {} mesh of this study is as accurate", name_of(coarse));
        if (!last_of_coarse)
            return fmt::format("For any error, {} is faster than {}; the fastest is {}", name_of(fine), name_of(coarse),
                               words_of(*b, rms));
        return fmt::format("For an rms error of {:.2g} or less, {} is faster than {}: {}{}", error, name_of(fine),
                           name_of(coarse), words_of(*b, rms), beaten);
    }
    return {};
}

// Adds a sentence for each target error: the fastest choice. A choice that meets several targets is named for the
// strictest.
void recommend(std::vector<std::string>& sentences, const PointsOf& points, const Measure& measure) {
    const auto any = [](const Point& /*point*/) { return true; };
    for (std::size_t i = 0; i < measure.targets.size() && measure.targets[i] > 0; ++i) {
        const double target = measure.targets[i];
        const Point* best = fastest(points, measure, target, any);
        if (!best) {
            sentences.push_back(fmt::format("No choice of this study reaches {}.", measure.demand_of(target)));
            return;  // nor any smaller target
        }
        const bool is_last = i + 1 == measure.targets.size() || measure.targets[i + 1] == 0;
        if (!is_last && fastest(points, measure, measure.targets[i + 1], any) == best) continue;
        sentences.push_back(fmt::format("For {}: {}.", measure.demand_of(target), words_of(*best, measure)));
    }
}

}  // namespace

std::vector<const Point*> timed_points(const Study& study, std::size_t series) {
    std::vector<const Point*> points;
    for (const Point& point : study.points)
        if (point.series == series && point.is_timed()) points.push_back(&point);
    return points;
}

void find_fronts(Study& study) {
    for (std::size_t m = 0; m < kMeasureCount; ++m) {
        for (std::size_t series = 0; series < study.series.size(); ++series) {
            std::vector<Point*> by_time;
            for (Point& point : study.points) {
                if (point.series != series) continue;
                point.on_front[m] = false;
                if (point.is_timed()) by_time.push_back(&point);
            }
            std::ranges::stable_sort(by_time, {}, [&](const Point* point) {
                return std::pair(point->median_seconds(), error_of(*point, kMeasures[m]));
            });
            double least = std::numeric_limits<double>::infinity();
            for (Point* point : by_time) {
                const double error = error_of(*point, kMeasures[m]);
                if (!(error < kSameError * least)) continue;
                least = error;
                point->on_front[m] = true;
            }
        }
    }
}

void write_findings(Study& study) {
    for (std::size_t series = 0; series < study.series.size(); ++series) {
        std::vector<std::string>& sentences = study.series[series].findings;
        sentences.clear();
        const PointsOf points = timed_points(study, series);
        if (points.empty()) continue;
        for (const Measure& measure : kMeasures) recommend(sentences, points, measure);
        for (const auto& [coarse, fine] : {std::pair(Shading::kFlat, Shading::kGouraud),
                                           {Shading::kGouraud, Shading::kPhong},
                                           {Shading::kPhong, Shading::kExact}})
            if (const auto sentence = crossover(points, coarse, fine)) sentences.push_back(*sentence + ".");
    }
}

}  // namespace twinlight::study
