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

ShaderProgram& KeptPrograms::find_or_make(const Key& key) {
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
    ShaderProgram& program = *found->second.program;
    if (is_new) evict();  // never this one: it was used last
    return program;
}

void KeptPrograms::evict() {
    while (entries_.size() > limit_ && entries_.size() > 1) {
        entries_.erase(std::ranges::min_element(
            entries_, {}, [](const auto& key_and_entry) { return key_and_entry.second.last_used; }));
        ++counters_.evicted;
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

// Which numbers are constants, judging by the same Draw of earlier frames.
const Uniforms& KeptPrograms::constants_for(const Kind& kind, const Uniforms& numbers) {
    History& history = histories_[{kind, counts_[kind]++}];
    history.seen = true;
    ++history.frame;
    const auto frames_since = [&](int frame) { return history.frame - frame; };
    for (const auto& [name, value] : history.numbers) {
        if (numbers.at(name) == value) continue;
        const bool is_new = history.moved.insert_or_assign(name, history.frame).second;
        if (!is_new) continue;
        history.settled_at = history.frame;
        history.constants.clear();
        history.is_current = false;
    }
    history.numbers = numbers;
    const auto forgotten = [&](const auto& name_and_frame) {
        return frames_since(name_and_frame.second) > kForgetFrames;
    };
    if (std::erase_if(history.moved, forgotten) > 0) history.is_current = false;
    if (history.is_current || frames_since(history.settled_at) < kStillFrames) return history.constants;

    Uniforms still;
    for (const auto& [name, value] : numbers)
        if (!history.moved.contains(name)) still.emplace(name, value);
    // At most one program is baked per frame, because compiling delays the frame.
    const bool is_there = still.empty() || entries_.contains(Key{kind, still});
    if (!is_there && std::exchange(has_baked_, true)) return history.constants;
    history.is_current = true;
    return history.constants = std::move(still);
}

void KeptPrograms::use(const EffectSet& effects, const Form& form, const Uniforms& numbers, Tier tier) {
    const Kind kind{effects, form};
    const std::uint64_t made_before = counters_.made + counters_.baked;
    ShaderProgram* program = nullptr;
    switch (tier) {
        case Tier::kUniform: program = &find_or_make({kind, {}}); break;
        case Tier::kBaked: program = &find_or_make({kind, used_uniforms(kind, numbers)}); break;
        case Tier::kAuto: {
            const Uniforms& constants = constants_for(kind, used_uniforms(kind, numbers));
            program = &find_or_make({kind, constants});
            // While the driver compiles it on its own threads, the program with uniforms draws.
            if (!constants.empty() && !program->is_ready()) program = &find_or_make({kind, {}});
            break;
        }
    }
    if (counters_.made + counters_.baked == made_before) ++counters_.hits;
    program->use(numbers);
}

void KeptPrograms::end_frame() {
    std::erase_if(histories_, [](const auto& kind_and_history) { return !kind_and_history.second.seen; });
    for (auto& [kind, history] : histories_) history.seen = false;
    counts_.clear();
    has_baked_ = false;
}

}  // namespace twinlight::programmable
