#include "app/demo/panel_shaders.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <imgui.h>

#include <algorithm>
#include <stdexcept>

#include "app/demo/theme.h"
#include "app/demo/widgets.h"
#include "base/text/translation.h"
#include "render/programmable/export/kept_files.h"
#include "render/programmable/export/shader_text.h"

namespace twinlight::demo {
namespace {

using session::Ink;
using session::Session;
using session::ShownShader;

ImU32 ink_color(Ink ink) {
    switch (ink) {
        case Ink::kPlain: return kText;
        case Ink::kKeyword: return IM_COL32(206, 156, 232, 255);
        case Ink::kType: return IM_COL32(122, 196, 214, 255);
        case Ink::kNumber: return IM_COL32(226, 168, 116, 255);
        case Ink::kComment: return IM_COL32(128, 140, 132, 255);
        case Ink::kDirective: return IM_COL32(206, 156, 232, 255);
        case Ink::kCall: return IM_COL32(234, 206, 130, 255);
    }
    return kText;
}

// The shading of the active pane, or of the first one with shaders.
Look look_of_shaders(const Session& session) {
    const session::Pane& active = active_pane(session);
    if (active.renderer == Path::kProgrammable) return look_of(session, active);
    for (const session::Pane& pane : session.panes)
        if (pane.renderer == Path::kProgrammable) return look_of(session, pane);
    return look_of(session, active);
}

std::vector<ShownShader> shaders_to_keep(const Scene& scene, const programmable::Options& options) {
    const std::string why = programmable::why_not_in_files(scene.frame);
    if (!why.empty()) throw std::runtime_error(tr("Shaders to keep cannot draw this scene: {}.", why));
    std::vector<ShownShader> shaders;
    for (NamedFile& file : programmable::kept_files(scene.frame, options, programmable::Glsl::k330, scene.name()))
        if (file.name.ends_with(".vert") || file.name.ends_with(".frag"))
            shaders.push_back({std::move(file.name), 0, std::move(file.bytes)});
    return shaders;
}

}  // namespace

void ShadersPanel::update(const Session& session) {
    const Look look = look_of_shaders(session);
    const bool is_same = look == look_;
    if (revision_ == session.revision && is_same && to_keep_ == made_to_keep_) return;
    // Until then the shaders of before are shown.
    const bool is_shown = revision_ >= 0 && is_same && to_keep_ == made_to_keep_;
    if (!patience_.may_work(session.revision) && is_shown) return;
    revision_ = session.revision;
    look_ = look;
    made_to_keep_ = to_keep_;
    patience_.work([&] { make_shaders(session); });
    // At first the longest program, which does the most.
    const bool is_new_scene = opened_ != session.opened;
    opened_ = session.opened;
    if (is_new_scene || shown_ >= shaders_.size()) {
        const auto length = [](const ShownShader& shader) { return shader.glsl.size(); };
        shown_ = static_cast<std::size_t>(std::ranges::max_element(shaders_, {}, length) - shaders_.begin());
    }
}

void ShadersPanel::make_shaders(const Session& session) {
    trouble_.clear();
    shaders_.clear();
    lines_.clear();
    programmable::Options options;
    static_cast<Look&>(options) = look_;
    plans_ = explain_draws(session.scene.frame, options);
    try {
        if (to_keep_ && options.shading == Shading::kExact)
            throw std::runtime_error(
                tr("Exact surfaces are found by rays for one picture. Press g to choose another shading."));
        shaders_ = to_keep_ ? shaders_to_keep(session.scene, options)
                            : session::shown_shaders(programmable::shader_source(session.scene.frame, options));
        if (shaders_.empty()) trouble_ = tr("The scene draws nothing, so it has no shaders.");
    } catch (const std::runtime_error& error) {
        trouble_ = error.what();
    }
}

void ShadersPanel::show_reasons(const ShownShader& shader) const {
    const ExplainedDraw* draw = session::plan_of(plans_, shader.draw);
    if (!draw) return;
    std::vector<ExplainedEffect> rows = explain_effects(draw->plan);
    if (!all_reasons_) std::erase_if(rows, [](const ExplainedEffect& row) { return row.is_off; });
    ImGui::TextUnformatted(wrapped(fmt::format("{}", fmt::join(effect_words(draw->plan).of_draw, tr(", ")))).c_str());
    if (!ImGui::BeginTable("reasons", 2, ImGuiTableFlags_SizingFixedFit)) return;
    ImGui::TableSetupColumn("");
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch);
    for (const ExplainedEffect& row : rows) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        colored_text_line(row.in ? kGood : kDim, tr(row.in ? "used" : "skipped"));
        ImGui::TableNextColumn();
        colored_text(row.in ? kText : kDim, row.what);
        dim_text(row.why);
    }
    ImGui::EndTable();
    dim_text(tr("All skipped lights together change a channel by at most {}.", in_codes(draw->plan.error_bound)));
}

