#include "check/check.h"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "command/text.h"
#include "fixed/fixed.h"
#include "fuzz/vertex_colors.h"
#include "programmable/precise.h"
#include "reference/reference.h"
#include "state/state.h"

namespace twinlight::check {

namespace {

using fuzz::Color;

// ---- What is asked ----

struct Variant {
    std::string name;
    RenderOptions options;
};

RenderOptions with(const std::function<void(RenderOptions&)>& change) {
    RenderOptions options = fuzz::gls_own_model();
    change(options);
    return options;
}

// The shaders' tiers and shadings, as far as the current context has them. At a vertex all shadings give the same.
std::vector<Variant> shader_variants() {
    std::vector<Variant> variants = {
        {"uniform", with([](RenderOptions&) {})},
        {"baked", with([](RenderOptions& o) { o.tier = Tier::kBaked; })},
        {"precise", with([](RenderOptions& o) { o.precise = true; })},
        {"flat", with([](RenderOptions& o) { o.shading = Shading::kFlat; })},
        {"phong", with([](RenderOptions& o) { o.shading = Shading::kPhong; })},
        {"baked phong", with([](RenderOptions& o) {
             o.tier = Tier::kBaked;
             o.shading = Shading::kPhong;
         })},
    };
    if (!programmable::has_precise()) std::erase_if(variants, [](const Variant& v) { return v.options.precise; });
    return variants;
}

const std::vector<Variant>& reference_variants() {
    static const std::vector<Variant> variants = {
        {"double", with([](RenderOptions&) {})},
        {"float", with([](RenderOptions& o) { o.arithmetic.number = Number::kFloat; })},
        {"long double", with([](RenderOptions& o) { o.arithmetic.number = Number::kLongDouble; })},
    };
    return variants;
}

// ---- Judging ----

bool is_finite(const glm::dvec4& color) {
    return std::isfinite(color.r) && std::isfinite(color.g) && std::isfinite(color.b) && std::isfinite(color.a);
}

bool agree(const Color& value, const glm::dvec4& expected, double tolerance) {
    if (!value) return false;
    for (int i = 0; i < 4; ++i) {
        if (std::isnan(expected[i]) && std::isnan((*value)[i])) continue;
        if (!(std::abs((*value)[i] - expected[i]) <= tolerance * std::max(1.0, std::abs(expected[i])))) return false;
    }
    return true;
}

void worsen(Verdict& verdict, Verdict by) { verdict = std::max(verdict, by); }

// Of what is calculated, or kept, in floats.
double float_tolerance(const Case& of) { return of.tolerance.value_or(kTolerance); }

void judge_fixed(const Case& of, const std::string& driver, const Expectation& expected, const Color& value,
                 Result& result) {
    const auto listed = std::ranges::find_if(of.differs, [&](const Differs& differs) {
        return differs.spot == expected.spot && ::fnmatch(("*" + differs.driver + "*").c_str(), driver.c_str(), 0) == 0;
    });
    const double tolerance = float_tolerance(of);
    const bool agrees = agree(value, expected.primary, tolerance);
    Verdict verdict = Verdict::kPass;
    std::string name;
    if (listed != of.differs.end()) {
        name = listed->name;
        verdict = agrees                                    ? Verdict::kVanished
                  : agree(value, listed->color, kTolerance) ? Verdict::kDeparts
                                                            : Verdict::kNew;
    } else if (!agrees) {
        verdict = of.is_ruling ? Verdict::kRuling : Verdict::kNew;
    }
    worsen(result.verdicts[static_cast<std::size_t>(Path::kFixed)], verdict);
    if (verdict != Verdict::kPass)
        result.findings.push_back({Path::kFixed, "", verdict, expected.spot, value, expected.primary, name});
}

void judge_own(Path path, std::string_view variant, const Spot& spot, const glm::dvec4& expected, const Color& value,
               double tolerance, Result& result) {
    if (value && !is_finite(*value)) ++result.non_finite;
    if (agree(value, expected, tolerance)) return;
    worsen(result.verdicts[static_cast<std::size_t>(path)], Verdict::kNew);
    result.findings.push_back({path, std::string(variant), Verdict::kNew, spot, value, expected, ""});
}

double reference_tolerance(const Case& of, const RenderOptions& options) {
    const double floats = float_tolerance(of);
    return options.arithmetic.number == Number::kFloat ? floats : std::min(floats, kWrittenTolerance);
}

bool is_of_vertices(const Case& of) { return of.expectations.front().spot.is_vertex; }

void judge_reference(const Case& of, const fuzz::VertexScene& scene, Result& result) {
    const bool back = scene.shows_back();
    for (const Variant& variant : reference_variants()) {
        const std::vector<reference::LitVertex> lit = reference::light_vertices(scene.draw(), variant.options, false);
        const double tolerance = reference_tolerance(of, variant.options);
        for (const Expectation& expected : of.expectations) {
            const reference::LitVertex& vertex = lit.at(static_cast<std::size_t>(expected.spot.vertex));
            judge_own(Path::kReference, variant.name, expected.spot, expected.primary,
                      back ? vertex.back_primary : vertex.front_primary, tolerance, result);
            const glm::dvec4 secondary = back ? vertex.back_secondary : vertex.front_secondary;
            judge_own(Path::kReference, variant.name + " secondary", expected.spot, glm::dvec4(expected.secondary, 1),
                      glm::dvec4(glm::dvec3(secondary), 1), tolerance, result);
        }
    }
}

long non_finite_pixels(const Image& image) {
    return std::ranges::count_if(image.pixels, [](const Rgba& pixel) {
        return !std::ranges::all_of(pixel, [](auto channel) { return std::isfinite(channel); });
    });
}

glm::dvec4 color_at(const Image& image, const Spot& spot) {
    const Rgba& pixel = image.at(spot.x, spot.y);
    return {pixel[0], pixel[1], pixel[2], pixel[3]};
}

// What a picture shows where the case expects something of this shading.
void judge_picture(const Case& of, Path path, const Variant& variant, const Image& image, Result& result) {
    result.non_finite += non_finite_pixels(image);
    for (const Expectation& expected : of.expectations) {
        if (expected.spot.shading != variant.options.shading) continue;
        judge_own(path, variant.name, expected.spot, expected.primary, color_at(image, expected.spot),
                  float_tolerance(of), result);
    }
}

// The variants that draw some of the case's expectations: those of its shadings, and all numbers and tiers of each.
std::vector<Variant> variants_of(const Case& of, Path path) {
    std::vector<Variant> result;
    std::vector<std::optional<Shading>> shadings;
    for (const Expectation& expected : of.expectations) {
        if (std::ranges::find(shadings, expected.spot.shading) == shadings.end())
            shadings.push_back(expected.spot.shading);
    }
    for (const std::optional<Shading>& shading : shadings) {
        for (Variant variant : path == Path::kReference ? reference_variants() : shader_variants()) {
            if (variant.options.shading || (variant.options.precise && shading)) continue;
            variant.options.shading = shading;
            if (shading) variant.name += *shading == Shading::kPhong ? " phong" : " exact";
            result.push_back(variant);
        }
    }
    return result;
}

}  // namespace

std::string_view word_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::kPass: return "pass";
        case Verdict::kRuling: return "ruling";
        case Verdict::kDeparts: return "departs";
        case Verdict::kNew: return "NEW";
        case Verdict::kVanished: return "VANISHED";
    }
    return "";
}

