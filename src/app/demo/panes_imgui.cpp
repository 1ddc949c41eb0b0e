// The panes: what ImGui shows of them. Pictures, headers with their menus, footers, the slider, the marks on a difference.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "app/demo/panes.h"
#include "app/demo/theme.h"
#include "app/demo/widgets.h"
#include "app/session/sides.h"
#include "base/text/translation.h"

namespace twinlight::demo {
namespace {

using session::Cell;
using session::kDifferencePane;
using session::kPanes;
using session::Session;
using Clock = std::chrono::steady_clock;

constexpr double kSlowMs = 50;

std::string ms_text(double ms) {
    return ms < 10    ? fmt::format("{:.2f} ms", ms)
           : ms < 100 ? fmt::format("{:.1f} ms", ms)
                      : fmt::format("{:.0f} ms", ms);
}

// "fixed function and reference"; with the shadings where the renderers are the same.
std::string difference_title(const Session& session) {
    const session::Pane &a = session.panes[session.difference.a], &b = session.panes[session.difference.b];
    if (a.renderer == b.renderer) return tr("{} and {}", title_of(session, a), title_of(session, b));
    constexpr std::array<const char*, kPaths> kNames = {"fixed function", "shaders", "reference"};
    return tr("{} and {}", tr(kNames[static_cast<std::size_t>(a.renderer)]),
              tr(kNames[static_cast<std::size_t>(b.renderer)]));
}

void begin_bar(const char* name, const Rectangle& bar) {
    ImGui::SetNextWindowPos(corner(bar));
    ImGui::SetNextWindowSize(size_of(bar));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    ImGui::Begin(name, nullptr, kPlainWindow);
}

void end_bar() {
    ImGui::End();
    ImGui::PopStyleVar(2);
}

// What the greys of the difference mean, at the picture's lower left corner.
void show_color_scale(const Rectangle& picture, int amplification) {
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    const float size = static_cast<float>(scale()),
                width = std::min(120 * size, static_cast<float>(picture.width) / 2 - 20), height = 8 * size,
                margin = 10 * size;
    const ImVec2 from{static_cast<float>(picture.x) + margin,
                      static_cast<float>(picture.y + picture.height) - margin - height};
    const auto zero = static_cast<int>(std::lround(255 * kZeroGrey));
    const ImU32 grey = IM_COL32(zero, zero, zero, 255);
    draw.AddRectFilledMultiColor(from, {from.x + width, from.y + height}, grey, IM_COL32_WHITE, IM_COL32_WHITE, grey);
    draw.AddRect(from, {from.x + width, from.y + height}, kDim);
    const float line = from.y - ImGui::GetFontSize() - 2;
    const std::string most = fmt::format("{:.3g}/255", 255.0 / amplification);
    const float most_width = ImGui::CalcTextSize(most.c_str()).x;
    const char* const least = tr("equal");
    if (ImGui::CalcTextSize(least).x + at_scale(4) + most_width <= width) draw.AddText({from.x, line}, kDim, least);
    draw.AddText({from.x + width - most_width, line}, kDim, most.c_str());
}

ImVec2 middle_of_pixel(const Rectangle& picture, int x, int y) {
    return plus(corner(picture), {static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F});
}

// The probed pixel, with its vectors if they are known.
void show_probe(const Session& session, const Rectangle& picture) {
    if (!session.probe) return;
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    draw.PushClipRect(corner(picture), far_corner(picture), true);
    const auto& arrows = session.probe_arrows;
    if (arrows && arrows->revision == session.revision)
        draw_probe(draw, *arrows, [&](const glm::dvec3& point_eye) -> std::optional<ImVec2> {
            const auto place = arrows->place_of(point_eye);
            if (!place) return {};
            return plus(corner(picture), {static_cast<float>(place->x), static_cast<float>(place->y)});
        });
    else if (!session.probe->is_vertex)
        draw_cross(draw, middle_of_pixel(picture, session.probe->x, session.probe->y));
    draw.PopClipRect();
}

// What the header of a pane opens: the renderer and the shading.
void show_pane_menu(Session& session, std::size_t number) {
    if (!ImGui::BeginPopup("choose")) return;
    session::Pane& pane = session.panes[number];
    for (std::size_t i = 0; i < kPaths; ++i)
        if (ImGui::MenuItem(tr(session::kRendererTitles[i]), nullptr, pane.renderer == kAllPaths[i]))
            pane.renderer = kAllPaths[i];
    ImGui::Separator();
    if (ImGui::MenuItem(tr("As glShadeModel says"), nullptr, !pane.shading)) pane.shading.reset();
    for (const ShadingName& shading : kShadings) {
        constexpr std::array<const char*, 4> kWords = {"Flat", "Gouraud", "Phong", "Exact surfaces"};
        const bool can = pane.renderer != Path::kFixed || !lights_every_pixel(shading.value);
        if (ImGui::MenuItem(tr(kWords[static_cast<std::size_t>(shading.value)]), can ? nullptr : tr("shaders only"),
                            pane.shading == shading.value, can))
            pane.shading = shading.value;
    }
    if (pane.renderer != Path::kFixed) {
        ImGui::Separator();
        const bool on = look_of(session, pane).lecture_variants;
        if (ImGui::MenuItem(tr("The lecture's variants (pragmas)"), nullptr, on)) pane.lecture_variants = !on;
    }
    ImGui::EndPopup();
}

// What the header of the difference opens.
void show_pair_menu(Session& session) {
    if (!ImGui::BeginPopup("pair")) return;
    for (std::size_t a = 0; a < kPanes; ++a) {
        for (std::size_t b = a + 1; b < kPanes; ++b) {
            const std::string title =
                tr("{} and {}", title_of(session, session.panes[a]), title_of(session, session.panes[b]));
            if (ImGui::MenuItem(title.c_str(), nullptr, session.difference == session::Pair{a, b}))
                session.difference = {a, b};
        }
    }
    ImGui::EndPopup();
}

// The colours of compare's page.
ImU32 verdict_color(compare::Verdict verdict) {
    switch (verdict) {
        case compare::Verdict::kWithin: return kGood;
        case compare::Verdict::kBeyond: return kBad;
        case compare::Verdict::kUnjudged:
        case compare::Verdict::kPartial:
        case compare::Verdict::kInformative: break;
    }
    return kDim;
}

void show_sentences(const std::vector<std::string>& sentences) {
    ImGui::BeginTooltip();
    for (const std::string& sentence : sentences)
        ImGui::TextUnformatted(wrapped(sentence, 26 * ImGui::GetFontSize()).c_str());
    ImGui::EndTooltip();
}

// The text at the right end of a bar.
void right_text(const Rectangle& bar, ImU32 color, const std::string& text) {
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    ImGui::GetBackgroundDrawList()->AddText({static_cast<float>(bar.x + bar.width) - width - 8, text_y(bar)}, color,
                                            text.c_str());
}

}  // namespace

bool Panes::shows_overlays(const Session& session, std::size_t pane) const {
    return any(session.overlays) && drawn_[pane].overlaid.overlays();
}

unsigned Panes::shown_texture(const Session& session, std::size_t pane) const {
    return shows_overlays(session, pane) ? drawn_[pane].overlaid.texture() : drawn_[pane].texture.name();
}

std::string Panes::time_of(const Session& session, std::size_t number) const {
    const Drawn& drawn = drawn_[number];
    if (session.panes[number].renderer == Path::kReference) {
        if (!drawn.reference) return tr("drawing ...");
        if (drawn.revision != session.revision) {
            const double age = std::chrono::duration<double>(Clock::now() - drawn.since).count();
            return tr("{:.1f} s old, drawing ...", age);
        }
        if (drawn.reference->divisor > 1) return tr("coarse, drawing ...");
    }
    const auto ms = drawn.times.median_ms();
    // What is drawn fast is late only if the driver compiles.
    if (is_late_ && (is_behind(drawn) || drawn.overlaid.is_behind()))
        return ms && *ms > kSlowMs ? tr("drawing ...") : tr("compiling ...");
    return ms ? ms_text(*ms) : "";
}

// The time is beside the title, or in the footer where there is no room.
const Rectangle& Panes::time_bar(const Session& session, const Cell& cell) const {
    const std::string title = title_of(session, session.panes[cell.pane]);
    const float needed = fonts().bold->CalcTextSizeA(height_of(*fonts().bold), 1e4F, 0, title.c_str()).x +
                         ImGui::CalcTextSize(time_of(session, cell.pane).c_str()).x + 30;
    return needed < static_cast<float>(cell.header.width) ? cell.header : cell.footer;
}

void Panes::show_header(Session& session, const Cell& cell) {
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    const bool is_active = session.active == cell.pane;
    draw.AddRectFilled(corner(cell.header), far_corner(cell.header), kBar, 4, ImDrawFlags_RoundCornersTop);
    if (is_active && session.view == session::View::kGrid)
        draw.AddRectFilled(corner(cell.header), {corner(cell.header).x + 4, far_corner(cell.header).y}, kAccent);

    const std::string name = fmt::format("header {}", cell.pane);
    begin_bar(name.c_str(), cell.header);
    ImGui::SetCursorPos({10, (static_cast<float>(cell.header.height) - ImGui::GetFontSize()) / 2});
    ImGui::PushFont(fonts().bold);
    if (cell.pane == kDifferencePane) {
        const std::string title = fitting({tr("Difference of {}", difference_title(session)), tr("Difference")},
                                          static_cast<float>(cell.header.width) - 20);
        if (ImGui::Selectable(title.c_str(), false, 0, {static_cast<float>(cell.header.width) - 20, 0}))
            ImGui::OpenPopup("pair");
    } else {
        const session::Pane& pane = session.panes[cell.pane];
        const float room = static_cast<float>(cell.header.width) - 20;
        const std::string title = fitting(
            {title_of(session, pane), tr(session::kRendererTitles[static_cast<std::size_t>(pane.renderer)])}, room);
        if (ImGui::Selectable(title.c_str(), false, 0, {room, 0})) {
            session.active = cell.pane;
            ImGui::OpenPopup("choose");
        }
    }
    ImGui::PopFont();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {10, 8});
    show_pane_menu(session, cell.pane);
    show_pair_menu(session);
    ImGui::PopStyleVar();
    end_bar();
}

