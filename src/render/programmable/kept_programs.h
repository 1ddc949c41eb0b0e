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
#include <set>
#include <string>

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

    const Counters& counters() const { return counters_; }

  private:
    struct Kind {
        EffectSet effects;
        Form form;
        friend auto operator<=>(const Kind&, const Kind&) = default;  // NOLINT
    };
    struct Key {
        Kind kind;
        Uniforms constants;
        friend auto operator<=>(const Key&, const Key&) = default;  // NOLINT
    };
    struct Entry {
        std::unique_ptr<ShaderProgram> program;
        std::uint64_t last_used = 0;
    };
    // What is known about the n-th Draw of a Kind in a frame: Draws are matched by their order.
    struct History {
        Uniforms numbers;
        std::map<std::string, int, std::less<>> moved;  // when each changing number last changed
        int frame = 0;
        int settled_at = 1;       // since this frame only the numbers in `moved` have changed
        Uniforms constants;       // the constants of the program in use
        Entry* entry = nullptr;   // that program; null if it is to be looked up
        bool is_current = false;  // `constants` has all numbers except those in `moved`
        bool seen = true;         // drawn in this frame
    };

    Entry& find_or_make(const Key& key);
    // The n-th Draw of this Kind in the frame, with its present constants.
    History& history_of(const Kind& kind, const Uniforms& numbers);
    void choose_constants(const Kind& kind, History& history);
    Uniforms used_uniforms(const Kind& kind, const Uniforms& numbers);
    void evict();

    std::size_t limit_;
    std::map<Key, Entry> entries_;
    std::map<std::pair<Kind, int>, History> histories_;
    std::map<Kind, std::set<std::string, std::less<>>> names_;  // names of the uniforms in its text
    std::map<Kind, int> counts_;                                // the number of a Kind's Draws in this frame
    bool has_baked_ = false;                                    // a program was baked in this frame
    std::uint64_t uses_ = 0;
    Counters counters_;
};

}  // namespace twinlight::programmable
