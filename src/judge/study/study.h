// A study shows how much time accuracy costs: the time and the error of each choice, the best choices (nothing is both
// faster and more accurate), and sentences that sum it up.
//
// Errors are differences from the exact picture: the reference with exact surfaces, in double (docs/accuracy.md). The
// code calls it the truth.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/image/image.h"
#include "judge/study/choice.h"
#include "judge/study/measure.h"
#include "judge/study/spectral.h"
#include "scene/frame/frame.h"

namespace twinlight::study {

// ---- What a study holds ----

struct Machine {
    std::string processor;  // "AMD EPYC 7763"
    int cores = 0;
    std::string system;  // "Debian GNU/Linux 12 (bookworm), Linux 6.1.0"

    friend bool operator==(const Machine&, const Machine&) = default;
};

// What was measured on one machine.
struct Series {
    std::string name;  // distinguishes it from other series of the study
    Machine machine;
    std::string driver;   // driver_name()
    std::string library;  // gl_library()
    int rounds = 0;
    std::vector<std::string> findings;        // sentences: the fastest choice for each error
    std::optional<SpectralStudy> spectral{};  // only for scenes with spectra

    friend bool operator==(const Series&, const Series&) = default;
};

struct Point {
    std::size_t series = 0;
    Choice choice;
    std::vector<double> seconds;  // times of a frame, one for each round
    Errors errors;
    std::string picture_png, difference_png;  // empty: missing; the difference is amplified by difference_factor
    int difference_factor = 1;
    std::array<bool, kMeasureCount> on_front{};  // for each measure

    double median_seconds() const;
    std::array<double, 2> quartiles_seconds() const;
    bool is_timed() const { return !seconds.empty(); }
};

struct Study {
    std::string scene;
    std::string fingerprint;  // a hash of the scene's text
    int width = 0, height = 0;
    Extent extent = Extent::kFull;
    int coverage = 1;  // samples of the exact picture along a pixel's side
    std::vector<Series> series;
    std::vector<Point> points;  // points of the same series are adjacent
    std::string truth_png;
};

// ---- Running a study ----

// A frame that is prepared for drawing.
struct Prepared {
    std::function<void()> draw;      // returns when the picture is drawn
    std::function<Image()> picture;  // draws it and returns it
};

// Thrown for a choice that the scene or the driver does not support.
struct Refused : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct ChoiceRenderers {
    // Throws Refused where the choice is not supported; the study leaves it out. So do other errors, which are
    // reported.
    std::function<Prepared(const Frame& frame, const Choice& choice)> prepare;
    // The shape that is seen at each pixel (render/reference/reference.h).
    std::function<std::vector<int>(const Frame& frame, const reference::Options& options)> seen;
};

struct Progress {
    int done = 0, total = 0;
    std::string next;
    double seconds_left = 0;
};

struct Settings {
    Extent extent = Extent::kFull;
    int coverage = 1;
    double seconds = 60;             // for timing; every choice is timed at least three times
    std::vector<Choice> choices{};   // empty: those of select_choices()
    const Study* earlier = nullptr;  // a study with one series to continue; its times are kept
    // Called for a choice that a renderer fails to draw, with the reason; the study leaves the choice out.
    std::function<void(const Choice& choice, const std::string& reason)> failed{};
    // Called before each step; false ends the study, which keeps its results.
    std::function<bool(const Progress& progress)> progress;
};

// `frame_of(n)`: the scene with n slices; 0: unchanged. Throws what the renderers throw. The caller fills in the name
// and fingerprint of the scene, the machine and the driver.
Study run(const std::function<Frame(int slices)>& frame_of, bool has_slices, const ChoiceRenderers& renderers,
          const Settings& settings);

// Merges studies of one scene from several machines. Throws MergeError where difference_of() is not empty.
struct NamedStudy {
    std::string file;
    Study study;
};
struct MergeError : std::runtime_error {
    using std::runtime_error::runtime_error;
};
Study merged(std::vector<NamedStudy> studies);
// Why the studies cannot be compared: "of 9 x 8 pixels, not 8 x 8"; empty if they can.
std::string difference_of(const Study& a, const Study& b);

// ---- Results computed from the points ----

// The points of a series whose times were measured.
std::vector<const Point*> timed_points(const Study& study, std::size_t series);

// Sets Point::on_front: no other point of the series is both as fast and as accurate, over all pixels. Errors that
// differ by less than half a percent count as equal, so that rounding does not count as accuracy.
inline constexpr double kSameError = 0.995;
void find_fronts(Study& study);
// Sets Series::findings.
void write_findings(Study& study);
// Three sentences about a series at most: the fastest choice that is right at every pixel, the fastest whose error is
// hardly visible, and what costs most accuracy.
std::vector<std::string> headlines(const Study& study, std::size_t series);

// ---- Files ----

// {"format": "twinlight study", "version": 2, "scene", "fingerprint", "size": [w, h], "extent": "full"|"quick", "coverage",
//  "series": [{"name", "machine": {"processor", "cores", "system"}, "driver", "library", "rounds", "findings": ["sentence"],
//              "spectral": see spectral_json(); only for scenes with spectra}],
//  "points": [{"series": 0, "key", "words", "axes": {"renderer": "fixed", ...}, "seconds": {"median", "q1", "q3", "samples": []},
//              "error": {"whole"|"interior"|"silhouette": {"pixels", a value for each measure, "psnr_db"}},
//              "front": ["rms", ...], "picture", "difference", "difference_factor"}]}
// "picture" and "difference" are file names relative to study.json, or null.
inline constexpr const char* kFormat = "twinlight study";
inline constexpr int kFormatVersion = 2;
std::string study_json(const Study& study);
// Does not read pictures. Throws std::runtime_error with the place of the error: "A.json: points[3].seconds: ...".
Study read_study(std::string_view json, const std::string& file);

// The file name of a point's picture, or of its difference.
std::string picture_file(const Study& study, const Point& point);
std::string difference_file(const Study& study, const Point& point);
inline constexpr const char* kTruthFile = "pictures/truth.png";
// The file names of a series' plot of samples, and of the scene's picture with a number of samples.
std::string spectral_file(const Study& study, std::size_t series);
std::string sampled_picture_file(const Study& study, std::size_t series, int samples);

std::string study_csv(const Study& study);  // a line for each point; the first line names the columns
// A plot of error against time on logarithmic axes, for slides.
std::string study_svg(const Study& study);
// Plots of one finding each, from the points of the first machine; empty if the study does not measure it: error against
// time for each shading, errors inside shapes and at outlines against slices, errors of changes of the lighting.
std::string shading_svg(const Study& study);
std::string outlines_svg(const Study& study);
std::string changes_svg(const Study& study);
// A self-contained page: the plot, the pictures, a table that can be sorted.
std::string study_page(const Study& study);

// Writes these files and the pictures into a folder: all of them or none. Throws FileError.
void write_study(const Study& study, const std::string& folder);
// Reads a study.json and the pictures next to it; missing pictures stay empty. Throws FileError, and what read_study()
// throws.
Study load_study(const std::string& file);

}  // namespace twinlight::study