// The sentence in a pane's footer.
std::pair<std::string, unsigned> Panes::footer_of(const Session& session, std::size_t number, float room) const {
    if (number == kDifferencePane) {
        if (!has_difference(session) || !difference_.verdict)
            return {tr("Not known yet: the reference is drawing"), kDim};
        const PairVerdict& verdict = *difference_.verdict;
        return {fitting(verdict.texts, room), verdict_color(verdict.verdict)};
    }
    const Drawn& drawn = drawn_[number];
    const session::Pane& pane = session.panes[number];
    if (!drawn.error.empty()) return {drawn.error.substr(0, drawn.error.find('\n')), kBad};
    const auto lacks_here = [&](const Unsupported& item) { return lacks(pane.renderer, item); };
    const auto missing = std::ranges::find_if(session.scene.frame.unsupported, lacks_here);
    if (missing != session.scene.frame.unsupported.end()) return {tr("not drawn: {}", missing->name), kAccent};
    const auto described = [room](const char* text, const char* short_text) {
        return std::pair(fitting({tr(text), tr(short_text)}, room), kDim);
    };
    if (pane.renderer == Path::kReference) return described("double precision, without a driver", "double precision");
    if (pane.renderer == Path::kFixed) return described("the driver executes glLight, glMaterial, ...", "the driver");
    const bool per_pixel = lights_every_pixel(look_of(session, pane).shading);
    return per_pixel ? described("GLSL that lights every pixel", "GLSL, every pixel")
                     : described("GLSL that lights every vertex", "GLSL, every vertex");
}

