// The driver as a second opinion on what happens to fragments: random states, drawn by the driver's fixed function and
// by the reference, pixel by pixel. The driver's departures are left out; tests/golden/fragment_departures_test.cpp shows
// each of them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <memory>

#include "command/text.h"
#include "context/context.h"
#include "fixed/fixed.h"
#include "random_fragments.h"
#include "reference/reference.h"
#include "state/state.h"

namespace twinlight {

namespace {

constexpr int kWindow = 64;
constexpr std::uint64_t kStates = 600;

// What a channel may be off by outside of edge pixels, in codes of 8 bits, besides the slack that reference::freedom()
// gives the pixel: two right roundings of one value may be neighbours.
constexpr double kRounding = 1;
// How many pixels may differ beyond their slack at all: as rarely as float and double lie on different sides of a
// rounding border.
constexpr double kDifferingShare = 0.001;
// The freedom must not grow until nothing is compared: what it may leave open, and its mean slack, in codes.
constexpr double kInteriorShare = 0.85;
constexpr double kMeanSlack = 0.15;

struct Found {
    long pixels = 0, interior = 0, differing = 0, beyond = 0;
    double slack = 0;            // summed up over the channels of the interior, in codes
    double worst_excess = -1e9;  // codes beyond the slack
    int worst_x = 0, worst_y = 0;

    void operator+=(const Found& more) {
        pixels += more.pixels;
        interior += more.interior;
        slack += more.slack;
        differing += more.differing;
        beyond += more.beyond;
        worst_excess = std::max(worst_excess, more.worst_excess);
    }
};

Found compare(const Frame& frame) {
    const Image driver = fixed::render(frame, {}), reference = reference::render(frame, {});
    const Freedom freedom = reference::freedom(frame);
    Found found;
    for (int y = 0; y < kWindow; ++y)
        for (int x = 0; x < kWindow; ++x) {
            ++found.pixels;
            if (freedom.edge[driver.index(x, y)]) continue;
            ++found.interior;
            double excess = -1e9;
            for (std::size_t c = 0; c < 4; ++c) {
                const int codes = std::abs(channel_code(driver.at(x, y)[c]) - channel_code(reference.at(x, y)[c]));
                const double slack = 255.0 * static_cast<double>(freedom.slack.at(x, y)[c]);
                excess = std::max(excess, codes - slack);
                found.slack += slack;
            }
            found.differing += excess > 0;
            found.beyond += excess > kRounding;
            if (excess > found.worst_excess) {
                found.worst_excess = excess;
                found.worst_x = x;
                found.worst_y = y;
            }
        }
    return found;
}

const FragmentDeparture* departure_of(const Frame& frame) {
    for (const FragmentDeparture& departure : fragment_departures())
        for (const auto& item : frame.items)
            if (const Draw* draw = std::get_if<Draw>(&item); draw && departure.applies(*draw)) return &departure;
    return nullptr;
}

// TWINLIGHT_STATES says how many states, for a longer run than `make test` has time for.
std::uint64_t number_of_states() {
    const char* asked = std::getenv("TWINLIGHT_STATES");
    return asked ? std::strtoull(asked, nullptr, 10) : kStates;
}

TEST(FragmentsMatchDriver, OverRandomStates) {
    const auto context = make_offscreen_context(kWindow, kWindow);
    std::map<std::string_view, int> left_out;
    Found all;
    int failing_states = 0;
    const std::uint64_t states = number_of_states();
    for (std::uint64_t seed = 0; seed < states && failing_states < 10; ++seed) {
        const std::string text = random_fragments(seed);
        const auto scene = std::make_shared<const CommandList>(read_scene(text, "random.gl", "random"));
        StateOptions options;
        options.width = options.height = kWindow;
        const Frame frame = make_frame(scene, options);
        ASSERT_TRUE(frame.unsupported.empty()) << "seed " << seed << ": " << frame.unsupported[0].name;
        if (const FragmentDeparture* departure = departure_of(frame)) {
            ++left_out[departure->name];
            continue;
        }
        const Found found = compare(frame);
        all += found;
        if (found.beyond == 0) continue;
        ++failing_states;
        ADD_FAILURE() << fmt::format("seed {}: {} of {} interior pixels; at {},{} {:.1f} codes beyond the slack\n{}",
                                     seed, found.beyond, found.interior, found.worst_x, found.worst_y,
                                     found.worst_excess, failing_states == 1 ? text : "");
    }
    const double pixels = static_cast<double>(all.pixels), interior = static_cast<double>(all.interior);
    fmt::print(
        "{} interior pixels ({:.0f} %) compared, {} differing beyond their slack, which is {:.2f} codes on average\n",
        all.interior, 100 * interior / pixels, all.differing, all.slack / (4 * interior));
    EXPECT_LT(static_cast<double>(all.differing), kDifferingShare * interior);
    EXPECT_GT(interior, kInteriorShare * pixels);
    EXPECT_LT(all.slack / (4 * interior), kMeanSlack);
    for (const auto& [name, count] : left_out) fmt::print("  {} states left out: {}\n", count, name);
}

}  // namespace

}  // namespace twinlight
