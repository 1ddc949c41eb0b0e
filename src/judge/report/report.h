// The report of a comparison: its pictures, comparison.json and index.html.
#pragma once

#include <string>
#include <vector>

#include "judge/compare/comparison.h"

namespace twinlight::report {

// "fixed.png"
std::string picture_file(const compare::Render& render);
// "difference-fixed-shaders.png"
std::string difference_file(const compare::Comparison& comparison, const compare::Pair& pair);

// "step-1" for the first, which is 0.
std::string step_folder(std::size_t step);

// One JSON object, indented, with a newline at the end:
//   {"scene", "driver", "library", "size": [w, h], "verdict": "within" | "beyond" (the tolerance) | "partial" | "unchecked",
//    "renders": [{"name", "file", "ms", "error_bound"}],   error_bound: only for pictures drawn from plans
//    "pairs": [{"a", "b",                        names of renders
//               "interior": {"pixels", "differing", "max", "rms", "worst": [x, y]},   pixels away from edges
//               "beyond_slack": {the same},     of all checked pixels: the part of the differences that is not allowed; the verdict
//                                               follows from it
//               "edge": {the same},             pixels at edges
//               "checked": {"to_allowed_difference", "to_one_of_several_colors", "not_checked",   numbers of pixels
//                          "drawn": those that a fragment covers, "drawn_not_checked", "drawn_widely_checked": in a range of over 32/255,
//                          "undefined": that differ, but whose colour OpenGL leaves undefined,
//                          "colors", "width": {"median", "95%"}},   of to_one_of_several_colors: how many, and the widest range
//               "verdict": "within" | "beyond" | "partial" | "unchecked": no difference found, but over 2% of the drawn pixels are
//                          not checked, or widely | "informative" (meant to differ),
//               "tolerance": {"max", "differing_share"},   for beyond_slack; missing for "informative"
//               "file", "factor"}],             the difference picture and its amplification
//    "driver_precision": {"position", "conversion", "approximates_rho"},   DrawingPrecision
//    "is_listed_driver": whether any bugs of this driver and version are listed
//    "undefined": why OpenGL leaves colours undefined at which pictures differ; "" if there are none
//    "proved_causes": ["name (section)"],       known bugs without which the fixed function agrees (compare/causes.h)
//    "known_departures": ["name (section)"],    others, as guesses; if "beyond": known bugs of this driver that the scene may show
//    "unsupported": [{"name", "count", "place", "renderers": [...]}],   commands that some renderers cannot draw
//    "labels": [{"text", "at": [x, y]}],        the scene's (#pragma twinlight label); the pictures do not have them
//    "queries": [{"place", "call", "twinlight", "driver", "agree"}],    what the scene's glGet* return; "?" for no answer
//    "warnings": ["scene.gl:7:1: warning: message [name]"],   of the linter about the scene
//    "notes": ["2 of the program's commands up to this frame have NaN or infinity; ..."]}   about a recorded program
// max and rms are for channels on [0,1]; x and y count from the top left.
std::string comparison_json(const compare::Comparison& comparison);

// Encoded once; written as files and embedded in the page.
struct EncodedPictures {
    std::vector<std::string> renders;      // PNG, in the order of Comparison::renders
    std::vector<std::string> differences;  // PNG, in the order of Comparison::pairs
    std::string edges;                     // PNG, white where the edge mask is set
    std::string why;                       // PNG, at each pixel why it may differ: Whys, the lowest byte in red
};
EncodedPictures encode_pictures(const compare::Comparison& comparison);

// What one article of the page shows: the comparison of a scene, or of one of its steps.
struct Compared {
    std::string title;  // of the step; "" for a scene without steps
    const compare::Comparison& comparison;
    const EncodedPictures& pictures;
};

// A page that contains everything: pictures, style and script. Several comparisons, which are a scene's steps, become
// articles, of which a row of thumbnails selects one. There must be at least one.
std::string comparison_page(const std::vector<Compared>& comparisons);

// Writes the pictures, comparison.json and index.html into a folder, which is created if it does not exist: all of them or none.
// Throws FileError.
void write_report(const compare::Comparison& comparison, const std::string& folder);

// The comparison of a scene's step.
struct ComparedStep {
    std::string title;
    compare::Comparison comparison;
};

// One JSON object: {"scene", "driver", "library", "size": [w, h], "verdict": the worst of all steps,
//    "steps": [{"number", "title", "folder": "step-1", "comparison": as comparison_json() has it}]}
std::string steps_json(const std::vector<ComparedStep>& steps);

// The worst verdict of the steps.
compare::Verdict verdict_of(const std::vector<ComparedStep>& steps);

// The same for all steps of a scene: index.html and comparison.json are of all, the pictures are in step-1/, step-2/, ...
void write_report(const std::vector<ComparedStep>& steps, const std::string& folder);

}  // namespace twinlight::report