std::string color_text(const std::optional<glm::dvec4>& color) {
    if (!color) return "nothing";
    glm::dvec4 c = *color;
    for (int i = 0; i < 4; ++i)
        if (std::isnan(c[i])) c[i] = std::abs(c[i]);  // whatever its sign bit
    return fmt::format("({:.7g}, {:.7g}, {:.7g}, {:.7g})", c.r, c.g, c.b, c.a);
}

bool Result::fails() const { return !error.empty() || non_finite > 0 || std::ranges::any_of(verdicts, is_failure); }

Suite::Suite()
    : context_(make_offscreen_context(fuzz::kShaderPicture, fuzz::kShaderPicture, ColorBuffer::kFloat)),
      driver_(driver_name()) {
    renderer_.emplace();
}

Suite::~Suite() {
    context_->make_current();
    renderer_.reset();
}

std::vector<Result> Suite::run(std::span<const Case> cases) {
    context_->make_current();
    std::vector<Result> results(cases.size());
    run_vertices(cases, results);
    run_pictures(cases, results);
    return results;
}

void Suite::run_vertices(std::span<const Case> cases, std::vector<Result>& results) {
    std::vector<std::optional<fuzz::VertexScene>> scenes(cases.size());
    for (std::size_t i = 0; i < cases.size(); ++i) {
        if (!is_of_vertices(cases[i])) continue;
        scenes[i] = fuzz::make_vertex_scene(cases[i].scene, results[i].error);
        if (!scenes[i]) continue;
        for (const Expectation& expected : cases[i].expectations) {
            if (static_cast<std::size_t>(expected.spot.vertex) >= scenes[i]->lit.size())
                results[i].error = "the last primitive has no " + expected.spot.str();
        }
        if (!results[i].error.empty()) {
            scenes[i].reset();
            continue;
        }
        const std::vector<Color> fixed = fuzz::fixed_colors(*scenes[i]);
        for (const Expectation& expected : cases[i].expectations)
            judge_fixed(cases[i], driver_, expected, fixed.at(static_cast<std::size_t>(expected.spot.vertex)),
                        results[i]);
        judge_reference(cases[i], *scenes[i], results[i]);
    }
    for (const Variant& variant : shader_variants()) {
        const auto colors = fuzz::shader_colors(scenes, *renderer_, variant.options);
        for (std::size_t i = 0; i < cases.size(); ++i) {
            if (!scenes[i] || (scenes[i]->shows_back() && !fuzz::knows_faces_of_corners())) continue;
            for (const Expectation& expected : cases[i].expectations)
                judge_own(Path::kProgrammable, variant.name, expected.spot,
                          fuzz::color_sum(expected.primary, glm::dvec4(expected.secondary, 0)),
                          colors[i].at(static_cast<std::size_t>(expected.spot.vertex)), float_tolerance(cases[i]),
                          results[i]);
        }
    }
}

