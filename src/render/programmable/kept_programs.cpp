#include "render/programmable/kept_programs.h"

#include <algorithm>
#include <utility>

#include "render/programmable/bake.h"

namespace twinlight::programmable {
namespace {

// A program is baked after this many frames in which no further number has changed. Compiling costs as much time as it
// saves in some frames of a large mesh, so numbers that change now and then should not be baked in between.
constexpr int kStillFrames = 4;
// A number that has changed is baked again after this many frames without a change.
constexpr int kForgetFrames = 60;

}  // namespace

KeptPrograms::Entry& KeptPrograms::find_or_make(const Key& key) {
    const auto [found, is_new] = entries_.try_emplace(key);
    if (is_new) {
        const ShaderSource source = with_constants(assemble(key.kind.effects, key.kind.form), key.constants);
        try {
            found->second.program = std::make_unique<ShaderProgram>(source, key.kind.effects);
        } catch (...) {
            entries_.erase(found);
            throw;
        }
        ++(key.constants.empty() ? counters_.made : counters_.baked);
    }
    found->second.last_used = ++uses_;
    if (is_new) evict();  // never this one: it was used last
    return found->second;
}

void KeptPrograms::evict() {
    while (entries_.size() > limit_ && entries_.size() > 1) {
        entries_.erase(std::ranges::min_element(
            entries_, {}, [](const auto& key_and_entry) { return key_and_entry.second.last_used; }));
        ++counters_.evicted;
        for (auto& [kind, history] : histories_) history.entry = nullptr;
    }
}

// The numbers that the shader text uses.
Uniforms KeptPrograms::used_uniforms(const Kind& kind, const Uniforms& numbers) {
    const auto [names, is_new] = names_.try_emplace(kind);
    if (is_new) names->second = uniform_names(assemble(kind.effects, kind.form));
    Uniforms result;
    for (const auto& [name, value] : numbers)
        if (names->second.contains(name)) result.emplace(name, value);
    return result;
}

KeptPrograms::History& KeptPrograms::history_of(const Kind& kind, const Uniforms& numbers) {
    History& history = histories_[{kind, counts_[kind]++}];
    history.seen = true;
    if (++history.frame == 1) history.numbers = used_uniforms(kind, numbers);
    // Both are sorted by name, and `numbers` has all names.
    auto given = numbers.begin();
    for (auto& [name, value] : history.numbers) {
        while (given->first != name) ++given;
        if (given->second == value) continue;
        value = given->second;
        const bool is_new = history.moved.insert_or_assign(name, history.frame).second;
        if (!is_new) continue;
        history.settled_at = history.frame;
        history.constants.clear();
        history.entry = nullptr;
        history.is_current = false;
    }
    choose_constants(kind, history);
    return history;
}

// Which numbers are constants, judging by the same Draw of earlier frames.
void KeptPrograms::choose_constants(const Kind& kind, History& history) {
    const auto frames_since = [&](int frame) { return history.frame - frame; };
    const auto forgotten = [&](const auto& name_and_frame) {
        return frames_since(name_and_frame.second) > kForgetFrames;
    };
    if (std::erase_if(history.moved, forgotten) > 0) history.is_current = false;
    if (history.is_current || frames_since(history.settled_at) < kStillFrames) return;

    Uniforms still;
    for (const auto& [name, value] : history.numbers)
        if (!history.moved.contains(name)) still.emplace(name, value);
    // At most one program is baked per frame, because compiling delays the frame.
    const bool is_there = still.empty() || entries_.contains(Key{kind, still});
    if (!is_there && std::exchange(has_baked_, true)) return;
    history.is_current = true;
    history.constants = std::move(still);
    history.entry = nullptr;
}

void KeptPrograms::use(const EffectSet& effects, const Form& form, const Uniforms& numbers, Tier tier) {
    const Kind kind{effects, form};
    const std::uint64_t made_before = counters_.made + counters_.baked;
    Entry* entry = nullptr;
    switch (tier) {
        case Tier::kUniform: entry = &find_or_make({kind, {}}); break;
        case Tier::kBaked: entry = &find_or_make({kind, used_uniforms(kind, numbers)}); break;
        case Tier::kAuto: {
            History& history = history_of(kind, numbers);
            if (history.entry)
                history.entry->last_used = ++uses_;
            else
                history.entry = &find_or_make({kind, history.constants});
            entry = history.entry;
            // While the driver compiles it on its own threads, the program with uniforms draws.
            if (!history.constants.empty() && !entry->program->is_ready()) entry = &find_or_make({kind, {}});
            break;
        }
    }
    if (counters_.made + counters_.baked == made_before) ++counters_.hits;
    entry->program->use(numbers);
}

void KeptPrograms::end_frame() {
    std::erase_if(histories_, [](const auto& kind_and_history) { return !kind_and_history.second.seen; });
    for (auto& [kind, history] : histories_) history.seen = false;
    counts_.clear();
    has_baked_ = false;
}

}  // namespace twinlight::programmable
