// The panel "Lesson": the list of lessons; or a lesson's question, prediction, task and check.
#pragma once

#include <future>
#include <memory>

#include "app/session/lesson_state.h"
#include "app/session/session.h"

namespace twinlight::demo {

// The language of the window's lessons: Chinese if the window's font has Chinese letters.
lesson::Language lessons_language();

class LessonPanel {
  public:
    // To be called in every frame: takes the result of a check.
    void update(session::Session& session);
    void show(session::Session& session);
    bool is_busy() const { return running_.valid(); }

  private:
    struct Checked {
        std::shared_ptr<session::LessonState> state;
        int revision = -1;
        lesson::Grade grade;
    };

    // Grades the commands in a thread.
    void check(session::Session& session);
    void show_list(session::Session& session);
    void show_prediction(session::Session& session);
    void show_task(session::Session& session);

    std::future<Checked> running_;
};

}  // namespace twinlight::demo
