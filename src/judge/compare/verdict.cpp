// The rules for verdicts.
#include <algorithm>

#include "judge/compare/comparison.h"

namespace twinlight::compare {

Verdict judge(const ImageDifference& difference, const Tolerance& tolerance) {
    return is_within(difference, tolerance) ? Verdict::kWithin : Verdict::kBeyond;
}

Verdict judge(const Comparison& comparison, const Pair& pair) {
    Verdict verdict = judge(pair.difference, comparison.tolerance);
    if (verdict == Verdict::kWithin && !pair.judged.is_enough()) verdict = Verdict::kUnjudged;
    const Render &a = comparison.a(pair), &b = comparison.b(pair);
    bool partial = false;
    for (const Unsupported& item : comparison.unsupported) {
        const bool is_known = item.missing_from == MissingFrom::kFrame && !comparison.changed_by_missing.empty();
        if (is_known && comparison.missing_changes_nothing()) continue;
        // A difference may be caused by this.
        if (lacks(a.path, item) != lacks(b.path, item) && !is_known) return Verdict::kPartial;
        partial = partial || lacks(a.path, item) || lacks(b.path, item);
    }
    return partial && verdict != Verdict::kBeyond ? Verdict::kPartial : verdict;
}

bool Comparison::missing_changes_nothing() const {
    return !changed_by_missing.empty() && std::ranges::find(changed_by_missing, true) == changed_by_missing.end();
}

Verdict Comparison::verdict() const {
    Verdict worst = Verdict::kWithin;
    for (const Pair& pair : pairs) worst = std::max(worst, pair.verdict);
    return worst;
}

bool Comparison::within_tolerance() const { return verdict() != Verdict::kBeyond; }

}  // namespace twinlight::compare
