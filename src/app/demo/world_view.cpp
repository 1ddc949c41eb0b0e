#include "app/demo/world_view.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "app/demo/overlays.h"
#include "app/demo/theme.h"
#include "app/demo/widgets.h"
#include "base/text/translation.h"

namespace twinlight::demo {
namespace {

using session::Handle;
using session::LightMarker;

constexpr double kInsideShare = 0.25;  // of the picture's width, for the scene's own picture in its corner
constexpr float kBulb = 7, kDragPixels = 3;

std::string point_text(const glm::dvec3& point) {
    std::string text;
    for (int i = 0; i < 3; ++i)
        text += (i > 0 ? ", " : "") + fmt::format("{:.3g}", std::abs(point[i]) < 5e-4 ? 0 : point[i]);
    return "(" + text + ")";
}

// A marker's place in the window.
std::optional<ImVec2> window_place(const session::WorldProjection& projection, const Rectangle& box,
                                   const glm::dvec3& point_world) {
    const auto place = projection.place_of(point_world);
    if (!place) return {};
    return ImVec2{static_cast<float>(box.x + place->x), static_cast<float>(box.y + place->y)};
}

void draw_bulb(ImDrawList& draw, const ImVec2& at, const LightMarker& light, bool bright) {
    const float size = at_scale(kBulb);
    if (!light.is_black)
        for (const auto& [radius, alpha] : {std::pair{2.6F, 28}, {1.9F, 45}})
            draw.AddCircleFilled(at, radius * size, color_of(light.color, alpha), 32);
    draw.AddCircleFilled(at, size + 1.5F, kShadow, 24);
    draw.AddCircleFilled(at, size, color_of(light.color), 24);
    draw.AddCircle(at, size + (bright ? 3.0F : 0.0F), bright ? IM_COL32_WHITE : IM_COL32(255, 255, 255, 170), 24,
                   bright ? 2.0F : 1.0F);
    if (light.is_black) draw.AddLine({at.x - size, at.y + size}, {at.x + size, at.y - size}, kBad, 2);
}

}  // namespace

std::optional<PaneJob> WorldView::next_job(const session::Session& session) {
    const Wanted wanted{session.revision, view_.camera, session.width, session.height};
    if (wanted_ == wanted) return {};
    view_.follow(session);
    wanted_ = wanted;
    wanted_.camera = view_.camera;
    is_waiting_ = true;
    PaneJob job;
    job.pane = session::kWorldPane;
    job.size = {session.width, session.height};
    job.draw = [frame = as_seen_from_outside(session.scene.frame, view_.world, view_.projection),
                lines = world_lines(view_.world, view_.projection)](Renderers& renderers) {
        renderers.world.draw(frame,
                             {{{.shading = Shading::kPhong, .lecture_variants = true}}, programmable::Tier::kAuto});
        draw_lines(lines, frame.width, frame.height);
    };
    return job;
}

void WorldView::take(const PanePicture& picture) {
    is_waiting_ = false;
    error_ = picture.error;
    texture_.upload(picture.rgba, picture.job.size.width, picture.job.size.height);
}

void WorldView::carry_out_mouse(session::Session& session, const Rectangle& box) {
    ImGui::SetNextWindowPos(corner(box));
    ImGui::SetNextWindowSize(size_of(box));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::Begin("world", nullptr, kPlainWindow | ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImGui::InvisibleButton("mouse", size_of(box));
    const ImGuiIO& io = ImGui::GetIO();
    const glm::dvec2 place(io.MousePos.x - static_cast<float>(box.x), io.MousePos.y - static_cast<float>(box.y));
    if (ImGui::IsItemHovered()) {
        if (!ImGui::IsItemActive()) under_mouse_ = handle_at(view_.world, view_.projection, place, 12 * scale());
        if (io.MouseWheel != 0) zoom(view_.camera, io.MouseWheel);
    } else if (!ImGui::IsItemActive()) {
        under_mouse_.reset();
    }
    if (ImGui::IsItemActivated()) {
        drag_.reset();
        dragged_ = false;
        under_mouse_ = handle_at(view_.world, view_.projection, place, 12 * scale());
        orbits_ = !under_mouse_;
        session.history.end_group();
        if (under_mouse_) {
            drag_.emplace(session, view_.world, *under_mouse_);
            session.selected_light = view_.world.lights[under_mouse_->light].number;
            const auto call = command_of(commands(session), session.scene.frame, view_.world, *under_mouse_);
            if (call) session.selected_command = call;
        }
    }
    if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left, kDragPixels)) dragged_ = true;
    const ImVec2 by = ImGui::GetMouseDragDelta(ImGuiMouseButton_Left, kDragPixels);
    if (ImGui::IsItemActive() && drag_ && dragged_) {
        carry_out(session, *drag_, view_.projection, {by.x, by.y});
    }
    if (ImGui::IsItemActive() && orbits_ && dragged_) orbit(view_.camera, io.MouseDelta.x, io.MouseDelta.y);
    if (ImGui::IsItemDeactivated()) {
        session.history.end_group();
        if (orbits_ && !dragged_) session.selected_light.reset();  // a click beside the lights
        drag_.reset();
        orbits_ = false;
    }
    if (under_mouse_ || drag_) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    ImGui::End();
    ImGui::PopStyleVar();
}

