// The verdict on the difference pane's two pictures: that of `twinlight compare`, in its words.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/session/session.h"
#include "base/image/difference.h"
#include "judge/compare/comparison.h"
#include "render/context/drawing_precision.h"

namespace twinlight::demo {

// What both panes of the difference show, so that their pictures should agree; empty if they are meant to differ.
std::optional<Look> common_look(const session::Session& session);

struct PairVerdict {
    compare::Verdict verdict = compare::Verdict::kInformative;
    std::vector<std::string> texts;      // for a bar: the first that fits
    std::vector<std::string> sentences;  // all that compare says
};
// `numbers`: of the two pictures, with the allowed difference `allowed`.
PairVerdict verdict_on_pair(const session::Session& session, const ImageDifference& numbers,
                            const AllowedDifference& allowed);
// For two pictures that are meant to differ.
PairVerdict meant_to_differ(const ImageDifference& numbers);

// How exactly the driver draws: measured once, in a thread that the first call starts. Null until then.
const DrawingPrecision* drivers_precision();
void wait_for_drivers_precision();

// What the two pictures may differ by, once drivers_precision() is known: `reference` allows that much between a driver and `right`, which
// has this look.
AllowedDifference allowed_of_pair(const session::Session& session, const Look& look, AllowedDifference allowed,
                                  const compare::Render& right);

}  // namespace twinlight::demo
