#include "app/demo/panel_probe.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/demo/theme.h"
#include "app/demo/widgets.h"
#include "base/text/translation.h"
#include "scene/command/names.h"

namespace twinlight::demo {
namespace {

using session::ProbePoint;
using session::Session;
using session::SumRow;

// A table whose last three columns are red, green and blue.
bool begin_sum(const char* name, const char* red = "red", const char* green = "green", const char* blue = "blue") {
    if (!ImGui::BeginTable(name, 6, ImGuiTableFlags_SizingFixedFit)) return false;
    ImGui::TableSetupColumn("");
    ImGui::TableSetupColumn("");
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch);
    for (int channel = 0; channel < 3; ++channel) ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed);
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TableNextColumn();
    for (const char* head : {"", red, green, blue}) {
        ImGui::TableNextColumn();
        const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(tr(head)).x;
        if (room > 0) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + room);
        ImGui::TextDisabled("%s", tr(head));
    }
    return true;
}

void sum_row(const SumRow& row) {
    const Vec3<double>& c = row.color;
    ImGui::TableNextRow();
    if (row.is_result) ImGui::TableSetBgColor(ImGuiTableBgTarget_RowBg0, kResultRow);
    ImGui::TableNextColumn();
    ImGui::PushFont(fonts().code);
    ImGui::TextUnformatted(row.sign.empty() ? " " : row.sign.c_str());
    ImGui::PopFont();
    ImGui::TableNextColumn();
    swatch(c);
    ImGui::TableNextColumn();
    ImGui::PushFont(row.is_result ? fonts().bold : fonts().text);
    ImGui::TextUnformatted(row.what.c_str());
    ImGui::PopFont();
    if (!row.how.empty()) {
        ImGui::SameLine();
        if (ImGui::CalcTextSize(row.how.c_str()).x > ImGui::GetContentRegionAvail().x) ImGui::NewLine();
        dim_text(row.how);
    }
    ImGui::PushFont(row.is_result ? fonts().code_bold : fonts().code);
    for (const double channel : {c.x, c.y, c.z}) {
        ImGui::TableNextColumn();
        const bool is_clipped = channel > 1 || channel < 0;  // before the clamp
        if (is_clipped) ImGui::PushStyleColor(ImGuiCol_Text, kBad);
        ImGui::TextUnformatted(fmt::format("{:7.4f}", channel).c_str());
        if (is_clipped) ImGui::PopStyleColor();
    }
    ImGui::PopFont();
}

void sum_table(const char* name, const std::vector<SumRow>& rows) {
    if (rows.empty() || !begin_sum(name)) return;
    for (const SumRow& row : rows) sum_row(row);
    ImGui::EndTable();
}

// A bar for red, green and blue: the terms of a sum one after the other, with a line where the sum is clamped.
void stacked_bars(const std::vector<SumRow>& rows) {
    double most = 1;
    for (const SumRow& row : rows)
        if (row.is_result) most = std::max({most, row.color.x, row.color.y, row.color.z});
    const float width = ImGui::GetContentRegionAvail().x, height = at_scale(9);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    for (const int channel : {0, 1, 2}) {
        const auto value_of = [channel](const SumRow& row) {
            return channel == 0 ? row.color.x : channel == 1 ? row.color.y : row.color.z;
        };
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const auto x_of = [&](double value) { return at.x + static_cast<float>(value / most) * width; };
        draw.AddRectFilled(at, plus(at, {width, height}), kBar, 2);
        double sum = 0;
        int shade = 0;
        for (const SumRow& row : rows) {
            if (row.is_result) break;
            const double value = std::max(value_of(row), 0.0);
            const ImVec2 from{x_of(sum), at.y}, to{x_of(sum + value), at.y + height};
            // Neighbours differ in brightness.
            const int bright = shade++ % 2 == 0 ? 235 : 165, other = bright / 4;
            draw.AddRectFilled(from, to,
                               IM_COL32(channel == 0 ? bright : other, channel == 1 ? bright : other,
                                        channel == 2 ? bright : other, 255));
            if (value > 0 && ImGui::IsMouseHoveringRect(from, to))
                ImGui::SetTooltip("%s", fmt::format("{}: {:.4f}", row.what, value).c_str());
            sum += value;
        }
        draw.AddLine({x_of(1), at.y - 1}, {x_of(1), at.y + height + 1}, kText, 1);
        ImGui::Dummy({width, height});
    }
}

