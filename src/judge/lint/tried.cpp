#include "judge/lint/tried.h"

#include <algorithm>
#include <utility>

#include "base/text/translation.h"
#include "judge/lint/picture_set.h"
#include "judge/lint/watch.h"
#include "render/reference/reference.h"
#include "render/reference/vertices/lit_vertices.h"

namespace twinlight::lint {

namespace {

using Commands = std::vector<Command>;

// ---- A scene with edits ----

// The edits of a warning, for commands as they come.
class Editor {
  public:
    // `moved`: for each edit, the commands at its `moved`, in the order in which they run.
    Editor(std::span<const Edit> edits, std::vector<Commands> moved) : moved_(std::move(moved)) {
        for (const Edit& edit : edits) {
            Commands written;
            if (!edit.insert.empty()) written = read_scene(edit.insert, "fix", "fix").commands;
            for (Command& command : written) command.place = edit.place;
            edits_.push_back({edit, std::move(written)});
        }
        used_.resize(edits_.size());
    }

    // What runs before a statement, or in its place, and after it.
    Commands before(const Place& place) { return written(place, false); }
    Commands after(const Place& place) { return written(place, true); }
    bool keeps(const Place& place) const {
        return std::ranges::none_of(edits_, [&](const auto& one) {
            const Edit& edit = one.first;
            return (edit.removes && edit.place == place) || (edit.moved.line > 0 && edit.moved == place);
        });
    }

  private:
    Commands written(const Place& place, bool is_after) {
        Commands all;
        for (std::size_t i = 0; i < edits_.size(); ++i) {
            const auto& [edit, inserted] = edits_[i];
            if (edit.place != place || edit.is_after != is_after) continue;
            const Commands& from = moved_[i];
            if (!from.empty()) all.push_back(from[std::min(used_[i]++, from.size() - 1)]);
            all.insert(all.end(), inserted.begin(), inserted.end());
        }
        return all;
    }

    std::vector<std::pair<Edit, Commands>> edits_;
    std::vector<Commands> moved_;
    std::vector<std::size_t> used_;  // of each edit's `moved`
};

Editor editor_for(const Recording& recording, std::span<const Edit> edits) {
    std::vector<Commands> moved(edits.size());
    recording.for_each([&](const Step& step) {
        for (std::size_t i = 0; i < edits.size() && step.kind == Step::Kind::kCommand; ++i)
            if (edits[i].moved.line > 0 && step.command.place == edits[i].moved) moved[i].push_back(step.command);
        return true;
    });
    return {edits, std::move(moved)};
}

// A recording of a program. Consecutive calls of one statement, such as those of a shape, run together.
class Edited final : public Recording {
  public:
    Edited(std::shared_ptr<const Recording> original, std::span<const Edit> edits)
        : Recording(original->name), original_(std::move(original)), editor_(editor_for(*original_, edits)) {}

    void for_each(const std::function<bool(const Step&)>& visit) const override {
        Editor editor = editor_;
        Place last;
        bool is_open = false;  // between glBegin and glEnd
        const auto visit_all = [&](const Commands& commands) {
            return std::ranges::all_of(commands, [&](const Command& command) { return visit({.command = command}); });
        };
        original_->for_each([&](const Step& step) {
            if (step.kind != Step::Kind::kCommand) return visit(step);
            const Place& place = step.command.place;
            if (!is_open && place != last && !(visit_all(editor.after(last)) && visit_all(editor.before(place))))
                return false;
            if (!is_open) last = place;
            if (step.command.id == CommandId::glBegin) is_open = true;
            if (step.command.id == CommandId::glEnd) is_open = false;
            return !editor.keeps(place) || visit(step);
        });
    }

  private:
    std::shared_ptr<const Recording> original_;
    Editor editor_;
};

std::shared_ptr<const CommandList> edited_list(const CommandList& list, const Warning& warning) {
    Editor editor = editor_for(list, warning.edits);
    const auto edited = [&](const Commands& commands) {
        Commands result;
        for (const Command& command : commands) {
            const Commands before = editor.before(command.place), after = editor.after(command.place);
            result.insert(result.end(), before.begin(), before.end());
            if (editor.keeps(command.place)) result.push_back(command);
            result.insert(result.end(), after.begin(), after.end());
        }
        return result;
    };
    auto result = std::make_shared<CommandList>(list);
    result->commands = edited(list.commands);
    if (list.text) result->text = std::make_shared<const std::string>(corrected(*list.text, warning));
    if (list.later) {
        std::vector<LaterPicture> later = *list.later;
        for (LaterPicture& picture : later) picture.commands = edited(picture.commands);
        result->later = std::make_shared<const std::vector<LaterPicture>>(std::move(later));
    }
    return result;
}

// A scene and its later pictures.
struct Shown {
    Scene scene;
    std::vector<LaterScene> later;

