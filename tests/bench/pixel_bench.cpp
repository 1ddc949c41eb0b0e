// How fast fragments are lit: a shader with a scene's numbers baked in, against programs that serve every scene.
#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <memory>
#include <stdexcept>

#include "lit_spheres.h"
#include "opponents.h"
#include "ratios.h"
#include "render/context/context.h"
#include "render/context/gl.h"
#include "render/programmable/programmable.h"

namespace twinlight::bench::pixel_bench {
namespace {

constexpr int kSide = 512;

Way finishing(std::string name, std::function<void()> draw) {
    return {std::move(name), [draw = std::move(draw)] {
                draw();
                glFinish();
            }};
}

// They must draw the same, or the comparison is of nothing.
void check_same(const std::string& name, const std::vector<Way>& ways) {
    std::optional<Image> first;
    for (const Way& way : ways) {
        way.run();
        Image picture = read_pixels(kSide, kSide);
        if (!first)
            first = std::move(picture);
        else
            for (std::size_t i = 0; i < picture.pixels.size(); ++i)
                for (std::size_t channel = 0; channel < 3; ++channel)
                    if (std::abs(picture.pixels[i][channel] - first->pixels[i][channel]) > 2.5 / 255)
                        throw std::runtime_error(
                            fmt::format("{}: {} draws another picture than {}; pixel {}: {} and {}", name, way.name,
                                        ways.front().name, i, picture.pixels[i][channel], first->pixels[i][channel]));
    }
}

void compare_pixels(Results& results) {
    const auto context = make_offscreen_context(kSide, kSide);
    programmable::Renderer renderer;
    const auto drawing = [&](std::string name, const Frame& frame, programmable::Tier tier) {
        programmable::Options options;
        options.shading = Shading::kPhong;
        options.tier = tier;
        const auto prepared = std::make_shared<programmable::UploadedFrame>(frame, options);
        return finishing(std::move(name), [&renderer, prepared] { renderer.draw(*prepared); });
    };
    std::vector<double> over_uber, uniform_over_uber;
    bool is_first = true;  // of the seven: one directional, diffuse light
    for (const LitScene& scene : seven_scenes()) {
        const Draw draw = on_dome(scene.draw, kSide);
        const Frame frame = frame_of(draw, kSide);
        const auto uber = std::shared_ptr(make_uber(draw));
        std::vector<Way> ways = {finishing("uber shader, a loop", [uber] { uber->draw(); }),
                                 drawing("uniforms", frame, programmable::Tier::kUniform),
                                 drawing("baked", frame, programmable::Tier::kBaked)};
        if (is_first) {
            const auto flags = std::shared_ptr(make_flag_uber(draw));
            ways.push_back(finishing("uber shader, flags", [flags] { flags->draw(); }));
        }
        check_same(scene.name, ways);
        Draw unlit = draw;
        unlit.lighting.enabled = false;
        const Frame unlit_frame = frame_of(unlit, kSide);
        ways.push_back(drawing("baked, without lighting", unlit_frame,
                               programmable::Tier::kBaked));  // what no shader can do without
        const auto timed = results.compare("per fragment: " + scene.name, ways);
        over_uber.push_back(times_faster(timed[2], timed[0]));
        uniform_over_uber.push_back(times_faster(timed[1], timed[0]));
        if (std::exchange(is_first, false))
            results.ratio("pixel_baked_over_flag_uber_one_diffuse", times_faster(timed[2], timed[3]), Bar{30});
    }
    results.ratio("pixel_baked_over_uber", geometric_mean(over_uber), Bar{6});
    results.ratio("pixel_uniform_over_uber", geometric_mean(uniform_over_uber));
}

const bool added = add_part("pixel", compare_pixels);

}  // namespace
}  // namespace twinlight::bench::pixel_bench
