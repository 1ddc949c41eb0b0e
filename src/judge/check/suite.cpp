#include "judge/check/suite.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <iterator>
#include <limits>
#include <new>
#include <stdexcept>

#include "judge/check/variants.h"
#include "judge/compare/departures.h"
#include "judge/compare/vertex_colors.h"
#include "judge/oracle/oracle.h"
#include "render/context/driver_name.h"
#include "render/context/gl.h"
#include "render/fixed/fixed.h"
#include "render/reference/reference.h"
#include "render/reference/vertices/lit_vertices.h"
#include "scene/command/text.h"
#include "scene/frame/lecture_variants.h"
#include "scene/state/state.h"

namespace twinlight::check {

namespace {

using compare::Color;

// ---- Which variants run ----

// --precise follows only GL's own model.
bool runs(const ShaderVariant& variant, const Frame& frame) {
    return !(variant.options.precise && has_variants(frame));
}

Enum driver_error() {
    const Enum first = glGetError();
    while (glGetError() != GL_NO_ERROR) {
    }
    return first;
}

// ---- Comparing results with what is expected ----

bool is_finite(const glm::dvec4& color) {
    return std::isfinite(color.r) && std::isfinite(color.g) && std::isfinite(color.b) && std::isfinite(color.a);
}

// The right answer and its tolerance.
struct Right {
    Seen value, other;  // both are right
    double tolerance = 0;
};

bool agree(const std::optional<Seen>& value, const Right& right) {
    if (!value || value->index() != right.value.index()) return false;
    if (const Enum* error = std::get_if<Enum>(&*value)) return *error == std::get<Enum>(right.value);
    const auto near = [&](double a, double b) {
        if (a == b || (std::isnan(a) && std::isnan(b))) return true;  // infinite ones too
        return std::abs(a - b) <= right.tolerance * std::max(1.0, std::abs(b));
    };
    const auto &a = std::get<glm::dvec4>(*value), &b = std::get<glm::dvec4>(right.value),
               &other = std::get<glm::dvec4>(right.other);
    for (int i = 0; i < 4; ++i)
        if (!near(a[i], b[i]) && !near(a[i], other[i])) return false;
    return true;
}

std::optional<Seen> seen(const Color& color) { return color ? std::optional<Seen>(*color) : std::nullopt; }

void worsen(Outcome& outcome, Outcome by) { outcome = std::max(outcome, by); }

double float_tolerance(const Case& hard_case) { return hard_case.tolerance.value_or(kTolerance); }

// For results that are computed or stored in floats.
Right of_floats(const Case& hard_case, const Expectation& expected) {
    return {expected.value, expected.other, float_tolerance(hard_case)};
}

// For results of the reference. Long double has only one right answer.
Right of_reference(const Case& hard_case, const Expectation& expected, Number number) {
    const double floats = float_tolerance(hard_case);
    return {expected.value, number == Number::kLongDouble ? expected.value : expected.other,
            number == Number::kFloat ? floats : std::min(floats, kWrittenTolerance)};
}

// The result of a renderer at a place of a case.
using Shown = std::function<std::optional<Seen>(const Expectation&)>;

// What the case lists for this driver at a place; null if nothing.
const Differs* listed_at(const Case& hard_case, const Spot& spot, const std::string& driver) {
    const auto listed = std::ranges::find_if(
        hard_case.differs, [&](const Differs& differs) { return differs.spot == spot && differs.is_of(driver); });
    return listed == hard_case.differs.end() ? nullptr : &*listed;
}

// The same for shaders: they show only the bugs of what comes after the vertex stage.
const Differs* listed_for_shaders(const Case& hard_case, const Spot& spot, const std::string& driver) {
    const Differs* listed = listed_at(hard_case, spot, driver);
    const auto is_of_shaders = [&](const compare::Departure& departure) {
        return departure.name == listed->name && departure.cause == compare::Cause::kDriver;
    };
    return listed && std::ranges::any_of(compare::departures(), is_of_shaders) ? listed : nullptr;
}

// `error` is the result of glGetError afterwards. Scenes with features that GL lacks are not tested.
void judge_fixed(const Case& hard_case, const Frame& frame, const std::string& driver, Enum error, const Shown& shown,
                 Result& result) {
    if (has_variants(frame)) return;
    if (!hard_case.expects_error() && error != kGL_NO_ERROR) {  // also where the specification is silent
        worsen(result.outcomes[static_cast<std::size_t>(Path::kFixed)], Outcome::kNewBug);
        result.findings.push_back(
            {Path::kFixed, "", Outcome::kNewBug, {.kind = Spot::Kind::kError, .shading = {}}, error, kGL_NO_ERROR, ""});
    }
    for (const Expectation& expected : hard_case.expectations) {
        if (expected.spot.shading) continue;
        const std::optional<Seen> value =
            expected.spot.kind == Spot::Kind::kError ? std::optional<Seen>(error) : shown(expected);
        const Differs* listed = listed_at(hard_case, expected.spot, driver);
        const bool agrees = agree(value, of_floats(hard_case, expected));
        Outcome outcome = Outcome::kPass;
        std::string name, note;
        if (listed && !(agrees && listed->is_at_times(driver))) {
            name = listed->name;
            note = listed->note(driver);
            outcome = agrees                                                                     ? Outcome::kFixedBug
                      : agree(value, {listed->value, listed->value, float_tolerance(hard_case)}) ? Outcome::kKnownBug
                                                                                                 : Outcome::kNewBug;
        } else if (!agrees) {
            outcome = hard_case.is_ruling ? Outcome::kOurChoice : Outcome::kNewBug;
        }
        worsen(result.outcomes[static_cast<std::size_t>(Path::kFixed)], outcome);
        if (outcome != Outcome::kPass)
            result.findings.push_back({Path::kFixed, "", outcome, expected.spot, value, expected.value, name, note});
    }
}

void judge_ours(Path path, std::string_view variant, const Spot& spot, const Right& right,
                const std::optional<Seen>& value, Result& result) {
    const glm::dvec4* color = value ? std::get_if<glm::dvec4>(&*value) : nullptr;
    if (color && !is_finite(*color)) ++result.non_finite;
    Outcome& outcome = result.outcomes[static_cast<std::size_t>(path)];
    if (agree(value, right)) return worsen(outcome, Outcome::kPass);
    worsen(outcome, Outcome::kNewBug);
    result.findings.push_back({path, std::string(variant), Outcome::kNewBug, spot, value, right.value, ""});
}

// The error that Twinlight's own state machine raises; it counts as the reference's.
void judge_error(const Case& hard_case, Enum error, Result& result) {
    for (const Expectation& expected : hard_case.expectations)
        if (expected.spot.kind == Spot::Kind::kError)
            judge_ours(Path::kReference, "", expected.spot, of_floats(hard_case, expected), error, result);
}

// Does not depend on the tolerance of the case. Skips channels with two right answers.
void compare_with_long_double(const Expectation& expected, const Color& value, const glm::dvec4& exact,
                              Result& result) {
    for (int i = 0; i < 4 && value; ++i) {
        if (std::get<glm::dvec4>(expected.value)[i] != std::get<glm::dvec4>(expected.other)[i]) continue;
        const double off = std::abs((*value)[i] - exact[i]);
        result.from_long_double = std::isnan(off) ? HUGE_VAL : std::max(result.from_long_double, off);
    }
}

// Primary plus secondary colour, as fragments show them.
Right as_sum(Right right, const glm::dvec3& secondary) {
    for (Seen* color : {&right.value, &right.other})
        *color = compare::color_sum(std::get<glm::dvec4>(*color), glm::dvec4(secondary, 0));
    return right;
}

// The colours of a Draw's vertices in long double, primary plus secondary.
std::vector<glm::dvec4> sums_in_long_double(const Draw& draw, bool back) {
    std::vector<glm::dvec4> sums;
    for (const reference::LitVertex& vertex : reference::light_vertices(draw, long_double().options, false))
        sums.push_back(compare::face_colors(vertex, back).sum());
    return sums;
}

// The same with a given shading, which may differ from GL's own: phong shading normalises each fragment's normal, flat
// shading shows the provoking vertex of a polygon (2.14.7, table 2.12).
std::vector<glm::dvec4> sums_in_long_double(const compare::VertexScene& scene, std::optional<Shading> shading) {
    Draw draw = scene.draw();
    draw.lighting.normalize |= shading == Shading::kPhong;
    std::vector<glm::dvec4> sums = sums_in_long_double(draw, scene.shows_back());
    if (shading == Shading::kFlat && draws_polygons(draw.mode))
        std::ranges::fill(sums, glm::dvec4(draw.mode == kGL_POLYGON ? sums.front() : sums.back()));
    return sums;
}

void judge_reference(const Case& hard_case, const compare::VertexScene& scene, Result& result) {
    const bool back = scene.shows_back();
    for (const ReferenceVariant& variant : reference_variants()) {
        const std::vector<reference::LitVertex> lit = reference::light_vertices(scene.draw(), variant.options, false);
        for (const Expectation& expected : hard_case.expectations) {
            if (expected.spot.kind != Spot::Kind::kVertex) continue;
            const compare::FaceColors face =
                compare::face_colors(lit.at(static_cast<std::size_t>(expected.spot.vertex)), back);
            const Right right = of_reference(hard_case, expected, variant.options.arithmetic.number);
            const glm::dvec4 right_secondary(expected.secondary, 1);
            judge_ours(Path::kReference, variant.name, expected.spot, right, face.primary, result);
            judge_ours(Path::kReference, variant.name + " secondary", expected.spot,
                       {right_secondary, right_secondary, right.tolerance}, glm::dvec4(glm::dvec3(face.secondary), 1),
                       result);
        }
    }
}

// The expected colours against the oracle's, which evaluates the commands in 60 digits. A case with a command that it does
// not know, such as a display list, or with NaN or infinity, is left to the long doubles.
void judge_expectations(const Case& hard_case, const compare::VertexScene& scene, Result& result) {
    const auto is_finite = [](double x) { return std::isfinite(x); };
    const bool all_finite = std::ranges::all_of(hard_case.scene->commands, [&](const Command& command) {
        return std::ranges::all_of(command.arguments, is_finite);
    });
    if (hard_case.expects_error() || !all_finite) return;
    std::vector<oracle::Vertex> exact, inside;
    try {
        exact = oracle::light(*hard_case.scene);
        // RULING: a cosine at the border of a cone is inside.
        constexpr double kRounding = 4 * std::numeric_limits<double>::epsilon();
        inside = oracle::light(*hard_case.scene, {.border = oracle::Border::kInside, .width = kRounding});
    } catch (const std::invalid_argument&) {
        return;
    }
    for (const Expectation& expected : hard_case.expectations) {
        const auto vertex = static_cast<std::size_t>(expected.spot.vertex);
        if (expected.spot.kind != Spot::Kind::kVertex || vertex >= exact.size()) continue;
        const double tolerance = std::min(float_tolerance(hard_case), kWrittenTolerance);
        const Right primary{expected.value, expected.value, tolerance};
        const Seen second = glm::dvec4(expected.secondary, 1);
        const auto colors = [&](const oracle::Vertex& of) {
            const oracle::Colors& face = scene.shows_back() ? of.back : of.front;
            const auto& p = face.primary;
            const auto& s = face.secondary;
            return std::pair(glm::dvec4(p[0], p[1], p[2], p[3]), glm::dvec4(s[0], s[1], s[2], 1));
        };
        const auto& of = agree(colors(exact[vertex]).first, primary) ? exact[vertex] : inside[vertex];
        judge_ours(Path::kReference, "60 digits", expected.spot, primary, colors(of).first, result);
        judge_ours(Path::kReference, "60 digits secondary", expected.spot, {second, second, tolerance},
                   colors(of).second, result);
    }
}

void judge_shaders(const Case& hard_case, const compare::VertexScene& scene, const ShaderVariant& variant,
                   const std::vector<Color>& colors, Result& result) {
    const std::vector<glm::dvec4> of_gl = sums_in_long_double(scene, {});
    const std::vector<glm::dvec4> exact = sums_in_long_double(scene, variant.options.shading);
    for (const Expectation& expected : hard_case.expectations) {
        if (expected.spot.kind != Spot::Kind::kVertex) continue;
        const auto vertex = static_cast<std::size_t>(expected.spot.vertex);
        compare_with_long_double(expected, colors.at(vertex), exact.at(vertex), result);
        if (glm::length(exact[vertex] - of_gl[vertex]) > kWrittenTolerance)
            continue;  // this shading differs from GL here
        judge_ours(Path::kProgrammable, variant.name, expected.spot,
                   as_sum(of_floats(hard_case, expected), expected.secondary), seen(colors[vertex]), result);
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

struct CasePicture {
    Path path;
    std::string variant;
    std::optional<Shading> shading;
    Number number;  // only for the reference
    Image image;
};

bool is_of(const Spot& spot, const CasePicture& picture) {
    return spot.kind == Spot::Kind::kPixel && spot.shading == picture.shading;
}

// Compares a picture at the places that the case expects with this shading.
void judge_picture(const Case& hard_case, const CasePicture& picture, const std::string& driver, Result& result) {
    result.non_finite += non_finite_pixels(picture.image);
    for (const Expectation& expected : hard_case.expectations) {
        if (!is_of(expected.spot, picture)) continue;
        const Seen shown = color_at(picture.image, expected.spot);
        const Differs* listed =
            picture.path == Path::kProgrammable ? listed_for_shaders(hard_case, expected.spot, driver) : nullptr;
        if (listed && agree(shown, {listed->value, listed->value, float_tolerance(hard_case)})) {
            worsen(result.outcomes[static_cast<std::size_t>(picture.path)], Outcome::kKnownBug);
            result.findings.push_back({picture.path, picture.variant, Outcome::kKnownBug, expected.spot, shown,
                                       expected.value, listed->name, listed->note(driver)});
            continue;
        }
        const Right right = picture.path == Path::kReference ? of_reference(hard_case, expected, picture.number)
                                                             : of_floats(hard_case, expected);
        judge_ours(picture.path, picture.variant, expected.spot, right, shown, result);
    }
}

void compare_with_long_double(const Case& hard_case, const std::vector<CasePicture>& pictures,
                              const std::string& driver, Result& result) {
    for (const CasePicture& exact : pictures) {
        if (exact.path != Path::kReference || exact.number != Number::kLongDouble) continue;
        for (const CasePicture& picture : pictures) {
            if (picture.path != Path::kProgrammable) continue;
            for (const Expectation& e : hard_case.expectations)
                if (is_of(e.spot, exact) && is_of(e.spot, picture) && !listed_for_shaders(hard_case, e.spot, driver))
                    compare_with_long_double(e, color_at(picture.image, e.spot), color_at(exact.image, e.spot), result);
        }
    }
}

// Whether a known bug of the driver may crash it there.
bool may_crash(const Case& hard_case, const Frame& frame, const std::string& driver) {
    return compare::DeparturesOfScene(*hard_case.scene, parse_driver_name(driver), {}).crash_in(frame) != nullptr;
}

// The pictures of a case, for each of its shadings: by all variants of the shaders, unless `renderer` is null, and all numbers of
// the reference.
std::vector<CasePicture> pictures_of(const Case& hard_case, const Frame& frame, programmable::Renderer* renderer) {
    std::vector<std::optional<Shading>> shadings;
    for (const Expectation& expected : hard_case.expectations) {
        if (expected.spot.kind == Spot::Kind::kPixel &&
            std::ranges::find(shadings, expected.spot.shading) == shadings.end())
            shadings.push_back(expected.spot.shading);
    }
    std::vector<CasePicture> shown, exact;
    for (const std::optional<Shading>& shading : shadings) {
        const std::string suffix = shading ? std::string(" ") + name_of(*shading) : "";
        for (ShaderVariant variant : shader_variants()) {
            if (!renderer || variant.options.shading || (variant.options.precise && shading) || !runs(variant, frame))
                continue;
            variant.options.shading = shading;
            shown.push_back(
                {Path::kProgrammable, variant.name + suffix, shading, {}, renderer->render(frame, variant.options)});
        }
        for (ReferenceVariant variant : reference_variants()) {
            variant.options.shading = shading;
            exact.push_back({Path::kReference, variant.name + suffix, shading, variant.options.arithmetic.number,
                             reference::render(frame, variant.options)});
        }
    }
    std::ranges::move(exact, std::back_inserter(shown));
    return shown;
}

}  // namespace

std::string_view word_of(Outcome outcome) {
    switch (outcome) {
        case Outcome::kNotTested: return "not tested";
        case Outcome::kPass: return "pass";
        case Outcome::kOurChoice: return "our choice";
        case Outcome::kKnownBug: return "known bug";
        case Outcome::kNewBug: return "new bug";
        case Outcome::kFixedBug: return "fixed bug";
    }
    return "";
}

std::string finding_text(const Case& hard_case, const Finding& finding) {
    std::string text = fmt::format("{}{}{}, {}: {}, ", name_of(finding.path), finding.variant.empty() ? "" : " ",
                                   finding.variant, finding.spot.str(), text_of(finding.value));
    const std::string expected = text_of(finding.expected);
    const std::string known = finding.note.empty() ? "known bug" : "known bug (" + finding.note + ")";
    switch (finding.outcome) {
        case Outcome::kFixedBug: return text + "as expected; the " + known + " is gone: " + finding.name;
        case Outcome::kOurChoice: return text + "our choice is " + expected;
        case Outcome::kKnownBug: return text + "expected " + expected + " (" + known + ": " + finding.name + ")";
        case Outcome::kNotTested:
        case Outcome::kPass:
        case Outcome::kNewBug: break;
    }
    text += "expected " + expected + " (" + hard_case.text + ")";
    return finding.name.empty() ? text : text + "; the " + known + " gives another value: " + finding.name;
}

bool Result::fails() const {
    return !error.empty() || non_finite > 0 || from_long_double > kTolerance ||
           std::ranges::any_of(outcomes, is_failure);
}

Suite::Suite()
    : context_(compare::kShaderPicture, compare::kShaderPicture, ColorBuffer::kFloat), driver_(driver_name()) {}

std::vector<Result> Suite::run(std::span<const Case> cases) {
    context_.make_current();
    std::vector<Result> results(cases.size());
    run_vertices(cases, results);
    run_pictures(cases, results);
    return results;
}

void Suite::run_vertices(std::span<const Case> cases, std::vector<Result>& results) {
    std::vector<std::optional<compare::VertexScene>> scenes(cases.size());
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const Case& hard_case = cases[i];
        if (!hard_case.is_of_vertices()) continue;
        try {
            CarriedOut given = hard_case.carried_out(compare::kVertexWindow);
            judge_error(hard_case, given.error, results[i]);
            scenes[i] = compare::make_vertex_scene(std::move(given.scene), results[i].error);
        } catch (const std::bad_alloc&) {
            throw;
        } catch (const std::exception& refused) {
            results[i].error = refused.what();
        }
        if (!scenes[i]) continue;
        for (const Expectation& expected : hard_case.expectations) {
            if (static_cast<std::size_t>(expected.spot.vertex) >= scenes[i]->lit.size())
                results[i].error = "the last primitive has no " + expected.spot.str();
        }
        if (!results[i].error.empty()) {
            scenes[i].reset();
            continue;
        }
        driver_error();
        const std::vector<Color> fixed = compare::fixed_colors(*scenes[i]);
        judge_fixed(
            hard_case, scenes[i]->scene.frame, driver_, driver_error(),
            [&](const Expectation& expected) { return seen(fixed.at(static_cast<std::size_t>(expected.spot.vertex))); },
            results[i]);
        judge_reference(hard_case, *scenes[i], results[i]);
        judge_expectations(hard_case, *scenes[i], results[i]);
    }
    for (const ShaderVariant& variant : shader_variants()) {
        const auto colors = shader_colors(scenes, variant, results);
        for (std::size_t i = 0; i < cases.size(); ++i) {
            if (!scenes[i] || (scenes[i]->shows_back() && !compare::knows_faces_of_corners())) continue;
            if (runs(variant, scenes[i]->scene.frame))
                judge_shaders(cases[i], *scenes[i], variant, colors[i], results[i]);
        }
    }
}

// All scenes in one picture; if the shaders cannot draw it, each scene by itself. A scene that fails then is taken out.
std::vector<std::vector<Color>> Suite::shader_colors(std::vector<std::optional<compare::VertexScene>>& scenes,
                                                     const ShaderVariant& variant, std::vector<Result>& results) {
    try {
        return compare::shader_colors(scenes, context_.shaders(), variant.options);
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception&) {
        std::vector<std::vector<Color>> colors(scenes.size());
        for (std::size_t i = 0; i < scenes.size(); ++i) {
            try {
                colors[i] =
                    compare::shader_colors(std::span(&scenes[i], 1), context_.shaders(), variant.options).front();
            } catch (const std::bad_alloc&) {
                throw;
            } catch (const std::exception& refused) {
                results[i].error = refused.what();
                scenes[i].reset();
            }
        }
        return colors;
    }
}

void Suite::run_pictures(std::span<const Case> cases, std::vector<Result>& results) {
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const Case& hard_case = cases[i];
        Result& result = results[i];
        if (hard_case.is_of_vertices()) continue;
        try {
            const auto [scene, error] = hard_case.carried_out(kSide);
            const Frame& frame = scene.frame;
            judge_error(hard_case, error, result);
            const bool draws = !may_crash(hard_case, frame, driver_);
            if (draws) {
                driver_error();
                const Image fixed = fixed::render(scene);
                judge_fixed(
                    hard_case, frame, driver_, driver_error(),
                    [&](const Expectation& expected) { return Seen(color_at(fixed, expected.spot)); }, result);
                result.pictures.emplace_back("fixed", fixed);
            }
            std::vector<CasePicture> pictures = pictures_of(hard_case, frame, draws ? &context_.shaders() : nullptr);
            for (const CasePicture& picture : pictures) judge_picture(hard_case, picture, driver_, result);
            compare_with_long_double(hard_case, pictures, driver_, result);
            for (CasePicture& picture : pictures)
                result.pictures.emplace_back(fmt::format("{} {}", name_of(picture.path), picture.variant),
                                             std::move(picture.image));
        } catch (const std::bad_alloc&) {
            throw;
        } catch (const std::exception& refused) {
            result.error = refused.what();
        }
    }
}

void Suite::draw_vertices(const Case& hard_case, Result& result) {
    if (!hard_case.is_of_vertices() || !result.error.empty()) return;
    context_.make_current();
    const Scene scene = hard_case.carried_out(kVertexSide).scene;
    if (!has_variants(scene.frame)) result.pictures.emplace_back("fixed", fixed::render(scene));
    result.pictures.emplace_back("shaders", context_.shaders().render(scene.frame, plain().options));
    result.pictures.emplace_back("reference", reference::render(scene.frame, {}));
}

}  // namespace twinlight::check
