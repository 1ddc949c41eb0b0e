// Executes a scene's commands, and reports its GL errors.
#include <fmt/format.h>

#include <utility>

#include "scene/command/text.h"
#include "scene/state/state.h"

namespace twinlight {

namespace {

// Collects the errors of a scene's commands, without those that only result from an earlier one.
class Errors {
  public:
    // The errors that `state` raised in `command`. `was_inside`: whether that is between glBegin and glEnd.
    void add(const Command& command, const State& state, bool was_inside) {
        const bool has_new = state.error_count() > count_;
        if (has_new && state.errors().size() > taken_ && !follows(command, state, was_inside)) {
            const GlError& error = state.errors()[taken_];
            texts_.push_back({error.place, fmt::format("{} ({})", error.message, enum_name(error.code))});
        }
        if (has_new && command.id == CommandId::glBegin) failed_begin_ = true;
        if (command.id == CommandId::glEnd) failed_begin_ = told_inside_ = false;
        count_ = state.error_count();
        taken_ = state.errors().size();
    }
    // What is still open at the end, unless an error already names that glBegin.
    void add_unfinished(const GlError& error) {
        if (!told_inside_) texts_.push_back({error.place, error.message});
    }
    bool is_full() const { return texts_.size() >= kMaxErrorsShown; }
    std::vector<TextError>& texts() { return texts_; }

  private:
    bool follows(const Command& command, const State& state, bool was_inside) {
        if (command.id == CommandId::glEnd && failed_begin_) return true;
        // After a forgotten glEnd each command is an error; the first is enough.
        const bool is_forbidden = was_inside && state.errors()[taken_].code == kGL_INVALID_OPERATION;
        return is_forbidden && std::exchange(told_inside_, true);
    }

    std::vector<TextError> texts_;
    std::size_t count_ = 0, taken_ = 0;  // how many errors of the State were looked at, and of those that it keeps
    bool failed_begin_ = false, told_inside_ = false;
};

}  // namespace

SceneError with_gl_errors(const SceneError& error, const StateOptions& options) {
    if (!error.readable) return error;
    std::vector<TextError> errors = error.errors;
    State state(options);
    std::size_t count = 0;
    for (const Command& command : error.readable->commands) {
        state.apply(command);
        if (state.exhausted() || state.errors().size() >= kMaxErrorsKept) break;
        for (; count < state.errors().size(); ++count) {
            const GlError& raised = state.errors()[count];
            // Other errors may result from the commands that could not be read.
            if (raised.code == kGL_INVALID_ENUM || raised.code == kGL_INVALID_VALUE)
                errors.push_back({raised.place, fmt::format("{} ({})", raised.message, enum_name(raised.code))});
        }
    }
    SceneError all(std::move(errors), error.text);
    all.note = error.note;
    return all;
}

namespace {

Frame frame_of(const CommandList& commands, const StateOptions& options, bool throws_gl_errors) {
    State state(options);
    Errors errors;
    for (const Command& command : commands.commands) {
        const bool was_inside = state.inside_begin();
        state.apply(command);
        if (state.error_count() > 0) errors.add(command, state, was_inside);
        if (state.exhausted() || (errors.is_full() && throws_gl_errors)) break;
    }
    const auto unfinished = state.unfinished();
    if (unfinished && !errors.is_full() && !state.exhausted()) errors.add_unfinished(*unfinished);
    const bool is_refused = throws_gl_errors || state.exhausted();
    if (!errors.texts().empty() && is_refused) throw SceneError(std::move(errors.texts()), commands.text);
    Frame frame = state.take_frame();
    if (frame.draws().empty())
        throw SceneError(
            commands.is_program
                ? tr("{0}: this program's first picture is empty; if it draws after a key: twinlight record {0} "
                     "--keys TEXT",
                     commands.name)
                : tr("{}: this scene draws nothing; add a shape, such as glutSolidSphere(1, 64, 32);", commands.name));
    return frame;
}

}  // namespace

Frame make_frame(const CommandList& commands, const StateOptions& options) { return frame_of(commands, options, true); }

namespace {

// A program as GL draws it: without the commands that cause GL errors, which become notes. Null if it needs too much memory.
std::shared_ptr<const CommandList> without_gl_errors(const CommandList& program, const StateOptions& options) {
    const auto list = std::make_shared<CommandList>(program);
    list->commands.clear();
    State state(options);
    Errors errors;
    for (const Command& command : program.commands) {
        const bool was_inside = state.inside_begin();
        const std::size_t count = state.error_count();
        state.apply(command);
        if (state.exhausted()) return nullptr;
        if (state.error_count() > 0 && !errors.is_full()) errors.add(command, state, was_inside);
        // Of the commands of a display list, only some may have errors.
        const bool calls = command.id == CommandId::glCallList || command.id == CommandId::glCallLists;
        if (state.error_count() == count || calls) list->commands.push_back(command);
    }
    if (const auto unfinished = state.unfinished(); unfinished && !errors.is_full()) errors.add_unfinished(*unfinished);
    for (Command& ending : state.endings()) {
        if (!program.commands.empty()) ending.place = program.commands.back().place;
        list->commands.push_back(std::move(ending));
    }
    for (const TextError& error : errors.texts())
        list->own_notes.push_back(fmt::format("{}: GL error: {}", error.place.str(), error.message));
    return list;
}

}  // namespace

Scene make_scene(std::shared_ptr<const CommandList> commands, const StateOptions& options) {
    try {
        Frame frame = make_frame(*commands, options);
        return {std::move(commands), std::move(frame)};
    } catch (const SceneError&) {
        if (!commands->is_program) throw;
        std::shared_ptr<const CommandList> correct = without_gl_errors(*commands, options);
        if (!correct) throw;
        Frame frame = frame_of(*correct, options, false);  // a list that is called may still have errors
        return {std::move(correct), std::move(frame)};
    }
}

}  // namespace twinlight