    std::vector<const Frame*> frames() const {
        std::vector<const Frame*> all = {&scene.frame};
        for (const LaterScene& picture : later) all.push_back(&picture.scene.frame);
        return all;
    }
};

// nullopt where the edits make a scene that cannot be drawn.
std::optional<Shown> edited(const Shown& shown, const Warning& warning) {
    const int width = shown.scene.frame.width, height = shown.scene.frame.height;
    const auto edited_scene = [&](const Scene& scene) -> std::optional<Scene> {
        std::shared_ptr<const Recording> recording;
        if (const CommandList* const list = scene.recording->command_list())
            recording = edited_list(*list, warning);
        else
            recording = std::make_shared<const Edited>(scene.recording, warning.edits);
        std::optional<Frame> frame = last_frame(*recording, width, height);
        if (!frame) return std::nullopt;
        return Scene{std::move(recording), std::move(*frame)};
    };
    std::optional<Scene> scene = edited_scene(shown.scene);
    if (!scene) return std::nullopt;
    Shown result{*scene, {}};
    if (scene->recording->command_list()) {
        if (!shown.later.empty()) result.later = later_scenes(*scene);
        return result;
    }
    for (const LaterScene& picture : shown.later) {
        std::optional<Scene> later = edited_scene(picture.scene);
        if (!later) return std::nullopt;
        result.later.push_back({std::move(*later), picture.when, picture.is_next});
    }
    return result;
}

// ---- What a fix changes ----

bool pictures_differ(const Frame& before, const Frame& after) {
    constexpr float kVisible = 2.5F / 255;
    return differing_pixels(reference::render(smaller(before), {}), reference::render(smaller(after), {}), kVisible) >
           0;
}

bool shows_the_same(const Draw& a, const Draw& b) {
    if (a.raster != b.raster || a.fragment != b.fragment || a.vertices.size() != b.vertices.size()) return false;
    constexpr double kVisible = 1.0 / 255;
    const auto lit_a = reference::light_vertices(a, {}, true), lit_b = reference::light_vertices(b, {}, true);
    const auto near = [](const glm::dvec4& p, const glm::dvec4& q) {
        return glm::all(glm::lessThan(glm::abs(p - q), glm::dvec4(kVisible)));
    };
    for (std::size_t i = 0; i < lit_a.size(); ++i)
        if (!near(lit_a[i].front_primary, lit_b[i].front_primary) ||
            !near(lit_a[i].front_secondary, lit_b[i].front_secondary))
            return false;
    return true;
}

// Whether any object gets other colours, even where it is not seen.
bool draws_differ(const Frame& before, const Frame& after) {
    const std::vector<const Draw*> draws = before.draws(), with = after.draws();
    return !std::ranges::equal(draws, with, [](const Draw* a, const Draw* b) { return shows_the_same(*a, *b); });
}

// The second picture is drawn over a cleared one here, whatever it clears.
bool clears_differ(const Frame& before, const Frame& after) {
    const auto buffers = [](const Frame& frame) {
        std::vector<std::pair<bool, bool>> cleared;
        for (const FrameItem& item : frame.items)
            if (const Clear* clear = std::get_if<Clear>(&item)) cleared.emplace_back(clear->color, clear->depth);
        return cleared;
    };
    return buffers(before) != buffers(after);
}

class Trial {
  public:
    explicit Trial(const Shown& shown) : shown_(shown), found_(warnings_of_all_pictures(shown.scene, shown.later)) {}

