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

namespace {

std::string with_time(const Point& point) {
    return fmt::format("{} ({})", point.choice.words(), milliseconds(point.median_seconds()));
}

constexpr double kVisible = 1;  // a mean Delta E 2000

// What costs most accuracy: the change of the lighting with the largest error, beside the same choice without it; without such
// changes, the outlines of the finest mesh.
std::optional<std::string> largest_loss(const PointsOf& points) {
    const Point* worst = nullptr;
    for (const Point* point : points) {
        const Choice& choice = point->choice;
        if (choice.lighting_change == LightingChange::kWhole || choice.shading != Shading::kPhong) continue;
        if (!worst || point->errors.whole.rms > worst->errors.whole.rms) worst = point;
    }
    if (worst) {
        Choice whole = worst->choice;
        whole.lighting_change = LightingChange::kWhole;
        const auto same = std::ranges::find(points, whole, &Point::choice);
        if (same == points.end()) return {};
        return fmt::format(
            "Simpler lighting costs most accuracy: {} has an rms error of {:.2g}, with all of the lighting {:.2g}.",
            worst->choice.words(), worst->errors.whole.rms, (*same)->errors.whole.rms);
    }
    const Point* finest = nullptr;
    for (const Point* point : points)
        if (is_whole(*point, Shading::kPhong) && (!finest || point->choice.slices > finest->choice.slices))
            finest = point;
    if (!finest || finest->choice.slices == 0) return {};
    return fmt::format(
        "Outlines cost most accuracy: {} has an rms error of {:.2g} inside shapes, and of {:.2g} at outlines.",
        finest->choice.words(), finest->errors.interior.rms, finest->errors.silhouette.rms);
}

}  // namespace

std::vector<std::string> headlines(const Study& study, std::size_t series) {
    PointsOf points = timed_points(study, series);
    if (points.empty()) return {};
    std::ranges::stable_sort(points, {}, [](const Point* point) { return point->median_seconds(); });
    const auto first = [&](const auto& is_meant) {
        const auto found = std::ranges::find_if(points, is_meant);
        return found == points.end() ? nullptr : *found;
    };
    std::vector<std::string> sentences;
    // The reference draws the exact picture itself, so it is no answer.
    const Point* right = first([](const Point* point) {
        return point->choice.method != Method::kReference && point->errors.whole.max <= kCode * (1 + 1e-6);
    });
    sentences.push_back(right ? fmt::format("The fastest choice within 1/255 of the exact picture at every pixel: {}.",
                                            with_time(*right))
                              : "On this driver, no choice is within 1/255 of the exact picture at every pixel.");
    const Point* close = first([](const Point* point) { return point->errors.whole.delta_e <= kVisible; });
    if (close && close != right)
        sentences.push_back(fmt::format(
            "The fastest whose error is hardly visible, with a mean Delta E of at most 1: {}.", with_time(*close)));
    else
        sentences.push_back(
            fmt::format("The fastest of all, {}, has a mean Delta E of {:.2g}; about 1 is just visible.",
                        with_time(*points.front()), points.front()->errors.whole.delta_e));
    if (const auto loss = largest_loss(points)) sentences.push_back(*loss);
    return sentences;
}

}  // namespace twinlight::study