void WorldView::show_markers(const session::Session& session, const Rectangle& box) const {
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    const auto place = [&](const glm::dvec3& point_world) { return window_place(view_.projection, box, point_world); };
    Labels labels(draw);
    const auto text = [&](const ImVec2& at, ImU32 color, const std::string& words) { labels.add(at, color, words); };
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 tip(0);
        tip[axis] = arrow_length(view_.world);
        constexpr std::array<ImU32, 3> kColors = {IM_COL32(235, 95, 90, 255), IM_COL32(120, 210, 120, 255),
                                                  IM_COL32(105, 155, 255, 255)};
        if (const auto at = place(tip))
            text({at->x + 4, at->y - 8}, kColors[static_cast<std::size_t>(axis)],
                 std::string(1, static_cast<char>('x' + axis)));
    }
    if (view_.world.camera_world)
        if (const auto at = place(*view_.world.camera_world)) {
            draw.AddCircleFilled(*at, 5, kShadow);
            draw.AddCircleFilled(*at, 4, kAccent);
            const char* const name = tr("camera");
            const float left = at->x - ImGui::CalcTextSize(name).x - 16;
            text({left < corner(box).x ? at->x + 12 : left, at->y - ImGui::GetFontSize() / 2}, kAccent, name);
        }
    struct Name {
        ImVec2 at;
        std::string text;
        bool bright;
    };
    std::vector<Name> names;
    for (std::size_t i = view_.world.lights.size(); i-- > 0;) {  // the first on top
        const LightMarker& light = view_.world.lights[i];
        const auto at = place(light.place_world);
        if (!at) continue;
        const bool selected = session.selected_light == light.number;
        const bool bright = selected || (under_mouse_ && under_mouse_->light == i);
        const ImU32 color = color_of(light.color);
        if (light.is_directional) {
            if (const auto to = place(arrow_tip(view_.world, light))) draw_arrow(draw, *at, *to, color);
        }
        if (light.cutoff_deg) {
            const auto tip = place(place_of(view_.world, Handle{i, true}));
            std::vector<ImVec2> rim;
            for (const glm::dvec3& point : cone_rim(light, arrow_length(view_.world)))
                if (const auto on_rim = place(point)) rim.push_back(*on_rim);
            const int alpha = bright ? 230 : 130;
            draw.AddPolyline(rim.data(), static_cast<int>(rim.size()), color_of(light.color, alpha), ImDrawFlags_Closed,
                             1.5F);
            for (std::size_t p = 0; p < rim.size(); p += 4)
                draw.AddLine(*at, rim[p], color_of(light.color, alpha / 2), 1);
            if (tip) {
                draw.AddLine(*at, *tip, color_of(light.color, alpha), 1.5F);
                draw.AddCircleFilled(*tip, 5.5F, kShadow);
                draw.AddCircleFilled(*tip, 4.5F, color);
            }
        }
        draw_bulb(draw, *at, light, bright);
        // Lights at one place share a line.
        const auto same_place = std::ranges::find_if(names, [&](const Name& name) {
            return std::abs(name.at.x - at->x) < kBulb && std::abs(name.at.y - at->y) < kBulb;
        });
        if (same_place == names.end()) {
            names.push_back({*at, light_name(light.number), bright});
        } else {
            same_place->text = light_name(light.number) + ", " + same_place->text;
            same_place->bright = same_place->bright || bright;
        }
    }
    if (session.probe && session.probe_arrows && session.probe_arrows->revision == session.revision) {
        session::ProbeArrows arrows = *session.probe_arrows;
        arrows.length = std::max(arrows.length, arrow_length(view_.world));
        draw_probe(draw, arrows, [&](const glm::dvec3& point_eye) {
            return place(glm::dvec3(glm::inverse(view_.world.eye_from_world) * glm::dvec4(point_eye, 1)));
        });
    }
    for (const Name& name : names) {
        const float beside = at_scale(kBulb + 6);
        text({name.at.x + beside, name.at.y - ImGui::GetFontSize() - 2}, name.bright ? kText : kDim, name.text);
    }
}

