// How fast vertices are lit: the driver's fixed function and shaders, on the same mesh with the same indices.
//
// Nothing is rasterised (GL_RASTERIZER_DISCARD): what is left is the vertex stage, with the indices, the clip tests and the
// driver's calls, which both have alike.
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <memory>

#include "lit_spheres.h"
#include "ratios.h"
#include "render/context/context.h"
#include "render/context/gl.h"
#include "render/effect/plan.h"
#include "render/fixed/replay.h"
#include "render/programmable/programmable.h"
#include "ways.h"

namespace twinlight::bench::vertex_bench {
namespace {

constexpr int kSide = 64;

// ---- The seven scenes ----

void compare_seven_scenes(Results& results, const Draw& mesh) {
    std::vector<double> baked, uniform, baked_rows, uniform_rows, banded;
    for (const LitScene& scene : seven_scenes(mesh)) {
        const Frame frame = frame_of(scene.draw);
        const auto timed =
            results.compare(scene.name, {fixed_way("fixed, rows", frame, fixed::Scrub::kNothing, false),
                                         shader_way("uniforms, rows", frame, programmable::Tier::kUniform, false),
                                         shader_way("baked, rows", frame, programmable::Tier::kBaked, false),
                                         fixed_way("fixed, patches", frame, fixed::Scrub::kNothing, true),
                                         shader_way("uniforms, patches", frame, programmable::Tier::kUniform, true),
                                         shader_way("baked, patches", frame, programmable::Tier::kBaked, true)});
        uniform_rows.push_back(times_faster(timed[1], timed[0]));
        baked_rows.push_back(times_faster(timed[2], timed[0]));
        uniform.push_back(times_faster(timed[4], timed[3]));
        baked.push_back(times_faster(timed[5], timed[3]));
        banded.push_back(times_faster(timed[5], timed[0]));
    }
    results.ratio("vertex_baked_over_fixed", geometric_mean(baked), Bar{2});
    results.ratio("vertex_uniform_over_fixed", geometric_mean(uniform), Bar{1});
    results.ratio("vertex_banded_over_fixed_row_major", geometric_mean(banded), Bar{5});
    results.ratio("vertex_baked_row_major_over_fixed_row_major", geometric_mean(baked_rows));
    results.ratio("vertex_uniform_row_major_over_fixed_row_major", geometric_mean(uniform_rows));
}

void compare_precise(Results& results, const Draw& mesh) {
    programmable::Options precise = options_for(programmable::Tier::kUniform, true);
    precise.precise = true;
    std::vector<double> ratios;
    for (const LitScene& scene : seven_scenes(mesh)) {
        const Frame frame = frame_of(scene.draw);
        const auto timed = results.compare(
            scene.name + ", --precise",
            {shader_way("uniforms", frame, programmable::Tier::kUniform, true), shader_way("precise", frame, precise)});
        ratios.push_back(times_faster(timed[1], timed[0]));
    }
    results.ratio("vertex_precise_over_uniform", geometric_mean(ratios));
}

void compare_scrubbed(Results& results, const Draw& mesh) {
    std::vector<double> ratios;
    for (const LitScene& scene : idle_scenes(mesh)) {
        const Frame frame = frame_of(scene.draw);
        const auto timed =
            results.compare(scene.name, {fixed_way("fixed, all that is told", frame, fixed::Scrub::kNothing, true),
                                         fixed_way("fixed, scrubbed", frame, fixed::Scrub::kState, true)});
        ratios.push_back(times_faster(timed[1], timed[0]));
        results.ratio("fixed_scrubbed_over_fixed: " + scene.name.substr(0, scene.name.find(':')), ratios.back());
    }
    results.ratio("fixed_scrubbed_over_fixed", geometric_mean(ratios), Bar{1.3});
}

void compare_vertices(Results& results) {
    const auto context = make_offscreen_context(kSide, kSide);
    glEnable(GL_RASTERIZER_DISCARD);
    const Draw mesh = sphere(512, 256);
    compare_scrubbed(results, mesh);
    compare_seven_scenes(results, mesh);
    compare_precise(results, mesh);
}

// ---- The first frame, planning ----

// A context, the buffers, the programs compiled, one picture.
void compare_first_frames(Results& results) {
    const LitScene scene = seven_scenes(sphere(64, 32)).at(1);
    const Frame frame = frame_of(scene.draw);
    const auto first = [&](const std::function<Way()>& make) {
        return [make] {
            const auto context = make_offscreen_context(kSide, kSide);
            make().run();
        };
    };
    const auto timed = results.compare(
        "the first frame, programs compiled: " + scene.name,
        {{"fixed", first([&] { return fixed_way("", frame, fixed::Scrub::kNothing, false); })},
         {"uniforms", first([&] { return shader_way("", frame, programmable::Tier::kUniform, false); })},
         {"baked", first([&] { return shader_way("", frame, programmable::Tier::kBaked, false); })}});
    results.ratio("first_frame_over_fixed", times_faster(timed[1], timed[0]));
    results.ratio("first_frame_baked_over_fixed", times_faster(timed[2], timed[0]));
}

Way planning(const Draw& draw) {
    const auto facts = std::make_shared<const VertexFacts>(vertex_facts(draw));
    return {"planned, where the vertices' facts are kept",
            [facts, &draw] { plan_effects(draw, options_for(programmable::Tier::kUniform, true), *facts); }};
}

void compare_planning(Results& results) {
    const auto context = make_offscreen_context(kSide, kSide);
    std::vector<double> shares, anew;
    for (const LitScene& scene : seven_scenes(sphere(512, 256))) {
        const Frame frame = frame_of(scene.draw);
        const auto timed =
            results.compare("planning: " + scene.name,
                            {shader_way("baked, patches, drawn into 64 x 64", frame, programmable::Tier::kBaked, true),
                             planning(scene.draw),
                             {"planned, the vertices looked through",
                              [&] { plan_effects(scene.draw, options_for(programmable::Tier::kUniform, true)); }}});
        const auto share = [&](std::size_t i) { return timed[i].median() / (timed[i].median() + timed[0].median()); };
        shares.push_back(share(1));
        anew.push_back(share(2));
    }
    results.ratio("planning_share", *std::ranges::max_element(shares), Bar{0.02, true});
    results.ratio("planning_share_vertices_looked_through", *std::ranges::max_element(anew));
}

// ---- Frame after frame ----

// A window's frames: each is given as a whole, and a light has moved. `moves_vertices`: a vertex as well.
Way live_way(std::string name, const Draw& draw, const programmable::KeptLimits& limits, bool moves_vertex = false) {
    const auto renderer = std::make_shared<programmable::Renderer>(limits);
    const auto frame = std::make_shared<Frame>(frame_of(draw));
    const auto step = [=, number = 0]() mutable {
        Draw& moving = std::get<Draw>(frame->items.at(0));
        const double shift = 1e-3 * (++number % 7);
        moving.lighting.lights[0].position_eye.x = draw.lighting.lights[0].position_eye.x + shift;
        if (moves_vertex)
            moving.vertices.edit().back().position_object.x = draw.vertices.back().position_object.x + 1e-9 * number;
        renderer->draw(*frame, options_for(programmable::Tier::kAuto, false));
        glFinish();
    };
    return {std::move(name), step};
}

void compare_still_frames(Results& results) {
    const auto context = make_offscreen_context(kSide, kSide);
    const programmable::KeptLimits nothing{.mesh_bytes = 0};
    std::vector<double> still, changing, known;
    for (const LitScene& scene : seven_scenes(sphere(512, 256))) {
        const auto timed = results.compare(
            "frame after frame: " + scene.name,
            {live_way("anew each time", scene.draw, nothing), live_way("vertices kept", scene.draw, {}),
             live_way("one vertex moves", scene.draw, {}, true),
             shader_way("planned and sent once", frame_of(scene.draw), programmable::Tier::kAuto, false)});
        still.push_back(times_faster(timed[1], timed[0]));
        changing.push_back(times_faster(timed[2], timed[0]));
        known.push_back(times_faster(timed[3], timed[1]));
    }
    results.ratio("still_frame_over_new_frame", geometric_mean(still));
    results.ratio("changing_frame_over_new_frame", geometric_mean(changing));
    results.ratio("prepared_frame_over_still_frame", geometric_mean(known));
}

// ---- More lights than matter ----

// Eight lights near by, and the others far away or with cones that miss: planned and drawn.
Draw with_many_lights(const Draw& eight, int count) {
    Draw draw = eight;
    auto& lights = draw.lighting.lights;
    for (int i = kMaxLights; i < count; ++i) {
        LightSource light = lights.at(static_cast<std::size_t>(i % kMaxLights));
        if (i % 2 == 0) {
            light.position_eye = {3000 * std::cos(i), 3000 * std::sin(i), -2000, 1};
            light.quadratic_attenuation = 1;
        } else {
            light.spot_cutoff_deg = 20;
            light.spot_direction_eye = glm::dvec3(light.position_eye) - glm::dvec3(0, 0, -5);
        }
        lights.push_back(light);
    }
    return draw;
}

double many_lights_over_eight(Results& results, bool rasterised) {
    constexpr int kPicture = 512;
    const auto context = make_offscreen_context(kPicture, kPicture);
    if (!rasterised) glEnable(GL_RASTERIZER_DISCARD);
    Draw eight = seven_scenes(sphere(512, 256)).at(3).draw;
    eight.raster.viewport = {0, 0, kPicture, kPicture};
    std::vector<Draw> draws;
    std::vector<Way> ways;
    for (const int count : {8, 64, 512, 4096}) draws.push_back(with_many_lights(eight, count));
    Draw one = eight;
    for (std::size_t i = 1; i < kMaxLights; ++i) one.lighting.lights[i].enabled = false;
    draws.push_back(one);
    for (const Draw& draw : draws) {
        const Way drawing = shader_way("", frame_of(draw, kPicture), programmable::Tier::kUniform, true);
        const Way plan = planning(draw);
        const std::size_t lit = plan_effects(draw, options_for(programmable::Tier::kUniform, true)).lights.size();
        const std::string name =
            &draw == &draws.back() ? "1 light" : fmt::format("{} lights", draw.lighting.lights.size());
        ways.push_back({fmt::format("{}, of which {} matter", name, lit), [drawing, plan] {
                            plan.run();
                            drawing.run();
                        }});
    }
    const auto timed = results.compare(
        rasterised ? "lights that exist, planned and drawn into 512 x 512" : "the same without rasterisation", ways);
    return times_faster(timed[0], timed[3]);
}

void compare_many_lights(Results& results) {
    results.ratio("lights_8_over_4096", many_lights_over_eight(results, true), Bar{1.2, true});
    results.ratio("lights_8_over_4096_vertex_stage", many_lights_over_eight(results, false));
}

const bool added = add_part("vertex", compare_vertices) && add_part("first_frame", compare_first_frames) &&
                   add_part("planning", compare_planning) && add_part("still", compare_still_frames) &&
                   add_part("lights", compare_many_lights);

}  // namespace
}  // namespace twinlight::bench::vertex_bench
