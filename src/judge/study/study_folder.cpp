// The folder of a study: study.json, study.csv, plots, index.html and the pictures.
#include <filesystem>
#include <utility>

#include "base/image/file.h"
#include "judge/study/study.h"

namespace twinlight::study {

namespace fs = std::filesystem;

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
    write_files_atomically(files);
}

Study load_study(const std::string& file) {
    constexpr std::size_t kMostBytes = std::size_t{256} << 20;
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