void Panes::show_footer(Session& session, const Cell& cell) {
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    const Rectangle& bar = cell.footer;
    draw.AddRectFilled(corner(bar), far_corner(bar), kBar, 4, ImDrawFlags_RoundCornersBottom);
    float right = far_corner(bar).x - 6;
    if (cell.pane != kDifferencePane && &time_bar(session, cell) == &bar)
        right -= ImGui::CalcTextSize(time_of(session, cell.pane).c_str()).x + 12;
    const float left = static_cast<float>(bar.x) + 10;
    const auto [text, color] = footer_of(session, cell.pane, right - left);
    draw.PushClipRect(corner(bar), {right, far_corner(bar).y});
    draw.AddText({left, text_y(bar)}, color, text.c_str());
    draw.PopClipRect();
    const bool is_hovered = ImGui::IsMouseHoveringRect(corner(bar), far_corner(bar), false);
    if (cell.pane == kDifferencePane && has_difference(session) && difference_.verdict && is_hovered)
        show_sentences(difference_.verdict->sentences);
    if (cell.pane != kDifferencePane) right_text(time_bar(session, cell), kDim, time_of(session, cell.pane));
    if (cell.pane == kDifferencePane && has_difference(session)) show_amplification(session, cell.picture);
}

// The factor, at the picture's lower right corner.
void Panes::show_amplification(Session& session, const Rectangle& picture) {
    const int width = std::min(static_cast<int>(130 * scale()), picture.width / 2 - 20);
    const int height = static_cast<int>(26 * scale());
    begin_bar("amplification",
              {picture.x + picture.width - width - 6, picture.y + picture.height - height - 6, width, height});
    ImGui::SetCursorPos({0, 2});
    ImGui::SetNextItemWidth(static_cast<float>(width));
    constexpr std::array<int, 8> kFactors = {0, 1, 2, 4, 8, 16, 32, 64};
    int chosen = static_cast<int>(std::ranges::find(kFactors, session.amplification) - kFactors.begin());
    const std::string factor =
        fmt::format("x {}", session.amplification == 0 ? difference_.amplification : session.amplification);
    const std::string shown = session.amplification == 0
                                  ? fitting({tr("{} (auto)", factor), factor}, static_cast<float>(width) - 12)
                                  : factor;
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {6, 2});
    if (ImGui::SliderInt("##amplification", &chosen, 0, 7, shown.c_str()))
        session.amplification = kFactors[static_cast<std::size_t>(std::clamp(chosen, 0, 7))];
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("%s",
                          tr("Differences are multiplied by this. Grey is equal; brighter is a larger difference."));
    ImGui::PopStyleVar();
    end_bar();
}

