// A comparison in words: what the page and the terminal say alike.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "judge/compare/comparison.h"

namespace twinlight::report {

std::string grouped(std::size_t number);                                                // "1,234,567"
std::string codes_of(double max);                                                       // "3/255"
std::string share_of(const RegionDifference& region);                                   // "0.03%", "< 0.01%", "0%"
std::string name_of(const compare::Comparison& comparison, const compare::Pair& pair);  // "fixed ~ reference"
std::string word_of(compare::Verdict verdict);  // "within", "beyond", "informative"

// "no interior channel off by more than 1/255, fewer than 0.1% of interior pixels differing"
std::string words_of(const compare::Tolerance& tolerance);

// The whole's verdict, then a sentence for each judged pair that is beyond the tolerance.
std::vector<std::string> verdict_sentences(const compare::Comparison& comparison);

// Whether a part of the pair's difference is allowed, and is not judged.
bool has_allowed_difference(const compare::Pair& pair);
// Those of the `shown` renderers that do not do it.
std::vector<std::string_view> names_of(const Unsupported& unsupported, std::span<const Path> shown = kAllPaths);
// "glEnable(GL_FOG), 2 times, first at scene.gl:3:1, is not done by programmable and reference."
std::string sentence_of(const Unsupported& unsupported, std::span<const Path> shown = kAllPaths);

}  // namespace twinlight::report
