// Writes the files of a report.
#include <filesystem>
#include <system_error>

#include "base/image/file.h"
#include "base/image/png.h"
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

}  // namespace

std::string picture_file(const Render& render) { return render.name + ".png"; }

std::string difference_file(const Comparison& comparison, const Pair& pair) {
    return "difference-" + comparison.a(pair).name + "-" + comparison.b(pair).name + ".png";
}

EncodedPictures encode_pictures(const Comparison& comparison) {
    EncodedPictures pictures;
    for (const Render& render : comparison.renders) pictures.renders.push_back(encode_png(render.image));
    for (const Pair& pair : comparison.pairs) {
        pictures.differences.push_back(
            encode_png(difference_picture(comparison.a(pair).image, comparison.counterpart(pair), pair.factor)));
    }
    pictures.edges = encode_png(edge_picture(comparison));
    return pictures;
}

void write_report(const Comparison& comparison, const std::string& folder) {
    const EncodedPictures pictures = encode_pictures(comparison);
    const std::string json = comparison_json(comparison);
    const std::string page = comparison_page({{"", comparison, pictures}});

    std::vector<FileToWrite> files;
    const auto add = [&](const std::string& name, std::string_view bytes) {
        files.push_back({(std::filesystem::path(folder) / name).string(), bytes});
    };
    for (std::size_t i = 0; i < comparison.renders.size(); ++i) {
        add(picture_file(comparison.renders[i]), pictures.renders[i]);
    }
    for (std::size_t i = 0; i < comparison.pairs.size(); ++i) {
        add(difference_file(comparison, comparison.pairs[i]), pictures.differences[i]);
    }
    add("comparison.json", json);
    add("index.html", page);

    const bool made = make_folder(folder);
    try {
        write_files_atomically(files);
    } catch (const FileError&) {
        std::error_code ignored;
        if (made) std::filesystem::remove(folder, ignored);
        throw;
    }
}

}  // namespace twinlight::report
