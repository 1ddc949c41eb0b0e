// The comparison of one scene drawn several ways: three renderers per vertex, two per pixel, and the pairs of
// them that are held against each other.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/image/difference.h"
#include "base/image/image.h"
#include "render/effect/explanation.h"
#include "render/fixed/fixed.h"
#include "render/path.h"
#include "render/programmable/programmable.h"
#include "render/reference/options.h"
#include "scene/state/scene.h"

namespace twinlight::report {

// What compare_scene draws with.
struct Renderers {
    std::function<Image(const Scene&, const fixed::Options&)> fixed;
    std::function<programmable::Picture(const Frame&, const programmable::Options&)> programmable;
    std::function<Image(const Frame&, const reference::Options&)> reference;
    // The pixels where right rasterisers may differ; all others are interior.
    std::function<AllowedDifference(const Frame&, const reference::Options&)> allowed_difference;
};

// Called before each step: how many are done, how many there are, what comes next.
using Progress = std::function<void(int done, int total, std::string_view next)>;

struct Render {
    Path path = Path::kFixed;
    std::string name;     // "fixed", "programmable", "reference", "programmable-phong", "reference-phong"; or -exact
    std::string meaning;  // a sentence for who sees the picture
    Image image;
    double ms = 0;  // one render, the picture read back
    // The reference's picture with quadrilaterals cut the other way, where the scene has any: the specification
    // allows both (QuadCut), so another picture is held against whichever is nearer, pixel by pixel.
    std::optional<Image> other_cut{};
    // What it was drawn from, where that is plans: how far they leave it from the scene is allowed.
    std::vector<ExplainedDraw> plan{};
};

enum class Verdict : std::uint8_t {
    kWithin,       // the tolerance
    kBeyond,       // the tolerance
    kPartial,      // the pictures are not the whole scene, and what both show does not differ beyond the tolerance
    kInformative,  // the two show different models: no tolerance applies
};

// What a judged pair is held to, in the interior, beyond the difference that is allowed for filters and blending: no channel off by
// more than max, and a share of the pixels that differ below differing_share.
struct Tolerance {
    double max = 1 / 255.0;          // one code: two right roundings of one value may be neighbours
    double differing_share = 0.001;  // as rarely as float and double lie on different sides of a rounding border
};

struct Pair {
    std::size_t a = 0, b = 0;  // into Comparison::renders
    ImageDifference difference;
    Verdict verdict = Verdict::kInformative;
    int factor = 1;  // by which the difference picture is amplified
};

struct Comparison {
    std::string scene;
    std::string driver;
    int width = 0, height = 0;
    std::vector<Render> renders;
    std::vector<Pair> pairs;
    AllowedDifference allowed;  // of the per-vertex pictures; its edges are of all
    std::vector<Unsupported> unsupported;
    // Where pictures differ beyond the tolerance: what the scene does of which the driver is known to leave the
    // specification's text, "name (section)". The caller's.
    std::vector<std::string> known_departures{};
    Tolerance tolerance;

    const Render& a(const Pair& pair) const { return renders[pair.a]; }
    const Render& b(const Pair& pair) const { return renders[pair.b]; }
    // b's picture as a's is held against it: of a reference with two cuts, the nearer one at each pixel.
    Image counterpart(const Pair& pair) const;
    Verdict verdict() const;        // kBeyond if a pair is; else kPartial if one is; else kWithin
    bool within_tolerance() const;  // as far as the pictures tell: no pair is beyond
};

// What a comparison says of two pictures that show the whole scene.
Verdict judge(const ImageDifference& difference, const Tolerance& tolerance);

enum class Pictures : std::uint8_t { kAll, kPerVertex };  // the second: each drawn once, and not timed

struct CompareOptions {
    std::string driver;  // its name
    Pictures pictures = Pictures::kAll;
    double budget = PlanOptions{}.budget;  // of shaders
    bool precise = false;  // the programmable per-vertex picture is drawn with programmable::Options::precise
    // kPhong, or kExact, whose pictures, "programmable-exact" and "reference-exact", take the place of phong's.
    Shading per_pixel = Shading::kPhong;
};

// The per-vertex pictures follow GL's own model (the lecture's variants off), flat or gouraud as the scene
// says, so that the three can be held against each other; the phong pictures follow the scene's variants.
// What the driver draws with is drawn twice and the second time is told, for in the first the driver compiles.
Comparison compare_scene(const Scene& scene, const CompareOptions& options, const Renderers& renderers,
                         const Progress& progress = {});

// ---- What is written of it ----

// "fixed.png"
std::string picture_file(const Render& render);
// "difference-fixed-programmable.png"
std::string difference_file(const Comparison& comparison, const Pair& pair);

// One JSON object, indented, with a newline at the end:
//   {"scene", "driver", "size": [w, h], "verdict": "within" | "beyond" | "partial",
//    "renders": [{"name", "file", "ms", "error_bound"}],   the last of what is drawn from plans
//    "pairs": [{"a", "b",                        names of renders
//               "interior": {"pixels", "differing", "max", "rms", "worst": [x, y]},
//               "beyond_slack": {the same},     what is judged of the interior
//               "edge": {the same},
//               "verdict": "within" | "beyond" | "partial" | "informative",
//               "tolerance": {"max", "differing_share"},   of the interior; not where informative
//               "file", "factor"}],             the difference picture and its amplification
//    "known_departures": ["name (section)"],    where beyond: of the driver, that the scene may show
//    "unsupported": [{"name", "count", "place", "renderers": [...]}]}
// max and rms are of channels on [0,1]; x and y count from the top left.
std::string comparison_json(const Comparison& comparison);

// Encoded once, written as files and inside the page.
struct EncodedPictures {
    std::vector<std::string> renders;      // PNG, in the order of Comparison::renders
    std::vector<std::string> differences;  // PNG, in the order of Comparison::pairs
    std::string edges;                     // PNG, white where the edge mask is set
};
EncodedPictures encode_pictures(const Comparison& comparison);

// A page that holds everything: pictures, style and script are inside.
std::string comparison_page(const Comparison& comparison, const EncodedPictures& pictures);

// The pictures, comparison.json and index.html, into a folder that is made if it is not there: all of them or
// none. Throws FileError.
void write_report(const Comparison& comparison, const std::string& folder);

}  // namespace twinlight::report
