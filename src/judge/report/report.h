// What is written of a comparison: its pictures, comparison.json and index.html.
#pragma once

#include <string>
#include <vector>

#include "judge/compare/comparison.h"

namespace twinlight::report {

// "fixed.png"
std::string picture_file(const compare::Render& render);
// "difference-fixed-programmable.png"
std::string difference_file(const compare::Comparison& comparison, const compare::Pair& pair);

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
//    "is_listed_driver": whether any bugs of this driver and version are listed
//    "known_departures": ["name (section)"],    where beyond: known of this driver, and the scene may show it
//    "unsupported": [{"name", "count", "place", "renderers": [...]}]}
// max and rms are of channels on [0,1]; x and y count from the top left.
std::string comparison_json(const compare::Comparison& comparison);

// Encoded once, written as files and inside the page.
struct EncodedPictures {
    std::vector<std::string> renders;      // PNG, in the order of Comparison::renders
    std::vector<std::string> differences;  // PNG, in the order of Comparison::pairs
    std::string edges;                     // PNG, white where the edge mask is set
};
EncodedPictures encode_pictures(const compare::Comparison& comparison);

// A page that holds everything: pictures, style and script are inside.
std::string comparison_page(const compare::Comparison& comparison, const EncodedPictures& pictures);

// The pictures, comparison.json and index.html, into a folder that is made if it is not there: all of them or
// none. Throws FileError.
void write_report(const compare::Comparison& comparison, const std::string& folder);

}  // namespace twinlight::report