// The lines of a derivation: the symbol at the left; at the right the value, and below it how it is computed.
void show_lines(const char* name, const std::vector<explain::Line>& lines) {
    using Kind = explain::Line::Kind;
    if (!ImGui::BeginTable(name, 2, ImGuiTableFlags_SizingFixedFit)) return;
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, 9 * ImGui::GetFontSize() / 1.8F);
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch);
    for (const explain::Line& line : lines) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::PushFont(fonts().code_bold);
        ImGui::TextUnformatted(line.what.c_str());
        ImGui::PopFont();
        ImGui::TableNextColumn();
        if (line.kind == Kind::kHeadingOfColors) continue;
        if (line.kind == Kind::kNote) {
            colored_text(kAccent, line.value);
            continue;
        }
        ImGui::PushFont(fonts().code);
        if (line.kind == Kind::kColor) {
            swatch(line.color);
            ImGui::SameLine();
            ImGui::TextUnformatted(
                fmt::format("{:.4f} {:.4f} {:.4f}", line.color.x, line.color.y, line.color.z).c_str());
        } else {
            ImGui::TextUnformatted(wrapped(line.value).c_str());
        }
        if (!line.how.empty() && line.kind == Kind::kColor) dim_text(line.how);
        ImGui::PopFont();
        if (!line.how.empty() && line.kind != Kind::kColor) dim_text(line.how);
    }
    ImGui::EndTable();
}

}  // namespace

bool ProbePanel::update(Session& session) {
    const Look look = look_of(session, active_pane(session));
    if (answer_ && answer_->probe == *session.probe && revision_ == session.revision && look_ == look) return true;
    const bool is_same_probe = answer_ && answer_->probe == *session.probe;
    if (is_same_probe && !patience_.may_work(session.revision)) return false;
    patience_.work([&] { answer_ = session::answer_probe(session.scene, look, *session.probe); });
    revision_ = session.revision;
    look_ = look;
    fragments_ = session::fragments_of(session.scene, *answer_);
    if (is_same_probe && fragment_ < fragments_.size()) return true;
    fragment_ = session::main_fragment(fragments_);
    session.probe_arrows.reset();
    const auto points = session::points_of(session.scene, *answer_, fragment_);
    const auto heaviest = std::ranges::max_element(points, {}, &ProbePoint::weight);
    point_ = static_cast<std::size_t>(heaviest - points.begin());
    return true;
}

void ProbePanel::show_choice(Session& session) {
    session::Probe& probe = *session.probe;
    int kind = probe.is_vertex ? 1 : 0;
    ImGui::RadioButton(tr("Pixel"), &kind, 0);
    ImGui::SameLine();
    ImGui::RadioButton(tr("Vertex"), &kind, 1);
    probe.is_vertex = kind == 1;
    ImGui::SameLine();
    int numbers[2] = {probe.is_vertex ? static_cast<int>(probe.draw) : probe.x,
                      probe.is_vertex ? static_cast<int>(probe.vertex) : probe.y};
    const char* const label = tr(probe.is_vertex ? "draw, vertex" : "x, y");
    const float room =
        ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(label).x - ImGui::GetStyle().ItemInnerSpacing.x;
    ImGui::SetNextItemWidth(std::min(8 * ImGui::GetFontSize(), room));
    if (ImGui::InputInt2(label, numbers)) {
        if (probe.is_vertex) {
            probe.draw = static_cast<std::size_t>(std::max(numbers[0], 1));
            probe.vertex = static_cast<std::size_t>(std::max(numbers[1], 1));
        } else {
            probe.x = std::clamp(numbers[0], 0, session.width - 1);
            probe.y = std::clamp(numbers[1], 0, session.height - 1);
        }
    }
}

