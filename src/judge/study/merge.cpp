// Merges studies of one scene from several machines.
#include <fmt/format.h>

#include <set>

#include "judge/study/study.h"
#include "render/context/driver_name.h"

namespace twinlight::study {

namespace {

// Gives each series a different name: the driver, or with its provider, or with the processor, or with a number.
void name_apart(std::vector<Series>& all) {
    const auto try_names = [&](const auto& name) {
        std::set<std::string> names;
        for (std::size_t i = 0; i < all.size(); ++i) names.insert(all[i].name = name(all[i], i));
        return names.size() == all.size();
    };
    const auto by_driver = [](const Series& series, std::size_t) { return parse_driver_name(series.driver).renderer; };
    const auto by_provider = [](const Series& series, std::size_t) {
        const Driver driver = parse_driver_name(series.driver);
        return driver.renderer + ", " + driver.provider;
    };
    const auto by_machine = [](const Series& series, std::size_t) {
        return parse_driver_name(series.driver).renderer + ", " + series.machine.processor;
    };
    const auto by_number = [&](const Series& series, std::size_t i) {
        return fmt::format("{} ({})", by_machine(series, i), i + 1);
    };
    try_names(by_driver) || try_names(by_provider) || try_names(by_machine) || try_names(by_number);
}

}  // namespace

std::string difference_of(const Study& a, const Study& b) {
    if (a.fingerprint != b.fingerprint)
        return a.scene == b.scene ? fmt::format("of a different version of the scene '{}'", b.scene)
                                  : fmt::format("of the scene '{}', not '{}'", b.scene, a.scene);
    if (a.width != b.width || a.height != b.height)
        return fmt::format("of {} x {} pixels, not {} x {}", b.width, b.height, a.width, a.height);
    if (a.coverage != b.coverage)
        return fmt::format("with an exact picture of {0} x {0} samples per pixel, not {1} x {1}", b.coverage,
                           a.coverage);
    return {};
}

Study merged(std::vector<NamedStudy> studies) {
    Study result = studies.at(0).study;
    for (std::size_t i = 1; i < studies.size(); ++i) {
        Study& other = studies[i].study;
        if (const std::string difference = difference_of(result, other); !difference.empty())
            throw MergeError(
                fmt::format("{} is {} like {}; only studies of the same scene, size and coverage can be merged",
                            studies[i].file, difference, studies[0].file));
        for (Point& point : other.points) {
            point.series += result.series.size();
            result.points.push_back(std::move(point));
        }
        result.series.insert(result.series.end(), other.series.begin(), other.series.end());
        if (other.extent == Extent::kFull) result.extent = Extent::kFull;
        if (result.truth_png.empty()) result.truth_png = std::move(other.truth_png);
    }
    name_apart(result.series);
    find_fronts(result);
    write_findings(result);
    return result;
}

}  // namespace twinlight::study
