// A comparison as text, for the page and the terminal.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "judge/compare/comparison.h"

namespace twinlight::report {

std::string grouped(std::size_t number);                                                // "1,234,567"
std::string in_255ths(double max);                                                      // "3/255"
std::string share_of(const RegionDifference& region);                                   // "0.03%", "< 0.01%", "0%"
std::string name_of(const compare::Comparison& comparison, const compare::Pair& pair);  // "fixed ~ reference"
std::string word_of(compare::Verdict verdict);   // for comparison.json: "within", "beyond", "partial", "informative"
std::string words_of(compare::Verdict verdict);  // for people: "agree", "differ", "partial", "meant to differ"

// "up to 1/255, in fewer than 0.1% of the pixels"
std::string words_of(const compare::Tolerance& tolerance);

// What a comparison shows, a sentence each.
struct Answer {
    std::string headline;              // "All three agree: the largest difference away from edges is 1/255."
    std::string where;                 // where most pixels differ; empty if none do
    std::vector<std::string> details;  // other pairs that differ, known bugs

    std::vector<std::string> sentences() const;  // all of them, in this order
};
Answer answer(const compare::Comparison& comparison);

// The largest difference away from edges of the pairs that should agree.
double largest_difference(const compare::Comparison& comparison);

// Where a label is in the pictures, in pixels from the top left.
std::array<int, 2> pixel_of(const compare::Comparison& comparison, const SceneLabel& label);

// Whether a part of the pair's difference is allowed.
bool has_allowed_difference(const compare::Pair& pair);
// The renderers among `shown` that cannot draw the command.
std::vector<std::string_view> names_of(const Unsupported& unsupported, std::span<const Path> shown = kAllPaths);
// "glEnable(GL_FOG) (2 times, first at scene.gl:3:1) is not drawn by shaders and reference."
std::string sentence_of(const Unsupported& unsupported, std::span<const Path> shown = kAllPaths);

}  // namespace twinlight::report
