// KeptPrograms: the programs that a renderer has made, by what they are made from, in three tiers.
//
//   kUniform   the program of an EffectSet and a Form; a Draw's numbers are its uniforms
//   kBaked     all numbers are constants of the program's text (bake.h)
//   kAuto      uniforms first; where numbers have stood still for some frames, a program with these as constants, while
//              what moves stays a uniform
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

    // Makes the program that draws this current, with its numbers.
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
    // What a frame's n-th Draw of a Kind has been: Draws are known again by their order.
    struct History {
        Uniforms numbers;
        std::map<std::string, int, std::less<>> moved;  // the frame in which a number was another one the last time
        int frame = 0;
        int settled_at = 1;       // since this frame nothing but `moved` has moved
        Uniforms constants;       // of the program in use
        bool is_current = false;  // they are all but what is in `moved`
        bool seen = true;         // in this frame
    };

    ShaderProgram& find_or_make(const Key& key);
    const Uniforms& constants_for(const Kind& kind, const Uniforms& numbers);
    Uniforms called_for(const Kind& kind, const Uniforms& numbers);
    void evict();

    std::size_t limit_;
    std::map<Key, Entry> entries_;
    std::map<std::pair<Kind, int>, History> histories_;
    std::map<Kind, std::set<std::string, std::less<>>> names_;  // of the uniforms of its text
    std::map<Kind, int> counts_;                                // of a Kind's Draws in this frame
    bool has_baked_ = false;                                    // in this frame
    std::uint64_t uses_ = 0;
    Counters counters_;
};

}  // namespace twinlight::programmable
