#include "app/demo/panel_save.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "app/demo/theme.h"
#include "app/demo/widgets.h"
#include "base/text/translation.h"

namespace twinlight::demo {

using session::Session;

SavePanel::SavePanel() {
    std::error_code ignored;
    std::filesystem::current_path(ignored).string().copy(folder_.data(), folder_.size() - 1);
}

double SavePanel::seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - started_).count();
}

std::string SavePanel::screenshot_path(const Session& session) const {
    return session::free_path(folder_.data(), session::stem_of(key_of(session)), ".png");
}

void SavePanel::save(Session& session, session::Form form) {
    last_failed_ = false;
    try {
        last_ = session::save(session, form, look_of(session, active_pane(session)), folder_.data());
    } catch (const std::runtime_error& error) {
        last_ = error.what();
        last_failed_ = true;
    }
    say(session, last_);
}

void SavePanel::toggle_clip(Session& session) {
    if (clip_) {
        clip_->end(seconds());
        return;
    }
    last_failed_ = false;
    try {
        clip_ = std::make_unique<session::Clip>(
            session::free_path(folder_.data(), session::stem_of(key_of(session)), "-clip"));
        started_ = std::chrono::steady_clock::now();
        last_.clear();
    } catch (const std::runtime_error& error) {
        last_ = error.what();
        last_failed_ = true;
        say(session, last_);
    }
}

void SavePanel::add_frame(Image picture) {
    for (Rgba& pixel : picture.pixels) pixel[3] = 1;
    clip_->add(seconds(), std::move(picture));
}

void SavePanel::update(Session& session) {
    if (!clip_) return;
    const std::string result = clip_->result();
    if (result.empty()) return;
    last_ = result;
    say(session, last_);
    clip_.reset();
}

void SavePanel::show(Session& session) {
    const float width = 9 * ImGui::GetFontSize();
    const auto row = [width](const char* name, const std::string& what) {
        ImGui::Dummy({0, 2});
        const bool pressed = ImGui::Button(tr(name), {width, 0});
        ImGui::SameLine();
        ImGui::AlignTextToFramePadding();
        dim_text(what);
        return pressed;
    };
    heading(tr("The scene"));
    if (row("Save", session.file ? tr("to {} (Ctrl+S)", *session.file) : tr("to a new file (Ctrl+S)")))
        session.save_requested = true;
    if (row("Save as ...", tr("to another file (Ctrl+Shift+S)"))) session.dialog = session::Dialog::kSaveAs;
    heading(tr("New files"));
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(tr("Folder"));
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1);
    ImGui::InputText("##folder", folder_.data(), folder_.size());
    dim_text(tr("No file is overwritten: a name that exists gets a number."));
    for (const session::FormName& form : session::kForms)
        if (row(form.words, tr(form.what))) save(session, form.value);
    if (row("Screenshot", tr("the whole window: NAME.png (key p)"))) session.screenshot_requested = true;
    const char* words = !clip_ ? "Record a clip" : clip_->is_ending() ? "Writing ..." : "Stop";
    if (row(words,
            tr("the pictures: NAME-clip/frame-00001.png and so on, 30 a second; with ffmpeg also NAME-clip.mp4")))
        toggle_clip(session);
    if (clip_)
        colored_text(kAccent,
                     tr("{:.1f} s recorded, {} frames written",
                        static_cast<double>(clip_->frames()) / session::Clip::kFramesPerSecond, clip_->frames()));
    if (!last_.empty()) {
        ImGui::Dummy({0, ImGui::GetFontSize() / 2});
        colored_text(last_failed_ ? kBad : kGood, last_);
    }
}

}  // namespace twinlight::demo
