// Runs the rules over a scene: executes its commands, shows them to each rule's Watch, and joins repeated warnings.
#include "judge/lint/lint.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <tuple>

#include "judge/lint/source.h"
#include "judge/lint/watch.h"

namespace twinlight::lint {

std::span<const Rule> rules() {
    static const std::vector<Rule> all = [] {
        std::vector<Rule> joined;
        for (const auto& part : {light_rules(), material_rules(), overlay_rules(), normal_rules(),
                                 turned_normals_rules(), back_side_rules(), view_rules(), picture_rules(),
                                 between_vertices_rules(), redraw_rules(), scaled_shininess_rules()})
            joined.insert(joined.end(), part.begin(), part.end());
        return joined;
    }();
    return all;
}

const Rule* find_rule(std::string_view name) {
    const auto found = std::ranges::find(rules(), name, &Rule::name);
    return found == rules().end() ? nullptr : &*found;
}

namespace {

// Commands that come only as part of Draws.
constexpr CommandSet kOnlyInDraws = CommandSet::of({"vertex", "tex_coord", "multi_tex_coord", "edge_flag"});

class Walk {
  public:
    Walk(const Frame& frame, const CommandList* list)
        : state_({.width = frame.width, .height = frame.height, .memory = std::numeric_limits<std::size_t>::max()}) {
        for (const Rule& rule : rules()) watches_.push_back(rule.make());
        for (const auto& watch : watches_) watch->start(list);
        state_.watch_lists([this](const Command& command, bool is_done) { show(command, is_done); });
    }

    void take(const Step& step) {
        if (step.kind != Step::Kind::kCommand || state_.exhausted()) return;
        // What GL_COMPILE stores is shown when it is executed.
        const bool is_stored = state_.lists().open_name != 0 && state_.lists().open_mode == kGL_COMPILE;
        if (!is_stored) show(step.command, false);
        state_.apply(step.command);
        if (!is_stored) show(step.command, true);
    }

    void redraw(const Redraw& redraw) {
        for (const auto& watch : watches_) watch->redrawn(redraw);
    }

    std::vector<Warning> finish(const Frame& frame, bool is_recorded) {
        std::vector<Warning> all;
        for (std::size_t i = 0; i < watches_.size(); ++i) {
            watches_[i]->finish(frame, is_recorded);
            for (Warning& warning : watches_[i]->take()) {
                warning.rule = &rules()[i];
                all.push_back(std::move(warning));
            }
        }
        return all;
    }

  private:
    void show(const Command& command, bool is_done) {
        if (kOnlyInDraws.contains(command.id)) return;
        if (!is_done) {
            for (const auto& watch : watches_) watch->before(command, state_);
            return;
        }
        for (const auto& item : state_.items())
            if (const Draw* draw = std::get_if<Draw>(&item))
                for (const auto& watch : watches_) watch->drawn(*draw, state_);
        state_.drop_picture();
        for (const auto& watch : watches_) watch->after(command, state_);
    }

    State state_;
    std::vector<std::unique_ptr<Watch>> watches_;
};

std::tuple<std::string, int, int> in_order(const Place& place) {
    return {place.file ? *place.file : "", place.line, place.column};
}

// Warnings of a rule with the same key or message are one, with the number of its places.
std::vector<Warning> joined(std::vector<Warning> warnings) {
    std::vector<Warning> kept;
    std::map<std::tuple<const Rule*, std::string>, std::size_t> numbers;
    std::vector<std::set<std::tuple<std::string, int, int>>> places;  // of each kept warning
    for (Warning& warning : warnings) {
        const auto known = numbers.find({warning.rule, warning.message});
        const std::size_t number = known == numbers.end() ? kept.size() : known->second;
        numbers.emplace(std::tuple(warning.rule, warning.message), number);
        const std::string key = warning.key.empty() ? warning.message : warning.key;
        const auto at = numbers.try_emplace({warning.rule, key}, number).first;
        const bool is_new = at->second == kept.size();
        const std::tuple place = in_order(warning.place);
        if (is_new) {
            kept.push_back(std::move(warning));
            places.emplace_back();
        }
        places[at->second].insert(place);
        kept[at->second].count = static_cast<int>(places[at->second].size());
    }
    std::ranges::stable_sort(kept, {}, [](const Warning& warning) { return in_order(warning.place); });
    return kept;
}

}  // namespace

std::vector<Warning> lint(const Scene& scene) {
    const CommandList* list = scene.recording->command_list();
    Walk walk(scene.frame, list);
    scene.recording->for_each([&](const Step& step) {
        walk.take(step);
        return true;
    });
    if (list)
        if (const auto redraw = redraw_of(*list, scene.frame.width, scene.frame.height)) walk.redraw(*redraw);
    std::vector<Warning> warnings = walk.finish(scene.frame, list == nullptr);
    std::map<std::shared_ptr<const std::string>, Allowed> allowed;  // by the text
    std::erase_if(warnings, [&](const Warning& warning) {
        const auto text = scene.recording->text_of(warning.place);
        return text && allowed.try_emplace(text, *text).first->second.has(warning.rule->name, warning.place.line);
    });
    if (list && list->text) {
        const CallsNotRun not_run(*list);
        std::erase_if(warnings, [&](Warning& warning) {
            if (warning.place.file && list->included.contains(*warning.place.file)) {
                warning.edits.clear();  // they change the program's own text
                return false;
            }
            return not_run.mend(warning);
        });
    }
    std::set<std::string_view> found;
    for (const Warning& warning : warnings) found.insert(warning.rule->name);
    std::erase_if(warnings, [&](const Warning& warning) {
        return std::ranges::any_of(warning.rule->explained_by,
                                   [&](std::string_view cause) { return found.contains(cause); });
    });
    return joined(std::move(warnings));
}

}  // namespace twinlight::lint
