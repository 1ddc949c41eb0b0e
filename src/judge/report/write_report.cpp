// Writes the files of a report.
#include <algorithm>
#include <filesystem>
#include <functional>
#include <string_view>
#include <system_error>

#include "base/image/file.h"
#include "base/image/png.h"
#include "base/threads/threads.h"
#include "judge/report/report.h"

namespace twinlight::report {

using compare::Comparison;
using compare::Pair;
using compare::Render;

namespace {

Image edge_picture(const Comparison& comparison) {
    Image picture(comparison.width, comparison.height, {0, 0, 0, 1});
    for (std::size_t i = 0; i < comparison.allowed.edge.size(); ++i) {
        if (comparison.allowed.edge[i]) picture.pixels[i] = {1, 1, 1, 1};
    }
    return picture;
}

Image why_picture(const Comparison& comparison) {
    const AllowedDifference& allowed = comparison.allowed;
    Image picture(comparison.width, comparison.height, {0, 0, 0, 1});
    for (std::size_t i = 0; i < allowed.edge.size(); ++i) {
        Whys whys = allowed.edge[i] && !allowed.open.empty() ? allowed.open[i] : 0;
        for (const AllowedPart& part : allowed.parts)
            if (!allowed.edge[i] && allowed.allows(part.why, i)) whys |= bit_of(part.why);
        for (std::size_t c = 0; c < 3; ++c) picture.pixels[i][c] = static_cast<float>(whys >> (8 * c) & 0xFFU) / 255;
    }
    return picture;
}

}  // namespace

std::string picture_file(const Render& render) { return render.name + ".png"; }

std::string step_folder(std::size_t step) { return "step-" + std::to_string(step + 1); }

std::string difference_file(const Comparison& comparison, const Pair& pair) {
    return "difference-" + comparison.a(pair).name + "-" + comparison.b(pair).name + ".png";
}

EncodedPictures encode_pictures(const Comparison& comparison) {
    EncodedPictures pictures{.renders = std::vector<std::string>(comparison.renders.size()),
                             .differences = std::vector<std::string>(comparison.pairs.size()),
                             .edges = {},
                             .why = {}};
    std::vector<std::function<void()>> pieces;
    for (std::size_t i = 0; i < comparison.renders.size(); ++i)
        pieces.emplace_back([&, i] { pictures.renders[i] = encode_png(comparison.renders[i].image); });
    for (std::size_t i = 0; i < comparison.pairs.size(); ++i) {
        pieces.emplace_back([&, i] {
            const Pair& pair = comparison.pairs[i];
            pictures.differences[i] =
                encode_png(difference_picture(comparison.a(pair).image, comparison.counterpart(pair), pair.factor));
        });
    }
    pieces.emplace_back([&] { pictures.edges = encode_png(edge_picture(comparison)); });
    pieces.emplace_back([&] { pictures.why = encode_png(why_picture(comparison)); });
    for_each_on_threads(static_cast<int>(pieces.size()), [&](int piece) { pieces[static_cast<std::size_t>(piece)](); });
    return pictures;
}

namespace {

namespace fs = std::filesystem;

void add_pictures(const Comparison& comparison, const EncodedPictures& pictures, const fs::path& folder,
                  std::vector<FileToWrite>& files) {
    for (std::size_t i = 0; i < comparison.renders.size(); ++i)
        files.push_back({(folder / picture_file(comparison.renders[i])).string(), pictures.renders[i]});
    for (std::size_t i = 0; i < comparison.pairs.size(); ++i)
        files.push_back(
            {(folder / difference_file(comparison, comparison.pairs[i])).string(), pictures.differences[i]});
}

// Whether a report writes a picture of this name: "fixed.png", "difference-fixed-reference.png".
bool is_picture_of_report(std::string_view name) {
    constexpr std::string_view kDifference = "difference-", kEnd = ".png";
    if (!name.ends_with(kEnd)) return false;
    name.remove_suffix(kEnd.size());
    const bool is_difference = name.starts_with(kDifference);
    if (is_difference) name.remove_prefix(kDifference.size());
    for (const std::string_view renderer : {"fixed", "shaders", "reference"})
        if (name == renderer || name.starts_with(std::string(renderer) + "-"))
            return is_difference || name.find('-') == std::string_view::npos || name.ends_with("-phong") ||
                   name.ends_with("-exact");
    return false;
}

// The pictures of an earlier report in this folder that are not among `files`.
std::vector<std::string> stale_pictures(const fs::path& root, const std::vector<FileToWrite>& files) {
    std::vector<std::string> stale;
    std::error_code error;
    if (!fs::exists(root / "comparison.json", error)) return stale;
    const auto add_from = [&](const fs::path& folder) {
        for (const auto& entry : fs::directory_iterator(folder, error)) {
            const std::string path = (folder / entry.path().filename()).string();
            if (is_picture_of_report(entry.path().filename().string()) &&
                std::ranges::find(files, path, &FileToWrite::path) == files.end())
                stale.push_back(path);
        }
    };
    add_from(root);
    for (std::size_t step = 0; fs::is_directory(root / step_folder(step), error); ++step)
        add_from(root / step_folder(step));
    return stale;
}

// Writes the files, and removes folders of steps that an earlier report had.
void write_all(const fs::path& root, std::size_t steps, const std::vector<FileToWrite>& files) {
    write_files_atomically(files, stale_pictures(root, files), MissingFolders::kMade);
    std::error_code ignored;
    for (std::size_t step = steps; fs::is_directory(root / step_folder(step), ignored); ++step)
        fs::remove(root / step_folder(step), ignored);  // if it is empty
}

}  // namespace

void write_report(const Comparison& comparison, const std::string& folder) {
    const EncodedPictures pictures = encode_pictures(comparison);
    const std::string json = comparison_json(comparison);
    const std::string page = comparison_page({{"", comparison, pictures}});
    const fs::path root = folder;
    std::vector<FileToWrite> files;
    add_pictures(comparison, pictures, root, files);
    files.push_back({(root / "comparison.json").string(), json});
    files.push_back({(root / "index.html").string(), page});
    write_all(root, 0, files);
}

void write_report(const std::vector<ComparedStep>& steps, const std::string& folder) {
    const fs::path root = folder;
    std::vector<EncodedPictures> pictures;
    for (const ComparedStep& step : steps) pictures.push_back(encode_pictures(step.comparison));
    std::vector<Compared> compared;
    std::vector<FileToWrite> files;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        compared.push_back({steps[i].title, steps[i].comparison, pictures[i]});
        add_pictures(steps[i].comparison, pictures[i], root / step_folder(i), files);
    }
    const std::string json = steps_json(steps), page = comparison_page(compared);
    files.push_back({(root / "comparison.json").string(), json});
    files.push_back({(root / "index.html").string(), page});
    write_all(root, steps.size(), files);
}

}  // namespace twinlight::report
