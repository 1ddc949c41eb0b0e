// Reads a study.json, from another machine or an earlier run. Any file may be given, so everything is checked.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/text/json.h"
#include "judge/study/study.h"

namespace twinlight::study {

namespace {

// A JSON value with its path, for error messages.
class Node {
  public:
    Node(const Json& json, std::string path) : json_(&json), path_(std::move(path)) {}

    Node operator[](const char* name) const {
        if (!json_->is_object()) fail("it must be an object");
        const auto found = json_->find(name);
        if (found == json_->end()) fail(fmt::format("'{}' is missing", name));
        return {*found, path_ + (path_.ends_with(' ') ? "" : ".") + name};
    }
    bool has(const char* name) const { return json_->is_object() && json_->contains(name); }
    std::vector<Node> elements() const {
        if (!json_->is_array()) fail("it must be a list");
        std::vector<Node> nodes;
        for (std::size_t i = 0; i < json_->size(); ++i) nodes.push_back({(*json_)[i], fmt::format("{}[{}]", path_, i)});
        return nodes;
    }
    std::string text() const {
        if (!json_->is_string()) fail("it must be a string");
        std::string text = json_->get<std::string>();
        const auto is_control = [](char c) { return static_cast<unsigned char>(c) < ' ' || c == 0x7f; };
        if (std::ranges::any_of(text, is_control)) fail("it contains a control character");
        return text;
    }
    double number(double least, double most) const {
        if (!json_->is_number()) fail("it must be a number");
        const double value = json_->get<double>();
        if (!(value >= least && value <= most)) fail(fmt::format("{} is not in [{:g}, {:g}]", value, least, most));
        return value;
    }
    int whole_number(int least, int most) const {
        if (!json_->is_number_integer()) fail("it must be a whole number");
        return static_cast<int>(number(least, most));
    }
    bool is_null() const { return json_->is_null(); }
    [[noreturn]] void fail(const std::string& what) const {
        throw std::runtime_error(path_ + (path_.ends_with(' ') ? "" : ": ") + what);
    }

