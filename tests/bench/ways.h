// A Frame drawn again and again by one of the two fast paths, from buffers that the driver has. For the context that is current.
#pragma once

#include <optional>
#include <string>

#include "ratios.h"
#include "render/fixed/replay.h"
#include "render/programmable/numbers/shader_options.h"
#include "scene/frame/frame.h"

namespace twinlight::bench {

// GL's own model, so that all draw the same.
programmable::Options options_for(programmable::Tier tier, bool patches);

Way fixed_way(std::string name, const Frame& frame, fixed::Scrub scrub, bool patches);
Way shader_way(std::string name, const Frame& frame, const programmable::Options& options);
Way shader_way(std::string name, const Frame& frame, programmable::Tier tier, bool patches,
               const std::optional<Shading>& shading = {});

}  // namespace twinlight::bench
