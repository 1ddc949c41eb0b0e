// The reference: what a plan saves whoever simulates, and how fast its doubles are beside the driver's floats.
#include <fmt/format.h>
#include <sched.h>

#include <algorithm>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "lit_spheres.h"
#include "opponents.h"
#include "ratios.h"
#include "render/context/context.h"
#include "render/context/gl.h"
#include "render/effect/scrubbed_state.h"
#include "render/programmable/programmable.h"
#include "render/reference/reference.h"
#include "render/reference/vertices/draw_lighting.h"

namespace twinlight::bench::reference_bench {
namespace {

void compare_references(Results& results) {
    std::vector<double> ratios;
    for (const LitScene& scene : idle_scenes(sphere(128, 64))) {
        const PlanOptions plan{{.shading = {}, .lecture_variants = false}};
        const reference::Options options{plan};
        const Frame whole = frame_of(scene.draw), scrubbed = scrubbed_frame(whole, plan);
        const std::vector<Timed> times = results.compare(
            "reference, " + scene.name, {{.name = "all state", .run = [&] { reference::render(whole, options); }},
                                         {.name = "scrubbed", .run = [&] { reference::render(scrubbed, options); }}});
        ratios.push_back(times_faster(times[1], times[0]));
    }
    results.ratio("reference_scrubbed_over_reference", geometric_mean(ratios));
}

// ---- Doubles beside floats ----

constexpr int kSide = 512;

programmable::Options phong(programmable::Tier tier) {
    programmable::Options options;
    options.shading = Shading::kPhong;
    options.tier = tier;
    options.lecture_variants = false;
    return options;
}

// As many points of the dome as the reference lights at once, all over it.
std::vector<reference::StageVertex> dome_points(const Draw& dome) {
    constexpr int kRow = 32;
    static_assert(kRow * kRow == reference::PointBatch::kPoints);
    std::vector<reference::StageVertex> points;
    for (int y = 0; y < kRow; ++y)
        for (int x = 0; x < kRow; ++x) {
            const double s = 2.0 * (x + 0.5) / kRow - 1, t = 2.0 * (y + 0.5) / kRow - 1;
            reference::StageVertex& v = points.emplace_back();
            v.position_eye = dome.eye_from_object * glm::dvec4(s, t, -0.3 * (s * s + t * t), 1);
            v.normal_eye = {0.6 * s, 0.6 * t, 1};
        }
    return points;
}
constexpr int kTimes = kSide * kSide / static_cast<int>(reference::PointBatch::kPoints);

volatile double kept = 0;  // so that nothing is left out
void keep(double value) { kept = value; }

// These points' lighting, as often as makes a picture. In a picture, too, points have just been found and lie in the cache;
// finding them, and what becomes of their colours, is left out.
class LitPoints {
  public:
    explicit LitPoints(const Draw& dome) : lighting_(dome, false) {
        points_.makes_unit_normals = true;
        const std::vector<reference::StageVertex> vertices = dome_points(dome);
        for (const reference::StageVertex& v : vertices)
            points_.add(reference::surface_of(v.position_eye, v.normal_eye, reference::Face::kFront));
        points_.add(lighting_.material(vertices.front(), reference::Face::kFront));
    }
    void light(const Arithmetic& arithmetic) {
        for (int i = 0; i < kTimes; ++i) {
            lighting::light_points(lighting_.model(), lighting_.lights(), points_, arithmetic, lit_);
            keep(lit_.primary.y.front());
        }
    }
    // After light(), which gives the results their lengths.
    void light_on(const lighting::InstructionSet& set) {
        for (int i = 0; i < kTimes; ++i) {
            set.light_points(lighting_.model(), lighting_.lights(), points_, {}, lit_);
            keep(lit_.primary.y.front());
        }
    }

