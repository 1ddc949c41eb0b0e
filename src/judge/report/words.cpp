#include "judge/report/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/text/translation.h"
#include "judge/compare/releases.h"
#include "render/context/driver_name.h"

namespace twinlight::report {

using compare::Comparison;
using compare::Pair;
using compare::Tolerance;
using compare::Verdict;

std::string grouped(std::size_t number) {
    std::string digits = std::to_string(number);
    for (std::ptrdiff_t i = std::ssize(digits) - 3; i > 0; i -= 3) digits.insert(static_cast<std::size_t>(i), 1, ',');
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
        case Verdict::kUnjudged: return "unchecked";
        case Verdict::kPartial: return "partial";
        case Verdict::kInformative: return "informative";
    }
    return "";
}

std::string words_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::kWithin: return "agree";
        case Verdict::kBeyond: return "differ";
        case Verdict::kUnjudged: return "not checked";
        case Verdict::kPartial: return "partial";
        case Verdict::kInformative: return "meant to differ";
    }
    return "";
}

std::array<int, 2> pixel_of(const Comparison& comparison, const SceneLabel& label) {
    const auto pixel = [](double share, int pixels) { return static_cast<int>(std::lround(share * pixels)); };
    return {pixel(label.place_picture.x, comparison.width), pixel(1 - label.place_picture.y, comparison.height)};
}

bool has_allowed_difference(const Pair& pair) {
    const RegionDifference &interior = pair.difference.interior, &beyond = pair.difference.beyond_allowed;
    return pair.verdict != Verdict::kInformative &&
           (beyond.differing != interior.differing || beyond.max != interior.max);
}

std::string words_of(const Tolerance& tolerance) {
    return tr("up to {}, in fewer than {:g}% of the pixels", in_255ths(tolerance.max), 100 * tolerance.differing_share);
}

