// Draws the pictures, compares them in pairs, and applies the allowed differences.
#include "judge/compare/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <functional>
#include <set>
#include <utility>

#include "judge/compare/allowances.h"
#include "judge/compare/causes.h"
#include "judge/compare/departures.h"
#include "judge/compare/missing.h"
#include "judge/compare/vertex_colors.h"
#include "render/programmable/shader_program.h"
#include "render/reference/reference.h"
#include "render/reference/undefined_colors.h"

namespace twinlight::compare {

namespace {

struct PlannedRender {
    Path path;
    bool per_pixel;  // lighting per pixel, with the lecture's variants
    const char* name;
    const char* meaning;

    bool by_driver() const { return path != Path::kReference; }
};
constexpr std::array kRenders = {
    PlannedRender{Path::kFixed, false, "fixed",
                  "The driver's fixed function runs the commands and lights each vertex."},
    PlannedRender{Path::kProgrammable, false, "shaders",
                  "Shaders on the same driver light each vertex, with GL's model."},
    PlannedRender{
        Path::kReference, false, "reference",
        "The reference lights each vertex in double precision, with the specification's equation and no driver."},
    PlannedRender{Path::kProgrammable, true, "shaders-phong", "Shaders light each pixel, with the scene's variants."},
    PlannedRender{Path::kReference, true, "reference-phong",
                  "The reference lights each pixel, with the scene's variants."},
};
// With exact surfaces: these instead of the phong pictures.
constexpr std::array kExactRenders = {
    PlannedRender{Path::kProgrammable, true, "shaders-exact",
                  "Shaders draw curved shapes exactly, by casting a ray through each pixel."},
    PlannedRender{Path::kReference, true, "reference-exact",
                  "The reference draws curved shapes exactly, by casting a ray through each pixel."},
};
constexpr const char* kPreciseMeaning =
    "Shaders light each vertex, with GL's model and in the order of operations of Mesa's fixed function.";

// The per-vertex pictures follow GL's own model.
Look look_of(bool per_pixel, const CompareOptions& options) {
    return per_pixel ? twinlight::look_of(options.per_pixel, true) : kGlsOwnModel;
}

constexpr std::size_t kReference = 2, kReferencePhong = 4;

struct PlannedPair {
    std::size_t a, b;    // into kRenders
    bool judged;         // has a tolerance
    bool phong = false;  // both are lit per pixel
};
constexpr std::array kPairs = {
    PlannedPair{0, 1, true},       PlannedPair{0, 2, true},  PlannedPair{1, 2, true},
    PlannedPair{3, 4, true, true}, PlannedPair{0, 3, false},  // shows what is lost by lighting only vertices
};

bool is_of_drivers(const PlannedPair& pair) { return kRenders[pair.a].by_driver() && kRenders[pair.b].by_driver(); }

// The driver draws each picture twice, and only the second is timed, because the first includes compiling.
template <class Draw>
auto timed(bool twice, double& ms, const Draw& draw) {
    using Clock = std::chrono::steady_clock;
    if (twice) draw();
    const Clock::time_point start = Clock::now();
    auto picture = draw();
    ms = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    return picture;
}

Render render(const PlannedRender& planned, const Scene& scene, const CompareOptions& options,
              const Renderers& renderers) {
    Render result{.path = planned.path, .name = planned.name, .meaning = planned.meaning, .image = {}};
    const Look look = look_of(planned.per_pixel, options);
    const bool twice = planned.by_driver() && !options.per_vertex_only;
    switch (planned.path) {
        case Path::kFixed:
            result.image = timed(twice, result.ms, [&] { return renderers.fixed(scene, {look.shading}); });
            break;
        case Path::kProgrammable: {
            programmable::Options shaders{{look, options.budget}};
            shaders.precise = options.precise && !planned.per_pixel;
            if (shaders.precise) result.meaning = kPreciseMeaning;
            result.image = timed(twice, result.ms, [&] { return renderers.programmable(scene.frame, shaders); });
            if (!shaders.precise) result.plan = explain_draws(scene.frame, shaders);
            break;
        }
        case Path::kReference:
            result.image =
                timed(twice, result.ms, [&] { return renderers.reference(scene.frame, reference::Options{look}); });
            if (reference::has_quadrilaterals(scene.frame))
                result.other_cut = renderers.reference(scene.frame, {look, reference::QuadCut::kSecondToFourth});
            break;
    }
    return result;
}

// The reference's picture in the cuts that are nearest to `image`, pixel by pixel.
Image nearest_cut(const Image& image, const Render& reference, const AllowedDifference& allowed) {
    if (!reference.other_cut) return reference.image;
    return nearer_of(image, reference.image, *reference.other_cut, allowed.channels());
}

// The same, also with some Draws' quadrilaterals cut one way and some the other. A driver may choose for each: llvmpipe cuts strips and
// borders in ways of their own. Nothing if that is no choice, or if more Draws have quadrilaterals than are tried.
std::optional<Image> nearest_mix(const Image& image, Image nearest, const Frame& frame, const Look& look,
                                 const AllowedDifference& allowed, const Renderers& renderers) {
    constexpr std::size_t kMostDraws = 4;
    const std::vector<std::size_t> numbers = reference::draws_of_quadrilaterals(frame);
    if (numbers.size() < 2 || numbers.size() > kMostDraws) return std::nullopt;
    const Image channels = allowed.channels();
    // All but those in which all are cut alike.
    for (unsigned mix = 1; mix + 1 < 1U << numbers.size(); ++mix) {
        reference::Options options{look};
        options.cut_otherwise.resize(numbers.back() + 1);
        for (std::size_t i = 0; i < numbers.size(); ++i) options.cut_otherwise[numbers[i]] = (mix >> i & 1U) != 0;
        nearest = nearer_of(image, nearest, renderers.reference(frame, options), channels);
    }
    return nearest;
}

// Draws what Comparison::changed_by_missing needs.
PixelMask changed_by_missing(const Scene& scene, const Render& fixed, const CompareOptions& options,
                             const Renderers& renderers) {
    const auto less = without_missing(scene.recording, scene.frame.unsupported);
    if (!less) return {};
    return changed_pixels(fixed.image, renderers.fixed(with_commands(scene, less), {look_of(false, options).shading}));
}

// Whether only one of the two lacks something that only the fixed function draws.
bool differ_in_missing(const Comparison& comparison, const Pair& pair) {
    return std::ranges::any_of(comparison.unsupported, [&](const Unsupported& item) {
        return item.missing_from == MissingFrom::kFrame &&
               lacks(comparison.a(pair).path, item) != lacks(comparison.b(pair).path, item);
    });
}

// The Draws that show where the fixed function differs. All of them where that is not known: colours are mixed, or nothing is drawn.
std::vector<const Draw*> draws_that_differ(const Frame& frame, const PixelMask& differing) {
    const std::vector<const Draw*> draws = frame.draws(), all = draws_of_all_pictures(frame);
    const std::vector<int> seen = reference::seen_draws(frame, {kGlsOwnModel});
    std::set<int> numbers;
    for (std::size_t i = 0; i < differing.size(); ++i)
        if (differing[i]) numbers.insert(seen[i]);
    if (numbers.empty() || numbers.contains(-1)) return all;
    std::vector<const Draw*> result;
    for (const int number : numbers) result.push_back(draws[static_cast<std::size_t>(number)]);
    return std::ranges::any_of(result, [](const Draw* draw) { return draw->shows_copies(); }) ? all : result;
}

// Whether pictures differ, or are not judged in whole, in which the bug has a part.
bool may_cause_difference(const Comparison& comparison, const Departure& departure) {
    const bool misses_unknown = comparison.changed_by_missing.empty();
    return std::ranges::any_of(comparison.pairs, [&](const Pair& pair) {
        const bool is_open = pair.verdict == Verdict::kBeyond || (pair.verdict == Verdict::kPartial && misses_unknown);
        const auto has_part = [&](const Render& render) {
            return departure.cause == Cause::kFixedFunction ? render.path == Path::kFixed
                                                            : render.path != Path::kReference;
        };
        const bool is_proved = !comparison.proved_causes.empty() && comparison.a(pair).path == Path::kFixed;
        return is_open && !is_proved && (has_part(comparison.a(pair)) || has_part(comparison.b(pair)));
    });
}

std::string named(const Departure& departure) { return fmt::format("{} ({})", departure.name, departure.section); }

// `allowed`: between the fixed function and the reference. `differing`: where the former differs.
Causes causes_of(const Comparison& comparison, const Scene& scene, const std::vector<const Departure*>& known,
                 const AllowedDifference& allowed, const PixelMask& differing, const CompareOptions& options,
                 const Renderers& renderers) {
    const Render &fixed = comparison.renders.front(), &right = comparison.renders[kReference];
    const Look look = look_of(false, options);
    const auto is_near = [&](const Image& image, const Image& counterpart) {
        return is_within(difference(image, counterpart, allowed), comparison.tolerance);
    };
    const auto is_right = [&](const Image& image) {
        const Image nearest = nearest_cut(image, right, comparison.allowed);
        if (is_near(image, nearest)) return true;
        if (!right.other_cut) return false;
        const auto mix = nearest_mix(image, nearest, scene.frame, look, comparison.allowed, renderers);
        return mix && is_near(image, *mix);
    };
    return find_causes(scene, known,
                       {.draw_fixed = [&](const Scene& less) { return renderers.fixed(less, {look.shading}); },
                        .is_right = is_right,
                        .is_same = [&](const Frame& frame) { return is_right(renderers.reference(frame, {look})); },
                        .fixed = fixed.image,
                        .differing = differing});
}

// Shaders that the driver refuses are a part of the scene that they do not draw.
void add_refused(std::vector<Unsupported>& unsupported, const Frame& frame, const std::string& why) {
    const std::string name = "a picture by shaders (" + why + ")";
    if (std::ranges::find(unsupported, name, &Unsupported::name) != unsupported.end()) return;
    const std::vector<const Draw*> draws = frame.draws();
    unsupported.push_back({name, 1, draws.empty() ? Place{} : draws.front()->place, MissingFrom::kShaders});
}

}  // namespace

Image Comparison::counterpart(const Pair& pair) const { return nearest_cut(a(pair).image, b(pair), allowed); }

Comparison compare_scene(const Scene& scene, const CompareOptions& options, const Renderers& renderers) {
    constexpr int kSteps = static_cast<int>(kRenders.size()) + 2;
    int done = 0;
    const auto begin_step = [&](std::string_view name) {
        if (options.progress) options.progress(done++, kSteps, name);
    };

    Comparison result;
    const Frame& frame = scene.frame;
    const bool all = !options.per_vertex_only;
    result.scene = scene.title();
    result.driver = options.driver;
    result.library = options.library;
    result.precision = renderers.precision;
    result.width = frame.width;
    result.height = frame.height;
    result.unsupported = frame.unsupported;
    result.labels = frame.labels;
    result.notes = scene.notes;
    for (std::size_t i = 0; i < kRenders.size(); ++i) {
        const bool exact = kRenders[i].per_pixel && options.per_pixel == Shading::kExact;
        const PlannedRender& planned =
            exact ? kExactRenders[i - (kRenders.size() - kExactRenders.size())] : kRenders[i];
        if (planned.per_pixel && !all) continue;
        begin_step(planned.name);
        try {
            result.renders.push_back(render(planned, scene, options, renderers));
        } catch (const programmable::ShaderRefused& refused) {
            result.renders.push_back({.path = planned.path,
                                      .name = std::string(planned.name),
                                      .meaning = std::string(planned.meaning),
                                      .image = Image(frame.width, frame.height)});
            add_refused(result.unsupported, frame, refused.what());
        }
    }
    result.changed_by_missing = changed_by_missing(scene, result.renders.front(), options, renderers);
    begin_step("edges");
    const auto allowed_of = [&](bool per_pixel) {
        reference::Options of_driver{look_of(per_pixel, options)};
        of_driver.approximates_rho = renderers.precision.approximates_rho;
        of_driver.border = std::max(of_driver.border, 2 * renderers.precision.position);
        return renderers.allowed_difference(frame, of_driver);
    };
    result.allowed = allowed_of(false);
    AllowedDifference of_phong = all ? allowed_of(true) : result.allowed;

    const auto allow_precision = [&](AllowedDifference& allowed, const Render& right) {
        const Image* other_cut = right.other_cut ? &*right.other_cut : nullptr;
        allow_reference(allowed, right.image, other_cut);
        allow_drawing(allowed, right.image, other_cut, renderers.precision);
    };
    allow_precision(result.allowed, result.renders[kReference]);
    if (all) allow_precision(of_phong, result.renders[kReferencePhong]);

    begin_step("differences");
    const AllowedDifference of_drivers = allowed_of_drivers(result.allowed, result.renders[kReference]);
    PixelMask differing_from_fixed;
    std::optional<AllowedDifference> of_fixed;  // between it and the reference, if they differ
    // Each of two drivers is held to the reference, so what may lie between the two is not counted.
    const Judged judged_per_vertex = judged(result.allowed), judged_per_pixel = judged(of_phong);
    for (const PlannedPair& planned : kPairs) {
        if (kRenders[planned.b].per_pixel && !all) continue;
        Pair pair;
        pair.a = planned.a;
        pair.b = planned.b;
        const AllowedDifference& allowed = is_of_drivers(planned) ? of_drivers
                                           : planned.phong        ? of_phong
                                                                  : result.allowed;
        Image counterpart = result.counterpart(pair);
        std::optional<AllowedDifference> changed = with_plans(
            allowed, result.a(pair), result.b(pair), result.renders[planned.phong ? kReferencePhong : kReference]);
        pair.difference = difference(result.a(pair).image, counterpart, changed ? *changed : allowed);
        if (planned.judged && result.b(pair).other_cut && !is_within(pair.difference, result.tolerance)) {
            pair.counterpart = nearest_mix(result.a(pair).image, counterpart, frame, look_of(planned.phong, options),
                                           result.allowed, renderers);
            if (pair.counterpart) {
                counterpart = *pair.counterpart;
                pair.difference = difference(result.a(pair).image, counterpart, changed ? *changed : allowed);
            }
        }
        if (planned.judged && !result.changed_by_missing.empty() && differ_in_missing(result, pair)) {
            if (!changed) changed = allowed;
            for (std::size_t i = 0; i < changed->edge.size(); ++i) {
                if (!result.changed_by_missing[i]) continue;
                changed->edge[i] = true;
                if (!changed->open.empty()) changed->open[i] = bit_of(Why::kMissing);
                changed->ranges.erase(i);
            }
            pair.difference.beyond_allowed = difference(result.a(pair).image, counterpart, *changed).beyond_allowed;
        }
        const AllowedDifference& of_pair = changed ? *changed : allowed;
        pair.judged = planned.phong ? judged_per_pixel : judged_per_vertex;
        pair.judged.undefined = pair.difference.undefined;
        if (planned.judged) pair.verdict = judge(result, pair);
        if (pair.verdict == Verdict::kBeyond && result.a(pair).path == Path::kFixed) {
            const PixelMask beyond = pixels_beyond_allowed(result.a(pair).image, counterpart, of_pair);
            differing_from_fixed.resize(beyond.size());
            for (std::size_t i = 0; i < beyond.size(); ++i)
                differing_from_fixed[i] = differing_from_fixed[i] || beyond[i];
            if (pair.b == kReference) of_fixed = of_pair;
        }
        // A large difference in an edge pixel must not make the differences away from edges invisible.
        pair.factor = amplification_for(pair.difference.interior.max);
        result.pairs.push_back(pair);
    }
    if (all) result.queries = queries_of(scene, renderers.answers);
    const Driver driver = parse_driver_name(options.driver);
    result.is_listed_driver = is_listed(driver);
    if (std::ranges::any_of(result.pairs, [](const Pair& pair) { return pair.judged.undefined > 0; }))
        if (const auto undefined = reference::first_undefined_color(frame)) result.undefined = words_of(*undefined);
    if (result.verdict() == Verdict::kWithin) return result;
    const std::vector<const Departure*> known = known_departures_in(scene, driver);
    const Causes causes = of_fixed && all
                              ? causes_of(result, scene, known, *of_fixed, differing_from_fixed, options, renderers)
                              : Causes{};
    for (const Departure* cause : causes.proved) result.proved_causes.push_back(named(*cause));
    const std::vector<const Draw*> draws = result.verdict() == Verdict::kBeyond
                                               ? draws_that_differ(frame, differing_from_fixed)
                                               : draws_of_all_pictures(frame);
    for (const Departure* departure : known) {
        if (causes.is_innocent(*departure)) continue;
        const bool is_seen =
            departure->cause != Cause::kFixedFunction || departure->command_rule != nullptr ||
            std::ranges::any_of(draws, [&](const Draw* draw) { return may_show_in(*departure, *draw); });
        if (is_seen && may_cause_difference(result, *departure)) result.known_departures.push_back(named(*departure));
    }
    return result;
}

}  // namespace twinlight::compare