    bool passes(const Warning& warning) const {
        const std::optional<Shown> with = edited(shown_, warning);
        if (!with || with->later.size() != shown_.later.size()) return false;
        const std::vector<Warning> left = warnings_of_all_pictures(with->scene, with->later);
        if (std::ranges::any_of(left, [&](const Warning& one) {
                return is_same_mistake(one, warning) ||
                       std::ranges::none_of(found_, [&](const Warning& known) { return is_same_mistake(one, known); });
            }))
            return false;
        const std::set<std::pair<int, int>> about = draws_of(warning);
        const std::vector<const Frame*> before = shown_.frames(), after = with->frames();
        bool changes = false;
        for (std::size_t i = 0; i < before.size(); ++i) {
            if (!about.empty() && !changes_only(about, *before[i], *after[i])) return false;
            changes = changes || clears_differ(*before[i], *after[i]) || draws_differ(*before[i], *after[i]) ||
                      pictures_differ(*before[i], *after[i]);
        }
        return changes;
    }

  private:
    // The statements of the Draws that warnings of this rule are about; empty where it does not say.
    std::set<std::pair<int, int>> draws_of(const Warning& warning) const {
        std::set<std::pair<int, int>> draws;
        for (const Warning& one : found_) {
            if (one.rule != warning.rule) continue;
            if (one.draw.line == 0) return {};
            draws.emplace(one.draw.line, one.draw.column);
        }
        return draws;
    }

    static bool changes_only(const std::set<std::pair<int, int>>& about, const Frame& before, const Frame& after) {
        const std::vector<const Draw*> draws = before.draws(), with = after.draws();
        if (draws.size() != with.size()) return true;  // it draws more or less: only the pictures can tell
        for (std::size_t i = 0; i < draws.size(); ++i)
            if (!about.contains({draws[i]->place.line, draws[i]->place.column}) && !shows_the_same(*draws[i], *with[i]))
                return false;
        return true;
    }

    const Shown& shown_;
    std::vector<Warning> found_;
};

// ---- Other fixes ----

// The opposite of "glDisable(GL_LIGHTING);": "glEnable(GL_LIGHTING);". Empty for other calls.
std::string opposite(const std::string& call) {
    const auto swapped = [&](std::string_view from, std::string_view to) {
        return call.starts_with(from) ? std::string(to) + call.substr(from.size()) : std::string();
    };
    const std::string disabled = swapped("glEnable(", "glDisable(");
    return disabled.empty() ? swapped("glDisable(", "glEnable(") : disabled;
}

// Where the statement that starts at a Draw's place ends: at its glEnd, or there.
Place end_of(const Recording& recording, const Place& draw) {
    Place end = draw;
    bool is_open = false;
    recording.for_each([&](const Step& step) {
        if (step.kind != Step::Kind::kCommand) return true;
        if (step.command.place == draw && step.command.id == CommandId::glBegin) is_open = true;
        if (!is_open || step.command.id != CommandId::glEnd) return true;
        end = step.command.place;
        return false;
    });
    return end;
}

// The same switch, and back after the object; nullopt for other fixes.
std::optional<Warning> around_object(const Recording& recording, const Warning& warning) {
    if (warning.edits.size() != 1 || warning.draw.line == 0) return std::nullopt;
    const Edit& edit = warning.edits.front();
    const std::string back = opposite(edit.insert);
    if (back.empty() || edit.removes || edit.is_after || std::ranges::count(edit.insert, ';') != 1) return std::nullopt;
    Warning around = warning;
    around.edits.push_back({.place = end_of(recording, warning.draw), .insert = back, .is_after = true});
    around.fix = tr("{} before {}, and {} after {}", edit.insert,
                    edit.place == warning.place ? tr("it") : where(edit.place), back, where(around.edits[1].place));
    return around;
}

std::size_t steps_of(const Recording& recording, std::size_t most) {
    std::size_t steps = 0;
    recording.for_each([&](const Step&) { return ++steps <= most; });
    return steps;
}

}  // namespace

void try_fixes(const Scene& scene, std::span<const LaterScene> later, std::vector<Warning>& warnings) {
    const auto has_edits = [](const Warning& warning) { return !warning.edits.empty(); };
    if (std::ranges::none_of(warnings, has_edits)) return;
    constexpr std::size_t kMostSteps = 300'000;
    if (steps_of(*scene.recording, kMostSteps) > kMostSteps) return;
    const Shown shown{scene, {later.begin(), later.end()}};
    const Trial trial(shown);
    for (Warning& warning : warnings) {
        if (!has_edits(warning) || trial.passes(warning)) continue;
        const std::optional<Warning> around = around_object(*scene.recording, warning);
        if (around && trial.passes(*around))
            warning = *around;
        else
            warning.edits.clear();
    }
}

}  // namespace twinlight::lint
