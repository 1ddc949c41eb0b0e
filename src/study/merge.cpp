// Several machines' studies of one scene, laid over each other.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "study/study.h"

namespace twinlight::study {

std::string short_name(const std::string& driver) {
    const std::size_t end = driver.find("), ");
    return end == std::string::npos ? driver.substr(0, driver.find(',')) : driver.substr(0, end + 1);
}

std::string difference_of(const Study& a, const Study& b) {
    if (a.fingerprint != b.fingerprint)
        return a.scene == b.scene ? fmt::format("of a scene '{}' that says something else", b.scene)
                                  : fmt::format("of the scene '{}', not '{}'", b.scene, a.scene);
    if (a.width != b.width || a.height != b.height)
        return fmt::format("of {} x {} pixels, not {} x {}", b.width, b.height, a.width, a.height);
    if (a.coverage != b.coverage)
        return fmt::format("against a truth of {0} x {0} samples a pixel, not {1} x {1}", b.coverage, a.coverage);
    return {};
}

Study merged(std::vector<NamedStudy> studies) {
    Study result = studies.at(0).study;
    for (std::size_t i = 1; i < studies.size(); ++i) {
        Study& other = studies[i].study;
        if (const std::string difference = difference_of(result, other); !difference.empty())
            throw MergeError(fmt::format("{} is {} as {}; studies of one scene, size and truth can be merged",
                                         studies[i].file, difference, studies[0].file));
        for (Point& point : other.points) {
            point.series += result.series.size();
            result.points.push_back(std::move(point));
        }
        result.series.insert(result.series.end(), other.series.begin(), other.series.end());
        if (other.extent == Extent::kFull) result.extent = Extent::kFull;
        if (result.truth_png.empty()) result.truth_png = std::move(other.truth_png);
    }
    // Named by what tells them apart: the driver, else the machine too, else a number.
    const auto are_different = [&] {
        std::set<std::string> names;
        for (const Series& series : result.series) names.insert(series.name);
        return names.size() == result.series.size();
    };
    for (Series& series : result.series) series.name = short_name(series.driver);
    if (!are_different())
        for (Series& series : result.series) series.name += ", " + series.machine.processor;
    if (!are_different())
        for (std::size_t i = 0; i < result.series.size(); ++i) result.series[i].name += fmt::format(" ({})", i + 1);
    find_fronts(result);
    result.findings = findings(result);
    return result;
}

}  // namespace twinlight::study