void ShadersPanel::show_glsl(Session& session) {
    const std::string& glsl = shaders_[shown_].glsl;
    if (lines_.empty() || inked_ != shown_) {
        lines_ = session::inked_lines(session::without_reasons(glsl));
        inked_ = shown_;
    }
    if (ImGui::Button(tr("Copy"))) {
        ImGui::SetClipboardText(glsl.c_str());
        say(session, tr("copied {} lines of GLSL", lines_.size()));
    }
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", tr("{} lines; saved from the tab Save", lines_.size()).c_str());
    // At least twenty lines, also below a long list of reasons.
    const float height = std::max(ImGui::GetContentRegionAvail().y, 20 * ImGui::GetTextLineHeightWithSpacing());
    ImGui::BeginChild("glsl", {0, height}, true, ImGuiWindowFlags_HorizontalScrollbar);
    ImGui::PushFont(fonts().code);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 2});
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(lines_.size()));
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            ImGui::TextDisabled("%4d  ", i + 1);
            for (const session::InkedText& piece : lines_[static_cast<std::size_t>(i)]) {
                ImGui::SameLine(0, 0);
                ImGui::PushStyleColor(ImGuiCol_Text, ink_color(piece.ink));
                ImGui::TextUnformatted(piece.text.data(), piece.text.data() + piece.text.size());
                ImGui::PopStyleColor();
            }
        }
    }
    clipper.End();
    ImGui::PopStyleVar();
    ImGui::PopFont();
    ImGui::EndChild();
}

void ShadersPanel::show(Session& session) {
    int kind = to_keep_ ? 1 : 0;
    ImGui::RadioButton(tr("for this picture"), &kind, 0);
    const char* const to_keep = tr("to keep (GLSL 3.30)");
    same_line_for(to_keep);
    ImGui::RadioButton(to_keep, &kind, 1);
    to_keep_ = kind == 1;
    update(session);
    if (!trouble_.empty()) {
        colored_text(kAccent, trouble_);
        return;
    }
    ImGui::SetNextItemWidth(-1);
    if (ImGui::BeginCombo("##program", fitting_in_combo(shaders_[shown_].title).c_str())) {
        for (std::size_t i = 0; i < shaders_.size(); ++i) {
            ImGui::PushID(static_cast<int>(i));
            if (ImGui::Selectable(shaders_[i].title.c_str(), i == shown_)) shown_ = i;
            ImGui::PopID();
        }
        ImGui::EndCombo();
    }
    if (to_keep_) {
        dim_text(
            tr("They stay right when objects, lights and the camera move. The values are uniforms with GL's names."));
    } else {
        heading(tr("What the shaders compute, and why"));
        ImGui::Checkbox(tr("also what the scene turns off"), &all_reasons_);
        show_reasons(shaders_[shown_]);
        heading("GLSL");
    }
    show_glsl(session);
}

}  // namespace twinlight::demo
