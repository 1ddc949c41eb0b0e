#include "judge/fuzz/pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render/context/driver_name.h"
#include "render/context/gl.h"
#include "render/fixed/fixed.h"
#include "render/reference/reference.h"
#include "scene/command/text.h"
#include "scene/state/state.h"

namespace twinlight::fuzz {

namespace {

double codes(double difference) { return std::round(255 * difference); }

// Where the driver has no accumulation buffer, fixed::Driver has one, but not for display lists.
bool lacks_accumulation_buffer() {
    GLint bits = 0;
    glGetIntegerv(GL_ACCUM_RED_BITS, &bits);
    return bits == 0;
}
bool accumulates_in_a_list(const CommandList& scene) {
    bool is_in_list = false;
    return std::ranges::any_of(scene.commands, [&](const Command& command) {
        if (command.id == CommandId::glNewList || command.id == CommandId::glEndList)
            is_in_list = command.id == CommandId::glNewList;
        return is_in_list && command.id == CommandId::glAccum;
    });
}

}  // namespace

Pictures::Pictures(std::vector<std::string_view> lifted) : lifted_(std::move(lifted)), context_(kSide, kSide) {
    renderers_.fixed = fixed::render;
    renderers_.programmable = [this](const Frame& frame, const programmable::Options& options) {
        return context_.shaders().render(frame, options);
    };
    renderers_.reference = reference::render;
    renderers_.allowed_difference = reference::allowed_difference;
    renderers_.precision = measure_drawing_precision();
    context_.make_current();
}

StateDifferences Pictures::compare(const std::shared_ptr<const CommandList>& commands) {
    StateDifferences found;
    try {
        const Scene scene = make_scene(commands, {.width = kSide, .height = kSide});
        if (!scene.frame.unsupported.empty()) {
            found.error = scene.frame.unsupported.front().name + " is not supported";
            return found;
        }
        context_.make_current();
        if (accumulates_in_a_list(*commands) && lacks_accumulation_buffer()) return found;
        const compare::DeparturesOfScene departures(*commands, current_driver(), lifted_);
        if (const compare::Departure* crash = departures.crash_in(scene.frame)) {
            found.left_out[crash] = {1, false};
            return found;
        }
        const compare::Comparison comparison =
            compare::compare_scene(scene, {.budget = 0, .per_vertex_only = true}, renderers_);
        const compare::Departure* departure = departures.in(scene.frame);
        bool shows_bug = false;
        for (std::size_t pair = 0; pair < kPairs; ++pair) {  // both lists have the same order
            const RegionDifference& beyond = comparison.pairs[pair].difference.beyond_allowed;
            // The share of pixels that differ by 1/255 counts over all pictures: in one picture the colour of a whole
            // surface may round either way.
            const bool fails = beyond.max > comparison.tolerance.max;
            shows_bug = shows_bug || (fails && has_fixed(pair));
            if (departure && (has_fixed(pair) || departure->cause != compare::Cause::kFixedFunction)) continue;
            PairDifferences& here = found.pairs[pair];
            here.compared = static_cast<long>(beyond.pixels);
            here.differing = static_cast<long>(beyond.differing);
            here.worst = codes(beyond.max);
            here.fails = fails;
            if (!fails) continue;
            const auto channels = [&](const Image& image) {
                const Rgba& pixel = image.at(beyond.worst_x, beyond.worst_y);
                return fmt::format("({}, {}, {}, {})", channel_code(pixel[0]), channel_code(pixel[1]),
                                   channel_code(pixel[2]), channel_code(pixel[3]));
            };
            here.what = fmt::format("pixel {},{} of {} x {}: {} and {}, {}/255 more than the allowed difference",
                                    beyond.worst_x, beyond.worst_y, kSide, kSide,
                                    channels(comparison.a(comparison.pairs[pair]).image),
                                    channels(comparison.counterpart(comparison.pairs[pair])), here.worst);
        }
        if (departure) found.left_out[departure] = {1, shows_bug};
    } catch (const SceneError& refused) {
        found.error = refused.what();
    }
    return found;
}

}  // namespace twinlight::fuzz
