// The panel "Lint": the linter's warnings about the scene as it is now, each with "show me" and "fix it".
#pragma once

#include <chrono>
#include <future>
#include <memory>
#include <string>
#include <vector>

#include "app/session/findings.h"
#include "app/session/session.h"

namespace twinlight::demo {

class LintPanel {
  public:
    // To be called in every frame: starts the linter when the commands stand still, in a thread of its own.
    void update(const session::Session& session);
    // Returns whether the user wants to see a command: it is session.selected_command.
    bool show(session::Session& session);
    // Whether the linter is to run or runs.
    bool is_busy() const { return running_.valid() || made_for_ != seen_; }
    // The findings about the present commands; empty while the linter runs.
    std::size_t count() const { return made_for_ == seen_ ? findings_.size() : 0; }

  private:
    using Clock = std::chrono::steady_clock;
    struct Result {
        int revision = -1;
        std::vector<session::Finding> findings;
        std::string trouble;
    };

    std::future<Result> running_;
    int seen_ = -1;            // the history's revision in the last frame
    Clock::time_point since_;  // from then on
    int made_for_ = -2;        // the revision that the findings belong to
    std::vector<session::Finding> findings_;
    std::string trouble_;
};

}  // namespace twinlight::demo