void ProbePanel::show_colors(const Session& session, const std::array<std::optional<Rgba>, session::kPanes>& colors) {
    if (!ImGui::BeginTable("panes", 3, ImGuiTableFlags_SizingFixedFit)) return;
    ImGui::TableSetupColumn("");
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("");
    for (std::size_t pane = 0; pane < session::kPanes; ++pane) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        const Rgba color = colors[pane].value_or(Rgba{});
        if (colors[pane])
            swatch({color[0], color[1], color[2]});
        else
            ImGui::TextUnformatted("");
        ImGui::TableNextColumn();
        const char* const renderer =
            tr(session::kRendererTitles[static_cast<std::size_t>(session.panes[pane].renderer)]);
        ImGui::TextUnformatted(
            fitting({title_of(session, session.panes[pane]), renderer}, ImGui::GetContentRegionAvail().x).c_str());
        ImGui::TableNextColumn();
        ImGui::PushFont(fonts().code);
        if (colors[pane])
            ImGui::TextUnformatted(
                fmt::format("{:3} {:3} {:3}", channel_code(color[0]), channel_code(color[1]), channel_code(color[2]))
                    .c_str());
        else
            ImGui::TextDisabled("%s", tr("not drawn"));
        ImGui::PopFont();
    }
    ImGui::EndTable();
}

void ProbePanel::show_equation(Session& session, const ProbePoint& point) {
    ImGui::PushFont(fonts().code);
    ImGui::TextUnformatted(wrapped(session::equation_of(point.derivation, session.symbols)).c_str());
    ImGui::PopFont();
    bool is_lecture = session.symbols == session::Symbols::kLecture;
    if (ImGui::Checkbox(tr("the lecture's symbols"), &is_lecture))
        session.symbols = is_lecture ? session::Symbols::kLecture : session::Symbols::kSpecification;
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip(
            "%s", tr("k_a, k_d, k_s, n·l as in the lecture, or a_cm, d_cm, s_cm, n.VP as in the specification"));
    const std::vector<int>& lights = point.derivation.lights;
    session.probe_arrows = session::arrows_of(point.derivation, light_, session.revision);
    if (light_ && std::ranges::find(lights, *light_) == lights.end()) light_.reset();
    ImGui::SetNextItemWidth(-1);
    if (ImGui::BeginCombo("##light", light_ ? light_name(*light_).c_str() : tr("all lights"))) {
        if (ImGui::Selectable(tr("all lights"), !light_)) light_.reset();
        for (const int light : lights)
            if (ImGui::Selectable(light_name(light).c_str(), light_ == light)) light_ = light;
        ImGui::EndCombo();
    }
    const std::vector<SumRow> rows = session::sum_rows(point.derivation, light_, session.symbols);
    stacked_bars(rows);
    sum_table("sum", rows);
    if (light_) {
        show_lines("light", session::lines_of(point.derivation, light_, session.symbols));
        return;
    }
    if (ImGui::TreeNode(tr("Place and normal"))) {
        show_lines("place", session::lines_of(point.derivation, {}, session.symbols));
        ImGui::TreePop();
    }
    for (const int light : lights) {
        // Two lights fit below the sum.
        const ImGuiTreeNodeFlags open = lights.size() <= 2 ? ImGuiTreeNodeFlags_DefaultOpen : ImGuiTreeNodeFlags_None;
        if (!ImGui::TreeNodeEx(light_name(light).c_str(), open)) continue;
        show_lines("lines", session::lines_of(point.derivation, light, session.symbols));
        ImGui::TreePop();
    }
}