// What the scene's own camera sees, in the lower right corner.
void WorldView::show_inside(const Rectangle& box, unsigned inside) const {
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    const float width = static_cast<float>(kInsideShare * box.width),
                height = static_cast<float>(kInsideShare * box.height);
    const ImVec2 to{far_corner(box).x - 10, far_corner(box).y - 10};
    const ImVec2 from{to.x - width, to.y - height};
    draw.AddRectFilled({from.x - 4, from.y - 4}, {to.x + 5, to.y + 5}, kShadow, 4);
    add_picture(draw, inside, from, to);
    draw.AddRect({from.x - 1, from.y - 1}, {to.x + 1, to.y + 1}, kAccent, 0, ImDrawFlags_None, 1.5F);
}

std::string WorldView::described(const session::Session& session, const LightMarker& light) const {
    const std::string name = light_name(light.number);
    const std::string black = light.is_black ? tr("; its colours are black") : "";
    if (light.typed >= session.scene.frame.typed_lights.size()) return name + black;
    const TypedLight& typed = session.scene.frame.typed_lights[light.typed];
    const std::string position = point_text(glm::dvec3(typed.position.value));
    if (light.is_directional) return tr("{}: directional, from {}{}", name, position, black);
    const std::string place =
        tr("at {}{}", position, typed.position.value.w == 1 ? "" : fmt::format(", w = {:.3g}", typed.position.value.w));
    if (!light.cutoff_deg) return tr("{}: point light {}{}", name, place, black);
    return tr("{}: spotlight {}, toward {}, {:.3g} degrees{}", name, place, point_text(typed.spot_direction.value),
              *light.cutoff_deg, black);
}

void WorldView::show(session::Session& session, const session::Cell& cell, unsigned inside) {
    const Rectangle& box = cell.picture;
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    const auto bar = [&](const Rectangle& at, ImDrawFlags corners, ImU32 color, const std::string& words,
                         ImFont* font) {
        draw.AddRectFilled(corner(at), far_corner(at), kBar, 4, corners);
        const float y = static_cast<float>(at.y) + (static_cast<float>(at.height) - height_of(*font)) / 2;
        draw.PushClipRect(corner(at), {far_corner(at).x - 6, far_corner(at).y});
        draw.AddText(font, height_of(*font), {static_cast<float>(at.x) + 10, y}, color, words.c_str());
        draw.PopClipRect();
    };
    carry_out_mouse(session, box);

    add_picture(draw, texture_.name(), corner(box), far_corner(box));
    draw.PushClipRect(corner(box), far_corner(box), true);
    if (inside != 0) show_inside(box, inside);
    show_markers(session, box);
    draw.PopClipRect();

    ImGui::PushFont(fonts().bold);
    const std::string title =
        fitting({tr("The scene from outside"), tr("From outside")}, static_cast<float>(cell.header.width) - 20);
    ImGui::PopFont();
    bar(cell.header, ImDrawFlags_RoundCornersTop, kText, title, fonts().bold);
    const auto shown_light = [&]() -> const LightMarker* {
        if (under_mouse_ && under_mouse_->light < view_.world.lights.size())
            return &view_.world.lights[under_mouse_->light];
        const auto found = std::ranges::find_if(
            view_.world.lights, [&](const LightMarker& light) { return session.selected_light == light.number; });
        return found == view_.world.lights.end() ? nullptr : &*found;
    };
    const LightMarker* light = shown_light();
    if (!error_.empty())
        bar(cell.footer, ImDrawFlags_RoundCornersBottom, kBad, error_.substr(0, error_.find('\n')), fonts().text);
    else if (is_waiting_)
        bar(cell.footer, ImDrawFlags_RoundCornersBottom, kDim, tr("compiling ..."), fonts().text);
    else if (light)
        bar(cell.footer, ImDrawFlags_RoundCornersBottom, kText, described(session, *light), fonts().text);
    else
        bar(cell.footer, ImDrawFlags_RoundCornersBottom, kDim,
            fitting({tr("Drag to turn, wheel to zoom; drag a light, or the tip of its cone, to move it"),
                     tr("Drag to turn; drag a light to move it")},
                    static_cast<float>(cell.footer.width) - 20),
            fonts().text);
}

}  // namespace twinlight::demo
