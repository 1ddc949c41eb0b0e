// What a plan saves whoever simulates: the reference, drawing all state and only what is called for.
#include "effect/scrubbed_state.h"
#include "lit_spheres.h"
#include "ratios.h"
#include "reference/reference.h"

namespace twinlight::bench {
namespace {

void compare_references(Results& results) {
    std::vector<double> ratios;
    for (const LitScene& scene : idle_scenes(sphere(128, 64))) {
        RenderOptions options;
        options.lecture_variants = false;
        const Frame whole = frame_of(scene.draw), scrubbed = scrubbed_frame(whole, options);
        const std::vector<Timed> times = results.compare(
            "reference, " + scene.name, {{.name = "all state", .run = [&] { reference::render(whole, options); }},
                                         {.name = "scrubbed", .run = [&] { reference::render(scrubbed, options); }}});
        ratios.push_back(times_faster(times[1], times[0]));
    }
    results.ratio("reference_scrubbed_over_reference", geometric_mean(ratios));
}

const bool added = add_part("reference", compare_references);

}  // namespace
}  // namespace twinlight::bench