  private:
    reference::DrawLighting lighting_;
    lighting::Points points_;
    lighting::Lit<lighting::Column> lit_;
};

// The lighting of one pixel for each of the picture's, on one core; and the driver's picture of the same.
void compare_with_driver(Results& results) {
    const auto context = make_offscreen_context(kSide, kSide);
    programmable::Renderer renderer;
    const auto drawing = [&](std::string name, const Frame& frame, programmable::Tier tier) {
        const auto prepared = std::make_shared<programmable::UploadedFrame>(frame, phong(tier));
        return Way{std::move(name), [&renderer, prepared] {
                       renderer.draw(*prepared);
                       glFinish();
                   }};
    };
    // Also on the processor's narrower instruction sets: most processors have no AVX-512.
    const std::span<const lighting::InstructionSet> narrower = std::span(lighting::instruction_sets()).subspan(1);
    std::vector<std::vector<double>> narrower_nanoseconds(narrower.size()), uniform_over_narrower(narrower.size());
    std::vector<double> nanoseconds, uber_over_reference, uniform_over_reference, baked_over_reference;
    for (const LitScene& scene : seven_scenes()) {
        const Draw draw = on_dome(scene.draw, kSide);
        const Frame frame = frame_of(draw, kSide);
        LitPoints points(draw);
        const std::shared_ptr<Program> uber = make_uber(draw);
        const auto lights = static_cast<double>(std::ranges::count_if(draw.lighting.lights, &LightSource::enabled));
        std::vector<Way> ways = {{.name = "reference, lighting", .run = [&] { points.light({}); }},
                                 drawing("llvmpipe, uniforms", frame, programmable::Tier::kUniform),
                                 drawing("llvmpipe, baked", frame, programmable::Tier::kBaked),
                                 {.name = "llvmpipe, uber shader", .run = [uber] {
                                      uber->draw();
                                      glFinish();
                                  }}};
        for (const lighting::InstructionSet& set : narrower)
            ways.push_back({fmt::format("reference, lighting, {}", set.name), [&] { points.light_on(set); }});
        const auto timed = results.compare("doubles beside floats: " + scene.name, ways);
        const double items = static_cast<double>(kSide) * kSide * lights;
        nanoseconds.push_back(timed[0].least() * 1e9 / items);
        uniform_over_reference.push_back(times_faster(timed[0], timed[1]));
        baked_over_reference.push_back(times_faster(timed[0], timed[2]));
        uber_over_reference.push_back(times_faster(timed[0], timed[3]));
        for (std::size_t i = 0; i < narrower.size(); ++i) {
            narrower_nanoseconds[i].push_back(timed[4 + i].least() * 1e9 / items);
            uniform_over_narrower[i].push_back(times_faster(timed[4 + i], timed[1]));
        }
        results.remark(fmt::format("reference: {:.2f} ns a pixel and light in its fastest round, {:.2f} in the median",
                                   nanoseconds.back(), timed[0].median() * 1e9 / items));
    }
    results.ratio("reference_ns_per_pixel_light", geometric_mean(nanoseconds), Bar{3, true});
    results.ratio("llvmpipe_uniform_phong_over_reference", geometric_mean(uniform_over_reference), Bar{3});
    results.ratio("llvmpipe_baked_phong_over_reference", geometric_mean(baked_over_reference), Bar{1});
    results.ratio("llvmpipe_uber_phong_over_reference", geometric_mean(uber_over_reference));
    for (std::size_t i = 0; i < narrower.size(); ++i) {
        results.ratio(fmt::format("reference_ns_per_pixel_light_{}", narrower[i].name),
                      geometric_mean(narrower_nanoseconds[i]));
        results.ratio(fmt::format("llvmpipe_uniform_phong_over_reference_{}", narrower[i].name),
                      geometric_mean(uniform_over_narrower[i]));
    }
}

// The same lighting in other numbers, and point by point.
void compare_numbers(Results& results) {
    const LitScene scene = seven_scenes()[3];
    const Draw draw = on_dome(scene.draw, kSide);
    const reference::DrawLighting lighting(draw, false);
    LitPoints points(draw);
    const double items = static_cast<double>(kSide) * kSide * kMaxLights;
    const auto in = [&](const char* name, const Arithmetic& arithmetic) {
        return Way{name, [&points, arithmetic] { points.light(arithmetic); }, items};
    };
    const auto one_by_one = [&] {
        const std::vector<reference::StageVertex> vertices = dome_points(draw);
        double sum = 0;
        for (int i = 0; i < kTimes; ++i)
            for (const reference::StageVertex& v : vertices)
                sum += lighting.colors(v, reference::Face::kFront).primary.g;
        keep(sum);
    };
    results.compare(fmt::format("the reference's numbers, a pixel and light ({}): {}",
                                lighting::instruction_sets().front().name, scene.name),
                    {in("doubles", {}),
                     in("doubles, powers by squaring", {.powers = Powers::kSquaring}),
                     in("doubles, powers by table", {.powers = Powers::kTable}),
                     in("floats", {.number = Number::kFloat}),
                     in("long doubles", {.number = Number::kLongDouble}),
                     {.name = "doubles, one point after the other", .run = one_by_one, .items = items}},
                    {.count = 5});
}

// Pictures of the reference on one processor and on all, by the wall clock.
void compare_processors(Results& results) {
    cpu_set_t all, one;
    if (sched_getaffinity(0, sizeof all, &all) != 0) return;
    int first = 0;
    while (!CPU_ISSET(first, &all)) ++first;
    CPU_ZERO(&one);
    CPU_SET(first, &one);
    const Frame frame = frame_of(on_dome(seven_scenes()[3].draw, kSide), kSide);
    const auto drawing = [&](const cpu_set_t& processors) {
        sched_setaffinity(0, sizeof processors, &processors);
        reference::render(frame, reference::Options{phong(programmable::Tier::kUniform)});
    };
    const auto timed =
        results.compare(fmt::format("reference: a picture on 1 and on {} processors", CPU_COUNT(&all)),
                        {{.name = "one", .run = [&] { drawing(one); }}, {.name = "all", .run = [&] { drawing(all); }}},
                        {.clock = Clock::kWall});
    sched_setaffinity(0, sizeof all, &all);
    results.ratio("reference_all_processors_over_one", times_faster(timed[1], timed[0]),
                  CPU_COUNT(&all) == 2 ? std::optional(Bar{1.9}) : std::nullopt);
}

const bool added = add_part("reference", compare_references);
const bool driver_added = add_part("reference_driver", compare_with_driver);
const bool numbers_added = add_part("reference_numbers", compare_numbers);
const bool processors_added = add_part("reference_processors", compare_processors);

}  // namespace
}  // namespace twinlight::bench::reference_bench
