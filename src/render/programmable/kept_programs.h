// KeptPrograms: the programs that a renderer has made, by what they were made from, in three tiers.
//
//   kUniform   the program of an EffectSet and a Form; a Draw's numbers are uniforms
//   kBaked     all numbers are constants in the program's text (bake.h)
//   kAuto      starts with uniforms; numbers that have not changed for some frames become constants of a new program,
//              and the others stay uniforms
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "render/programmable/programmable.h"
#include "render/programmable/shader_program.h"

namespace twinlight::programmable {

// Owns GL programs: dies before their context does.
class KeptPrograms {
  public:
    explicit KeptPrograms(std::size_t limit) : limit_(limit) {}

    // Makes the program for this Draw current and sets its uniforms.
    void use(const EffectSet& effects, const Form& form, const Uniforms& numbers, Tier tier);
    void end_frame();
    // See Renderer.
    void allow_baking(bool is_allowed) {
        may_bake_ = is_allowed;
        wants_to_bake_ = false;
    }
    bool wants_to_bake() const { return wants_to_bake_; }

    const Counters& counters() const { return counters_; }

  private:
    struct Key {
        EffectSet effects;
        Form form;
        Uniforms constants;
        friend auto operator<=>(const Key&, const Key&) = default;  // NOLINT
    };
    struct Entry {
        std::unique_ptr<ShaderProgram> program;
        std::uint64_t last_used = 0;
    };
    // What is known about the n-th Draw of a Kind in a frame: Draws are matched by their order. Or, if it has many, about
    // all of them: then `moved` are also the numbers in which they differ.
    struct History {
        Uniforms numbers;        // of the last frame
        std::vector<bool> used;  // whether the shader text has this uniform
        std::vector<int> moved;  // the frame in which this uniform last changed; 0: never, or forgotten
        int frame = 0;
        int settled_at = 1;       // since this frame only uniforms in `moved` have changed
        int next_forgotten = 0;   // no uniform is forgotten before this frame
        Uniforms constants;       // the constants of the program in use
        Entry* entry = nullptr;   // that program; null if it is to be looked up
        bool is_current = false;  // `constants` has all numbers except those in `moved`
    };
    // The Draws that differ only in numbers.
    struct Kind {
        EffectSet effects;
        Form form;
        std::optional<std::set<std::string, std::less<>>> names;  // of the uniforms in its text
        std::vector<History> histories;
        std::size_t count = 0;  // of its Draws in this frame
        bool has_one_history = false;
        Entry* with_uniforms = nullptr;  // the program without constants; null if it is to be looked up
    };

    Kind& kind_of(const EffectSet& effects, const Form& form);
    Entry& find_or_make(const Kind& kind, const Uniforms& constants);
    Entry& with_uniforms(Kind& kind);
    // The next Draw of this Kind in the frame, with its present constants.
    History& next_history(Kind& kind, const Uniforms& numbers);
    void choose_constants(const Kind& kind, History& history);
    std::vector<bool> which_are_used(Kind& kind, const Uniforms& numbers);
    void evict();

    std::size_t limit_;
    std::map<Key, Entry> entries_;
    std::map<std::pair<EffectSet, Form>, Kind> kinds_;
    std::vector<Kind*> order_;    // the Kinds of the last frame's Draws, then of this frame's
    std::size_t draw_count_ = 0;  // in this frame
    bool has_baked_ = false;      // a program was baked in this frame
    bool may_bake_ = true, wants_to_bake_ = false;
    std::uint64_t uses_ = 0;
    Counters counters_;
};

}  // namespace twinlight::programmable
