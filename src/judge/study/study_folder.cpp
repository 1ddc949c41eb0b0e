// The folder of a study: study.json, study.csv, plots, index.html and the pictures.
#include <filesystem>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include "base/image/file.h"
#include "judge/study/study.h"

namespace twinlight::study {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMostBytes = std::size_t{256} << 20;

// Visits the pictures of a study: the name of each one's file, and its bytes.
template <class AnyStudy, class Visit>
void for_each_picture(AnyStudy& study, const Visit& visit) {
    visit(std::string(kTruthFile), &study.truth_png);
    for (auto& point : study.points) {
        visit(picture_file(study, point), &point.picture_png);
        visit(difference_file(study, point), &point.difference_png);
    }
    for (std::size_t i = 0; i < study.series.size(); ++i) {
        if (!study.series[i].spectral) continue;
        for (auto& sampled : study.series[i].spectral->pictures)
            visit(sampled_picture_file(study, i, sampled.samples), &sampled.png);
    }
}

// The plots, and the names of their files; only those that the study has.
std::vector<std::pair<std::string, std::string>> plots_of(const Study& study) {
    std::vector<std::pair<std::string, std::string>> plots = {{"shading.svg", shading_svg(study)},
                                                              {"outlines.svg", outlines_svg(study)},
                                                              {"changes.svg", changes_svg(study)}};
    for (std::size_t i = 0; i < study.series.size(); ++i)
        if (study.series[i].spectral)
            plots.emplace_back(spectral_file(study, i), spectral_svg(*study.series[i].spectral));
    std::erase_if(plots, [](const auto& plot) { return plot.second.empty(); });
    return plots;
}

// The files of the study in this folder besides those that every study has. Empty if there is no study, or if its study.json
// cannot be read.
std::set<std::string> files_of_earlier(const std::string& folder) {
    const std::string file = (fs::path(folder) / "study.json").string();
    std::set<std::string> names;
    try {
        const Study earlier = read_study(read_file(file, kMostBytes), file);
        for_each_picture(earlier, [&](const std::string& name, const std::string*) { names.insert(name); });
        for (const auto& [name, plot] : plots_of(earlier)) names.insert(name);
    } catch (const std::runtime_error&) {
        names.clear();
    }
    return names;
}

}  // namespace

void write_study(const Study& study, const std::string& folder) {
    std::vector<FileToWrite> files;
    const auto add = [&](const std::string& name, std::string_view bytes) {
        files.push_back({(fs::path(folder) / name).string(), bytes});
    };
    for_each_picture(study, [&](const std::string& name, const std::string* png) {
        if (!png->empty()) add(name, *png);
    });
    const std::string json = study_json(study), csv = study_csv(study), svg = study_svg(study),
                      page = study_page(study);
    const auto plots = plots_of(study);
    for (const auto& [name, plot] : plots) add(name, plot);
    add("study.json", json);
    add("study.csv", csv);
    add("study.svg", svg);
    add("index.html", page);
    std::set<std::string> earlier = files_of_earlier(folder);
    for (const FileToWrite& file : files) earlier.erase(fs::path(file.path).lexically_relative(folder).string());
    std::vector<std::string> stale;
    for (const std::string& name : earlier) stale.push_back((fs::path(folder) / name).string());
    write_files_atomically(files, stale, MissingFolders::kMade);
}

Study load_study(const std::string& file) {
    Study study = read_study(read_file(file, kMostBytes), file);
    const fs::path folder = fs::path(file).parent_path();
    for_each_picture(study, [&](const std::string& name, std::string* png) {
        constexpr std::size_t kMostPictureBytes = std::size_t{64} << 20;
        *png = fs::exists(folder / name) ? read_file((folder / name).string(), kMostPictureBytes) : std::string();
    });
    for (Point& point : study.points) {  // both or none
        if (point.difference_png.empty()) point.picture_png.clear();
        if (point.picture_png.empty()) point.difference_png.clear();
    }
    return study;
}

}  // namespace twinlight::study
