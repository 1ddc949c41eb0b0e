#include "judge/fuzz/shrink.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "base/math/as_float.h"

namespace twinlight::fuzz {

namespace {

class Shrinker {
  public:
    Shrinker(CommandList scene, const StillFails& still_fails, int questions)
        : scene_(std::move(scene)), still_fails_(still_fails), questions_(questions) {}

    CommandList shrink() {
        for (bool smaller = true; smaller && questions_ > 0;) {
            smaller = remove_runs();
            smaller = remove_pairs() || smaller;
            smaller = simplify_values() || smaller;
        }
        return std::move(scene_);
    }

  private:
    // Keeps the candidate if it fails too.
    bool take(CommandList candidate) {
        if (questions_-- <= 0 || !still_fails_(candidate)) return false;
        scene_ = std::move(candidate);
        return true;
    }

    CommandList without(std::size_t first, std::size_t count) const {
        CommandList candidate = scene_;
        const auto begin = candidate.commands.begin() + static_cast<std::ptrdiff_t>(first);
        candidate.commands.erase(begin, begin + static_cast<std::ptrdiff_t>(count));
        return candidate;
    }

    // Removes runs of half of the commands, of a quarter, ... of one; from the end, because later commands depend on
    // earlier ones.
    bool remove_runs() {
        bool any = false;
        for (std::size_t length = std::max<std::size_t>(1, scene_.commands.size() / 2);; length /= 2) {
            for (std::size_t end = scene_.commands.size(); end >= length; end -= length)
                any = take(without(end - length, length)) || any;
            if (length == 1) return any;
        }
    }

    // Removes commands that need each other: Begin and End, Push and Pop, NewList and EndList, with or without the
    // commands between them.
    bool remove_pairs() {
        bool any = false;
        for (std::size_t first = 0; first < scene_.commands.size(); ++first) {
            const std::string_view closing = closing_of(scene_.commands[first].id);
            if (closing.empty()) continue;
            std::size_t last = first + 1;
            for (int open = 1; last < scene_.commands.size(); ++last) {
                if (scene_.commands[last].id == scene_.commands[first].id) ++open;
                if (scene_.commands[last].name() == closing && --open == 0) break;
            }
            if (last == scene_.commands.size()) continue;
            if (take(without(first, last - first + 1))) {
                any = true;
                --first;  // the next command is here now
                continue;
            }
            CommandList ends = without(last, 1);
            ends.commands.erase(ends.commands.begin() + static_cast<std::ptrdiff_t>(first));
            // Without its list, the commands run directly; the calls of the list are removed too.
            if (scene_.commands[first].id == CommandId::glNewList) {
                const double name = scene_.commands[first].number(0);
                std::erase_if(ends.commands, [&](const Command& command) {
                    return command.id == CommandId::glCallList && command.number(0) == name;
                });
            }
            any = take(std::move(ends)) || any;
        }
        return any;
    }

    static std::string_view closing_of(CommandId id) {
        switch (id) {
            case CommandId::glBegin: return "glEnd";
            case CommandId::glPushMatrix: return "glPopMatrix";
            case CommandId::glPushAttrib: return "glPopAttrib";
            case CommandId::glPushClientAttrib: return "glPopClientAttrib";
            case CommandId::glNewList: return "glEndList";
            default: return {};
        }
    }

    // Replaces numbers by 0, 1 or numbers of few digits. GL's names stay.
    bool simplify_values() {
        bool any = false;
        for (std::size_t c = 0; c < scene_.commands.size(); ++c) {
            for (std::size_t i = 0; i < scene_.commands[c].arguments.size(); ++i) {
                if (!is_number(scene_.commands[c], i)) continue;
                const double value = scene_.commands[c].arguments[i];
                for (const double simple : simpler(value)) {
                    CommandList candidate = scene_;
                    candidate.commands[c].arguments[i] = simple;
                    if (!take(std::move(candidate))) continue;
                    any = true;
                    break;
                }
            }
        }
        return any;
    }

    static bool is_number(const Command& command, std::size_t argument) {
        const std::vector<Parameter>& parameters = command.sig().parameters;
        for (std::size_t p = 0; p < parameters.size(); ++p) {
            const std::size_t first = command.first(p);
            if (argument < first || argument >= first + command.count(p)) continue;
            const Kind kind = parameters[p].kind;
            if (kind != Kind::kFloat && kind != Kind::kDouble && kind != Kind::kInt) return false;
            const Extent extent = parameters[p].extent;
            if (extent == Extent::kPointer || extent == Extent::kNewNames || extent == Extent::kResult) return false;
            const bool is_name = command.arguments[argument] >= 0x100 &&
                                 enum_name(static_cast<Enum>(command.arguments[argument])).starts_with("GL");
            return !(kind == Kind::kInt && is_name);
        }
        return false;
    }

    static std::vector<double> simpler(double value) {
        std::vector<double> candidates;
        for (const double digits : {0.0, 1.0, 10.0, 100.0}) {
            double rounded = digits == 0 ? 0 : std::round(value * digits) / digits;
            if (rounded == 0) rounded = 0;  // not -0
            rounded = as_float(rounded);
            if (rounded == value) return candidates;  // it is already that simple
            candidates.push_back(rounded);
            if (digits == 0 && value != 1) candidates.push_back(1);
        }
        return candidates;
    }

    CommandList scene_;
    const StillFails& still_fails_;
    int questions_;
};

}  // namespace

CommandList shrink(CommandList scene, const StillFails& still_fails, int questions) {
    return Shrinker(std::move(scene), still_fails, questions).shrink();
}

}  // namespace twinlight::fuzz
