// How fast vertices are lit: the driver's fixed function and shaders, on the same mesh with the same indices.
#include <fmt/format.h>

#include <memory>

#include "context/context.h"
#include "context/gl.h"
#include "fixed/prepared_frame.h"
#include "lit_spheres.h"
#include "programmable/programmable.h"
#include "ratios.h"
#include "shape/vertex_order.h"

namespace twinlight::bench {
namespace {

constexpr int kSide = 64;

// A way that draws the frame again and again, and waits until it is drawn.
Way drawing(std::string name, const std::shared_ptr<fixed::PreparedFrame>& frame) {
    return {std::move(name), [frame] {
                frame->draw();
                glFinish();
            }};
}

std::shared_ptr<fixed::PreparedFrame> prepared(const Frame& frame, fixed::Scrub scrub) {
    return std::make_shared<fixed::PreparedFrame>(frame, RenderOptions{}, scrub);
}

void compare_vertices(Results& results) {
    const auto context = make_offscreen_context(kSide, kSide);
    if (getenv("RD")) glEnable(GL_RASTERIZER_DISCARD);
    std::vector<double> scrubbed_over_fixed;
    for (const LitScene& scene : idle_scenes()) {
        const Frame frame = frame_of(scene.draw);
        const auto timed = results.compare(
            scene.name, {drawing("fixed", prepared(frame, fixed::Scrub::kNothing)),
                         drawing("fixed, state scrubbed", prepared(frame, fixed::Scrub::kState)),
                         drawing("fixed, state scrubbed, indices in patches", prepared(frame, fixed::Scrub::kAll))});
        scrubbed_over_fixed.push_back(times_faster(timed[1], timed[0]));
    }
    results.ratio("fixed_scrubbed_over_fixed", geometric_mean(scrubbed_over_fixed), Bar{1.3});

    for (const LitScene& scene : seven_scenes()) {
        const Frame frame = frame_of(scene.draw);
        const auto timed = results.compare(
            scene.name, {drawing("fixed", prepared(frame, fixed::Scrub::kNothing)),
                         drawing("fixed, state scrubbed", prepared(frame, fixed::Scrub::kState)),
                         drawing("fixed, state scrubbed, indices in patches", prepared(frame, fixed::Scrub::kAll))});
    }
}

const bool added = add_part("vertex", compare_vertices);

}  // namespace
}  // namespace twinlight::bench