void Panes::show_slider(Session& session, const Cell& cell) {
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    const Rectangle& box = cell.picture;
    const float x = static_cast<float>(box.x) + static_cast<float>(session.slider_at) * static_cast<float>(box.width);
    const auto half = [&](std::size_t pane, float from, float to) {
        draw.PushClipRect({from, static_cast<float>(box.y)}, {to, far_corner(box).y}, true);
        add_picture(draw, shown_texture(session, pane), corner(box), far_corner(box));
        if (shows_overlays(session, pane)) show_labels(*drawn_[pane].overlaid.overlays(), box);
        draw.PopClipRect();
    };
    half(session.slider.a, static_cast<float>(box.x), x);
    half(session.slider.b, x, far_corner(box).x);
    if (session.labels_shown) show_scene_labels(session.scene.frame.labels, box);
    show_probe(session, box);
    const float middle = static_cast<float>(box.y) + static_cast<float>(box.height) / 2;
    draw.AddLine({x, static_cast<float>(box.y)}, {x, far_corner(box).y}, IM_COL32(255, 255, 255, 200), 2);
    draw.AddCircleFilled({x, middle}, 13, IM_COL32(255, 255, 255, 235));
    draw.AddTriangleFilled({x - 9, middle}, {x - 3, middle - 5}, {x - 3, middle + 5}, kBackground);
    draw.AddTriangleFilled({x + 9, middle}, {x + 3, middle + 5}, {x + 3, middle - 5}, kBackground);
}

