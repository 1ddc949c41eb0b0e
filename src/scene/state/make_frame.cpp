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

Frame make_frame(const CommandList& commands, const StateOptions& options) {
    State state(options);
    Errors errors;
    for (const Command& command : commands.commands) {
        const bool was_inside = state.inside_begin();
        state.apply(command);
        if (state.error_count() > 0) errors.add(command, state, was_inside);
        if (state.exhausted() || errors.is_full()) break;
    }
    const auto unfinished = state.unfinished();
    if (unfinished && !errors.is_full() && !state.exhausted()) errors.add_unfinished(*unfinished);
    if (!errors.texts().empty()) throw SceneError(std::move(errors.texts()), commands.text);
    Frame frame = state.take_frame();
    if (frame.draws().empty())
        throw SceneError(fmt::format("{}: this scene draws nothing; add a shape, such as glutSolidSphere(1, 64, 32);",
                                     commands.name));
    return frame;
}

Scene make_scene(std::shared_ptr<const CommandList> commands, const StateOptions& options) {
    Frame frame = make_frame(*commands, options);
    return {std::move(commands), std::move(frame)};
}

}  // namespace twinlight
