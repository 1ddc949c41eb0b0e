// Which pictures are drawn, which are held against each other, and what they are held to.
#include "judge/compare/comparison.h"

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <utility>

#include "judge/compare/allowed_difference.h"
#include "judge/compare/departures.h"

namespace twinlight::compare {

namespace {

constexpr RenderOptions kPerVertex = {.shading = std::nullopt, .lecture_variants = false};
constexpr RenderOptions kPerPixel = {.shading = Shading::kPhong, .lecture_variants = true};

struct PlannedRender {
    const char* name;
    const char* meaning;
    RenderFunction Renderers::*renderer;
    RenderOptions options;
    bool by_driver;
};
const std::array kRenders = {
    PlannedRender{"fixed", "The driver's fixed function carries the commands out. It lights vertices.",
                  &Renderers::fixed, kPerVertex, true},
    PlannedRender{"programmable", "Shaders on the same driver light vertices by GL's model.", &Renderers::programmable,
                  kPerVertex, true},
    PlannedRender{"reference", "The specification's equation in double precision, no driver. It lights vertices.",
                  &Renderers::reference, kPerVertex, false},
    PlannedRender{"programmable-phong", "Shaders light every pixel and follow the scene's pragmas.",
                  &Renderers::programmable, kPerPixel, true},
    PlannedRender{"reference-phong", "The reference lights every pixel and follows the scene's pragmas.",
                  &Renderers::reference, kPerPixel, false},
};

// The same of exact surfaces.
PlannedRender exact(PlannedRender planned) {
    planned.name = planned.by_driver ? "programmable-exact" : "reference-exact";
    planned.meaning =
        planned.by_driver
            ? "Shaders cast a ray through every pixel at the surfaces that curved shapes stand for."
            : "The reference casts a ray through every pixel at the surfaces that curved shapes stand for.";
    planned.options.shading = Shading::kExact;
    return planned;
}

constexpr std::size_t kReference = 2, kReferencePhong = 4;

struct PlannedPair {
    std::size_t a, b;  // into kRenders
    bool judged;
    bool phong = false;  // both
};
constexpr std::array kPairs = {
    PlannedPair{0, 1, true},       PlannedPair{0, 2, true},  PlannedPair{1, 2, true},
    PlannedPair{3, 4, true, true}, PlannedPair{0, 3, false},  // what GL's lighting of vertices cannot show
};

bool is_of_drivers(const PlannedPair& pair) { return kRenders[pair.a].by_driver && kRenders[pair.b].by_driver; }

// `warms_up`: what a driver draws with is drawn once before it is timed.
Render render(const PlannedRender& planned, const Frame& frame, const Renderers& renderers, bool warms_up) {
    using Clock = std::chrono::steady_clock;
    const RenderFunction& draw = renderers.*planned.renderer;
    if (planned.by_driver && warms_up) draw(frame, planned.options);
    const Clock::time_point start = Clock::now();
    Image image = draw(frame, planned.options);
    const std::chrono::duration<double, std::milli> taken = Clock::now() - start;
    Render result{.name = planned.name, .meaning = planned.meaning, .image = std::move(image), .ms = taken.count()};
    if (planned.renderer == &Renderers::programmable && !planned.options.precise)
        result.plan = explain(frame, planned.options);
    if (!planned.by_driver && has_quadrilaterals(frame)) {
        RenderOptions other = planned.options;
        other.quad_cut = QuadCut::kSecondToFourth;
        result.other_cut = draw(frame, other);
    }
    return result;
}

}  // namespace

Image Comparison::counterpart(const Pair& pair) const {
    return b(pair).other_cut ? nearer_of(a(pair).image, b(pair).image, *b(pair).other_cut, freedom.slack)
                             : b(pair).image;
}

Comparison compare_scene(const Frame& frame, const Renderers& renderers, const CompareOptions& options) {
    constexpr int kSteps = static_cast<int>(kRenders.size()) + 2;
    int done = 0;
    const auto begin_step = [&](std::string_view name) {
        if (options.progress) options.progress(done++, kSteps, name);
    };

    Comparison result;
    if (frame.commands) result.scene = frame.commands->name;
    result.driver = options.driver;
    result.width = frame.width;
    result.height = frame.height;
    result.unsupported = frame.unsupported;
    for (PlannedRender planned : kRenders) {
        const bool is_per_pixel = planned.options.shading.has_value();
        if (is_per_pixel && options.per_vertex_only) continue;
        planned.options.budget = options.budget;
        if (options.precise && planned.renderer == &Renderers::programmable && !is_per_pixel) {
            planned.options.precise = true;
            planned.meaning =
                "Shaders light vertices by GL's model, in the order of operations of Mesa's fixed function.";
        }
        if (is_per_pixel && options.per_pixel == Shading::kExact) planned = exact(planned);
        begin_step(planned.name);
        result.renders.push_back(render(planned, frame, renderers, !options.per_vertex_only));
    }
    begin_step("edges");
    result.freedom = renderers.freedom(frame, kPerVertex);
    RenderOptions of_pixels = kPerPixel;
    of_pixels.shading = options.per_pixel;
    Freedom of_phong = options.per_vertex_only ? result.freedom : renderers.freedom(frame, of_pixels);
    for (std::size_t i = 0; i < result.freedom.edge.size(); ++i) {  // one mask for all pairs
        result.freedom.edge[i] = of_phong.edge[i] = result.freedom.edge[i] || of_phong.edge[i];
    }

    allow_ties(result.freedom, result.renders[kReference].image);
    if (!options.per_vertex_only) allow_ties(of_phong, result.renders[kReferencePhong].image);

    begin_step("differences");
    const Freedom of_drivers = freedom_of_drivers(result.freedom, result.renders[kReference]);
    for (const PlannedPair& planned : kPairs) {
        if (planned.b >= result.renders.size()) continue;  // per pixel
        Pair pair;
        pair.a = planned.a;
        pair.b = planned.b;
        const Freedom& freedom = is_of_drivers(planned) ? of_drivers : planned.phong ? of_phong : result.freedom;
        pair.difference = difference(result.a(pair).image, result.counterpart(pair),
                                     with_plans(freedom, result.a(pair), result.b(pair),
                                                result.renders[planned.phong ? kReferencePhong : kReference]));
        if (planned.judged) pair.verdict = judge(result, pair);
        // The interior is what is judged; an edge pixel that is wholly different must not darken it.
        pair.factor = amplification_for(pair.difference.interior.max);
        result.pairs.push_back(pair);
    }
    const Driver driver = parse_driver_name(options.driver);
    result.is_listed_driver = is_listed(driver);
    if (!result.within_tolerance())
        for (const Departure* departure : known_departures_in(frame, driver))
            result.known_departures.push_back(fmt::format("{} ({})", departure->name, departure->section));
    return result;
}

}  // namespace twinlight::compare
