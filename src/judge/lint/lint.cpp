// Runs the rules over a scene: executes its commands, shows them to each rule's Watch, and joins repeated warnings.
#include "judge/lint/lint.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <tuple>

#include "judge/lint/picture_set.h"
#include "judge/lint/redraw.h"
#include "judge/lint/source.h"
#include "judge/lint/watch.h"

namespace twinlight::lint {

std::span<const Rule> rules() {
    static const std::vector<Rule> all = [] {
        std::vector<Rule> joined;
        for (const auto& part :
             {light_rules(), material_rules(), overlay_rules(), normal_rules(), turned_normals_rules(),
              back_side_rules(), view_rules(), picture_rules(), between_vertices_rules(), redraw_rules(),
              later_picture_rules(), scaled_shininess_rules()})
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

std::tuple<std::string, int, int> in_order(const Place& place) {
    return {place.file ? *place.file : "", place.line, place.column};
}

const std::string& key_of(const Warning& warning) { return warning.key.empty() ? warning.message : warning.key; }

// The statements that a picture ran. Calls of a recording without places of its source are none.
class Statements {
  public:
    void add(const Place& place) {
        if (place.column == Place::kCallNumber) return;
        if (!last_ || place.file != last_file_) {
            last_ = &of_files_[place.file ? *place.file : ""];
            last_file_ = place.file;
        }
        last_->emplace(place.line, place.column);
    }
    bool has(const Place& place) const {
        const auto found = of_files_.find(place.file ? *place.file : "");
        return found != of_files_.end() && found->second.contains({place.line, place.column});
    }
    void add(const Statements& others) {
        for (const auto& [file, places] : others.of_files_) of_files_[file].insert(places.begin(), places.end());
    }

  private:
    std::map<std::string, std::set<std::pair<int, int>>> of_files_;
    std::set<std::pair<int, int>>* last_ = nullptr;
    std::shared_ptr<const std::string> last_file_;
};

// The warnings of one picture.
struct Found {
    std::vector<Warning> warnings;
    Statements statements;

    bool has(const Warning& wanted) const {
        return std::ranges::any_of(warnings, [&](const Warning& one) { return is_same_mistake(one, wanted); });
    }
};

class Walk {
  public:
    Walk(const Frame& frame, const CommandList* list)
        : state_({.width = frame.width, .height = frame.height, .memory = std::numeric_limits<std::size_t>::max()}) {
        for (const Rule& rule : rules()) watches_.push_back(rule.make());
        for (const auto& watch : watches_) watch->start(list);
        state_.watch_lists([this](const Command& command, bool is_done) { show(command, is_done); });
        state_.watch_draws([this](const Draw& draw) {
            for (const auto& watch : watches_) watch->take(draw, state_);
        });
    }

    void take(const Step& step) {
        if (step.kind == Step::Kind::kFrameEnd) return next_picture();
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

    Found finish(const Frame& frame, bool is_recorded) {
        Found found{.warnings = {}, .statements = std::move(statements_)};
        for (std::size_t i = 0; i < watches_.size(); ++i) {
            watches_[i]->finish(frame, is_recorded);
            for (Warning& warning : watches_[i]->take()) {
                warning.rule = &rules()[i];
                found.warnings.push_back(std::move(warning));
            }
        }
        return found;
    }

  private:
    void next_picture() {
        statements_ = {};
        for (const auto& watch : watches_) {
            if (watch->warns_again()) watch->take();
            watch->shown();
        }
    }

    void show(const Command& command, bool is_done) {
        if (kOnlyInDraws.contains(command.id)) return;
        if (!is_done) {
            for (const auto& watch : watches_) watch->before(command, state_);
            return;
        }
        statements_.add(command.place);
        state_.drop_picture();
        for (const auto& watch : watches_) watch->after(command, state_);
    }

    State state_;
    std::vector<std::unique_ptr<Watch>> watches_;
    Statements statements_;  // of this picture
};

// The first pictures of a whole program, one after the other.
class Pictures final : public Recording {
  public:
    Pictures(std::shared_ptr<const Recording> first, std::size_t count)
        : Recording(first->name), first_(std::move(first)), count_(count) {}

    void for_each(const std::function<bool(const Step&)>& visit) const override {
        const CommandList& list = *first_->command_list();
        bool goes_on = true;
        list.for_each([&](const Step& step) { return goes_on = visit(step); });
        const Command none{};
        for (std::size_t i = 0; goes_on && i + 1 < count_; ++i) {
            if (!visit({.kind = Step::Kind::kFrameEnd, .command = none})) return;
            for (const Command& command : (*list.later)[i].commands)
                if (!visit({.command = command})) return;
        }
    }
    std::shared_ptr<const std::string> text_of(const Place& place) const override { return first_->text_of(place); }

  private:
    std::shared_ptr<const Recording> first_;
    std::size_t count_;
};

Found found_in(const Scene& scene, const CommandList* list, const Redraw* redraw) {
    Walk walk(scene.frame, list);
    scene.recording->for_each([&](const Step& step) {
        walk.take(step);
        return true;
    });
    if (redraw) walk.redraw(*redraw);
    return walk.finish(scene.frame, list == nullptr);
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
        const std::string key = key_of(warning);
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

std::optional<Frame> last_frame(const Recording& recording, int width, int height) {
    State state({.width = width, .height = height});
    recording.for_each([&](const Step& step) {
        if (step.kind == Step::Kind::kFrameEnd) state.drop_picture();
        if (step.kind == Step::Kind::kCommand) state.apply(step.command);
        return true;
    });
    if (state.exhausted() || state.unfinished()) return std::nullopt;
    return state.take_frame();
}

bool is_same_mistake(const Warning& a, const Warning& b) {
    const bool is_call = a.place.column == Place::kCallNumber;
    return a.rule == b.rule && key_of(a) == key_of(b) && (is_call || in_order(a.place) == in_order(b.place));
}

std::vector<Warning> warnings_of_all_pictures(const Scene& scene, std::span<const LaterScene> later) {
    const CommandList* const list = scene.recording->command_list();
    const std::optional<Redraw> redraw = list ? redraw_of(*list, scene.frame.width, scene.frame.height) : std::nullopt;
    const Found first = found_in(scene, list, redraw ? &*redraw : nullptr);
    std::vector<Warning> all = first.warnings;
    Statements run;
    run.add(first.statements);
    for (const LaterScene& picture : later) {
        const Found found = found_in(picture.scene, list, nullptr);
        for (Warning& warning : all) {
            const bool is_first_only = first.has(warning) && found.statements.has(warning.place) && !found.has(warning);
            if (picture.is_next && is_first_only) warning.when = "in the first picture only";
        }
        for (const Warning& warning : found.warnings) {
            const auto is_same = [&](const Warning& known) { return is_same_mistake(known, warning); };
            const bool is_new_statement = warning.place.column != Place::kCallNumber && !run.has(warning.place);
            if (std::ranges::any_of(all, is_same) || (!picture.is_next && !is_new_statement)) continue;
            all.push_back(warning);
            if (!warning.rule->compares_pictures) all.back().when = picture.when;
        }
        run.add(found.statements);
    }
    return all;
}

std::vector<LaterScene> later_scenes(const Scene& scene) {
    const CommandList* const list = scene.recording->command_list();
    std::vector<LaterScene> scenes;
    const std::size_t count = list && list->later ? list->later->size() : 0;
    for (std::size_t i = 0; i < count; ++i) {
        const auto recording = std::make_shared<const Pictures>(scene.recording, i + 2);
        std::optional<Frame> frame = last_frame(*recording, scene.frame.width, scene.frame.height);
        if (!frame) break;
        scenes.push_back({{recording, std::move(*frame)}, (*list->later)[i].when, i == 0});
    }
    return scenes;
}

std::vector<Warning> lint(const Scene& scene, std::span<const LaterScene> later) {
    const CommandList* const list = scene.recording->command_list();
    std::vector<Warning> warnings = warnings_of_all_pictures(scene, later);
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
            return not_run.fix(warning);
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
