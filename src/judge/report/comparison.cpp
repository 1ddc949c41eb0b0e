// Which pictures are drawn, which are held against each other, and what they are held to.
#include "judge/report/comparison.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <utility>

namespace twinlight::report {

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

// 2.1.1: a colour need not be computed to more than 1 part in 10^5. Where the right value lies that near to the border of
// two codes, such as a background of 0.3 (76.5 codes), either code is right.
constexpr double kArithmetic = 1e-5;

// In codes, from a channel to where its code changes.
double from_border(float channel) {
    const double codes = 255 * std::clamp(static_cast<double>(channel), 0.0, 1.0);
    return std::abs(codes - std::floor(codes) - 0.5);
}

void allow_ties(AllowedDifference& allowed, const Image& reference) {
    for (std::size_t i = 0; i < reference.pixels.size(); ++i) {
        for (std::size_t c = 0; c < reference.pixels[i].size(); ++c) {
            if (from_border(reference.pixels[i][c]) <= 255 * kArithmetic)
                allowed.channels.pixels[i][c] += static_cast<float>(kArithmetic);
        }
    }
}

// Of two pictures of drivers each may use the allowed difference to its side, and cut quadrilaterals its own way: a driver
// may cut those of a display list otherwise than the same ones outside of it.
AllowedDifference allowed_of_drivers(AllowedDifference allowed, const Render& reference) {
    for (std::size_t i = 0; i < allowed.channels.pixels.size(); ++i) {
        for (std::size_t c = 0; c < allowed.channels.pixels[i].size(); ++c) {
            float& channel = allowed.channels.pixels[i][c];
            channel *= 2;
            if (!reference.other_cut) continue;
            channel += std::abs(reference.image.pixels[i][c] - reference.other_cut->pixels[i][c]);
        }
    }
    return allowed;
}

// What planning may leave out of either picture (RenderOptions::budget), as the plans bound it: where the right value lies
// that near to the border of two codes, it may cross it. Where a difference is allowed already, it grows by that. Alpha is
// no light's.
AllowedDifference with_plans(AllowedDifference allowed, const Render& a, const Render& b, const Render& reference) {
    const double error = error_bound(a.plan) + error_bound(b.plan);
    if (error == 0) return allowed;
    const auto may_cross = [&](const Image& image, std::size_t i, std::size_t c) {
        return from_border(image.pixels[i][c]) <= 255 * (error + kArithmetic);
    };
    for (std::size_t i = 0; i < allowed.channels.pixels.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            float& channel = allowed.channels.pixels[i][c];
            const bool more = channel > 0 || may_cross(reference.image, i, c) ||
                              (reference.other_cut && may_cross(*reference.other_cut, i, c));
            if (more) channel += static_cast<float>(error);
        }
    }
    return allowed;
}

Render render(const PlannedRender& planned, const Frame& frame, const Renderers& renderers, Pictures pictures) {
    using Clock = std::chrono::steady_clock;
    const RenderFunction& draw = renderers.*planned.renderer;
    if (planned.by_driver && pictures == Pictures::kAll) draw(frame, planned.options);
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
    return b(pair).other_cut ? nearer_of(a(pair).image, b(pair).image, *b(pair).other_cut, allowed.channels)
                             : b(pair).image;
}

Verdict Comparison::verdict() const {
    const auto any = [&](Verdict verdict) {
        return std::ranges::any_of(pairs, [verdict](const Pair& pair) { return pair.verdict == verdict; });
    };
    if (any(Verdict::kBeyond)) return Verdict::kBeyond;
    return any(Verdict::kPartial) ? Verdict::kPartial : Verdict::kWithin;
}

bool Comparison::within_tolerance() const { return verdict() != Verdict::kBeyond; }

Verdict judge(const ImageDifference& difference, const Tolerance& tolerance) {
    const RegionDifference& judged = difference.beyond_allowed;
    const bool within =
        judged.max <= tolerance.max && (judged.differing == 0 || judged.differing_share() < tolerance.differing_share);
    return within ? Verdict::kWithin : Verdict::kBeyond;
}

