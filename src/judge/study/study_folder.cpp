// The folder of a study: study.json, study.csv, plots, index.html and the pictures.
#include <filesystem>
#include <set>
#include <stdexcept>
#include <utility>

#include "base/image/file.h"
#include "judge/study/study.h"

namespace twinlight::study {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMostBytes = std::size_t{256} << 20;

// The files that the study in this folder wrote besides those that every study has. Empty if there is none, or if its
// study.json cannot be read.
std::set<std::string> files_of_earlier(const std::string& folder) {
    const std::string file = (fs::path(folder) / "study.json").string();
    std::set<std::string> names;
    try {
        const Study earlier = read_study(read_file(file, kMostBytes), file);
        for (const Point& point : earlier.points) {
            names.insert(picture_file(earlier, point));
            names.insert(difference_file(earlier, point));
        }
        for (std::size_t i = 0; i < earlier.series.size(); ++i) {
            names.insert(spectral_file(earlier, i));
            if (!earlier.series[i].spectral) continue;
            for (const SampledPicture& picture : earlier.series[i].spectral->pictures)
                names.insert(sampled_picture_file(earlier, i, picture.samples));
        }
        names.insert(kTruthFile);
    } catch (const std::runtime_error&) {
        names.clear();
    }
    return names;
}

}  // namespace

void write_study(const Study& study, const std::string& folder) {
    std::error_code error;
    fs::create_directories(fs::path(folder) / "pictures", error);
    if (error) throw FileError(folder + ": " + error.message());
    std::vector<FileToWrite> files;
    const auto add = [&](const std::string& name, std::string_view bytes) {
        files.push_back({(fs::path(folder) / name).string(), bytes});
    };
    if (!study.truth_png.empty()) add(kTruthFile, study.truth_png);
    for (const Point& point : study.points) {
        if (point.picture_png.empty()) continue;
        add(picture_file(study, point), point.picture_png);
        add(difference_file(study, point), point.difference_png);
    }
    const std::string json = study_json(study), csv = study_csv(study), svg = study_svg(study),
                      page = study_page(study);
    add("study.json", json);
    add("study.csv", csv);
    add("study.svg", svg);
    add("index.html", page);
    const std::string shading = shading_svg(study), outlines = outlines_svg(study), changes = changes_svg(study);
    for (const auto& [name, plot] :
         {std::pair("shading.svg", &shading), {"outlines.svg", &outlines}, {"changes.svg", &changes}})
        if (!plot->empty()) add(name, *plot);
    std::vector<std::string> plots;  // of samples
    plots.reserve(study.series.size());
    for (std::size_t i = 0; i < study.series.size(); ++i) {
        if (!study.series[i].spectral) continue;
        add(spectral_file(study, i), plots.emplace_back(spectral_svg(*study.series[i].spectral)));
        for (const SampledPicture& picture : study.series[i].spectral->pictures)
            if (!picture.png.empty()) add(sampled_picture_file(study, i, picture.samples), picture.png);
    }
    std::set<std::string> stale = files_of_earlier(folder);
    write_files_atomically(files);
    for (const FileToWrite& file : files) stale.erase(fs::path(file.path).lexically_relative(folder).string());
    for (const std::string& name : stale) fs::remove(fs::path(folder) / name, error);
}

Study load_study(const std::string& file) {
    Study study = read_study(read_file(file, kMostBytes), file);
    const fs::path folder = fs::path(file).parent_path();
    const auto picture = [&](const std::string& name) {
        constexpr std::size_t kMostPictureBytes = std::size_t{64} << 20;
        return fs::exists(folder / name) ? read_file((folder / name).string(), kMostPictureBytes) : std::string();
    };
    study.truth_png = picture(kTruthFile);
    for (Point& point : study.points) {
        point.picture_png = picture(picture_file(study, point));
        point.difference_png = picture(difference_file(study, point));
        if (point.difference_png.empty()) point.picture_png.clear();
    }
    for (std::size_t i = 0; i < study.series.size(); ++i)
        if (study.series[i].spectral)
            for (SampledPicture& sampled : study.series[i].spectral->pictures)
                sampled.png = picture(sampled_picture_file(study, i, sampled.samples));
    return study;
}

}  // namespace twinlight::study