void ProbePanel::show_fragment(Session& session) {
    if (fragments_.empty()) {
        dim_text(tr("No draw covers this pixel. It shows what glClear left."));
        return;
    }
    if (fragments_.size() > 1) {
        ImGui::SetNextItemWidth(-1);
        const auto label = [this](std::size_t i) {
            return fmt::format("{}: {}##{}", fragments_[i].name, fragments_[i].fate, i);
        };
        if (ImGui::BeginCombo("##fragment", fitting_in_combo(tr("{} of {}: {}", fragment_ + 1, fragments_.size(),
                                                                fragments_[fragment_].name))
                                                .c_str())) {
            for (std::size_t i = 0; i < fragments_.size(); ++i)
                if (ImGui::Selectable(label(i).c_str(), i == fragment_)) fragment_ = i;
            ImGui::EndCombo();
        }
        if (!fragments_[fragment_].is_seen) colored_text(kAccent, fragments_[fragment_].fate);
    } else {
        dim_text(fragments_[fragment_].name);
    }
    const std::vector<ProbePoint> points = session::points_of(session.scene, *answer_, fragment_);
    if (!fragments_[fragment_].is_lit || points.empty()) {
        dim_text(tr("GL_LIGHTING is disabled here: the colour is glColor's, and no light matters."));
    } else {
        point_ = std::min(point_, points.size() - 1);
        const std::vector<SumRow> mean = session::mean_rows(points);
        if (!mean.empty()) {
            heading(tr("The colour of this pixel"));
            sum_table("mean", mean);
            for (std::size_t i = 0; i < points.size(); ++i) {
                if (i > 0) ImGui::SameLine();
                if (ImGui::RadioButton(points[i].name.c_str(), i == point_)) point_ = i;
            }
        }
        heading(tr("The equation at {}: {}", points[point_].name, title_of(session, active_pane(session))));
        show_equation(session, points[point_]);
    }
    const std::vector<SumRow> after = session::fragment_rows(session.scene, *answer_, fragment_);
    if (!after.empty()) {
        heading(tr("After lighting"));
        show_lines("steps", session::after_lighting(session.scene, *answer_, fragment_));
        sum_table("after", after);
    }
    const std::string rulings = session::rulings_of(*answer_, fragment_);
    if (!rulings.empty()) colored_text(kAccent, rulings);
}

void ProbePanel::show_under_pointer(Session& session) {
    if (!update(session) || !answer_->trouble.empty() || fragments_.empty()) return;
    const std::vector<ProbePoint> points = session::points_of(session.scene, *answer_, fragment_);
    if (!fragments_[fragment_].is_lit || points.empty()) return;
    const ProbePoint& point = points[std::min(point_, points.size() - 1)];
    session.probe_arrows = session::arrows_of(point.derivation, {}, session.revision);
    ImGui::SetNextWindowSize({30 * ImGui::GetFontSize(), 0});
    ImGui::BeginTooltip();
    const std::vector<SumRow> mean = session::mean_rows(points);
    dim_text(tr("Pixel {}, {}: {}", session.probe->x, session.probe->y,
                mean.empty() ? tr("the lighting equation") : tr("a mix of its corners; at {}", point.name)));
    sum_table("sum under the pointer", session::sum_rows(point.derivation, {}, session.symbols));
    if (!mean.empty()) sum_table("mean under the pointer", {mean.back()});
    ImGui::EndTooltip();
}

void ProbePanel::show(Session& session, const std::array<std::optional<Rgba>, session::kPanes>& colors) {
    if (!session.probe) {
        dim_text(
            tr("Click a picture to see why the pixel has its colour: every term of the lighting equation with its "
               "numbers."));
        if (ImGui::Button(tr("Explain a vertex"))) session.probe = session::Probe{.is_vertex = true};
        if (!session.probe) return;
    }
    show_choice(session);
    if (!update(session)) {
        dim_text(tr("The numbers follow when nothing moves."));
        return;
    }
    if (!answer_->trouble.empty()) {
        colored_text(kAccent, answer_->trouble);
        return;
    }
    if (!session.probe->is_vertex) show_colors(session, colors);
    show_fragment(session);
    ImGui::Spacing();
    if (ImGui::Button(tr("Copy as text"))) {
        std::vector<explain::Rendered> rendered;
        for (std::size_t pane = 0; pane < session::kPanes; ++pane)
            if (colors[pane]) rendered.push_back({session.panes[pane].renderer, *colors[pane]});
        ImGui::SetClipboardText(session::probe_text(session.scene, *answer_, rendered).c_str());
        say(session, tr("the numbers of this probe are copied"));
    }
}

}  // namespace twinlight::demo
