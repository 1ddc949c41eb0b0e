#include "judge/report/words.h"

#include <fmt/format.h>

#include <cmath>

#include "render/context/driver_name.h"

namespace twinlight::report {

using compare::Comparison;
using compare::Pair;
using compare::Tolerance;
using compare::Verdict;

std::string grouped(std::size_t number) {
    std::string digits = std::to_string(number);
    for (std::ptrdiff_t i = std::ssize(digits) - 3; i > 0; i -= 3) digits.insert(static_cast<std::size_t>(i), ",");
    return digits;
}

std::string codes_of(double max) { return fmt::format("{}/255", std::lround(max * 255)); }

std::string share_of(const RegionDifference& region) {
    const double percent = 100 * region.differing_share();
    if (percent == 0) return "0%";
    if (percent < 0.01) return "< 0.01%";
    return fmt::format("{:.2f}%", percent);
}

std::string name_of(const Comparison& comparison, const Pair& pair) {
    return comparison.a(pair).name + " ~ " + comparison.b(pair).name;
}

std::string word_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::kWithin: return "within";
        case Verdict::kBeyond: return "beyond";
        case Verdict::kPartial: return "partial";
        case Verdict::kInformative: return "informative";
    }
    return "";
}

bool has_allowed_difference(const Pair& pair) {
    return pair.verdict != Verdict::kInformative && pair.difference.beyond_allowed.rms < pair.difference.interior.rms;
}

std::string words_of(const Tolerance& tolerance) {
    return fmt::format("no interior channel off by more than {}, fewer than {:g}% of interior pixels differing",
                       codes_of(tolerance.max), 100 * tolerance.differing_share);
}

std::vector<std::string> verdict_sentences(const Comparison& comparison) {
    if (comparison.pairs.front().difference.interior.pixels == 0) {  // all pairs share one mask
        return {"Nothing is judged: every pixel is an edge pixel; try a larger --size."};
    }
    if (comparison.verdict() == Verdict::kPartial) {
        return {fmt::format(
            "The comparison is partial: not every renderer draws the whole scene, {} "
            "not done by all. What is drawn by all is within the tolerance ({}) where it can be told.",
            comparison.unsupported.size() == 1 ? "one kind of command is"
                                               : fmt::format("{} kinds of commands are", comparison.unsupported.size()),
            words_of(comparison.tolerance))};
    }
    if (comparison.within_tolerance()) {
        return {"The renderers agree: every judged pair is within the tolerance (" + words_of(comparison.tolerance) +
                ")."};
    }
    std::vector<std::string> sentences = {"The renderers differ: the tolerance (" + words_of(comparison.tolerance) +
                                          ") is exceeded."};
    for (const Pair& pair : comparison.pairs) {
        if (pair.verdict != Verdict::kBeyond) continue;
        const RegionDifference& judged = pair.difference.beyond_allowed;
        sentences.push_back(fmt::format("{}: {} of {} interior pixels differ ({}), by up to {} at ({}, {}){}.",
                                        name_of(comparison, pair), grouped(judged.differing), grouped(judged.pixels),
                                        share_of(judged), codes_of(judged.max), judged.worst_x, judged.worst_y,
                                        has_allowed_difference(pair) ? ", beyond the allowed difference" : ""));
    }
    const Driver driver = parse_driver_name(comparison.driver);
    for (const std::string& departure : comparison.known_departures)
        sentences.push_back(
            fmt::format("This scene does what {} of {} is known to get wrong: {}; see golden/known_differences.",
                        driver.name, driver.version, departure));
    if (!comparison.is_listed_driver) sentences.push_back("No known bugs are listed for this driver.");
    return sentences;
}

std::vector<std::string_view> names_of(const Unsupported& unsupported, std::span<const Path> shown) {
    std::vector<std::string_view> names;
    for (const Path path : shown)
        if (lacks(path, unsupported)) names.push_back(name_of(path));
    return names;
}

std::string sentence_of(const Unsupported& unsupported, std::span<const Path> shown) {
    const std::vector<std::string_view> names = names_of(unsupported, shown);
    std::string renderers;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0) renderers += i + 1 == names.size() ? " and " : ", ";
        renderers += names[i];
    }
    const std::string count = unsupported.count == 1 ? "once" : fmt::format("{} times", unsupported.count);
    return fmt::format("{} ({}, {}{}) is not done by {}.", unsupported.name, count,
                       unsupported.count == 1 ? "at " : "first at ", unsupported.first.str(), renderers);
}

}  // namespace twinlight::report
