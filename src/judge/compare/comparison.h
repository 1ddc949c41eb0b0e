// The comparison of a scene drawn five ways: by three renderers with lighting per vertex, and by two with lighting per pixel.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/image/difference.h"
#include "base/image/image.h"
#include "judge/compare/judged.h"
#include "judge/compare/queries.h"
#include "judge/compare/tolerance.h"
#include "render/effect/explanation.h"
#include "render/fixed/fixed.h"
#include "render/path.h"
#include "render/programmable/programmable.h"
#include "render/reference/vertices/reference_options.h"
#include "scene/frame/scene.h"

namespace twinlight::compare {

// The renderers that compare_scene uses.
struct Renderers {
    std::function<Image(const Scene&, const fixed::Options&)> fixed;
    std::function<Image(const Frame&, const programmable::Options&)> programmable;
    std::function<Image(const Frame&, const reference::Options&)> reference;
    // The edge pixels, where correct rasterisers may differ, and the allowed difference of all others ("interior").
    std::function<AllowedDifference(const Frame&, const reference::Options&)> allowed_difference;
    DriversAnswers answers{};      // to the scene's queries; may be empty
    DrawingPrecision precision{};  // of the driver; exact if it was not measured
};

struct Render {
    Path path = Path::kFixed;
    std::string name;     // "fixed", "shaders", "reference", "shaders-phong", "reference-phong"; or -exact
    std::string meaning;  // the picture's caption: a sentence
    Image image;
    double ms = 0;  // of one drawing, including reading the picture back
    // The reference's picture with quadrilaterals split along the other diagonal, if the scene has any. The specification
    // allows both (QuadCut), so another picture is compared with the nearer one, pixel by pixel.
    std::optional<Image> other_cut{};
    // The plans that it was drawn from, if any. The error that they allow is an allowed difference.
    std::vector<ExplainedDraw> plan{};
};

// From the best to the worst.
enum class Verdict : std::uint8_t {
    kInformative,  // the pictures show different models and are meant to differ, so there is no tolerance
    kWithin,       // within the tolerance
    kUnjudged,     // the same, but too many pixels could not be judged (Judged::is_enough())
    kPartial,      // a picture lacks part of the scene; where this changes nothing, they are within the tolerance
    kBeyond,       // beyond the tolerance
};

struct Pair {
    std::size_t a = 0, b = 0;  // into Comparison::renders
    // If a part of the scene is missing from one picture only, beyond_allowed is of the pixels that it does not change.
    ImageDifference difference;
    Judged judged;
    Verdict verdict = Verdict::kInformative;
    int factor = 1;  // amplification of the difference picture
    // What a is compared with, if that is no picture of b alone: with some Draws' quadrilaterals split one way and some the other.
    std::optional<Image> counterpart{};
};

// A warning of the linter about the scene.
struct SceneWarning {
    std::string line, why, fix;  // "scene.gl:7:1: warning: message [name]", the reason, the call to write
};

struct Comparison {
    std::string scene;
    std::string driver;          // driver_name()
    std::string library{};       // gl_library()
    DrawingPrecision precision;  // of the driver
    int width = 0, height = 0;
    std::vector<Render> renders;
    std::vector<Pair> pairs;
    AllowedDifference allowed;  // for the per-vertex pictures
    std::vector<Unsupported> unsupported;
    std::vector<SceneLabel> labels{};  // the frame's
    // The pixels that change if the fixed function leaves out what only it draws; empty if this is unknown, or if there
    // is no such command.
    PixelMask changed_by_missing{};
    // Why the specification leaves colours undefined at which pictures differ: "the attenuation ... (2.14.1)"; empty if there are none.
    std::string undefined{};
    std::vector<SceneWarning> warnings{};  // by the caller; they do not change the verdict
    std::vector<std::string> notes{};      // Scene::notes
    // If pictures differ beyond the tolerance, or are not judged in whole: the known bugs of this driver that the scene may trigger, "name (section)".
    std::vector<std::string> known_departures{};
    // The bugs among them that are proved to be why the fixed function differs (causes.h). If there are any, known_departures has
    // only those that other pictures may show.
    std::vector<std::string> proved_causes{};
    bool is_listed_driver = false;  // whether any bugs of this driver are listed
    std::vector<Query> queries{};   // glGet* and glIsEnabled in the scene, and what they return
    Tolerance tolerance;

    const Render& a(const Pair& pair) const { return renders[pair.a]; }
    const Render& b(const Pair& pair) const { return renders[pair.b]; }
    // The picture of b that a is compared with. If the reference has two cuts, takes the nearer one at each pixel.
    Image counterpart(const Pair& pair) const;
    Verdict verdict() const;        // the worst of the pairs; at least kWithin
    bool within_tolerance() const;  // no pair is beyond it
    // Whether leaving out what only the fixed function draws changes no pixel; false if this is unknown.
    bool missing_changes_nothing() const;
};

// ---- The verdict (verdict.cpp) ----

// The verdict for two pictures that show the whole scene.
Verdict judge(const ImageDifference& difference, const Tolerance& tolerance);
// The verdict for two pictures that may lack the commands in Comparison::unsupported. If one of them lacks more, the
// pair's difference is of the pixels in which that changes nothing, if these are known.
Verdict judge(const Comparison& comparison, const Pair& pair);

// ---- How it is made ----

struct CompareOptions {
    std::string driver{}, library{};       // driver_name() and gl_library() of the driver that the renderers use
    double budget = PlanOptions{}.budget;  // for shaders
    bool precise = false;                  // programmable::Options::precise, for the picture with lighting per vertex
    // kPhong, or kExact: the pictures "shaders-exact" and "reference-exact" then replace those with phong shading.
    Shading per_pixel = Shading::kPhong;
    bool per_vertex_only = false;  // draws no pictures with lighting per pixel; draws the others once, without timing
    // Called before each step: the number of finished steps, the number of all steps, the name of the next.
    std::function<void(int done, int total, std::string_view next)> progress{};
};

// The per-vertex pictures follow GL's own model (without the lecture's variants), with the scene's flat or smooth shading, so that
// the three can be compared. The per-pixel pictures follow the scene's variants.
// The driver draws each picture twice, and only the second is timed, because the first includes compiling.
Comparison compare_scene(const Scene& scene, const CompareOptions& options, const Renderers& renderers);

}  // namespace twinlight::compare