namespace {

// Whether a render leaves this out. Its name is its renderer's, "-phong" or "-exact" may follow.
bool lacks(const Render& render, const Unsupported& item) {
    return std::ranges::any_of(item.renderers, [&](const std::string& name) { return render.name.starts_with(name); });
}

Verdict verdict_of(const Comparison& comparison, const Pair& pair) {
    const Verdict verdict = judge(pair.difference, comparison.tolerance);
    const Render &a = comparison.a(pair), &b = comparison.b(pair);
    bool partial = false;
    for (const Unsupported& item : comparison.unsupported) {
        if (lacks(a, item) != lacks(b, item)) return Verdict::kPartial;  // a difference may come of it
        partial = partial || lacks(a, item);
    }
    return partial && verdict == Verdict::kWithin ? Verdict::kPartial : verdict;
}

}  // namespace

Comparison compare_scene(const Frame& frame, const std::string& scene, const std::string& driver,
                         const Renderers& renderers, const Progress& progress, Pictures pictures, double budget,
                         bool precise, Shading per_pixel) {
    constexpr int kSteps = static_cast<int>(kRenders.size()) + 2;
    int done = 0;
    const auto begin_step = [&](std::string_view name) {
        if (progress) progress(done++, kSteps, name);
    };

    Comparison result;
    result.scene = scene;
    result.driver = driver;
    result.width = frame.width;
    result.height = frame.height;
    result.unsupported = frame.unsupported;
    const auto is_left_out = [pictures](bool phong) { return phong && pictures == Pictures::kPerVertex; };
    for (PlannedRender planned : kRenders) {
        planned.options.budget = budget;
        if (precise && planned.renderer == &Renderers::programmable && planned.options.shading != Shading::kPhong) {
            planned.options.precise = true;
            planned.meaning =
                "Shaders light vertices by GL's model, in the order of operations of Mesa's fixed function.";
        }
        if (is_left_out(planned.options.shading == Shading::kPhong)) continue;
        if (planned.options.shading == Shading::kPhong && per_pixel == Shading::kExact) planned = exact(planned);
        begin_step(planned.name);
        result.renders.push_back(render(planned, frame, renderers, pictures));
    }
    begin_step("edges");
    result.allowed = renderers.allowed_difference(frame, kPerVertex);
    RenderOptions of_pixels = kPerPixel;
    of_pixels.shading = per_pixel;
    AllowedDifference of_phong =
        pictures == Pictures::kAll ? renderers.allowed_difference(frame, of_pixels) : result.allowed;
    for (std::size_t i = 0; i < result.allowed.edge.size(); ++i) {  // one mask for all pairs
        result.allowed.edge[i] = of_phong.edge[i] = result.allowed.edge[i] || of_phong.edge[i];
    }

    allow_ties(result.allowed, result.renders[kReference].image);
    if (pictures == Pictures::kAll) allow_ties(of_phong, result.renders[kReferencePhong].image);

    begin_step("differences");
    const AllowedDifference of_drivers = allowed_of_drivers(result.allowed, result.renders[kReference]);
    for (const PlannedPair& planned : kPairs) {
        if (is_left_out(kRenders[planned.b].options.shading == Shading::kPhong)) continue;
        Pair pair;
        pair.a = planned.a;
        pair.b = planned.b;
        const AllowedDifference& allowed = is_of_drivers(planned) ? of_drivers
                                           : planned.phong        ? of_phong
                                                                  : result.allowed;
        pair.difference = difference(result.a(pair).image, result.counterpart(pair),
                                     with_plans(allowed, result.a(pair), result.b(pair),
                                                result.renders[planned.phong ? kReferencePhong : kReference]));
        if (planned.judged) pair.verdict = verdict_of(result, pair);
        // The interior is what is judged; an edge pixel that is wholly different must not darken it.
        pair.factor = amplification_for(pair.difference.interior.max);
        result.pairs.push_back(pair);
    }
    return result;
}

std::string picture_file(const Render& render) { return render.name + ".png"; }

std::string difference_file(const Comparison& comparison, const Pair& pair) {
    return "difference-" + comparison.a(pair).name + "-" + comparison.b(pair).name + ".png";
}

}  // namespace twinlight::report
