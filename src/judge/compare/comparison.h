// The comparison of one scene drawn several ways: three renderers per vertex, two per pixel, and the pairs of
// them that are compared.
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
#include "render/reference/reference_options.h"
#include "scene/state/scene.h"

namespace twinlight::compare {

// What compare_scene draws with.
struct Renderers {
    std::function<Image(const Scene&, const fixed::Options&)> fixed;
    std::function<programmable::Picture(const Frame&, const programmable::Options&)> programmable;
    std::function<Image(const Frame&, const reference::Options&)> reference;
    // The pixels where right rasterisers may differ; all others are interior.
    std::function<AllowedDifference(const Frame&, const reference::Options&)> allowed_difference;
};

struct Render {
    Path path = Path::kFixed;
    std::string name;     // "fixed", "programmable", "reference", "programmable-phong", "reference-phong"; or -exact
    std::string meaning;  // a sentence for who sees the picture
    Image image;
    double ms = 0;  // one render, the picture read back
    // The reference's picture with quadrilaterals cut the other way, where the scene has any: the specification
    // allows both (QuadCut), so another picture is compared with the nearer one, pixel by pixel.
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

// What a judged pair is held to away from edges, beyond the allowed difference (allowances.h): no channel off by more than max,
// and a share of the pixels that differ below differing_share.
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
    std::string driver;  // driver_name()
    int width = 0, height = 0;
    std::vector<Render> renders;
    std::vector<Pair> pairs;
    AllowedDifference allowed;  // of the per-vertex pictures; its edges are of all
    std::vector<Unsupported> unsupported;
    // Where pictures differ beyond the tolerance: what the scene does that this driver is known to get wrong, "name (section)".
    std::vector<std::string> known_departures{};
    bool is_listed_driver = false;  // whether anything is known of this driver
    Tolerance tolerance;

    const Render& a(const Pair& pair) const { return renders[pair.a]; }
    const Render& b(const Pair& pair) const { return renders[pair.b]; }
    // The picture of b that a is compared with: of a reference with two cuts, the nearer one at each pixel.
    Image counterpart(const Pair& pair) const;
    Verdict verdict() const;        // kBeyond if a pair is; else kPartial if one is; else kWithin
    bool within_tolerance() const;  // as far as the pictures tell: no pair is beyond
};

// ---- The verdict (verdict.cpp) ----

// What a comparison says of two pictures that show the whole scene.
Verdict judge(const ImageDifference& difference, const Tolerance& tolerance);
// The same of two that may lack what is in Comparison::unsupported.
Verdict judge(const Comparison& comparison, const Pair& pair);

// ---- How it is made ----

struct CompareOptions {
    std::string driver{};                  // driver_name() of the driver that the renderers use
    double budget = PlanOptions{}.budget;  // of shaders
    bool precise = false;  // the programmable per-vertex picture is drawn with programmable::Options::precise
    // kPhong, or kExact, whose pictures, "programmable-exact" and "reference-exact", take the place of phong's.
    Shading per_pixel = Shading::kPhong;
    bool per_vertex_only = false;  // no pictures per pixel; each is drawn once, and not timed
    // Called before each step: how many are done, how many there are, what comes next.
    std::function<void(int done, int total, std::string_view next)> progress{};
};

// The per-vertex pictures follow GL's own model (the lecture's variants off), flat or gouraud as the scene
// says, so that the three can be compared; the phong pictures follow the scene's variants.
// The driver draws each picture twice, and the second is timed: in the first it compiles.
Comparison compare_scene(const Scene& scene, const CompareOptions& options, const Renderers& renderers);

}  // namespace twinlight::compare