void Suite::run_pictures(std::span<const Case> cases, std::vector<Result>& results) {
    for (std::size_t i = 0; i < cases.size(); ++i) {
        if (is_of_vertices(cases[i])) continue;
        try {
            const Frame frame = make_frame(cases[i].scene, {.width = kSide, .height = kSide});
            const Image fixed = fixed::render(frame, {});
            results[i].pictures.emplace_back("fixed", fixed);
            for (const Expectation& expected : cases[i].expectations) {
                if (!expected.spot.shading)
                    judge_fixed(cases[i], driver_, expected, color_at(fixed, expected.spot), results[i]);
            }
            const auto judge = [&](Path path, const Variant& variant, Image image) {
                judge_picture(cases[i], path, variant, image, results[i]);
                const std::string_view of = kPathNames.at(static_cast<std::size_t>(path));
                results[i].pictures.emplace_back(fmt::format("{} {}", of, variant.name), std::move(image));
            };
            for (const Variant& variant : variants_of(cases[i], Path::kProgrammable))
                judge(Path::kProgrammable, variant, renderer_->render(frame, variant.options));
            for (const Variant& variant : variants_of(cases[i], Path::kReference))
                judge(Path::kReference, variant, reference::render(frame, variant.options));
        } catch (const SceneError& refused) {
            results[i].error = refused.what();
        }
    }
}

}  // namespace twinlight::check
