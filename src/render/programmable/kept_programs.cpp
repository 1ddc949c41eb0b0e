#include "render/programmable/kept_programs.h"

#include <algorithm>
#include <utility>

#include "render/programmable/text/bake.h"

namespace twinlight::programmable {
namespace {

// A program is baked after this many frames in which no further number has changed. Compiling costs as much time as it
// saves in some frames of a large mesh, so numbers that change now and then should not be baked in between.
constexpr int kStillFrames = 4;
// A number that has changed is baked again after this many frames without a change.
constexpr int kForgetFrames = 60;
// More Draws of a Kind share a program: each program is compiled, and to change from one to the next takes time.
constexpr std::size_t kMostOwnPrograms = 4;

}  // namespace

KeptPrograms::Kind& KeptPrograms::kind_of(const EffectSet& effects, const Form& form) {
    // Frames have mostly the same Draws in the same order.
    const std::size_t number = draw_count_++;
    if (number == order_.size()) order_.push_back(nullptr);
    Kind*& kind = order_[number];
    if (!kind || kind->effects != effects || kind->form != form) {
        kind = &kinds_[{effects, form}];
        kind->effects = effects;
        kind->form = form;
    }
    return *kind;
}

KeptPrograms::Entry& KeptPrograms::find_or_make(const Kind& kind, const Uniforms& constants) {
    const auto [found, is_new] = entries_.try_emplace({kind.effects, kind.form, constants});
    if (is_new) {
        const ShaderSource source = with_constants(assemble(kind.effects, kind.form), constants);
        try {
            found->second.program = std::make_unique<ShaderProgram>(source, kind.effects);
        } catch (...) {
            entries_.erase(found);
            throw;
        }
        ++(constants.empty() ? counters_.made : counters_.baked);
    }
    found->second.last_used = ++uses_;
    if (is_new) evict();  // never this one: it was used last
    return found->second;
}

KeptPrograms::Entry& KeptPrograms::with_uniforms(Kind& kind) {
    if (!kind.with_uniforms) kind.with_uniforms = &find_or_make(kind, {});
    kind.with_uniforms->last_used = ++uses_;
    return *kind.with_uniforms;
}

void KeptPrograms::evict() {
    while (entries_.size() > limit_ && entries_.size() > 1) {
        entries_.erase(std::ranges::min_element(
            entries_, {}, [](const auto& key_and_entry) { return key_and_entry.second.last_used; }));
        ++counters_.evicted;
        for (auto& [key, kind] : kinds_) {
            kind.with_uniforms = nullptr;
            for (History& history : kind.histories) history.entry = nullptr;
        }
    }
}

std::vector<bool> KeptPrograms::which_are_used(Kind& kind, const Uniforms& numbers) {
    if (!kind.names) kind.names = uniform_names(assemble(kind.effects, kind.form));
    std::vector<bool> used(numbers.size());
    for (std::size_t i = 0; i < used.size(); ++i) used[i] = kind.names->contains(numbers[i].name);
    return used;
}

KeptPrograms::History& KeptPrograms::next_history(Kind& kind, const Uniforms& numbers) {
    const std::size_t number = kind.has_one_history ? 0 : kind.count;
    if (number == kind.histories.size()) kind.histories.emplace_back();
    History& history = kind.histories[number];
    if (number == kind.count++) ++history.frame;
    if (history.used.empty() || !history.numbers.has_same_names(numbers)) {
        history = {.numbers = numbers,
                   .used = which_are_used(kind, numbers),
                   .moved = std::vector<int>(numbers.size()),
                   .frame = 1,
                   .constants = {}};
    }
    bool has_changed = false;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (!history.used[i] || are_same(history.numbers[i].values, numbers[i].values)) continue;
        has_changed = true;
        if (std::exchange(history.moved[i], history.frame) != 0) continue;
        history.settled_at = history.frame;
        history.constants = {};
        history.entry = nullptr;
        history.is_current = false;
    }
    if (has_changed) history.numbers = numbers;
    choose_constants(kind, history);
    return history;
}

// Which numbers are constants, judging by the same Draw of earlier frames.
void KeptPrograms::choose_constants(const Kind& kind, History& history) {
    if (history.frame >= history.next_forgotten) {
        int oldest = history.frame;
        for (int& frame : history.moved) {
            if (frame == 0) continue;
            if (history.frame - frame > kForgetFrames) {
                frame = 0;
                history.is_current = false;
            } else {
                oldest = std::min(oldest, frame);
            }
        }
        history.next_forgotten = oldest + kForgetFrames + 1;
    }
    if (history.is_current || history.frame - history.settled_at < kStillFrames) return;

    Uniforms still = history.numbers.filtered([&](std::size_t i) { return history.used[i] && history.moved[i] == 0; });
    // At most one program is baked per frame, because compiling delays the frame.
    const bool is_there = still.empty() || entries_.contains(Key{kind.effects, kind.form, still});
    if (!is_there && (!may_bake_ || std::exchange(has_baked_, true))) {
        wants_to_bake_ = true;
        return;
    }
    history.is_current = true;
    history.constants = std::move(still);
    history.entry = nullptr;
}

void KeptPrograms::use(const EffectSet& effects, const Form& form, const Uniforms& numbers, Tier tier) {
    Kind& kind = kind_of(effects, form);
    const std::uint64_t made_before = counters_.made + counters_.baked;
    Entry* entry = nullptr;
    switch (tier) {
        case Tier::kUniform: entry = &with_uniforms(kind); break;
        case Tier::kBaked: {
            const std::vector<bool> used = which_are_used(kind, numbers);
            entry = &find_or_make(kind, numbers.filtered([&](std::size_t i) { return used[i]; }));
            break;
        }
        case Tier::kAuto: {
            History& history = next_history(kind, numbers);
            if (history.entry)
                history.entry->last_used = ++uses_;
            else
                history.entry = &find_or_make(kind, history.constants);
            entry = history.entry;
            // While the driver compiles it on its own threads, the program with uniforms draws.
            if (!history.constants.empty() && !entry->program->is_ready()) entry = &with_uniforms(kind);
            break;
        }
    }
    if (counters_.made + counters_.baked == made_before) ++counters_.hits;
    entry->program->use(numbers);
}

// A Draw that this frame did not have is forgotten.
void KeptPrograms::end_frame() {
    for (auto& [key, kind] : kinds_) {
        const bool has_many = kind.count > kMostOwnPrograms;
        if (std::exchange(kind.has_one_history, has_many) != has_many) kind.histories.clear();
        kind.histories.resize(std::min(kind.histories.size(), kind.count));
        kind.count = 0;
    }
    order_.resize(draw_count_);
    draw_count_ = 0;
    has_baked_ = false;
}

}  // namespace twinlight::programmable
