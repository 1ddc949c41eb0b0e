// What accuracy costs in time: each choice's time and its error against the truth, the choices that no other beats, and
// sentences that say which to take.
//
// Truth: the reference with exact surfaces, in double (docs/accuracy.md).
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
#include "scene/state/frame.h"

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
    std::string name;  // where there are several: what tells it from the others
    Machine machine;
    std::string driver;
    int rounds = 0;
    std::vector<std::string> findings;        // sentences: what to choose, where one choice overtakes another
    std::optional<SpectralStudy> spectral{};  // of scenes with spectra

    friend bool operator==(const Series&, const Series&) = default;
};

struct Point {
    std::size_t series = 0;
    Choice choice;
    std::vector<double> seconds;  // a frame, one for each round
    Errors errors;
    std::string picture_png, difference_png;  // empty: not at hand; the second amplified by difference_factor
    int difference_factor = 1;
    std::array<bool, kMeasureCount> on_front{};  // by each measure

    double median_seconds() const;
    std::array<double, 2> quartiles_seconds() const;
    bool is_timed() const { return !seconds.empty(); }
};

struct Study {
    std::string scene;
    std::string fingerprint;  // of the scene's text: equal scenes have equal ones
    int width = 0, height = 0;
    Extent extent = Extent::kFull;
    int coverage = 1;  // the samples of truth along a pixel's side
    std::vector<Series> series;
    std::vector<Point> points;  // of one series together
    std::string truth_png;
};

// ---- How it is made ----

// A frame made ready to be drawn again and again.
struct Prepared {
    std::function<void()> draw;      // returns when the picture is drawn
    std::function<Image()> picture;  // draws it and gives it
};

// A choice that this scene or this driver does not go with.
struct Refused : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct ChoiceRenderers {
    // Throws Refused: the choice is left out.
    std::function<Prepared(const Frame& frame, const Choice& choice)> prepare;
    // Which shape is seen at each pixel: render/reference/reference.h.
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
    double seconds = 60;             // for timing; every choice is timed three times at least
    const Study* earlier = nullptr;  // whose times are taken over, of one series
    // Called before each piece of work; false ends the study with what it has.
    std::function<bool(const Progress& progress)> progress;
};

// `frame_of(n)`: the scene in n slices, 0 for as it is. Throws what the renderers throw. Who calls fills in the scene's name and
// fingerprint, the machine and the driver.
Study run(const std::function<Frame(int slices)>& frame_of, bool has_slices, const ChoiceRenderers& renderers,
          const Settings& settings);

// Several machines' studies of one scene in one. Throws MergeError where they are of different ones.
struct NamedStudy {
    std::string file;
    Study study;
};
struct MergeError : std::runtime_error {
    using std::runtime_error::runtime_error;
};
Study merged(std::vector<NamedStudy> studies);
// Why the two cannot be held against each other: "of another scene"; empty where they can.
std::string difference_of(const Study& a, const Study& b);

// ---- What follows from the points ----

// Sets Point::on_front: no other point of the series is both as fast and as accurate, over all pixels; errors that differ by less
// than half a percent count as the same, so that the last bits of two programs are not told as accuracy.
inline constexpr double kSameError = 0.995;
void find_fronts(Study& study);
// Sets Series::findings.
void find_words(Study& study);

// ---- What is written ----

// {"format": "twinlight study", "version": 2, "scene", "fingerprint", "size": [w, h], "extent": "full"|"quick", "coverage",
//  "series": [{"name", "machine": {"processor", "cores", "system"}, "driver", "rounds", "findings": ["sentence"],
//              "spectral": what spectral_json() gives, of scenes with spectra}],
//  "points": [{"series": 0, "key", "words", "axes": {"renderer": "fixed", ...}, "seconds": {"median", "q1", "q3", "samples": []},
//              "error": {"whole"|"interior"|"silhouette": {"pixels", a value of each measure, "psnr_db"}},
//              "front": ["rms", ...], "picture", "difference", "difference_factor"}]}
// Pictures are named by their files, beside study.json; null where there are none.
inline constexpr const char* kFormat = "twinlight study";
inline constexpr int kFormatVersion = 2;
std::string study_json(const Study& study);
// Throws std::runtime_error that says what is wrong where: "A.json: points[3].seconds: ...". Pictures are not read.
Study read_study(std::string_view json, const std::string& file);

// The file of a point's picture, or of its difference.
std::string picture_file(const Study& study, const Point& point);
std::string difference_file(const Study& study, const Point& point);
inline constexpr const char* kTruthFile = "pictures/truth.png";
// The file of a series' plot of samples.
std::string spectral_file(const Study& study, std::size_t series);

std::string study_csv(const Study& study);  // a line a point, the first names the columns
// Error against time on logarithmic axes, for slides.
std::string study_svg(const Study& study);
// Self-contained: the plot, its points' pictures, a table to sort.
std::string study_page(const Study& study);

// All of these and the pictures into a folder: all files or none. Throws FileError.
void write_study(const Study& study, const std::string& folder);
// A study.json with the pictures that lie beside it; those that do not are left empty. Throws FileError, and as read_study().
Study load_study(const std::string& file);

}  // namespace twinlight::study
