#include "app/demo/panel_lesson.h"

#include <fmt/format.h>
#include <imgui.h>

#include <chrono>
#include <exception>
#include <map>
#include <string>
#include <string_view>

#include "app/demo/theme.h"
#include "app/demo/widgets.h"
#include "base/text/reason.h"
#include "base/threads/async.h"

namespace twinlight::demo {
namespace {

void paragraph(const std::string& markdown) { ImGui::TextUnformatted(wrapped(session::plain_text(markdown)).c_str()); }
void colored_paragraph(ImU32 color, const std::string& text) { colored_text_line(color, wrapped(text)); }

}  // namespace

lesson::Language lessons_language() {
    return has_chinese_letters() ? lesson::Language::kChinese : lesson::Language::kEnglish;
}

void LessonPanel::check(session::Session& session) {
    const auto answer = answer_of(session);
    running_ =
        std::async(kThreadIfPossible, [state = session.lesson, revision = session.history.revision(), list = answer] {
            Checked checked{state, revision, {}};
            try {
                checked.grade = lesson::Grader(state->page).grade(list);
            } catch (const std::exception& error) {
                checked.grade.reason = reason_of(error);
            }
            return checked;
        });
}

void LessonPanel::update(session::Session& session) {
    if (!running_.valid() || !is_ready(running_)) return;
    Checked checked = running_.get();
    if (checked.state != session.lesson) return;  // another lesson was opened
    session::take_grade(session, std::move(checked.grade), checked.revision);
}

void LessonPanel::show_list(session::Session& session) {
    colored_paragraph(kDim, session::words_of(lessons_language()).lessons);
    for (const std::string_view name : lesson::names()) {
        static std::map<std::string_view, std::string> titles;  // the pages do not change
        std::string& title = titles[name];
        if (title.empty()) title = lesson::load_lesson(name, lessons_language()).title;
        ImGui::PushID(name.data());
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float indent = 1.6F * ImGui::GetFontSize();
        ImGui::Indent(indent);
        const std::string lines = wrapped(title);
        ImGui::Unindent(indent);
        if (ImGui::Selectable("##open", false, 0, {0, ImGui::CalcTextSize(lines.c_str()).y}))
            session::start_lesson(session, lesson::load_lesson(name, lessons_language()));
        if (session::is_solved(session, name)) draw_tick(at);
        ImGui::SameLine(indent);
        ImGui::TextUnformatted(lines.c_str());
        ImGui::PopID();
    }
}

void LessonPanel::show_prediction(session::Session& session) {
    session::LessonState& state = *session.lesson;
    const session::LessonWords& words = session::words_of(state.page.language);
    heading(words.prediction);
    paragraph(state.page.prediction);
    for (std::size_t i = 0; i < state.page.choices.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        const bool is_chosen = state.predicted == i;
        if (ImGui::RadioButton("##choice", is_chosen)) session::predict(session, i);
        ImGui::SameLine();
        const std::string text =
            fmt::format("{}. {}", static_cast<char>('A' + i), session::plain_text(state.page.choices[i]));
        const bool is_right = state.predicted && i == state.page.right_choice;
        if (is_right || is_chosen)
            colored_paragraph(is_right ? kGood : kBad, text);
        else
            paragraph(text);
        if (ImGui::IsItemClicked()) session::predict(session, i);
        ImGui::PopID();
    }
    if (!state.predicted) return;
    colored_paragraph(*state.predicted == state.page.right_choice ? kGood : kBad,
                      session::verdict_on_prediction(state));
    const bool is_shown = session::shows_change(session);
    if (ImGui::Button(is_shown ? words.show_start : words.show_change)) session::show_change(session, !is_shown);
    paragraph(state.page.seen);
}

void LessonPanel::show_task(session::Session& session) {
    const session::LessonState& state = *session.lesson;
    const session::LessonWords& words = session::words_of(state.page.language);
    heading(words.task);
    paragraph(state.page.task);
    colored_paragraph(kDim, words.how);
    if (running_.valid()) {
        ImGui::TextDisabled("%s", words.checking);
    } else if (ImGui::Button(words.check)) {
        check(session);
    }
    if (!state.grade) return;
    // Grey as soon as it is no longer about the scene on show.
    const bool is_outdated = session::is_outdated(session), is_right = state.grade->is_right;
    if (is_outdated) dim_text(words.outdated);
    colored_paragraph(is_outdated ? kDim : is_right ? kGood : kBad, is_right ? words.right : words.not_yet);
    const std::string why = is_right ? session::because_of(state.page) : session::plain_text(state.grade->reason);
    colored_paragraph(is_outdated ? kDim : kText, why);
}

void LessonPanel::show(session::Session& session) {
    if (!session.lesson) {
        show_list(session);
        return;
    }
    const std::shared_ptr<session::LessonState> state = session.lesson;
    const session::LessonWords& words = session::words_of(state->page.language);
    bold_text(wrapped(state->page.title));
    ImGui::Dummy({0, ImGui::GetFontSize() / 4});
    paragraph(state->page.question);
    show_prediction(session);
    show_task(session);
    ImGui::Dummy({0, ImGui::GetFontSize() / 2});
    ImGui::Separator();
    if (ImGui::Button(words.again)) session::start_lesson(session, state->page);
    ImGui::SameLine();
    if (ImGui::Button(words.all)) session::leave_lesson(session);
    const std::string next = session::next_lesson(*state);
    if (next.empty()) return;
    ImGui::SameLine();
    if (ImGui::Button(words.next)) session::start_lesson(session, lesson::load_lesson(next, state->page.language));
}

}  // namespace twinlight::demo
