#include "app/demo/pair_verdict.h"

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <exception>
#include <future>

#include "base/text/translation.h"
#include "judge/compare/allowances.h"
#include "judge/report/words.h"
#include "scene/frame/lecture_variants.h"

namespace twinlight::demo {
namespace {

using session::Session;

std::array<const session::Pane*, 2> panes_of(const Session& session) {
    return {&session.panes[session.difference.a], &session.panes[session.difference.b]};
}

compare::Render shown_by(const Session& session, const session::Pane& pane, const Look& look) {
    compare::Render render{.path = pane.renderer, .name = {}, .meaning = {}, .image = {}};
    render.name = std::string(name_of(pane.renderer));
    if (pane.renderer == Path::kProgrammable) render.plan = explain_draws(session.scene.frame, {look});
    return render;
}

// It needs contexts of its own.
const std::shared_future<DrawingPrecision>& measured_precision() {
    static const std::shared_future<DrawingPrecision> measured =
        std::async(std::launch::async, [] {
            try {
                return measure_drawing_precision();
            } catch (const std::exception&) {
                return DrawingPrecision{};  // it cannot draw beside the window
            }
        }).share();
    return measured;
}

}  // namespace

const DrawingPrecision* drivers_precision() {
    const auto& measured = measured_precision();
    return measured.wait_for(std::chrono::seconds(0)) == std::future_status::ready ? &measured.get() : nullptr;
}

void wait_for_drivers_precision() { measured_precision().wait(); }

std::optional<Look> common_look(const Session& session) {
    const bool is_flat = session::is_flat(session.scene.frame), has_any = has_variants(session.scene.frame);
    const auto shown = [&](const session::Pane& pane) {
        Look look = look_of(session, pane);
        if (pane.renderer == Path::kFixed || !has_any) look.lecture_variants = false;
        // GL_SMOOTH is Gouraud shading.
        if (look.shading == (is_flat ? Shading::kFlat : Shading::kGouraud)) look.shading.reset();
        return look;
    };
    const auto [a, b] = panes_of(session);
    return shown(*a) == shown(*b) ? std::optional(shown(*a)) : std::nullopt;
}

AllowedDifference allowed_of_pair(const Session& session, const Look& look, AllowedDifference allowed,
                                  const compare::Render& right) {
    const Image* const other_cut = right.other_cut ? &*right.other_cut : nullptr;
    compare::allow_reference(allowed, right.image, other_cut);
    compare::allow_drawing(allowed, right.image, other_cut, *drivers_precision());
    const auto [a, b] = panes_of(session);
    if (a->renderer != Path::kReference && b->renderer != Path::kReference)
        allowed = compare::allowed_of_drivers(std::move(allowed), right);
    const auto with_plans =
        compare::with_plans(allowed, shown_by(session, *a, look), shown_by(session, *b, look), right);
    return with_plans ? *with_plans : allowed;
}

PairVerdict verdict_on_pair(const Session& session, const ImageDifference& numbers, const AllowedDifference& allowed) {
    compare::Comparison comparison;
    comparison.unsupported = session.scene.frame.unsupported;
    comparison.is_listed_driver = true;  // no sentence about lists
    for (const session::Pane* pane : panes_of(session))
        comparison.renders.push_back(
            {.path = pane->renderer, .name = std::string(name_of(pane->renderer)), .meaning = {}, .image = {}});
    compare::Pair pair{.a = 0, .b = 1, .difference = numbers, .judged = compare::judged(allowed)};
    pair.judged.undefined = numbers.undefined;
    pair.verdict = judge(comparison, pair);
    comparison.pairs = {pair};
    PairVerdict result{pair.verdict, {}, report::answer(comparison).sentences()};
    const auto add = [&result](std::string text) { result.texts.push_back(std::move(text)); };
    add(result.sentences.front());
    const double most = numbers.interior.max;
    switch (pair.verdict) {
        case compare::Verdict::kWithin:
            if (most > 0)
                add(tr("Both agree: at most {}{}", report::in_255ths(most),
                       most > comparison.tolerance.max * (1 + 1e-9) ? tr(", which OpenGL leaves open") : ""));
            add(tr("Both agree"));
            break;
        case compare::Verdict::kUnjudged: add(tr("No difference found")); break;
        case compare::Verdict::kPartial: add(tr("Partial")); break;
        case compare::Verdict::kBeyond:
            add(tr("They differ by up to {}", report::in_255ths(numbers.beyond_allowed.max)));
            break;
        case compare::Verdict::kInformative: break;
    }
    return result;
}

PairVerdict meant_to_differ(const ImageDifference& numbers) {
    const RegionDifference& region = numbers.interior;
    const std::string where = region.differing == 0 ? tr(" No pixel does here.")
                                                    : tr(" {} of the pixels do, by up to {}.", report::share_of(region),
                                                         report::in_255ths(region.max));
    return {compare::Verdict::kInformative,
            {tr("Meant to differ.") + where, tr("Meant to differ")},
            {tr("Meant to differ: the two pictures are lit differently, so there is no verdict.") + where}};
}

}  // namespace twinlight::demo
