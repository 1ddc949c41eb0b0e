#include "judge/fuzz/writer.h"

#include "judge/compare/departures.h"

namespace twinlight::fuzz {

std::string_view departure_of(const Seed& seed, Random& structure) {
    const bool about_one = structure.chance(0.1);
    const int which = structure.below(static_cast<int>(compare::departures().size()));
    if (!seed.departure.empty()) return seed.departure;
    return about_one ? compare::departures()[static_cast<std::size_t>(which)].name : std::string_view();
}

}  // namespace twinlight::fuzz
