// What accuracy costs in time: each choice's time and its error against the truth, the choices that no other beats, and
// sentences that say which to take.
//
// Truth: the reference with exact surfaces, in double (docs/accuracy.md). Errors are of channels on [0,1], of red, green and blue.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "image/image.h"
#include "state/frame.h"
#include "study/choice.h"
#include "study/spectral.h"

namespace twinlight::study {

// A frame made ready to be drawn again and again by one renderer.
struct Prepared {
    std::function<void()> draw;      // returns when the picture is drawn
    std::function<Image()> picture;  // draws it and gives it
};
using Prepare = std::function<Prepared(const Frame& frame, const RenderOptions& options)>;

struct Renderers {
    Prepare fixed, programmable, reference;
    // Which shape is seen at each pixel: reference/reference.h.
    std::function<std::vector<int>(const Frame& frame, const RenderOptions& options)> seen;
};

struct Error {
    std::size_t pixels = 0;
    double max = 0;
    double rms = 0;

    double psnr_db() const;  // 20 log10(1 / rms); infinite where there is none
};

struct Point {
    Choice choice;
    std::vector<double> seconds;  // a frame, one for each round
    Error whole;                  // of all pixels
    Error interior,
        silhouette;  // where the same shape is seen as in truth, and more than a pixel from where another is; elsewhere
    Image picture, difference;  // the second amplified by difference_factor
    int difference_factor = 1;
    bool on_front = false;

    double median_seconds() const;
    std::array<double, 2> quartiles_seconds() const;
};

struct Study {
    std::string scene, driver;
    int width = 0, height = 0;
    int rounds = 0;
    std::vector<Point> points;
    Image truth;
    std::vector<std::string> findings;      // sentences: what to choose, where one choice overtakes another
    std::optional<SpectralStudy> spectral;  // of scenes with spectra
};

struct Settings {
    Extent extent = Extent::kFull;
    double seconds = 60;  // for timing; every choice is timed three times at least
    // Called before each piece of work; false ends the study with what it has.
    std::function<bool(int done, int total, const std::string& next)> progress;
};

// `frame_of(n)`: the scene in n slices, 0 for as it is. Throws what the renderers throw.
Study run(const std::function<Frame(int slices)>& frame_of, bool has_slices, const Renderers& renderers,
          const Settings& settings);

// ---- What follows from the points ----

// Sets on_front: no other point is both as fast and as accurate (rms of all pixels).
void find_front(std::vector<Point>& points);
std::vector<std::string> findings(const std::vector<Point>& points);

// ---- What is written ----

// {"scene", "driver", "size": [w, h], "rounds",
//  "points": [{"key", "words", "renderer", "tier", "shading", "slices", "budget", "seconds": {"median", "q1", "q3", "samples"},
//              "error": {"whole"|"interior"|"silhouette": {"pixels", "max", "rms", "psnr_db"}}, "on_front"}],
//  "findings": ["sentence"],
//  "spectral": as spectral_json() gives it, of scenes with spectra}
std::string study_json(const Study& study);
std::string study_csv(const Study& study);  // a line a point, the first names the columns
// Error against time on logarithmic axes, for slides.
std::string study_svg(const Study& study);
// Self-contained: the plot, its points' pictures, a table to sort.
std::string study_page(const Study& study);

}  // namespace twinlight::study
