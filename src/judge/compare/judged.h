// How many pixels of two pictures are judged, and how strictly.
#pragma once

#include <cstddef>

#include "base/image/difference.h"

namespace twinlight::compare {

struct Judged {
    std::size_t to_allowed = 0;    // away from edges: held to their allowed difference
    std::size_t to_one_of = 0;     // at edges: held to one of several colours
    std::size_t not_judged = 0;    // at edges: any colour may be right
    std::size_t drawn = 0;         // that a fragment covers, or may cover
    std::size_t drawn_widely = 0;  // of these: held to a range wider than kWide
    std::size_t drawn_not_judged = 0;
    std::size_t undefined =
        0;  // that differ, but whose colour the specification leaves undefined (ImageDifference::undefined)
    // The pixels of to_one_of: how many colours each may have, and how wide its widest range is.
    struct Spread {
        double median = 0, most = 0;  // most: of 95 % of them at most
    };
    Spread colors{}, width{};

    // The share of the drawn pixels at which an error can hide.
    double open_share() const {
        return drawn == 0
                   ? 0
                   : static_cast<double>(drawn_widely + drawn_not_judged + undefined) / static_cast<double>(drawn);
    }
    bool is_enough() const { return open_share() <= kMostOpen; }

    static constexpr double kWide = 32 / 255.0;
    static constexpr double kMostOpen = 0.02;
};

// `allowed`: between a driver and the reference.
Judged judged(const AllowedDifference& allowed);

}  // namespace twinlight::compare
