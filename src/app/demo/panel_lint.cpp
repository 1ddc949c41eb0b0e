#include "app/demo/panel_lint.h"

#include <fmt/format.h>
#include <imgui.h>

#include <cctype>
#include <exception>
#include <optional>
#include <string_view>

#include "app/demo/theme.h"
#include "app/demo/widgets.h"
#include "base/text/reason.h"
#include "base/text/translation.h"
#include "base/threads/async.h"
#include "scene/command/text.h"

namespace twinlight::demo {
namespace {

constexpr auto kStill = std::chrono::milliseconds(300);  // the commands must not change for so long

// The rules' texts are Markdown.
std::string without_marks(std::string_view text) {
    std::string plain(text);
    std::erase(plain, '`');
    return plain;
}

// With a capital letter, unless it starts with a name of GL.
std::string as_sentence(std::string message) {
    if (!message.starts_with("gl") && !message.empty())
        message[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(message[0])));
    return message + tr(".");
}

}  // namespace

void LintPanel::update(const session::Session& session) {
    const int revision = session.history.revision();
    if (revision != seen_) {
        seen_ = revision;
        since_ = Clock::now();
    }
    if (running_.valid() && is_ready(running_)) {
        Result result = running_.get();
        made_for_ = result.revision;
        findings_ = std::move(result.findings);
        trouble_ = std::move(result.trouble);
    }
    if (running_.valid() || made_for_ == revision || Clock::now() - since_ < kStill) return;
    running_ = std::async(kThreadIfPossible,
                          [revision, list = session.history.now(), size = WindowSize{session.width, session.height}] {
                              try {
                                  return Result{revision, session::findings_of(*list, size), ""};
                              } catch (const std::exception& error) {
                                  return Result{revision, {}, reason_of(error)};
                              }
                          });
}

bool LintPanel::show(session::Session& session) {
    if (made_for_ != seen_) {
        dim_text(tr("Checking the scene ..."));
        return false;
    }
    if (!trouble_.empty()) {
        colored_text(kBad, trouble_);
        return false;
    }
    if (findings_.empty()) {
        colored_text(kGood, tr("No mistakes in the lighting."));
        dim_text(
            tr("The linter checks what GL accepts without an error: lights that are black, positions set before the "
               "camera, normals not of length 1, and more."));
        return false;
    }
    dim_text(tr("GL accepts these commands, but the picture is probably not what you want."));
    bool selected = false;
    std::optional<std::size_t> to_fix;
    for (std::size_t i = 0; i < findings_.size(); ++i) {
        const session::Finding& finding = findings_[i];
        const lint::Warning& warning = finding.warning;
        ImGui::PushID(static_cast<int>(i));
        ImGui::Dummy({0, ImGui::GetFontSize() / 4});
        ImGui::Separator();
        ImGui::Dummy({0, ImGui::GetFontSize() / 4});
        bold_text(as_sentence(warning.message));
        ImGui::PushFont(fonts().code);
        colored_text(kAccent, print_command(commands(session).commands[finding.command]));
        ImGui::PopFont();
        dim_text(fmt::format("{}{}  [{}]", finding.where,
                             warning.count > 1 ? tr(" and {} more places", warning.count - 1) : "", warning.rule->name)
                     .c_str());
        ImGui::TextUnformatted(wrapped(without_marks(tr(warning.rule->why))).c_str());
        ImGui::PushFont(fonts().code);
        colored_text(kGood, warning.fix);
        ImGui::PopFont();
        if (ImGui::Button(tr("Show me"))) {
            session.selected_command = finding.command;
            selected = true;
        }
        ImGui::SameLine();
        if (finding.can_fix) {
            if (ImGui::Button(tr("Fix it"))) to_fix = i;
        } else {
            ImGui::AlignTextToFramePadding();
            ImGui::TextDisabled("%s", tr("This one needs your own change."));
        }
        ImGui::PopID();
    }
    if (to_fix) {
        const session::Finding& finding = findings_[*to_fix];
        edit(session, session::corrected(commands(session), finding), tr("fix {}", finding.warning.rule->name));
        say(session, tr("corrected: {}; z undoes it", finding.warning.message));
    }
    return selected;
}

}  // namespace twinlight::demo
