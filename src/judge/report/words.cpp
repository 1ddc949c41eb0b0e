#include "judge/report/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

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

std::string in_255ths(double max) { return fmt::format("{}/255", std::lround(max * 255)); }

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

std::string words_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::kWithin: return "agree";
        case Verdict::kBeyond: return "differ";
        case Verdict::kPartial: return "partial";
        case Verdict::kInformative: return "meant to differ";
    }
    return "";
}

bool has_allowed_difference(const Pair& pair) {
    return pair.verdict != Verdict::kInformative && pair.difference.beyond_allowed.rms < pair.difference.interior.rms;
}

std::string words_of(const Tolerance& tolerance) {
    return fmt::format("up to {}, in fewer than {:g}% of the pixels", in_255ths(tolerance.max),
                       100 * tolerance.differing_share);
}

namespace {

// "fixed ~ reference: 5 of 299,091 pixels away from edges differ (< 0.01%)"
std::string count_of(const Comparison& comparison, const Pair& pair, const RegionDifference& region) {
    return fmt::format("{}: {} of {} pixels away from edges differ ({})", name_of(comparison, pair),
                       grouped(region.differing), grouped(region.pixels), share_of(region));
}

// The pair with this verdict that differs most in one of its regions; null if there is none.
const Pair* worst_pair(const Comparison& comparison, Verdict verdict, RegionDifference ImageDifference::*region) {
    const Pair* worst = nullptr;
    const auto size = [region](const Pair& pair) {
        return std::pair((pair.difference.*region).max, (pair.difference.*region).differing);
    };
    for (const Pair& pair : comparison.pairs)
        if (pair.verdict == verdict && (!worst || size(pair) > size(*worst))) worst = &pair;
    return worst;
}

Answer partial_answer(const Comparison& comparison) {
    const std::size_t kinds = comparison.unsupported.size();
    return {
        fmt::format("The comparison is partial: {} not drawn by every renderer.",
                    kinds == 1 ? "one kind of command is" : fmt::format("{} kinds of commands are", kinds)),
        fmt::format("The first is {} at {}.", comparison.unsupported.front().name,
                    comparison.unsupported.front().first.str()),
        "Pictures that lack the same commands agree; between others, the missing commands may cause any difference.",
        {}};
}

Answer agreeing_answer(const Comparison& comparison) {
    Answer answer{.is_right = "Yes: the renderers agree.", .where = {}, .how_much = {}, .details = {}};
    const Pair *beyond = worst_pair(comparison, Verdict::kWithin, &ImageDifference::beyond_allowed),
               *any = worst_pair(comparison, Verdict::kWithin, &ImageDifference::interior);
    if (beyond && beyond->difference.beyond_allowed.differing > 0) {
        const RegionDifference& region = beyond->difference.beyond_allowed;
        answer.where = fmt::format("At a few pixels. Most are in {}, for example at ({}, {}).",
                                   count_of(comparison, *beyond, region), region.worst_x, region.worst_y);
        answer.how_much =
            fmt::format("By up to {}; allowed is {}.", in_255ths(region.max), words_of(comparison.tolerance));
    } else if (any && any->difference.interior.differing > 0) {
        const RegionDifference& region = any->difference.interior;
        answer.where = fmt::format("Nowhere by more than allowed. Most differences are in {}, for example at ({}, {}).",
                                   count_of(comparison, *any, region), region.worst_x, region.worst_y);
        answer.how_much =
            fmt::format("By up to {}, which rounding, filtering or blending explains at each of these pixels.",
                        in_255ths(region.max));
    } else {
        answer.where = "Away from edges, no pixel differs.";
        answer.how_much = fmt::format("By 0; allowed is {}.", words_of(comparison.tolerance));
    }
    return answer;
}

Answer differing_answer(const Comparison& comparison) {
    const Pair& worst = *worst_pair(comparison, Verdict::kBeyond, &ImageDifference::beyond_allowed);
    const RegionDifference& region = worst.difference.beyond_allowed;
    Answer answer{.is_right = "No: the renderers differ more than allowed.",
                  .where = fmt::format("Most in {}; the worst is at ({}, {}).", count_of(comparison, worst, region),
                                       region.worst_x, region.worst_y),
                  .how_much = fmt::format(
                      "By up to {}{}; allowed is {}.", in_255ths(region.max),
                      has_allowed_difference(worst) ? " more than filters, blending and rounding explain" : "",
                      words_of(comparison.tolerance)),
                  .details = {}};
    for (const Pair& pair : comparison.pairs) {
        if (pair.verdict != Verdict::kBeyond || &pair == &worst) continue;
        const RegionDifference& other = pair.difference.beyond_allowed;
        answer.details.push_back(fmt::format("{}, by up to {}; the worst is at ({}, {}).",
                                             count_of(comparison, pair, other), in_255ths(other.max), other.worst_x,
                                             other.worst_y));
    }
    const Driver driver = parse_driver_name(comparison.driver);
    for (const std::string& departure : comparison.known_departures)
        answer.details.push_back(
            fmt::format("A known bug of {} in {} may be the cause: {}. See golden/known_differences.", driver.name,
                        driver.version, departure));
    if (!comparison.is_listed_driver) answer.details.emplace_back("No known bugs are listed for this driver.");
    return answer;
}

}  // namespace

std::vector<std::string> Answer::sentences() const {
    std::vector<std::string> all = {is_right, where, how_much};
    all.insert(all.end(), details.begin(), details.end());
    return all;
}

Answer answer(const Comparison& comparison) {
    if (comparison.pairs.front().difference.interior.pixels == 0)  // all pairs share one mask
        return {"Unknown: every pixel is at an edge, where correct renderers may differ.",
                "No pixel can be compared.",
                "Try a larger --size.",
                {}};
    switch (comparison.verdict()) {
        case Verdict::kPartial: return partial_answer(comparison);
        case Verdict::kBeyond: return differing_answer(comparison);
        case Verdict::kWithin:
        case Verdict::kInformative: break;
    }
    return agreeing_answer(comparison);
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
    return fmt::format("{} ({}, {}{}) is not drawn by {}.", unsupported.name, count,
                       unsupported.count == 1 ? "at " : "first at ", unsupported.first.str(), renderers);
}

}  // namespace twinlight::report