namespace {

// "fixed ~ reference: 5 of 299,091 checked pixels differ (< 0.01%)"
std::string count_of(const Comparison& comparison, const Pair& pair, const RegionDifference& region) {
    return tr("{}: {} of {} checked pixels differ ({})", name_of(comparison, pair), grouped(region.differing),
              grouped(region.pixels), share_of(region));
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

void add_known_departures(const Comparison& comparison, Answer& answer) {
    const Driver driver = parse_driver_name(comparison.driver);
    const std::string measured =
        compare::has_measured_release(driver) ? "" : fmt::format(" (measured on {})", compare::counts_as(driver));
    const auto add = [&](std::string_view verb, std::string_view departure) {
        answer.details.push_back(fmt::format("A known bug of {} in {}{} {}: {}. See golden/known_differences.",
                                             driver.name, driver.version, measured, verb, departure));
    };
    for (const std::string& cause : comparison.proved_causes)
        add(comparison.proved_causes.size() == 1 ? "is the cause" : "is part of the cause", cause);
    if (!comparison.proved_causes.empty())
        answer.details.emplace_back(
            "This is proved: with other commands that have the same effect in OpenGL but avoid the bug, the fixed "
            "function "
            "agrees.");
    for (const std::string& departure : comparison.known_departures) add("may be the cause", departure);
}

// What the driver's precision adds to the allowed differences.
void add_precision(const Comparison& comparison, std::vector<std::string>& details) {
    const DrawingPrecision& precision = comparison.precision;
    if (precision.position > 0)
        details.push_back(
            tr("Allowed: this driver's colours are those of a place up to {:.2g} pixels away.", precision.position));
    if (precision.conversion > 0)
        details.push_back(
            tr("Allowed: this driver may round a colour to the next 8-bit value up to {:.2g}/255 beyond the middle.",
               precision.conversion));
    if (precision.approximates_rho)
        details.emplace_back(tr("Allowed: this driver chooses other levels of textures, as section 3.8.8 permits."));
}

std::size_t changed_by_missing(const Comparison& comparison) {
    return static_cast<std::size_t>(std::ranges::count(comparison.changed_by_missing, true));
}

Answer partial_answer(const Comparison& comparison) {
    const std::size_t kinds = comparison.unsupported.size();
    const Unsupported& first = comparison.unsupported.front();
    const bool is_known = !comparison.changed_by_missing.empty();
    Answer answer{
        kinds == 1 ? tr("The comparison is partial: one kind of command is not drawn by every renderer.")
                   : tr("The comparison is partial: {} kinds of commands are not drawn by every renderer.", kinds),
        tr("The first is {} at {}. {}", first.name, first.first.str(),
           tr(is_known ? "Where leaving them out changes no pixel of the fixed function, the pictures agree."
                       : "Pictures that lack the same commands agree; between others, the missing commands may "
                         "cause any difference.")),
        {}};
    if (is_known) {
        answer.details.push_back(fmt::format("They change {} of {} pixels.", grouped(changed_by_missing(comparison)),
                                             grouped(comparison.changed_by_missing.size())));
    } else {
        add_known_departures(comparison, answer);
    }
    return answer;
}

// How many pixels differ where the colour is undefined: in the pair that has the most of them.
void add_undefined(const Comparison& comparison, std::vector<std::string>& details) {
    std::size_t most = 0;
    for (const Pair& pair : comparison.pairs)
        if (pair.verdict != Verdict::kInformative) most = std::max(most, pair.judged.undefined);
    if (most == 0) return;
    details.push_back(
        tr("Not counted: {} pixels differ, but OpenGL leaves their colour undefined: {}. The reference and "
           "the shaders follow "
           "Twinlight's own rule.",
           grouped(most), comparison.undefined));
}

Answer agreeing_answer(const Comparison& comparison) {
    const Pair* worst = worst_pair(comparison, Verdict::kWithin, &ImageDifference::interior);
    const bool is_pair = comparison.renders.size() == 2;
    std::vector<std::string> details;
    if (comparison.missing_changes_nothing())
        details.emplace_back("Not every renderer draws all commands, but leaving those out changes no pixel.");
    add_undefined(comparison, details);
    if (!worst || worst->difference.interior.differing == 0)
        return {tr(is_pair ? "Both agree: no pixel away from edges differs."
                           : "All three agree: no pixel away from edges differs."),
                "", details};
    add_precision(comparison, details);
    const RegionDifference& region = worst->difference.interior;
    const double largest = largest_difference(comparison);
    std::string headline =
        is_pair ? tr("Both agree: the largest difference away from edges is {}", in_255ths(largest))
                : tr("All three agree: the largest difference away from edges is {}", in_255ths(largest));
    if (largest > comparison.tolerance.max * (1 + 1e-9)) {
        const Pair* beyond = worst_pair(comparison, Verdict::kWithin, &ImageDifference::beyond_allowed);
        headline +=
            beyond->difference.beyond_allowed.differing == 0
                ? tr(", and OpenGL leaves that much open")
                : tr(", and OpenGL leaves all but {} of it open", in_255ths(beyond->difference.beyond_allowed.max));
    }
    return {headline + tr("."),
            tr("{} differ most: at {} of {} pixels away from edges ({}), for example ({}, {}).",
               name_of(comparison, *worst), grouped(region.differing), grouped(region.pixels), share_of(region),
               region.worst_x, region.worst_y),
            details};
}

// The pair of which the most could not be checked.
const Pair& least_judged(const Comparison& comparison) {
    const Pair* least = nullptr;
    for (const Pair& pair : comparison.pairs)
        if (pair.verdict == Verdict::kUnjudged && (!least || pair.judged.open_share() > least->judged.open_share()))
            least = &pair;
    return *least;
}

Answer unjudged_answer(const Comparison& comparison) {
    const Pair& pair = least_judged(comparison);
    const compare::Judged& judged = pair.judged;
    const double percent = 100 * judged.open_share();
    const std::string share =
        percent < 10 ? tr("{:.1f}% of the drawn pixels", percent) : tr("{:.0f}% of the drawn pixels", percent);
    const bool is_undefined = judged.undefined > judged.drawn_not_judged + judged.drawn_widely;
    Answer answer{
        .headline = is_undefined
                        ? tr("The pictures differ only where OpenGL leaves the colour undefined: at {}.", share)
                        : tr("No difference found; {} could not be checked.", share),
        .where =
            tr("{}: of {} drawn pixels, OpenGL leaves {} open, and {} may have any colour in a range of over {}.",
               name_of(comparison, pair), grouped(judged.drawn), grouped(judged.drawn_not_judged + judged.undefined),
               grouped(judged.drawn_widely), in_255ths(compare::Judged::kWide)),
        .details = {}};
    add_undefined(comparison, answer.details);
    if (judged.undefined == 0)
        answer.details.emplace_back(tr("A larger --size may help: fewer pixels are then at edges."));
    add_known_departures(comparison, answer);
    add_precision(comparison, answer.details);
    return answer;
}

Answer differing_answer(const Comparison& comparison) {
    const Pair& worst = *worst_pair(comparison, Verdict::kBeyond, &ImageDifference::beyond_allowed);
    const RegionDifference& region = worst.difference.beyond_allowed;
    Answer answer{.headline = tr("{}{} and {} differ by up to {}{}.",
                                 comparison.renders.size() == 2 ? "" : "Not all agree: ", comparison.a(worst).name,
                                 comparison.b(worst).name, in_255ths(region.max),
                                 has_allowed_difference(worst) ? tr(", more than OpenGL leaves open") : ""),
                  .where = tr("{}; the worst is at ({}, {}). Allowed: {}.", count_of(comparison, worst, region),
                              region.worst_x, region.worst_y, words_of(comparison.tolerance)),
                  .details = {}};
    if (region.only_alpha) answer.where += tr(" Only alpha differs, which no window shows.");
    for (const Pair& pair : comparison.pairs) {
        if (pair.verdict != Verdict::kBeyond || &pair == &worst) continue;
        const RegionDifference& other = pair.difference.beyond_allowed;
        answer.details.push_back(fmt::format("{}, by up to {}; the worst is at ({}, {}).",
                                             count_of(comparison, pair, other), in_255ths(other.max), other.worst_x,
                                             other.worst_y));
    }
    if (const std::size_t changed = changed_by_missing(comparison); changed > 0)
        answer.details.push_back(
            fmt::format("Not counted: {} pixels that change if commands are left out that not every renderer draws.",
                        grouped(changed)));
    add_undefined(comparison, answer.details);
    add_known_departures(comparison, answer);
    add_precision(comparison, answer.details);
    if (!comparison.is_listed_driver) answer.details.emplace_back("No known bugs are listed for this driver.");
    return answer;
}

}  // namespace

double largest_difference(const Comparison& comparison) {
    double largest = 0;
    for (const Pair& pair : comparison.pairs)
        if (pair.verdict != Verdict::kInformative) largest = std::max(largest, pair.difference.interior.max);
    return largest;
}

std::vector<std::string> Answer::sentences() const {
    std::vector<std::string> all = {headline};
    if (!where.empty()) all.push_back(where);
    all.insert(all.end(), details.begin(), details.end());
    return all;
}

Answer answer(const Comparison& comparison) {
    switch (comparison.verdict()) {
        case Verdict::kPartial: return partial_answer(comparison);
        case Verdict::kBeyond: return differing_answer(comparison);
        case Verdict::kUnjudged: return unjudged_answer(comparison);
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