// The slider has two headers and two footers: the left picture's and the right one's.
void Panes::show_slider_bars(Session& session, const Cell& cell) {
    Cell left = cell, right = cell;
    left.pane = session.slider.a;
    right.pane = session.slider.b;
    left.header.width = left.footer.width = cell.header.width / 2;
    right.header.x = right.footer.x = cell.header.x + left.header.width;
    right.header.width = right.footer.width = cell.header.width - left.header.width;
    for (const Cell& side : {left, right}) {
        show_header(session, side);
        show_footer(session, side);
    }
}

// What differs between the two sides, each with a switch.
void Panes::show_sides(Session& session, const Rectangle& bar) {
    const std::vector<session::SideRow> rows = session::side_rows(session);
    if (rows.empty()) return;
    begin_bar("sides", bar);
    const float height = static_cast<float>(bar.height) / static_cast<float>(rows.size());
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, 0});
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const session::SideRow& row = rows[i];
        ImGui::SetCursorPos({10, (static_cast<float>(i) + 0.5F) * height - ImGui::GetFontSize() / 2});
        const float room = static_cast<float>(bar.width) - 20 - 2 * ImGui::GetFontSize();
        ImGui::PushStyleColor(ImGuiCol_Text, row.differs ? kText : kDim);
        bool differs = row.differs;
        if (ImGui::Checkbox(fitting({row.text, row.short_text}, room).c_str(), &differs)) switch_side(session, row);
        ImGui::PopStyleColor();
        if (ImGui::IsItemHovered())
            ImGui::SetTooltip("%s",
                              tr(row.differs ? "The two sides differ in this. Click to make them equal in it."
                                             : "The two sides are equal in this. Click to make them differ in it."));
    }
    ImGui::PopStyleVar();
    end_bar();
}

void Panes::show_picture(Session& session, const Cell& cell) {
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    const bool is_difference = cell.pane == kDifferencePane;
    const unsigned texture = is_difference ? difference_.texture.name() : shown_texture(session, cell.pane);
    add_picture(draw, texture, corner(cell.picture), far_corner(cell.picture));
    if (!is_difference && shows_overlays(session, cell.pane))
        show_labels(*drawn_[cell.pane].overlaid.overlays(), cell.picture);
    if (session.labels_shown) show_scene_labels(session.scene.frame.labels, cell.picture);
    show_header(session, cell);
    show_footer(session, cell);
    if (is_difference && has_difference(session)) {
        show_color_scale(cell.picture, difference_.amplification);
        // The worst pixel, once it is known whether that is an error.
        const bool is_wrong = difference_.verdict && difference_.verdict->verdict == compare::Verdict::kBeyond;
        const RegionDifference& region = is_wrong ? difference_.numbers.beyond_allowed : difference_.numbers.interior;
        if (difference_.verdict && region.differing > 0)
            draw.AddCircle(middle_of_pixel(cell.picture, region.worst_x, region.worst_y), 9, kAccent, 24, 2);
    }
    show_probe(session, cell.picture);
}

void Panes::show(Session& session, const session::Layout& layout) {
    for (const Cell& cell : layout.cells) {
        switch (session.view) {
            case session::View::kWorld: world_.show(session, cell, shown_texture(session, cell.pane)); break;
            case session::View::kSlider:
                show_slider(session, cell);
                show_slider_bars(session, cell);
                show_sides(session, layout.sides);
                break;
            case session::View::kTutor:
                if (cell.pane == session::kWorldPane) {
                    world_.show(session, cell, 0);
                    break;
                }
                [[fallthrough]];
            case session::View::kSingle:
            case session::View::kGrid: show_picture(session, cell); break;
        }
    }
}

}  // namespace twinlight::demo