  private:
    const Json* json_;
    std::string path_;
};

constexpr double kShortest = 1e-9, kLongest = 1e6;  // seconds of a frame
constexpr int kMany = 1 << 30;
constexpr std::size_t kMostPoints = 10'000;  // each is compared with all others

std::vector<double> read_median(const Node& node) {
    if (node.is_null()) return {};
    return {node.number(kShortest, kLongest)};
}

// Patches must be sorted by light, with the same numbers of samples for each, from few to many.
void check_patches(const std::vector<PatchError>& patches, const Node& node) {
    constexpr std::size_t kMost = 4096;
    if (patches.size() > kMost) node.fail(fmt::format("it has more than {} elements", kMost));
    std::size_t count = 0;  // number of patches of one light
    while (count < patches.size() && patches[count].light == patches[0].light) ++count;
    std::set<std::string> lights;
    for (std::size_t i = 0; i < patches.size(); ++i) {
        const bool is_first = i % count == 0;
        const bool is_right =
            patches[i].light == patches[i - i % count].light && patches[i].samples == patches[i % count].samples &&
            (is_first ? lights.insert(patches[i].light).second : patches[i].samples > patches[i - 1].samples);
        if (!is_right || patches.size() % count != 0)
            node.fail("it must be sorted by light, with the same numbers of samples for each, from few to many");
    }
}

SpectralStudy read_spectral(const Node& node) {
    SpectralStudy study;
    for (const Node& patch : node["patches"].elements())
        study.patches.push_back({.light = patch["light"].text(),
                                 .samples = patch["samples"].whole_number(0, kMany),
                                 .mean = patch["mean"].number(0, kMany),
                                 .max = patch["max"].number(0, kMany),
                                 .worst = patch["worst"].text()});
    check_patches(study.patches, node["patches"]);
    for (const Node& picture : node["pictures"].elements())
        study.pictures.push_back({.samples = picture["samples"].whole_number(0, kMany),
                                  .reference_seconds = read_median(picture["reference_seconds"]),
                                  .sampling_shader_seconds = read_median(picture["sampling_shader_seconds"]),
                                  .shader_seconds = read_median(picture["shader_seconds"]),
                                  .off = {.mean = picture["mean"].number(0, kMany),
                                          .percentile_95 = picture["percentile_95"].number(0, kMany),
                                          .max = picture["max"].number(0, kMany)}});
    const auto is_more = [](const SampledPicture& a, const SampledPicture& b) { return a.samples >= b.samples; };
    if (std::ranges::adjacent_find(study.pictures, is_more) != study.pictures.end())
        node["pictures"].fail("it must go from few samples to many");
    study.findings = spectral_findings(study);
    return study;
}

Series read_series(const Node& node) {
    const Node machine = node["machine"];
    return {.name = node["name"].text(),
            .machine = {.processor = machine["processor"].text(),
                        .cores = machine["cores"].whole_number(0, kMany),
                        .system = machine["system"].text()},
            .driver = node["driver"].text(),
            .library = node.has("library") ? node["library"].text() : "",
            .rounds = node["rounds"].whole_number(0, kMany),
            .findings = {},
            .spectral = node.has("spectral") ? std::optional(read_spectral(node["spectral"])) : std::nullopt};
}

Error read_error(const Node& node) {
    Error error;
    error.pixels = static_cast<std::size_t>(node["pixels"].whole_number(0, kMany));
    for (const Measure& measure : kMeasures) error.*measure.value = node[measure.name].number(0, kLargestError);
    return error;
}

Choice read_choice(const Node& node) {
    Choice choice;
    for (const Axis& axis : axes()) {
        const Node value = node[axis.name];
        std::string key;
        if (!axis.is_number)
            key = value.text();
        else if (!value.is_null())
            key = fmt::format("{}", value.number(0, kMany));
        if (!axis.set(choice, key))
            value.fail(axis.is_number ? fmt::format("'{}' is not a legal number here", key)
                                      : fmt::format("'{}' is not one of {}", key, axis.keys()));
    }
    return choice;
}

Point read_point(const Node& node, std::size_t series_count) {
    Point point;
    point.series = static_cast<std::size_t>(node["series"].whole_number(0, static_cast<int>(series_count) - 1));
    point.choice = read_choice(node["axes"]);
    for (const Node& sample : node["seconds"]["samples"].elements())
        point.seconds.push_back(sample.number(0, kLongest));
    for (const char* name : {"median", "q1", "q3"})  // computed from the samples again, but no less checked
        if (const Node value = node["seconds"][name]; !value.is_null()) value.number(0, kLongest);
    for (const Region& region : kRegions) point.errors.*region.errors = read_error(node["error"][region.name]);
    point.difference_factor = node["difference_factor"].whole_number(1, kMany);
    return point;
}

Extent read_extent(const Node& node) {
    const std::string text = node.text();
    for (const Extent extent : {Extent::kQuick, Extent::kFull})
        if (text == name_of(extent)) return extent;
    node.fail(fmt::format("'{}' is not one of quick, full", text));
}

}  // namespace

Study read_study(std::string_view text, const std::string& file) {
    const Json json = parsed_json(text);
    if (json.is_discarded()) throw std::runtime_error(file + ": this is not JSON");
    if (!json.is_object() || json.value("format", Json()) != kFormat)
        throw std::runtime_error(file + ": this is not a study; `twinlight study` writes studies as study.json");
    const Node root(json, file + ": ");
    if (const Node version = root["version"]; version.whole_number(0, kMany) != kFormatVersion)
        version.fail(fmt::format("this program reads version {}; run the study again", kFormatVersion));
    Study study;
    study.scene = root["scene"].text();
    study.fingerprint = root["fingerprint"].text();
    const std::vector<Node> size = root["size"].elements();
    if (size.size() != 2) root["size"].fail("it must be [width, height]");
    study.width = size[0].whole_number(1, kMany);
    study.height = size[1].whole_number(1, kMany);
    study.extent = read_extent(root["extent"]);
    study.coverage = root["coverage"].whole_number(1, kMostCoverage);
    for (const Node& series : root["series"].elements()) study.series.push_back(read_series(series));
    if (study.series.empty()) root["series"].fail("it is empty");
    const std::vector<Node> points = root["points"].elements();
    if (points.size() > kMostPoints) root["points"].fail(fmt::format("it has more than {} elements", kMostPoints));
    for (const Node& node : points) {
        study.points.push_back(read_point(node, study.series.size()));
        const Point& point = study.points.back();
        const auto is_same = [&](const Point& other) {
            return other.series == point.series && other.choice == point.choice;
        };
        if (std::ranges::count_if(study.points, is_same) > 1) node.fail("this choice is listed twice");
    }
    find_fronts(study);
    write_findings(study);
    return study;
}

}  // namespace twinlight::study
